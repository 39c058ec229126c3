// How wrong a picture is: what it shows against what the reference shows, pixel by pixel, in figures that mean the
// same for every method. An exact method has nothing but zeros here, and the same depth bits.
//
// Steps      float32 steps: how many values of the format lie from one depth to the other
// Near tie   another surface whose depth is at most kNearTieSteps away from the right one
// Figures    of no pixels at all are 0, and exactShare is 1: nothing is wrong with nothing
// Source     docs/correctness.md, What is promised, what is measured
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/depth/visibility_buffer.h"

namespace zscope {

inline constexpr std::uint32_t kNearTieSteps = 2;

/// Distribution of |reference depth / test depth - 1|; infinite where the test has depth 0 and the reference not.
struct RelativeDistance {
    double rms = 0;
    double p99 = 0;
    double max = 0;
};

struct ErrorFigures {
    std::uint64_t pixels           = 0;  // compared
    std::uint64_t covered          = 0;  // the reference shows a triangle
    std::uint64_t holes            = 0;  // ... and the test shows background
    std::uint64_t spills           = 0;  // the test shows a triangle where the reference shows background
    std::uint64_t nearTies         = 0;  // both show a triangle, another one, at most kNearTieSteps apart
    std::uint64_t realWrongSurface = 0;  // the same, farther apart
    std::uint64_t depthBitsDiffer  = 0;  // of all pixels

    double           exactShare    = 1;  // of the pixels that show the right triangle: those with the right depth bits
    std::uint32_t    p99DepthSteps = 0;  // on the same pixels
    std::uint32_t    maxDepthSteps = 0;
    RelativeDistance distanceOnSameSurface;
    RelativeDistance distanceOnWrongSurface;

    std::uint64_t lostTriangles = 0;  // visible in the reference, nowhere in the test
    /// What a wrong cull leaves in a picture: a lost triangle for which every one of its pixels shows something that
    /// the definition ranks behind it. A lost triangle that is hidden by a spill of another is not among them.
    std::uint64_t falseCulls = 0;

    std::uint64_t wrongCoverage() const { return holes + spills; }
    std::uint64_t wrongSurface() const { return nearTies + realWrongSurface; }
    std::uint64_t wrongPixels() const { return wrongCoverage() + wrongSurface(); }
    /// The largest relative depth error wherever both show a triangle.
    double worstDistance() const
    {
        return distanceOnSameSurface.max > distanceOnWrongSurface.max ? distanceOnSameSurface.max
                                                                      : distanceOnWrongSurface.max;
    }
    /// Same ids and same depth bits at every pixel compared.
    bool isExact() const { return wrongPixels() == 0 && depthBitsDiffer == 0; }
};

/// float32 steps between two depths (0 and up).
std::uint32_t stepsBetween(float a, float b);

/// Of several pictures as if they were one: counts add up, shares and root mean squares weigh by pixels, largest values
/// stay. What is larger than 99 % of the pixels of all is not known from those of each: the largest of these stands for
/// it.
ErrorFigures together(std::span<const ErrorFigures> pictures);

/// Both pictures must have the same size.
ErrorFigures compare(const Picture& reference, const Picture& test);

/// One pixel of the reference against the same pixel of the test.
struct PixelPair {
    std::int64_t referenceId = -1, testId = -1;
    float        referenceDepth = 0, testDepth = 0;
};
/// At some pixels only. `testIds` are the ids of the whole test picture: a triangle is lost only if it is in none.
ErrorFigures compare(std::span<const PixelPair> pixels, std::span<const std::int64_t> testIds);

}  // namespace zscope
