// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/actions.h"

#include <algorithm>

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>

#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/icons.h"

namespace zscope::ui {
namespace {

constexpr double kTurnStep = 5;   // degrees per arrow key
constexpr double kZoomStep = 1.25;
constexpr QSize  kSizes[]  = {{160, 90}, {640, 360}, {1280, 720}, {1600, 900}, {1920, 1080}, {3840, 2160}};  // of the picture, pixels

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size())); }

QKeySequence key(int k) { return QKeySequence(k); }

}  // namespace

QString plainName(const QAction& action)
{
    QString name = action.text();
    name.remove(QRegularExpression(QStringLiteral("\\(&.\\)")));
    return name.remove('&');
}

Actions::Actions(QMainWindow& window, Session& session, FrameView& view, WindowRequests requests)
    : QObject(&window), m_window(window), m_session(session), m_view(view), m_requests(std::move(requests))
{
    makeFileMenu();
    makeViewMenu();
    makeCameraMenu();
    makeAlgorithmMenu();
    makeStepMenu();
    makeCompareMenu();
    makeLanguageMenu();
    makeHelpMenu();
    makeToolBar();
    showTool(m_view.tool());
    spoken(*this, [this] { say(); });
}

void Actions::say()
{
    for (const auto& [action, label] : m_labels) {
        action->setText(tr(label));
        action->setIconText(plainName(*action));  // on the toolbar
    }
    for (const auto& [action, tip] : m_tips) action->setToolTip(tr(tip));
    for (const auto& [action, title] : m_titles) action->setToolTip(said(title));
    for (std::size_t i = 0; i < layers().size(); ++i) m_layerChoices[i]->setText(said(layers()[i].word));
    for (std::size_t i = 0; i < presets().size(); ++i) {
        m_others[i]->setText(tr("B: %1").arg(text(presets()[i].name)));
        m_algorithmBox->setItemData(static_cast<int>(i), said(presets()[i].title), Qt::ToolTipRole);
    }
    for (std::size_t i = 0; i < std::size(kSizes); ++i) m_sizes[i]->setText(tr("%1 × %2").arg(kSizes[i].width()).arg(kSizes[i].height()));
    m_toolBar->setWindowTitle(tr("Tools"));
    m_algorithmBox->setAccessibleName(tr("Algorithm"));
    m_layersButton->setText(tr("Layers"));
}

QMenu* Actions::addMenu(QMenu* under, const char* label)
{
    QMenu* menu = under ? under->addMenu(QString()) : m_window.menuBar()->addMenu(QString());
    m_labels.emplace_back(menu->menuAction(), label);
    return menu;
}

QAction* Actions::add(QMenu* menu, const char* label, const QList<QKeySequence>& keys, std::function<void()> run,
                      const QString& icon)
{
    QAction* action = addNamed(menu, QString(), keys, std::move(run), icon);
    m_labels.emplace_back(action, label);
    return action;
}

QAction* Actions::addNamed(QMenu* menu, const QString& name, const QList<QKeySequence>& keys, std::function<void()> run,
                           const QString& icon)
{
    auto* action = new QAction(name, this);
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
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&File"));
    m_open      = add(menu, QT_TR_NOOP("&Open…"), QKeySequence::Open, m_requests.open, "open");
    m_recent    = addMenu(menu, QT_TR_NOOP("Open &recent"));
    QMenu* examples = addMenu(menu, QT_TR_NOOP("&Examples"));
    QMenu* hard     = nullptr;
    for (const SceneEntry& scene : builtinScenes()) {
        const QString name  = text(scene.name);
        QMenu*        under = examples;
        if (name.startsWith("hard/")) {
            if (!hard) hard = addMenu(examples, QT_TR_NOOP("Hard cases"));
            under = hard;
        }
        QAction* action = under->addAction(QString(name).replace('&', "&&"), this, [this, name] { m_requests.openWord("builtin:" + name); });
        m_titles.emplace_back(action, scene.title);
        under->setToolTipsVisible(true);
    }
    m_needScene.push_back(add(menu, QT_TR_NOOP("Re&load"), key(Qt::CTRL | Qt::Key_R), [this] { m_session.reload(); }));
    menu->addSeparator();
    m_needScene.push_back(add(menu, QT_TR_NOOP("&Save picture"), key(Qt::Key_F12), m_requests.savePicture));
    m_needScene.push_back(
        add(menu, QT_TR_NOOP("Save picture &without decoration"), key(Qt::CTRL | Qt::Key_F12), m_requests.savePlainPicture));
    m_needScene.push_back(add(menu, QT_TR_NOOP("Save picture &as…"), QKeySequence::Save, m_requests.savePictureAs));
    m_needScene.push_back(add(menu, QT_TR_NOOP("&Copy picture"), QKeySequence::Copy, m_requests.copyPicture));
    menu->addSeparator();
    add(menu, QT_TR_NOOP("&Quit"), key(Qt::CTRL | Qt::Key_Q), [this] { m_window.close(); });
    showRecent({});
}

