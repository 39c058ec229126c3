// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/snapshot.h"

#include <algorithm>

#include <QCoreApplication>

namespace zscope::ui {

int levelOnShow(const Snapshot& shown)
{
    const ShownStep* step = shown.stepOfPicture();
    if (!step || step->pyramid.levels.empty()) return -1;
    const int             top   = static_cast<int>(step->pyramid.levels.size()) - 1;
    const HierarchyState& of    = *step->state.hierarchy;
    const int             level = shown.selectedLevel                               ? *shown.selectedLevel
                                  : step->state.event == Grain::Update && of.update ? of.update->level
                                  : of.query                                        ? of.query->level
                                                                                    : Pyramid::kTileLevel;
    return std::clamp(level, 0, top);
}

bool isStale(const Snapshot& shown)
{
    const TheirPicture* theirs = shown.compare.theirs.get();
    return theirs && shown.scene && (theirs->scene != shown.scene->scene().digest || theirs->camera() != shown.camera);
}

QString nameOfOther(const CompareState& compare)
{
    if (compare.theirs) return compare.theirs->title;
    return compare.other ? QString::fromStdString(nameOf(*compare.other)) : QString();
}

bool isBeyondWipe(const Snapshot& shown, const QPoint& pixel)
{
    const VisibilityBuffer* other = shown.compare.seen() == CompareShow::Wipe ? shown.visibleOfOther() : nullptr;
    return other && pixel.x() + 0.5 >= shown.compare.wipe * other->width();
}

Snapshot asOther(const Snapshot& shown)
{
    Snapshot other       = shown;
    other.compare.isHeld = true;
    return other;
}

std::optional<PixelFacts> factsOf(const Snapshot& shown, const QPoint& pixel)
{
    const VisibilityBuffer* visible = isBeyondWipe(shown, pixel) ? shown.visibleOfOther() : shown.visible();
    if (!visible || pixel.x() < 0 || pixel.y() < 0 || pixel.x() >= visible->width() || pixel.y() >= visible->height())
        return {};

    PixelFacts facts;
    facts.pixel           = pixel;
    const std::int64_t id = visible->idAt(pixel.x(), pixel.y());
    if (visible == shown.visibleOfOther() && shown.compare.theirs) {
        const check::CheckAnswer& answer = *shown.compare.theirs->answer;
        facts.theirs                     = theirPixel(*shown.compare.theirs, pixel);
        if (id >= 0 && answer.conventions.ids == check::IdKind::Triangles && !isStale(shown)
            && static_cast<std::uint64_t>(id) < shown.scene->scene().triangleCount())
            facts.triangle = TriangleId{static_cast<std::uint32_t>(id)};
        return facts;
    }
    if (id < 0) return facts;
    facts.triangle = TriangleId{static_cast<std::uint32_t>(id)};
    facts.depth    = visible->depthAt(pixel.x(), pixel.y());
    facts.z        = shown.pictureCamera().near / static_cast<double>(facts.depth);

    // While a new scene is being drawn the picture may still be the old one's.
    if (!shown.scene || static_cast<std::uint64_t>(id) >= shown.scene->scene().triangleCount()) return facts;
    const Scene&      scene    = shown.scene->scene();
    const InstanceId  instance = scene.instanceOf(*facts.triangle);
    const Mesh&       mesh     = scene.meshOf(instance);
    const std::size_t inMesh   = facts.triangle->value - scene.firstTriangle[instance.value];
    const PolygonId   polygon  = mesh.trianglePolygon[inMesh];
    facts.polygon              = polygon.value;
    facts.group                = QString::fromStdString(mesh.groups[mesh.polygonGroup[polygon.value].value]);
    facts.material             = QString::fromStdString(mesh.materialOf(polygon).name);
    if (scene.instances.size() > 1) facts.instance = QString::number(instance.value);  // its number, like a triangle's
    return facts;
}

QString numbersAt(const Snapshot& shown, const QPoint& pixel)
{
    const auto facts = factsOf(shown, pixel);
    if (!facts) return {};
    if (!facts->theirs)
        return facts->triangle ? QString::number(facts->triangle->value) + '\n'
                                     + QString::number(static_cast<double>(facts->depth), 'f', 4)
                               : QString();
    QStringList lines;
    if (facts->theirs->id) lines << QString::number(*facts->theirs->id);
    if (facts->theirs->depth) lines << QString::number(*facts->theirs->depth, 'f', 4);
    return lines.join('\n');
}

std::optional<NodeName> nodeOfPick(const Snapshot& shown)
{
    const auto            triangle  = pickedTriangle(shown);
    const HierarchyState* hierarchy = shown.hierarchy();
    if (!triangle || !hierarchy || !hierarchy->tree || triangle->value >= shown.scene->scene().triangleCount())
        return {};
    const int id = nodeHolding(*triangle, hierarchy->nodes, *shown.scene->prepared, *hierarchy->tree);
    return id < 0 ? std::nullopt : std::optional(nameOf(hierarchy->nodes[static_cast<std::size_t>(id)]));
}

std::optional<TriangleId> pickedTriangle(const Snapshot& shown)
{
    if (shown.selectedTriangle) return shown.selectedTriangle;
    if (!shown.picked) return {};
    const auto facts = factsOf(shown, *shown.picked);
    return facts ? facts->triangle : std::nullopt;
}

}  // namespace zscope::ui
