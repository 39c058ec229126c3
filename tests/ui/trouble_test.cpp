// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong is said in the language of the window: files of every kind
// are broken in every place, and no English sentence may come out.
#include <random>
#include <set>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QRegularExpression>

#include "core/lesson/explain.h"
#include "core/lesson/lesson_facts.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_run.h"
#include "core/measure/record.h"
#include "core/scene/load.h"
#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/session/course.h"
#include "ui/session/session_file.h"
#include "ui/text/phrase_book.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

const QString kSources = QStringLiteral(ZSCOPE_SOURCE_DIR);

/// Three English words in a row, outside of what is quoted from a file; words that can be chosen stand between commas.
QString englishIn(QString text)
{
    text.remove(QRegularExpression(QStringLiteral("“[^”]*”|\"[^\"]*\"")));
    const auto found = QRegularExpression("[A-Za-z]{2,}( [A-Za-z]{2,}){2,}").match(text);
    return found.hasMatch() ? found.captured() : QString();
}

bool isChinese(const QString& text) { return text.contains(QRegularExpression(QStringLiteral("[\u4E00-\u9FFF]"))); }

/// Says every error, and remembers those that are not said in Chinese.
class Hearing {
public:
    void hear(const Error& error)
    {
        if (error.kind == Trouble::Cancelled) return;
        hear(error.sentence);
    }
    template <class Value>
    void hear(const Result<Value>& result)
    {
        QVERIFY(!result.ok());
        hear(result.error());
    }
    void hear(const std::string& sentence)
    {
        m_heard.insert(QString::fromStdString(sentence).replace(QRegularExpression("[0-9]+"), "1"));
        const QString chinese = said(sentence);
        if (!isChinese(chinese) || !englishIn(chinese).isEmpty())
            m_english.insert(QString::fromStdString(sentence) + " -> " + chinese);
    }
    bool isChineseOnly() const
    {
        for (const QString& sentence : m_english) qWarning("%s", qPrintable(sentence));
        return m_english.empty();
    }
    std::size_t sentences() const { return m_heard.size(); }

private:
    std::set<QString> m_heard, m_english;
};

QByteArray jsonOf(const QJsonValue& value)
{
    return value.isArray() ? QJsonDocument(value.toArray()).toJson() : QJsonDocument(value.toObject()).toJson();
}

/// The document with one place of it changed; every place, every change.
void eachBroken(const QJsonValue& value, const std::function<void(const QJsonValue&)>& use)
{
    static const QJsonArray kInstead{QJsonValue(),
                                     true,
                                     -1,
                                     0,
                                     2.5,
                                     1e300,
                                     "x",
                                     QString(),
                                     QJsonArray(),
                                     QJsonArray{1},
                                     QJsonArray{-1, 2},
                                     QJsonArray{1, 2, "y"},
                                     QJsonObject(),
                                     QJsonObject{{"zzz", 1}}};
    for (const QJsonValue& instead : kInstead) use(instead);
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto member = object.begin(); member != object.end(); ++member) {
            QJsonObject without = object;
            without.remove(member.key());
            use(without);
            eachBroken(member.value(), [&](const QJsonValue& broken) {
                QJsonObject with   = object;
                with[member.key()] = broken;
                use(with);
            });
        }
        QJsonObject more = object;
        more["zzz"]      = 1;
        use(more);
    } else if (value.isArray()) {
        const QJsonArray array = value.toArray();
        for (qsizetype i = 0; i < std::min<qsizetype>(array.size(), 2); ++i) {
            QJsonArray without = array;
            without.removeAt(i);
            use(without);
            eachBroken(array[i], [&](const QJsonValue& broken) {
                QJsonArray with = array;
                with[i]         = broken;
                use(with);
            });
        }
    }
}

