// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/depth_test/depth_test_panel.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

struct DepthTestWords {
    Q_DECLARE_TR_FUNCTIONS(DepthTest)
};

void tellPixel(const PixelState& pixel, DepthTestContents& told)
{
    if (pixel.discarded)
        told.verdict = DepthTestWords::tr("It lies in a hole of its material: there is no fragment to test.");
    else if (pixel.keep == Keep::DepthOnly)
        told.verdict = pixel.won ? DepthTestWords::tr("The nearest so far: the pre-pass keeps its D.")
                                 : DepthTestWords::tr("Not nearer than the D that the pre-pass has kept.");
    else if (!pixel.rival && !pixel.won)
        told.verdict = pixel.keep == Keep::Equal
                           ? DepthTestWords::tr("Farther than the D that the pre-pass kept: it is hidden.")
                           : DepthTestWords::tr("It lies beyond the far plane: the pixel stays background.");
    else if (!pixel.rival)
        told.verdict = DepthTestWords::tr("The pixel was background: the first triangle to cover it owns it.");
    else if (pixel.keep == Keep::Over && pixel.won)
        told.verdict = DepthTestWords::tr("Painted over what was there: no depth is compared.");
    else if (pixel.depth == pixel.rivalDepth)
        told.verdict = pixel.won
                           ? DepthTestWords::tr("Equal depth, and the lower number wins: the pixel changes hands.")
                           : DepthTestWords::tr("Equal depth, and the lower number wins: the pixel stays as it is.");
    else
        told.verdict = pixel.won ? DepthTestWords::tr("The larger D is nearer: the pixel changes hands.")
                                 : DepthTestWords::tr("The smaller D is farther: the pixel stays as it is.");
    told.facts.push_back({DepthTestWords::tr("pixel"), QString("%1, %2").arg(pixel.x).arg(pixel.y)});
    told.facts.push_back({DepthTestWords::tr("offered by triangle"), grouped(pixel.triangle.value)});
    told.facts.push_back({DepthTestWords::tr("its depth D"), depthText(pixel.depth)});
    if (pixel.unmovedDepth)
        told.facts.push_back({DepthTestWords::tr("D before its relief"), depthText(*pixel.unmovedDepth)});
    told.facts.push_back({DepthTestWords::tr("owner before"),
                          pixel.rival ? grouped(pixel.rival->value) : DepthTestWords::tr("background")});
    if (pixel.rival) told.facts.push_back({DepthTestWords::tr("its depth D"), depthText(pixel.rivalDepth)});
}

void tellTriangle(const TriangleState& triangle, DepthTestContents& told)
{
    told.facts.push_back({DepthTestWords::tr("triangle"), grouped(triangle.triangle.value)});
    for (const auto& corner : triangle.corners)
        told.facts.push_back(
            {DepthTestWords::tr("corner"), QString("%1,  %2").arg(decimal(corner[0], 2), decimal(corner[1], 2))});
    told.facts.push_back({DepthTestWords::tr("pixels won so far"), grouped(triangle.pixelsWon)});
}

void tellPick(const PixelFacts& facts, DepthTestContents& told)
{
    told.facts.push_back(
        {DepthTestWords::tr("picked pixel"), QString("%1, %2").arg(facts.pixel.x()).arg(facts.pixel.y())});
    if (!facts.triangle) {
        told.facts.push_back({DepthTestWords::tr("owner"), DepthTestWords::tr("background")});
        return;
    }
    told.facts.push_back({DepthTestWords::tr("owner, triangle"), grouped(facts.triangle->value)});
    told.facts.push_back({DepthTestWords::tr("depth D"), depthText(facts.depth)});
    told.facts.push_back({DepthTestWords::tr("distance z"), decimal(facts.z, 6)});
    told.facts.push_back({DepthTestWords::tr("polygon of the file"), grouped(facts.polygon)});
    if (!facts.instance.isEmpty()) told.facts.push_back({DepthTestWords::tr("instance"), facts.instance});
    if (!facts.group.isEmpty()) told.facts.push_back({DepthTestWords::tr("group"), facts.group});
    if (!facts.material.isEmpty()) told.facts.push_back({DepthTestWords::tr("material"), facts.material});
}

}  // namespace

DepthTestContents depthTestOf(const Snapshot& shown)
{
    DepthTestContents told;
    const ShownStep*  step = shown.showsStep ? shown.stepOfPicture() : nullptr;
    if (step && step->state.pixel) tellPixel(*step->state.pixel, told);
    if (step && step->state.triangle) tellTriangle(*step->state.triangle, told);
    if (const auto facts = shown.picked ? factsOf(shown, *shown.picked) : std::nullopt) tellPick(*facts, told);
    if (told.verdict.isEmpty() && told.facts.empty())
        told.verdict = shown.scene ? DepthTestWords::tr(
                           "Click a pixel of the picture to see who owns it, or step by the grain “pixel” to "
                           "watch each depth test.")
                                   : DepthTestWords::tr("Open a scene to see its depth tests.");
    return told;
}

DepthTestPanel::DepthTestPanel(Session& session, QWidget* parent) : Panel(session, parent), m_verdict(new QLabel)
{
    m_verdict->setWordWrap(true);
    auto* inside = new QWidget;
    auto* layout = new QVBoxLayout(inside);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    layout->addWidget(m_verdict);
    m_grid = new QGridLayout;
    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(1, 1);
    layout->addLayout(m_grid);
    layout->addStretch(1);

    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(inside);
    scroll->viewport()->setAutoFillBackground(false);
    inside->setAutoFillBackground(false);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);
    setMinimumHeight(96);
    spoken(*this, [this] { setAccessibleName(tr("Depth test")); });
}

void DepthTestPanel::present(const Snapshot& shown, Changes what)
{
    if (!(what & (Change::Picture | Change::Selection | Change::Scene))) return;
    const DepthTestContents told = depthTestOf(shown);
    m_verdict->setText(told.verdict);
    m_verdict->setVisible(!told.verdict.isEmpty());
    m_verdict->setForegroundRole(told.facts.empty() ? QPalette::PlaceholderText : QPalette::WindowText);
    while (m_names.size() < told.facts.size()) {
        const int row = static_cast<int>(m_names.size());
        m_names.push_back(new QLabel);
        m_values.push_back(new QLabel);
        m_names.back()->setObjectName("soft");
        m_values.back()->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_values.back()->setTextInteractionFlags(Qt::TextSelectableByMouse);
        m_grid->addWidget(m_names.back(), row, 0);
        m_grid->addWidget(m_values.back(), row, 1);
    }
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const bool used = i < told.facts.size();
        m_names[i]->setVisible(used);
        m_values[i]->setVisible(used);
        if (!used) continue;
        m_names[i]->setText(told.facts[i].name);
        m_values[i]->setText(told.facts[i].value);
    }
    const auto facts = shown.picked ? factsOf(shown, *shown.picked) : std::nullopt;
    emit summaryChanged(facts && facts->triangle ? tr("triangle %1").arg(grouped(facts->triangle->value)) : QString());
}

}  // namespace zscope::ui
