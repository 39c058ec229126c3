// Traces: our own steps are right, each kind of change is found at its row, an unsnapped sweep differs by rounding
// alone, and a file that is no trace is refused in one sentence.
#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/check/trace_beside.h"
#include "core/check/truth.h"
#include "core/io/phrase_book.h"
#include "core/lesson/replay.h"
#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

using Json = nlohmann::ordered_json;

DrawRequest requestFor(const std::string& word, const std::string& preset, int width = 64, int height = 48)
{
    const auto scene = preparedScene(word);
    return {.scene    = scene,
            .camera   = cameraOf(scene->scene(), width, height),
            .pipeline = findPreset(preset)->pipeline,
            .threads  = 1};
}

/// The states of all steps of a grain, or of every n-th.
std::vector<Json> statesOf(const DrawRequest& request, Grain grain, std::uint64_t every = 1)
{
    Replay            replay(request);
    const auto        count = replay.count(grain);
    std::vector<Json> rows;
    for (std::uint64_t step = 0; step < *count; step += every)
        rows.push_back(Json::parse(stateToJson(*replay.at(grain, StepIndex{step}), PyramidCells::Written)));
    return rows;
}

std::string linesOf(const std::vector<Json>& rows)
{
    std::string text;
    for (const Json& row : rows) text += row.dump() + '\n';
    return text;
}

/// What stands beside a row says the same as its sentence, and belongs to the same moment.
void expectBeside(const check::Trace& trace, const check::TraceAnswer& answer, const DrawRequest& request)
{
    constexpr std::size_t kOfEach = 3;  // of rows that differ, and of others
    check::TraceBeside    beside(std::make_shared<check::Trace>(trace), std::make_shared<check::TraceAnswer>(answer),
                                 request, check::halfStepOf(8));
    Replay                replay(request);
    std::size_t           wrong = 0, others = 0;
    for (std::size_t i = 0; i < answer.rows.size(); ++i) {
        const check::JudgedRow& row = answer.rows[i];
        if ((row.isWrong() ? wrong : others)++ >= kOfEach) continue;
        const auto fields = beside.row(i);
        ASSERT_TRUE(fields) << fields.error().text();
        check::Likeness worst = check::Likeness::Same;
        for (const check::FieldBeside& field : *fields) {
            if (field.depth == 0) worst = std::max(worst, field.likeness);
            EXPECT_FALSE(field.name.empty());
        }
        EXPECT_EQ(worst == check::Likeness::Differs, row.isWrong()) << row.sentence;
        EXPECT_EQ(worst == check::Likeness::Rounding, row.isRounding) << trace.textOf(trace.rows[i]);
        if (row.grain) {
            EXPECT_EQ(replay.at(*row.grain, row.step)->events, row.events);
        }
    }
}

check::TraceAnswer judged(const DrawRequest& request, const std::string& text)
{
    const auto trace = check::traceOf(text, "trace.jsonl");
    EXPECT_TRUE(trace) << trace.error().text();
    const auto answer = check::judgeTrace(*trace, request, check::halfStepOf(8));
    EXPECT_TRUE(answer);
    EXPECT_TRUE(chinesePhrases().text(answer->sentence)) << "not in the phrase book: " << answer->sentence;
    expectBeside(*trace, *answer, request);
    return *answer;
}

struct Way {
    std::string   preset;
    Grain         grain;
    std::uint64_t every = 1;
    std::string   scene = "builtin:cubes";
};
const std::vector<Way> kWays{{"scanline", Grain::Line},
                             {"scanline", Grain::Span, 5},
                             {"interval", Grain::Interval, 3},
                             {"interval-polygon", Grain::Line},
                             {"zbuffer", Grain::Pixel, 11},
                             {"zbuffer", Grain::Triangle},
                             {"edge-walk", Grain::Span, 7},
                             {"zbuffer-zcull", Grain::Query},
                             {"zbuffer-prepass", Grain::Triangle, 3},
                             {"quadtree", Grain::Query},
                             {"quadtree", Grain::Update},
                             {"hzb-octree", Grain::Node},
                             {"two-pass", Grain::Node, 3},
                             {"scanline", Grain::Pixel, 97, "builtin:glass"}};

