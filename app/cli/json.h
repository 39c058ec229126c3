// JSON as the command line writes it: keys in the order they were said, two spaces, a newline at the end.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/stages.h"
#include "core/scene/mesh.h"

namespace zscope::cli {

using Json = nlohmann::ordered_json;

/// Text that is no UTF-8 (a file name may be any bytes) has its bad bytes replaced.
inline std::string textOf(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

inline Json jsonOf(const dvec3& v) { return Json::array({v.x, v.y, v.z}); }

/// null for a box without anything in it.
inline Json jsonOf(const Bounds& box)
{
    if (box.isEmpty()) return nullptr;
    return Json{{"min", jsonOf(box.min)}, {"max", jsonOf(box.max)}};
}

inline Json jsonOf(const std::vector<NamedCount>& counts)
{
    Json json = Json::object();
    for (const NamedCount& count : counts) json[count.name] = count.value;
    return json;
}

}  // namespace zscope::cli
