// What the sentence of an event may need beyond the event: facts of the whole run, at the moment of the event.
//
// Use        Event::sentence(const Telling&), made only where somebody reads it: when a run stops at its step
// Cost       nothing until it is asked; coveredPixels() looks at every pixel
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/ids.h"
#include "core/probe/words.h"

namespace zscope {

class Telling {
public:
    virtual ~Telling() = default;

    /// Whole faces are drawn, as they were read.
    virtual bool drawsFaces() const = 0;
    /// Triangles of the scene.
    virtual std::uint64_t triangles() const = 0;
    /// Pixels that something covers.
    virtual std::uint64_t coveredPixels() const = 0;
    /// Pixels that the triangle reached last has won.
    virtual std::uint64_t pixelsWon() const = 0;
    /// The depth that a pixel holds where nothing covers it.
    virtual float background() const = 0;

    /// What is drawn.
    std::string_view polygon() const { return drawsFaces() ? "face" : "triangle"; }
    std::string_view polygons() const { return drawsFaces() ? "faces" : "triangles"; }
    /// "triangle 1,234"
    std::string nameOf(TriangleId id) const { return std::string(polygon()) + ' ' + grouped(std::uint64_t{id.value}); }
};

}  // namespace zscope
