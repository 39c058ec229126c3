// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/their_files.h"

#include <algorithm>
#include <array>

#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QRegularExpression>

#include "core/check/foreign.h"
#include "core/io/image_read.h"
#include "core/io/png.h"
#include "core/io/read_file.h"

namespace zscope::ui {
namespace {

constexpr std::array    kEndings{".npy", ".zdump", ".pfm", ".png", ".bmp", ".ppm"};
constexpr std::array    kTraceEndings{".jsonl", ".json-lines"};
constexpr std::uint64_t kLargestPicture = std::uint64_t{1} << 30;  // bytes
constexpr qint64        kBeginning      = 4096;                    // bytes; no header of an array is longer

bool ends(const QString& file, const char* ending) { return file.endsWith(QLatin1String(ending), Qt::CaseInsensitive); }

template <class Endings>
QString patternsOf(const Endings& endings)
{
    QStringList patterns;
    for (const char* ending : endings) patterns << QLatin1Char('*') + QLatin1String(ending);
    return patterns.join(' ');
}

/// Empty of what is no regular file: opening one of those may wait.
QByteArray beginningOf(const QString& path)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) return {};
    return file.read(kBeginning);
}

bool isNamedIds(const QString& file)
{
    const QString name = QFileInfo(file).completeBaseName();
    return name.startsWith("ids", Qt::CaseInsensitive) || name.endsWith("ids", Qt::CaseInsensitive);
}

struct ArrayHead {
    QChar                kind;  // of NumPy: 'f', 'i', 'u'; null: it cannot be read, and core says why
    std::optional<QSize> size;
};

ArrayHead arrayHeadOf(const QString& file)
{
    static const QRegularExpression number("'descr'\\s*:\\s*'[<>|=]?([a-z])"),
        shape("'shape'\\s*:\\s*\\(\\s*(\\d{1,5})\\s*,\\s*(\\d{1,5})\\s*,?\\s*\\)");
    const QString head = QString::fromLatin1(beginningOf(file));
    ArrayHead     found;
    if (const auto match = number.match(head); match.hasMatch()) found.kind = match.captured(1).front();
    if (const auto match = shape.match(head); match.hasMatch())
        found.size = QSize(match.captured(2).toInt(), match.captured(1).toInt());
    return found;
}

std::optional<QSize> sizeOfPfm(const QString& file)
{
    static const QRegularExpression head("^P[Ff]\\s+(\\d{1,5})\\s+(\\d{1,5})\\s");
    const auto                      match = head.match(QString::fromLatin1(beginningOf(file)));
    if (!match.hasMatch()) return {};
    return QSize(match.captured(1).toInt(), match.captured(2).toInt());
}

bool isGrey16(const QString& file)
{
    const QByteArray head = beginningOf(file);  // signature, length and name of IHDR, width, height, bits, kind
    return head.size() > 25 && head[24] == 16 && (head[25] == 0 || head[25] == 4);
}

}  // namespace

bool isDrawn(const QString& file)
{
    return std::ranges::any_of(kEndings, [&](const char* ending) { return ends(file, ending); });
}

bool isTrace(const QString& file)
{
    return std::ranges::any_of(kTraceEndings, [&](const char* ending) { return ends(file, ending); });
}

QString drawnPatterns() { return patternsOf(kEndings); }
QString tracePatterns() { return patternsOf(kTraceEndings); }

Result<TheirFiles> theirFilesOf(const QStringList& files)
{
    TheirFiles theirs;
    const auto put = [](std::optional<std::string>& place, const std::string& path) -> Result<Done> {
        if (place) return Error{Trouble::Input, "two files hold the same: " + *place + " is one, too", path};
        place = path;
        return Done{};
    };
    for (const QString& file : files) {
        const std::string    path = file.toStdString();
        std::optional<QSize> size;
        Result<Done>         done = Done{};
        if (ends(file, ".zdump")) {
            const auto dump = check::readDump(path);
            if (!dump) return dump.error();
            size               = QSize(dump->width, dump->height);
            theirs.hasMatrices = dump->view && dump->projection;
            done               = put(theirs.dump, path);
        } else if (ends(file, ".npy")) {
            const ArrayHead head = arrayHeadOf(file);
            size                 = head.size;
            done                 = put(isNamedIds(file) || head.kind == 'i' ? theirs.ids
                                       : head.kind == 'u'                   ? theirs.numbers
                                                                            : theirs.depth,
                       path);
        } else if (ends(file, ".pfm")) {
            size = sizeOfPfm(file);
            done = put(theirs.depth, path);
        } else if (isDrawn(file)) {
            if (QFileInfo(file).isFile()) size = QImageReader(file).size();
            const bool isPng = ends(file, ".png");
            done             = put(isPng && isNamedIds(file) ? theirs.ids
                                   : isPng && isGrey16(file) ? theirs.depth
                                                             : theirs.picture,
                       path);
        } else {
            return Error{Trouble::Input, "pictures are read from .npy, .zdump, .pfm, .png, .bmp and .ppm", path};
        }
        if (!done) return done.error();
        if (!theirs.size && size && size->isValid() && !size->isEmpty()) theirs.size = size;
    }
    // beside one of the two it is the other
    if (theirs.numbers && (theirs.depth || theirs.ids)) {
        std::optional<std::string>& other = theirs.depth ? theirs.ids : theirs.depth;
        if (const auto done = put(other, *theirs.numbers); !done) return done.error();
        theirs.numbers.reset();
    }
    return theirs;
}

std::optional<std::string> sessionInPicture(const QString& file)
{
    if (!ends(file, ".png")) return {};
    const auto bytes = readRegularFile(file.toStdString(), kLargestPicture);
    return bytes ? pngTextOf(*bytes, kPngSession) : std::nullopt;
}

}  // namespace zscope::ui
