#include "core/method/warnock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <vector>

#include <fmt/format.h>

#include "core/plain/coverage.h"
#include "core/plain/depth_test.h"
#include "core/plain/set_up_all.h"
#include "core/probe/words.h"

namespace zscope::plain {

namespace {

constexpr Pass   kNearestOfWindow{};
constexpr double kLead     = 0x1p-20;  // relative: eight float32 steps
constexpr double kRounding = 0x1p-48;  // of a plane's terms: far above what float64 rounds

struct Window {
    PixelBox    pixels;
    std::size_t first, end;  // Windows::m_lists: the triangles that meet the window it was cut from
};

/// The windows that wait, the next one on top.
class Windows {
public:
    Windows(Work& work, std::span<const ScreenTriangle> triangles) : m_memory(work.stripe.memory)
    {
        for (const ScreenTriangle& triangle : triangles) m_lists.push_back(&triangle);
        if (const PixelBox all = work.stripe.region(); !all.isEmpty()) m_waiting.push_back({all, 0, m_lists.size()});
    }

    bool pop(Window& window)
    {
        if (m_waiting.empty()) return false;
        window = m_waiting.back();
        m_waiting.pop_back();
        return true;
    }

    /// Puts them behind the list of the window that this one was cut from. Valid until the next call.
    std::span<const ScreenTriangle* const> thoseThatMeet(Window& window)
    {
        m_lists.resize(window.end);  // what lies behind belongs to windows that are decided
        for (std::size_t i = window.first; i < window.end; ++i)
            if (!Coverage(*m_lists[i]).isOutside(window.pixels)) m_lists.push_back(m_lists[i]);
        if (m_lists.capacity() * sizeof(m_lists[0]) > m_memory) throw std::bad_alloc();
        window = {window.pixels, window.end, m_lists.size()};
        return std::span(m_lists).subspan(window.first);
    }

    /// In four; in two where it is one pixel wide or high.
    void divide(const Window& window)
    {
        const PixelBox&               w = window.pixels;
        const int                     x = w.x0 + (w.x1 - w.x0) / 2, y = w.y0 + (w.y1 - w.y0) / 2;
        const std::array<PixelBox, 4> parts{
            {{x, y, w.x1, w.y1}, {w.x0, y, x, w.y1}, {x, w.y0, w.x1, y}, {w.x0, w.y0, x, y}}};
        for (const PixelBox& part : parts)
            if (!part.isEmpty()) m_waiting.push_back({part, window.first, window.end});
    }

private:
    std::vector<Window>                m_waiting;
    std::vector<const ScreenTriangle*> m_lists;
    std::uint64_t                      m_memory;
};

/// A triangle's plane at the corners of a window.
struct CornerDepths {
    std::array<double, 4> depth;
    double                error;  // of each, and of any pixel between