/// The text with its bytes disturbed, so that it is no JSON any more.
void eachSpoilt(const std::string& text, const std::function<void(const std::string&)>& use)
{
    std::mt19937 random(5);
    for (int i = 0; i < 600; ++i) {
        std::string       spoilt = text;
        const std::size_t at     = random() % spoilt.size();
        switch (random() % 4) {
            case 0:
                spoilt.resize(at);
                break;
            case 1:
                spoilt[at] = "{}[],:\"x7-\n\x01\\/'\xC3;N"[random() % 18];
                break;
            case 2:
                spoilt.erase(at, 1 + random() % 3);
                break;
            case 3:
                spoilt.insert(at, 1, "{}[],:\"x7-\n\x01\\/'\xC3;N"[random() % 18]);
                break;
        }
        use(spoilt);
    }
    for (const char* odd : {"“", "\u00A0", "True", "NaN", "\\u12", "\\uD800", "1,5"})
        for (int i = 0; i < 30; ++i) use(std::string(text).insert(random() % text.size(), odd));
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
void write(const QString& path, const QByteArray& text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

const char* const kScene = R"({
  "meshes": {"a": {"builtin": "cube"}, "b": {"obj": "b.obj"}},
  "materials": {"red": {"colour": [1, 0, 0]}, "net": {"colour": [1, 1, 0], "cutout": {"pattern": "checker",
      "size": 0.2}},
                "glass": {"colour": [0, 0, 1], "opacity": 0.5}, "rough": {"colour": [0, 1, 0],
                    "relief": {"pattern": "bricks", "size": 0.2, "depth": 0.1}}},
  "instances": [{"mesh": "a", "material": "red", "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0]},
                {"mesh": "a", "colour": "each", "grid": {"count": [2, 1, 1], "step": [2, 0, 0]}},
                {"mesh": "b", "colour": [1, 0, 1], "random": {"count": 2, "seed": 1, "min": [0, 0, 0], "max": [1, 1,
                    1], "rotate": true}},
                {"mesh": "a", "material": "glass"}, {"mesh": "a", "material": "net"}, {"mesh": "a",
                    "material": "rough"},
                {"mesh": "a", "material": "red", "colour": [1, 1, 1]}],
  "light": {"direction": [-1, -1, -1]},
  "cameras": {"one": {"eye": [3, 3, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 40, "near": 0.1, "far": 100,
      "size": [64, 36], "cull": "back"}}
})";

const char* const kBrokenObjects[] = {"",
                                      "v 1\n",
                                      "v 1 2 x\n",
                                      "v 0 0 0\n",
                                      "# nothing\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 a\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3//4/5\n",
                                      "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "v 0 0 1e999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "\xFF\xFEv\0",
                                      "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"};
const char* const kOddObjects[]    = {"v 0 0 0 7 junk\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "mtllib\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl ghost\nf 1 2 3\n",
                                      "mtllib /abs/x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "mtllib ../x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\nf 1 2 9\ncurv 1 2\n",
                                      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n",
                                      "mtllib odd.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 1 2 x\nf 1 2 4\n",
                                      "mtllib wide.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "mtllib C:\\x\\odd.mtl D:/none.mtl Odd.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng a\\\nusemtl b\nf 1 2 3\n"};

}  // namespace

class TroubleTest final : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QCoreApplication::processEvents(); }

    void aSessionBrokenAnywhereIsToldOfInChinese()
    {
        Desk desk("hzb-octree");
        desk.window.speak(Language::Chinese);
        QVERIFY(desk.open("builtin:cubes", {64, 36}));
        desk.session.compareWith(findPreset("scanline")->pipeline);
        desk.session.toggleBookmark();
        Breakpoint node{.on = Breakpoint::On::Node};
        node.node = {InstanceId{1}, "0"};
        desk.session.toggleBreakpoint({.on = Breakpoint::On::Line, .line = 7});
        desk.session.toggleBreakpoint(node);
        desk.session.pick(QPoint(3, 4));
        QVERIFY(desk.settles());
        SessionFile session        = *sessionFileOf(desk.session);
        session.layout             = desk.window.layoutNow();
        session.step               = 3;
        session.selection.node     = node.node;
        session.selection.level    = 1;
        session.selection.triangle = TriangleId{2};
        const std::string text     = sessionToJson(session, "/a/b.zscope-session");
        QVERIFY(sessionFromJson(text, "/a/b.zscope-session").ok());
        Hearing    all;
        const auto hear = [&](const std::string& broken) {
            if (const auto read = sessionFromJson(broken, "/a/b.zscope-session"); !read) all.hear(read.error());
        };
        eachBroken(QJsonDocument::fromJson(QByteArray::fromStdString(text)).object(),
                   [&](const QJsonValue& broken) { hear(jsonOf(broken).toStdString()); });
        eachSpoilt(text, hear);
        QVERIFY2(all.sentences() > 80, qPrintable(QString::number(all.sentences())));
        QVERIFY(all.isChineseOnly());
    }
    void aSceneBrokenAnywhereIsToldOfInChinese()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        QTemporaryDir folder;
        write(folder.filePath("b.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString file = folder.filePath("s.json");
        Hearing       all;
        const auto    hear = [&](const QByteArray& text) {
            write(file, text);
            const auto scene = loadScene(file.toStdString(), {.memoryLimit = 64u << 20});
            if (!scene) return all.hear(scene.error());
            for (const Warning& warning : scene->warnings) all.hear(warning.sentence);
        };
        QJsonObject scene = QJsonDocument::fromJson(kScene).object();
        QVERIFY(!scene.isEmpty());
        // An instance each, so that what is wrong with one does not hide the others.
        const QJsonArray instances = scene["instances"].toArray();
        for (const QJsonValue& instance : instances) {
            scene["instances"] = QJsonArray{instance};
            hear(jsonOf(scene));
            eachBroken(instance, [&](const QJsonValue& broken) {
                scene["instances"] = QJsonArray{broken};
                hear(jsonOf(scene));
            });
        }
        scene["instances"] = QJsonArray{instances[0]};
        eachBroken(scene, [&](const QJsonValue& broken) { hear(jsonOf(broken)); });
        for (const char* mesh :
             {R"({"obj": "/abs.obj"})", R"({"obj": "../up.obj"})", R"({"obj": "none.obj"})", R"({"obj": "b.txt"})",
              R"({"builtin": "none"})", R"({"builtin": "city"})", R"({"builtin": "teapot?size=x"})"}) {
            QJsonObject other = scene;
            other["meshes"]   = QJsonObject{{"a", QJsonDocument::fromJson(mesh).object()}};
            hear(jsonOf(other));
        }
        eachSpoilt(jsonOf(scene).toStdString(),
                   [&](const std::string& text) { hear(QByteArray::fromStdString(text)); });
        QVERIFY2(all.sentences() > 100, qPrintable(QString::number(all.sentences())));
        QVERIFY(all.isChineseOnly());
    }
    void anObjectFileBrokenOrOddIsToldOfInChinese()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        QTemporaryDir folder;
        write(folder.filePath("odd.mtl"),
              "newmtl\nnewmtl a\nKd 1 x 0\nKd\nd 7x\nTr\nnewmtl b\nKd 1e999 0 0\nmap_Kd a.png\n");
        write(folder.filePath("wide.mtl"), QByteArray("\xFF\xFEn\0", 4));
        const QString file = folder.filePath("b.obj");
        Hearing       all;
        int           broken = 0;
        for (const char* text : kBrokenObjects) {
            write(file, text[0] == '\xFF' ? QByteArray("\xFF\xFEv\0 \0", 6) : QByteArray(text));
            const auto scene = loadScene(file.toStdString());
            QVERIFY2(!scene.ok(), text);
            all.hear(scene.error());
            ++broken;
        }
        for (const char* text : kOddObjects) {
            write(file, text);
            const auto scene = loadScene(file.toStdString());
            QVERIFY2(scene.ok(), text);
            QVERIFY2(!scene->warnings.empty(), text);
            for (const Warning& warning : scene->warnings) all.hear(warning.sentence);
        }
        for (const QString& absent : {folder.filePath("none.obj"), folder.path() + ".obj", folder.filePath("x.txt"),
                                      QString("builtin:none"), QString("builtin:tea"), QString("builtin:cube?x=1"),
                                      QString("builtin:city?blocks"), QString("builtin:city?blocks=1&blocks=2"),
                                      QString("builtin:city?blocks=x"), QString("builtin:city?blocks="),
                                      QString("builtin:city?block=1"), QString("builtin:city?blocks=1000000000")})
            if (const auto scene = loadScene(absent.toStdString(), {.memoryLimit = 1u << 20}); !scene)
                all.hear(scene.error());
        QVERIFY(QDir().mkpath(folder.filePath("folder.obj")));
        const auto isFolder = loadScene(folder.filePath("folder.obj").toStdString());
        QVERIFY(!isFolder);
        all.hear(isFolder.error());
        QVERIFY2(all.sentences() > 30, qPrintable(QString::number(all.sentences())));
        QVERIFY(all.isChineseOnly());
    }
    void aSceneThatIsTooLargeIsToldOfInChinese()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        Hearing all;
        for (const SceneEntry& entry : builtinScenes())
            for (const char* value : {"999", "2000000", "0.5", "x", ""}) {
                const std::string defaults(entry.parameters);
                for (std::size_t from = 0; from < defaults.size();) {
                    const std::size_t to    = std::min(defaults.find('&', from), defaults.size());
                    const std::string key   = defaults.substr(from, defaults.find('=', from) - from);
                    const auto        scene = loadScene("builtin:" + std::string(entry.name) + "?" + key + "=" + value,
                                                        {.memoryLimit = 1u << 16});
                    if (!scene) all.hear(scene.error());
                    from = to + 1;
                }
            }
        QVERIFY(all.sentences() > 20);
        QVERIFY(all.isChineseOnly());
    }
    void aLessonBrokenAnywhereIsToldOfInChinese()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        Hearing    all;
        const auto hear = [&](const QString& text) {
            if (const auto lesson = parseLesson(text.toStdString(), "lesson.md"); !lesson) all.hear(lesson.error());
        };
        const QRegularExpression sections(
            "^=== (lesson|page|question)\n(\\{.*?\\})\n(?==== |$)",
            QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
        int broken = 0;
        for (const char* name :
             {"01-what-hides-what", "05-intervals", "10-octree-front-to-back", "13-holes-and-fill-rules"}) {
            const QString text = QString::fromUtf8(bytesOf(kSources + "/resources/lessons/" + name + ".md"));
            QVERIFY(parseLesson(text.toStdString(), "lesson.md").ok());
            for (const auto& match : sections.globalMatch(text)) {
                const QJsonObject object = QJsonDocument::fromJson(match.captured(2).toUtf8()).object();
                QVERIFY2(!object.isEmpty(), qPrintable(match.captured(2)));
                eachBroken(object, [&](const QJsonValue& value) {
                    ++broken;
                    hear(QString(text).replace(match.capturedStart(2), match.capturedLength(2),
                                               QString::fromUtf8(jsonOf(value))));
                });
            }
            const QStringList lines = text.split('\n');
            for (qsizetype i = 0; i < lines.size(); ++i) {
                QStringList without = lines, twice = lines, other = lines;
                without.removeAt(i);
                twice.insert(i, lines[i]);
                if (lines[i].startsWith("=== ")) other[i] = "=== else";
                for (const QStringList& all_ : {without, twice, other}) hear(all_.join('\n'));
            }
        }
        QVERIFY(broken > 500);
        const QString head = "=== lesson\n{\"title\": \"t\"}\n",
                      page =
                          "=== page\n{\"scene\": \"builtin:cube\", \"algorithm\": \"hzb-octree\", \"size\": [64, 36], "
                          "\"stop\": %1}\n=== en\nx\n",
                      question = page.arg("{\"grain\": \"frame\", \"end\": true}") + "=== question\n";
        for (const char* stop :
             {R"({"end": true, "grain": "frame", "line": 2})", R"({"grain": "line", "line": 2})",
              R"({"grain": "node", "instance": 1})", R"({"grain": "node", "step": 1, "triangle": 2})",
              R"({"grain": "node"})", R"({"node": "0"})", R"({"grain": "pixel", "pixel": [99, 99]})",
              R"({"grain": "node", "verdict": "none"})"})
            hear(head + page.arg(stop));
        for (const char* one :
             {R"({"kind": "number", "ask": "a", "why": "b"})",
              R"({"kind": "number", "fact": "none", "ask": "a", "why": "b"})",
              R"({"kind": "pixel", "fact": "none", "ask": "a", "why": "b"})",
              R"({"kind": "pixel", "ask": "a", "why": "b"})",
              R"({"kind": "number", "answer": 1, "tolerance": -1, "ask": "a", "why": "b"})",
              R"({"kind": "choice", "answer": 1, "ask": "a", "why": "b"})",
              R"({"kind": "choice", "ask": "a", "why": "b"})",
              R"({"kind": "choice", "ask": "a", "why": "b", "choices": [{"text": "x"}, {"text": "y"}]})",
              R"({"kind": "choice", "ask": "a", "why": "b", "choices": [{"text": "x", "value": 1}, {"text": "y"}]})",
              R"({"kind": "choice", "fact": "line", "ask": "a", "why": "b", "choices": [{"text": "x", "value": 1,
                 "from": 2}, {"text": "y"}]})",
              R"({"kind": "choice", "fact": "line", "ask": "a", "why": "b", "choices": [{"text": "x", "from": 3,
                 "to": 2}, {"text": "y"}]})",
              R"({"kind": "choice", "fact": "line", "ask": "a", "why": "b", "choices": [{"text": "x", "value": 1},
                 {"text": "y"}]})",
              R"({"kind": "number", "answer": 1, "value": 1, "ask": "a", "why": "b"})",
              R"({"kind": "number", "answer": 1, "ask": "a", "why": "b", "choices": [{"text": "x"}]})"})
            hear(head + question + one + "\n");
        for (const char* text : {"", "=== page\n{}", "=== en\nx", "=== question\n{}", "=== lesson\n{\"title\": \"\"}",
                                 "=== lesson\n{}", "=== lesson\n[]"})
            hear(text);
        hear(head + head);
        hear(head + "=== page\n{}");
        hear(head + page.arg("{\"grain\": \"frame\", \"end\": true}") + "=== en\ny\n");
        QVERIFY2(all.sentences() > 100, qPrintable(QString::number(all.sentences())));
        QVERIFY(all.isChineseOnly());
    }
    void aLessonThatTheRendererContradictsIsToldOfInChinese()
    {
        Desk desk("hzb-octree");
        desk.window.speak(Language::Chinese);
        QVERIFY(desk.open("builtin:cube", {64, 36}));
        const DrawRequest request = desk.session.request();
        Hearing           all;
        // Every fact, at steps that lack it.
        Replay     replay(request);
        const auto start = replay.at(Grain::Frame, StepIndex{0});
        QVERIFY(start.ok());
        for (const char* algorithm : {"hzb-octree", "scanline", "zbuffer"}) {
            DrawRequest other = request;
            other.pipeline    = findPreset(algorithm)->pipeline;
            const auto end    = Replay(other).at(Grain::Frame, StepIndex{0});
            QVERIFY(end.ok());
            for (const FactEntry& fact : facts())
                if (const auto value = factOf(fact.word, FactSource{*end, other, std::nullopt}); !value)
                    all.hear(value);
        }
        all.hear(factOf("none", FactSource{*start, request, std::nullopt}));
        all.hear(factOf("work.none", FactSource{*start, request, std::nullopt}));
        all.hear(pixelFactOf("none", FactSource{*start, request, std::nullopt}));
        const auto run = [&](const QString& stop, const QString& question) {
            const QString text =
                "=== lesson\n{\"title\": \"t\"}\n=== page\n{\"scene\": \"builtin:cube\", \"algorithm\": "
                "\"hzb-octree\", \"size\": [64, 36], \"stop\": "
                + stop + "}\n=== en\nx\n=== question\n" + question;
            const auto lesson = parseLesson(text.toStdString(), "lesson.md");
            QVERIFY2(lesson.ok(), lesson.ok() ? "" : lesson.error().text().c_str());
            const auto answer = runPage(lesson->pages[0], "lesson.md", request);
            QVERIFY(!answer.ok());
            all.hear(answer);
        };
        const QString end    = R"({"grain": "frame", "end": true})",
                      number = R"({"kind": "number", "fact": "covered", "ask": "a", "why": "b"})";
        run(R"({"grain": "triangle", "triangle": 999999})", number);
        run(R"({"grain": "triangle", "triangle": 1, "nth": 999})", number);
        run(R"({"grain": "triangle", "step": 999999})", number);
        run(end, R"({"kind": "number", "fact": "line", "ask": "a", "why": "b"})");
        run(end, R"({"kind": "number", "fact": "covered", "at": "next", "ask": "a", "why": "b"})");
        run(end, R"({"kind": "number", "fact": "covered", "answer": -7, "ask": "a", "why": "b"})");
        run(end,
            R"({"kind": "choice", "fact": "covered", "ask": "a", "why": "b", "choices": [{"text": "x", "value": -1},
                {"text": "y", "value": -2}]})");
        run(end,
            R"({"kind": "choice", "fact": "covered", "ask": "a", "why": "b", "choices": [{"text": "x", "from": 0},
                {"text": "y", "from": 0}]})");
        run(end, R"({"kind": "pixel", "fact": "owner", "value": -7, "ask": "a", "why": "b"})");
        run(end, R"({"kind": "pixel", "fact": "owner", "from": -1, "ask": "a", "why": "b"})");
        // And what the renderer refuses.
        DrawRequest odd  = request;
        odd.memoryLimit  = 1 << 20;
        odd.camera.width = odd.camera.height = 4000;
        Replay tooLarge(odd);
        all.hear(tooLarge.count(Grain::Frame));
        all.hear(replay.count(Grain::Line));
        all.hear(replay.at(Grain::Node, StepIndex{1u << 30}));
        all.hear(explainPixel(request, {9999, 1}));
        all.hear(explainTriangle(request, TriangleId{9999}));
        QVERIFY2(all.sentences() > 55, qPrintable(QString::number(all.sentences())));
        QVERIFY(all.isChineseOnly());
    }
    void aRecordBrokenAnywhereIsToldOfInChinese()
    {
        Desk desk;
        desk.window.speak(Language::Chinese);
        Record record;
        record.head.caseCount = 1;
        RecordCase measured;
        measured.scene = "builtin:cube";
        measured.width = 4, measured.height = 3;
        measured.rows = "[{\"algorithm\": \"zbuffer\"}]";
        record.cases.push_back(measured);
        const std::string text = recordToJson(record);
        Hearing           all;
        const auto        hear = [&](const std::string& broken) {
            const auto read = recordFromJson(broken, "record.json");
            if (!read) return all.hear(read.error());
            for (const RecordCase& each : read->cases)
                if (const auto rows = rowsOf(each); !rows) all.hear(rows.error());
        };
        hear(text);  // its row lacks nearly everything
        eachBroken(QJsonDocument::fromJson(QByteArray::fromStdString(text)).object(),
                   [&](const QJsonValue& broken) { hear(jsonOf(broken).toStdString()); });
        eachSpoilt(text, hear);
        QVERIFY2(all.sentences() >= 5, qPrintable(QString::number(all.sentences())));
        QVERIFY(all.isChineseOnly());
    }
    void theWindowSaysItInItsLanguageAndSaysItAgainInAnother()
    {
        QTemporaryDir folder;
        write(folder.filePath("bad.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
        write(folder.filePath("bad.json"),
              "{\"meshes\": {\"a\": {\"builtin\": \"cube\"}},\n\"instances\": [{\"mesh\": \"b\"}]}");
        write(folder.filePath("torn.json"), "{\"meshes\": {\"a\": {\"builtin\"");
        write(folder.filePath("bad.zscope-session"), "{\"zscope-session\": 1,\n \"scene\": 7}");
        QVERIFY(QDir().mkpath(folder.filePath("lessons")));
        write(folder.filePath("lessons/01-bad.md"), "=== lesson\n{\"title\": \"t\"}\n=== page\n{\"scene\": 7}\n");
        write(folder.filePath("settings.ini"), "[look]\nlanguage=zh_CN\nthis is no setting\n");
        Desk desk("zbuffer");
        desk.window.speak(Language::Chinese);
        QCoreApplication::processEvents();
        MessageBar& bar        = desk.window.messages();
        const auto  toldInBoth = [&](const char* place) {
            const QString chinese = bar.sentence();
            QVERIFY2(isChinese(chinese), qPrintable(chinese));
            QVERIFY2(englishIn(QString(chinese).remove(folder.path())).isEmpty(), qPrintable(chinese));
            QVERIFY2(chinese.contains(place), qPrintable(chinese));
            desk.window.speak(Language::English);
            QCoreApplication::processEvents();
            QVERIFY2(!isChinese(bar.sentence()) && !englishIn(bar.sentence()).isEmpty(), qPrintable(bar.sentence()));
            QVERIFY2(bar.sentence().contains(place), qPrintable(bar.sentence()));
            desk.window.speak(Language::Chinese);
            QCoreApplication::processEvents();
            QCOMPARE(bar.sentence(), chinese);
        };
        for (const char* file :
             {"bad.obj", "bad.json", "torn.json", "bad.zscope-session", "absent.obj", "absent.zscope-session"}) {
            bar.hide();
            desk.window.open(folder.filePath(file));
            QVERIFY(QTest::qWaitFor([&] { return !bar.sentence().isEmpty(); }, Desk::kLong));
            toldInBoth(file);
            if (QString(file) == "torn.json") desk.photograph("trouble-chinese");
        }
        bar.hide();
        desk.window.open("builtin:cubs");
        QVERIFY(QTest::qWaitFor([&] { return !bar.sentence().isEmpty(); }, Desk::kLong));
        toldInBoth("cubs");
        bar.hide();
        desk.window.openLessons(folder.filePath("lessons"));
        toldInBoth("01-bad.md:4");
        bool isListed = false;
        for (const QLabel* label : desk.window.findChildren<QLabel*>("troubles"))
            isListed = isListed || (isChinese(label->text()) && label->text().contains("01-bad.md:4"));
        QVERIFY(isListed);
        bar.hide();
        desk.window.openLessons(folder.filePath("nowhere"));
        toldInBoth("nowhere");
        bar.hide();
        desk.window.saveSessionTo("/nowhere/x.zscope-session");  // nothing is loaded: nothing to save
        QVERIFY(bar.sentence().isEmpty());
        QVERIFY(desk.open("builtin:cube"));
        desk.window.saveSessionTo("/nowhere/x.zscope-session");
        toldInBoth("/nowhere/x.zscope-session");

        // Settings are read before there is a window.
        const Settings settings(folder.filePath("settings.ini"));
        QVERIFY(settings.trouble());
        bar.tell([&settings] { return *settings.trouble(); });
        toldInBoth("settings.ini:3");
    }
};

ZSCOPE_UI_TEST(TroubleTest, "trouble_test", Window)
#include "trouble_test.moc"