void Actions::makeViewMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&View"));
    m_fit       = add(menu, QT_TR_NOOP("&Fit"), key(Qt::Key_F), [this] { m_view.fit(); }, "fit");
    add(menu, QT_TR_NOOP("&1:1"), key(Qt::CTRL | Qt::Key_0), [this] { m_view.oneToOne(); });
    add(menu, QT_TR_NOOP("Zoom &in"), {key(Qt::CTRL | Qt::Key_Plus), key(Qt::CTRL | Qt::Key_Equal)}, [this] { m_view.zoomBy(kZoomStep); });
    add(menu, QT_TR_NOOP("Zoom &out"), key(Qt::CTRL | Qt::Key_Minus), [this] { m_view.zoomBy(1 / kZoomStep); });
    menu->addSeparator();
    m_needScene.push_back(add(menu, QT_TR_NOOP("&Go to pixel…"), key(Qt::CTRL | Qt::Key_G), m_requests.goToPixel));
    const auto nudge = [&](const char* label, Qt::Key arrow, const QPoint& by) {
        m_inspectOnly.push_back(add(menu, label, key(Qt::CTRL | arrow), [this, by] {
            m_session.nudgePick(by);
            if (m_session.now().picked) m_view.reveal(*m_session.now().picked);
        }));
    };
    nudge(QT_TR_NOOP("Pick the pixel to the left"), Qt::Key_Left, {-1, 0});
    nudge(QT_TR_NOOP("Pick the pixel to the right"), Qt::Key_Right, {1, 0});
    nudge(QT_TR_NOOP("Pick the pixel above"), Qt::Key_Up, {0, -1});
    nudge(QT_TR_NOOP("Pick the pixel below"), Qt::Key_Down, {0, 1});
    add(menu, QT_TR_NOOP("&Stop work, or forget the pick"), key(Qt::Key_Escape), [this] {
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
    m_panels = addMenu(menu, QT_TR_NOOP("&Panels"));
    add(menu, QT_TR_NOOP("&Reset layout"), QKeySequence(), m_requests.resetLayout);
    makeAppearanceMenu(menu);
}

void Actions::makeLayersMenu(QMenu* view)
{
    m_layers    = addMenu(view, QT_TR_NOOP("&Layers"));
    auto* group = new QActionGroup(this);
    for (const Layer& layer : layers()) {
        QAction* action = addNamed(m_layers, QString(), {}, [this, &layer] { m_session.setLayer(layer); });
        action->setCheckable(true);
        m_titles.emplace_back(action, layer.title);
        group->addAction(action);
        m_layerChoices.push_back(action);
    }
    m_layers->setToolTipsVisible(true);
    m_needScene.push_back(add(m_layers, QT_TR_NOOP("Fit the range of depths"), key(Qt::Key_N), [this] {
        DepthRange range  = m_session.now().look.range;
        range.isAutomatic = true;
        m_session.setDepthRange(range);
    }));
    m_layers->addSeparator();
    const auto toggle = [this](const char* label, bool Layers::* part) {
        QAction* action = m_layers->addAction(QString());
        m_labels.emplace_back(action, label);
        action->setCheckable(true);
        m_layerToggles.emplace_back(action, part);
        connect(action, &QAction::triggered, this, [this, part](bool on) {
            Layers layers = m_session.now().layers;
            layers.*part  = on;
            m_session.setLayers(layers);
        });
    };
    toggle(QT_TR_NOOP("Current line"), &Layers::line);
    toggle(QT_TR_NOOP("Active edges"), &Layers::edges);
    toggle(QT_TR_NOOP("What is still to come, pale"), &Layers::ghost);
    toggle(QT_TR_NOOP("Triangle of the step"), &Layers::triangle);
    toggle(QT_TR_NOOP("Last question and update of the pyramid"), &Layers::query);
    toggle(QT_TR_NOOP("Boxes of the nodes, by verdict"), &Layers::boxes);
    toggle(QT_TR_NOOP("Cells of the pyramid, with values"), &Layers::pyramid);
    toggle(QT_TR_NOOP("Grid and numbers in large pixels"), &Layers::grid);
    toggle(QT_TR_NOOP("Magnifier"), &Layers::magnifier);
}

void Actions::makeSizeMenu(QMenu* view)
{
    QMenu* sizes = addMenu(view, QT_TR_NOOP("Picture si&ze"));
    for (const QSize& size : kSizes)
        m_sizes.push_back(sizes->addAction(QString(), this, [this, size] { m_session.setPictureSize(size.width(), size.height()); }));
    sizes->addSeparator();
    QAction* asView = sizes->addAction(QString(), this, [this] {
        const QSizeF size = QSizeF(m_view.size()) * m_view.devicePixelRatioF();
        m_session.setPictureSize(static_cast<int>(size.width()), static_cast<int>(size.height()));
    });
    m_labels.emplace_back(asView, QT_TR_NOOP("As large as the view"));
}

void Actions::makeAppearanceMenu(QMenu* view)
{
    QMenu* menu  = addMenu(view, QT_TR_NOOP("&Appearance"));
    auto*  group = new QActionGroup(this);
    const std::pair<const char*, Appearance> looks[] = {{QT_TR_NOOP("As the system"), Appearance::System},
                                                        {QT_TR_NOOP("Light"), Appearance::Light},
                                                        {QT_TR_NOOP("Dark"), Appearance::Dark}};
    for (const auto& [label, look] : looks) {
        QAction* action = menu->addAction(QString(), this, [this, look = look] { m_requests.look(look); });
        m_labels.emplace_back(action, label);
        action->setCheckable(true);
        group->addAction(action);
        m_appearances.push_back(action);
    }
}

void Actions::makeLanguageMenu()
{
    // Each language in its own words, so that whoever chose the wrong one finds back.
    QMenu* menu  = m_window.menuBar()->addMenu(QStringLiteral("&Language / \u8BED\u8A00"));
    auto*  group = new QActionGroup(this);
    const auto choice = [&](const QString& name, Language language) {
        QAction* action = menu->addAction(name, this, [this, language] { m_requests.speak(language); });
        action->setCheckable(true);
        group->addAction(action);
        m_languages.push_back(action);
        return action;
    };
    m_labels.emplace_back(choice(QString(), Language::System), QT_TR_NOOP("As the system"));
    choice(QStringLiteral("English"), Language::English);
    choice(QStringLiteral("\u7B80\u4F53\u4E2D\u6587"), Language::Chinese);
}

void Actions::makeCameraMenu()
{
    QMenu* menu  = addMenu(nullptr, QT_TR_NOOP("&Camera"));
    auto*  tools = new QActionGroup(this);
    m_inspect    = add(menu, QT_TR_NOOP("&Inspect"), key(Qt::Key_I), [this] { m_view.setTool(Tool::Inspect); }, "inspect");
    m_camera     = add(menu, QT_TR_NOOP("&Camera"), key(Qt::Key_C), [this] {
        m_view.setTool(Tool::Camera);
        m_view.setFocus();
    }, "camera");
    m_tips.emplace_back(m_inspect, QT_TR_NOOP("Inspect (I): the wheel zooms, dragging pans, a click picks a pixel, Right and Left step"));
    m_tips.emplace_back(m_camera, QT_TR_NOOP("Camera (C, or while Alt is held): left drag orbits, middle drag pans, the wheel dollies, "
                                             "the arrow keys turn the model, WASD flies"));
    for (QAction* tool : {m_inspect, m_camera}) {
        tool->setCheckable(true);
        tools->addAction(tool);
    }
    menu->addSeparator();
    const auto axis = [&](const char* label, Qt::Key digit, AxisView view) {
        m_needScene.push_back(add(menu, label, key(Qt::KeypadModifier | digit), [this, view] {
            m_session.moveCamera([view](CameraControl& camera) { camera.lookAlong(view); });
        }));
    };
    axis(QT_TR_NOOP("From the &front"), Qt::Key_1, AxisView::Front);
    axis(QT_TR_NOOP("From the &right"), Qt::Key_3, AxisView::Right);
    axis(QT_TR_NOOP("From &above"), Qt::Key_7, AxisView::Top);
    m_needScene.push_back(add(menu, QT_TR_NOOP("R&eset"), {key(Qt::Key_Return), key(Qt::KeypadModifier | Qt::Key_Enter)},
                              [this] { m_session.resetCamera(); }));
    m_namedViews = addMenu(menu, QT_TR_NOOP("Views of the &scene"));
    menu->addSeparator();
    const auto turn = [&](const char* label, QKeySequence keys, YzyAngles by) {
        m_cameraOnly.push_back(add(menu, label, keys, [this, by] {
            m_session.moveCamera([by](CameraControl& camera) {
                const YzyAngles at = camera.angles();
                camera.setAngles({at.first + by.first, at.second + by.second, at.third + by.third});
            });
        }));
    };
    turn(QT_TR_NOOP("Turn: first angle, less"), key(Qt::Key_Left), {-kTurnStep, 0, 0});
    turn(QT_TR_NOOP("Turn: first angle, more"), key(Qt::Key_Right), {kTurnStep, 0, 0});
    turn(QT_TR_NOOP("Turn: second angle, less"), key(Qt::Key_Down), {0, -kTurnStep, 0});
    turn(QT_TR_NOOP("Turn: second angle, more"), key(Qt::Key_Up), {0, kTurnStep, 0});
    turn(QT_TR_NOOP("Turn: third angle, less"), key(Qt::SHIFT | Qt::Key_Left), {0, 0, -kTurnStep});
    turn(QT_TR_NOOP("Turn: third angle, more"), key(Qt::SHIFT | Qt::Key_Right), {0, 0, kTurnStep});
    m_needScene.push_back(add(menu, QT_TR_NOOP("&Normalise the model"), QKeySequence(), [this] { m_session.normaliseModel(); }));
}

void Actions::makeAlgorithmMenu()
{
    QMenu* menu  = addMenu(nullptr, QT_TR_NOOP("&Algorithm"));
    auto*  group = new QActionGroup(this);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset& preset = presets()[i];
        QList<QKeySequence> keys;
        if (i < 9) keys << key(static_cast<int>(Qt::Key_1) + static_cast<int>(i));
        QAction* action = addNamed(menu, text(preset.name), keys, [this, &preset] { m_session.setPipeline(preset.pipeline); });
        action->setCheckable(true);
        m_titles.emplace_back(action, preset.title);
        group->addAction(action);
        m_algorithms.push_back(action);
    }
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    m_cull = add(menu, QT_TR_NOOP("Leave out &back faces"), QKeySequence(), [this] {
        m_session.setFaceCulling(m_cull->isChecked() ? FaceCulling::Back : FaceCulling::None);
    });
    m_cull->setCheckable(true);
    m_cull->setChecked(m_session.settings().faceCulling == FaceCulling::Back);
}

