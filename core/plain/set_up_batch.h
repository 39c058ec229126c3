// Set-up of a batch: its vertices go to view space; each triangle is cut at the near plane, projected, snapped, and
// kept if it covers a pixel centre of the stripe.
//
// Result     Scratch::triangles, in the batch's order; the parts of a cut triangle keep its id
// Source     docs/correctness.md, The arithmetic, written out
#pragma once

#include "core/plain/work.h"

namespace zscope {
struct BatchPlace;
}

namespace zscope::plain {

void setUpBatch(Call work, const BatchPlace& place);

}  // namespace zscope::plain
