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
#include "ui/text/utf8_text.h"
#include "ui/theme/icons.h"
#include "ui/window/layouts.h"

namespace zscope::ui {

QString plainName(const QAction& action)
{
    QString name = action.text();
    name.remove(QRegularExpression(QStringLiteral("\\(&.\\)")));
    return name.remove('&');
}

QString menuNameOf(const QAction& action)
{
    for (const QObject* place : action.associatedObjects())
        if (const auto* menu = qobject_cast<const QMenu*>(place)) return plainName(*menu->menuAction());
    return {};
}

bool isListed(const QAction& action) { return action.isVisible() && !action.text().isEmpty(); }

Actions::Actions(QMainWindow& window, Session& session, FrameView& view, Settings& settings, WindowRequests requests)
    : QObject(&window), m_window(window), m_session(session), m_view(view), m_requests(std::move(requests)),
      m_bindings(settings)
{
    makeFileMenu();
    makeViewMenu();
    makeCameraMenu();
    makeAlgorithmMenu();
    makeStepMenu();
    makeCompareMenu();
    makeMeasureMenu();
    makeLessonsMenu();
    makeLanguageMenu();
    makeHelpMenu();
    makeToolBar();
    for (QAction* action : m_all)
        m_bindings.add(*action, std::ranges::count(m_inspectOnly, action)  ? ToolScope::Inspect
                                : std::ranges::count(m_cameraOnly, action) ? ToolScope::Camera
                                                                           : ToolScope::Both);
    showTool(m_view.tool());
    showMeasuring(false);
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
        m_others[i]->setText(tr("B: %1").arg(utf8Text(presets()[i].name)));
        m_algorithmBox->setItemData(static_cast<int>(i), said(presets()[i].title), Qt::ToolTipRole);
    }
    for (const auto& [action, size] : m_sizes) action->setText(tr("%1 × %2").arg(size.width()).arg(size.height()));
    for (std::size_t i = 0; i < layoutEntries().size(); ++i) {
        m_layoutChoices[i]->setText(layoutEntries()[i].translatedTitle());
        m_layoutChoices[i]->setToolTip(layoutEntries()[i].translatedTip());
    }
    m_toolBar->setWindowTitle(tr("Tools"));
    m_algorithmBox->setAccessibleName(tr("Algorithm"));
    m_layersButton->setText(tr("Layers"));
}

void Actions::adopt(QAction& action, const QString& name)
{
    action.setObjectName(name);
    m_all.push_back(&action);
    m_window.addAction(&action);
    m_bindings.add(action, ToolScope::Both);
}

QMenu* Actions::addMenu(QMenu* under, const char* label)
{
    QMenu* menu = under ? under->addMenu(QString()) : m_window.menuBar()->addMenu(QString());
    m_labels.emplace_back(menu->menuAction(), label);
    return menu;
}

QAction* Actions::add(QMenu* menu, const QString& name, const char* label, const QList<QKeySequence>& keys,
                      std::function<void()> run, const QString& icon)
{
    QAction* action = addNamed(menu, name, QString(), keys, std::move(run), icon);
    m_labels.emplace_back(action, label);
    return action;
}

QAction* Actions::addNamed(QMenu* menu, const QString& name, const QString& label, const QList<QKeySequence>& keys,
                           std::function<void()> run, const QString& icon)
{
    auto* action = new QAction(label, this);
    action->setObjectName(name);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
    menu->addAction(action);
    m_window.addAction(action);  // the key works whatever has the focus
    m_all.push_back(action);
    if (!icon.isEmpty()) m_icons.emplace_back(action, icon);
    return action;
}

void Actions::dress(const Theme& theme)
{
    for (const auto& [action, name] : m_icons) {
        QIcon      icon    = iconOf(name, theme.text);
        const auto checked = iconOf(name, theme.buttonText);
        for (const QSize& size : checked.availableSizes())
            icon.addPixmap(checked.pixmap(size), QIcon::Normal, QIcon::On);
        action->setIcon(icon);
        action->setIconVisibleInMenu(!action->isCheckable());  // there the mark of what is chosen stands in its place
    }
    m_layersButton->setIcon(iconOf("layers", theme.text));
}

