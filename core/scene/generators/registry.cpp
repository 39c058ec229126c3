#include "core/scene/generators/registry.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/base/memory.h"

// The registry: one line per file of this folder.
#define ZSCOPE_GENERATOR_FILES(file)                                                                                 \
    file(cubes) file(teapot) file(soccer_ball) file(icosphere) file(soccer_field) file(city) file(soup) file(layers) \
        file(cutouts) file(reliefs) file(walls) file(glass) file(rows) file(million) file(office_tower) file(hard_a) \
            file(hard_b) file(hard_c) file(hard_d) file(hard_e) file(hard_f) file(hard_g)

namespace zscope {

namespace generated {
#define ZSCOPE_DECLARE(file) std::vector<Generator> file();
ZSCOPE_GENERATOR_FILES(ZSCOPE_DECLARE)
#undef ZSCOPE_DECLARE
}  // namespace generated

std::span<const Generator> generators()
{
    static const std::vector<Generator> all = [] {
        std::vector<Generator> list;
        for (auto* file : {
#define ZSCOPE_NAME(file) &generated::file,
                 ZSCOPE_GENERATOR_FILES(ZSCOPE_NAME)
#undef ZSCOPE_NAME
             })
            std::ranges::move(file(), std::back_inserter(list));
        return list;
    }();
    return all;
}

namespace {

/// The shortest decimal that reads back as the same number.
std::string text(double value) { return fmt::format("{}", value); }

std::string fallbackOf(const Parameter& parameter)
{
    if (const auto* whole = std::get_if<WholeNumber>(&parameter.range)) return std::to_string(whole->fallback);
    if (const auto* real = std::get_if<RealNumber>(&parameter.range)) return text(real->fallback);
    return std::get<OneOf>(parameter.range).words.front();
}

std::string describe(const Parameter& parameter)
{
    if (const auto* whole = std::get_if<WholeNumber>(&parameter.range))
        return fmt::format("a whole number from {} to {}", whole->min, whole->max);
    if (const auto* real = std::get_if<RealNumber>(&parameter.range))
        return fmt::format("a number from {} to {}", text(real->min), text(real->max));
    return fmt::format("one of {}", fmt::join(std::get<OneOf>(parameter.range).words, ", "));
}

template <class Number>
std::optional<Number> wholly(std::string_view digits)
{
    Number     value{};
    const auto end    = digits.data() + digits.size();
    const auto answer = std::from_chars(digits.data(), end, value);
    if (answer.ec != std::errc{} || answer.ptr != end) return std::nullopt;
    return value;
}

/// The value that `text` stands for, if it is in the parameter's range.
std::optional<Arguments::Value> valueOf(const Parameter& parameter, std::string_view written)
{
    if (const auto* whole = std::get_if<WholeNumber>(&parameter.range)) {
        const auto value = wholly<std::int64_t>(written);
        if (value && *value >= whole->min && *value <= whole->max) return *value;
    } else if (const auto* real = std::get_if<RealNumber>(&parameter.range)) {
        const auto value = wholly<double>(written);
        if (value && *value >= real->min && *value <= real->max) return *value;  // a NaN is in no range
    } else {
        for (const std::string& word : std::get<OneOf>(parameter.range).words)
            if (word == written) return word;
    }
    return std::nullopt;
}

/// Letters to insert, remove or replace to turn one word into the other (Levenshtein).
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0]               = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j]                  = std::min({row[j - 1] + 1, above + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
            diagonal                = above;
        }
    }
    return row[b.size()];
}

Error unknownScene(std::string_view name)
{
    std::vector<std::string_view> close;
    std::vector<std::string_view> plain;                       // every name that is not in a folder
    const std::string_view        start = name.substr(0, 64);  // a name is never longer
    for (const Generator& generator : generators()) {
        const std::string_view candidate = generator.name;
        const bool             begins    = !start.empty() && candidate.starts_with(start);
        if (begins || editDistance(start, candidate) <= 1 + candidate.size() / 4) close.push_back(candidate);
        if (candidate.find('/') == std::string_view::npos) plain.push_back(candidate);
    }
    if (close.size() > 8) close.resize(8);
    if (close.empty())
        return {Trouble::Usage, fmt::format("there is no builtin scene '{}'; there are {} and more under 'list scenes'",
                                            start, fmt::join(plain, ", "))};
    return {Trouble::Usage,
            fmt::format("there is no builtin scene '{}'; did you mean {}?", start, fmt::join(close, ", "))};
}

}  // namespace

