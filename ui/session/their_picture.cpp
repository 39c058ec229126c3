// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/their_picture.h"

#include <algorithm>
#include <cmath>

#include "core/lesson/colour_maps.h"

namespace zscope::ui {
namespace {

using check::CheckAnswer;
using check::IdKind;
using check::Mistake;
using check::Verdict;

constexpr std::uint32_t kSame = 0xFFFFFFFF, kSameBackground = 0xFFF3F5F8, kRounding = 0xFFCBD1DA;

/// 0 is kept for background.
std::uint32_t rankOf(std::int64_t id) { return std::max(1u, static_cast<std::uint32_t>(id + 1)); }

VisibilityBuffer bufferOf(const CheckAnswer& answer)
{
    constexpr float         kLeast = 1e-30f, kUnknown = 0.5f;
    const check::Shown&     shown  = answer.shown;
    const Camera&           camera = answer.camera;
    const check::DepthScale scale(camera, shown.meaning);
    VisibilityBuffer        buffer;
    buffer.resize(camera.width, camera.height, {});
    buffer.clearRows(0, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            if (!shown.covered.at(x, y)) continue;
            std::int64_t id = shown.ids ? shown.ids->at(x, y) : 0;
            if (shown.ids && shown.kind == IdKind::Faces && id >= 0 && id < answer.truth->faces.count())
                id = answer.truth->faces.trianglesOf(id).first;
            float depth = kUnknown;
            if (shown.depth) {
                const double of = scale.depthOf(shown.depth->at(x, y), x, y);
                depth           = of > 0 ? static_cast<float>(std::min(of, 1.0)) : kLeast;  // NaN is not larger
            }
            buffer.row(y)[x] = keyOf(std::max(depth, kLeast), rankOf(id));
        }
    return buffer;
}

/// Whether the files have what a layer shows.
bool holds(const CheckAnswer& answer, const Layer& layer)
{
    return (layer.word == "depth" && answer.shown.depth) || (layer.word == "ids" && answer.shown.ids);
}

/// What the files show at a pixel held against what A shows there.
class PixelComparison {
public:
    PixelComparison(const VisibilityBuffer& a, bool byFaces, const CheckAnswer& answer)
        : m_a(a), m_byFaces(byFaces), m_answer(answer), m_scale(answer.camera, answer.shown.meaning)
    {}

    /// Whether A is the reference there, in what the verdict is about.
    bool isRight(const Verdict& verdict, int x, int y) const
    {
        const Picture&     right = m_answer.truth->picture;
        const std::int64_t id = m_a.idAt(x, y), expected = right.ids.at(x, y);
        if ((id < 0) != (expected < 0)) return false;
        if (id < 0) return true;
        if (!areSame(id, expected)) return false;
        const bool isOfSurface = !verdict.isSame() && verdict.mistake() != Mistake::WrongDepth;
        return isOfSurface || stepsBetween(m_a.depthAt(x, y), right.depth.at(x, y)) <= 2;
    }
    PixelDifference byVerdict(const Verdict& verdict, int x, int y) const
    {
        if (!verdict.isWrong()) return PixelDifference::None;
        switch (verdict.mistake()) {
            case Mistake::Hole:
                return PixelDifference::Hole;
            case Mistake::Spill:
                return PixelDifference::Spill;
            case Mistake::WrongSurface:
                return PixelDifference::Surface;
            case Mistake::WrongDepth:
                break;
        }
        return ofDepth(x, y);
    }
    PixelDifference plain(int x, int y) const
    {
        const check::Shown& shown   = m_answer.shown;
        const std::int64_t  id      = m_a.idAt(x, y);
        const bool          isShown = shown.covered.at(x, y) != 0;
        if (id < 0 || !isShown)
            return id < 0 && !isShown ? PixelDifference::None
                   : isShown          ? PixelDifference::Spill
                                      : PixelDifference::Hole;
        if (shown.ids && !hasId(shown.ids->at(x, y), id)) return PixelDifference::Surface;
        if (!shown.depth) return PixelDifference::None;
        const double            depth = static_cast<double>(m_a.depthAt(x, y));
        const check::DepthValue value = m_scale.of(depth, x, y);
        const double most = check::toleranceOf(value, depth, m_answer.truth->slack.at(x, y), shown.resolution);
        return std::abs(shown.depth->at(x, y) - value.value) <= most ? PixelDifference::None : ofDepth(x, y);
    }

private:
    bool areSame(std::int64_t a, std::int64_t b) const
    {
        const auto& faces = m_answer.truth->faces;
        return m_byFaces ? faces.faceOf(a) == faces.faceOf(b) : faces.areOneSurface(a, b);
    }
    bool hasId(std::int64_t shown, std::int64_t id) const
    {
        const auto& faces = m_answer.truth->faces;
        if (m_answer.shown.kind == IdKind::Faces) return faces.faceOf(id) == shown;
        const auto triangles = static_cast<std::int64_t>(m_answer.truth->scene->scene().triangleCount());
        return shown >= 0 && shown < triangles && areSame(shown, id);
    }
    PixelDifference ofDepth(int x, int y) const
    {
        const double theirs = m_scale.depthOf(m_answer.shown.depth->at(x, y), x, y);
        return theirs > static_cast<double>(m_a.depthAt(x, y)) ? PixelDifference::DepthNearer
                                                               : PixelDifference::DepthFarther;
    }

