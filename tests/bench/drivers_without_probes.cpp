// How the statements go: `probe(Event{...});` is a call, so a macro of that name removes every one of them from the
// very text that everybody else compiles. Headers of other libraries come first and stay as they are. A probe type of
// its own keeps the templates made here apart from those of the library.
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <variant>
#include <vector>

#include <hwy/base.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

// Events take values with them when they go.
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#ifndef probe
#define probe(...) static_cast<void>(probe)
#endif

#include "tests/bench/drivers_without_probes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/drivers_without_probes.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/frame/drivers-inl.h"
#include "core/probe/probe.h"

#ifndef ZSCOPE_STATEMENTS_REMOVED
#define ZSCOPE_STATEMENTS_REMOVED
namespace zscope::bench {
struct StatementsRemoved : NoProbe {};
}  // namespace zscope::bench
#endif

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

void drawStripeSilently(const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch, StageClock& clock)
{
    drawStripe(pipeline, stripe, scratch, clock, ExactRules{}, bench::StatementsRemoved{});
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zscope {

HWY_EXPORT(drawStripeSilently);

void bench::drawStripeWithoutProbes(const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch,
                                    StageClock& clock)
{
    HWY_DYNAMIC_DISPATCH(drawStripeSilently)(pipeline, stripe, scratch, clock);
}

}  // namespace zscope

#endif  // HWY_ONCE