TEST(Trace, OurOwnStepsAreRight)
{
    for (const Way& way : kWays) {
        const DrawRequest        request = requestFor(way.scene, way.preset);
        const auto               rows    = statesOf(request, way.grain, way.every);
        const check::TraceAnswer answer  = judged(request, linesOf(rows));
        EXPECT_EQ(answer.rows.size(), rows.size());
        EXPECT_GT(rows.size(), 5u) << way.preset;
        EXPECT_TRUE(answer.isRight()) << way.preset << ' ' << wordOf(way.grain) << ": " << answer.sentence;
        EXPECT_EQ(answer.rounding, 0u) << way.preset << ' ' << wordOf(way.grain);
    }
}

/// A program knows no steps of ours: rows say by what they hold where they belong.
TEST(Trace, RowsFindTheirMomentByWhatTheyHold)
{
    for (const auto& [preset, grain, field] :
         std::vector<std::tuple<std::string, Grain, std::string>>{{"scanline", Grain::Line, "line"},
                                                                  {"interval", Grain::Interval, "interval"},
                                                                  {"zbuffer", Grain::Pixel, "pixel"},
                                                                  {"zbuffer", Grain::Triangle, "triangle"},
                                                                  {"zbuffer-prepass", Grain::Triangle, "triangle"},
                                                                  {"quadtree", Grain::Query, "query"},
                                                                  {"quadtree", Grain::Update, "update"}}) {
        const DrawRequest request = requestFor("builtin:cubes", preset);
        std::vector<Json> rows;
        for (Json row : statesOf(request, grain, 1)) {
            const bool isOfGrain = row["event"] == std::string(wordOf(grain));
            for (const char* key : {"algorithm", "grain", "step", "count", "sentence", "event", "stage", "source"})
                row.erase(key);
            const bool isPixel = field == "pixel", isTriangle = field == "triangle";
            for (const char* key : {"nodes", "node"}) row.erase(key);
            if (!isPixel) row.erase("pixel");
            if (field != "query" && field != "update") row.erase("query");
            if (field != "update") row.erase("update");
            if (field == "update") row.erase("query");
            if (!isTriangle) row.erase("triangle");
            if (field == "line") row.erase("span");
            if (isOfGrain && row.contains(field) && !row[field].is_null()
                && (field != "query" || !row[field]["triangle"].is_null()))
                rows.push_back(row);
        }
        ASSERT_GT(rows.size(), 5u) << preset << ' ' << field;
        const check::TraceAnswer answer = judged(request, linesOf(rows));
        EXPECT_TRUE(answer.isRight()) << preset << ' ' << field << ": " << answer.sentence;
        for (const check::JudgedRow& row : answer.rows) EXPECT_EQ(row.grain, grain) << preset;
    }
}

/// One change of one row.
struct Change {
    std::string                    name;
    Way                            way;
    std::function<bool(Json& row)> make;  // false: this row cannot be changed so
    std::string                    says;  // a regular expression
};

Json* edgeOf(Json& row, std::size_t at) { return row["active_edges"].size() > at ? &row["active_edges"][at] : nullptr; }

