// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/scene/scene_panel.h"

#include <array>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/parts/scrolling.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr std::size_t kWarningsShown = 200;

}  // namespace

ScenePanel::ScenePanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_title(new QLabel), m_hint(new QLabel), m_facts(new QWidget), m_turning(new QWidget),
      m_normalise(new QPushButton), m_warningsTitle(new QLabel), m_warnings(new QListWidget)
{
    auto* inside = new ScrolledPart;
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    m_title->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_title->setWordWrap(true);
    layout->addWidget(m_title);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    layout->addWidget(m_hint);

    auto* facts = new QGridLayout(m_facts);
    facts->setContentsMargins(0, 0, 0, 0);
    facts->setVerticalSpacing(3);
    facts->setColumnStretch(1, 1);
    std::array<QLabel*, 5> factNames{};
    for (int i = 0; i < static_cast<int>(factNames.size()); ++i) {
        auto*& name = factNames[static_cast<std::size_t>(i)];
        name        = new QLabel;
        name->setObjectName("soft");
        auto*& value = m_values[static_cast<std::size_t>(i)];
        value        = new QLabel;
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        facts->addWidget(name, i, 0);
        facts->addWidget(value, i, 1);
    }
    layout->addWidget(m_facts);

    auto* turning = new QVBoxLayout(m_turning);
    turning->setContentsMargins(0, 0, 0, 0);
    turning->setSpacing(6);
    auto* section = new QLabel;
    section->setObjectName("soft");
    turning->addWidget(section);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
        m_angles[i] = new QDoubleSpinBox;
        m_angles[i]->setRange(-360, 360);
        m_angles[i]->setDecimals(1);
        m_angles[i]->setSingleStep(5);
        m_angles[i]->setAlignment(Qt::AlignRight);
        m_angles[i]->setKeyboardTracking(false);
        m_angles[i]->setMinimumWidth(40);
        row->addWidget(m_angles[i], 1);
        connect(m_angles[i], &QDoubleSpinBox::valueChanged, this, &ScenePanel::turn);
    }
    turning->addLayout(row);
    m_normalise->setFocusPolicy(Qt::TabFocus);
    turning->addWidget(m_normalise);
    connect(m_normalise, &QPushButton::clicked, this, [this] { this->session().normaliseModel(); });
    layout->addWidget(m_turning);

    m_warningsTitle->setObjectName("section");
    layout->addWidget(m_warningsTitle);
    m_warnings->setFrameShape(QFrame::NoFrame);
    m_warnings->setWordWrap(true);
    layout->addWidget(m_warnings, 1);
    layout->addStretch(0);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolling(inside));
    showScene(session.now());
    spoken(*this, [this, section, factNames] {
        m_normalise->setText(tr("Normalise"));
        m_hint->setText(tr("Drop an OBJ file on the window, press Ctrl+O, or choose File ▸ Examples."));
        m_normalise->setToolTip(
            tr("Puts the mean of the vertices in the middle and fits the model's cube to the picture"));
        m_warnings->setAccessibleName(tr("Warnings"));
        section->setText(tr("Turn the model: y, z, y in degrees"));
        const std::array factTexts{tr("triangles"), tr("polygons"), tr("vertices"), tr("instances"), tr("size")};
        for (std::size_t i = 0; i < factTexts.size(); ++i) factNames[i]->setText(factTexts[i]);
        const std::array axisNames{tr("First angle, about y"), tr("Second angle, about z"), tr("Third angle, about y")};
        for (std::size_t i = 0; i < axisNames.size(); ++i) {
            m_angles[i]->setAccessibleName(axisNames[i]);
            m_angles[i]->setToolTip(
                tr("%1. The camera goes round the model, so the light turns with it.").arg(axisNames[i]));
        }
    });
}

void ScenePanel::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Scene) showScene(shown);
    if (what & (Change::Camera | Change::Scene)) showAngles();
}

void ScenePanel::showScene(const Snapshot& shown)
{
    const bool loaded = shown.scene != nullptr;
    m_hint->setVisible(!loaded);
    for (QWidget* part : std::initializer_list<QWidget*>{m_title, m_facts, m_turning}) part->setVisible(loaded);
    m_warnings->clear();
    m_warnings->setVisible(false);
    m_warningsTitle->setVisible(false);
    if (!loaded) return;

    const Scene& scene = shown.scene->scene();
    m_title->setText(shown.scene->title);
    m_title->setToolTip(shown.scene->word);
    const dvec3 size = scene.bounds.isEmpty() ? dvec3{0, 0, 0} : scene.bounds.max - scene.bounds.min;
    const auto  side = [](double value) { return QString::number(value, 'g', 4); };
    m_values[0]->setText(grouped(scene.triangleCount()));
    m_values[1]->setText(grouped(shown.scene->polygons));
    m_values[2]->setText(grouped(shown.scene->vertices));
    m_values[3]->setText(grouped(scene.instances.size()));
    m_values[4]->setText(QString("%1 × %2 × %3").arg(side(size.x), side(size.y), side(size.z)));

    const std::size_t warnings = scene.warnings.size();
    emit              summaryChanged(warnings == 0 ? QString() : counted(warnings, tr("1 warning"), tr("%1 warnings")));
    if (warnings == 0) return;
    m_warningsTitle->setText(tr("Left out or mended while reading"));
    m_warningsTitle->setVisible(true);
    m_warnings->setVisible(true);
    for (std::size_t i = 0; i < warnings && i < kWarningsShown; ++i) {
        const Warning& warning = scene.warnings[i];
        m_warnings->addItem(warning.line > 0 ? tr("line %1: %2").arg(warning.line).arg(said(warning.sentence))
                                             : said(warning.sentence));
    }
    if (warnings > kWarningsShown) m_warnings->addItem(tr("and %1 more").arg(grouped(warnings - kWarningsShown)));
}

void ScenePanel::showAngles()
{
    const YzyAngles  angles = session().control().angles();
    const std::array values{angles.first, angles.second, angles.third};
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
        if (m_angles[i]->hasFocus()) continue;  // not under the hand that types
        const QSignalBlocker quiet(m_angles[i]);
        m_angles[i]->setValue(values[i]);
    }
}

void ScenePanel::turn()
{
    const YzyAngles angles{m_angles[0]->value(), m_angles[1]->value(), m_angles[2]->value()};
    session().moveCamera([&](CameraControl& camera) { camera.setAngles(angles); });
}

}  // namespace zscope::ui
