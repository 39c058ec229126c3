// SPDX-License-Identifier: GPL-3.0-or-later
// The menus: which actions there are, their keys, and what they ask the session for.
#include "ui/parts/choice_box.h"
#include "ui/session/course.h"
#include "ui/session/examiner.h"
#include "ui/text/utf8_text.h"
#include "ui/window/actions.h"
#include "ui/window/layouts.h"
#include "ui/window/settings.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace zscope::ui {
namespace {

constexpr double kTurnStep = 5;  // degrees per arrow key
constexpr double kZoomStep = 1.25;
// of the picture, pixels
constexpr QSize kSizes[] = {{160, 90}, {640, 360}, {1280, 720}, {1600, 900}, {1920, 1080}, {3840, 2160}};

QKeySequence key(int k) { return QKeySequence(k); }
QKeySequence key(QKeyCombination k) { return QKeySequence(k); }
/// Digit 1 to 9 and a modifier, by its place from 0.
QKeySequence digit(int at, Qt::KeyboardModifiers modifiers)
{
    return QKeySequence(QKeyCombination(modifiers, static_cast<Qt::Key>(Qt::Key_1 + at)));
}

}  // namespace

void Actions::makeFileMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&File"));
    m_open      = add(menu, "file.open", QT_TR_NOOP("&Open…"), QKeySequence::Open, m_requests.open, "open");
    m_needScene.push_back(add(menu, "file.open-theirs", QT_TR_NOOP("Open &my picture…"),
                              key(Qt::CTRL | Qt::SHIFT | Qt::Key_O), m_requests.openTheirs));
    m_needScene.push_back(add(menu, "file.open-trace", QT_TR_NOOP("Open my &trace…"),
                              key(Qt::CTRL | Qt::ALT | Qt::Key_O), m_requests.openTrace));
    m_recent = addMenu(menu, QT_TR_NOOP("Open &recent"));
    for (int i = 0; i < Settings::kRecentFiles; ++i) {
        QAction* action =
            addNamed(m_recent, QString("recent.%1").arg(i + 1), QString(), {digit(i, Qt::ControlModifier)},
                     [this, i] { m_requests.openWord(m_recentFiles[static_cast<std::size_t>(i)]->data().toString()); });
        m_recentFiles.push_back(action);
    }
    m_recent->setToolTipsVisible(true);
    QMenu* examples = addMenu(menu, QT_TR_NOOP("&Examples"));
    QMenu* hard     = nullptr;
    for (const SceneEntry& scene : builtinScenes()) {
        const QString name  = utf8Text(scene.name);
        QMenu*        under = examples;
        if (name.startsWith("hard/")) {
            if (!hard) hard = addMenu(examples, QT_TR_NOOP("Hard cases"));
            under = hard;
        }
        QAction* action = addNamed(under, "example." + name, QString(name).replace('&', "&&"), {},
                                   [this, name] { m_requests.openWord("builtin:" + name); });
        m_titles.emplace_back(action, scene.title);
        under->setToolTipsVisible(true);
    }
    m_needScene.push_back(
        add(menu, "file.reload", QT_TR_NOOP("Re&load"), key(Qt::CTRL | Qt::Key_R), [this] { m_session.reload(); }));
    menu->addSeparator();
    m_needScene.push_back(
        add(menu, "file.save-picture", QT_TR_NOOP("&Save picture"), key(Qt::Key_F12), m_requests.savePicture));
    m_needScene.push_back(add(menu, "file.save-plain-picture", QT_TR_NOOP("Save picture &without decoration"),
                              key(Qt::CTRL | Qt::Key_F12), m_requests.savePlainPicture));
    m_needScene.push_back(add(menu, "file.save-picture-as", QT_TR_NOOP("Save picture &as…"), QKeySequence::Save,
                              m_requests.savePictureAs));
    m_needScene.push_back(
        add(menu, "file.copy-picture", QT_TR_NOOP("&Copy picture"), QKeySequence::Copy, m_requests.copyPicture));
    add(menu, "file.picture-names", QT_TR_NOOP("&Names of pictures…"), QKeySequence(), m_requests.namePictures);
    menu->addSeparator();
    m_needScene.push_back(add(menu, "session.save", QT_TR_NOOP("Save s&ession…"), key(Qt::CTRL | Qt::ALT | Qt::Key_S),
                              m_requests.saveSession));
    menu->addSeparator();
    add(menu, "file.quit", QT_TR_NOOP("&Quit"), key(Qt::CTRL | Qt::Key_Q), [this] { m_window.close(); });
    showRecent({});
}