void Actions::makeStepMenu()
{
    QMenu*     menu = addMenu(nullptr, QT_TR_NOOP("&Step"));
    const auto step = [&](const char* label, const QKeySequence& keys, std::function<void()> run) {
        QAction* action = add(menu, label, keys, std::move(run));
        m_needScene.push_back(action);
        return action;
    };
    step(QT_TR_NOOP("&Play or pause"), key(Qt::Key_Space), [this] { m_session.player().setPlaying(!m_session.player().isPlaying()); });
    m_inspectOnly.push_back(step(QT_TR_NOOP("&Forward"), key(Qt::Key_Right), [this] { m_session.stepBy(1); }));
    m_inspectOnly.push_back(step(QT_TR_NOOP("&Back"), key(Qt::Key_Left), [this] { m_session.stepBy(-1); }));
    m_inspectOnly.push_back(step(QT_TR_NOOP("Forward by the coarser grain"), key(Qt::SHIFT | Qt::Key_Right), [this] { m_session.stepCoarser(1); }));
    m_inspectOnly.push_back(step(QT_TR_NOOP("Back by the coarser grain"), key(Qt::SHIFT | Qt::Key_Left), [this] { m_session.stepCoarser(-1); }));
    step(QT_TR_NOOP("F&irst step"), key(Qt::Key_Home), [this] { m_session.goToStart(); });
    step(QT_TR_NOOP("&Last step"), key(Qt::Key_End), [this] { m_session.goToEnd(); });
}

