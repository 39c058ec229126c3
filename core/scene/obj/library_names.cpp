#include "core/scene/obj/library_names.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/base/quotable.h"
#include "core/io/read_file.h"
#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/names.h"

namespace zscope::obj {

namespace {

constexpr std::size_t kMaxWordsOfOne = 16;    // that are tried as one name with blanks
constexpr std::size_t kMaxPathBytes  = 4096;  // of any file system

struct Word {
    std::size_t begin = 0, end = 0;
    bool        isQuoted = false;
};

/// The words of the text; what stands in quotes is one. The last one holds all that is left beyond kMaxWords.
std::vector<Word> wordsOf(std::string_view text)
{
    std::vector<Word> words;
    for (std::size_t at = 0;;) {
        while (at < text.size() && isBlank(text[at])) ++at;
        if (at == text.size()) return words;
        if (words.size() == kMaxWords) {
            words.push_back({at, text.size()});
            return words;
        }
        std::size_t end = at;
        while (end < text.size() && !isBlank(text[end])) ++end;
        const std::size_t closing  = text[at] == '"' || text[at] == '\'' ? text.find(text[at], at + 1) : text.npos;
        const bool        isQuoted = closing != text.npos && (closing + 1 == text.size() || isBlank(text[closing + 1]));
        if (isQuoted) end = closing + 1;
        words.push_back({at, end, isQuoted});
        at = end;
    }
}

std::string_view lastPart(std::string_view path) { return path.substr(path.find_last_of("/\\:") + 1); }

/// For an absolute path: the file of that name beside the OBJ file.
std::optional<LibraryName> besideInstead(const std::string& folder, std::string_view name)
{
    if (!isAbsolutePath(name)) return std::nullopt;
    for (std::size_t i = 1; i < name.size(); ++i)
        if (isBlank(name[i - 1]) && isAbsolutePath(name.substr(i))) return std::nullopt;  // two paths, not one
    const std::string_view last = lastPart(name);
    const auto             path = findInside(folder, std::string(last));
    if (!path) return std::nullopt;
    return LibraryName{*path, fmt::format("the path '{}' is absolute; '{}' beside this file is read instead",
                                          quotable(name, 200), quotable(last, 200))};
}

/// The text as one name, if there is such a file.
std::optional<LibraryName> existing(const std::string& folder, std::string_view text, bool isQuoted)
{
    if (text.size() > kMaxPathBytes) return std::nullopt;
    if (const auto path = findInside(folder, std::string(text))) return LibraryName{*path, {}};
    if (auto beside = besideInstead(folder, text)) return beside;
    return isQuoted ? existing(folder, text.substr(1, text.size() - 2), false) : std::nullopt;
}

/// What is said of a name for which there is no file.
std::string whyMissing(const std::string& folder, std::string_view text, bool isQuoted)
{
    if (isQuoted) text = text.substr(1, text.size() - 2);
    if (text.size() > kMaxPathBytes) return "the name is too long";
    const auto whyNot = [&folder](std::string_view name) {
        const auto path = pathInside(folder, std::string(name));
        return path.ok() ? "more than one name seems to stand here" : path.error().sentence;
    };
    if (!isAbsolutePath(text)) return whyNot(text);
    return fmt::format("the path '{}' is absolute, and beside this file: {}", quotable(text, 200),
                       whyNot(lastPart(text)));
}

/// The names of one reading: at each word the longest name that exists; what lies between goes on to the next ".mtl".
std::vector<LibraryName> split(const std::string& folder, std::string_view text)
{
    const std::vector<Word>  words = wordsOf(text);
    std::vector<LibraryName> names;
    std::optional<Word>      gap;
    const auto               closeGap = [&] {
        if (gap)
            names.push_back({{}, whyMissing(folder, text.substr(gap->begin, gap->end - gap->begin), gap->isQuoted)});
        gap.reset();
    };
    for (std::size_t first = 0; first < words.size();) {
        std::optional<LibraryName> found;
        std::size_t                next = std::min(words.size(), first + kMaxWordsOfOne);
        for (; next > first; --next) {
            const std::string_view name = text.substr(words[first].begin, words[next - 1].end - words[first].begin);
            found                       = existing(folder, name, next == first + 1 && words[first].isQuoted);
            if (found) break;
        }
        if (found) {
            closeGap();
            names.push_back(*std::move(found));
            first = next;
            continue;
        }
        const Word& word = words[first++];
        if (word.isQuoted) closeGap();
        gap = Word{gap ? gap->begin : word.begin, word.end, word.isQuoted};
        if (word.isQuoted || hasEnding(text.substr(word.begin, word.end - word.begin), ".mtl")) closeGap();
    }
    closeGap();
    return names;
}

}  // namespace

std::vector<LibraryName> librariesNamed(const std::string& folder, std::string_view names)
{
    std::vector<LibraryName> best;
    std::ptrdiff_t           fewest = 0;
    for (const NameReading& reading : readingsOf(withoutBlanks(names))) {
        std::vector<LibraryName> these = split(folder, reading.name);
        const auto               gaps  = std::ranges::count_if(these, [](const auto& one) { return one.path.empty(); });
        if (!best.empty() && gaps >= fewest) continue;
        best   = std::move(these);
        fewest = gaps;
        if (gaps == 0) break;
    }
    return best;
}

}  // namespace zscope::obj
