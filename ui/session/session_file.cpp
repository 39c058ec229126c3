// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include "core/frame/faults.h"
#include "core/io/json_document.h"
#include "core/scene/view_json.h"
#include "ui/session/examiner.h"
#include "ui/session/tracer.h"

namespace zscope::ui {
namespace {

constexpr int kVersion = 1;

struct OverEntry {
    const char* word;
    bool Layers::*part;
};
constexpr std::array kOver{OverEntry{"line", &Layers::line},       OverEntry{"edges", &Layers::edges},
                           OverEntry{"ghost", &Layers::ghost},     OverEntry{"triangle", &Layers::triangle},
                           OverEntry{"query", &Layers::query},     OverEntry{"boxes", &Layers::boxes},
                           OverEntry{"pyramid", &Layers::pyramid}, OverEntry{"grid", &Layers::grid},
                           OverEntry{"marks", &Layers::marks},     OverEntry{"magnifier", &Layers::magnifier}};
constexpr std::array<std::string_view, 5> kShows{"a", "b", "wipe", "difference", "side-by-side"};  // by CompareShow
constexpr std::array<std::string_view, 4> kLinks{"step", "line", "stage", "pixel"};                // by Link
constexpr std::array<std::string_view, 4> kBreaks{"line", "pixel", "node", "triangle"};            // by Breakpoint::On

// Writing -----------------------------------------------------------------------------------------------------------

std::string textJson(const QString& value) { return zscope::quoted(value.toStdString()); }
std::string numberJson(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest).toStdString();
}
const char* truth(bool value) { return value ? "true" : "false"; }

std::string algorithmJson(const Pipeline& pipeline)
{
    std::string json;
    for (const AxisEntry& axis : axes())
        json += (json.empty() ? "{" : ", ") + quoted(axis.word) + ": " + quoted(chosen(pipeline, axis.word));
    if (!pipeline.fault.isEmpty()) json += ", \"fault\": " + zscope::quoted(wordsOf(pipeline.fault));
    return json + "}";
}

std::string nodeJson(const NodeName& node)
{
    return "{\"path\": " + zscope::quoted(node.path)
           + (node.instance ? ", \"instance\": " + std::to_string(node.instance->value) : "") + "}";
}

std::string pixelJson(int x, int y) { return "[" + std::to_string(x) + ", " + std::to_string(y) + "]"; }

std::string breakpointJson(const Breakpoint& breakpoint)
{
    const std::string_view on   = kBreaks[static_cast<std::size_t>(breakpoint.on)];
    const auto             what = [&]() -> std::string {
        switch (breakpoint.on) {
            case Breakpoint::On::Line:
                return std::to_string(breakpoint.line);
            case Breakpoint::On::Pixel:
                return pixelJson(breakpoint.pixel.x, breakpoint.pixel.y);
            case Breakpoint::On::Node:
                return nodeJson(breakpoint.node);
            case Breakpoint::On::Triangle:
                return std::to_string(breakpoint.triangle.value);
        }
        return "0";
    };
    return "{" + quoted(on) + ": " + what() + "}";
}

std::string bookmarkJson(const Bookmark& mark)
{
    return "{\"name\": " + textJson(mark.name) + ", \"grain\": " + quoted(zscope::wordOf(mark.grain))
           + ", \"step\": " + std::to_string(mark.step) + ",\n   \"algorithm\": " + algorithmJson(mark.pipeline) + "}";
}

/// A path as it is written into a session.
QString placeFrom(const QString& path, const QString& sessionFile)
{
    const QString below = QFileInfo(sessionFile).absoluteDir().relativeFilePath(path);
    return below.startsWith("..") || QDir::isAbsolutePath(below) ? path : below;
}
QString pathOf(const QString& place, const QString& sessionFile)
{
    return QFileInfo(sessionFile).absoluteDir().absoluteFilePath(place);
}

template <class Values, class Json>
std::string listJson(const Values& values, const Json& json)
{
    std::string all;
    for (const auto& value : values) all += (all.empty() ? "[" : ",\n  ") + json(value);
    return all.empty() ? "[]" : all + "]";
}

std::string bytes(const QByteArray& value) { return zscope::quoted(value.toBase64().toStdString()); }

// Reading -----------------------------------------------------------------------------------------------------------

/// Keeps the first thing that was wrong; what is read after it does not matter.
class Reader {
public:
    explicit Reader(std::string file) : m_file(std::move(file)) {}

