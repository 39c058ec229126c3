// Which side of a triangle the viewer sees, and whether that side is drawn.
//
// Turn       the sign of twice the snapped area: -1 counter-clockwise to the viewer, 0 without area, 1 clockwise
// Front      counter-clockwise; of a mirrored instance clockwise, because its corners run the other way round
// Source     docs/correctness.md, Scene and camera (mirrored instances), Coverage
#pragma once

#include "core/base/affine.h"
#include "core/scene/view.h"

namespace zscope {

struct Facing {
    FaceCulling culling    = FaceCulling::None;
    bool        isMirrored = false;  // the instance's matrix is (Affine::isMirrored)

    bool isFront(int turn) const { return isMirrored ? turn > 0 : turn < 0; }
    bool isBack(int turn) const { return isMirrored ? turn < 0 : turn > 0; }
    bool isCulled(int turn) const { return culling == FaceCulling::Back && isBack(turn); }
};

}  // namespace zscope