const std::vector<Change>& changes()
{
    static const Way                 kLines{"scanline", Grain::Line}, kPixels{"zbuffer", Grain::Pixel, 11};
    static const std::vector<Change> kChanges{
        {"an edge that has left", kLines,
         [](Json& row) {
             if (row["left"].empty()) return false;
             row["active_edges"].push_back(row["left"][0]);
             return true;
         },
         "On line \\d+ your table still holds an edge of polygon \\d+, whose last line was \\d+\\."},
        {"the same, told by its polygon and place alone", kLines,
         [](Json& row) {
             if (row["left"].empty()) return false;
             const Json edge = row["left"][0];
             const Json left{{"polygon", edge["polygon"]}, {"x", edge["x"]}};
             row["active_edges"].push_back(left);
             return true;
         },
         "On line \\d+ your table still holds an edge of polygon \\d+, whose last line was \\d+\\."},
        {"an edge too early", kLines,
         [](Json& row) {
             if (!edgeOf(row, 0)) return false;
             Json edge          = *edgeOf(row, 0);
             edge["first_line"] = row["line"].get<int>() + 3;
             edge["last_line"]  = row["line"].get<int>() + 9;
             row["active_edges"].push_back(edge);
             return true;
         },
         "On line \\d+ your table already holds an edge of polygon \\d+, whose first line is \\d+\\."},
        {"an edge less", kLines,
         [](Json& row) {
             if (!edgeOf(row, 2)) return false;
             row["active_edges"].erase(2);
             return true;
         },
         "On line \\d+ your table lacks an edge of polygon \\d+ at x [-\\d.e]+; its lines are \\d+ to \\d+\\."},
        {"a wrong x", kLines,
         [](Json& row) {
             if (!edgeOf(row, 1)) return false;
             (*edgeOf(row, 1))["x"] = (*edgeOf(row, 1))["x"].get<double>() + 0.75;
             (*edgeOf(row, 1)).erase("x_subpixels");
             return true;
         },
         "On line \\d+ an edge of polygon \\d+ has x [-\\d.e]+ in your table, and [-\\d.e]+ in ours\\."},
        {"a wrong slope", kLines,
         [](Json& row) {
             if (!edgeOf(row, 1)) return false;
             Json& edge = *edgeOf(row, 1);
             if (edge["first_line"] == edge["last_line"]) return false;
             edge["dx"] = edge["dx"][0].get<double>() / edge["dx"][1].get<double>() + 2.5;
             return true;
         },
         ".* has dx .*"},
        {"a wrong last line", kLines,
         [](Json& row) {
             if (!edgeOf(row, 1)) return false;
             (*edgeOf(row, 1))["last_line"] = (*edgeOf(row, 1))["last_line"].get<int>() + 2;
             return true;
         },
         ".* has last_line .*"},
        {"a wrong order", kLines,
         [](Json& row) {
             if (row["active_edges"].size() < 6) return false;
             std::swap(row["active_edges"][0], row["active_edges"][5]);
             return true;
         },
         "On line \\d+ your table is not sorted by x: .*"},
        {"an edge of no polygon", kLines,
         [](Json& row) {
             if (!edgeOf(row, 0)) return false;
             row["active_edges"].push_back({{"polygon", 999999}, {"x", 3}});
             return true;
         },
         "On line \\d+ your table holds an edge of polygon 999999 at x 3, and ours does not\\."},
        {"an edge that did not enter", kLines,
         [](Json& row) {
             if (row["entered"].empty()) return false;
             row["entered"].erase(0);
             return true;
         },
         ".* your list of edges that entered lacks an edge of polygon .*"},
        {"a polygon too many", kLines,
         [](Json& row) {
             if (row["active_polygons"].size() < 2) return false;
             row["active_polygons"].push_back(999999);
             return true;
         },
         ".* polygon 999999 is active in your trace, and not in our run\\."},
        {"a polygon too few", kLines,
         [](Json& row) {
             if (row["active_polygons"].size() < 2) return false;
             row["active_polygons"].erase(1);
             return true;
         },
         ".* is active in our run, and not in your trace\\."},
        {"a span too long", kLines,
         [](Json& row) {
             if (row["spans"].empty() || row["spans"][0]["x1"].get<int>() > 55) return false;
             row["spans"][0]["x1"] = row["spans"][0]["x1"].get<int>() + 3;
             return true;
         },
         "On line \\d+ pixel \\d+ lies in a span of polygon \\d+ in your trace, and not in our run\\."},
        {"a span too few", kLines,
         [](Json& row) {
             if (row["spans"].size() < 2 || row["spans"][1]["x1"].get<int>() - row["spans"][1]["x0"].get<int>() < 3)
                 return false;
             row["spans"].erase(1);
             return true;
         },
         "On line \\d+ pixel \\d+ lies in a span of polygon \\d+ in our run, and not in your trace\\."},
        {"a span outside", kLines,
         [](Json& row) {
             row["spans"].push_back({{"x0", 60}, {"x1", 70}, {"polygon", 1}});
             return true;
         },
         "On line \\d+ a span of polygon 1 goes from pixel 60 to 69, and a line has pixels 0 to 63\\."},
        {"a wrong depth", kPixels,
         [](Json& row) {
             if (!row.contains("pixel")) return false;
             row["pixel"]["depth"] = row["pixel"]["depth"].get<double>() * 1.5;
             return true;
         },
         "At pixel \\(\\d+, \\d+\\), where triangle \\d+ is tested, 'depth' is .*"},
        {"another winner", kPixels,
         [](Json& row) {
             if (!row.contains("pixel")) return false;
             row["pixel"]["won"] = !row["pixel"]["won"].get<bool>();
             return true;
         },
         ".* your triangle (wins|loses), and ours (loses|wins): the pixel held (triangle \\d+|the background) at depth "
         ".*"},
        {"another rival", kPixels,
         [](Json& row) {
             if (!row.contains("pixel")) return false;
             row["pixel"]["rival"] = {{"triangle", 999999}, {"depth", 0.5}};
             return true;
         },
         ".* your pixel held triangle 999999 before, and ours (triangle \\d+|the background)\\."},
        {"more pixels won",
         {"zbuffer", Grain::Triangle},
         [](Json& row) {
             if (!row.contains("triangle")) return false;
             row["triangle"]["pixels_won"] = 123456;
             return true;
         },
         "After triangle \\d+ 'triangle.pixels_won' is 123456 in your trace, and \\d+ in our run\\."},
        {"a corner elsewhere",
         {"zbuffer", Grain::Triangle},
         [](Json& row) {
             if (!row.contains("triangle")) return false;
             row["triangle"]["corners"][1][0] = row["triangle"]["corners"][1][0].get<double>() + 0.5;
             return true;
         },
         "After triangle \\d+ a corner of your triangle is \\(.*\\), and none of ours\\."},
        {"a cell of the pyramid",
         {"quadtree", Grain::Triangle},
         [](Json& row) {
             if (!row.contains("pyramid") || row["pyramid"]["stored"].empty()) return false;
             row["pyramid"]["stored"][0]["farthest"][0][0] = 0.9;
             return true;
         },
         "After triangle \\d+ cell \\(0, 0\\) of level 3 is 0.9 in your pyramid, and .* in ours\\."},
        {"another verdict",
         {"quadtree", Grain::Query},
         [](Json& row) {
             if (!row.contains("query") || row["query"].is_null()) return false;
             row["query"]["verdict"] = row["query"]["verdict"] == "hidden" ? "entered" : "hidden";
             return true;
         },
         ".* 'query.verdict' is (hidden|entered) in your trace, and (hidden|entered) in our run\\."},
        {"another winner of an interval",
         {"interval", Grain::Interval, 3},
         [](Json& row) {
             if (!row.contains("interval")) return false;
             row["interval"]["winner"] = 999999;
             return true;
         },
         ".* 'interval.winner' is 999999 in your trace, and .* in our run\\."},
        {"a step that is not there", kLines,
         [](Json& row) {
             row["step"] = 100000;
             return true;
         },
         "Our run has no step 100000 of grain line\\."},
    };
    return kChanges;
}

