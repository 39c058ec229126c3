// Views and cameras as JSON: in scene files, and as the file of --camera.
//
// View       {"size":[W,H],"eye":[3],"target":[3],"up":[3],"fov":degrees,"near":n,"far":F,"cull":"none"|"back"}, all
//            optional, or the ten numbers of a camera
// Camera     {"eye":[3],"right":[3],"up":[3],"forward":[3],"focal":c,"near":n,"far":F,"width":W,"height":H}, all needed
// Numbers    a JSON number, or a string holding a decimal, a C hex float, or inf; used as given
// Errors     Input with the line: an unknown or missing key, a wrong type or size, what explainInvalid() says
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/json_document.h"
#include "core/scene/view.h"

namespace zscope {

/// Three finite numbers; `what` names them in errors.
Result<dvec3> vectorOf(const JsonValue& value, const std::string& file, std::string_view what);

Result<Camera>      cameraOf(const JsonValue& document, const std::string& file);
Result<ViewRequest> viewOf(const JsonValue& document, const std::string& file);

}  // namespace zscope
