// Generated scenes: what each is called, what can be asked of it, and how it is made.
//
// Growing    a generator is one file in this folder and one line in registry.cpp; a file may hold several scenes
// Words      NAME[?key=value&...], as after "builtin:"; every key has a default, a range and a meaning, so the
//            word is checked here and a generator meets only values it declared
// Promise    the same word gives the same scene, bit for bit, with every standard library: numbers come from
//            random.h, circles from circle.h, square roots from IEEE
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace zscope {

struct WholeNumber {
    std::int64_t fallback;
    std::int64_t min, max;  // both allowed
};
struct RealNumber {
    double fallback;
    double min, max;  // both allowed
};
struct OneOf {
    std::vector<std::string> words;  // the first is the default
};

/// Something that can be asked of a generator.
struct Parameter {
    std::string                                  key;
    std::variant<WholeNumber, RealNumber, OneOf> range;
};

/// The parameters of one word after checking, with defaults filled in.
class Arguments {
public:
    using Value = std::variant<std::int64_t, double, std::string>;

    std::uint64_t memoryLimit = 0;  // bytes the scene may take; never 0 when a generator sees it
    Progress      progress    = {};

    /// `key` must be one that the generator declared, of that kind.
    std::int64_t       whole(std::string_view key) const { return std::get<std::int64_t>(at(key)); }
    double             real(std::string_view key) const { return std::get<double>(at(key)); }
    const std::string& word(std::string_view key) const { return std::get<std::string>(at(key)); }

    void set(std::string key, Value value);

private:
    const Value& at(std::string_view key) const;

    std::vector<std::pair<std::string, Value>> m_values;  // one per declared parameter
};

struct Generator {
    std::string            name;   // after "builtin:"; letters, digits, '-', '/'
    std::string            title;  // one line
    std::vector<Parameter> parameters = {};

    /// Meshes, instances, light and views; ids, bounds, digest and name are filled in by generate().
    /// Errors: Limit (arguments.memoryLimit), Cancelled, Usage where parameters do not go together.
    std::function<Result<Scene>(const Arguments& arguments)> make;
};

/// All of them, in the order of the registry.
std::span<const Generator> generators();

/// The scene of a word (without "builtin:"). Errors: Usage naming what would have been right, and what make() says.
Result<Scene> generate(std::string_view word, std::uint64_t memoryLimit, const Progress& progress = {});

/// Checks the words of one generator. Errors: Usage that names the valid keys or the range.
Result<Arguments> parseArguments(const Generator& generator, std::string_view text);

/// "count=1000&seed=1": the parameters with their defaults.
std::string defaultsOf(const Generator& generator);

/// Bytes a mesh of this size takes while it grows: vectors may hold twice what is in use. In float64, so that no
/// product of sizes runs over.
double meshBytes(double vertices, double polygons, double corners, double triangles);

/// The error of a scene that would take `bytes` where `limit` are allowed; `what` names the scene or the part.
Error tooLarge(std::string_view what, double bytes, std::uint64_t limit);

}  // namespace zscope
