#include "core/scene/obj/material_library.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "core/io/read_file.h"
#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/numbers.h"
#include "core/scene/obj/statement_stream.h"

namespace zscope::obj {

namespace {

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
/// (shortest decimals of float32), and the standard colour first in every material. `opacities` gets what sets the
/// opacity of each material, in their order: `d` goes before `Tr`, and a later one before an earlier one.
std::string plainText(std::string_view bytes, const std::string& file, WarningList& warnings,
                      std::vector<FileStatement>& opacities)
{
    std::string    plain;
    LineReader     lines(bytes);
    bool           inMaterial = false;
    const Material standard;
    while (lines.next()) {
        std::string_view       rest = lines.text();
        const std::string_view word = takeWord(rest);
        const auto             warn = [&](const std::string& what) {
            const auto sentence = [&] {
                return fmt::format("{}: {}; the statement is left out", quotable(word), what);
            };
            warnings.add(file, lines.number(), sentence);
        };
        std::array<double, 3> value{};
        if (word == "newmtl") {
            const std::string name = printableName(rest);
            inMaterial             = !name.empty();
            if (!inMaterial) {
                warn("the name is missing");
                continue;
            }
            plain += fmt::format("newmtl {}\nKd {} {} {}\n", name, standard.diffuse.r, standard.diffuse.g,
                                 standard.diffuse.b);
            opacities.emplace_back();
        } else if (!inMaterial) {
            continue;
        } else if (word == "Kd") {
            const std::size_t count = readFractions(rest, value, warn);
            if (count == 0) continue;
            if (count < 3) value[2] = value[0];  // as the format says: g and b default to r
            if (count < 2) value[1] = value[0];
            plain += fmt::format("Kd {} {} {}\n", static_cast<float>(value[0]), static_cast<float>(value[1]),
                                 static_cast<float>(value[2]));
        } else if (word == "d" || word == "Tr") {
            std::string_view number = rest;
            if (takeWord(number) != "-halo") number = rest;
            if (readFractions(number, value, warn) > 0) {
                plain += fmt::format("{} {}\n", word, static_cast<float>(value[0]));
                if (word == "d" || !opacities.back().text.starts_with("d "))
                    opacities.back() = {fmt::format("{} {}", word, quotable(withoutBlanks(rest))), file,
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
    const auto  warn = [&](const auto& sentence) { warnings.add(m_objFile, line, sentence); };
    std::string whole(withoutBlanks(names));
    if (whole.empty()) return warn([] { return std::string("mtllib names no file"); });
    if (m_folder.empty()) return warn([] { return std::string("there is no folder to read a material library from"); });
    std::replace(whole.begin(), whole.end(), '\\', '/');

    const Result<std::string> path = pathInside(m_folder, whole);
    if (path.ok()) return readFile(*path, line, warnings);
    const bool isOneWord = whole.find_first_of(" \t") == std::string::npos;
    if (isOneWord) return warn([&] { return "material library: " + path.error().sentence; });

    std::string_view rest = whole;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        const Result<std::string> one = pathInside(m_folder, std::string(word));
        if (one.ok())
            readFile(*one, line, warnings);
        else
            warn([&] { return "material library: " + one.error().sentence; });
        if (m_read.size() >= kMaxLibraries) break;
    }
}

void MaterialLibrary::readFile(const std::string& path, int line, WarningList& warnings)
{
    if (m_read.contains(path)) return;
    if (m_read.size() >= kMaxLibraries)
        return warnings.add(m_objFile, line, [] {
            return fmt::format("more than {} material libraries; this one is left out", kMaxLibraries);
        });
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

    std::vector<FileStatement>       opacities;
    std::istringstream               stream(plainText(*bytes, path, warnings, opacities));
    std::map<std::string, int>       numbers;
    std::vector<tinyobj::material_t> read;
    std::string                      remarks, errors;
    tinyobj::LoadMtl(&numbers, &read, &stream, &remarks, &errors);
    for (const auto& [name, number] : numbers) {
        if (name.empty()) continue;  // its entry for a file without materials
        const tinyobj::material_t& from = read[static_cast<std::size_t>(number)];
        Material                   material{name, {from.diffuse[0], from.diffuse[1], from.diffuse[2]}, from.dissolve};
        if (material.opacity < 1)
            material.opacityFrom =
                std::make_shared<FileStatement>(std::move(opacities[static_cast<std::size_t>(number)]));
        m_materials.emplace(name, std::move(material));
    }
}

const Material* MaterialLibrary::find(const std::string& name) const
{
    const auto at = m_materials.find(name);
    return at == m_materials.end() ? nullptr : &at->second;
}

}  // namespace zscope::obj
