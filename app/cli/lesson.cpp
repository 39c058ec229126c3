// zscope-cli lesson: checks lessons that a teacher has written, and says where each page stops and what its right
// answer is.
#include <algorithm>

#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_run.h"

namespace zscope::cli {
namespace {

std::string answerText(const LessonQuestion& question, const LessonAnswer& answer)
{
    if (answer.choice)
        return fmt::format("choice {}: {}", *answer.choice + 1, question.choices[*answer.choice].text.in(false));
    if (answer.number)
        return answer.tolerance > 0 ? fmt::format("{} +- {}", *answer.number, answer.tolerance)
                                    : fmt::format("{}", *answer.number);
    std::size_t pixels = 0;
    std::string first;
    for (int y = 0; y < answer.pixels.height(); ++y)
        for (int x = 0; x < answer.pixels.width(); ++x)
            if (answer.pixels.at(x, y) != 0 && pixels++ == 0) first = fmt::format("{},{}", x, y);
    return fmt::format("{} pixels, the first at {}", pixels, first);
}

std::optional<Error> checkPage(const LessonPage& page, std::size_t number, const std::string& file, Session& session)
{
    auto scene = loadScene(page.scene, session, 0, 0);
    // what it says is the file's fault, not the command's
    const auto inLesson = [](Trouble kind) { return kind == Trouble::Usage ? Trouble::Input : kind; };
    if (!scene) return Error{inLesson(scene.error().kind), scene.error().text(), file, page.fileLine};
    const ViewRequest view   = viewOfPage(page, **scene);
    const auto        camera = makeCamera(view, (*scene)->bounds);
    if (!camera) return Error{inLesson(camera.error().kind), camera.error().sentence, file, page.fileLine};
    const DrawRequest request{.scene       = std::make_shared<PreparedScene>(*scene),
                              .camera      = *camera,
                              .faceCulling = view.faceCulling.value_or(FaceCulling::None),
                              .pipeline    = page.pipeline};
    const auto        run = runPage(page, file, request);
    if (!run) return run.error();
    Replay     replay(request);
    const auto state = replay.at(run->grain, run->step);
    if (!state) return state.error();
    session.print(fmt::format("page {}  {}  {} {} of {}  {}\n", number, state->algorithm, wordOf(run->grain),
                              run->step.value, state->count, state->sentence));
    if (page.question)
        session.print(
            fmt::format("        {} -> {}\n", page.question->ask.in(false), answerText(*page.question, *run->answer)));
    return std::nullopt;
}

Exit check(const std::vector<std::string>& files, Session& session)
{
    Exit worst = Exit::Done;
    for (const std::string& file : files) {
        const auto lesson = readLesson(file);
        if (!lesson) {
            worst = session.fail(lesson.error());
            continue;
        }
        session.print(fmt::format("{}: {}\n", file, lesson->title.in(false)));
        for (std::size_t i = 0; i < lesson->pages.size(); ++i)
            if (const auto error = checkPage(lesson->pages[i], i + 1, file, session)) worst = session.fail(*error);
    }
    return worst;
}

}  // namespace

Command addLesson(CLI::App& parent)
{
    CLI::App* parser =
        parent.add_subcommand("lesson", "Check lessons: each page's stop and the right answer to its question");
    auto files = std::make_shared<std::vector<std::string>>();
    parser->add_option("FILE", *files, "Lesson files, see docs/lessons.md")->required()->type_name("");
    return {parser, [files](Session& session) { return check(*files, session); }};
}

}  // namespace zscope::cli
