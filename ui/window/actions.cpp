// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/actions.h"

#include <algorithm>

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>

#include "ui/theme/icons.h"

namespace zscope::ui {
namespace {

constexpr double kTurnStep = 5;   // degrees per arrow key
constexpr double kZoomStep = 1.25;

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size())); }

/// Titles in the registries of core are English; a translation may know them in the context "Registry".
QString translated(std::string_view title) { return QCoreApplication::translate("Registry", std::string(title).c_str()); }

QKeySequence key(int k) { return QKeySequence(k); }

}  // namespace

Actions::Actions(QMainWindow& window, Session& session, FrameView& view, WindowRequests requests)
    : QObject(&window), m_window(window), m_session(session), m_view(view), m_requests(std::move(requests))
{
    makeFileMenu();
    makeViewMenu();
    makeCameraMenu();
    makeAlgorithmMenu();
    makeStepMenu();
    makeCompareMenu();
    makeHelpMenu();
    makeToolBar();
    showTool(m_view.tool());
}

QAction* Actions::add(QMenu* menu, const QString& label, const QList<QKeySequence>& keys, std::function<void()> run,
                      const QString& icon)
{
    auto* action = new QAction(label, this);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    menu->addAction(action);
    m_window.addAction(action);  // the key works whatever has the focus
    m_all.push_back(action);
    if (!icon.isEmpty()) m_icons.emplace_back(action, icon);
    return action;
}

void Actions::makeFileMenu()
{
    QMenu* menu = m_window.menuBar()->addMenu(tr("&File"));
    m_open      = add(menu, tr("&Open…"), QKeySequence::Open, m_requests.open, "open");
    m_recent    = menu->addMenu(tr("Open &recent"));
    QMenu* examples = menu->addMenu(tr("&Examples"));
    QMenu* hard     = nullptr;
    for (const SceneEntry& scene : builtinScenes()) {
        const QString name  = text(scene.name);
        QMenu*        under = examples;
        if (name.startsWith("hard/")) {
            if (!hard) hard = examples->addMenu(tr("Hard cases"));
            under = hard;
        }
        QAction* action = under->addAction(QString(name).replace('&', "&&"), this, [this, name] { m_requests.openWord("builtin:" + name); });
        action->setToolTip(translated(scene.title));
        under->setToolTipsVisible(true);
    }
    m_needScene.push_back(add(menu, tr("Re&load"), key(Qt::CTRL | Qt::Key_R), [this] { m_session.reload(); }));
    menu->addSeparator();
    m_needScene.push_back(add(menu, tr("&Save picture"), key(Qt::Key_F12), m_requests.savePicture));
    m_needScene.push_back(
        add(menu, tr("Save picture &without decoration"), key(Qt::CTRL | Qt::Key_F12), m_requests.savePlainPicture));
    m_needScene.push_back(add(menu, tr("Save picture &as…"), QKeySequence::Save, m_requests.savePictureAs));
    m_needScene.push_back(add(menu, tr("&Copy picture"), QKeySequence::Copy, m_requests.copyPicture));
    menu->addSeparator();
    add(menu, tr("&Quit"), key(Qt::CTRL | Qt::Key_Q), [this] { m_window.close(); });
    showRecent({});
}

void Actions::makeViewMenu()
{
    QMenu* menu = m_window.menuBar()->addMenu(tr("&View"));
    m_fit       = add(menu, tr("&Fit"), key(Qt::Key_F), [this] { m_view.fit(); }, "fit");
    add(menu, tr("&1:1"), key(Qt::CTRL | Qt::Key_0), [this] { m_view.oneToOne(); });
    add(menu, tr("Zoom &in"), {key(Qt::CTRL | Qt::Key_Plus), key(Qt::CTRL | Qt::Key_Equal)}, [this] { m_view.zoomBy(kZoomStep); });
    add(menu, tr("Zoom &out"), key(Qt::CTRL | Qt::Key_Minus), [this] { m_view.zoomBy(1 / kZoomStep); });
    menu->addSeparator();
    m_needScene.push_back(add(menu, tr("&Go to pixel…"), key(Qt::CTRL | Qt::Key_G), m_requests.goToPixel));
    const auto nudge = [&](const QString& label, Qt::Key arrow, const QPoint& by) {
        m_inspectOnly.push_back(add(menu, label, key(Qt::CTRL | arrow), [this, by] {
            m_session.nudgePick(by);
            if (m_session.now().picked) m_view.reveal(*m_session.now().picked);
        }));
    };
    nudge(tr("Pick the pixel to the left"), Qt::Key_Left, {-1, 0});
    nudge(tr("Pick the pixel to the right"), Qt::Key_Right, {1, 0});
    nudge(tr("Pick the pixel above"), Qt::Key_Up, {0, -1});
    nudge(tr("Pick the pixel below"), Qt::Key_Down, {0, 1});
    add(menu, tr("&Stop work, or forget the pick"), key(Qt::Key_Escape), [this] {
        if (!m_session.isIdle()) return m_session.cancelWork();
        m_session.pick({});
        m_session.selectEdge({});
        m_session.selectNode({});
        m_session.selectTriangle({});
    });
    menu->addSeparator();
    makeLayersMenu(menu);
    makeSizeMenu(menu);
    menu->addSeparator();
    m_panels = menu->addMenu(tr("&Panels"));
    add(menu, tr("&Reset layout"), QKeySequence(), m_requests.resetLayout);
    makeAppearanceMenu(menu);
}