void Actions::makeViewMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&View"));
    m_fit       = add(
              menu, "view.fit", QT_TR_NOOP("&Fit"), key(Qt::Key_F), [this] { m_view.fit(); }, "fit");
    add(menu, "view.one-to-one", QT_TR_NOOP("&1:1"), key(Qt::CTRL | Qt::Key_0), [this] { m_view.oneToOne(); });
    add(menu, "view.zoom-in", QT_TR_NOOP("Zoom &in"), {key(Qt::CTRL | Qt::Key_Plus), key(Qt::CTRL | Qt::Key_Equal)},
        [this] { m_view.zoomBy(kZoomStep); });
    add(menu, "view.zoom-out", QT_TR_NOOP("Zoom &out"), key(Qt::CTRL | Qt::Key_Minus),
        [this] { m_view.zoomBy(1 / kZoomStep); });
    menu->addSeparator();
    m_needScene.push_back(
        add(menu, "view.go-to-pixel", QT_TR_NOOP("&Go to pixel…"), key(Qt::CTRL | Qt::Key_G), m_requests.goToPixel));
    const auto nudge = [&](const char* name, const char* label, Qt::Key arrow, const QPoint& by) {
        m_inspectOnly.push_back(add(menu, name, label, key(Qt::CTRL | arrow), [this, by] {
            m_session.nudgePick(by);
            if (m_session.now().picked) m_view.reveal(*m_session.now().picked);
        }));
    };
    nudge("pick.left", QT_TR_NOOP("Pick the pixel to the left"), Qt::Key_Left, {-1, 0});
    nudge("pick.right", QT_TR_NOOP("Pick the pixel to the right"), Qt::Key_Right, {1, 0});
    nudge("pick.up", QT_TR_NOOP("Pick the pixel above"), Qt::Key_Up, {0, -1});
    nudge("pick.down", QT_TR_NOOP("Pick the pixel below"), Qt::Key_Down, {0, 1});
    add(menu, "view.stop", QT_TR_NOOP("&Stop work, or forget the pick"), key(Qt::Key_Escape), [this] {
        if (!m_session.isIdle()) return m_session.cancelWork();
        if (!m_session.examiner().isIdle()) return m_session.examiner().cancel();
        m_session.pick({});
        m_session.selectEdge({});
        m_session.selectNode({});
        m_session.selectTriangle({});
    });
    menu->addSeparator();
    makeLayersMenu(menu);
    makeSizeMenu(menu);
    menu->addSeparator();
    m_panels = addMenu(menu, QT_TR_NOOP("&Panels"));
    makeLayoutMenu(addMenu(menu, QT_TR_NOOP("La&yout")));
    makeAppearanceMenu(menu);
}

