<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Compare</name>
    <message>
        <source>B is A to the bit: the same triangle and the same depth at all %1 pixels.</source>
        <translation>B 与 A 逐位相同：全部 %1 个像素的三角形和深度都相同。</translation>
    </message>
    <message>
        <source>Every pixel shows the same triangle; no depth is farther off than the tolerance.</source>
        <translation>每个像素显示的三角形都相同；深度之差均不超过容差。</translation>
    </message>
    <message>
        <source>1 pixel differs.</source>
        <translation>有 1 个像素不同。</translation>
    </message>
    <message>
        <source>%1 pixels differ.</source>
        <translation>有 %1 个像素不同。</translation>
    </message>
    <message>
        <source>1 pixel differs at this moment.</source>
        <translation>此刻有 1 个像素不同。</translation>
    </message>
    <message>
        <source>%1 pixels differ at this moment.</source>
        <translation>此刻有 %1 个像素不同。</translation>
    </message>
    <message>
        <source>Of all: %1.</source>
        <translation>占全部的 %1。</translation>
    </message>
    <message>
        <source>holes: %1 shows something, %2 does not</source>
        <translation>空洞：%1 有内容而 %2 没有</translation>
    </message>
    <message>
        <source>spills: %1 shows something, %2 does not</source>
        <translation>溢出：%1 有内容而 %2 没有</translation>
    </message>
    <message>
        <source>another surface, farther off than a tie</source>
        <translation>表面不同，且深度差超过近似相等</translation>
    </message>
    <message>
        <source>another surface, a near tie</source>
        <translation>表面不同，但深度近似相等</translation>
    </message>
    <message>
        <source>same triangle, B nearer</source>
        <translation>同一三角形，B 更近</translation>
    </message>
    <message>
        <source>same triangle, B farther</source>
        <translation>同一三角形，B 更远</translation>
    </message>
    <message>
        <source>most float32 steps on a triangle</source>
        <translation>同一三角形上最多相差的 float32 步数</translation>
    </message>
    <message>
        <source>steps at 99 of 100 pixels, at most</source>
        <translation>99% 的像素相差的步数不超过</translation>
    </message>
    <message>
        <source>triangles of %1 that %2 shows nowhere</source>
        <translation>%1 中有而 %2 完全没有显示的三角形</translation>
    </message>
    <message>
        <source>B shows what A shows, but for rounding.</source>
        <translation>除舍入外，B 与 A 相同。</translation>
    </message>
    <message>
        <source>another surface</source>
        <translation>表面不同</translation>
    </message>
    <message>
        <source>another depth, B nearer</source>
        <translation>深度不同，B 更近</translation>
    </message>
    <message>
        <source>another depth, B farther</source>
        <translation>深度不同，B 更远</translation>
    </message>
    <message>
        <source>equal but for rounding</source>
        <translation>仅舍入不同</translation>
    </message>
</context>
<context>
    <name>DepthTest</name>
    <message>
        <source>It lies in a hole of its material: there is no fragment to test.</source>
        <translation>它落在材质的孔洞中：没有片元可测试。</translation>
    </message>
    <message>
        <source>The nearest so far: the pre-pass keeps its D.</source>
        <translation>目前最近：预深度通道保留它的 D。</translation>
    </message>
    <message>
        <source>Not nearer than the D that the pre-pass has kept.</source>
        <translation>不比预深度通道保留的 D 更近。</translation>
    </message>
    <message>
        <source>Farther than the D that the pre-pass kept: it is hidden.</source>
        <translation>比预深度通道保留的 D 更远：它被遮挡。</translation>
    </message>
    <message>
        <source>It lies beyond the far plane: the pixel stays background.</source>
        <translation>它在远平面之外：像素仍为背景。</translation>
    </message>
    <message>
        <source>The pixel was background: the first triangle to cover it owns it.</source>
        <translation>像素原为背景：第一个覆盖它的三角形得到它。</translation>
    </message>
    <message>
        <source>Painted over what was there: no depth is compared.</source>
        <translation>覆盖在已有内容之上：不比较深度。</translation>
    </message>
    <message>
        <source>Equal depth, and the lower number wins: the pixel changes hands.</source>
        <translation>深度相等，编号小者胜：像素易主。</translation>
    </message>
    <message>
        <source>Equal depth, and the lower number wins: the pixel stays as it is.</source>
        <translation>深度相等，编号小者胜：像素不变。</translation>
    </message>
    <message>
        <source>The larger D is nearer: the pixel changes hands.</source>
        <translation>D 较大者更近：像素易主。</translation>
    </message>
    <message>
        <source>The smaller D is farther: the pixel stays as it is.</source>
        <translation>D 较小者更远：像素不变。</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>offered by triangle</source>
        <translation>来自三角形</translation>
    </message>
    <message>
        <source>its depth D</source>
        <translation>它的深度 D</translation>
    </message>
    <message>
        <source>D before its relief</source>
        <translation>浮雕偏移前的 D</translation>
    </message>
    <message>
        <source>owner before</source>
        <translation>原归属</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>pixels won so far</source>
        <translation>目前赢得的像素</translation>
    </message>
    <message>
        <source>picked pixel</source>
        <translation>选取的像素</translation>
    </message>
    <message>
        <source>owner</source>
        <translation>归属</translation>
    </message>
    <message>
        <source>owner, triangle</source>
        <translation>归属三角形</translation>
    </message>
    <message>
        <source>depth D</source>
        <translation>深度 D</translation>
    </message>
    <message>
        <source>distance z</source>
        <translation>距离 z</translation>
    </message>
    <message>
        <source>polygon of the file</source>
        <translation>文件中的多边形</translation>
    </message>
    <message>
        <source>instance</source>
        <translation>实例</translation>
    </message>
    <message>
        <source>group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Click a pixel of the picture to see who owns it, or step by the grain “pixel” to watch each depth test.</source>
        <translation>单击图像中的像素查看它的归属，或按粒度“像素”单步观察每次深度测试。</translation>
    </message>
    <message>
        <source>Open a scene to see its depth tests.</source>
        <translation>打开一个场景来查看它的深度测试。</translation>
    </message>
</context>
<context>
    <name>Diagnosis</name>
    <message>
        <source>hole</source>
        <translation>空洞</translation>
    </message>
    <message>
        <source>spill</source>
        <translation>溢出</translation>
    </message>
    <message>
        <source>wrong surface</source>
        <translation>表面错误</translation>
    </message>
    <message>
        <source>wrong depth</source>
        <translation>深度错误</translation>
    </message>
    <message>
        <source>The files hold background alone: there are no conventions.</source>
        <translation>文件中只有背景，无法得出约定。</translation>
    </message>
    <message>
        <source>depth is %1</source>
        <translation>深度为 %1</translation>
    </message>
    <message>
        <source>the top row comes first</source>
        <translation>首行在上</translation>
    </message>
    <message>
        <source>the bottom row comes first</source>
        <translation>首行在下</translation>
    </message>
    <message>
        <source>ids are triangles, counted from %1</source>
        <translation>编号为三角形，从 %1 开始</translation>
    </message>
    <message>
        <source>ids are faces, counted from %1</source>
        <translation>编号为面，从 %1 开始</translation>
    </message>
    <message>
        <source>back faces are left out</source>
        <translation>剔除背面</translation>
    </message>
    <message>
        <source>back faces are drawn</source>
        <translation>绘制背面</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>空洞</translation>
    </message>
    <message>
        <source>spills</source>
        <translation>溢出</translation>
    </message>
    <message>
        <source>wrong surfaces</source>
        <translation>表面错误</translation>
    </message>
    <message>
        <source>wrong depths</source>
        <translation>深度错误</translation>
    </message>
    <message>
        <source>right</source>
        <translation>正确</translation>
    </message>
    <message>
        <source>rounding (%1)</source>
        <translation>舍入（%1）</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>Grain</name>
    <message>
        <source>frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>node</source>
        <translation>结点</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>query</source>
        <translation>查询</translation>
    </message>
    <message>
        <source>line</source>
        <translation>扫描线</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>span</source>
        <translation>扫描段</translation>
    </message>
    <message>
        <source>update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>像素</translation>
    </message>
</context>
<context>
    <name>Layouts</name>
    <message>
        <source>Teach</source>
        <translation>教学</translation>
    </message>
    <message>
        <source>Every structure that the algorithm uses, beside its picture</source>
        <translation>算法所用的每种结构，与画面并列</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>对比</translation>
    </message>
    <message>
        <source>Two algorithms held against each other, and why a pixel differs</source>
        <translation>两种算法相互对照，以及像素为何不同</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>性能</translation>
    </message>
    <message>
        <source>What ran and how long it took, and what was left out</source>
        <translation>运行了什么、用了多久、省略了什么</translation>
    </message>
</context>
<context>
    <name>Linking</name>
    <message>
        <source>B stands at the same part of its run.</source>
        <translation>B 停在其运行的相同比例处。</translation>
    </message>
    <message>
        <source>B stands at the same part of the same stage.</source>
        <translation>B 停在同一阶段的相同比例处。</translation>
    </message>
    <message>
        <source>A works on no line of its own here.</source>
        <translation>A 在此处不处理任何扫描线。</translation>
    </message>
    <message>
        <source>B comes to line %1 here for the first time.</source>
        <translation>B 在此首次到达第 %1 行。</translation>
    </message>
    <message>
        <source>B never works on line %1.</source>
        <translation>B 从不处理第 %1 行。</translation>
    </message>
    <message>
        <source>Pick a pixel for B to follow.</source>
        <translation>请拾取一个像素供 B 跟随。</translation>
    </message>
    <message>
        <source>The pixel shows the background in A.</source>
        <translation>该像素在 A 中显示背景。</translation>
    </message>
    <message>
        <source>The last step at which the pixel still shows the background in B, too.</source>
        <translation>该像素在 B 中仍显示背景的最后一步。</translation>
    </message>
    <message>
        <source>Here B gives the pixel to the triangle that it shows in A.</source>
        <translation>在此步 B 把该像素交给 A 中显示的三角形。</translation>
    </message>
    <message>
        <source>No step of B changes the pixel.</source>
        <translation>B 没有任何一步改变该像素。</translation>
    </message>
    <message>
        <source>B never shows that triangle in the pixel; this is its last change.</source>
        <translation>B 在该像素从不显示那个三角形；这是它的最后一次改变。</translation>
    </message>
</context>
<context>
    <name>Numbers</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Pipeline</source>
        <translation>流水线</translation>
    </message>
    <message>
        <source>Active edges</source>
        <translation>活动边</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>金字塔</translation>
    </message>
    <message>
        <source>Hierarchy</source>
        <translation>层次结构</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>观察者</translation>
    </message>
    <message>
        <source>Depth test</source>
        <translation>深度测试</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>为什么</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>对比</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>典型错误</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>运行记录</translation>
    </message>
</context>
<context>
    <name>PictureName</name>
    <message>
        <source>The template is empty.</source>
        <translation>模板是空的。</translation>
    </message>
    <message>
        <source>The template is longer than %1 letters.</source>
        <translation>模板超过 %1 个字符。</translation>
    </message>
    <message>
        <source>A name that begins with a dot would be hidden.</source>
        <translation>以点开头的名称会被隐藏。</translation>
    </message>
    <message>
        <source>A file&apos;s name cannot hold “%1”.</source>
        <translation>文件名不能含有“%1”。</translation>
    </message>
    <message>
        <source>There is no field {%1}.</source>
        <translation>没有字段 {%1}。</translation>
    </message>
    <message>
        <source>A brace has no counterpart.</source>
        <translation>花括号不成对。</translation>
    </message>
    <message>
        <source>{n} is missing: without a number one picture would take the place of another.</source>
        <translation>缺少 {n}：没有编号，图片会互相替换。</translation>
    </message>