void Actions::makeLayersMenu(QMenu* view)
{
    m_layers    = view->addMenu(tr("&Layers"));
    auto* group = new QActionGroup(this);
    for (const Layer& layer : layers()) {
        QAction* action = add(m_layers, text(layer.word), QKeySequence(), [this, &layer] { m_session.setLayer(layer); });
        action->setCheckable(true);
        action->setToolTip(translated(layer.title));
        group->addAction(action);
        m_layerChoices.push_back(action);
    }
    m_layers->setToolTipsVisible(true);
    m_needScene.push_back(add(m_layers, tr("Fit the range of depths"), key(Qt::Key_N), [this] {
        DepthRange range  = m_session.now().look.range;
        range.isAutomatic = true;
        m_session.setDepthRange(range);
    }));
    m_layers->addSeparator();
    const auto toggle = [this](const QString& label, bool Layers::* part) {
        QAction* action = m_layers->addAction(label);
        action->setCheckable(true);
        m_layerToggles.emplace_back(action, part);
        connect(action, &QAction::triggered, this, [this, part](bool on) {
            Layers layers = m_session.now().layers;
            layers.*part  = on;
            m_session.setLayers(layers);
        });
    };
    toggle(tr("Current line"), &Layers::line);
    toggle(tr("Active edges"), &Layers::edges);
    toggle(tr("What is still to come, pale"), &Layers::ghost);
    toggle(tr("Triangle of the step"), &Layers::triangle);
    toggle(tr("Last question and update of the pyramid"), &Layers::query);
    toggle(tr("Boxes of the nodes, by verdict"), &Layers::boxes);
    toggle(tr("Cells of the pyramid, with values"), &Layers::pyramid);
    toggle(tr("Grid and numbers in large pixels"), &Layers::grid);
    toggle(tr("Magnifier"), &Layers::magnifier);
}

void Actions::makeSizeMenu(QMenu* view)
{
    QMenu* sizes = view->addMenu(tr("Picture si&ze"));
    for (const QSize size : {QSize(160, 90), QSize(640, 360), QSize(1280, 720), QSize(1600, 900), QSize(1920, 1080), QSize(3840, 2160)})
        sizes->addAction(tr("%1 × %2").arg(size.width()).arg(size.height()), this,
                         [this, size] { m_session.setPictureSize(size.width(), size.height()); });
    sizes->addSeparator();
    sizes->addAction(tr("As large as the view"), this, [this] {
        const QSizeF size = QSizeF(m_view.size()) * m_view.devicePixelRatioF();
        m_session.setPictureSize(static_cast<int>(size.width()), static_cast<int>(size.height()));
    });
}

void Actions::makeAppearanceMenu(QMenu* view)
{
    QMenu* menu  = view->addMenu(tr("&Appearance"));
    auto*  group = new QActionGroup(this);
    const std::pair<QString, Appearance> looks[] = {
        {tr("As the system"), Appearance::System}, {tr("Light"), Appearance::Light}, {tr("Dark"), Appearance::Dark}};
    for (const auto& [label, look] : looks) {
        QAction* action = menu->addAction(label, this, [this, look = look] { m_requests.look(look); });
        action->setCheckable(true);
        group->addAction(action);
        m_appearances.push_back(action);
    }
}