void Actions::makeCompareMenu()
{
    QMenu* menu  = addMenu(nullptr, QT_TR_NOOP("C&ompare"));
    QMenu* other = addMenu(menu, QT_TR_NOOP("&B"));
    auto*  group = new QActionGroup(this);
    for (std::size_t i = 0; i < presets().size(); ++i) {
        const Preset& preset = presets()[i];
        QList<QKeySequence> keys;
        if (i < 9) keys << key(static_cast<int>(Qt::SHIFT | Qt::Key_1) + static_cast<int>(i));
        QAction* action = addNamed(other, QString(), keys, [this, &preset] { m_session.compareWith(preset.pipeline); });
        action->setCheckable(true);
        m_titles.emplace_back(action, preset.title);
        group->addAction(action);
        m_others.push_back(action);
    }
    other->setToolTipsVisible(true);
    m_needScene.push_back(add(menu, QT_TR_NOOP("&Keep A as B"), QKeySequence(), [this] { m_session.compareWith(m_session.now().pipeline); }));
    menu->addSeparator();
    const auto show = [&](const char* label, Qt::Key k, CompareShow what) {
        QAction* action = add(menu, label, key(k), [this, what] {
            const bool isOn = m_session.now().compare.show == what;
            m_session.showCompared(isOn ? CompareShow::A : what);
        });
        m_needOther.push_back(action);
        m_inspectOnly.push_back(action);  // the camera flies with W and D
    };
    show(QT_TR_NOOP("&To and fro between A and B"), Qt::Key_T, CompareShow::B);
    show(QT_TR_NOOP("&Wipe"), Qt::Key_W, CompareShow::Wipe);
    show(QT_TR_NOOP("&Difference"), Qt::Key_D, CompareShow::Difference);
    m_needOther.push_back(add(menu, QT_TR_NOOP("&Swap A and B"), QKeySequence(), [this] { m_session.swapCompared(); }));
    menu->addSeparator();
    m_needOther.push_back(add(menu, QT_TR_NOOP("&End the comparison"), QKeySequence(), [this] { m_session.compareWith({}); }));
}

void Actions::makeHelpMenu()
{
    QMenu* menu = addMenu(nullptr, QT_TR_NOOP("&Help"));
    add(menu, QT_TR_NOOP("&Keys and mouse"), {key(Qt::Key_F1), key(Qt::Key_Question)}, m_requests.keys);
    add(menu, QT_TR_NOOP("&About ZScope"), QKeySequence(), m_requests.about);
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
    m_toolBar->setMinimumHeight(54);  // with the step below it that the style sheet leaves

    m_algorithmBox = new QComboBox;
    m_algorithmBox->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (const Preset& preset : presets()) m_algorithmBox->addItem(text(preset.name));
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
    m_layersButton = new QToolButton;
    m_layersButton->setMenu(m_layers);
    m_layersButton->setPopupMode(QToolButton::InstantPopup);
    m_layersButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_layersButton->setFocusPolicy(Qt::TabFocus);
    m_icons.emplace_back(m_layers->menuAction(), "layers");
    m_toolBar->addWidget(m_layersButton);
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
    m_layersButton->setIcon(iconOf("layers", theme.text));
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

void Actions::showLanguage(Language language) { m_languages[static_cast<std::size_t>(language)]->setChecked(true); }

}  // namespace zscope::ui