void Actions::makeLayersMenu(QMenu* view)
{
    m_layers    = addMenu(view, QT_TR_NOOP("&Layers"));
    auto* group = new QActionGroup(this);
    for (const Layer& layer : layers()) {
        QAction* action = addNamed(m_layers, "layer." + utf8Text(layer.word), QString(), {},
                                   [this, &layer] { m_session.setLayer(layer); });
        action->setCheckable(true);
        m_titles.emplace_back(action, layer.title);
        group->addAction(action);
        m_layerChoices.push_back(action);
    }
    m_layers->setToolTipsVisible(true);
    m_needScene.push_back(
        add(m_layers, "layer.fit-range", QT_TR_NOOP("Fit the range of depths"), key(Qt::Key_N), [this] {
            DepthRange range  = m_session.now().look.range;
            range.isAutomatic = true;
            m_session.setDepthRange(range);
        }));
    m_layers->addSeparator();
    const auto toggle = [this](const char* name, const char* label, bool Layers::*part) {
        QAction* action = add(m_layers, name, label, QKeySequence(), [this, part] {
            Layers layers = m_session.now().layers;
            layers.*part  = !(layers.*part);
            m_session.setLayers(layers);
        });
        action->setCheckable(true);
        m_layerToggles.emplace_back(action, part);
    };
    toggle("over.line", QT_TR_NOOP("Current line"), &Layers::line);
    toggle("over.edges", QT_TR_NOOP("Active edges"), &Layers::edges);
    toggle("over.ghost", QT_TR_NOOP("What is still to come, pale"), &Layers::ghost);
    toggle("over.triangle", QT_TR_NOOP("Triangle of the step"), &Layers::triangle);
    toggle("over.query", QT_TR_NOOP("Last question and update of the pyramid"), &Layers::query);
    toggle("over.boxes", QT_TR_NOOP("Boxes of the nodes, by verdict"), &Layers::boxes);
    toggle("over.pyramid", QT_TR_NOOP("Cells of the pyramid, with values"), &Layers::pyramid);
    toggle("over.grid", QT_TR_NOOP("Grid and numbers in large pixels"), &Layers::grid);
    toggle("over.marks", QT_TR_NOOP("Breakpoints"), &Layers::marks);
    toggle("over.magnifier", QT_TR_NOOP("Magnifier"), &Layers::magnifier);
}

void Actions::makeSizeMenu(QMenu* view)
{
    QMenu* sizes = addMenu(view, QT_TR_NOOP("Picture si&ze"));
    for (const QSize& size : kSizes)
        m_sizes.emplace_back(addNamed(sizes, QString("size.%1x%2").arg(size.width()).arg(size.height()), QString(), {},
                                      [this, size] { m_session.setPictureSize(size.width(), size.height()); }),
                             size);
    sizes->addSeparator();
    add(sizes, "size.view", QT_TR_NOOP("As large as the view"), QKeySequence(), [this] {
        const QSizeF size = QSizeF(m_view.size()) * m_view.devicePixelRatioF();
        m_session.setPictureSize(static_cast<int>(size.width()), static_cast<int>(size.height()));
    });
}

void Actions::makeLayoutMenu(QMenu* menu)
{
    auto* group = new QActionGroup(this);
    for (const LayoutEntry& layout : layoutEntries()) {
        QAction* action = addNamed(menu, QString("layout.") + layout.word, QString(), {},
                                   [this, word = QString(layout.word)] { m_requests.layout(word); });
        action->setCheckable(true);
        group->addAction(action);
        m_layoutChoices.push_back(action);
    }
    menu->addSeparator();
    m_ownLayouts = addMenu(menu, QT_TR_NOOP("&Own layouts"));
    add(menu, "layout.save", QT_TR_NOOP("&Save this layout…"), QKeySequence(), m_requests.saveOwnLayout);
    m_forgetLayouts = addMenu(menu, QT_TR_NOOP("&Forget a layout"));
    add(menu, "layout.reset", QT_TR_NOOP("&Reset layout"), QKeySequence(), m_requests.resetLayout);
}

