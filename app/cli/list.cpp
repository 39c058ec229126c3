// zscope-cli list: the words that the other commands understand, from the registries that make them work.
#include <algorithm>
#include <array>

#include "app/cli/commands.h"
#include "app/cli/json.h"
#include "app/cli/table.h"
#include "app/cli/words.h"
#include "core/frame/faults.h"
#include "core/frame/pipeline.h"
#include "core/frame/renderer.h"
#include "core/frame/shortcuts.h"
#include "core/lesson/layers.h"
#include "core/measure/suites.h"
#include "core/scene/load.h"

namespace zscope::cli {
namespace {

constexpr std::string_view titleOf(Grain grain)
{
    constexpr std::array<std::string_view, kGrains.size()> titles{
        "The finished frame",
        "A stage of the frame is complete",
        "A node has been decided on",
        "A triangle has been drawn",
        "A question has been answered: to the pyramid about a node or a triangle, or one of the method's own",
        "A line of the sweep",
        "The pixels between two neighbouring edges have been decided",
        "A run of pixels of one line",
        "A cell of the pyramid has been computed anew",
        "One pixel's depth test"};
    return titles[static_cast<std::size_t>(grain)];
}

Json algorithms()
{
    Json list = Json::array();
    for (const Preset& preset : presets()) {
        Json grains = Json::array();
        for (const Grain grain : grainsOf(preset.pipeline)) grains.push_back(zscope::wordOf(grain));
        list.push_back({{"name", preset.name},
                        {"title", preset.title},
                        {"exact", preset.isExact()},
                        {"exact_by_face", preset.claim != Claim::Approximate},
                        {"family", familyOf(preset.pipeline)},
                        {"grains", std::move(grains)}});
    }
    return list;
}

Json choices()
{
    Json list = Json::array();
    for (const AxisEntry& axis : axes())
        for (const ChoiceEntry& choice : axis.choices)
            list.push_back({{"name", choice.word}, {"title", choice.title}, {"axis", axis.word}});
    return list;
}

Json faultList()
{
    Json list = Json::array();
    for (const FaultEntry& fault : faults())
        list.push_back({{"name", fault.word},
                        {"title", fault.title},
                        {"algorithm", fault.preset},
                        {"cause", fault.cause},
                        {"cure", fault.cure}});
    return list;
}

Json scenes()
{
    Json list = Json::array();
    for (const SceneEntry& scene : builtinScenes())
        list.push_back({{"name", scene.name}, {"title", scene.title}, {"parameters", scene.parameters}});
    return list;
}

Json layerList()
{
    Json list = Json::array();
    for (const Layer& layer : layers()) list.push_back({{"name", layer.word}, {"title", layer.title}});
    return list;
}

Json grains()
{
    Json list = Json::array();
    for (const Grain grain : kGrains) list.push_back({{"name", zscope::wordOf(grain)}, {"title", titleOf(grain)}});
    return list;
}

Json simd()
{
    Json list = Json::array();
    for (const SimdEntry& entry : simdTargets())
        list.push_back({{"name", entry.word}, {"title", entry.title}, {"available", entry.available}});
    return list;
}

Json suiteList()
{
    Json list = Json::array();
    for (const Suite& suite : suites()) {
        Json scenes = Json::array();
        for (const SuiteScene& scene : suite.scenes)
            scenes.push_back(std::string(scene.word)
                             + (scene.view.empty() ? "" : " (" + std::string(scene.view) + ")"));
        list.push_back({{"name", suite.name},
                        {"title", suite.title},
                        {"algorithms", suite.algorithms},
                        {"scenes", std::move(scenes)}});
    }
    return list;
}

Json shortcutList()
{
    Json list = Json::array();
    for (const ShortcutEntry& entry : shortcutEntries()) {
        Json needs = Json::array(), can = Json::array(), whyNot = Json::object();
        for (const Shortcut needed : entry.needs) needs.push_back(entryOf(needed).name);
        for (const Preset& preset : presets()) {
            const std::string_view plain = whyPlain(preset.pipeline);
            const std::string_view why   = plain.empty() ? entry.whyNot(preset.pipeline) : plain;
            if (!why.empty())
                whyNot[std::string(preset.name)] = why;
            else
                can.push_back(preset.name);
        }
        list.push_back({{"name", entry.name},
                        {"title", entry.title},
                        {"kind", wordOf(entry.kind)},
                        {"replaces", entry.replaces},
                        {"needs", std::move(needs)},
                        {"presets", std::move(can)},
                        {"why_not", std::move(whyNot)}});
    }
    return list;
}

struct Kind {
    std::string_view word;
    Json (*list)();
};
constexpr std::array kKinds{Kind{"algorithms", algorithms}, Kind{"choices", choices},  Kind{"scenes", scenes},
                            Kind{"layers", layerList},      Kind{"grains", grains},    Kind{"simd", simd},
                            Kind{"suites", suiteList},      Kind{"faults", faultList}, Kind{"shortcuts", shortcutList}};

std::string cellOf(const Json& value)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    std::string words;
    for (const Json& each : value) words += (words.empty() ? "" : ",") + each.get<std::string>();
    return words;
}

/// The same list for people: a column per key, the title last, and whole sentences after it.
std::string tableOf(const Json& list)
{
    if (list.empty()) return "";
    const auto               isSentence = [](const std::string& key) { return key == "cause" || key == "cure"; };
    const auto               isOfJson   = [](const std::string& key) { return key == "presets" || key == "why_not"; };
    std::vector<std::string> keys;
    for (const auto& member : list.front().items())
        if (member.key() != "title" && !isSentence(member.key()) && !isOfJson(member.key()))
            keys.push_back(member.key());
    keys.emplace_back("title");
    std::vector<Table::Column> columns;
    for (const std::string& key : keys) columns.push_back({key, Table::Align::Left});
    Table table(std::move(columns));
    for (const Json& entry : list) {
        std::vector<std::string> cells;
        for (const std::string& key : keys) cells.push_back(cellOf(entry.at(key)));
        for (const auto& member : entry.items())
            if (isSentence(member.key()))
                cells.back() += (member.key() == "cause" ? ". " : " ") + cellOf(member.value());
        table.row(std::move(cells));
    }
    return table.text(outputWidth());
}

struct ListOptions {
    std::string kind;
    bool        json = false;
};

Result<Exit> list(const ListOptions& options, Session& session)
{
    const auto kind = std::ranges::find(kKinds, options.kind, &Kind::word);
    if (kind == kKinds.end()) {
        std::vector<std::string> valid;
        for (const Kind& each : kKinds) valid.emplace_back(each.word);
        return unknownWord("list", options.kind, valid);
    }
    const Json entries = kind->list();
    session.print(options.json ? textOf(entries) : tableOf(entries));
    return Exit::Done;
}

}  // namespace

Command addList(CLI::App& parent)
{
    CLI::App*   parser  = parent.add_subcommand("list", "Show the words that the other commands understand");
    auto        options = std::make_shared<ListOptions>();
    std::string help    = "Which list:";
    for (const Kind& kind : kKinds) help += ' ' + std::string(kind.word);
    parser->add_option("LIST", options->kind, help)->type_name("")->required();
    parser->add_flag("--json", options->json, "JSON instead of a table");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = list(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
