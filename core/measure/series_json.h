// A series as JSON, column by column, for the rows of a benchmark and the way back.
#pragma once

#include <nlohmann/json.hpp>

#include "core/measure/series.h"

namespace zscope {

nlohmann::ordered_json toJson(const Series& series);
/// What toJson() made. Throws nlohmann's exceptions where it is something else.
Series seriesOf(const nlohmann::ordered_json& json);

}  // namespace zscope