</context>
<context>
    <name>Predict</name>
    <message>
        <source>Node %1 of instance %2</source>
        <translation>实例 %2 的结点 %1</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>结点 %1</translation>
    </message>
    <message>
        <source>active edges</source>
        <translation>活动边</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>金字塔</translation>
    </message>
    <message>
        <source>hierarchy</source>
        <translation>层次结构</translation>
    </message>
    <message>
        <source>Line %1 comes next. How many edges enter?</source>
        <translation>接下来是第 %1 行。有多少条边进入？</translation>
    </message>
    <message>
        <source>Line %1 comes next. How many edges leave?</source>
        <translation>接下来是第 %1 行。有多少条边离开？</translation>
    </message>
    <message>
        <source>Line %1 comes next. The edge of polygon %2 is at x = %3 and moves by dx = %4. Where will it be? (to 0.1 pixel)</source>
        <translation>接下来是第 %1 行。多边形 %2 的边在 x = %3，每行移动 dx = %4。它将在哪里？（答到 0.1 像素）</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>%1 covers the pixels %2 to %3 across and %4 to %5 down, and is at nearest D = %6. What does the pyramid answer?</source>
        <translation>%1覆盖横向像素 %2 到 %3、纵向 %4 到 %5，最近 D = %6。金字塔如何回答？</translation>
    </message>
    <message>
        <source>Cell %1 of level %2 is computed anew; it held %3. What comes of it?</source>
        <translation>第 %2 级的单元格 %1 重新计算；它原为 %3。结果如何？</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>%1 is judged next. Its box reaches around the eye. What becomes of it?</source>
        <translation>接下来判定%1。它的盒子包住视点。结果如何？</translation>
    </message>
    <message>
        <source>%1 is judged next. Its box covers %2 pixels and is at nearest D = %3. What becomes of it?</source>
        <translation>接下来判定%1。它的盒子覆盖 %2 个像素，最近 D = %3。结果如何？</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>被遮住</translation>
    </message>
    <message>
        <source>May be seen</source>
        <translation>可能看得见</translation>
    </message>
    <message>
        <source>It changes</source>
        <translation>改变</translation>
    </message>
    <message>
        <source>It stays</source>
        <translation>不变</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>视野之外</translation>
    </message>
    <message>
        <source>Entered</source>
        <translation>进入</translation>
    </message>
    <message>
        <source>%1 enter: so many lie in the bucket of line %2.</source>
        <translation>%1 条进入：第 %2 行的桶里有这么多。</translation>
    </message>
    <message>
        <source>%1 leave: line %2 was their last.</source>
        <translation>%1 条离开：第 %2 行是它们的末行。</translation>
    </message>
    <message>
        <source>x = %1: the x before, and dx.</source>
        <translation>x = %1：原来的 x 加 dx。</translation>
    </message>
    <message>
        <source>Hidden: all that is there is nearer than %1.</source>
        <translation>被遮住：那里的一切都比 %1 更近。</translation>
    </message>
    <message>
        <source>May be seen: something there is not nearer than %1.</source>
        <translation>可能看得见：那里有不比 %1 更近的东西。</translation>
    </message>
    <message>
        <source>It changes: the farthest below it has come nearer, and the cells above may change, too.</source>
        <translation>改变：其下最远的变近了，上面的单元格也可能改变。</translation>
    </message>
    <message>
        <source>It stays: the farthest below it is as far as before, and the way up ends.</source>
        <translation>不变：其下最远的与之前一样远，上行之路到此结束。</translation>
    </message>
    <message>
        <source>Outside: the box does not reach the view.</source>
        <translation>视野之外：盒子没有进入视野。</translation>
    </message>
    <message>
        <source>Hidden: what is drawn already is nearer all over its rectangle.</source>
        <translation>被遮住：已画的内容在其整个矩形内都更近。</translation>
    </message>
    <message>
        <source>Entered: it cannot be called hidden.</source>
        <translation>进入：无法断定它被遮住。</translation>
    </message>
</context>
<context>
    <name>Pyramid</name>
    <message>
        <source>hidden</source>
        <translation>被遮挡</translation>
    </message>
    <message>
        <source>may be seen</source>
        <translation>可能可见</translation>
    </message>
    <message>
        <source>may be seen, entered</source>
        <translation>可能可见，进入</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>A node</source>
        <translation>一个结点</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>结点 %1</translation>
    </message>
    <message>
        <source>%1 of instance %2</source>
        <translation>实例 %2 的%1</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>%1 covers %2 × %3 px: level %4, %5 × %6 cells. </source>
        <translation>%1覆盖 %2 × %3 像素：第 %4 级，%5 × %6 个单元格。</translation>
    </message>
    <message>
        <source>There is background among them; it is at nearest %1: </source>
        <translation>其中有背景；它最近为 %1：</translation>
    </message>
    <message>
        <source>Farthest held %1, it is at nearest %2: </source>
        <translation>所存最远为 %1，它最近为 %2：</translation>
    </message>
    <message>
        <source>Finer cells decided. </source>
        <translation>由更细的单元格决定。</translation>
    </message>
    <message>
        <source>1 cell or pixel read.</source>
        <translation>读取了 1 个单元格或像素。</translation>
    </message>
    <message>
        <source>%1 cells or pixels read.</source>
        <translation>读取了 %1 个单元格或像素。</translation>
    </message>
    <message>
        <source>Cell (%1, %2) of level %3: </source>
        <translation>第 %3 级的单元格（%1, %2）：</translation>
    </message>
    <message>
        <source>%1 as before. </source>
        <translation>%1，与之前相同。</translation>
    </message>
    <message>
        <source>%1 instead of %2. </source>
        <translation>%1，取代 %2。</translation>
    </message>
    <message>
        <source>Way up: %1, and it stops there.</source>
        <translation>向上传播：%1，到此为止。</translation>
    </message>
    <message>
        <source>Way up so far: %1.</source>
        <translation>目前已向上传播：%1。</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>, %1 threads</source>
        <translation>，%1 线程</translation>
    </message>
    <message>
        <source>ms, median frame</source>
        <translation>毫秒，中位帧</translation>
    </message>
    <message>
        <source>Where the time goes</source>
        <translation>时间花在哪里</translation>
    </message>
    <message>
        <source>%1: grows like n to the %2</source>
        <translation>%1：按 n 的 %2 次方增长</translation>
    </message>
    <message>
        <source>times as long as %1</source>
        <translation>相对 %1 的倍数</translation>
    </message>
    <message>
        <source>Below the line: faster than %1</source>
        <translation>线以下：比 %1 快</translation>
    </message>
    <message>
        <source>How the time grows</source>
        <translation>时间如何增长</translation>
    </message>
    <message>
        <source>Speed against error: %1</source>
        <translation>速度与误差：%1</translation>
    </message>
    <message>
        <source>%1, %2 cores. ZScope %3, compiler %4. %5 of %6 cases. Experiment %7.</source>
        <translation>%1，%2 核。ZScope %3，编译器 %4。共 %6 个案例，已测 %5 个。实验 %7。</translation>
    </message>
    <message>
        <source>Every picture was compared with the brute-force reference before it was timed. Times are medians; ratios are medians over rounds in which the algorithms were timed in turn, with the interval that holds the true ratio in 19 of 20 experiments as far as the rounds allow. The time of a wrong picture is struck out.</source>
        <translation>每幅图像在计时之前都与穷举参考逐像素比较。时间为中位数；比值为各轮的中位数，各轮中算法轮流计时，区间在轮数允许的范围内于 20 次实验中有 19 次包含真实比值。图像有错的时间以删除线标出。</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>algorithm</source>
        <translation>算法</translation>
    </message>
    <message>
        <source>threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>错误像素</translation>
    </message>
    <message>
        <source>median ms</source>
        <translation>中位数（毫秒）</translation>
    </message>
    <message>
        <source>interval</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>未检查</translation>
    </message>
    <message>
        <source>%1, wrong</source>
        <translation>%1，有错</translation>
    </message>
    <message>
        <source>best, quartiles</source>
        <translation>最快，四分位数</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>绘制内容</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>slowest, ms</source>
        <translation>最慢，毫秒</translation>
    </message>
    <message>
        <source>wrong frames</source>
        <translation>错误帧</translation>
    </message>
    <message>
        <source>worst frame, % wrong</source>
        <translation>最差帧，错误 %</translation>
    </message>
    <message>
        <source>wrong frames after each cut</source>
        <translation>每次切换后的错误帧</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1 differ</source>
        <translation>%1 处不同</translation>
    </message>
    <message>
        <source>shaded</source>
        <translation>着色</translation>
    </message>
    <message>
        <source>ids and depth</source>
        <translation>编号与深度</translation>
    </message>
    <message>
        <source>, ids and depth</source>
        <translation>，编号与深度</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>切换</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>ms, median of the passes</source>
        <translation>毫秒，各遍中位数</translation>
    </message>
    <message>
        <source>frames a second</source>
        <translation>每秒帧数</translation>
    </message>
    <message>
        <source>wrong pixels, % of those covered</source>
        <translation>错误像素，占被覆盖者的 %</translation>
    </message>
    <message>
        <source>Frame by frame: %1</source>
        <translation>逐帧：%1</translation>
    </message>
    <message>
        <source>Wrong pixels, frame by frame: %1</source>
        <translation>逐帧错误像素：%1</translation>
    </message>
    <message>
        <source>Where the time goes: %1</source>
        <translation>时间花在哪里：%1</translation>
    </message>
</context>
<context>
    <name>Runs</name>
    <message>
        <source>%1, 1 thread, %2.</source>
        <translation>%1，1 个线程，%2。</translation>
    </message>
    <message>
        <source>%1, %2 threads, %3.</source>
        <translation>%1，%2 个线程，%3。</translation>
    </message>
    <message>
        <source>It chose %1.</source>
        <translation>它选择了 %1。</translation>
    </message>
    <message>
        <source>Its picture was not checked.</source>
        <translation>其图像未经检验。</translation>
    </message>
    <message>
        <source>Its picture is WRONG although it promised to be exact: %1. Its time is no result.</source>
        <translation>其图像有错，尽管它承诺精确：%1。其时间不算结果。</translation>
    </message>
    <message>
        <source>1 pixel differs in triangle or depth</source>
        <translation>1 个像素的三角形或深度不同</translation>
    </message>
    <message>
        <source>%1 pixels differ in triangle or depth</source>
        <translation>%1 个像素的三角形或深度不同</translation>
    </message>
    <message>
        <source>Its faces cover exactly what they should.</source>
        <translation>各面的覆盖恰好正确。</translation>
    </message>
    <message>
        <source>Its picture is the reference&apos;s, to the bit.</source>
        <translation>其图像与参考图逐位相同。</translation>
    </message>
    <message>
        <source>%1 holes, %2 spills, %3 other surfaces, of them %4 near ties; %5 depths differ, by up to %6 float32 steps.</source>
        <translation>%1 个空洞，%2 个溢出，%3 个错误表面，其中 %4 个近乎相等；%5 个深度不同，最多相差 %6 个 float32 步。</translation>
    </message>
</context>
<context>
    <name>SavePicture</name>
    <message>
        <source>%1 is there already; it was left as it is.</source>
        <translation>%1 已经存在；未作改动。</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>%1:%2: this is no setting; the window starts with its defaults.</source>
        <translation>%1:%2：这不是一项设置；窗口以默认设置启动。</translation>
    </message>
    <message>
        <source>%1 cannot be read as settings; the window starts with its defaults.</source>
        <translation>无法把 %1 读作设置；窗口以默认设置启动。</translation>
    </message>
</context>
<context>
    <name>SpeedError</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>exact by face</source>
        <translation>按面精确</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>近似</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>unchecked</source>
        <translation>未检验</translation>
    </message>
    <message>
        <source>no wrong pixel</source>
        <translation>没有错误像素</translation>
    </message>
    <message>
        <source>1 wrong pixel</source>
        <translation>1 个错误像素</translation>
    </message>
    <message>
        <source>%1 wrong pixels</source>
        <translation>%1 个错误像素</translation>
    </message>
    <message>
        <source>no depth is off</source>
        <translation>深度无误差</translation>
    </message>
    <message>
        <source>depth off by up to %1</source>
        <translation>深度误差最大 %1</translation>
    </message>
    <message>
        <source>No run of this view has been checked against the reference.</source>
        <translation>此视图还没有与参考图比较过的测量。</translation>
    </message>
    <message>
        <source>One run.</source>
        <translation>1 次测量。</translation>
    </message>
    <message>
        <source>%1 runs.</source>
        <translation>%1 次测量。</translation>
    </message>
    <message>
        <source>The fastest without error is %1, at %2.</source>
        <translation>无误差者中最快的是 %1，%2。</translation>
    </message>
    <message>
        <source>None is without error.</source>
        <translation>没有无误差的。</translation>
    </message>
    <message>
        <source>%1 (%2, %3)</source>
        <translation>%1（%2，%3）</translation>
    </message>
    <message>
        <source>Faster at the price of an error: %1.</source>
        <translation>以误差换取速度：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>No error buys more speed.</source>
        <translation>任何误差都换不来更快的速度。</translation>
    </message>
    <message>
        <source>1 is wrong although it promised to be exact.</source>
        <translation>其中 1 次有错，尽管承诺精确。</translation>
    </message>
    <message>
        <source>%1 are wrong although they promised to be exact.</source>
        <translation>其中 %1 次有错，尽管承诺精确。</translation>
    </message>
    <message>
        <source>%1, %2: %3, half of the frames between %4 and %5; %6.</source>
        <translation>%1，%2：%3，半数帧在 %4 与 %5 之间；%6。</translation>
    </message>
</context>
<context>
    <name>StageCosts</name>
    <message>
        <source>%1 / vertex</source>
        <translation>%1 / 顶点</translation>
    </message>
    <message>
        <source>%1 / triangle</source>
        <translation>%1 / 三角形</translation>
    </message>
    <message>
        <source>%1 / pixel</source>
        <translation>%1 / 像素</translation>
    </message>
    <message>
        <source>%1 / edge</source>
        <translation>%1 / 边</translation>
    </message>
    <message>
        <source>%1 / active edge</source>
        <translation>%1 / 活动边</translation>
    </message>
    <message>
        <source>%1 / node</source>
        <translation>%1 / 结点</translation>
    </message>
    <message>
        <source>%1 / cell</source>
        <translation>%1 / 单元格</translation>
    </message>
    <message>
        <source>%1 / window</source>
        <translation>%1 / 窗口</translation>
    </message>
</context>
<context>
    <name>Verdicts</name>
    <message>
        <source>entered</source>
        <translation>进入</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>已绘制</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>被遮挡</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>视锥外</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>太小</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
