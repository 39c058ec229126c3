#include "core/lesson/checkpoints.h"

#include <algorithm>
#include <cassert>

namespace zscope {

const KeptState* Checkpoints::lastBefore(Grain grain, std::uint64_t seen) const
{
    const auto after = std::ranges::partition_point(
        kept, [&](const auto& each) { return each->state.recorders.steps.seen(grain) <= seen; });
    return after == kept.begin() ? nullptr : std::prev(after)->get();
}

void CheckpointKeeper::keepIn(Checkpoints& checkpoints, std::uint64_t events, std::size_t bytes)
{
    m_keepsIn   = &checkpoints;
    m_apart     = events;
    m_nextAt    = 0;  // the first at once
    m_mostBytes = bytes;
}

void CheckpointKeeper::beginAt(const KeptState& from, const Checkpoints& checkpoints)
{
    m_from        = &from;
    m_checkpoints = &checkpoints;
    m_run.scratch.memory.restore(from.state.memory);
}

bool CheckpointKeeper::passesBy(Checkpoint at)
{
    if (!m_byBatches && at == Checkpoint::Batch) return false;  // what is being set up is half complete
    const std::uint64_t place = m_places++;
    if (m_from) {
        if (place < m_from->place) return true;
        restore();
    } else if (m_keepsIn && (m_events >= m_nextAt || at == Checkpoint::AllSetUp)) {
        keep(place);
    }
    return false;
}

void CheckpointKeeper::keep(std::uint64_t place)
{
    const plain::Scratch& scratch = m_run.scratch;
    auto&                 kept    = m_keepsIn->kept;
    auto                  now     = std::make_unique<const KeptState>(KeptState{
        place,
        m_keepsIn->verdicts.size(),
        {m_run.recorders, m_run.frame.visible, m_run.frame.colour, scratch.pyramid, scratch.active, scratch.memory}});
    m_bytes += now->state.bytes();
    kept.push_back(std::move(now));
    while (m_bytes > m_mostBytes && !kept.empty()) {  // the first stays longest: behind it the edge table is full
        std::size_t left = 0;
        for (std::size_t i = 0; i < kept.size() && kept.size() > 1; i += 2) kept[left++] = std::move(kept[i]);
        kept.resize(left);
        m_bytes = 0;
        for (const auto& each : kept) m_bytes += each->state.bytes();
        m_apart *= 2;
    }
    m_nextAt = m_events + m_apart;
}

void CheckpointKeeper::restore()
{
    const RunState& state = m_from->state;
    assert(m_nextVerdict == m_from->verdicts);
    m_run.recorders     = state.recorders;
    m_run.frame.visible = state.visible;  // as large as it is: nothing moves that is being looked at
    m_run.frame.colour  = state.colour;
    m_run.scratch.pyramid.restore(state.pyramid);
    m_run.scratch.active = state.active;
    m_run.stop.beginAfter(state.recorders.steps.seen(m_run.stopGrain));
    m_from = nullptr;
}

}  // namespace zscope
