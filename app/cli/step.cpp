// zscope-cli step: how many steps a frame has, and what one of them looks like.
#include <limits>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/outputs.h"
#include "app/cli/words.h"
#include "core/io/file_writer.h"
#include "core/io/png.h"
#include "core/lesson/replay.h"

namespace zscope::cli {
namespace {

struct StepOptions {
    SceneOption                scene;
    ViewOptions                view;
    HowOptions                 how;
    std::optional<std::string> grain, at, state, picture;
    bool                       count = false, levels = false;
};

/// What is asked of the steps: their number, or one of them.
struct AskedStep {
    Grain                    grain = Grain::Frame;
    std::optional<StepIndex> at;  // nothing: how many there are
};

Result<AskedStep> askedBy(const StepOptions& options)
{
    AskedStep asked;
    if (!options.grain) return usage("--grain is missing: see 'zscope-cli list grains'");
    const std::optional<Grain> grain = grainOf(*options.grain);
    if (!grain) {
        std::vector<std::string> valid;
        for (const Grain each : kGrains) valid.emplace_back(wordOf(each));
        return unknownWord("grain", *options.grain, valid);
    }
    asked.grain = *grain;
    if (options.count == options.at.has_value()) return usage("say either --count or --at K");
    if (options.count && (options.state || options.picture)) return usage("--count writes no files: say --at K");
    if (options.levels && !options.state) return usage("--levels adds to a state: say with --state where it goes");
    if (options.at) {
        const auto step = wholeNumber(*options.at, "--at", 0, std::numeric_limits<std::int64_t>::max());
        if (!step) return step.error();
        asked.at = StepIndex{static_cast<std::uint64_t>(*step)};
    }
    return asked;
}

Result<Exit> step(const StepOptions& options, Session& session)
{
    const Result<AskedStep> asked = askedBy(options);
    if (!asked) return asked.error();
    const Result<ViewWords> words = options.view.read();
    if (!words) return words.error();
    const Result<How> how = options.how.read();
    if (!how) return how.error();
    const std::vector<Output> outputs{{"--state", options.state}, {"-o", options.picture, {".png"}}};
    if (const auto checked = checkOutputs(outputs, {options.scene.word(), options.view.cameraFile()}); !checked)
        return checked.error();
    const Result<LoadedScene> scene = options.scene.prepare(session, how->memoryLimit);
    if (!scene) return scene.error();
    if (const auto checked = checkOutputs(outputs, scene->scene->files); !checked) return checked.error();
    const auto view = words->of(*scene->scene);
    if (!view) return view.error();

    Replay replay(how->request(*scene, *view, session));
    if (!asked->at) {
        const Result<std::uint64_t> count = replay.count(asked->grain);
        if (!count) return count.error();
        session.print(fmt::format("{}\n", *count));
        return Exit::Done;
    }
    const Result<StepState> state = replay.at(asked->grain, *asked->at);
    if (!state) return state.error();
    if (session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
    if (options.state)
        if (const auto done = writeFile(
                *options.state, stateToJson(*state, options.levels ? PyramidCells::Written : PyramidCells::Left));
            !done)
            return done.error();
    if (session.interrupted()) return Error{Trouble::Cancelled, "interrupted"};
    if (options.picture) {
        const auto texts = reproducingTexts(session.reproducingCommand(), scene->scene->digest);
        if (const auto done = writePng(*options.picture, state->frame.colour.view(), texts,
                                       {.threads = how->threads, .cancel = session.cancel()});
            !done)
            return done.error();
    }
    session.print(
        fmt::format("{} {} of {}: {}\n", wordOf(state->grain), state->step.value, state->count, state->sentence));
    return Exit::Done;
}

}  // namespace

Command addStep(CLI::App& parent)
{
    CLI::App* parser  = parent.add_subcommand("step", "Stop a frame after a step and show its state");
    auto      options = std::make_shared<StepOptions>();
    options->scene.add(*parser);
    options->view.add(*parser);
    options->how.add(*parser, HowOptions::Algorithms::One);
    parser->add_option("--grain", options->grain, "How coarse a step is, see 'list grains'")->type_name("GRAIN");
    parser->add_flag("--count", options->count, "Print the number of steps");
    parser->add_option("--at", options->at, "Stop right after this step, counted from 0")->type_name("K");
    parser->add_option("--state", options->state, "The algorithm's state at that step")
        ->type_name("FILE.json")
        ->group("Output");
    parser->add_flag("--levels", options->levels, "Put the values of the pyramid's levels into the state")
        ->group("Output");
    parser
        ->add_option("-o,--output", options->picture,
                     "The picture at that step, a PNG: its name ends in .png or has no ending")
        ->type_name("FILE")
        ->group("Output");
    return {parser, [options](Session& session) {
                const Result<Exit> exit = step(*options, session);
                return exit ? *exit : session.fail(exit.error());
            }};
}

}  // namespace zscope::cli