    CornerDepths(const DepthPlane& p, const PixelBox& w)
        : error(kRounding * (std::abs(p.a) * w.x1 + std::abs(p.b) * w.y1 + std::abs(p.c)))
    {
        std::size_t i = 0;
        for (const int y : {w.y0, w.y1 - 1})
            for (const int x : {w.x0, w.x1 - 1}) depth[i++] = p.a * (x + 0.5) + (p.b * (y + 0.5) + p.c);
    }
    /// The plane stays within the depths of the triangle's corners, but for their rounding to float32.
    bool areWithin(const DepthPlane& p) const
    {
        return std::ranges::all_of(
            depth, [&p](double z) { return z >= p.farthest * (1 - 0x1p-23) && z <= p.nearest * (1 + 0x1p-23); });
    }
    double farthest() const { return *std::ranges::min_element(depth); }
};

/// Whether `leader`, which surrounds the window, is nearer than `other` at each of its pixels.
bool leads(const CornerDepths& leader, const ScreenTriangle& other, const PixelBox& window)
{
    if (leader.farthest() * (1 - kLead) - leader.error > other.depth.nearest) return true;
    const CornerDepths rival(other.depth, window);
    if (!rival.areWithin(other.depth)) return false;
    for (std::size_t i = 0; i < leader.depth.size(); ++i)
        if (!(leader.depth[i] * (1 - kLead) - leader.error > rival.depth[i] + rival.error)) return false;
    return true;
}

/// The triangle that surrounds the window in front of all others; nullptr: none does for certain.
const ScreenTriangle* leaderOf(const Work& work, const PixelBox& window, std::span<const ScreenTriangle* const> meeting)
{
    if (!work.rules.comparesByEnds()) return nullptr;
    const ScreenTriangle* best  = nullptr;
    double                depth = 0;  // of the best, at its farthest corner
    for (const ScreenTriangle* triangle : meeting) {
        const double farthest = CornerDepths(triangle->depth, window).farthest();
        if (triangle->patterned || (best && farthest <= depth) || !Coverage(*triangle).surrounds(window)) continue;
        best  = triangle;
        depth = farthest;
    }
    if (!best) return nullptr;
    const CornerDepths corners(best->depth, window);
    const bool         isKept = depth * (1 - kLead) - corners.error > work.stripe.visible.empty();  // the far test
    const bool         isFirst =
        isKept && corners.areWithin(best->depth) && std::ranges::all_of(meeting, [&](const ScreenTriangle* other) {
            return other == best || leads(corners, *other, window);
        });
    return isFirst ? best : nullptr;
}

void fill(Work& work, const ScreenTriangle& leader, const PixelBox& window)
{
    work.tell(TriangleReached{leader});
    DepthTest test(work, kNearestOfWindow, leader.depth, leader.id, false);
    for (int y = window.y0; y < window.y1; ++y) {
        test.beginLine(y, window.x0);
        for (int x = window.x0; x < window.x1; ++x) test.store(x);
    }
}

void testEach(Work& work, std::span<const ScreenTriangle* const> meeting, int x, int y)
{
    for (const ScreenTriangle* triangle : meeting) {
        work.tell(TriangleReached{*triangle});
        DepthTest test(work, kNearestOfWindow, triangle->depth, triangle->id, triangle->patterned);
        test.beginLine(y, x);
        test.offer(x);
    }
}

}  // namespace

void subdivide(Work& work, const Parts& parts)
{
    const std::vector<ScreenTriangle> triangles = setUpAll(work, parts);
    Windows                           windows(work, triangles);
    for (Window window; windows.pop(window) && !work.isCancelled();) {
        const auto            meeting = windows.thoseThatMeet(window);
        const bool            isPixel = window.pixels.area() == 1;
        const ScreenTriangle* leader  = isPixel ? nullptr : leaderOf(work, window.pixels, meeting);
        const WindowVerdict   verdict = meeting.empty() ? WindowVerdict::Empty
                                        : leader        ? WindowVerdict::Surrounded
                                        : isPixel       ? WindowVerdict::Pixel
                                                        : WindowVerdict::Divided;
        if (verdict == WindowVerdict::Divided) windows.divide(window);
        if (verdict != WindowVerdict::Divided && !work.leavesOut(Checkpoint::Piece)) {
            if (leader) fill(work, *leader, window.pixels);
            if (isPixel) testEach(work, meeting, window.pixels.x0, window.pixels.y0);
        }
        work.tell(WindowJudged{window.pixels, verdict, meeting, leader});
    }
}

// What the event says ---------------------------------------------------------------------------------------------

namespace {

constexpr PixelFate kWindowLost{"window-lost", "behind the nearest of a window", FateKind::Behind, 3, true};

/// As the picture stores it where rules are exact.
float depthAt(const DepthPlane& plane, PixelPosition p)
{
    const double z = plane.a * (p.x + 0.5) + (plane.b * (p.y + 0.5) + plane.c);
    return static_cast<float>(std::min(std::max(z, double{plane.farthest}), double{plane.nearest}));
}

std::string nameOf(const PixelBox& w)
{
    return fmt::format("window ({}, {}) to ({}, {})", w.x0, w.y0, w.x1 - 1, w.y1 - 1);
}

}  // namespace

About WindowJudged::about() const
{
    About about{.pixels = window};
    if (leader) about.triangle = leader->id;
    return about;
}

std::string WindowJudged::sentence(const Telling& telling) const
{
    const std::string name = capital(nameOf(window));
    switch (verdict) {
        case WindowVerdict::Empty:
            return name + ": no triangle meets it, so it stays background.";
        case WindowVerdict::Surrounded:
            return fmt::format(
                "{}: {} surrounds it and is nearest at its four corners, of {} that meet it; so all of it "
                "is its own.",
                name, telling.nameOf(leader->id), counted(meeting.size(), "triangle", "triangles"));
        case WindowVerdict::Pixel:
            return fmt::format("{} is a single pixel: the depth test has decided between {}.", name,
                               counted(meeting.size(), "triangle", "triangles"));
        case WindowVerdict::Divided:
            break;
    }
    return fmt::format("{}: of {} that meet it none surrounds it in front of all others; so it is divided in four.",
                       name, counted(meeting.size(), "triangle", "triangles"));
}

void WindowJudged::mean(Meanings& to) const
{
    if (!leader || !to.asksAbout(window)) return;
    const Outcome won{.word = "window-won", .effect = Effect::Wins, .countedAs = {"window_won"}};
    to.of(leader->id, window, won, [&](TriangleId id, PixelPosition at) {
        return Meaning{
            .depth    = depthAt(leader->depth, at),
            .sentence = fmt::format("{} surrounds {} and is nearest at its four corners: all of it is its own.",
                                    capital(to.telling().nameOf(id)), nameOf(window))};
    });
    const Outcome lost{.word = "window-lost", .effect = Effect::Loses, .countedAs = {"window_lost"}};
    const auto    lostBy = [&](const ScreenTriangle& other, PixelPosition at) {
        const float own = depthAt(other.depth, at), nearest = depthAt(leader->depth, at);
        return Meaning{
               .depth      = own,
               .rival      = leader->id,
               .rivalDepth = nearest,
               .fate       = kWindowLost,
               .sentence   = fmt::format("{}, near/z {:.9g}, lies behind {} at {:.9g}, which surrounds {} in front of "
                                              "all others.",
                                         capital(to.telling().nameOf(other.id)), own, to.telling().nameOf(leader->id),
                                         nearest, nameOf(window))};
    };
    for (const ScreenTriangle* other : meeting)
        for (int y = window.y0; y < window.y1 && other != leader; ++y) {
            if (!to.asksAbout({window.x0, y, window.x1, y + 1})) continue;
            for (int x = window.x0; x < window.x1; ++x)
                if (const PixelBox here{x, y, x + 1, y + 1}; to.asksAbout(here) && Coverage(*other).covers(x, y))
                    to.of(other->id, here, lost, [&](TriangleId, PixelPosition at) { return lostBy(*other, at); });
        }
}

}  // namespace zscope::plain
