// What culling tells: the verdict over every node and triangle that was asked about.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/ids.h"
#include "core/cull/after_drawing.h"
#include "core/depth/pyramid.h"
#include "core/hierarchy/tree.h"
#include "core/probe/about.h"
#include "core/probe/grain.h"
#include "core/probe/meaning.h"
#include "core/probe/telling.h"

namespace zscope {

enum class Verdict { Outside, Hidden, Entered, Small };  // Small: dropped, as an approximation

constexpr std::string_view wordOf(Verdict verdict)
{
    constexpr std::array<std::string_view, 4> words{"outside", "hidden", "entered", "small"};
    return words[static_cast<std::size_t>(verdict)];
}

namespace fates {
inline constexpr PixelFate kTriangleHidden{"triangle-hidden", "hidden by the pyramid, one by one", FateKind::Hidden, 1,
                                           true};
inline constexpr PixelFate kNodeHidden{"node-hidden", "hidden with a node", FateKind::Hidden, 2, true};
inline constexpr PixelFate kNodeOutside{"node-outside", "in a node outside the view", FateKind::LeftOut, 0, true};
inline constexpr PixelFate kNodeSmall{"node-small", "in a node that is too small", FateKind::LeftOut, 1, true};
}  // namespace fates

/// Which node of which tree: the tree over the instances, or the mesh tree of one instance.
struct NodePlace {
    bool            isInstanceTree;
    InstanceId      instance;  // of mesh trees
    const Tree&     tree;      // valid until the scene is given up, like the next
    const TreeNode& node;
};
/// "node 0.3 of instance 12", "node 0.3 of the instances".
std::string nameInWords(const NodePlace& place);

/// One of the passes over the scene begins; methods that need a single one do not say so.
struct PassStarted {
    int pass;  // 1: what the last frame saw; 2: everything, against what the first left
};

/// A node that was visible in the last frame and reaches the view is about to be drawn, its own triangles, unasked.
struct NodeRecalled {
    static constexpr Grain grain = Grain::Node;
    NodePlace              place;  // in the mesh tree of an instance
    const Tree&            instances;
    const TreeNode&        holder;  // the node of `instances` that holds the instance

    About       about() const { return {.node = &place}; }
    std::string sentence(const Telling&) const;
    void        mean(Meanings& to) const;
};

/// A node has been judged. `query` is what the pyramid was asked, or nullptr if it was not.
struct NodeJudged {
    static constexpr Grain grain = Grain::Node;
    NodePlace              place;
    Verdict                verdict;
    const PyramidQuery*    query;           // valid only during the call
    int                    pass;            // of two passes: 2; 0: there is only one
    bool                   isDrawnAhead;    // the first of two passes has drawn it
    bool                   asksAboutNodes;  // the pass does, where it can

    About about() const
    {
        return {
            .node = &place, .verdict = wordOf(verdict), .hidden = query ? std::optional(query->hidden) : std::nullopt};
    }
    std::string sentence(const Telling&) const;
    void        mean(Meanings& to) const;
};

/// An entered node's children are known and wait, in the order in which they will be visited.
struct NodeOpened {
    NodePlace                        place;
    std::span<const TreeNode* const> children;  // valid only during the call
};

/// The pyramid has been asked about a node or a triangle; what follows from it has not happened yet.
struct PyramidAsked {
    static constexpr Grain grain = Grain::Query;
    const PyramidQuery&    query;       // valid only during the call, like the next
    const NodePlace*       node;        // nullptr: it was a triangle
    TriangleId             triangle;    // of a triangle
    bool                   isOneLevel;  // no finer level is asked (an approximation)
    AfterDrawing           upkeep;

    About about() const
    {
        return {.triangle = node ? std::nullopt : std::optional(triangle), .node = node, .hidden = query.hidden};
    }
    std::string sentence(const Telling&) const;
    void        mean(Meanings& to) const;
};

/// A cell of the pyramid has been computed anew.
struct CellUpdated {
    static constexpr Grain grain = Grain::Update;
    CellWrite              write;
    AfterDrawing           upkeep;

    About       about() const { return {.level = write.level}; }
    std::string sentence(const Telling&) const;
};

/// A node's own triangles (or instances) are about to be drawn.
struct NodeDrawn {
    NodePlace place;
};

/// The pyramid says of a triangle that is set up that it cannot win a pixel.
struct TriangleHidden {
    TriangleId          triangle;
    const PyramidQuery& query;  // valid only during the call
};

/// The pyramid was asked about a triangle and let it through.
struct TrianglePassed {
    TriangleId          triangle;
    const PyramidQuery& query;  // valid only during the call
};

}  // namespace zscope
