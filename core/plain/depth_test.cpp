#include "core/plain/depth_test.h"

#include <algorithm>

#include "core/plain/shading.h"

namespace zscope::plain {

namespace {

SpoiltTest spoiltTest(const ChosenRules& rules)
{
    return {.firstComerStays  = rules.firstComerKeepsTie(),
            .drawsOver        = rules.drawsOver(),
            .equalWantsNearer = rules.equalPassWantsNearer(),
            .keepsLastDepths  = rules.keepsLastDepths(),
            .keepsFarthest    = rules.keepsFarthest()};
}

}  // namespace

DepthTest::DepthTest(Work& work, const Pass& pass, const DepthPlane& plane, TriangleId id, bool patterned)
    : m_work(work), m_pass(pass), m_plane(plane), m_rank(id.value + 1), m_empty(work.stripe.visible.empty()),
      m_shading(work.stripe.painter ? pass.shading : ShadingMoment::Never),
      m_nearerWins(pass.keep != Keep::Equal && pass.keep != Keep::Over && !work.rules.firstComerKeepsTie()  // a fault
                   && !work.rules.drawsOver() && !work.rules.keepsFarthest())                               // faults
{
    if (patterned) m_pattern = patternPlaneOf(work.stripe.scene.scene(), work.stripe.projection, id);
}

DepthTest::~DepthTest()
{
    const bool isPrepass = m_pass.keep == Keep::DepthOnly;
    m_work.tally.add(isPrepass ? Unit::PrepassPixels : Unit::Pixels, m_tested);
    m_work.tally.add(Unit::PixelsWon, isPrepass ? 0 : m_won);
    m_work.tally.add(Unit::Fragments, m_shaded);
}

void DepthTest::beginLine(int y, int first)
{
    m_y       = y;
    m_row     = m_work.stripe.visible.row(y);
    m_line    = m_plane.b * (y + 0.5) + m_plane.c;
    m_carried = first;
    if (m_work.rules.depthNumbers() == DepthNumbers::Float64) return;
    const auto a = static_cast<float>(m_plane.a), b = static_cast<float>(m_plane.b), c = static_cast<float>(m_plane.c);
    m_line  = b * (static_cast<float>(y) + 0.5f) + c;
    m_carry = a * (static_cast<float>(first) + 0.5f);
}

void DepthTest::offer(int x)
{
    const double   flat  = clampedDepthAt(x);
    const PixelKey bound = keyOfDepth(flat), held = m_row[x];
    const bool     shadesFirst = m_shading == ShadingMoment::BeforeTest;

    PixelKey fragment = bound;
    bool     exists = true, moved = false, looked = false;
    if (m_pattern && (shadesFirst || mayBecomeNearer(bound, held))) {
        looked = true;
        exists = !isHole(*m_pattern, x, m_y);
        moved  = exists && m_pattern->relief;
        if (m_pattern->relief) fragment = keyOfDepth(movedDepth(*m_pattern, flat, x, m_y));
    }
    const bool won =
        exists && (!m_pattern || looked) && (m_nearerWins ? fragment > held : winsByItsRule(fragment, held));
    if (won) m_row[x] = fragment;

    // With a pattern the shader also discards and moves fragments. After an early test (AfterTest) it runs for every
    // fragment that passes at the depth of its triangle. One that it discards is not shaded. One that it moves back is
    // shaded, although it may lose at its new depth.
    const bool shades = shadesFirst || (m_shading == ShadingMoment::AfterTest && (m_pattern ? looked && exists : won));
    if (shades && won) shade(x);
    ++m_tested;
    m_won += won;
    m_shaded += shades;
    m_work.tell(PixelTested{.x            = x,
                            .y            = m_y,
                            .triangle     = TriangleId{m_rank - 1},
                            .depth        = depthOf(fragment),
                            .won          = won,
                            .rivalRank    = rankOf(held),
                            .rivalDepth   = depthOf(held),
                            .keep         = m_pass.keep,
                            .shading      = m_pass.shading,
                            .shaded       = shades,
                            .discarded    = looked && !exists,
                            .moved        = moved,
                            .unmovedDepth = m_pattern ? depthOf(bound) : 0,
                            .spoilt       = spoiltTest(m_work.rules)});
}

void DepthTest::store(int x) { m_row[x] = keyOfDepth(clampedDepthAt(x)); }

bool DepthTest::wins(PixelKey fragment, PixelKey held) const
{
    return m_nearerWins ? fragment > held : winsByItsRule(fragment, held);
}

/// After a pre-pass, of a painter, and with a fault.
bool DepthTest::winsByItsRule(PixelKey fragment, PixelKey held) const
{
    if (m_pass.keep == Keep::Over) return fragment > keyOf(m_empty, 0);
    if (m_pass.keep == Keep::Nearest && m_work.rules.drawsOver())  // a fault
        return fragment > keyOf(m_empty, 0) && rankOf(fragment) > rankOf(held);
    if (m_pass.keep == Keep::Nearest && m_work.rules.keepsFarthest()) {  // a fault
        const bool isUnowned = rankOf(held) == 0, sameDepth = fragment >> 32 == held >> 32;
        return fragment > keyOf(m_empty, 0) && (isUnowned || (sameDepth ? fragment > held : fragment < held));
    }
    const bool firstComerStays = m_work.rules.firstComerKeepsTie() && m_pass.keep != Keep::DepthOnly;  // a fault
    if (m_pass.keep != Keep::Equal) {
        const PixelKey lastOfItsDepth = fragment & ~PixelKey{0xFFFFFFFF};
        return (firstComerStays ? lastOfItsDepth : fragment) > held;
    }
    // After a pre-pass: of the fragments with the depth that it left, the lowest id. It left the depth without an id.
    if (m_work.rules.equalPassWantsNearer()) return fragment >> 32 > held >> 32;  // a fault
    const bool isUnowned = rankOf(held) == 0;
    const bool sameDepth = fragment >> 32 == held >> 32;
    return sameDepth && fragment > keyOf(m_empty, 0) && (isUnowned || (fragment > held && !firstComerStays));
}

/// False only if the fragment loses at this depth and at any farther one.
bool DepthTest::mayBecomeNearer(PixelKey fragment, PixelKey held) const
{
    if (m_work.rules.keepsFarthest()) return fragment > keyOf(m_empty, 0);  // a fault
    if (m_pass.keep != Keep::Equal || !m_pattern->relief) return wins(fragment, held);
    return held >> 32 <= fragment >> 32;
}

PixelKey DepthTest::keyOfDepth(double depth) const
{
    return keyOf(m_work.rules.stored(depth), m_pass.keep == Keep::DepthOnly ? 0 : m_rank);
}

double DepthTest::clampedDepthAt(int x)
{
    double across = m_plane.a * (x + 0.5);
    if (m_work.rules.depthNumbers() != DepthNumbers::Float64) {
        const auto a = static_cast<float>(m_plane.a);
        across       = a * (static_cast<float>(x) + 0.5f);
        if (m_work.rules.depthNumbers() == DepthNumbers::Accumulated) {
            for (; m_carried < x; ++m_carried) m_carry += a;
            across = m_carry;
        }
    }
    const double depth = m_work.rules.depthFrom(across + m_line);  // a fault interpolates the distance
    return std::min(std::max(depth, double{m_plane.farthest}), double{m_plane.nearest});
}

void DepthTest::shade(int x) const
{
    const Painter& painter    = *m_work.stripe.painter;
    painter.colour.at(x, m_y) = colourOfFragment(painter, m_rank, x, m_y);
}

}  // namespace zscope::plain