</context>
<context>
    <name>Why</name>
    <message>
        <source>seen</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>overwritten</source>
        <translation>被覆盖</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>更远</translation>
    </message>
    <message>
        <source>lost a tie</source>
        <translation>平局落败</translation>
    </message>
    <message>
        <source>interval lost</source>
        <translation>区间落败</translation>
    </message>
    <message>
        <source>in a hole</source>
        <translation>在孔洞中</translation>
    </message>
    <message>
        <source>beyond far</source>
        <translation>远平面外</translation>
    </message>
    <message>
        <source>tile rejected</source>
        <translation>块被拒绝</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>被遮挡</translation>
    </message>
    <message>
        <source>node hidden</source>
        <translation>结点被遮挡</translation>
    </message>
    <message>
        <source>node outside</source>
        <translation>结点在视锥外</translation>
    </message>
    <message>
        <source>node too small</source>
        <translation>结点太小</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>视锥外</translation>
    </message>
    <message>
        <source>back face</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>before near</source>
        <translation>近平面前</translation>
    </message>
    <message>
        <source>not filled</source>
        <translation>未填充</translation>
    </message>
    <message>
        <source>blended</source>
        <translation>已混合</translation>
    </message>
    <message>
        <source>behind opaque</source>
        <translation>在不透明面后</translation>
    </message>
    <message>
        <source>set up</source>
        <translation>建立</translation>
    </message>
    <message>
        <source>its node lies outside</source>
        <translation>其结点在视锥外</translation>
    </message>
    <message>
        <source>its node is hidden</source>
        <translation>其结点被遮挡</translation>
    </message>
    <message>
        <source>its node is too small</source>
        <translation>其结点太小</translation>
    </message>
    <message>
        <source>its node is entered</source>
        <translation>进入其结点</translation>
    </message>
    <message>
        <source>its node is recalled</source>
        <translation>沿用其结点</translation>
    </message>
    <message>
        <source>hidden by the pyramid</source>
        <translation>被金字塔判为遮挡</translation>
    </message>
    <message>
        <source>passed the pyramid</source>
        <translation>通过金字塔测试</translation>
    </message>
    <message>
        <source>rejected with the tile</source>
        <translation>随块一起被拒绝</translation>
    </message>
    <message>
        <source>in a hole of its material</source>
        <translation>在材质的孔洞中</translation>
    </message>
    <message>
        <source>won the depth test</source>
        <translation>赢得深度测试</translation>
    </message>
    <message>
        <source>lost the depth test</source>
        <translation>深度测试落败</translation>
    </message>
    <message>
        <source>overtaken</source>
        <translation>被超过</translation>
    </message>
    <message>
        <source>won the interval</source>
        <translation>赢得区间</translation>
    </message>
    <message>
        <source>lost the interval</source>
        <translation>区间落败</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Actions</name>
    <message>
        <source>B: %1</source>
        <translation>B：%1</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>算法</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>示例(&amp;E)</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>疑难场景</translation>
    </message>
    <message>
        <source>Re&amp;load</source>
        <translation>重新载入(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Save picture</source>
        <translation>保存图像(&amp;S)</translation>
    </message>
    <message>
        <source>Save picture &amp;without decoration</source>
        <translation>保存无标注图像(&amp;W)</translation>
    </message>
    <message>
        <source>Save picture &amp;as…</source>
        <translation>图像另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>复制图像(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>适合窗口(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;1:1</source>
        <translation>&amp;1:1</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Go to pixel…</source>
        <translation>转到像素(&amp;G)…</translation>
    </message>
    <message>
        <source>Pick the pixel to the left</source>
        <translation>选取左边的像素</translation>
    </message>
    <message>
        <source>Pick the pixel to the right</source>
        <translation>选取右边的像素</translation>
    </message>
    <message>
        <source>Pick the pixel above</source>
        <translation>选取上方的像素</translation>
    </message>
    <message>
        <source>Pick the pixel below</source>
        <translation>选取下方的像素</translation>
    </message>
    <message>
        <source>&amp;Stop work, or forget the pick</source>
        <translation>停止工作，或取消选取(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>恢复默认布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>图层(&amp;L)</translation>
    </message>
    <message>
        <source>Fit the range of depths</source>
        <translation>自动调整深度范围</translation>
    </message>
    <message>
        <source>Current line</source>
        <translation>当前扫描线</translation>
    </message>
    <message>
        <source>Active edges</source>
        <translation>活动边</translation>
    </message>
    <message>
        <source>What is still to come, pale</source>
        <translation>尚未绘制的部分（淡色）</translation>
    </message>
    <message>
        <source>Triangle of the step</source>
        <translation>本步的三角形</translation>
    </message>
    <message>
        <source>Last question and update of the pyramid</source>
        <translation>金字塔最近一次查询与更新</translation>
    </message>
    <message>
        <source>Boxes of the nodes, by verdict</source>
        <translation>结点包围盒（按判定着色）</translation>
    </message>
    <message>
        <source>Cells of the pyramid, with values</source>
        <translation>金字塔单元格及其数值</translation>
    </message>
    <message>
        <source>Grid and numbers in large pixels</source>
        <translation>放大时的像素网格与数值</translation>
    </message>
    <message>
        <source>Magnifier</source>
        <translation>放大镜</translation>
    </message>
    <message>
        <source>Picture si&amp;ze</source>
        <translation>图像尺寸(&amp;Z)</translation>
    </message>
    <message>
        <source>As large as the view</source>
        <translation>与视图同大</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>相机(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>查看(&amp;I)</translation>
    </message>
    <message>
        <source>Inspect (I): the wheel zooms, dragging pans, a click picks a pixel, Right and Left step</source>
        <translation>查看（I）：滚轮缩放，拖动平移，单击选取像素，左右方向键单步</translation>
    </message>
    <message>
        <source>Camera (C, or while Alt is held): left drag orbits, middle drag pans, the wheel dollies, the arrow keys turn the model, WASD flies</source>
        <translation>相机（C，或按住 Alt）：左键拖动环绕，中键拖动平移，滚轮推拉，方向键转动模型，WASD 飞行</translation>
    </message>
    <message>
        <source>From the &amp;front</source>
        <translation>前视图(&amp;F)</translation>
    </message>
    <message>
        <source>From the &amp;right</source>
        <translation>右视图(&amp;R)</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>俯视图(&amp;A)</translation>
    </message>
    <message>
        <source>R&amp;eset</source>
        <translation>复位(&amp;E)</translation>
    </message>
    <message>
        <source>Views of the &amp;scene</source>
        <translation>场景自带视角(&amp;S)</translation>
    </message>
    <message>
        <source>Turn: first angle, less</source>
        <translation>转动：减小第一个角</translation>
    </message>
    <message>
        <source>Turn: first angle, more</source>
        <translation>转动：增大第一个角</translation>
    </message>
    <message>
        <source>Turn: second angle, less</source>
        <translation>转动：减小第二个角</translation>
    </message>
    <message>
        <source>Turn: second angle, more</source>
        <translation>转动：增大第二个角</translation>
    </message>
    <message>
        <source>Turn: third angle, less</source>
        <translation>转动：减小第三个角</translation>
    </message>
    <message>
        <source>Turn: third angle, more</source>
        <translation>转动：增大第三个角</translation>
    </message>
    <message>
        <source>&amp;Normalise the model</source>
        <translation>模型归一化(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Algorithm</source>
        <translation>算法(&amp;A)</translation>
    </message>
    <message>
        <source>Leave out &amp;back faces</source>
        <translation>剔除背面(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>单步(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>播放或暂停(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Forward</source>
        <translation>前进(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后退(&amp;B)</translation>
    </message>
    <message>
        <source>Forward by the coarser grain</source>
        <translation>按更粗的粒度前进</translation>
    </message>
    <message>
        <source>Back by the coarser grain</source>
        <translation>按更粗的粒度后退</translation>
    </message>
    <message>
        <source>F&amp;irst step</source>
        <translation>第一步(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Last step</source>
        <translation>最后一步(&amp;L)</translation>
    </message>
    <message>
        <source>C&amp;ompare</source>
        <translation>对比(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;B</source>
        <translation>&amp;B</translation>
    </message>
    <message>
        <source>&amp;Keep A as B</source>
        <translation>把 A 存为 B(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;To and fro between A and B</source>
        <translation>在 A 与 B 之间切换(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>卷帘(&amp;W)</translation>
    </message>
    <message>
        <source>Side &amp;by side</source>
        <translation>并排(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>差异(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Swap A and B</source>
        <translation>交换 A 与 B(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;End the comparison</source>
        <translation>结束对比(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>键盘与鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About ZScope</source>
        <translation>关于 ZScope(&amp;A)</translation>
    </message>
    <message>
        <source>Save s&amp;ession…</source>
        <translation>保存会话(&amp;E)…</translation>
    </message>
    <message>
        <source>La&amp;yout</source>
        <translation>布局(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Own layouts</source>
        <translation>自定义布局(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Save this layout…</source>
        <translation>保存此布局(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Forget a layout</source>
        <translation>删除布局(&amp;F)</translation>
    </message>
    <message>
        <source>Book&amp;mark this step</source>
        <translation>给此步加书签(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Next bookmark</source>
        <translation>下一个书签(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious bookmark</source>
        <translation>上一个书签(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Run to the next breakpoint</source>
        <translation>运行到下一个断点(&amp;R)</translation>
    </message>
    <message>
        <source>Run b&amp;ack to a breakpoint</source>
        <translation>反向运行到断点(&amp;A)</translation>
    </message>
    <message>
        <source>Brea&amp;kpoint on what is picked or selected</source>
        <translation>在拾取或选中的对象上设断点(&amp;K)</translation>
    </message>
    <message>
        <source>Breakpoint &amp;on</source>
        <translation>断点位于(&amp;O)</translation>
    </message>
    <message>
        <source>Remove all breakpoints</source>
        <translation>删除所有断点</translation>
    </message>
    <message>
        <source>First step that &amp;changes the picked pixel</source>
        <translation>首次改变拾取像素的步(&amp;C)</translation>
    </message>
    <message>
        <source>Next step that changes it</source>
        <translation>下一次改变它的步</translation>
    </message>
    <message>
        <source>Previous step that changes it</source>
        <translation>上一次改变它的步</translation>
    </message>
    <message>
        <source>The line of the picked pixel, or of the step</source>
        <translation>拾取像素或当前步所在的行</translation>
    </message>
    <message>
        <source>The picked pixel</source>
        <translation>拾取的像素</translation>
    </message>
    <message>
        <source>The selected node</source>
        <translation>选中的节点</translation>
    </message>
    <message>
        <source>The selected triangle, or that of the picked pixel</source>
        <translation>选中的三角形，或拾取像素的三角形</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>命令(&amp;C)…</translation>
    </message>
    <message>
        <source>C&amp;hange keys…</source>
        <translation>更改按键(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>课程(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;List of lessons</source>
        <translation>课程列表(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Next page</source>
        <translation>下一页(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Previous page</source>
        <translation>上一页(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Show this page&apos;s step again</source>
        <translation>重新显示本页的步骤(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Open a folder of lessons…</source>
        <translation>打开课程文件夹(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Reload lessons</source>
        <translation>重新载入课程(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Names of pictures…</source>
        <translation>图片名称(&amp;N)…</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>断点</translation>
    </message>
    <message>
        <source>Save a comparison s&amp;heet…</source>
        <translation>保存对比页(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Start measuring</source>
        <translation>开始测量(&amp;S)</translation>
    </message>
    <message>
        <source>S&amp;top measuring</source>
        <translation>停止测量(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Open a record…</source>
        <translation>打开记录(&amp;O)…</translation>
    </message>
    <message>
        <source>Add a &amp;key frame to the camera path</source>
        <translation>向相机路径添加关键帧(&amp;K)</translation>
    </message>
    <message>
        <source>Add a key frame after a &amp;cut</source>
        <translation>切换镜头后添加关键帧(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save the camera path…</source>
        <translation>保存相机路径(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Forget the camera path</source>
        <translation>清除相机路径(&amp;F)</translation>
    </message>
    <message>
        <source>Open a scene first</source>
        <translation>请先打开场景</translation>
    </message>
    <message>
        <source>There is no B to compare with: choose one above, under B</source>
        <translation>没有可比较的 B：请在上面的 B 菜单中选择</translation>
    </message>
    <message>
        <source>Only with the tool Inspect (I)</source>
        <translation>只在查看工具（I）下可用</translation>
    </message>
    <message>
        <source>What another program drew cannot be drawn again as A</source>
        <translation>其他程序的图像不能作为 A 重新绘制</translation>
    </message>
    <message>
        <source>Open your picture first: File ▸ Open my picture…</source>
        <translation>请先打开你的图像：文件 ▸ 打开我的图像…</translation>
    </message>
    <message>
        <source>Open &amp;my picture…</source>
        <translation>打开我的图像(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Judge my picture again</source>
        <translation>重新判断我的图像(&amp;J)</translation>
    </message>
    <message>
        <source>Save the &amp;report on my picture…</source>
        <translation>保存我的图像的报告(&amp;R)…</translation>
    </message>
    <message>
        <source>Open my &amp;trace…</source>
        <translation>打开我的运行记录(&amp;T)…</translation>
    </message>
</context>
<context>
    <name>zscope::ui::ActiveEdgesPanel</name>
    <message>
        <source>Active edge table</source>
        <translation>活动边表</translation>
    </message>
    <message>
        <source>This algorithm keeps no active edges. Choose the scanline algorithm to see them.</source>
        <translation>此算法没有活动边表。请选择扫描线算法来观察它。</translation>
    </message>
    <message>
        <source>The edges appear when the edge table has been built.</source>
        <translation>边表建好之后，边会显示在这里。</translation>
    </message>
    <message>
        <source>Open a scene to see its edges.</source>
        <translation>打开一个场景来查看它的边。</translation>
    </message>
    <message>
        <source>No edge is active on this line. Press Right to go on.</source>
        <translation>这条扫描线上没有活动边。按右方向键继续。</translation>
    </message>
    <message>
        <source>No edge is active here. Press Right to go on, or choose the grain “line”.</source>
        <translation>此处没有活动边。按右方向键继续，或选择粒度“扫描线”。</translation>
    </message>
    <message>
        <source>The picture is finished and no edge is active. Press Left to step back, or drag the timeline.</source>
        <translation>图像已完成，没有活动边。按左方向键后退，或拖动时间轴。</translation>
    </message>
    <message>
        <source>line %1 · %2 · %3</source>
        <translation>第 %1 行 · %2 · %3</translation>
    </message>
    <message>
        <source>1 edge</source>
        <translation>1 条边</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 条边</translation>
    </message>
    <message>
        <source>1 polygon</source>
        <translation>1 个多边形</translation>
    </message>
    <message>
        <source>%1 polygons</source>
        <translation>%1 个多边形</translation>
    </message>
    <message>
        <source>%1 entered</source>
        <translation>%1 条进入</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 条离开</translation>
    </message>
    <message>
        <source>Active polygons   %1</source>
        <translation>活动多边形   %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>zscope::ui::BucketChart</name>
    <message>
        <source>Edge table</source>
        <translation>边表</translation>
    </message>
    <message>
        <source>How many edges start on each line of the picture: the buckets of the edge table</source>
        <translation>图像每一行上有多少条边开始：边表的各个桶</translation>
    </message>
    <message>
        <source>1 edge starts on the current line</source>
        <translation>有 1 条边从当前行开始</translation>
    </message>
    <message>
        <source>%1 edges start on the current line</source>
        <translation>有 %1 条边从当前行开始</translation>
    </message>
    <message>
        <source>The edge table is empty</source>
        <translation>边表为空</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>edges that start on each line; none is active yet</source>
        <translation>从各行开始的边；目前还没有活动边</translation>
    </message>
</context>
<context>
    <name>zscope::ui::CheatSheet</name>
    <message>
        <source>Keys and mouse</source>
        <translation>按键和鼠标</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Inspect&lt;/b&gt;: the wheel zooms to the cursor, dragging pans, a click picks a pixel.&lt;br&gt;&lt;b&gt;Camera&lt;/b&gt;, or Alt held: left drag orbits, middle drag pans, right drag looks around, the wheel dollies, the arrow keys turn the model, W A S D Q E fly, Shift flies faster.&lt;br&gt;&lt;b&gt;Shift held&lt;/b&gt; with Inspect: B is seen for as long.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;查看&lt;/b&gt;：滚轮向光标处缩放，拖动平移，单击拾取像素。&lt;br&gt;&lt;b&gt;相机&lt;/b&gt;，或按住 Alt：左键拖动环绕，中键拖动平移，右键拖动环视，滚轮推拉，方向键转动模型，W A S D Q E 飞行，Shift 加速。&lt;br&gt;查看时&lt;b&gt;按住 Shift&lt;/b&gt;：显示 B，直到松开。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>zscope::ui::CommandModel</name>
    <message>
        <source>%1, not possible now</source>
        <translation>%1，现在不可用</translation>
    </message>
</context>
<context>
    <name>zscope::ui::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Type a few letters of a command</source>
        <translation>输入命令的几个字</translation>
    </message>
    <message>
        <source>Letters of a command</source>
        <translation>命令的几个字</translation>
    </message>
</context>
<context>
    <name>zscope::ui::ComparePanel</name>
    <message>
        <source>Algorithm A</source>
        <translation>算法 A</translation>
    </message>
    <message>
        <source>Algorithm B</source>
        <translation>算法 B</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>交换</translation>
    </message>
    <message>
        <source>Keep A as B</source>
        <translation>把 A 存为 B</translation>
    </message>
    <message>
        <source>Worst pixel</source>
        <translation>差异最大的像素</translation>
    </message>
    <message>
        <source>Step B with A</source>
        <translation>B 随 A 同步单步</translation>
    </message>
    <message>
        <source>B becomes A, and A becomes B</source>
        <translation>B 变为 A，A 变为 B</translation>
    </message>
    <message>
        <source>Keeps A as it is as B, so that you can change A and see what that does</source>
        <translation>把现在的 A 保留为 B，这样就可以修改 A 并观察其效果</translation>
    </message>
    <message>
        <source>Picks a pixel where the two differ most: another surface before another depth</source>
        <translation>选取两者差异最大的像素：先看表面不同，再看深度不同</translation>
    </message>
    <message>
        <source>Where the wipe lies</source>
        <translation>卷帘的位置</translation>
    </message>
    <message>
        <source>Tolerance in float32 steps</source>
        <translation>容差（以 float32 步计）</translation>
    </message>
    <message>
        <source>Depths of one triangle that are no more float32 steps apart count as equal</source>
        <translation>同一三角形的深度相差不超过这么多个 float32 步时，视为相等</translation>
    </message>
    <message>
        <source>Result of the comparison</source>
        <translation>对比结果</translation>
    </message>
    <message>
        <source>Choose B, or press Shift and a digit, to hold one algorithm against another.</source>
        <translation>选择 B，或按 Shift 加数字键，把一种算法与另一种作对比。</translation>
    </message>
    <message>
        <source>tolerance, float32 steps</source>
        <translation>容差，float32 步</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>卷帘</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>A (T goes to and fro)</source>
        <translation>A（按 T 来回切换）</translation>
    </message>
    <message>
        <source>B (T goes to and fro; hold Shift to see it for a moment)</source>
        <translation>B（按 T 来回切换；按住 Shift 可暂时查看）</translation>
    </message>
    <message>
        <source>A to the left, B to the right of a handle (W)</source>
        <translation>分隔线左边为 A，右边为 B（W）</translation>
    </message>
    <message>
        <source>Where they differ, and by how much (D)</source>
        <translation>哪里不同，相差多少（D）</translation>
    </message>
    <message>
        <source>B is being drawn.</source>
        <translation>正在绘制 B。</translation>
    </message>
    <message>
        <source>A %1 · B %2, this frame</source>
        <translation>本帧：A %1 · B %2</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>1 pixel</source>
        <translation>1 个像素</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 个像素</translation>
    </message>
    <message>
        <source>B is stepped with A, and stops where the box beside says</source>
        <translation>B 随 A 步进，停在右侧选项所指之处</translation>
    </message>
    <message>
        <source>What of A&apos;s step B follows</source>
        <translation>B 跟随 A 的哪一项</translation>
    </message>
    <message>
        <source>same step</source>
        <translation>同一步</translation>
    </message>
    <message>
        <source>same line</source>
        <translation>同一行</translation>
    </message>
    <message>
        <source>same stage</source>
        <translation>同一阶段</translation>
    </message>
    <message>
        <source>picked pixel</source>
        <translation>拾取的像素</translation>
    </message>
    <message>
        <source>The same number, or the same part of the run where B has no steps of that grain</source>
        <translation>相同的步数；若 B 没有该粒度的步，则为运行的相同比例</translation>
    </message>
    <message>
        <source>Where B works on A&apos;s line for the first time</source>
        <translation>B 首次处理 A 所在行之处</translation>
    </message>
    <message>
        <source>The same part of the same stage</source>
        <translation>同一阶段的相同比例</translation>
    </message>
    <message>
        <source>Where B gives the picked pixel to the triangle that it shows in A</source>
        <translation>B 把拾取的像素交给 A 中所示三角形之处</translation>
    </message>
    <message>
        <source>There is no B: choose one below</source>
        <translation>没有 B：请在下面选择</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>并排</translation>
    </message>
    <message>
        <source>A and B side by side, moved and zoomed together (B)</source>
        <translation>A 与 B 并排显示，一起移动和缩放（B）</translation>
    </message>
    <message>
        <source>What another program drew cannot be drawn again as A</source>
        <translation>其他程序的图像不能作为 A 重新绘制</translation>
    </message>
    <message>
        <source>B is of another scene or camera.</source>
        <translation>B 的场景或相机不同。</translation>
    </message>
    <message>
        <source>B is being compared.</source>
        <translation>正在比较 B。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::CountersModel</name>
    <message>
        <source>work of the textbook method</source>
        <translation>教科书方法的工作量</translation>
    </message>
    <message>
        <source>count</source>
        <translation>计数</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Course</name>
    <message>
        <source>%1 is not a folder of lessons</source>
        <translation>%1 不是课程文件夹</translation>
    </message>
    <message>
        <source>This page compares with a B of its own; your picture is B again after it.</source>
        <translation>本页与它自己的 B 比较，之后你的图像重新成为 B。</translation>
    </message>
    <message>
        <source>Your picture is of another view than this page. “Back to its view” in the panel Diagnosis shows it; the page stays open.</source>
        <translation>你的图像与本页的视图不同。“诊断”面板中的“回到原视图”可以显示它，本页不会关闭。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::DepthChart</name>
    <message>
        <source>Nodes per depth</source>
        <translation>各层的结点数</translation>
    </message>
    <message>
        <source>Depth %1: %2</source>
        <translation>第 %1 层：%2</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>层</translation>
    </message>
</context>
<context>
    <name>zscope::ui::DepthTestPanel</name>
    <message>
        <source>Depth test</source>
        <translation>深度测试</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
</context>
<context>
    <name>zscope::ui::DiagnosisPanel</name>
    <message>
        <source>Drop what your own renderer drew on the window: depth, ids or a picture. Its mistakes are found and named here.</source>
        <translation>把你自己的渲染器的结果（深度、编号或图像）拖到窗口上，这里会找出其中的错误并说明原因。</translation>
    </message>
    <message>
        <source>Open my picture…</source>
        <translation>打开我的图像…</translation>
    </message>
    <message>
        <source>Judge again</source>
        <translation>重新判断</translation>
    </message>
    <message>
        <source>Reads the files again and judges them by the camera on show (F7)</source>
        <translation>重新读取文件，并按当前相机判断（F7）</translation>
    </message>
    <message>
        <source>Back to its view</source>
        <translation>回到原视图</translation>
    </message>
    <message>
        <source>Opens the scene and the camera by which the picture was judged</source>
        <translation>打开判断该图像时所用的场景和相机</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>First wrong pixel</source>
        <translation>第一个错误像素</translation>
    </message>
    <message>
        <source>Picks the first wrong pixel in reading order: the panel Why says what is wrong there</source>
        <translation>按从左到右、从上到下的次序选取第一个错误像素，“为什么”面板说明那里错在何处</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Writes a page with pictures, in English and Chinese, to hand in</source>
        <translation>写出一个带图的中英文网页，供提交之用</translation>
    </message>
    <message>
        <source>What explains it. A click draws A with it.</source>
        <translation>可能的原因（单击后 A 也带上该错误）</translation>
    </message>
    <message>
        <source>A click switches the mistake on in A, another one switches it off</source>
        <translation>单击使 A 带上该错误，再次单击则取消</translation>
    </message>
    <message>
        <source>Diagnosis</source>
        <translation>诊断</translation>
    </message>
    <message>
        <source>Conventions found</source>
        <translation>得出的约定</translation>
    </message>
    <message>
        <source>Progress of the judging</source>
        <translation>判断的进度</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>rounding</source>
        <translation>舍入</translation>
    </message>
    <message>
        <source>The reference is drawn and compared.</source>
        <translation>正在绘制参考图像并比较。</translation>
    </message>
    <message>
        <source>Mistakes are tried, one after another.</source>
        <translation>正在逐一尝试各种错误。</translation>
    </message>
    <message>
        <source>Mistakes were not tried: it was cancelled.</source>
        <translation>已取消，没有尝试各种错误。</translation>
    </message>
    <message>
        <source>Another scene is open than the one by which this was judged.</source>
        <translation>当前打开的不是判断时所用的场景。</translation>
    </message>
    <message>
        <source>The camera has moved since this was judged.</source>
        <translation>判断之后相机已移动。</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>得出的约定：%1。</translation>
    </message>
    <message>
        <source>%1 % of the wrong pixels lie %2, and %3 % of all.</source>
        <translation>%1 % 的错误像素%2，而在全部像素中占 %3 %。</translation>
    </message>
    <message>
        <source>old</source>
        <translation>已过时</translation>
    </message>
    <message>
        <source>1 wrong pixel</source>
        <translation>1 个错误像素</translation>
    </message>
    <message>
        <source>%1 wrong pixels</source>
        <translation>%1 个错误像素</translation>
    </message>
    <message>
        <source>%1 explains %2 of the wrong pixels.</source>
        <translation>%1 解释了 %2 个错误像素。</translation>
    </message>
    <message>
        <source>It would spoil 1 more pixel.</source>
        <translation>它还会使另外 1 个像素出错。</translation>
    </message>
    <message>
        <source>It would spoil %1 more pixels.</source>
        <translation>它还会使另外 %1 个像素出错。</translation>
    </message>
    <message>
        <source>Lesson: %1</source>
        <translation>课程：%1</translation>
    </message>
</context>
<context>
    <name>zscope::ui::EdgeTableModel</name>
    <message>
        <source>entered on this line</source>
        <translation>在本行进入</translation>
    </message>
    <message>
        <source>has left: its last line is over</source>
        <translation>已离开：它的最后一行已过</translation>
    </message>
    <message>
        <source>this step is about its polygon</source>
        <translation>本步处理的是它的多边形</translation>
    </message>
    <message>
        <source>active</source>
        <translation>活动</translation>
    </message>
    <message>
        <source>Triangle %1, lines %2 to %3: %4</source>
        <translation>三角形 %1，第 %2 至 %3 行：%4</translation>
    </message>
    <message>
        <source>▲ entered on this line, ▼ has just left, ● this step</source>
        <translation>▲ 在本行进入，▼ 刚刚离开，● 本步</translation>
    </message>
    <message>
        <source>The triangle that the edge bounds</source>
        <translation>这条边所属的三角形</translation>
    </message>
    <message>
        <source>Where the edge meets the line&apos;s centre, in pixels</source>
        <translation>边与扫描线中心的交点，以像素计</translation>
    </message>
    <message>
        <source>The same in 1/256 of a pixel, rounded down</source>
        <translation>同上，以 1/256 像素计，向下取整</translation>
    </message>
    <message>
        <source>How far x moves from one line to the next, in pixels</source>
        <translation>从一行到下一行 x 的增量，以像素计</translation>
    </message>
    <message>
        <source>The same as an exact fraction</source>
        <translation>同上，写成精确的分数</translation>
    </message>
    <message>
        <source>The first line that the edge crosses</source>
        <translation>边穿过的第一行</translation>
    </message>
    <message>
        <source>The last line that the edge crosses</source>
        <translation>边穿过的最后一行</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>dx</source>
        <translation>dx</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>first</source>
        <translation>首行</translation>
    </message>
    <message>
        <source>last</source>
        <translation>末行</translation>
    </message>
    <message>
        <source>x·256</source>
        <translation>x·256</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Examiner</name>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Open the scene first that your picture shows.</source>
        <translation>请先打开图像所显示的场景。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::FaultsModel</name>
    <message>
        <source>fault</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>出错像素</translation>
    </message>
</context>
<context>
    <name>zscope::ui::FaultsPanel</name>
    <message>
        <source>Faults</source>
        <translation>典型错误</translation>
    </message>
    <message>
        <source>What the fault does to the picture; wrong pixels stand out in red</source>
        <translation>该错误对画面的影响；出错像素以红色突出</translation>
    </message>
    <message>
        <source>Open a scene: then the classic mistakes appear here, with what each of them does to it.</source>
        <translation>请打开场景：这里将列出典型错误，以及每种错误的后果。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2 pixels&lt;/b&gt; are wrong with &lt;b&gt;%3&lt;/b&gt;.</source>
        <translation>在 &lt;b&gt;%3&lt;/b&gt; 中，&lt;b&gt;%2 个像素里有 %1 个&lt;/b&gt;出错。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 of %2 pixels&lt;/b&gt; are wrong with &lt;b&gt;%3&lt;/b&gt;, in which it can happen.</source>
        <translation>在可能出现此错误的 &lt;b&gt;%3&lt;/b&gt; 中，&lt;b&gt;%2 个像素里有 %1 个&lt;/b&gt;出错。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Right:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;正确做法：&lt;/b&gt;%1</translation>
    </message>
    <message>
        <source>Switch it off</source>
        <translation>关闭此错误</translation>
    </message>
    <message>
        <source>Switch it on</source>
        <translation>启用此错误</translation>
    </message>
    <message>
        <source>It is being drawn, or cannot happen in this scene</source>
        <translation>正在绘制，或在此场景中不会发生</translation>
    </message>
</context>
<context>
    <name>zscope::ui::FrameView</name>
    <message>
        <source>Frame view</source>
        <translation>图像视图</translation>
    </message>
    <message>
        <source>The picture of the chosen algorithm at the chosen step</source>
        <translation>所选算法在所选步骤处的图像</translation>
    </message>
    <message>
        <source>depth tests per pixel</source>
        <translation>每像素深度测试次数</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Finished picture</source>
        <translation>完成的图像</translation>
    </message>
    <message>
        <source>A  %1</source>
        <translation>A  %1</translation>
    </message>
    <message>
        <source>B  %1</source>
        <translation>B  %1</translation>
    </message>
    <message>
        <source>A  %1  |  B  %2</source>
        <translation>A  %1  |  B  %2</translation>
    </message>
    <message>
        <source>Difference  %1, %2</source>
        <translation>差异  %1，%2</translation>
    </message>
    <message>
        <source>Difference  %1, %2: no pixel</source>
        <translation>差异  %1，%2：没有一个像素</translation>
    </message>
    <message>
        <source>Active edges</source>
        <translation>活动边</translation>
    </message>
    <message>
        <source>%1 of %2 node boxes</source>
        <translation>%1 / %2 个结点包围盒</translation>
    </message>
    <message>
        <source>1 node box</source>
        <translation>1 个结点包围盒</translation>
    </message>
    <message>
        <source>%1 node boxes</source>
        <translation>%1 个结点包围盒</translation>
    </message>
    <message>
        <source>Pyramid, level %1</source>
        <translation>金字塔，第 %1 级</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Drop an OBJ file here</source>
        <translation>把 OBJ 文件拖到这里</translation>
    </message>
    <message>
        <source>or press Ctrl+O to open one, or choose an example in File ▸ Examples</source>
        <translation>或按 Ctrl+O 打开文件，或在“文件 ▸ 示例”中选一个示例</translation>
    </message>
    <message>
        <source>Nothing is drawn</source>
        <translation>还没有图像</translation>
    </message>
    <message>
        <source>The drawing was cancelled; the next step, or another algorithm, begins it again</source>
        <translation>绘制已取消；再走一步或换一种算法就会重新开始</translation>
    </message>
</context>
<context>
    <name>zscope::ui::HierarchyPanel</name>
    <message>
        <source>Nodes in the tree, by verdict</source>
        <translation>树中的结点，按判定</translation>
    </message>
    <message>
        <source>Boxes over the picture</source>
        <translation>在图像上显示包围盒</translation>
    </message>
    <message>
        <source>Nodes of the hierarchy</source>
        <translation>层次结构的结点</translation>
    </message>
    <message>
        <source>Filter: part of a path, or an instance</source>
        <translation>筛选：路径的一部分，或实例</translation>
    </message>
    <message>
        <source>Filter of the nodes</source>
        <translation>结点筛选</translation>
    </message>
    <message>
        <source>Draws the boxes of the nodes that the switches above let through</source>
        <translation>绘制上方开关所允许的结点的包围盒</translation>
    </message>
    <message>
        <source>Open a scene to see its hierarchy.</source>
        <translation>打开一个场景来查看它的层次结构。</translation>
    </message>
    <message>
        <source>The nodes appear here as the visit comes to know them. Press Right to go on.</source>
        <translation>结点在遍历到时显示在这里。按右方向键继续。</translation>
    </message>
    <message>
        <source>The nodes appear here as the visit comes to know them. Press Right to go on, or choose the grain “node”.</source>
        <translation>结点在遍历到时显示在这里。按右方向键继续，或选择粒度“结点”。</translation>
    </message>
    <message>
        <source>1 node</source>
        <translation>1 个结点</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 个结点</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>太小</translation>
    </message>
    <message>
        <source>screen px</source>
        <translation>屏幕像素</translation>
    </message>
    <message>
        <source>around the eye</source>
        <translation>包住视点</translation>
    </message>
    <message>
        <source>nearest D</source>
        <translation>最近 D</translation>
    </message>
</context>
<context>
    <name>zscope::ui::KeysDialog</name>
    <message>
        <source>Assign</source>
        <translation>指定</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>无按键</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>重置所有按键</translation>
    </message>
    <message>
        <source>Change keys</source>
        <translation>更改按键</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>查找命令或按键</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>命令及其按键</translation>
    </message>
    <message>
        <source>New key for the chosen command</source>
        <translation>所选命令的新按键</translation>
    </message>
    <message>
        <source>Who has this key already</source>
        <translation>已占用此按键的命令</translation>
    </message>
    <message>
        <source>⚠ %1 belongs to: %2. Assigning it takes it away from there.</source>
        <translation>⚠ %1 已属于：%2。指定后将从那里移除。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::KeysModel</name>
    <message>
        <source>command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>default, where it was changed</source>
        <translation>默认值（若已更改）</translation>
    </message>
</context>
<context>
    <name>zscope::ui::LessonsPanel</name>
    <message>
        <source>en</source>
        <comment>the language of this translation: zh in Chinese</comment>
        <translation>zh</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>全部课程</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>重新显示</translation>
    </message>
    <message>
        <source>Brings scene, algorithm and step of this page back</source>
        <translation>恢复本页的场景、算法和步骤</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一页</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一页</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Your answer, a number</source>
        <translation>你的答案，一个数</translation>
    </message>
    <message>
        <source>Page of the lesson</source>
        <translation>课程页面</translation>
    </message>
    <message>
        <source>Whether the answer is right</source>
        <translation>答案是否正确</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>  (%1 of %2 right)</source>
        <translation>  （%2 题答对 %1 题）</translation>
    </message>
    <message>
        <source>There are no lessons here. Choose a folder of lessons in the menu Lessons.</source>
        <translation>这里没有课程。请在“课程”菜单中选择课程文件夹。</translation>
    </message>
    <message>
        <source>Choose a lesson: each brings its own scenes, stops and questions.</source>
        <translation>选择一课：每课自带场景、停点和问题。</translation>
    </message>
    <message>
        <source>1 lesson</source>
        <translation>1 课</translation>
    </message>
    <message>
        <source>%1 lessons</source>
        <translation>%1 课</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>Picked pixel: %1, %2</source>
        <translation>选取的像素：%1, %2</translation>
    </message>
    <message>
        <source>Click the pixel in the picture, or move to it with Ctrl and the arrow keys.</source>
        <translation>在图像中单击该像素，或用 Ctrl 加方向键移动到它。</translation>
    </message>
    <message>
        <source>The page is still on its way to its step</source>
        <translation>本页还在前往其步骤的途中</translation>
    </message>
    <message>
        <source>✔ Right.</source>
        <translation>✔ 正确。</translation>
    </message>
    <message>
        <source>✘ Not right.</source>
        <translation>✘ 不对。</translation>
    </message>
    <message>
        <source>✘ %1 is not right.</source>
        <translation>✘ %1 不对。</translation>
    </message>
    <message>
        <source>It is: %1</source>
        <translation>正确答案：%1</translation>
    </message>
    <message>
        <source>It is %1.</source>
        <translation>正确答案是 %1。</translation>
    </message>
    <message>
        <source>Pixel %1 is none of those that were asked for.</source>
        <translation>像素 %1 不符合要求。</translation>
    </message>
    <message>
        <source>The page before (Ctrl+Shift+PageUp)</source>
        <translation>上一页 (Ctrl+Shift+PageUp)</translation>
    </message>
    <message>
        <source>The next page (Ctrl+Shift+PageDown)</source>
        <translation>下一页 (Ctrl+Shift+PageDown)</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>“%1”不是数字。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::LevelThumbs</name>
    <message>
        <source>Levels of the pyramid</source>
        <translation>金字塔的各级</translation>
    </message>
    <message>
        <source>Level %1 is shown large</source>
        <translation>第 %1 级放大显示</translation>
    </message>
    <message>
        <source>Level 0: the depth buffer itself</source>
        <translation>第 0 级：深度缓冲本身</translation>
    </message>
    <message>
        <source>Level %1: a cell holds the farthest depth of %2 × %2 pixels</source>
        <translation>第 %1 级：每个单元格存放 %2 × %2 个像素中最远的深度</translation>
    </message>
    <message>
        <source>Level %1 is not stored: a question reads the %2 × %2 pixels instead</source>
        <translation>第 %1 级不存储：查询时改为读取 %2 × %2 个像素</translation>
    </message>
    <message>
        <source>1 cell lags behind its pixels</source>
        <translation>1 个单元格落后于它的像素</translation>
    </message>
    <message>
        <source>%1 cells lag behind their pixels</source>
        <translation>%1 个单元格落后于各自的像素</translation>
    </message>
</context>
<context>
    <name>zscope::ui::LevelView</name>
    <message>
        <source>One level of the pyramid, large</source>
        <translation>放大显示金字塔的一级</translation>
    </message>
    <message>
        <source>Cell (%1, %2) of level %3: %4</source>
        <translation>第 %3 级的单元格（%1, %2）：%4</translation>
    </message>
    <message>
        <source>It lags behind its pixels, which are nearer by now.</source>
        <translation>它落后于自己的像素，那些像素现在更近了。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::LineStrip</name>
    <message>
        <source>Strip of the current line</source>
        <translation>当前扫描线的条带</translation>
    </message>
    <message>
        <source>1 interval has an owner</source>
        <translation>1 个区间有归属</translation>
    </message>
    <message>
        <source>%1 intervals have an owner</source>
        <translation>%1 个区间有归属</translation>
    </message>
    <message>
        <source>Nothing on this line</source>
        <translation>此行上什么也没有</translation>
    </message>
    <message>
        <source>x %1</source>
        <translation>x %1</translation>
    </message>
    <message>
        <source>no span of this line is filled yet</source>
        <translation>此行还没有填充任何跨度</translation>
    </message>
    <message>
        <source>spans offered, owners below</source>
        <translation>上为候选跨度，下为归属</translation>
    </message>
    <message>
        <source>x %1: background</source>
        <translation>x %1：背景</translation>
    </message>
    <message>
        <source>x %1 to %2: triangle %3</source>
        <translation>x %1 至 %2：三角形 %3</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Magnifier</name>
    <message>
        <source>Magnifier</source>
        <translation>放大镜</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>depth D</source>
        <translation>深度 D</translation>
    </message>
    <message>
        <source>distance z</source>
        <translation>距离 z</translation>
    </message>
    <message>
        <source>instance</source>
        <translation>实例</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>no triangle</source>
        <translation>没有三角形</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>id</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
</context>
<context>
    <name>zscope::ui::MainWindow</name>
    <message>
        <source>ZScope</source>
        <translation>ZScope</translation>
    </message>
    <message>
        <source>%1 — ZScope</source>
        <translation>%1 — ZScope</translation>
    </message>
    <message>
        <source>Open a scene</source>
        <translation>打开场景</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图像</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>The picture is in the clipboard</source>
        <translation>图像已复制到剪贴板</translation>
    </message>
    <message>
        <source>Go to pixel</source>
        <translation>转到像素</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>About ZScope</source>
        <translation>关于 ZScope</translation>
    </message>
    <message>
        <source>&lt;h3&gt;ZScope %1&lt;/h3&gt;&lt;p&gt;A microscope for visible-surface algorithms.&lt;/p&gt;&lt;p&gt;The window is free software under the GNU General Public License, version 3 or later; the core library under the MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;ZScope %1&lt;/h3&gt;&lt;p&gt;可见面判定算法的显微镜。&lt;/p&gt;&lt;p&gt;窗口程序是自由软件，遵循 GNU 通用公共许可证第 3 版或更新版本；核心库遵循 MIT 许可证。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Scenes and sessions (*.obj *.OBJ *.json *.zscope-session);;All files (*)</source>
        <translation>场景和会话 (*.obj *.OBJ *.json *.zscope-session);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>ZScope sessions (*.zscope-session)</source>
        <translation>ZScope 会话 (*.zscope-session)</translation>
    </message>
    <message>
        <source>%1 is there already; it was left as it is.</source>
        <translation>%1 已经存在；未作改动。</translation>
    </message>
    <message>
        <source>Save this layout</source>
        <translation>保存此布局</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>布局名称</translation>
    </message>
    <message>
        <source>The layout “%1” does not fit this version of the window.</source>
        <translation>布局“%1”不适用于此版本的窗口。</translation>
    </message>
    <message>
        <source>Open a folder of lessons</source>
        <translation>打开课程文件夹</translation>
    </message>
    <message>
        <source>There is no panel “%1”</source>
        <translation>没有名为“%1”的面板</translation>
    </message>
    <message>
        <source>The camera path is empty</source>
        <translation>相机路径是空的</translation>
    </message>
    <message>
        <source>Save the comparison sheet</source>
        <translation>保存对比页</translation>
    </message>
    <message>
        <source>PDF pages (*.pdf);;PNG pictures (*.png)</source>
        <translation>PDF 页面 (*.pdf);;PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Drawing and timing %1 algorithms for the sheet</source>
        <translation>正在为对比页绘制并计时 %1 种算法</translation>
    </message>
    <message>
        <source>A camera path has at most %1 frames.</source>
        <translation>一条相机路径最多有 %1 帧。</translation>
    </message>
    <message>
        <source>Key frame %1 of the camera path, at frame %2</source>
        <translation>相机路径的第 %1 个关键帧，位于第 %2 帧</translation>
    </message>
    <message>
        <source>The camera path is empty: add key frames first.</source>
        <translation>相机路径是空的：请先添加关键帧。</translation>
    </message>
    <message>
        <source>Save the camera path</source>
        <translation>保存相机路径</translation>
    </message>
    <message>
        <source>Camera paths (*.json)</source>
        <translation>相机路径 (*.json)</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 个三角形</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>Open my picture</source>
        <translation>打开我的图像</translation>
    </message>
    <message>
        <source>Depth, ids and pictures (%1);;All files (*)</source>
        <translation>深度、编号和图像 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>HTML pages (*.html)</source>
        <translation>HTML 网页 (*.html)</translation>
    </message>
    <message>
        <source>Open my trace</source>
        <translation>打开我的运行记录</translation>
    </message>
    <message>
        <source>Traces (%1);;All files (*)</source>
        <translation>运行记录 (%1);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>zscope::ui::MarksModel</name>
    <message>
        <source>Enter goes there, F2 renames it, Del removes it</source>
        <translation>Enter 转到此处，F2 改名，Del 删除</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1，%2 %3</translation>
    </message>
    <message>
        <source>F5 runs to where it is met next, Shift+F5 back, Del removes it</source>
        <translation>F5 运行到下一次命中处，Shift+F5 反向，Del 删除</translation>
    </message>
    <message>
        <source>breakpoint</source>
        <translation>断点</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>where</source>
        <translation>位置</translation>
    </message>
</context>
<context>
    <name>zscope::ui::MarksPanel</name>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Bookmarks and breakpoints</source>
        <translation>书签和断点</translation>
    </message>
    <message>
        <source>Ctrl+B marks a step to come back to. F9 sets a breakpoint on what is picked or selected; F5 runs to it.</source>
        <translation>Ctrl+B 标记一步以便返回。F9 在拾取或选中的对象上设断点；F5 运行到断点。</translation>
    </message>
    <message>
        <source>Marks the step on show, or takes its mark away (Ctrl+B)</source>
        <translation>标记当前显示的步，或取消其标记 (Ctrl+B)</translation>
    </message>
    <message>
        <source>Removes the selected mark (Del)</source>
        <translation>删除选中的标记 (Del)</translation>
    </message>
    <message>
        <source>Break on</source>
        <translation>设断点于</translation>
    </message>
    <message>
        <source>Sets a breakpoint on what is picked or selected, or takes it away (F9)</source>
        <translation>在拾取或选中的对象上设置或取消断点 (F9)</translation>
    </message>
    <message>
        <source>line</source>
        <translation>扫描线</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>node</source>
        <translation>结点</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>The step works on no line, and no pixel is picked</source>
        <translation>这一步不处理任何扫描线，也没有拾取像素</translation>
    </message>
    <message>
        <source>No pixel is picked</source>
        <translation>没有拾取像素</translation>
    </message>
    <message>
        <source>No node is selected</source>
        <translation>没有选中节点</translation>
    </message>
    <message>
        <source>No triangle is selected or picked</source>
        <translation>没有选中或拾取三角形</translation>
    </message>
</context>
<context>
    <name>zscope::ui::MeasurePanel</name>
    <message>
        <source>What to time</source>
        <translation>测量什么</translation>
    </message>
    <message>
        <source>this algorithm</source>
        <translation>当前算法</translation>
    </message>
    <message>
        <source>every preset</source>
        <translation>所有预设</translation>
    </message>
    <message>
        <source>each approximation</source>
        <translation>逐一测量每种近似</translation>
    </message>
    <message>
        <source>The choices that the window draws with now, faults and approximations too</source>
        <translation>窗口当前绘制所用的选择，包括错误和近似</translation>
    </message>
    <message>
        <source>All algorithms that have a name</source>
        <translation>所有有名称的算法</translation>
    </message>
    <message>
        <source>This algorithm made exact, then with one exactness given up at a time</source>
        <translation>当前算法的精确形式，然后每次放弃一项精确性</translation>
    </message>
    <message>
        <source>Timed frames of every run</source>
        <translation>每次测量的计时帧数</translation>
    </message>
    <message>
        <source>Timed frames of every run, after a few to warm up</source>
        <translation>每次测量在预热数帧之后的计时帧数</translation>
    </message>
    <message>
        <source> frames</source>
        <translation> 帧</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>Hold the first picture of every run against the brute-force reference. Without that no error is known, and nothing is in the chart</source>
        <translation>把每次测量的第一幅图像与穷举参考图比较。否则误差未知，图表中没有内容</translation>
    </message>
    <message>
        <source>Check every picture against the reference</source>
        <translation>每幅图像都与参考图比较</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Checks, times and counts what is chosen, in the background; leave the window alone meanwhile, it takes time from the runs</source>
        <translation>在后台检验、计时并计数所选内容；其间请勿操作窗口，否则会占用测量的时间</translation>
    </message>
    <message>
        <source>Stops; what is finished stays</source>
        <translation>停止；已完成的保留</translation>
    </message>
    <message>
        <source>How far the runs are</source>
        <translation>测量进度</translation>
    </message>
    <message>
        <source>Runs of this view</source>
        <translation>此视图的测量</translation>
    </message>
    <message>
        <source>Stages of the selected run</source>
        <translation>所选测量的各阶段</translation>
    </message>
    <message>
        <source>Counters of the selected run</source>
        <translation>所选测量的计数</translation>
    </message>
    <message>
        <source>Which error the chart shows</source>
        <translation>图表显示哪种误差</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>错误像素</translation>
    </message>
    <message>
        <source>depth error</source>
        <translation>深度误差</translation>
    </message>
    <message>
        <source>Drawing the reference</source>
        <translation>正在绘制参考图</translation>
    </message>
    <message>
        <source>Timing %1</source>
        <translation>正在测量 %1</translation>
    </message>
    <message>
        <source>Open a scene, then measure how long algorithms take on it.</source>
        <translation>打开一个场景，然后测量各算法在其上所需的时间。</translation>
    </message>
    <message>
        <source>Nothing has been timed on this view yet. Choose what to time, and press Measure: every run is checked first, then timed, then explained by counters.</source>
        <translation>此视图还没有测量。选择要测量的内容，再按“测量”：每次测量先检验，再计时，然后用计数来解释。</translation>
    </message>
    <message>
        <source>1 run</source>
        <translation>1 次测量</translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation>%1 次测量</translation>
    </message>
    <message>
        <source>Save the runs of this view</source>
        <translation>保存此视图的测量</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Opens a record: what &apos;zscope-cli bench --experiment&apos; measured, or what was saved here. A click on a point loads its run, scene and camera too</source>
        <translation>打开一份记录：由“zscope-cli bench --experiment”测得，或在此处保存。单击一个点会载入那次运行，连同场景与相机</translation>
    </message>
    <message>
        <source>Whose runs are shown</source>
        <translation>显示哪些运行</translation>
    </message>
    <message>
        <source>The view in the window, or a case of the record that was opened</source>
        <translation>窗口中的视图，或所打开记录中的一个案例</translation>
    </message>
    <message>
        <source>Saves the runs as a record, which &apos;zscope --report&apos; reads, or as CSV</source>
        <translation>把运行保存为记录（可由“zscope --report”读取）或 CSV</translation>
    </message>
    <message>
        <source>%1 is another program: it cannot be loaded here.</source>
        <translation>%1 是另一个程序，不能在此载入。</translation>
    </message>
    <message>
        <source>%1 has no case that was measured yet.</source>
        <translation>%1 还没有测量过的案例。</translation>
    </message>
    <message>
        <source>Open a record</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>Records (*.json)</source>
        <translation>记录 (*.json)</translation>
    </message>
    <message>
        <source>The view in the window</source>
        <translation>窗口中的视图</translation>
    </message>
    <message>
        <source>en</source>
        <translation>zh_CN</translation>
    </message>
    <message>
        <source>Records (*.json);;CSV, the table (*.csv)</source>
        <translation>记录 (*.json);;CSV 表格 (*.csv)</translation>
    </message>
    <message>
        <source>Open a scene first</source>
        <translation>请先打开场景</translation>
    </message>
    <message>
        <source>Runs are being timed already</source>
        <translation>正在计时</translation>
    </message>
    <message>
        <source>Nothing is being timed</source>
        <translation>没有正在计时的运行</translation>
    </message>
    <message>
        <source>There are no runs to save yet: press Measure</source>
        <translation>还没有可保存的运行：请按“测量”</translation>
    </message>
</context>
<context>
    <name>zscope::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>关闭消息</translation>
    </message>
</context>
<context>
    <name>zscope::ui::NodeModel</name>
    <message>
        <source>%1  instance %2</source>
        <translation>%1  实例 %2</translation>
    </message>
    <message>
        <source>around the eye</source>
        <translation>包住视点</translation>
    </message>
    <message>
        <source>Node %1, depth %2: %3</source>
        <translation>结点 %1，第 %2 层：%3</translation>
    </message>
    <message>
        <source>, in the tree of instance %1</source>
        <translation>，位于实例 %1 的树中</translation>
    </message>
    <message>
        <source>%1 triangles below</source>
        <translation>其下有 %1 个三角形</translation>
    </message>
    <message>
        <source>%1 instances below</source>
        <translation>其下有 %1 个实例</translation>
    </message>
    <message>
        <source>The slots taken from the root of its tree; from 8 on they straddle the planes of division</source>
        <translation>从树根到它依次经过的子槽；8 及以上表示跨越分割平面</translation>
    </message>
    <message>
        <source>What became of it so far</source>
        <translation>到目前为止的判定</translation>
    </message>
    <message>
        <source>Pixels of the rectangle that its box could touch</source>
        <translation>它的包围盒可能触及的矩形的像素数</translation>
    </message>
    <message>
        <source>No depth inside its box is larger, that is nearer</source>
        <translation>其包围盒内没有更大（即更近）的深度</translation>
    </message>
    <message>
        <source>node</source>
        <translation>结点</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>screen px</source>
        <translation>屏幕像素</translation>
    </message>
    <message>
        <source>nearest D</source>
        <translation>最近 D</translation>
    </message>
</context>
<context>
    <name>zscope::ui::ObserverPanel</name>
    <message>
        <source>Boxes seen by the observer, by verdict</source>
        <translation>观察者看到的包围盒，按判定</translation>
    </message>
    <message>
        <source>Freeze the culling view</source>
        <translation>冻结剔除视角</translation>
    </message>
    <message>
        <source>Whole scene</source>
        <translation>整个场景</translation>
    </message>
    <message>
        <source>Keeps this step&apos;s view and verdicts here while the camera of the picture moves on</source>
        <translation>图像的相机继续移动时，这里保留本步的视角和判定</translation>
    </message>
    <message>
        <source>Looks at the whole scene and the frustum again</source>
        <translation>重新观看整个场景和视锥</translation>
    </message>
    <message>
        <source>The boxes appear here as soon as the hierarchy is visited. Press Right to go on, or choose the grain “node”.</source>
        <translation>开始遍历层次结构后，包围盒会显示在这里。按右方向键继续，或选择粒度“结点”。</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>已冻结</translation>
    </message>
    <message>
        <source>drag to orbit</source>
        <translation>拖动以环绕</translation>
    </message>
    <message>
        <source>%1 triangles: pale blue where drawn, else in the colour of their node&apos;s verdict.</source>
        <translation>%1 个三角形：已绘制的为浅蓝色，其余为其节点判定的颜色。</translation>
    </message>
    <message>
        <source>%1 more are left out.</source>
        <translation>另有 %1 个未画出。</translation>
    </message>
    <message>
        <source>%1 boxes are left out.</source>
        <translation>有 %1 个包围盒未画出。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::ObserverView</name>
    <message>
        <source>The hierarchy from outside</source>
        <translation>从外部看层次结构</translation>
    </message>
    <message>
        <source>Drag orbits, the middle button pans, the wheel comes closer, arrow keys turn, a click selects a node</source>
        <translation>拖动环绕，中键平移，滚轮拉近，方向键转动，单击选择结点</translation>
    </message>
</context>
<context>
    <name>zscope::ui::PanelDock</name>
    <message>
        <source>Close the panel %1</source>
        <translation>关闭面板 %1</translation>
    </message>
    <message>
        <source>Close; the View menu opens it again</source>
        <translation>关闭；可从“视图”菜单重新打开</translation>
    </message>
</context>
<context>
    <name>zscope::ui::PictureNamesDialog</name>
    <message>
        <source>Names of pictures</source>
        <translation>图片名称</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Next picture</source>
        <translation>下一张图片</translation>
    </message>
    <message>
        <source>{scene}  name of the scene
{algorithm}  preset, or the choices
{grain}  grain of the steps
{step}  step, or end
{n}  the first number that is free</source>
        <translation>{scene}  场景名称
{algorithm}  预设，或所选的各项
{grain}  步骤的粒度
{step}  步骤编号，或 end
{n}  第一个可用的编号</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>字段</translation>
    </message>
</context>
<context>
    <name>zscope::ui::PipelinePanel</name>
    <message>
        <source>What ran</source>
        <translation>执行了什么</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>exact by face</source>
        <translation>按面精确</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>近似</translation>
    </message>
    <message>
        <source>Nothing yet: open a scene.</source>
        <translation>还没有内容：请打开一个场景。</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>不需要：%1</translation>
    </message>
</context>
<context>
    <name>zscope::ui::PredictBar</name>
    <message>
        <source>Predict</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Before the next step is shown here, say what it brings</source>
        <translation>在这里显示下一步之前，先说出它会带来什么</translation>
    </message>
    <message>
        <source>Save score…</source>
        <translation>保存成绩…</translation>
    </message>
    <message>
        <source>Writes every question, answer and result as a table (CSV) that a spreadsheet opens</source>
        <translation>把每个问题、答案和结果写成电子表格可打开的表 (CSV)</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Your prediction, a number</source>
        <translation>你的预测，一个数</translation>
    </message>
    <message>
        <source>Whether the prediction was right</source>
        <translation>预测是否正确</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%2 题答对 %1 题</translation>
    </message>
    <message>
        <source>✔ Right.</source>
        <translation>✔ 正确。</translation>
    </message>
    <message>
        <source>✘ Not right.</source>
        <translation>✘ 不对。</translation>
    </message>
    <message>
        <source>Save the score</source>
        <translation>保存成绩</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>%1 of %2 right, %3 skipped</source>
        <translation>%2 题中答对 %1 题，跳过 %3 题</translation>
    </message>
    <message>
        <source>– Skipped.</source>
        <translation>– 已跳过。</translation>
    </message>
    <message>
        <source>Steps by the grain “%1” ask.</source>
        <translation>按“%1”粒度的步会提问。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Predictions</name>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
</context>
<context>
    <name>zscope::ui::PyramidPanel</name>
    <message>
        <source>Over the picture</source>
        <translation>叠加到图像上</translation>
    </message>
    <message>
        <source>Follow the step</source>
        <translation>跟随步骤</translation>
    </message>
    <message>
        <source>The last question to the pyramid</source>
        <translation>对金字塔的最近一次查询</translation>
    </message>
    <message>
        <source>The cell written last</source>
        <translation>最近写入的单元格</translation>
    </message>
    <message>
        <source>Lays the cells of this level over the picture, with their values when zoomed in</source>
        <translation>把这一级的单元格叠加到图像上，放大时显示数值</translation>
    </message>
    <message>
        <source>Shows the level that the last question or update was about</source>
        <translation>显示最近一次查询或更新所涉及的一级</translation>
    </message>
    <message>
        <source>Open a scene to see its pyramid of depths.</source>
        <translation>打开一个场景来查看它的深度金字塔。</translation>
    </message>
    <message>
        <source>The pyramid appears when the frame has been cleared. Press Right to go on.</source>
        <translation>帧清除之后显示金字塔。按右方向键继续。</translation>
    </message>
    <message>
        <source>level %1 · %2 × %3</source>
        <translation>第 %1 级 · %2 × %3</translation>
    </message>
    <message>
        <source> · not stored</source>
        <translation> · 不存储</translation>
    </message>
    <message>
        <source> · %1</source>
        <translation> · %1</translation>
    </message>
    <message>
        <source>1 cell lags</source>
        <translation>1 个单元格落后</translation>
    </message>
    <message>
        <source>%1 cells lag</source>
        <translation>%1 个单元格落后</translation>
    </message>
    <message>
        <source>Nothing has been asked yet: step by the grain “query”.</source>
        <translation>还没有查询过：请按粒度“查询”单步。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::RangeBar</name>
    <message>
        <source>Range of depths</source>
        <translation>深度范围</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合</translation>
    </message>
    <message>
        <source>From the farthest to the nearest depth of the picture (N)</source>
        <translation>从图像的最远深度到最近深度（N）</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>Equal ratios of depth, not equal differences, are equal steps of colour</source>
        <translation>等比（而非等差）的深度对应相等的颜色间隔</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
    <message>
        <source>far  %1</source>
        <translation>远  %1</translation>
    </message>
    <message>
        <source>near  %1</source>
        <translation>近  %1</translation>
    </message>
    <message>
        <source>depth D</source>
        <translation>深度 D</translation>
    </message>
</context>
<context>
    <name>zscope::ui::RunsModel</name>
    <message>
        <source>Pixels that show another triangle than the reference, or one or none where it does not</source>
        <translation>与参考图显示不同三角形、多出或缺失三角形的像素</translation>
    </message>
    <message>
        <source>The largest relative error of a view distance, wherever both show a triangle</source>
        <translation>在两者都显示三角形之处，视距的最大相对误差</translation>
    </message>
    <message>
        <source>Half of the frames took between the two quartiles</source>
        <translation>半数帧的时间在两个四分位数之间</translation>
    </message>
    <message>
        <source>algorithm</source>
        <translation>算法</translation>
    </message>
    <message>
        <source>choices</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>median, ms</source>
        <translation>中位数，毫秒</translation>
    </message>
    <message>
        <source>Q1, ms</source>
        <translation>Q1，毫秒</translation>
    </message>
    <message>
        <source>Q3, ms</source>
        <translation>Q3，毫秒</translation>
    </message>
    <message>
        <source>best, ms</source>
        <translation>最快，毫秒</translation>
    </message>
    <message>
        <source>wrong px</source>
        <translation>错误像素</translation>
    </message>
    <message>
        <source>depth error</source>
        <translation>深度误差</translation>
    </message>
</context>
<context>
    <name>zscope::ui::ScenePanel</name>
    <message>
        <source>Normalise</source>
        <translation>归一化</translation>
    </message>
    <message>
        <source>Drop an OBJ file on the window, press Ctrl+O, or choose File ▸ Examples.</source>
        <translation>把 OBJ 文件拖到窗口上，按 Ctrl+O，或选择“文件 ▸ 示例”。</translation>
    </message>
    <message>
        <source>Puts the mean of the vertices in the middle and fits the model&apos;s cube to the picture</source>
        <translation>把顶点的平均位置移到中央，并使模型的立方体适合图像</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Turn the model: y, z, y in degrees</source>
        <translation>转动模型：绕 y、z、y，以度计</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>polygons</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>instances</source>
        <translation>实例</translation>
    </message>
    <message>
        <source>size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>First angle, about y</source>
        <translation>第一个角，绕 y 轴</translation>
    </message>
    <message>
        <source>Second angle, about z</source>
        <translation>第二个角，绕 z 轴</translation>
    </message>
    <message>
        <source>Third angle, about y</source>
        <translation>第三个角，绕 y 轴</translation>
    </message>
    <message>
        <source>%1. The camera goes round the model, so the light turns with it.</source>
        <translation>%1。相机绕模型转动，所以光线也随之转动。</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 条警告</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 条警告</translation>
    </message>
    <message>
        <source>Left out or mended while reading</source>
        <translation>读取时舍弃或修补的内容</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 条</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Session</name>
    <message>
        <source>Loading</source>
        <translation>正在载入</translation>
    </message>
    <message>
        <source>Loading: %1</source>
        <translation>正在载入：%1</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>正在绘制</translation>
    </message>
    <message>
        <source>Replaying</source>
        <translation>正在重放</translation>
    </message>
    <message>
        <source>Drawing B</source>
        <translation>正在绘制 B</translation>
    </message>
    <message>
        <source>Replaying B</source>
        <translation>正在重放 B</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>pixel (%1, %2)</source>
        <translation>像素 (%1, %2)</translation>
    </message>
    <message>
        <source>node %1 of instance %2</source>
        <translation>实例 %2 的节点 %1</translation>
    </message>
    <message>
        <source>node %1</source>
        <translation>节点 %1</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>Bookmark %1</source>
        <translation>书签 %1</translation>
    </message>
    <message>
        <source>There is no bookmark that way for this algorithm and grain.</source>
        <translation>此算法和粒度在该方向上没有书签。</translation>
    </message>
    <message>
        <source>There is no breakpoint yet: pick a pixel, or select a node or a triangle, and press F9.</source>
        <translation>还没有断点：拾取像素，或选中节点或三角形，然后按 F9。</translation>
    </message>
    <message>
        <source>The run is at its end.</source>
        <translation>运行已到终点。</translation>
    </message>
    <message>
        <source>No breakpoint is met from here to the end.</source>
        <translation>从此处到终点没有命中断点。</translation>
    </message>
    <message>
        <source>No breakpoint is met from the start to here.</source>
        <translation>从起点到此处没有命中断点。</translation>
    </message>
    <message>
        <source>Stopped at the breakpoint on %1</source>
        <translation>停在断点：%1</translation>
    </message>
    <message>
        <source>Pick a pixel first: then the steps that change it can be found.</source>
        <translation>请先拾取一个像素，然后才能查找改变它的步。</translation>
    </message>
    <message>
        <source>No step changes pixel (%1, %2): it shows the background from the start.</source>
        <translation>没有任何一步改变像素 (%1, %2)：它从一开始就显示背景。</translation>
    </message>
    <message>
        <source>No step that way changes pixel (%1, %2).</source>
        <translation>该方向上没有改变像素 (%1, %2) 的步。</translation>
    </message>
    <message>
        <source>Change %1 of %2 of pixel (%3, %4)</source>
        <translation>像素 (%3, %4) 的第 %1 次改变，共 %2 次</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>正在查找</translation>
    </message>
    <message>
        <source>The drawing was cancelled. It begins again with the next step, or with another algorithm.</source>
        <translation>绘制已取消。再走一步或换一种算法就会重新开始。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::SheetMaker</name>
    <message>
        <source>Comparison sheet</source>
        <translation>对比页</translation>
    </message>
    <message>
        <source>Which algorithms stand side by side? The first is what the others are held against.</source>
        <translation>哪些算法并列？其余的都与第一个比较。</translation>
    </message>
    <message>
        <source>Algorithms of the sheet</source>
        <translation>对比页的算法</translation>
    </message>
    <message>
        <source>A sheet has 2 to %1 columns</source>
        <translation>一张对比页有 2 到 %1 栏</translation>
    </message>
</context>
<context>
    <name>zscope::ui::SpeedErrorChart</name>
    <message>
        <source>Speed against error</source>
        <translation>速度与误差</translation>
    </message>
    <message>
        <source>median time of a frame, ms</source>
        <translation>每帧时间的中位数，毫秒</translation>
    </message>
    <message>
        <source>wrong pixels</source>
        <translation>错误像素</translation>
    </message>
    <message>
        <source>largest relative depth error</source>
        <translation>最大相对深度误差</translation>
    </message>
    <message>
        <source>unbeaten</source>
        <translation>未被超越</translation>
    </message>
</context>
<context>
    <name>zscope::ui::StagesModel</name>
    <message>
        <source>Nothing that is counted is what this stage works on</source>
        <translation>该阶段处理的对象没有计数</translation>
    </message>
    <message>
        <source>The stage&apos;s time in the median frame over %1</source>
        <translation>中位帧里该阶段的时间除以 %1</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>整帧</translation>
    </message>
    <message>
        <source>Of what the stages&apos; medians add up to</source>
        <translation>占各阶段中位数之和的比例</translation>
    </message>
    <message>
        <source>The stage&apos;s time in the median frame over the number of things that it worked on in that frame; with several threads wall time, not work</source>
        <translation>中位帧里该阶段的时间除以它在该帧处理的对象的数目；多线程时是实际经过的时间，而非工作量</translation>
    </message>
    <message>
        <source>stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Q1, ms</source>
        <translation>Q1，毫秒</translation>
    </message>
    <message>
        <source>median, ms</source>
        <translation>中位数，毫秒</translation>
    </message>
    <message>
        <source>Q3, ms</source>
        <translation>Q3，毫秒</translation>
    </message>
    <message>
        <source>share, %</source>
        <translation>占比，%</translation>
    </message>
    <message>
        <source>ns per piece</source>
        <translation>纳秒 / 件</translation>
    </message>
</context>
<context>
    <name>zscope::ui::StartPage</name>
    <message>
        <source>A microscope for visible-surface algorithms: step through how a picture is made, and ask of any pixel why it shows what it shows.</source>
        <translation>可见面算法的显微镜：逐步观察画面如何生成，并询问任一像素为何如此显示。</translation>
    </message>
    <message>
        <source>or drop an OBJ file here</source>
        <translation>或把 OBJ 文件拖到这里</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>最近打开</translation>
    </message>
    <message>
        <source>Open a scene…</source>
        <translation>打开场景…</translation>
    </message>
    <message>
        <source>Begin with lesson 1</source>
        <translation>从第 1 课开始</translation>
    </message>
</context>
<context>
    <name>zscope::ui::StatusLine</name>
    <message>
        <source>x %1  y %2</source>
        <translation>x %1  y %2</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>Time of the frame</source>
        <translation>本帧用时</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Pixel</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop what is being loaded, drawn or replayed (Esc)</source>
        <translation>停止正在进行的载入、绘制或重放（Esc）</translation>
    </message>
    <message>
        <source>One frame at full speed</source>
        <translation>全速绘制一帧的时间</translation>
    </message>
    <message>
        <source>The median of %1 frames at full speed</source>
        <translation>全速绘制 %1 帧的时间中位数</translation>
    </message>
    <message>
        <source>; replaying up to this step took %1</source>
        <translation>；重放到本步用了 %1</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>exact by face</source>
        <translation>按面精确</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>近似</translation>
    </message>
    <message>
        <source>with a fault</source>
        <translation>带错误</translation>
    </message>
    <message>
        <source>1 thread</source>
        <translation>1 个线程</translation>
    </message>
    <message>
        <source>%1 threads</source>
        <translation>%1 个线程</translation>
    </message>
    <message>
        <source>%1 of %2 seen in %3</source>
        <translation>%2中有 %1 个可见，共 %3</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 个三角形</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>1 pixel</source>
        <translation>1 个像素</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 个像素</translation>
    </message>
    <message>
        <source>id %1</source>
        <translation>编号 %1</translation>
    </message>
    <message>
        <source>depth %1</source>
        <translation>深度 %1</translation>
    </message>
</context>
<context>
    <name>zscope::ui::StepTrack</name>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>第 %1 步</translation>
    </message>
    <message>
        <source>stage: %1</source>
        <translation>阶段：%1</translation>
    </message>
</context>
<context>
    <name>zscope::ui::TimelinePanel</name>
    <message>
        <source>step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>First step</source>
        <translation>第一步</translation>
    </message>
    <message>
        <source>First step (Home)</source>
        <translation>第一步（Home）</translation>
    </message>
    <message>
        <source>One step back (Left); Shift+Left: one of the next coarser grain</source>
        <translation>后退一步（左方向键）；Shift+左方向键：按更粗一级的粒度后退</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>播放或暂停（空格）</translation>
    </message>
    <message>
        <source>One step forward (Right); Shift+Right: one of the next coarser grain</source>
        <translation>前进一步（右方向键）；Shift+右方向键：按更粗一级的粒度前进</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>最后一步</translation>
    </message>
    <message>
        <source>The finished picture (End)</source>
        <translation>完成的图像（End）</translation>
    </message>
    <message>
        <source>Grain of a step</source>
        <translation>单步的粒度</translation>
    </message>
    <message>
        <source>How large a step is</source>
        <translation>一步有多大</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Steps per second while playing</source>
        <translation>播放时每秒的步数</translation>
    </message>
    <message>
        <source>What this step did</source>
        <translation>这一步做了什么</translation>
    </message>
    <message>
        <source>%1 / s</source>
        <translation>%1 步/秒</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>The steps of the algorithm appear here once a scene is open.</source>
        <translation>打开场景后，算法的步骤会显示在这里。</translation>
    </message>
    <message>
        <source>1 bookmark</source>
        <translation>1 个书签</translation>
    </message>
    <message>
        <source>%1 bookmarks</source>
        <translation>%1 个书签</translation>
    </message>
    <message>
        <source>breakpoint on %1</source>
        <translation>断点：%1</translation>
    </message>
    <message>
        <source>%1 breakpoints</source>
        <translation>%1 个断点</translation>
    </message>
    <message>
        <source>Bookmark of this step</source>
        <translation>此步的书签</translation>
    </message>
    <message>
        <source>Marks this step, or takes its mark away (Ctrl+B)</source>
        <translation>标记此步或取消标记 (Ctrl+B)</translation>
    </message>
    <message>
        <source>Say what this step brings: the question is above its table.</source>
        <translation>请说出这一步带来什么：问题在相应表格的上方。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::TraceFieldsModel</name>
    <message>
        <source>What our run holds after the step of this row</source>
        <translation>我们的运行在该行对应的步骤之后的内容</translation>
    </message>
    <message>
        <source>What the row of your trace says</source>
        <translation>你的记录中该行的内容</translation>
    </message>
    <message>
        <source>field</source>
        <translation>字段</translation>
    </message>
    <message>
        <source>ours</source>
        <translation>我们的</translation>
    </message>
    <message>
        <source>yours</source>
        <translation>你的</translation>
    </message>
</context>
<context>
    <name>zscope::ui::TracePanel</name>
    <message>
        <source>Open a trace of your own program, or drop it on the window: it is stepped beside our run, and the first row that differs is found.</source>
        <translation>打开你自己程序的运行记录，或把它拖到窗口上：它会与我们的运行并排单步，并找出第一个不同的行。</translation>
    </message>
    <message>
        <source>Open my trace…</source>
        <translation>打开我的运行记录…</translation>
    </message>
    <message>
        <source>Judge again</source>
        <translation>重新判断</translation>
    </message>
    <message>
        <source>Reads the file again and holds it against the run on show</source>
        <translation>重新读取文件，并与当前显示的运行比较</translation>
    </message>
    <message>
        <source>Back to its run</source>
        <translation>回到原运行</translation>
    </message>
    <message>
        <source>To the scene, the camera and the algorithm that the trace was held against</source>
        <translation>回到与该记录比较时所用的场景、相机和算法</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes the trace; the file stays as it is</source>
        <translation>关闭记录，文件保持不变</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>First difference</source>
        <translation>第一处不同</translation>
    </message>
    <message>
        <source>The row before</source>
        <translation>上一行</translation>
    </message>
    <message>
        <source>The next row</source>
        <translation>下一行</translation>
    </message>
    <message>
        <source>The next row that differs</source>
        <translation>下一个不同的行</translation>
    </message>
    <message>
        <source>Rows of the trace</source>
        <translation>记录的各行</translation>
    </message>
    <message>
        <source>Fields of the row: ours and yours</source>
        <translation>该行的字段：我们的与你的</translation>
    </message>
    <message>
        <source>Progress of the judging</source>
        <translation>判断的进度</translation>
    </message>
    <message>
        <source>The trace is read and held against our run.</source>
        <translation>正在读取记录，并与我们的运行比较。</translation>
    </message>
    <message>
        <source>Another run is on show than the one that the trace was held against.</source>
        <translation>当前显示的运行不是与该记录比较的那一个。</translation>
    </message>
    <message>
        <source>old</source>
        <translation>已过时</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>没有不同</translation>
    </message>
    <message>
        <source>1 row differs</source>
        <translation>1 行不同</translation>
    </message>
    <message>
        <source>%1 rows differ</source>
        <translation>%1 行不同</translation>
    </message>
    <message>
        <source>The row stands beside ours when the question is answered.</source>
        <translation>回答问题之后，该行才与我们的并排显示。</translation>
    </message>
    <message>
        <source>This row differs by rounding alone.</source>
        <translation>该行仅因舍入而不同。</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>不同之处</translation>
    </message>
</context>
<context>
    <name>zscope::ui::TraceRowsModel</name>
    <message>
        <source>the same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>differs by rounding alone</source>
        <translation>仅因舍入而不同</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>✓ the same, ≈ differs by rounding alone, ✖ differs</source>
        <translation>✓ 相同，≈ 仅因舍入而不同，✖ 不同</translation>
    </message>
    <message>
        <source>Line of the file</source>
        <translation>文件中的行号</translation>
    </message>
    <message>
        <source>The step of our run that the row is held against</source>
        <translation>该行与我们运行的哪一步比较</translation>
    </message>
    <message>
        <source>line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>时刻</translation>
    </message>
</context>
<context>
    <name>zscope::ui::Tracer</name>
    <message>
        <source>Open the scene first that your trace is of.</source>
        <translation>请先打开你的运行记录所属的场景。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::VerdictBar</name>
    <message>
        <source>%1 nodes, %2</source>
        <translation>%1的结点，%2 个</translation>
    </message>
    <message>
        <source>%1: shown. Click to hide them.</source>
        <translation>%1：显示中。单击以隐藏。</translation>
    </message>
    <message>
        <source>%1: not shown. Click to show them.</source>
        <translation>%1：未显示。单击以显示。</translation>
    </message>
</context>
<context>
    <name>zscope::ui::WhyModel</name>
    <message>
        <source>level %1</source>
        <translation>第 %1 级</translation>
    </message>
    <message>
        <source>%1, face %2</source>
        <translation>%1，面 %2</translation>
    </message>
    <message>
        <source>what happened</source>
        <translation>发生了什么</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>where</source>
        <translation>何处</translation>
    </message>
    <message>
        <source>fate</source>
        <translation>结局</translation>
    </message>
    <message>
        <source>depth D</source>
        <translation>深度 D</translation>
    </message>
</context>
<context>
    <name>zscope::ui::WhyPanel</name>
    <message>
        <source>Go there</source>
        <translation>转到该处</translation>
    </message>
    <message>
        <source>Triangles that cover the pixel</source>
        <translation>覆盖该像素的三角形</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>为什么</translation>
    </message>
    <message>
        <source>What happened to the chosen triangle</source>
        <translation>所选三角形的经历</translation>
    </message>
    <message>
        <source>Goes to the step of the run that the chosen row tells of (Enter)</source>
        <translation>转到所选行所述的那一步（Enter）</translation>
    </message>
    <message>
        <source>Why not triangle …</source>
        <translation>为什么不是三角形…</translation>
    </message>
    <message>
        <source>Number of a triangle to ask about</source>
        <translation>要询问的三角形编号</translation>
    </message>
    <message>
        <source>Open a scene to ask why a pixel shows what it shows.</source>
        <translation>打开一个场景，询问某个像素为什么显示成这样。</translation>
    </message>
    <message>
        <source>Click a pixel of the picture: everything that covers it appears here, with what became of it.</source>
        <translation>单击图像中的一个像素：覆盖它的一切以及各自的结局都会列在这里。</translation>
    </message>
    <message>
        <source>Running the frame once more, to see …</source>
        <translation>正在重新运行这一帧，以便观察…</translation>
    </message>
    <message>
        <source>pixel %1, %2 · %3</source>
        <translation>像素 %1, %2 · %3</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 个三角形</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>node too small</source>
        <translation>结点太小</translation>
    </message>
    <message>
        <source>Choose a row that tells of a step</source>
        <translation>请选择讲述某一步的行</translation>
    </message>
    <message>
        <source>That is the finished picture; the step on show may not have come so far.</source>
        <translation>这是绘制完成后的图像；当前显示的步骤可能还没有走到那里。</translation>
    </message>
    <message>
        <source>the background at %1</source>
        <translation>%1 为背景</translation>
    </message>
    <message>
        <source>triangle %1 at %2</source>
        <translation>%2 为三角形 %1</translation>
    </message>
    <message>
        <source>1 other triangle</source>
        <translation>另外 1 个三角形</translation>
    </message>
    <message>
        <source>%1 other triangles</source>
        <translation>另外 %1 个三角形</translation>
    </message>
    <message>
        <source>In its place its pixels show %1.</source>
        <translation>它的像素所显示的是：%1。</translation>
    </message>
    <message>
        <source>1 pixel</source>
        <translation>1 个像素</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 个像素</translation>
    </message>
    <message>
        <source>What B has at the pixel</source>
        <translation>B 在该像素处的值</translation>
    </message>
</context>
</TS>