/// The fields of a row as a table shows them: "✖ name | ours | theirs", indented.
std::string tableOf(const std::vector<check::FieldBeside>& fields)
{
    std::string text;
    for (const check::FieldBeside& field : fields)
        text += std::string(field.likeness == check::Likeness::Differs    ? "x"
                            : field.likeness == check::Likeness::Rounding ? "~"
                                                                          : "=")
                + std::string(static_cast<std::size_t>(2 * field.depth) + 1, ' ') + field.name + " | " + field.ours
                + " | " + field.theirs + '\n';
    return text;
}

TEST(Trace, EdgesSpansAndPixelsStandBesideOurs)
{
    const auto besideOf = [](const DrawRequest& request, const Json& row) {
        const auto trace = std::make_shared<check::Trace>(*check::traceOf(row.dump() + "\n", "t.jsonl"));
        const auto answer =
            std::make_shared<check::TraceAnswer>(*check::judgeTrace(*trace, request, check::halfStepOf(8)));
        check::TraceBeside beside(trace, answer, request, check::halfStepOf(8));
        return tableOf(*beside.row(0));
    };
    const DrawRequest sweep = requestFor("builtin:cubes", "scanline");
    Json              state;
    for (const Json& row : statesOf(sweep, Grain::Line))
        if (row["active_edges"].size() >= 4
            && (state.is_null() || row["active_edges"].size() < state["active_edges"].size()))
            state = row;
    ASSERT_FALSE(state.is_null());
    const Json& edges = state["active_edges"];
    const auto  edge  = [&](std::size_t at) {
        return Json{{"polygon", edges[at]["polygon"]}, {"x", edges[at]["x"]}, {"last_line", edges[at]["last_line"]}};
    };
    const auto id      = [&](std::size_t at) { return edges[at]["polygon"].dump(); };
    const auto last    = [&](std::size_t at) { return edges[at]["last_line"].get<int>(); };
    const auto x       = [&](std::size_t at) { return fmt::format("{:.9g}", edges[at]["x"].get<double>()); };
    Json       moved   = edge(2);
    moved["last_line"] = last(2) + 2;
    Json row{{"line", state["line"]}, {"active_edges", {edge(0), moved}}};  // lacks those at 1, 3 and beyond
    const std::string table = besideOf(sweep, row);
    const std::string begin = fmt::format(
        "= line | {0} | {0}\nx active_edges |  | \n"
        "=   polygon {1} |  | \n=     x | {2} | {2}\n=     last_line | {3} | {3}\n"
        "x   polygon {4} |  | \nx     x | {5} | \nx     last_line | {6} | \n"
        "x   polygon {7} |  | \n=     x | {8} | {8}\nx     last_line | {9} | {10}\n",
        state["line"].get<int>(), id(0), x(0), last(0), id(1), x(1), last(1), id(2), x(2), last(2), last(2) + 2);
    EXPECT_TRUE(table.starts_with(begin)) << table << "\nand not\n" << begin;

    const DrawRequest stream = requestFor("builtin:cubes", "zbuffer");
    Json              pixel;
    for (const Json& each : statesOf(stream, Grain::Pixel, 11))
        if (each.contains("pixel") && each["pixel"]["won"] == true) pixel = each["pixel"];
    ASSERT_FALSE(pixel.is_null());
    const Json said{{"pixel", {{"x", pixel["x"]}, {"y", pixel["y"]}, {"triangle", pixel["triangle"]}, {"won", false}}}};
    EXPECT_EQ(besideOf(stream, said),
              fmt::format("x pixel |  | \n=   x | {0} | {0}\n=   y | {1} | {1}\n=   triangle | {2} | {2}\n"
                          "x   won | true | false\n",
                          pixel["x"].dump(), pixel["y"].dump(), pixel["triangle"].dump()));
    EXPECT_EQ(besideOf(sweep, Json{{"line", 700}, {"active_polygons", {1, 2}}}),
              "x line |  | 700\nx active_polygons |  | [1, 2]\n");
}