void Actions::makeCameraMenu()
{
    QMenu* menu  = m_window.menuBar()->addMenu(tr("&Camera"));
    auto*  tools = new QActionGroup(this);
    m_inspect    = add(menu, tr("&Inspect"), key(Qt::Key_I), [this] { m_view.setTool(Tool::Inspect); }, "inspect");
    m_camera     = add(menu, tr("&Camera"), key(Qt::Key_C), [this] {
        m_view.setTool(Tool::Camera);
        m_view.setFocus();
    }, "camera");
    m_inspect->setToolTip(tr("Inspect (I): the wheel zooms, dragging pans, a click picks a pixel, Right and Left step"));
    m_camera->setToolTip(tr("Camera (C, or while Alt is held): left drag orbits, middle drag pans, the wheel dollies, the "
                            "arrow keys turn the model, WASD flies"));
    for (QAction* tool : {m_inspect, m_camera}) {
        tool->setCheckable(true);
        tools->addAction(tool);
    }
    menu->addSeparator();
    const auto axis = [&](const QString& label, Qt::Key digit, AxisView view) {
        m_needScene.push_back(add(menu, label, key(Qt::KeypadModifier | digit), [this, view] {
            m_session.moveCamera([view](CameraControl& camera) { camera.lookAlong(view); });
        }));
    };
    axis(tr("From the &front"), Qt::Key_1, AxisView::Front);
    axis(tr("From the &right"), Qt::Key_3, AxisView::Right);
    axis(tr("From &above"), Qt::Key_7, AxisView::Top);
    m_needScene.push_back(add(menu, tr("R&eset"), {key(Qt::Key_Return), key(Qt::KeypadModifier | Qt::Key_Enter)},
                              [this] { m_session.resetCamera(); }));
    m_namedViews = menu->addMenu(tr("Views of the &scene"));
    menu->addSeparator();
    const auto turn = [&](const QString& label, QKeySequence keys, YzyAngles by) {
        m_cameraOnly.push_back(add(menu, label, keys, [this, by] {
            m_session.moveCamera([by](CameraControl& camera) {
                const YzyAngles at = camera.angles();
                camera.setAngles({at.first + by.first, at.second + by.second, at.third + by.third});
            });
        }));
    };
    turn(tr("Turn: first angle, less"), key(Qt::Key_Left), {-kTurnStep, 0, 0});
    turn(tr("Turn: first angle, more"), key(Qt::Key_Right), {kTurnStep, 0, 0});
    turn(tr("Turn: second angle, less"), key(Qt::Key_Down), {0, -kTurnStep, 0});
    turn(tr("Turn: second angle, more"), key(Qt::Key_Up), {0, kTurnStep, 0});
    turn(tr("Turn: third angle, less"), key(Qt::SHIFT | Qt::Key_Left), {0, 0, -kTurnStep});
    turn(tr("Turn: third angle, more"), key(Qt::SHIFT | Qt::Key_Right), {0, 0, kTurnStep});
    m_needScene.push_back(add(menu, tr("&Normalise the model"), QKeySequence(), [this] { m_session.normaliseModel(); }));
}

void Actions::makeAlgorithmMenu()
{
    QMenu* menu  = m_window.menuBar()->addMenu(tr("&Algorithm"));
    auto*  group = new QActionGroup(this);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset& preset = presets()[i];
        QList<QKeySequence> keys;
        if (i < 9) keys << key(static_cast<int>(Qt::Key_1) + static_cast<int>(i));
        QAction* action = add(menu, text(preset.name), keys, [this, &preset] { m_session.setPipeline(preset.pipeline); });
        action->setCheckable(true);
        action->setToolTip(translated(preset.title));
        group->addAction(action);
        m_algorithms.push_back(action);
    }
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    m_cull = add(menu, tr("Leave out &back faces"), QKeySequence(), [this] {
        m_session.setFaceCulling(m_cull->isChecked() ? FaceCulling::Back : FaceCulling::None);
    });
    m_cull->setCheckable(true);
    m_cull->setChecked(m_session.settings().faceCulling == FaceCulling::Back);
}