void Actions::makeAppearanceMenu(QMenu* view)
{
    QMenu*     menu  = addMenu(view, QT_TR_NOOP("&Appearance"));
    auto*      group = new QActionGroup(this);
    const auto look  = [&](const char* name, const char* label, Appearance appearance) {
        QAction* action = add(menu, name, label, QKeySequence(), [this, appearance] { m_requests.look(appearance); });
        action->setCheckable(true);
        group->addAction(action);
        m_appearances.push_back(action);
    };
    look("appearance.system", QT_TR_NOOP("As the system"), Appearance::System);
    look("appearance.light", QT_TR_NOOP("Light"), Appearance::Light);
    look("appearance.dark", QT_TR_NOOP("Dark"), Appearance::Dark);
}

void Actions::makeLanguageMenu()
{
    // Each language in its own words, so that whoever chose the wrong one finds back.
    QMenu*     menu   = m_window.menuBar()->addMenu(QStringLiteral("&Language / \u8BED\u8A00"));
    auto*      group  = new QActionGroup(this);
    const auto choice = [&](const char* name, const QString& label, Language language) {
        QAction* action = addNamed(menu, name, label, {}, [this, language] { m_requests.speak(language); });
        action->setCheckable(true);
        group->addAction(action);
        m_languages.push_back(action);
        return action;
    };
    m_labels.emplace_back(choice("language.system", QString(), Language::System), QT_TR_NOOP("As the system"));
    choice("language.english", QStringLiteral("English"), Language::English);
    choice("language.chinese", QStringLiteral("\u7B80\u4F53\u4E2D\u6587"), Language::Chinese);
}

void Actions::makeCameraMenu()
{
    QMenu* menu  = addMenu(nullptr, QT_TR_NOOP("&Camera"));
    auto*  tools = new QActionGroup(this);
    m_inspect    = add(
           menu, "tool.inspect", QT_TR_NOOP("&Inspect"), key(Qt::Key_I), [this] { m_view.setTool(Tool::Inspect); },
           "inspect");
    m_camera = add(
        menu, "tool.camera", QT_TR_NOOP("&Camera"), key(Qt::Key_C),
        [this] {
            m_view.setTool(Tool::Camera);
            m_view.setFocus();
        },
        "camera");
    m_tips.emplace_back(
        m_inspect,
        QT_TR_NOOP("Inspect (I): the wheel zooms, dragging pans, a click picks a pixel, Right and Left step"));
    m_tips.emplace_back(
        m_camera, QT_TR_NOOP("Camera (C, or while Alt is held): left drag orbits, middle drag pans, the wheel dollies, "
                             "the arrow keys turn the model, WASD flies"));
    for (QAction* tool : {m_inspect, m_camera}) {
        tool->setCheckable(true);
        tools->addAction(tool);
    }
    menu->addSeparator();
    const auto axis = [&](const char* name, const char* label, Qt::Key digit, AxisView view) {
        m_needScene.push_back(add(menu, name, label, key(Qt::KeypadModifier | digit), [this, view] {
            m_session.moveCamera([view](CameraControl& camera) { camera.lookAlong(view); });
        }));
    };
    axis("camera.front", QT_TR_NOOP("From the &front"), Qt::Key_1, AxisView::Front);
    axis("camera.right", QT_TR_NOOP("From the &right"), Qt::Key_3, AxisView::Right);
    axis("camera.above", QT_TR_NOOP("From &above"), Qt::Key_7, AxisView::Top);
    m_needScene.push_back(add(menu, "camera.reset", QT_TR_NOOP("R&eset"),
                              {key(Qt::Key_Return), key(Qt::KeypadModifier | Qt::Key_Enter)},
                              [this] { m_session.resetCamera(); }));
    m_namedViews = addMenu(menu, QT_TR_NOOP("Views of the &scene"));
    menu->addSeparator();
    const auto turn = [&](const char* name, const char* label, QKeySequence keys, YzyAngles by) {
        m_cameraOnly.push_back(add(menu, name, label, keys, [this, by] {
            m_session.moveCamera([by](CameraControl& camera) {
                const YzyAngles at = camera.angles();
                camera.setAngles({at.first + by.first, at.second + by.second, at.third + by.third});
            });
        }));
    };
    turn("camera.turn-first-less", QT_TR_NOOP("Turn: first angle, less"), key(Qt::Key_Left), {-kTurnStep, 0, 0});
    turn("camera.turn-first-more", QT_TR_NOOP("Turn: first angle, more"), key(Qt::Key_Right), {kTurnStep, 0, 0});
    turn("camera.turn-second-less", QT_TR_NOOP("Turn: second angle, less"), key(Qt::Key_Down), {0, -kTurnStep, 0});
    turn("camera.turn-second-more", QT_TR_NOOP("Turn: second angle, more"), key(Qt::Key_Up), {0, kTurnStep, 0});
    turn("camera.turn-third-less", QT_TR_NOOP("Turn: third angle, less"), key(Qt::SHIFT | Qt::Key_Left),
         {0, 0, -kTurnStep});
    turn("camera.turn-third-more", QT_TR_NOOP("Turn: third angle, more"), key(Qt::SHIFT | Qt::Key_Right),
         {0, 0, kTurnStep});
    m_needScene.push_back(add(menu, "camera.normalise", QT_TR_NOOP("&Normalise the model"), QKeySequence(),
                              [this] { m_session.normaliseModel(); }));
}

