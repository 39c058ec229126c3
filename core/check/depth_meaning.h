// What a number in a foreign depth buffer means, and how close it has to be to the true one.
//
// True       near/z as the reference has it (D, in (0, 1])
// Tolerance  one step of the file's format, four float32 steps of the largest number that is added up on the way, and
//            what the caller allows D, times how fast the number changes with D
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/scene/view.h"

namespace zscope::check {

/// In the order in which equally good guesses are preferred.
enum class DepthMeaning { NearOverZ, Z, Distance, Ndc, Window, WindowReversed, Linear };
inline constexpr std::array kDepthMeanings{DepthMeaning::NearOverZ, DepthMeaning::Z,      DepthMeaning::Distance,
                                           DepthMeaning::Ndc,       DepthMeaning::Window, DepthMeaning::WindowReversed,
                                           DepthMeaning::Linear};

/// "near/z", "z", ...
std::string_view            wordOf(DepthMeaning meaning);
std::optional<DepthMeaning> depthMeaningOf(std::string_view word);

/// Integers are fractions of their largest value, so they cannot hold distances.
constexpr bool fitsFractions(DepthMeaning meaning)
{
    return meaning == DepthMeaning::Window || meaning == DepthMeaning::WindowReversed || meaning == DepthMeaning::Linear
           || meaning == DepthMeaning::NearOverZ;
}

/// Numbers of a file: how finely they are told apart.
enum class DepthNumberFormat { Float16, Float32, Float64, Fixed };
struct DepthResolution {
    DepthNumberFormat format = DepthNumberFormat::Float32;
    double            steps  = 1;  // of Fixed: 1 is so many

    double at(double value) const;  // one step of the format
};

struct DepthValue {
    double value = 0;
    double slope = 0;  // of the value by D, without sign
    double terms = 0;  // the largest number that is added up
};

class DepthScale {
public:
    DepthScale(const Camera& camera, DepthMeaning meaning);

    /// False: nothing has this meaning, because there is no far plane.
    bool isPossible() const;
    /// Of depth D at pixel (x, y).
    DepthValue of(double depth, int x, int y) const;
    /// The other way round: near/z of a value at pixel (x, y), whatever it comes to.
    double depthOf(double value, int x, int y) const;

private:
    /// Length of the ray through the centre of a pixel, for z = 1.
    double rayAt(int x, int y) const;

    DepthMeaning m_meaning;
    double       m_near, m_far, m_range;  // far/(far - near); 1 without a far plane
    double       m_halfWidth, m_halfHeight, m_scale;
};

/// `slack`: of D, absolute, beside its float32 steps.
double toleranceOf(const DepthValue& value, double depth, double slack, const DepthResolution& resolution);

}  // namespace zscope::check
