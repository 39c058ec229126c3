// What every hard case is put through: all exact algorithms against the reference, its twins, and its counters.
//
// U1   agreedPicture()         every preset, thread count and vector target draws the reference's picture
// U2   expectShuffledTwin()    the order of the triangles decides nothing but ties
// U5   expectCounters()        the triangles' fates add up and are those that the reference found
//      expectScaledTwin() and others: changes that must leave the picture as it is
// Source     docs/correctness.md, Hard cases
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/frame/renderer.h"
#include "core/measure/reference.h"
#include "core/scene/scene.h"
#include "tests/agreement/exact_grid.h"

namespace zscope::hardcase {

/// A scene ready to be drawn as its default view shows it.
struct HardCase {
    std::string                          word;  // for messages
    std::shared_ptr<const Scene>         scene;
    std::shared_ptr<const PreparedScene> prepared;
    Camera                               camera;

    const Mesh& mesh() const { return *scene->meshes.front(); }  // hard cases have one mesh, placed once
    int         width() const { return camera.width; }
    int         height() const { return camera.height; }
};

/// The case of builtin:hard/`word`, such as "A2?diagonal=rising". Throws (the test fails) if there is none.
HardCase hardCase(const std::string& word);
/// A scene made from parts, under a name for messages.
HardCase hardCase(const std::string& word, Scene parts, const Camera& camera);
/// The same mesh with other positions, triangles or camera.
HardCase changed(const HardCase& original, const std::string& how, const Camera& camera,
                 const std::function<void(std::vector<dvec3>&                        positions,
                                          std::vector<std::array<std::uint32_t, 3>>& triangles)>& edit);
/// Only the triangles that `isKept` says; they get new ids.
HardCase only(const HardCase& original, const std::function<bool(std::uint32_t id)>& isKept);

/// How many of the presets, and of the combinations of threads and vector targets for each, are drawn.
enum class Effort {
    All,         // every preset that claims to be exact with every combination
    EachPreset,  // every such preset with one combination, another one at each call
    Some,        // four of the presets with one combination each, others at the next call; for cases of many scenes
};

/// The reference's picture, after every exact preset has been held against it, bit for bit, or by face.
Picture agreedPicture(const HardCase& hard, Effort effort = Effort::All, FaceCulling culling = FaceCulling::None);

/// Counters by name, of the z-buffer, after those of every preset were checked: they add up, are the fates that the
/// reference finds, and no method draws or tests more than the z-buffer; those that cull nothing do exactly the same.
std::map<std::string, std::uint64_t> expectCounters(const HardCase& hard, FaceCulling culling = FaceCulling::None);

/// How exactly a twin's depths must be those of the original.
enum class TwinDepth { Same, WithinOneStep };

/// Positions, eye, near and far times 2^exponent: the same bits.
void expectScaledTwin(const HardCase& hard, const Picture& picture, int exponent);
/// A picture larger by whole pixels on all sides holds the original in its middle. Moving the picture's origin may
/// round a slanted plane differently, by a float32 step at most.
void expectShiftedTwin(const HardCase& hard, const Picture& picture, TwinDepth depth = TwinDepth::Same);
/// Every face turned round. A triangle whose first corner lies behind the near plane is cut from another corner on,
/// which may round its depth differently.
void expectReversedTwin(const HardCase& hard, const Picture& picture, TwinDepth depth = TwinDepth::Same);
/// Triangles in another order: the same depths, and the same triangles except where their depths are equal.
void expectShuffledTwin(const HardCase& hard, const Picture& picture, std::uint64_t seed = 1);
/// All of them.
void expectTwins(const HardCase& hard, const Picture& picture, TwinDepth depth = TwinDepth::Same);

/// No pixel is covered by two triangles. (Of two different ids one bit differs: the triangles with that bit and those
/// without it are drawn apart, and a pixel shown by both is covered twice.)
void expectCoveredAtMostOnce(const HardCase& hard);

/// The first pixel where two coverages differ fails the test.
void expectCoverage(const Grid<int>& expected, const Grid<int>& actual, const std::string& what);

/// The triangles as pixelCamera() sees them, by plain division: exact where z is a power of two.
std::vector<GridTriangle> gridTriangles(const HardCase& hard);
/// The picture shows what exact arithmetic on gridTriangles() says, wherever that is clear.
void expectWinners(const HardCase& hard, const Picture& picture);

/// Steps of float32 from a to b, both positive.
std::int64_t depthSteps(float a, float b);

}  // namespace zscope::hardcase