void Arguments::set(std::string key, Value value)
{
    const auto known = std::ranges::find(m_values, key, &std::pair<std::string, Value>::first);
    if (known != m_values.end())
        known->second = std::move(value);
    else
        m_values.emplace_back(std::move(key), std::move(value));
}

const Arguments::Value& Arguments::at(std::string_view key) const
{
    const auto found = std::ranges::find(m_values, key, &std::pair<std::string, Value>::first);
    assert(found != m_values.end() && "a generator may ask only for what it declared");
    return found->second;
}

std::string defaultsOf(const Generator& generator)
{
    std::string joined;
    for (const Parameter& parameter : generator.parameters)
        joined += (joined.empty() ? "" : "&") + parameter.key + "=" + fallbackOf(parameter);
    return joined;
}

Result<Arguments> parseArguments(const Generator& generator, std::string_view words)
{
    Arguments arguments;
    for (const Parameter& parameter : generator.parameters)
        arguments.set(parameter.key, *valueOf(parameter, fallbackOf(parameter)));

    std::vector<std::string_view> given;
    while (!words.empty()) {
        const std::size_t      end  = words.find('&');
        const std::string_view word = words.substr(0, end);
        words                       = end == std::string_view::npos ? std::string_view{} : words.substr(end + 1);

        const std::size_t      equals    = word.find('=');
        const std::string_view key       = word.substr(0, equals);
        const auto             parameter = std::ranges::find(generator.parameters, key, &Parameter::key);
        if (parameter == generator.parameters.end()) {
            if (generator.parameters.empty())
                return Error{Trouble::Usage, fmt::format("builtin:{} takes no parameters, and '{}' is given",
                                                         generator.name, word.substr(0, 80))};
            return Error{Trouble::Usage, fmt::format("builtin:{} has no parameter '{}'; it takes {}", generator.name,
                                                     key.substr(0, 80), defaultsOf(generator))};
        }
        if (equals == std::string_view::npos)
            return Error{Trouble::Usage, fmt::format("the parameter '{}' of builtin:{} needs a value: {}={}", key,
                                                     generator.name, key, fallbackOf(*parameter))};
        if (std::ranges::find(given, key) != given.end())
            return Error{Trouble::Usage,
                         fmt::format("the parameter '{}' of builtin:{} is given twice", key, generator.name)};
        given.push_back(key);

        const std::string_view written = word.substr(equals + 1);
        auto                   value   = valueOf(*parameter, written);
        if (!value)
            return Error{Trouble::Usage, fmt::format("the parameter '{}' of builtin:{} must be {}, not '{}'", key,
                                                     generator.name, describe(*parameter), written.substr(0, 80))};
        arguments.set(parameter->key, *std::move(value));
    }
    return arguments;
}

Result<Scene> generate(std::string_view word, std::uint64_t memoryLimit, const Progress& progress)
{
    const std::size_t      question = word.find('?');
    const std::string_view name     = word.substr(0, question);
    const auto             found    = std::ranges::find(generators(), name, &Generator::name);
    if (found == generators().end()) return unknownScene(name);

    const std::string_view words = question == std::string_view::npos ? std::string_view{} : word.substr(question + 1);
    Result<Arguments>      arguments = parseArguments(*found, words);
    if (!arguments) return arguments.error();
    arguments->memoryLimit = effectiveMemoryLimit(memoryLimit);
    arguments->progress    = progress;

    if (progress.cancelled()) return Error{Trouble::Cancelled, "the scene was not wanted any more"};
    Result<Scene> parts = found->make(*arguments);
    if (!parts) return parts.error();
    parts->name = fmt::format("builtin:{}", word);
    return assemble(std::move(parts).value());
}

double meshBytes(double vertices, double polygons, double corners, double triangles)
{
    const Mesh   mesh;
    const auto   each = [](const auto& list) { return static_cast<double>(sizeof(list[0])); };
    const double perPolygon =
        each(mesh.firstCorner) + each(mesh.polygonMaterial) + each(mesh.polygonGroup) + each(mesh.firstTriangle);
    const double perTriangle = each(mesh.triangles) + each(mesh.trianglePolygon);
    return 2
           * (vertices * each(mesh.positions) + corners * each(mesh.corners) + polygons * perPolygon
              + triangles * perTriangle);
}

Error tooLarge(std::string_view what, double bytes, std::uint64_t limit)
{
    constexpr double kMiB = 1024.0 * 1024.0;
    return {Trouble::Limit, fmt::format("{} would take {:.0f} MiB, and the memory limit is {:.0f} MiB", what,
                                        std::ceil(bytes / kMiB), std::floor(static_cast<double>(limit) / kMiB))};
}

}  // namespace zscope
