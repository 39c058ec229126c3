// The plain text of a stripe: the pipeline's words become a method, its pass and its parts.
#pragma once

#include "core/base/blend_order.h"
#include "core/frame/pipeline.h"
#include "core/plain/work.h"

namespace zscope {

class ColourTable;
class TransparentSurfaces;

/// The opaque picture of the stripe: ids and depths, and the colours of fragments that are shaded as they come. Every
/// pixel of the stripe may be read afterwards. Errors: std::bad_alloc.
void drawPlainly(const Pipeline& pipeline, plain::Work& work);

/// Transparent surfaces over the stripe's finished colours.
void blendPlainly(const TransparentSurfaces& surfaces, const ColourTable& colours, BlendOrder order, plain::Work& work,
                  GridView<std::uint32_t> colour);

}  // namespace zscope
