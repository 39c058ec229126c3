// A node of the two-level hierarchy where it stands in the scene: in the tree over the instances, or in the tree over
// the triangles of one instance's mesh.
#pragma once

#include "core/base/ids.h"
#include "core/geometry/stripe_volume.h"
#include "core/hierarchy/tree.h"

namespace zscope::plain {

struct PlacedNode {
    const TreeNode* node   = nullptr;
    const TreeNode* holder = nullptr;  // of mesh trees: the node of the tree over the instances that holds `instance`
    InstanceId      instance{};        // of mesh trees
    StripeVolume::Planes open = StripeVolume::kAll;  // planes of the stripe that the node may cross

    bool isInstanceTree() const { return holder == nullptr; }
};

}  // namespace zscope::plain