void Actions::makeStepMenu()
{
    QMenu*     menu = m_window.menuBar()->addMenu(tr("&Step"));
    const auto step = [&](const QString& label, const QKeySequence& keys, std::function<void()> run) {
        QAction* action = add(menu, label, keys, std::move(run));
        m_needScene.push_back(action);
        return action;
    };
    step(tr("&Play or pause"), key(Qt::Key_Space), [this] { m_session.player().setPlaying(!m_session.player().isPlaying()); });
    m_inspectOnly.push_back(step(tr("&Forward"), key(Qt::Key_Right), [this] { m_session.stepBy(1); }));
    m_inspectOnly.push_back(step(tr("&Back"), key(Qt::Key_Left), [this] { m_session.stepBy(-1); }));
    m_inspectOnly.push_back(step(tr("Forward by the coarser grain"), key(Qt::SHIFT | Qt::Key_Right), [this] { m_session.stepCoarser(1); }));
    m_inspectOnly.push_back(step(tr("Back by the coarser grain"), key(Qt::SHIFT | Qt::Key_Left), [this] { m_session.stepCoarser(-1); }));
    step(tr("F&irst step"), key(Qt::Key_Home), [this] { m_session.goToStart(); });
    step(tr("&Last step"), key(Qt::Key_End), [this] { m_session.goToEnd(); });
}

void Actions::makeCompareMenu()
{
    QMenu* menu  = m_window.menuBar()->addMenu(tr("C&ompare"));
    QMenu* other = menu->addMenu(tr("&B"));
    auto*  group = new QActionGroup(this);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset& preset = presets()[i];
        QList<QKeySequence> keys;
        if (i < 9) keys << key(static_cast<int>(Qt::SHIFT | Qt::Key_1) + static_cast<int>(i));
        QAction* action = add(other, tr("B: %1").arg(text(preset.name)), keys, [this, &preset] { m_session.compareWith(preset.pipeline); });
        action->setCheckable(true);
        action->setToolTip(translated(preset.title));
        group->addAction(action);
        m_others.push_back(action);
    }
    other->setToolTipsVisible(true);
    m_needScene.push_back(add(menu, tr("&Keep A as B"), QKeySequence(), [this] { m_session.compareWith(m_session.now().pipeline); }));
    menu->addSeparator();
    const auto show = [&](const QString& label, Qt::Key k, CompareShow what) {
        QAction* action = add(menu, label, key(k), [this, what] {
            const bool isOn = m_session.now().compare.show == what;
            m_session.showCompared(isOn ? CompareShow::A : what);
        });
        m_needOther.push_back(action);
        m_inspectOnly.push_back(action);  // the camera flies with W and D
    };
    show(tr("&To and fro between A and B"), Qt::Key_T, CompareShow::B);
    show(tr("&Wipe"), Qt::Key_W, CompareShow::Wipe);
    show(tr("&Difference"), Qt::Key_D, CompareShow::Difference);
    m_needOther.push_back(add(menu, tr("&Swap A and B"), QKeySequence(), [this] { m_session.swapCompared(); }));
    menu->addSeparator();
    m_needOther.push_back(add(menu, tr("&End the comparison"), QKeySequence(), [this] { m_session.compareWith({}); }));
}

void Actions::makeHelpMenu()
{
    QMenu* menu = m_window.menuBar()->addMenu(tr("&Help"));
    add(menu, tr("&Keys and mouse"), {key(Qt::Key_F1), key(Qt::Key_Question)}, m_requests.keys);
    add(menu, tr("&About ZScope"), QKeySequence(), m_requests.about);
}

void Actions::makeToolBar()
{
    m_toolBar = m_window.addToolBar(tr("Tools"));
    m_toolBar->setObjectName("tools");
    m_toolBar->setMovable(false);
    m_toolBar->setFloatable(false);
    m_toolBar->toggleViewAction()->setVisible(false);
    m_toolBar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_toolBar->setIconSize({16, 16});
    m_toolBar->setMinimumHeight(54);  // with the step below it that the style sheet leaves

    m_algorithmBox = new QComboBox;
    m_algorithmBox->setAccessibleName(tr("Algorithm"));
    m_algorithmBox->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (const Preset& preset : presets()) {
        m_algorithmBox->addItem(text(preset.name));
        m_algorithmBox->setItemData(m_algorithmBox->count() - 1, translated(preset.title), Qt::ToolTipRole);
    }
    connect(m_algorithmBox, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(presets().size())) m_session.setPipeline(presets()[static_cast<std::size_t>(index)].pipeline);
    });

    const auto spacer = [this] {
        auto* space = new QWidget;
        space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        m_toolBar->addWidget(space);
    };
    m_toolBar->addAction(m_open);
    m_toolBar->addWidget(m_algorithmBox);
    m_toolBar->addSeparator();
    m_toolBar->addAction(m_inspect);
    m_toolBar->addAction(m_camera);
    spacer();
    auto* layers = new QToolButton;
    layers->setText(tr("Layers"));
    layers->setMenu(m_layers);
    layers->setPopupMode(QToolButton::InstantPopup);
    layers->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    layers->setFocusPolicy(Qt::TabFocus);
    m_icons.emplace_back(m_layers->menuAction(), "layers");
    layers->setObjectName("layersButton");
    m_toolBar->addWidget(layers);
    m_toolBar->addAction(m_fit);
    for (auto* button : m_toolBar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
}

