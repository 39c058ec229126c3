#include "app/cli/grade_journal.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "core/io/file_writer.h"
#include "core/io/read_file.h"
#include "core/measure/strict_json.h"

namespace zscope::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMaxJournal = std::uint64_t{256} << 20;  // bytes

GradeRow rowOf(const Json& json)
{
    GradeRow   row{.submission = json.at("submission").get<std::string>(),
                   .scene      = json.at("scene").get<std::string>(),
                   .detail     = {},
                   .digest     = {}};
    const auto verdict = gradeVerdictOf(json.at("verdict").get<std::string>());
    if (!verdict) throw Json::other_error::create(501, "no such verdict", &json);
    row.verdict = *verdict;
    row.seconds = amountOf(json.at("seconds"));
    row.peakMiB = amountOf(json.at("peak_mib"));
    row.detail  = json.at("detail").get<std::string>();
    row.check   = json.at("check");
    row.digest  = json.at("digest").get<std::string>();
    return row;
}

/// FNV-1a, 64 bits.
class Fingerprint {
public:
    void add(std::string_view bytes)
    {
        for (const char c : bytes) m_value = (m_value ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        m_value = (m_value ^ bytes.size()) * 0x100000001b3u;
    }
    std::string text() const { return fmt::format("{:016x}", m_value); }

private:
    std::uint64_t m_value = 0xcbf29ce484222325u;
};

}  // namespace

Json jsonOf(const GradeRow& row)
{
    return {{"submission", row.submission},
            {"scene", row.scene},
            {"verdict", wordOf(row.verdict)},
            {"seconds", row.seconds},
            {"peak_mib", row.peakMiB},
            {"detail", row.detail},
            {"check", row.check}};
}

Result<GradeJournal> GradeJournal::open(std::string path, Json head)
{
    GradeJournal journal;
    journal.m_path = std::move(path);
    journal.m_head = std::move(head);
    if (journal.m_path.empty() || !fs::exists(journal.m_path)) return journal;
    const auto text = readRegularFile(journal.m_path, kMaxJournal);
    if (!text) return text.error();
    try {
        const Json json = Json::parse(*text);
        if (json.at("grade") != journal.m_head)
            return Error{
                Trouble::Input,
                "this is the journal of another grading (program, scenes, views, limits or version differ): name "
                "another file",
                journal.m_path};
        for (const Json& row : listOf(json.at("rows"))) journal.m_rows.push_back(rowOf(row));
    } catch (const Json::exception&) {
        return Error{Trouble::Input, "this is no journal of a grading", journal.m_path};
    }
    return journal;
}

const GradeRow* GradeJournal::find(const std::string& submission, const std::string& scene,
                                   const std::string& digest) const
{
    const auto found = std::ranges::find_if(m_rows, [&](const GradeRow& row) {
        return row.submission == submission && row.scene == scene && row.digest == digest;
    });
    return found == m_rows.end() ? nullptr : &*found;
}

Result<Done> GradeJournal::add(const GradeRow& row)
{
    if (m_path.empty()) return Done{};
    std::erase_if(m_rows,
                  [&](const GradeRow& old) { return old.submission == row.submission && old.scene == row.scene; });
    m_rows.push_back(row);
    Json rows = Json::array();
    for (const GradeRow& each : m_rows) {
        rows.push_back(cli::jsonOf(each));
        rows.back()["digest"] = each.digest;
    }
    return writeFile(m_path, textOf(Json{{"grade", m_head}, {"rows", std::move(rows)}}));
}

Result<std::string> digestOfFiles(const std::string& path)
{
    std::vector<fs::path> files;
    std::error_code       trouble;
    if (fs::is_directory(path, trouble)) {
        for (fs::recursive_directory_iterator at(path, trouble), end; !trouble && at != end; at.increment(trouble))
            if (at->is_regular_file(trouble) && !at->is_symlink(trouble)) files.push_back(at->path());
        if (trouble) return Error{Trouble::Input, trouble.message(), path};
        std::ranges::sort(files);
    } else {
        files.emplace_back(path);
    }
    Fingerprint digest;
    for (const fs::path& file : files) {
        digest.add(file.lexically_relative(path).string());
        std::ifstream stream(file, std::ios::binary);
        if (!stream) return Error{Trouble::Input, "cannot be read", file.string()};
        std::string block(1 << 16, '\0');
        while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0)
            digest.add({block.data(), static_cast<std::size_t>(stream.gcount())});
    }
    return digest.text();
}

}  // namespace zscope::cli
