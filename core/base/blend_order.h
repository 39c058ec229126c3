// In which order the transparent surfaces of a pixel are laid over its opaque colour.
#pragma once

namespace zscope {

enum class BlendOrder {
    Sorted,         // from far to near by (depth, -id): right wherever surfaces cross
    BackThenFront,  // back faces, then front faces, each as submitted: what renderers do that keep no list
};

}  // namespace zscope
