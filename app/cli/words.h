// Words of the command line turned into values, all or nothing: no trailing characters, no NaN, no overflow.
//
// Errors     Usage, naming the option and what it wants
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/affine.h"
#include "core/base/result.h"

namespace zscope::cli {

/// A whole number in [min, max].
Result<std::int64_t> wholeNumber(std::string_view text, std::string_view option, std::int64_t min, std::int64_t max);
/// A decimal or C hex float; infinity only where the option allows it.
enum class Infinity { Refused, Allowed };
Result<double> realNumber(std::string_view text, std::string_view option, Infinity infinity = Infinity::Refused);
/// "x,y,z", finite.
Result<dvec3> vector(std::string_view text, std::string_view option);
/// "WxH", whole numbers; whether a picture can have that size is makeCamera()'s business.
struct PictureSize {
    int width, height;
};
Result<PictureSize> pictureSize(std::string_view text, std::string_view option);

/// "a,b,c"; empty parts are kept, so that they are noticed.
std::vector<std::string> listOf(std::string_view text);

/// "unknown algorithm 'x': choose a, b or c"
Error unknownWord(std::string_view kind, std::string_view word, const std::vector<std::string>& valid);

}  // namespace zscope::cli