TEST(Trace, EachKindOfChangeIsFoundAtItsRow)
{
    std::map<std::pair<std::string, Grain>, std::vector<Json>> kept;
    for (const Change& change : changes()) {
        const DrawRequest request = requestFor(change.way.scene, change.way.preset);
        auto&             rows    = kept[{change.way.preset, change.way.grain}];
        if (rows.empty()) rows = statesOf(request, change.way.grain, change.way.every);
        int made = 0;
        for (std::size_t at = rows.size() / 3; at < rows.size() && made < 2; ++at) {
            std::vector<Json> spoilt = rows;
            if (!change.make(spoilt[at])) continue;
            ++made;
            const check::TraceAnswer answer = judged(request, linesOf(spoilt));
            ASSERT_TRUE(answer.firstWrong) << change.name << " in row " << at << ": " << rows[at].dump();
            EXPECT_EQ(*answer.firstWrong, at) << change.name << ": " << answer.sentence;
            EXPECT_EQ(answer.wrong, 1u) << change.name;
            EXPECT_TRUE(std::regex_match(answer.rows[at].sentence, std::regex(change.says)))
                << change.name << ": " << answer.rows[at].sentence;
        }
        EXPECT_GT(made, 0) << change.name;
    }
}

/// Order means nothing where it says so, numbers may be rounded, and what is not there is not judged.
TEST(Trace, WhatMeansNothingIsNotJudged)
{
    const DrawRequest request = requestFor("builtin:cubes", "scanline");
    std::vector<Json> rows;
    for (Json row : statesOf(request, Grain::Line)) {
        for (const char* list : {"entered", "left", "spans", "active_polygons"})
            std::reverse(row[list].begin(), row[list].end());
        for (Json& edge : row["active_edges"]) {
            edge["x"]  = edge["x"].get<double>() + 0.001;
            edge["dx"] = edge["dx"][0].get<double>() / edge["dx"][1].get<double>();
            edge.erase("x_subpixels");
        }
        row["sentence"] = "my own remark";
        rows.push_back(row);
    }
    const check::TraceAnswer answer = judged(request, linesOf(rows) + "\n  \n");
    EXPECT_TRUE(answer.isRight()) << answer.sentence;
    EXPECT_GT(answer.rounding, 10u);
    const check::TraceAnswer few =
        judged(request, "{\"line\":20,\"active_polygons\":" + rows[21]["active_polygons"].dump() + "}");
    EXPECT_TRUE(few.isRight()) << few.sentence;
    EXPECT_EQ(few.rows[0].grain, Grain::Line);
}

