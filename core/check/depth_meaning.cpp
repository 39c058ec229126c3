#include "core/check/depth_meaning.h"

#include <algorithm>
#include <cmath>

namespace zscope::check {
namespace {

constexpr std::array<std::string_view, 7> kWords{"near/z",          "z",     "distance", "ndc", "window",
                                                 "window-reversed", "linear"};

/// From a value of a binary format with so many fraction bits to the next; `least`: the smallest exponent.
double stepAt(double magnitude, int fractionBits, int least)
{
    int exponent = least;
    if (magnitude > 0 && std::isfinite(magnitude)) exponent = std::max(std::ilogb(magnitude), least);
    return std::ldexp(1.0, exponent - fractionBits);
}
double float32StepAt(double magnitude) { return stepAt(magnitude, 23, -126); }

}  // namespace

std::string_view wordOf(DepthMeaning meaning) { return kWords[static_cast<std::size_t>(meaning)]; }

std::optional<DepthMeaning> depthMeaningOf(std::string_view word)
{
    for (const DepthMeaning meaning : kDepthMeanings)
        if (wordOf(meaning) == word) return meaning;
    return std::nullopt;
}

double DepthResolution::at(double value) const
{
    const double magnitude = std::abs(value);
    switch (format) {
        case DepthNumberFormat::Float16:
            return stepAt(magnitude, 10, -14);
        case DepthNumberFormat::Float32:
            return float32StepAt(magnitude);
        case DepthNumberFormat::Float64:
            return stepAt(magnitude, 52, -1022);
        case DepthNumberFormat::Fixed:
            break;
    }
    return 1 / steps;
}

DepthScale::DepthScale(const Camera& camera, DepthMeaning meaning)
    : m_meaning(meaning), m_near(camera.near), m_far(camera.far),
      m_range(std::isinf(camera.far) ? 1 : camera.far / (camera.far - camera.near)), m_halfWidth(camera.width * 0.5),
      m_halfHeight(camera.height * 0.5), m_scale(camera.height * 0.5 * camera.focal)
{}

bool DepthScale::isPossible() const { return m_meaning != DepthMeaning::Linear || std::isfinite(m_far); }

double DepthScale::rayAt(int x, int y) const
{
    return std::hypot(1.0, (x + 0.5 - m_halfWidth) / m_scale, (y + 0.5 - m_halfHeight) / m_scale);
}

DepthValue DepthScale::of(double depth, int x, int y) const
{
    const double nearPart = std::isinf(m_far) ? 0 : m_near / (m_far - m_near);
    const double z = m_near / depth, zSlope = z / depth;
    switch (m_meaning) {
        case DepthMeaning::NearOverZ:
            return {depth, 1, depth};
        case DepthMeaning::Z:
            return {z, zSlope, z};
        case DepthMeaning::Distance: {
            const double ray = rayAt(x, y);
            return {z * ray, zSlope * ray, z * ray};
        }
        case DepthMeaning::Ndc:
            return {m_range + nearPart - 2 * m_range * depth, 2 * m_range, m_range + nearPart};
        case DepthMeaning::Window:
            return {m_range * (1 - depth), m_range, m_range};
        case DepthMeaning::WindowReversed:
            return {m_range * depth - nearPart, m_range, std::max(m_range * depth, nearPart)};
        case DepthMeaning::Linear:
            break;
    }
    const double length = m_far - m_near;
    return {(z - m_near) / length, zSlope / length, z / length};
}

double DepthScale::depthOf(double value, int x, int y) const
{
    const double nearPart = std::isinf(m_far) ? 0 : m_near / (m_far - m_near);
    switch (m_meaning) {
        case DepthMeaning::NearOverZ:
            return value;
        case DepthMeaning::Z:
            return m_near / value;
        case DepthMeaning::Distance:
            return m_near / value * rayAt(x, y);
        case DepthMeaning::Ndc:
            return (m_range + nearPart - value) / (2 * m_range);
        case DepthMeaning::Window:
            return 1 - value / m_range;
        case DepthMeaning::WindowReversed:
            return (value + nearPart) / m_range;
        case DepthMeaning::Linear:
            break;
    }
    return m_near / (m_near + value * (m_far - m_near));
}

double toleranceOf(const DepthValue& value, double depth, double slack, const DepthResolution& resolution)
{
    return resolution.at(value.value) + 4 * float32StepAt(value.terms)
           + value.slope * (4 * float32StepAt(depth) + slack);
}

}  // namespace zscope::check
