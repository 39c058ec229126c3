// Whole faces, as they were read, in the edge table: of any number of corners, concave or with holes.
//
// By ears    a face whose triangles turn different ways once snapped is entered triangle by triangle
//            (core/geometry/face_set_up.h says when)
#pragma once

#include "core/plain/work.h"

namespace zscope::plain {

/// Every face that may reach the stripe.
void enterFaces(Work& work);

}  // namespace zscope::plain