void Actions::makeAlgorithmMenu()
{
    QMenu* menu  = addMenu(nullptr, QT_TR_NOOP("&Algorithm"));
    auto*  group = new QActionGroup(this);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset&       preset = presets()[i];
        QList<QKeySequence> keys;
        if (i < 9) keys << digit(static_cast<int>(i), {});
        QAction* action = addNamed(menu, "algorithm.a." + utf8Text(preset.name), utf8Text(preset.name), keys,
                                   [this, &preset] { m_session.setPipeline(preset.pipeline); });
        action->setCheckable(true);
        m_titles.emplace_back(action, preset.title);
        group->addAction(action);
        m_algorithms.push_back(action);
    }
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    m_cull = add(menu, "algorithm.cull-back-faces", QT_TR_NOOP("Leave out &back faces"), QKeySequence(),
                 [this] { m_session.setFaceCulling(m_cull->isChecked() ? FaceCulling::Back : FaceCulling::None); });
    m_cull->setCheckable(true);
    m_cull->setChecked(m_session.settings().faceCulling == FaceCulling::Back);
}

void Actions::makeStepMenu()
{
    QMenu*     menu = addMenu(nullptr, QT_TR_NOOP("&Step"));
    const auto step = [&](const char* name, const char* label, const QKeySequence& keys, std::function<void()> run) {
        QAction* action = add(menu, name, label, keys, std::move(run));
        m_needScene.push_back(action);
        return action;
    };
    step("step.play", QT_TR_NOOP("&Play or pause"), key(Qt::Key_Space),
         [this] { m_session.player().setPlaying(!m_session.player().isPlaying()); });
    m_inspectOnly.push_back(
        step("step.forward", QT_TR_NOOP("&Forward"), key(Qt::Key_Right), [this] { m_session.stepBy(1); }));
    m_inspectOnly.push_back(
        step("step.back", QT_TR_NOOP("&Back"), key(Qt::Key_Left), [this] { m_session.stepBy(-1); }));
    m_inspectOnly.push_back(step("step.forward-coarser", QT_TR_NOOP("Forward by the coarser grain"),
                                 key(Qt::SHIFT | Qt::Key_Right), [this] { m_session.stepCoarser(1); }));
    m_inspectOnly.push_back(step("step.back-coarser", QT_TR_NOOP("Back by the coarser grain"),
                                 key(Qt::SHIFT | Qt::Key_Left), [this] { m_session.stepCoarser(-1); }));
    menu->addSeparator();
    step("step.first", QT_TR_NOOP("F&irst step"), key(Qt::Key_Home), [this] { m_session.goToStart(); });
    step("step.last", QT_TR_NOOP("&Last step"), key(Qt::Key_End), [this] { m_session.goToEnd(); });
    menu->addSeparator();
    step("bookmark.toggle", QT_TR_NOOP("Book&mark this step"), key(Qt::CTRL | Qt::Key_B),
         [this] { m_session.toggleBookmark(); });
    step("bookmark.next", QT_TR_NOOP("&Next bookmark"), key(Qt::CTRL | Qt::Key_PageDown),
         [this] { m_session.goToNextBookmark(Direction::Forward); });
    step("bookmark.previous", QT_TR_NOOP("Pre&vious bookmark"), key(Qt::CTRL | Qt::Key_PageUp),
         [this] { m_session.goToNextBookmark(Direction::Back); });
    menu->addSeparator();
    step("breakpoint.run-forward", QT_TR_NOOP("&Run to the next breakpoint"), key(Qt::Key_F5),
         [this] { m_session.runTo(Direction::Forward); });
    step("breakpoint.run-back", QT_TR_NOOP("Run b&ack to a breakpoint"), key(Qt::SHIFT | Qt::Key_F5),
         [this] { m_session.runTo(Direction::Back); });
    step("breakpoint.toggle", QT_TR_NOOP("Brea&kpoint on what is picked or selected"), key(Qt::Key_F9), [this] {
        if (const auto at = breakpointHere(m_session.now())) m_session.toggleBreakpoint(*at);
    });
    makeBreakpointMenu(addMenu(menu, QT_TR_NOOP("Breakpoint &on")));
    step("breakpoint.clear", QT_TR_NOOP("Remove all breakpoints"), key(Qt::CTRL | Qt::SHIFT | Qt::Key_F9), [this] {
        Marks marks = m_session.now().marks;
        marks.breakpoints.clear();
        m_session.setMarks(marks);
    });
    menu->addSeparator();
    const auto change = [&](const char* name, const char* label, const QKeySequence& keys, Session::PixelJump jump) {
        step(name, label, keys, [this, jump] { m_session.goToPixelChange(jump); });
    };
    change("pixel.first-change", QT_TR_NOOP("First step that &changes the picked pixel"), key(Qt::CTRL | Qt::Key_Home),
           Session::PixelJump::First);
    change("pixel.next-change", QT_TR_NOOP("Next step that changes it"), key(Qt::CTRL | Qt::SHIFT | Qt::Key_Right),
           Session::PixelJump::Next);
    change("pixel.previous-change", QT_TR_NOOP("Previous step that changes it"),
           key(Qt::CTRL | Qt::SHIFT | Qt::Key_Left), Session::PixelJump::Previous);
}