void Actions::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Pipeline) {
        const QSignalBlocker quiet(m_algorithmBox);
        int                  chosen = -1;
        for (std::size_t i = 0; i < presets().size(); ++i) {
            const bool isChosen = presets()[i].pipeline == shown.pipeline;
            m_algorithms[i]->setChecked(isChosen);
            if (isChosen) chosen = static_cast<int>(i);
        }
        // A composition without a name of its own stands below the others while it is chosen.
        const int named = static_cast<int>(presets().size());
        while (m_algorithmBox->count() > named) m_algorithmBox->removeItem(named);
        const QString name = QString::fromStdString(nameOf(shown.pipeline));
        if (chosen < 0) m_algorithmBox->addItem(name);
        m_algorithmBox->setCurrentIndex(chosen < 0 ? named : chosen);
        m_algorithmBox->setToolTip(name);  // it may be longer than the box
        for (std::size_t i = 0; i < layers().size(); ++i)
            m_layerChoices[i]->setChecked(&layers()[i] == shown.look.layer);
        m_cull->setChecked(m_session.settings().faceCulling == FaceCulling::Back);
    }
    if (what & Change::Compare) {
        for (std::size_t i = 0; i < presets().size(); ++i)
            m_others[i]->setChecked(shown.compare.other == presets()[i].pipeline);
        showTool(m_view.tool());
    }
    if (what & Change::Layers)
        for (const auto& [action, part] : m_layerToggles) action->setChecked(shown.layers.*part);
    if (what & Change::Scene) {
        for (QAction* action : m_needScene) action->setEnabled(shown.scene != nullptr);
        showNamedViews(shown);
        showTool(m_view.tool());
        showMeasuring(m_isMeasuring);
    }
}

void Actions::showMeasuring(bool isMeasuring)
{
    m_isMeasuring = isMeasuring;
    m_measure->setEnabled(!isMeasuring && m_session.now().scene != nullptr);
    m_stopMeasuring->setEnabled(isMeasuring);
}

void Actions::showTool(Tool tool)
{
    const bool scene = m_session.now().scene != nullptr;
    m_inspect->setChecked(tool == Tool::Inspect);
    m_camera->setChecked(tool == Tool::Camera);
    for (QAction* action : m_inspectOnly) action->setEnabled(scene && tool == Tool::Inspect);
    for (QAction* action : m_cameraOnly) action->setEnabled(scene && tool == Tool::Camera);
    const CompareState& compare = m_session.now().compare;
    const bool          other   = compare.isOn();
    m_swap->setEnabled(scene && compare.other);
    m_swap->setToolTip(compare.theirs   ? tr("What another program drew cannot be drawn again as A")
                       : !compare.other ? tr("There is no B to compare with: choose one above, under B")
                                        : QString());
    for (QAction* action : {m_judgeAgain, m_saveReport}) {
        action->setEnabled(scene && compare.theirs);
        action->setToolTip(compare.theirs ? QString() : tr("Open your picture first: File ▸ Open my picture…"));
    }
    for (QAction* action : m_needOther) {
        const bool isFree = tool == Tool::Inspect || !std::ranges::count(m_inspectOnly, action);
        action->setEnabled(scene && other && isFree);
        action->setToolTip(!scene    ? tr("Open a scene first")
                           : !other  ? tr("There is no B to compare with: choose one above, under B")
                           : !isFree ? tr("Only with the tool Inspect (I)")
                                     : QString());
    }
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
    m_recent->setEnabled(!files.isEmpty());
    for (qsizetype i = 0; i < static_cast<qsizetype>(m_recentFiles.size()); ++i) {
        QAction*   action = m_recentFiles[static_cast<std::size_t>(i)];
        const bool there  = i < files.size();
        action->setVisible(there);
        action->setEnabled(there);
        action->setText(there ? QFileInfo(files[i]).fileName().replace('&', "&&") : QString());
        action->setToolTip(there ? files[i] : QString());
        action->setData(there ? files[i] : QString());
    }
}

void Actions::showLayout(const QString& word)
{
    for (std::size_t i = 0; i < layoutEntries().size(); ++i)
        m_layoutChoices[i]->setChecked(word == layoutEntries()[i].word);
}

void Actions::showOwnLayouts(const QStringList& names)
{
    m_ownLayouts->clear();
    m_forgetLayouts->clear();
    for (const QString& name : names) {
        const QString label = QString(name).replace('&', "&&");
        m_ownLayouts->addAction(label, this, [this, name] { m_requests.useOwnLayout(name); })
            ->setObjectName("layout.own." + name);
        m_forgetLayouts->addAction(label, this, [this, name] { m_requests.forgetOwnLayout(name); });
    }
    m_ownLayouts->setEnabled(!names.isEmpty());
    m_forgetLayouts->setEnabled(!names.isEmpty());
}

void Actions::showAppearance(Appearance appearance)
{
    m_appearances[static_cast<std::size_t>(appearance)]->setChecked(true);
}

void Actions::showLanguage(Language language) { m_languages[static_cast<std::size_t>(language)]->setChecked(true); }

}  // namespace zscope::ui