/// The edges of triangles that are neither snapped nor stepped by whole numbers, as a program without either has them.
std::string unsnappedSweep(const DrawRequest& request)
{
    const Scene&  scene  = request.scene->scene();
    const Camera& camera = request.camera;
    struct Edge {
        std::uint32_t polygon;
        float         xa, ya, slope;
        int           first, last;
    };
    std::vector<Edge> edges;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Mesh& mesh = scene.meshOf(InstanceId{i});
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            std::array<float, 3> x{}, y{};
            for (std::size_t k = 0; k < 3; ++k) {
                const dvec3 d     = scene.instances[i].toWorld(mesh.positions[mesh.triangles[t][k]]) - camera.eye;
                const auto  z     = static_cast<float>(glm::dot(camera.forward, d));
                const auto  scale = static_cast<float>(camera.height * 0.5 * camera.focal);
                x[k] = static_cast<float>(camera.width) / 2 + static_cast<float>(glm::dot(camera.right, d)) / z * scale;
                y[k] = static_cast<float>(camera.height) / 2 - static_cast<float>(glm::dot(camera.up, d)) / z * scale;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                std::size_t a = k, b = (k + 1) % 3;
                if (y[a] > y[b]) std::swap(a, b);
                const int first = std::max(0, static_cast<int>(std::ceil(y[a] - 0.5F))),
                          last  = std::min(camera.height, static_cast<int>(std::ceil(y[b] - 0.5F))) - 1;
                if (first > last) continue;
                edges.push_back({scene.firstTriangle[i] + static_cast<std::uint32_t>(t), x[a], y[a],
                                 (x[b] - x[a]) / (y[b] - y[a]), first, last});
            }
        }
    }
    std::string text;
    for (int line = 0; line < camera.height; ++line) {
        std::vector<std::pair<float, Json>> active;
        std::set<std::uint32_t>             polygons;
        for (const Edge& edge : edges) {
            if (line < edge.first || line > edge.last) continue;
            const float x = edge.xa + edge.slope * (static_cast<float>(line) + 0.5F - edge.ya);
            active.emplace_back(x, Json{{"polygon", edge.polygon},
                                        {"x", x},
                                        {"dx", edge.slope},
                                        {"first_line", edge.first},
                                        {"last_line", edge.last}});
            polygons.insert(edge.polygon);
        }
        std::ranges::stable_sort(active, {}, [](const auto& each) { return each.first; });
        std::map<std::uint32_t, std::vector<float>> crossings;
        for (const auto& [x, edge] : active) crossings[edge["polygon"].get<std::uint32_t>()].push_back(x);
        Json spans = Json::array();
        for (const auto& [polygon, xs] : crossings) {
            const auto pixel = [&](float x) {
                return std::clamp(static_cast<int>(std::ceil(x - 0.5F)), 0, camera.width);
            };
            const int x0 = pixel(xs.front()), x1 = pixel(xs.back());
            if (x0 < x1) spans.push_back({{"x0", x0}, {"x1", x1}, {"polygon", polygon}});
        }
        Json row{{"line", line}, {"active_edges", Json::array()}, {"active_polygons", polygons}, {"spans", spans}};
        for (const auto& [x, edge] : active) row["active_edges"].push_back(edge);
        text += row.dump() + '\n';
    }
    return text;
}