void Actions::makeBreakpointMenu(QMenu* menu)
{
    const auto on = [&](const char* name, const char* label, Breakpoint::On what) {
        m_needScene.push_back(add(menu, name, label, QKeySequence(), [this, what] {
            if (const auto at = breakpointHere(m_session.now(), what)) m_session.toggleBreakpoint(*at);
        }));
    };
    on("breakpoint.line", QT_TR_NOOP("The line of the picked pixel, or of the step"), Breakpoint::On::Line);
    on("breakpoint.pixel", QT_TR_NOOP("The picked pixel"), Breakpoint::On::Pixel);
    on("breakpoint.node", QT_TR_NOOP("The selected node"), Breakpoint::On::Node);
    on("breakpoint.triangle", QT_TR_NOOP("The selected triangle, or that of the picked pixel"),
       Breakpoint::On::Triangle);
}

void Actions::makeCompareMenu()
{
    QMenu* menu  = addMenu(nullptr, QT_TR_NOOP("C&ompare"));
    QMenu* other = addMenu(menu, QT_TR_NOOP("&B"));
    auto*  group = new QActionGroup(this);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset&       preset = presets()[i];
        QList<QKeySequence> keys;
        if (i < 9) keys << digit(static_cast<int>(i), Qt::ShiftModifier);
        QAction* action = addNamed(other, "algorithm.b." + utf8Text(preset.name), QString(), keys,
                                   [this, &preset] { m_session.compareWith(preset.pipeline); });
        action->setCheckable(true);
        m_titles.emplace_back(action, preset.title);
        group->addAction(action);
        m_others.push_back(action);
    }
    for (QMenu* each : {menu, other}) each->setToolTipsVisible(true);
    m_needScene.push_back(add(menu, "compare.keep", QT_TR_NOOP("&Keep A as B"), QKeySequence(),
                              [this] { m_session.compareWith(m_session.now().pipeline); }));
    menu->addSeparator();
    const auto show = [&](const char* name, const char* label, Qt::Key k, CompareShow what) {
        QAction* action = add(menu, name, label, key(k), [this, what] {
            const bool isOn = m_session.now().compare.show == what;
            m_session.showCompared(isOn ? CompareShow::A : what);
        });
        m_needOther.push_back(action);
        m_inspectOnly.push_back(action);  // the camera flies with W and D
    };
    show("compare.to-and-fro", QT_TR_NOOP("&To and fro between A and B"), Qt::Key_T, CompareShow::B);
    show("compare.wipe", QT_TR_NOOP("&Wipe"), Qt::Key_W, CompareShow::Wipe);
    show("compare.difference", QT_TR_NOOP("&Difference"), Qt::Key_D, CompareShow::Difference);
    show("compare.side-by-side", QT_TR_NOOP("Side &by side"), Qt::Key_B, CompareShow::Beside);
    m_swap =
        add(menu, "compare.swap", QT_TR_NOOP("&Swap A and B"), QKeySequence(), [this] { m_session.swapCompared(); });
    m_judgeAgain = add(menu, "compare.judge-again", QT_TR_NOOP("&Judge my picture again"), key(Qt::Key_F7),
                       [this] { m_session.examiner().judgeAgain(); });
    m_saveReport = add(menu, "compare.save-report", QT_TR_NOOP("Save the &report on my picture…"), QKeySequence(),
                       [this] { m_session.examiner().chooseReport(); });
    menu->addSeparator();
    m_needScene.push_back(add(menu, "compare.sheet", QT_TR_NOOP("Save a comparison s&heet…"),
                              key(Qt::CTRL | Qt::SHIFT | Qt::Key_S), m_requests.saveSheet));
    menu->addSeparator();
    m_needOther.push_back(add(menu, "compare.end", QT_TR_NOOP("&End the comparison"), QKeySequence(),
                              [this] { m_session.compareWith({}); }));
}

