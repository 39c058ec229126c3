#include "core/scene/obj/material_library.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "core/base/quotable.h"
#include "core/io/read_file.h"
#include "core/io/text_encoding.h"
#include "core/scene/obj/library_names.h"
#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/names.h"
#include "core/scene/obj/numbers.h"

namespace zscope::obj {

namespace {

constexpr std::size_t kLongestWord = 16;  // of the statements that are looked at

std::string tooManySentence()
{
    return fmt::format("more than {} material libraries; this one is left out", kMaxLibraries);
}

/// Reads up to three reals; says how many, or warns and says 0.
std::size_t readFractions(std::string_view rest, std::array<double, 3>& values, const auto& warn)
{
    std::size_t count = 0;
    for (std::string_view word = takeWord(rest); !word.empty() && count < 3; word = takeWord(rest)) {
        const NumberTrouble trouble = readReal(word, values[count]);
        if (trouble != NumberTrouble::None) {
            warn(fmt::format("'{}' {}", quotable(word), describe(trouble)));
            return 0;
        }
        values[count] = std::clamp(values[count], 0.0, 1.0);
        ++count;
    }
    if (count == 0) warn("a number is missing");
    return count;
}

/// What tinyobjloader's reader gets: the statements that we keep, checked, with numbers it reads without error
/// (shortest decimals of float32), the standard colour first in every material, and for a name its place in `names`.
/// `opacities` holds what sets the opacity of each material: `d` goes before `Tr`, a later one before an earlier one.
struct PlainLibrary {
    std::string                text;
    std::vector<std::string>   names;
    std::vector<FileStatement> opacities;
};

std::string inSmallLetters(std::string_view word)
{
    std::string small(word);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

PlainLibrary plainLibrary(std::string_view bytes, const std::string& file, WarningList& warnings)
{
    PlainLibrary   plain;
    LineReader     lines(bytes);
    bool           inMaterial = false, hasTextures = false;
    const Material standard;
    while (lines.next()) {
        std::string_view       rest    = lines.text();
        const std::string_view written = takeWord(rest);
        const auto             warn    = [&](const std::string& what) {
            const auto sentence = [&] {
                return fmt::format("{}: {}; the statement is left out", quotable(written), what);
            };
            warnings.add(file, lines.number(), sentence);
        };
        const std::string     word = inSmallLetters(written.substr(0, kLongestWord));
        std::array<double, 3> value{};
        if (word == "newmtl") {
            std::string name = printableName(rest);
            inMaterial       = !name.empty();
            if (!inMaterial) {
                warn("the name is missing");
                continue;
            }
            if (lines.isJoined()) warnings.add(file, lines.number(), [] { return joinedNameSentence("newmtl"); });
            plain.text += fmt::format("newmtl {}\nKd {} {} {}\n", plain.names.size(), standard.diffuse.r,
                                      standard.diffuse.g, standard.diffuse.b);
            plain.names.push_back(std::move(name));
            plain.opacities.emplace_back();
        } else if (word.starts_with("map_")) {
            if (!std::exchange(hasTextures, true))
                warnings.add(file, lines.number(), [&] {
                    return fmt::format("textures ('{}') are not read; materials have the colour of Kd",
                                       quotable(written));
                });
        } else if (!inMaterial) {
            continue;
        } else if (word == "kd") {
            const std::size_t count = readFractions(beforeComment(rest), value, warn);
            if (count == 0) continue;
            if (count < 3) value[2] = value[0];  // as the format says: g and b default to r
            if (count < 2) value[1] = value[0];
            plain.text += fmt::format("Kd {} {} {}\n", static_cast<float>(value[0]), static_cast<float>(value[1]),
                                      static_cast<float>(value[2]));
        } else if (word == "d" || word == "tr") {
            std::string_view number = rest;
            if (takeWord(number) != "-halo") number = rest;
            number = beforeComment(number);
            if (readFractions(number, value, warn) > 0) {
                plain.text += fmt::format("{} {}\n", word == "d" ? "d" : "Tr", static_cast<float>(value[0]));
                std::string& last = plain.opacities.back().text;
                if (word == "d" || !(last.starts_with("d ") || last.starts_with("D ")))
                    plain.opacities.back() = {
                        fmt::format("{} {}", quotable(written), quotable(withoutBlanks(beforeComment(rest)))), file,
                        lines.number()};
            }
        }
    }
    if (lines.tooLong())
        warnings.add(file, lines.number(), [] { return std::string("the line is too long; the rest is left out"); });
    return plain;
}

}  // namespace

void MaterialLibrary::read(std::string_view names, int line, WarningList& warnings)
{
    const auto             warn  = [&](const auto& sentence) { warnings.add(m_objFile, line, sentence); };
    const std::string_view whole = withoutBlanks(names);
    if (whole.empty()) return warn([] { return std::string("mtllib names no file"); });
    if (m_folder.empty()) return warn([] { return std::string("there is no folder to read a material library from"); });
    if (m_statements.contains(std::string(whole))) return;
    if (m_statements.size() >= kMaxLibraries) return warn(tooManySentence);
    m_statements.emplace(whole);
    for (const LibraryName& name : librariesNamed(m_folder, whole)) {
        if (!name.warning.empty()) warn([&] { return "material library: " + name.warning; });
        if (!name.path.empty()) readFile(name.path, line, warnings);
    }
}

void MaterialLibrary::readFile(const std::string& path, int line, WarningList& warnings)
{
    if (m_read.contains(path)) return;
    if (m_read.size() >= kMaxLibraries) return warnings.add(m_objFile, line, tooManySentence);
    m_read.insert(path);
    const std::string         shown = std::filesystem::path(path).filename().string();
    const Result<std::string> bytes = readRegularFile(path, kMaxLibraryBytes);
    if (!bytes.ok())
        return warnings.add(m_objFile, line, [&] {
            return fmt::format("material library '{}' {}", quotable(shown), bytes.error().sentence);
        });
    if (const auto trouble = encodingTrouble(*bytes))
        return warnings.add(m_objFile, line, [&] {
            return fmt::format("material library '{}' is left out: {}", quotable(shown), *trouble);
        });

    PlainLibrary                     plain = plainLibrary(*bytes, path, warnings);
    std::istringstream               stream(plain.text);
    std::map<std::string, int>       numbers;
    std::vector<tinyobj::material_t> read;
    std::string                      remarks, errors;
    tinyobj::LoadMtl(&numbers, &read, &stream, &remarks, &errors);
    for (std::size_t i = 0; i < plain.names.size(); ++i) {  // one for each, in their order
        const tinyobj::material_t& from = read[i];
        Material                   material{
            std::move(plain.names[i]), {from.diffuse[0], from.diffuse[1], from.diffuse[2]}, from.dissolve};
        if (material.opacity < 1) material.opacityFrom = std::make_shared<FileStatement>(std::move(plain.opacities[i]));
        add(std::move(material));
    }
}

/// Of materials of the same name the first stays.
void MaterialLibrary::add(Material material)
{
    const std::string name = material.name;
    if (!m_materials.emplace(name, std::move(material)).second) return;
    for (const NameReading& reading : readingsOf(name)) {
        if (reading.isWhole) continue;
        const auto [at, isNew] = m_shortened.try_emplace(std::string(reading.name), Shortened{name, reading.isComment});
        if (!isNew) at->second.isOne = false;
    }
}

std::optional<Material> MaterialLibrary::find(const std::string& name) const
{
    const std::vector<NameReading> readings = readingsOf(name);
    for (const NameReading& reading : readings)
        if (const auto at = m_materials.find(std::string(reading.name)); at != m_materials.end()) return at->second;
    for (const NameReading& reading : readings) {
        const auto at = m_shortened.find(std::string(reading.name));
        if (at == m_shortened.end() || !at->second.isOne) continue;
        if (!reading.isWhole && !(reading.isComment && at->second.isComment)) continue;
        Material material = m_materials.at(at->second.whole);
        material.name     = at->first;
        return material;
    }
    return std::nullopt;
}

}  // namespace zscope::obj