TEST(Trace, AnUnsnappedSweepDiffersByRoundingAlone)
{
    for (const auto& [scene, width, height] :
         std::vector<std::tuple<std::string, int, int>>{{"builtin:cubes", 233, 151},
                                                        {"builtin:teapot?tessellation=6", 233, 151},
                                                        {"builtin:teapot?tessellation=6", 640, 480}}) {
        const DrawRequest        request = requestFor(scene, "scanline", width, height);
        const check::TraceAnswer answer  = judged(request, unsnappedSweep(request));
        EXPECT_TRUE(answer.isRight()) << scene << ": " << answer.sentence;
        EXPECT_GT(answer.rounding, 0u);
    }
}

TEST(Trace, WhatIsNoTraceIsRefusedInOneSentence)
{
    for (const auto& [text, line, sentence] : std::vector<std::tuple<std::string, int, std::string>>{
             {"", 0, "the trace holds no row"},
             {"\n \n", 0, "the trace holds no row"},
             {"{\"line\":1}\n[1]\n", 2, "a row of a trace must be an object with fields of a step's state"},
             {"{\"line\":1}\n{\"line\":}\n", 2, ""},
             {"{\"line\":1}\n{\"line\":2", 2, ""},
             {"{\"line\":\"one\"}", 1, ""},
             {"{\"line\":1,\"activeEdges\":[]}", 1, "'activeEdges' is no field of a step's state"},
             {"{\"line\":1,\"active_edges\":{}}", 1, "'active_edges' must be a list"},
             {"{\"line\":1,\"active_edges\":[3]}", 1, "'active_edges' must be a list of objects"},
             {"{\"line\":1,\"active_edges\":[{\"xs\":3}]}", 1, "'active_edges' has no field 'xs'"},
             {"{\"line\":1,\"active_edges\":[{\"dx\":[1]}]}", 1,
              "'dx' must be a number, or two: [numerator, denominator]"},
             {"{\"line\":1,\"active_edges\":[{\"x\":null}]}", 1, "'x' must be a number"},
             {"{\"line\":1,\"spans\":[{\"x0\":3,\"x1\":4}]}", 1, "'spans' must say 'polygon'"},
             {"{\"active_edges\":[]}", 1, "a row with 'active_edges' must say its 'line'"},
             {"{\"pixel\":{\"x\":1,\"y\":2}}", 1, "'pixel' must say 'triangle'"},
             {"{\"pixel\":7}", 1, "'pixel' must be an object"},
             {"{\"grain\":\"inch\",\"step\":1}", 1, "'grain' must be a grain: see zscope-cli list grains"},
             {"{\"grain\":\"line\",\"step\":-1}", 1, ""},
             {"{\"algorithm\":\"scanline\",\"line\":1}\n{\"algorithm\":\"zbuffer\",\"line\":2}", 2,
              "a trace is of one algorithm, but line 1 names another"}}) {
        const auto trace = check::traceOf(text, "t.jsonl");
        ASSERT_FALSE(trace) << text;
        EXPECT_EQ(trace.error().kind, Trouble::Input) << text;
        EXPECT_EQ(trace.error().file, "t.jsonl") << text;
        EXPECT_EQ(trace.error().line, line) << text;
        EXPECT_TRUE(sentence.empty() || trace.error().sentence == sentence) << text << ": " << trace.error().sentence;
        EXPECT_TRUE(chinesePhrases().text(trace.error().sentence)) << trace.error().sentence;
    }
    const auto unknown = check::traceOf("{\"algorithm\":\"my own\",\"line\":1}", "t.jsonl");
    ASSERT_TRUE(unknown);
    EXPECT_FALSE(check::traceAlgorithm(*unknown, {}));
    EXPECT_TRUE(check::traceAlgorithm(*unknown, "scanline"));
    EXPECT_FALSE(check::traceAlgorithm(*unknown, "none"));
    // Hostile numbers are a difference and cost nothing.
    const DrawRequest request = requestFor("builtin:cubes", "scanline");
    for (const char* row : {R"({"line":1099511627776})", R"({"line":20,"active_polygons":[-5,1099511627776]})",
                            R"({"line":20,"spans":[{"x0":-1099511627776,"x1":1099511627776,"polygon":0}]})",
                            R"({"line":20,"active_edges":[{"x":1e300,"dx":[1,0]}]})",
                            R"({"pixel":{"x":1099511627776,"y":-7,"triangle":-1}})"})
        EXPECT_FALSE(judged(request, row).isRight()) << row;
}

}  // namespace
}  // namespace zscope::tests