void Actions::makeMeasureMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&Measure"));
    m_measure   = add(menu, "measure.start", QT_TR_NOOP("&Start measuring"), key(Qt::Key_F8), m_requests.measure);
    m_stopMeasuring =
        add(menu, "measure.stop", QT_TR_NOOP("S&top measuring"), key(Qt::SHIFT | Qt::Key_F8), m_requests.stopMeasuring);
    add(menu, "measure.open", QT_TR_NOOP("&Open a record…"), QKeySequence(), m_requests.openRecord);
    menu->addSeparator();
    m_needScene.push_back(add(menu, "path.add", QT_TR_NOOP("Add a &key frame to the camera path"),
                              key(Qt::CTRL | Qt::Key_K), m_requests.addKeyFrame));
    m_needScene.push_back(add(menu, "path.add-cut", QT_TR_NOOP("Add a key frame after a &cut"),
                              key(Qt::CTRL | Qt::SHIFT | Qt::Key_K), m_requests.addKeyFrameAfterCut));
    m_needScene.push_back(
        add(menu, "path.save", QT_TR_NOOP("&Save the camera path…"), QKeySequence(), m_requests.savePath));
    m_needScene.push_back(
        add(menu, "path.forget", QT_TR_NOOP("&Forget the camera path"), QKeySequence(), m_requests.forgetPath));
}