    const VisibilityBuffer& m_a;
    bool                    m_byFaces;
    const CheckAnswer&      m_answer;
    check::DepthScale       m_scale;
};

}  // namespace

const Layer& layerFor(const CheckAnswer& answer, const Layer& onShow)
{
    if (holds(answer, onShow)) return onShow;
    return *findLayer(answer.shown.ids ? "ids" : answer.shown.depth ? "depth" : "shaded");
}

void paint(TheirPicture& theirs, const Look& look)
{
    theirs.look = look;
    if (theirs.picture && !holds(*theirs.answer, *look.layer)) {
        theirs.painted = *theirs.picture;
        return;
    }
    theirs.painted = layerFor(*theirs.answer, *look.layer).paint({.frame = *theirs.frame, .range = look.range});
}

Result<Done> fill(TheirPicture& theirs, const TheirFiles& files)
{
    const CheckAnswer& answer = *theirs.answer;
    auto               frame  = std::make_shared<Frame>();
    frame->visible            = bufferOf(answer);
    theirs.frame              = std::move(frame);
    if (!files.picture) return Done{};
    auto colours = check::readPicture(*files.picture, answer.camera.width, answer.camera.height);
    if (!colours) return colours.error();
    auto picture = std::make_shared<Grid<std::uint32_t>>(std::move(colours).value());
    if (answer.conventions.rows == check::Rows::BottomUp)
        for (int y = 0; y < picture->height() / 2; ++y)
            std::ranges::swap_ranges(picture->view().row(y), picture->view().row(picture->height() - 1 - y));
    for (std::uint32_t& colour : picture->values()) colour |= 0xFF000000u;
    theirs.picture = std::move(picture);
    return Done{};
}

TheirPixel theirPixel(const TheirPicture& theirs, const QPoint& pixel)
{
    const CheckAnswer&  answer = *theirs.answer;
    const check::Shown& shown  = answer.shown;
    const int           x = pixel.x(), y = pixel.y();
    const std::int64_t  right = answer.truth->picture.ids.at(x, y);
    const int           from  = answer.conventions.idsFrom.value_or(0);
    TheirPixel          at;
    at.verdict    = answer.verdicts.at(x, y);
    at.isCovered  = shown.covered.at(x, y) != 0;
    at.isExpected = right >= 0;
    if (shown.ids && at.isCovered) at.id = shown.ids->at(x, y) + from;
    if (at.isExpected)
        at.expectedId = (shown.ids && shown.kind == IdKind::Faces ? answer.truth->faces.faceOf(right) : right)
                        + (shown.ids ? from : 0);
    if (!shown.depth) return at;
    if (at.isCovered) at.depth = shown.depth->at(x, y);
    const check::DepthScale scale(answer.camera, shown.meaning);
    if (at.isExpected)
        at.expectedDepth = scale.of(static_cast<double>(answer.truth->picture.depth.at(x, y)), x, y).value;
    return at;
}

TheirDifference differenceOf(const VisibilityBuffer& a, bool byFaces, const TheirPicture& theirs)
{
    const CheckAnswer&    answer = *theirs.answer;
    const PixelComparison comparison(a, byFaces, answer);
    TheirDifference       result;
    Difference&           difference = result.difference;
    difference.kinds.reset(a.width(), a.height(), PixelDifference::None);
    difference.heat.reset(a.width(), a.height(), kSame);
    PixelDifference worst = PixelDifference::None;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const Verdict         verdict    = answer.verdicts.at(x, y);
            const bool            isRight    = comparison.isRight(verdict, x, y);
            const PixelDifference kind       = isRight ? comparison.byVerdict(verdict, x, y) : comparison.plain(x, y);
            const bool            isRounding = isRight && verdict.isRounding();
            result.rounding += isRounding;
            ++difference.counts[static_cast<std::size_t>(kind)];
            difference.kinds.at(x, y) = kind;
            std::uint32_t& colour     = difference.heat.at(x, y);
            if (kind >= PixelDifference::Surface)
                colour = kWrongColour;
            else if (kind != PixelDifference::None)
                colour = diverging(kind == PixelDifference::DepthNearer ? 1 : -1);
            else if (isRounding)
                colour = kRounding;
            else if (a.idAt(x, y) < 0)
                colour = kSameBackground;
            if (kind > worst) worst = kind, difference.worst = {x, y};
        }
    return result;
}

}  // namespace zscope::ui
