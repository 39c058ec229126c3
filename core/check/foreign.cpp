#include "core/check/foreign.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/io/bytes.h"
#include "core/io/image_read.h"
#include "core/io/npy_read.h"
#include "core/io/read_file.h"
#include "core/scene/view.h"

namespace zscope::check {
namespace {

/// No file of so many pixels is larger, headers included; those of another size are read as well, to say so.
std::uint64_t mostBytesOf(int width, int height)
{
    constexpr std::uint64_t kLeast = std::uint64_t{64} << 20;
    return std::max(
        kLeast, std::uint64_t{1} << 20 | static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * 16);
}

Result<std::string> bytesOf(const std::string& path, std::uint64_t most)
{
    Result<std::string> bytes = readRegularFile(path, most);
    if (bytes || bytes.error().kind != Trouble::Limit) return bytes;
    return inputError(fmt::format("the file has more than {} MiB, too many for a picture of this size", most >> 20),
                      path);
}

/// Little-endian numbers in the camera's size, and nothing else.
template <class T, class Value>
Result<Grid<Value>> rawOf(std::string_view bytes, const std::string& file, int width, int height)
{
    Grid<Value>       grid(width, height);
    const std::size_t wanted = grid.values().size() * sizeof(T);
    if (bytes.size() != wanted)
        return inputError(fmt::format("the file has {} bytes, and {}x{} numbers of {} bytes take {}", bytes.size(),
                                      width, height, sizeof(T), wanted),
                          file);
    for (std::size_t i = 0; i < grid.values().size(); ++i)
        grid.values()[i] = static_cast<Value>(numberAt<T>(bytes, i * sizeof(T), ByteOrder::Little));
    return grid;
}

DepthResolution resolutionOf(const NpyNumbers& numbers)
{
    if (numbers.kind == 'u')
        return {DepthNumberFormat::Fixed, std::ldexp(1.0, static_cast<int>(8 * numbers.bytes)) - 1};
    return {numbers.bytes == 2   ? DepthNumberFormat::Float16
            : numbers.bytes == 4 ? DepthNumberFormat::Float32
                                 : DepthNumberFormat::Float64,
            1};
}

template <class From, class Use>
Grid<double> realsOf(const Grid<From>& from, const Use& use)
{
    Grid<double> reals(from.width(), from.height());
    std::ranges::transform(from.values(), reals.values().begin(), use);
    return reals;
}

}  // namespace

Result<ForeignDepth> readDepth(const std::string& path, int width, int height)
{
    const Result<std::string> bytes = bytesOf(path, mostBytesOf(width, height));
    if (!bytes) return bytes.error();
    const auto same = [](auto value) { return static_cast<double>(value); };
    if (hasEnding(path, ".npy")) {
        Result<NpyGrid> grid = npyGridOf(*bytes, path, width, height);
        if (!grid) return grid.error();
        if (grid->numbers.kind == 'i')
            return inputError("depth must be floats or unsigned integers, and these are signed ones", path);
        ForeignDepth depth{std::move(grid->reals), resolutionOf(grid->numbers)};
        if (depth.resolution.format == DepthNumberFormat::Fixed)
            for (double& value : depth.values.values()) value /= depth.resolution.steps;
        return depth;
    }
    if (hasEnding(path, ".pfm")) {
        const Result<Grid<float>> floats = pfmOf(*bytes, path, width, height);
        if (!floats) return floats.error();
        return ForeignDepth{realsOf(*floats, same), {}};
    }
    if (hasEnding(path, ".png")) {
        const Result<Grid<std::uint16_t>> grey = grey16Of(*bytes, path, width, height);
        if (!grey) return grey.error();
        return ForeignDepth{realsOf(*grey, [](std::uint16_t value) { return value / 65535.0; }),
                            {DepthNumberFormat::Fixed, 65535}};
    }
    if (hasEnding(path, ".raw")) {
        Result<Grid<double>> values = rawOf<float, double>(*bytes, path, width, height);
        if (!values) return values.error();
        return ForeignDepth{*std::move(values), {}};
    }
    return inputError("depth is read from .npy, .pfm, .png and .raw", path);
}

Result<ForeignIds> readIds(const std::string& path, int width, int height)
{
    const Result<std::string> bytes = bytesOf(path, mostBytesOf(width, height));
    if (!bytes) return bytes.error();
    if (hasEnding(path, ".npy")) {
        Result<NpyGrid> grid = npyGridOf(*bytes, path, width, height);
        if (!grid) return grid.error();
        if (grid->numbers.kind == 'f') return inputError("ids must be integers, and these are floats", path);
        return ForeignIds{std::move(grid->wholes)};
    }
    if (hasEnding(path, ".png")) {
        const Result<Grid<std::uint32_t>> colours = coloursOf(*bytes, path, width, height);
        if (!colours) return colours.error();
        ForeignIds ids{Grid<std::int64_t>(width, height), true};
        std::ranges::transform(colours->values(), ids.values.values().begin(),
                               [](std::uint32_t colour) { return static_cast<std::int64_t>(colour) - 1; });
        return ids;
    }
    if (hasEnding(path, ".raw")) {
        Result<Grid<std::int64_t>> values = rawOf<std::int32_t, std::int64_t>(*bytes, path, width, height);
        if (!values) return values.error();
        return ForeignIds{*std::move(values)};
    }
    return inputError("ids are read from .npy, .png and .raw", path);
}

Result<Grid<std::uint32_t>> readPicture(const std::string& path, int width, int height)
{
    const Result<std::string> bytes = bytesOf(path, mostBytesOf(width, height));
    if (!bytes) return bytes.error();
    return coloursOf(*bytes, path, width, height);
}

Result<Dump> readDump(const std::string& path)
{
    const Result<std::string> bytes = bytesOf(path, mostBytesOf(kMaxPictureSide, kMaxPictureSide));
    if (!bytes) return bytes.error();
    return dumpOf(*bytes, path);
}

Result<Dump> dumpOf(std::string_view bytes, const std::string& file)
{
    constexpr std::size_t   kWords = 9, kStart = 8 + kWords * 4;
    constexpr std::uint32_t kMark = 0x01020304, kDepth = 1, kIds = 2, kView = 4, kProjection = 8;
    if (!bytes.starts_with("ZSDUMP1\n")) return inputError("this is no dump of zscope_dump.h", file);
    if (bytes.size() < kStart) return inputError("the dump ends in its header", file);
    const ByteOrder order =
        numberAt<std::uint32_t>(bytes, 8, ByteOrder::Little) == kMark ? ByteOrder::Little : ByteOrder::Big;
    std::array<std::uint32_t, kWords> words{};
    for (std::size_t i = 0; i < kWords; ++i) words[i] = numberAt<std::uint32_t>(bytes, 8 + 4 * i, order);
    const auto [mark, width, height, contents, rows, matrixOrder, range, idsFrom, reserved] = words;
    if (mark != kMark || reserved != 0 || contents >= 16 || rows > 2 || matrixOrder > 2 || range > 3 || idsFrom > 2)
        return inputError("the dump's header cannot be read", file);
    if (width < 1 || height < 1 || width > kMaxPictureSide || height > kMaxPictureSide)
        return inputError(fmt::format("the dump's picture must be from 1x1 to {0}x{0} pixels, not {1}x{2}",
                                      kMaxPictureSide, width, height),
                          file);
    if ((contents & (kDepth | kIds)) == 0) return inputError("the dump holds neither depth nor ids", file);

    const std::size_t pixels   = std::size_t{width} * height;
    const std::size_t matrices = (contents & kView ? 1u : 0u) + (contents & kProjection ? 1u : 0u);
    const std::size_t grids    = (contents & kDepth ? 1u : 0u) + (contents & kIds ? 1u : 0u);
    const std::size_t wanted   = kStart + matrices * 16 * 8 + grids * pixels * 4;
    if (bytes.size() != wanted)
        return inputError(fmt::format("the dump has {} bytes, and its header says {}", bytes.size(), wanted), file);

    Dump        dump;
    std::size_t at = kStart;
    dump.width = static_cast<int>(width), dump.height = static_cast<int>(height);
    const auto matrix = [&] {
        std::array<double, 16> numbers{};
        for (double& number : numbers) number = numberAt<double>(bytes, at, order), at += 8;
        return numbers;
    };
    if (contents & kView) dump.view = matrix();
    if (contents & kProjection) dump.projection = matrix();
    if (contents & kDepth) {
        dump.depth = ForeignDepth{Grid<double>(dump.width, dump.height), {}};
        for (double& value : dump.depth->values.values()) value = numberAt<float>(bytes, at, order), at += 4;
    }
    if (contents & kIds) {
        dump.ids = ForeignIds{Grid<std::int64_t>(dump.width, dump.height)};
        for (std::int64_t& id : dump.ids->values.values()) id = numberAt<std::int32_t>(bytes, at, order), at += 4;
    }
    if (rows != 0) dump.rows = rows == 1 ? Rows::TopDown : Rows::BottomUp;
    if (matrixOrder != 0) dump.order = matrixOrder == 1 ? MatrixOrder::Rows : MatrixOrder::Columns;
    if (range != 0) dump.range = static_cast<DepthRange>(range - 1);
    if (idsFrom != 0) dump.idsFrom = static_cast<int>(idsFrom) - 1;
    return dump;
}

}  // namespace zscope::check