void Actions::makeLessonsMenu()
{
    QMenu*  menu   = addMenu(nullptr, QT_TR_NOOP("&Lessons"));
    Course& course = m_session.course();
    add(menu, "lessons.list", QT_TR_NOOP("&List of lessons"), key(Qt::CTRL | Qt::Key_L),
        [&course] { course.showList(); });
    add(menu, "lessons.next", QT_TR_NOOP("&Next page"), key(Qt::CTRL | Qt::SHIFT | Qt::Key_PageDown),
        [&course] { course.next(); });
    add(menu, "lessons.previous", QT_TR_NOOP("&Previous page"), key(Qt::CTRL | Qt::SHIFT | Qt::Key_PageUp),
        [&course] { course.back(); });
    add(menu, "lessons.show", QT_TR_NOOP("&Show this page's step again"), key(Qt::CTRL | Qt::Key_Backspace),
        [&course] { course.show(); });
    menu->addSeparator();
    add(menu, "lessons.open", QT_TR_NOOP("&Open a folder of lessons…"), QKeySequence(), m_requests.openLessons);
    add(menu, "lessons.reload", QT_TR_NOOP("&Reload lessons"), key(Qt::CTRL | Qt::SHIFT | Qt::Key_R),
        [&course] { course.reload(); });
}

void Actions::makeHelpMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&Help"));
    add(menu, "help.commands", QT_TR_NOOP("&Commands…"), key(Qt::CTRL | Qt::SHIFT | Qt::Key_P), m_requests.palette);
    add(menu, "help.keys", QT_TR_NOOP("&Keys and mouse"), {key(Qt::Key_F1), key(Qt::Key_Question)}, m_requests.keys);
    add(menu, "help.change-keys", QT_TR_NOOP("C&hange keys…"), QKeySequence(), m_requests.changeKeys);
    add(menu, "help.about", QT_TR_NOOP("&About ZScope"), QKeySequence(), m_requests.about);
}

void Actions::makeToolBar()
{
    m_toolBar = m_window.addToolBar(QString());
    m_toolBar->setObjectName("tools");
    m_toolBar->setMovable(false);
    m_toolBar->setFloatable(false);
    m_toolBar->toggleViewAction()->setVisible(false);
    m_toolBar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_toolBar->setIconSize({16, 16});

    m_algorithmBox = new ChoiceBox;
    m_algorithmBox->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_algorithmBox->setMinimumContentsLength(12);
    for (const Preset& preset : presets()) m_algorithmBox->addItem(utf8Text(preset.name));
    connect(m_algorithmBox, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(presets().size()))
            m_session.setPipeline(presets()[static_cast<std::size_t>(index)].pipeline);
    });

    const auto spacer = [this] {
        auto* space = new QWidget;
        space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        space->setMinimumHeight(38);  // of a button, and the step below the bar that the style sheet leaves
        m_toolBar->addWidget(space);
    };
    m_toolBar->addAction(m_open);
    m_toolBar->addWidget(m_algorithmBox);
    m_toolBar->addSeparator();
    m_toolBar->addAction(m_inspect);
    m_toolBar->addAction(m_camera);
    spacer();
    m_layersButton = new QToolButton;
    m_layersButton->setMenu(m_layers);
    m_layersButton->setPopupMode(QToolButton::InstantPopup);
    m_layersButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_layersButton->setFocusPolicy(Qt::TabFocus);
    m_icons.emplace_back(m_layers->menuAction(), "layers");
    m_toolBar->addWidget(m_layersButton);
    m_toolBar->addAction(m_fit);
    m_toolBar->addSeparator();
    for (QAction* layout : m_layoutChoices) m_toolBar->addAction(layout);
    for (auto* button : m_toolBar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
}

}  // namespace zscope::ui