    const std::string&          file() const { return m_file; }
    const std::optional<Error>& error() const { return m_error; }
    void                        wrong(const JsonValue& value, std::string sentence)
    {
        if (!m_error) m_error = Error{Trouble::Input, std::move(sentence), m_file, value.line};
    }
    template <class Value>
    Value take(Result<Value> made)
    {
        if (made) return std::move(made).value();
        if (!m_error) m_error = made.error();
        return Value{};
    }

    const JsonValue::Object& object(const JsonValue& value, std::string_view what)
    {
        static const JsonValue::Object kNothing;
        if (value.object()) return *value.object();
        wrong(value, "'" + std::string(what) + "' must be an object");
        return kNothing;
    }
    const JsonValue::Array& list(const JsonValue& value, std::string_view what)
    {
        static const JsonValue::Array kNothing;
        if (value.array()) return *value.array();
        wrong(value, "'" + std::string(what) + "' must be a list");
        return kNothing;
    }
    std::string textOf(const JsonValue& value, std::string_view what)
    {
        if (value.text()) return *value.text();
        wrong(value, "'" + std::string(what) + "' must be text");
        return {};
    }
    bool truthOf(const JsonValue& value, std::string_view what)
    {
        if (value.truth()) return *value.truth();
        wrong(value, "'" + std::string(what) + "' must be true or false");
        return false;
    }
    std::int64_t whole(const JsonValue& value, std::string_view what, std::int64_t max = std::int64_t{1} << 62)
    {
        return take(wholeOf(value, m_file, what, 0, max));
    }
    template <std::size_t N>
    std::size_t oneOf(const JsonValue& value, std::string_view what, const std::array<std::string_view, N>& words)
    {
        const std::string word = textOf(value, what);
        const auto        at   = std::ranges::find(words, word);
        if (at == words.end()) wrong(value, "'" + std::string(what) + "' cannot be '" + word.substr(0, 60) + "'");
        return at == words.end() ? 0 : static_cast<std::size_t>(at - words.begin());
    }
    void unknown(const JsonValue& value, std::string_view where, const std::string& key)
    {
        wrong(value, std::string(where) + " has no '" + key.substr(0, 60) + "'");
    }

private:
    std::string          m_file;
    std::optional<Error> m_error;
};

Pipeline algorithmOf(Reader& read, const JsonValue& value)
{
    Pipeline pipeline = findPreset("zbuffer")->pipeline;
    for (const auto& [axis, choice] : read.object(value, "algorithm")) {
        if (axis == "fault") {
            if (const std::optional<FaultSet> faults = findFaults(read.textOf(choice, axis)))
                pipeline.fault = *faults;
            else
                read.wrong(choice, "there is no such fault");
            continue;
        }
        if (std::ranges::find(axes(), axis, &AxisEntry::word) == axes().end()) {
            read.unknown(choice, "an algorithm", axis);
            continue;
        }
        const auto with = withChoice(pipeline, axis, read.textOf(choice, axis));
        if (!with)
            read.wrong(choice, with.error().text());
        else
            pipeline = *with;
    }
    if (const auto why = explainInvalid(pipeline)) read.wrong(value, *why);
    return pipeline;
}

Grain grainIn(Reader& read, const JsonValue& value)
{
    const std::string word  = read.textOf(value, "grain");
    const auto        grain = grainOf(word);
    if (!grain) read.wrong(value, "there is no grain '" + word.substr(0, 60) + "'");
    return grain.value_or(Grain::Frame);
}

QPoint pixelOf(Reader& read, const JsonValue& value, std::string_view what)
{
    const auto& pair = read.list(value, what);
    if (pair.size() != 2) {
        read.wrong(value, "'" + std::string(what) + "' must be [x, y]");
        return {};
    }
    return {static_cast<int>(read.whole(pair[0], what, kMaxPictureSide - 1)),
            static_cast<int>(read.whole(pair[1], what, kMaxPictureSide - 1))};
}

NodeName nodeOf(Reader& read, const JsonValue& value)
{
    NodeName node;
    for (const auto& [key, part] : read.object(value, "node")) {
        if (key == "path")
            node.path = read.textOf(part, key);
        else if (key == "instance")
            node.instance = InstanceId{static_cast<std::uint32_t>(read.whole(part, key, 0xFFFFFFFF))};
        else
            read.unknown(part, "a node", key);
    }
    return node;
}

TriangleId triangleOf(Reader& read, const JsonValue& value)
{
    return {static_cast<std::uint32_t>(read.whole(value, "triangle", static_cast<std::int64_t>(kMaxTriangles)))};
}

Breakpoint breakpointOf(Reader& read, const JsonValue& value)
{
    Breakpoint  breakpoint;
    const auto& members = read.object(value, "breakpoint");
    if (members.size() != 1) {
        read.wrong(value, "a breakpoint must have one of line, pixel, node and triangle");
        return breakpoint;
    }
    const auto& [on, what] = members.front();
    if (on == "line") {
        breakpoint.on   = Breakpoint::On::Line;
        breakpoint.line = static_cast<int>(read.whole(what, on, kMaxPictureSide - 1));
    } else if (on == "pixel") {
        const QPoint pixel = pixelOf(read, what, on);
        breakpoint.on      = Breakpoint::On::Pixel;
        breakpoint.pixel   = {pixel.x(), pixel.y()};
    } else if (on == "node") {
        breakpoint.on   = Breakpoint::On::Node;
        breakpoint.node = nodeOf(read, what);
    } else if (on == "triangle") {
        breakpoint.on       = Breakpoint::On::Triangle;
        breakpoint.triangle = triangleOf(read, what);
    } else {
        read.unknown(what, "a breakpoint", on);
    }
    return breakpoint;
}

Bookmark bookmarkOf(Reader& read, const JsonValue& value)
{
    Bookmark mark;
    for (const auto& [key, part] : read.object(value, "bookmark")) {
        if (key == "name")
            mark.name = QString::fromStdString(read.textOf(part, key));
        else if (key == "grain")
            mark.grain = grainIn(read, part);
        else if (key == "step")
            mark.step = static_cast<std::uint64_t>(read.whole(part, key));
        else if (key == "algorithm")
            mark.pipeline = algorithmOf(read, part);
        else
            read.unknown(part, "a bookmark", key);
    }
    return mark;
}

DepthRange rangeOf(Reader& read, const JsonValue& value)
{
    DepthRange range;
    for (const auto& [key, part] : read.object(value, "range")) {
        if (key == "automatic")
            range.isAutomatic = read.truthOf(part, key);
        else if (key == "logarithmic")
            range.isLogarithmic = read.truthOf(part, key);
        else if (key == "farthest")
            range.farthest = static_cast<float>(read.take(realOf(part, read.file(), key)));
        else if (key == "nearest")
            range.nearest = static_cast<float>(read.take(realOf(part, read.file(), key)));
        else
            read.unknown(part, "a range", key);
    }
    return range;
}

void readCompare(Reader& read, const JsonValue& value, SessionFile& session)
{
    for (const auto& [key, part] : read.object(value, "compare")) {
        if (key == "algorithm")
            session.other = algorithmOf(read, part);
        else if (key == "files")
            for (const JsonValue& file : read.list(part, key))
                session.theirs << QString::fromStdString(read.textOf(file, key));
        else if (key == "show")
            session.show = static_cast<CompareShow>(read.oneOf(part, key, kShows));
        else if (key == "follows")
            session.link = static_cast<Link>(read.oneOf(part, key, kLinks));
        else if (key == "linked")
            session.isLinked = read.truthOf(part, key);
        else if (key == "wipe")
            session.wipe = std::clamp(read.take(realOf(part, read.file(), key)), 0.0, 1.0);
        else if (key == "tolerance")
            session.tolerance = static_cast<std::uint32_t>(read.whole(part, key, 1'000'000'000));
        else
            read.unknown(part, "a comparison", key);
    }
}

WindowLayout layoutOf(Reader& read, const JsonValue& value)
{
    WindowLayout layout;
    const auto   bytesOf = [&](const JsonValue& part, std::string_view what) {
        return QByteArray::fromBase64(QByteArray::fromStdString(read.textOf(part, what)));
    };
    for (const auto& [key, part] : read.object(value, "layout")) {
        if (key == "geometry")
            layout.geometry = bytesOf(part, key);
        else if (key == "state")
            layout.state = bytesOf(part, key);
        else if (key == "name")
            layout.name = QString::fromStdString(read.textOf(part, key));
        else if (key == "hidden")
            for (const JsonValue& word : read.list(part, key))
                layout.hidden << QString::fromStdString(read.textOf(word, key));
        else
            read.unknown(part, "a layout", key);
    }
    return layout;
}

void readMember(Reader& read, const std::string& key, const JsonValue& value, SessionFile& session)
{
    if (key == "zscope-session")
        read.take(wholeOf(value, read.file(), key, kVersion, kVersion));
    else if (key == "scene")
        session.scene = QString::fromStdString(read.textOf(value, key));
    else if (key == "camera")
        session.camera = read.take(cameraOf(value, read.file()));
    else if (key == "cull")
        session.faceCulling = read.oneOf(value, key, std::array<std::string_view, 2>{"none", "back"}) == 0
                                  ? FaceCulling::None
                                  : FaceCulling::Back;
    else if (key == "algorithm")
        session.pipeline = algorithmOf(read, value);
    else if (key == "grain")
        session.grain = grainIn(read, value);
    else if (key == "step") {
        if (!value.text())
            session.step = static_cast<std::uint64_t>(read.whole(value, key));
        else if (*value.text() != "end")
            read.wrong(value, "'step' must be a number or \"end\"");
    } else if (key == "picked")
        session.selection.picked = pixelOf(read, value, key);
    else if (key == "node")
        session.selection.node = nodeOf(read, value);
    else if (key == "triangle")
        session.selection.triangle = triangleOf(read, value);
    else if (key == "level")
        session.selection.level = static_cast<int>(read.whole(value, key, 32));
    else if (key == "layer") {
        const std::string word  = read.textOf(value, key);
        const auto        layer = std::ranges::find(layers(), word, &Layer::word);
        if (layer == layers().end())
            read.wrong(value, "there is no layer '" + word.substr(0, 60) + "'");
        else
            session.look.layer = &*layer;
    } else if (key == "range")
        session.look.range = rangeOf(read, value);
    else if (key == "over") {
        for (const auto& [word, part] : read.object(value, key)) {
            const auto over = std::ranges::find(kOver, std::string_view(word),
                                                [](const OverEntry& entry) { return std::string_view(entry.word); });
            if (over == kOver.end())
                read.unknown(part, "'over'", word);
            else
                session.layers.*(over->part) = read.truthOf(part, word);
        }
    } else if (key == "compare")
        readCompare(read, value, session);
    else if (key == "trace")
        session.trace = QString::fromStdString(read.textOf(value, key));
    else if (key == "bookmarks")
        for (const JsonValue& mark : read.list(value, key))
            session.selection.marks.bookmarks.push_back(bookmarkOf(read, mark));
    else if (key == "breakpoints")
        for (const JsonValue& on : read.list(value, key))
            session.selection.marks.breakpoints.push_back(breakpointOf(read, on));
    else if (key == "layout")
        session.layout = layoutOf(read, value);
    else
        read.unknown(value, "a session", key);
}

}  // namespace

std::optional<SessionFile> sessionFileOf(const Session& session)
{
    const Snapshot& now = session.now();
    if (!now.scene) return {};
    SessionFile file;
    file.scene       = now.scene->word;
    file.camera      = now.camera;
    file.faceCulling = session.settings().faceCulling;
    file.pipeline    = now.pipeline;
    file.grain       = now.grain;
    if (const auto at = session.position(); at && at->step + 1 < at->count) file.step = at->step;
    file.selection = {now.picked, now.selectedNode, now.selectedTriangle, now.selectedLevel, now.marks};
    file.selection.marks.history.reset();
    file.look   = now.look;
    file.layers = now.layers;
    file.other  = now.compare.other;
    if (now.compare.theirs) file.theirs = session.examiner().files();
    if (const TheirTrace* trace = session.tracer().trace()) file.trace = trace->file;
    file.show      = now.compare.show;
    file.link      = now.compare.link;
    file.isLinked  = now.compare.isLinked;
    file.wipe      = now.compare.wipe;
    file.tolerance = now.compare.tolerance;
    return file;
}

std::string sessionToJson(const SessionFile& session, const QString& file)
{
    QString scene = session.scene;
    if (!scene.startsWith("builtin:")) scene = placeFrom(scene, file);
    const Selection& of   = session.selection;
    std::string      json = "{\"zscope-session\": " + std::to_string(kVersion) + ",\n \"scene\": " + textJson(scene)
                       + ",\n \"camera\": " + cameraToJson(session.camera);
    while (!json.empty() && json.back() == '\n') json.pop_back();
    const auto add = [&json](std::string_view key, const std::string& value) {
        json += ",\n " + quoted(key) + ": " + value;
    };
    add("cull", session.faceCulling == FaceCulling::Back ? "\"back\"" : "\"none\"");
    add("algorithm", algorithmJson(session.pipeline));
    add("grain", quoted(zscope::wordOf(session.grain)));
    add("step", session.step ? std::to_string(*session.step) : "\"end\"");
    if (of.picked) add("picked", pixelJson(of.picked->x(), of.picked->y()));
    if (of.node) add("node", nodeJson(*of.node));
    if (of.triangle) add("triangle", std::to_string(of.triangle->value));
    if (of.level) add("level", std::to_string(*of.level));
    add("layer", quoted(session.look.layer->word));
    const DepthRange& range = session.look.range;
    add("range", std::string("{\"automatic\": ") + truth(range.isAutomatic) + ", \"logarithmic\": "
                     + truth(range.isLogarithmic) + ", \"farthest\": " + numberJson(static_cast<double>(range.farthest))
                     + ", \"nearest\": " + numberJson(static_cast<double>(range.nearest)) + "}");
    std::string over;
    for (const OverEntry& entry : kOver)
        over += (over.empty() ? "{" : ", ") + quoted(entry.word) + ": " + truth(session.layers.*entry.part);
    add("over", over + "}");
    const auto placeJson = [&](const QString& path) { return textJson(placeFrom(path, file)); };
    if (session.other || !session.theirs.isEmpty())
        add("compare", "{\"show\": " + quoted(kShows[static_cast<std::size_t>(session.show)]) + ", \"wipe\": "
                           + numberJson(session.wipe) + ", \"tolerance\": " + std::to_string(session.tolerance)
                           + ", \"linked\": " + truth(session.isLinked)
                           + ", \"follows\": " + quoted(kLinks[static_cast<std::size_t>(session.link)])
                           + (session.other ? ",\n  \"algorithm\": " + algorithmJson(*session.other)
                                            : ",\n  \"files\": " + listJson(session.theirs, placeJson))
                           + "}");
    if (!session.trace.isEmpty()) add("trace", placeJson(session.trace));
    add("bookmarks", listJson(of.marks.bookmarks, bookmarkJson));
    add("breakpoints", listJson(of.marks.breakpoints, breakpointJson));
    if (!session.layout.state.isEmpty())
        add("layout", "{\"geometry\": " + bytes(session.layout.geometry) + ",\n  \"state\": "
                          + bytes(session.layout.state) + ",\n  \"name\": " + textJson(session.layout.name)
                          + ",\n  \"hidden\": " + listJson(session.layout.hidden, textJson) + "}");
    return json + "}\n";
}

Result<SessionFile> sessionFromJson(const std::string& json, const QString& file)
{
    const std::string name     = file.toStdString();
    const auto        document = parseJson(json, name);
    if (!document) return document.error();
    Reader      read(name);
    SessionFile session;
    const auto& members = read.object(*document, "session");
    for (const char* needed : {"zscope-session", "scene", "camera"})
        if (std::ranges::find(members, std::string_view(needed), &JsonMember::first) == members.end())
            read.wrong(*document, std::string("this is no session: its '") + needed + "' is missing");
    session.pipeline = findPreset(kDefaultPreset)->pipeline;
    for (const auto& [key, value] : members) readMember(read, key, value, session);
    if (!read.error()) {
        const std::vector<Grain> grains = grainsOf(session.pipeline);
        if (std::ranges::find(grains, session.grain) == grains.end())
            read.wrong(*document, nameOf(session.pipeline) + " has no steps of grain '"
                                      + std::string(zscope::wordOf(session.grain)) + "'");
    }
    if (read.error()) return *read.error();
    if (!session.scene.startsWith("builtin:")) session.scene = pathOf(session.scene, file);
    for (QString& theirs : session.theirs) theirs = pathOf(theirs, file);
    if (!session.trace.isEmpty()) session.trace = pathOf(session.trace, file);
    return session;
}

void restore(Session& session, const SessionFile& file)
{
    session.player().setPlaying(false);
    session.compareWith({});
    session.tracer().close();
    session.setPipeline(file.pipeline);
    session.setGrain(file.grain);
    session.setFaceCulling(file.faceCulling);
    session.setLayer(*file.look.layer);
    session.setDepthRange(file.look.range);
    session.setLayers(file.layers);
    session.open(file.scene, Session::seenBy(file.camera, file.faceCulling));
    if (file.step) session.startAt(*file.step);
    session.startWith(file.selection);
    session.linkBy(file.link);
    session.linkSteps(file.isLinked);
    session.setTolerance(file.tolerance);
    session.setWipe(file.wipe);
    session.compareWith(file.other);
    session.showCompared(file.show);
    if (!file.theirs.isEmpty()) session.examiner().openWith(file.theirs, file.show, file.scene);
    if (!file.trace.isEmpty()) session.tracer().openWith(file.trace, file.scene);
}

}  // namespace zscope::ui