void Actions::dress(const Theme& theme)
{
    for (const auto& [action, name] : m_icons) {
        QIcon      icon    = iconOf(name, theme.text);
        const auto checked = iconOf(name, theme.buttonText);
        for (const QSize& size : checked.availableSizes()) icon.addPixmap(checked.pixmap(size), QIcon::Normal, QIcon::On);
        action->setIcon(icon);
    }
    if (auto* layers = m_toolBar->findChild<QToolButton*>("layersButton")) layers->setIcon(iconOf("layers", theme.text));
}

void Actions::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Pipeline) {
        const QSignalBlocker quiet(m_algorithmBox);
        int chosen = -1;
        for (std::size_t i = 0; i < presets().size(); ++i) {
            const bool isChosen = presets()[i].pipeline == shown.pipeline;
            m_algorithms[i]->setChecked(isChosen);
            if (isChosen) chosen = static_cast<int>(i);
        }
        m_algorithmBox->setCurrentIndex(chosen);
        for (std::size_t i = 0; i < layers().size(); ++i) m_layerChoices[i]->setChecked(&layers()[i] == shown.look.layer);
        m_cull->setChecked(m_session.settings().faceCulling == FaceCulling::Back);
    }
    if (what & Change::Compare) {
        for (std::size_t i = 0; i < presets().size(); ++i) m_others[i]->setChecked(shown.compare.other == presets()[i].pipeline);
        showTool(m_view.tool());
    }
    if (what & Change::Layers)
        for (const auto& [action, part] : m_layerToggles) action->setChecked(shown.layers.*part);
    if (what & Change::Scene) {
        for (QAction* action : m_needScene) action->setEnabled(shown.scene != nullptr);
        showNamedViews(shown);
        showTool(m_view.tool());
    }
}

void Actions::showTool(Tool tool)
{
    const bool scene = m_session.now().scene != nullptr;
    m_inspect->setChecked(tool == Tool::Inspect);
    m_camera->setChecked(tool == Tool::Camera);
    for (QAction* action : m_inspectOnly) action->setEnabled(scene && tool == Tool::Inspect);
    for (QAction* action : m_cameraOnly) action->setEnabled(scene && tool == Tool::Camera);
    const bool other = m_session.now().compare.other.has_value();
    for (QAction* action : m_needOther)
        action->setEnabled(scene && other && (tool == Tool::Inspect || !std::ranges::count(m_inspectOnly, action)));
}

void Actions::showNamedViews(const Snapshot& shown)
{
    m_namedViews->clear();
    const bool any = shown.scene && !shown.scene->scene().views.empty();
    m_namedViews->setEnabled(any);
    if (!any) return;
    for (const NamedView& named : shown.scene->scene().views) {
        m_namedViews->addAction(QString::fromStdString(named.name), this, [this, view = named.view]() mutable {
            const ViewRequest& now = m_session.now().view;
            view.width             = now.width;
            view.height            = now.height;
            m_session.useView(view);
        });
    }
}

void Actions::showRecent(const QStringList& files)
{
    m_recent->clear();
    m_recent->setEnabled(!files.isEmpty());
    for (int i = 0; i < files.size(); ++i) {
        const QString path   = files[i];
        QAction*      action = m_recent->addAction(QFileInfo(path).fileName().replace('&', "&&"), this,
                                                   [this, path] { m_requests.openWord(path); });
        action->setToolTip(path);
        if (i < 9) action->setShortcut(key(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i)));
    }
    m_recent->setToolTipsVisible(true);
}

void Actions::showAppearance(Appearance appearance) { m_appearances[static_cast<std::size_t>(appearance)]->setChecked(true); }

}  // namespace zscope::ui
