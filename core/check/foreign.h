// What another program drew, as its files hold it: depth, ids, a plain picture, or a dump with all of it.
//
// Rows       as the files have them, first row first (of PFM and BMP the top row, which these formats name); whether
//            that is the top of the picture is found out later (core/check/conventions.h)
// Dump       assets/homework/zscope_dump.h writes it: "ZSDUMP1\n", nine uint32 in the writer's byte order (0x01020304,
//            width, height, contents, rows, matrix order, depth range, ids count from, 0), then what `contents` names:
//            16 float64 view, 16 float64 projection, float32 depth, int32 ids (background -1)
// Bounds     files are compared with the camera's size before memory is taken for their numbers
// Errors     Input, one sentence with the file's name
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/grid.h"
#include "core/base/result.h"
#include "core/check/depth_meaning.h"

namespace zscope::check {

struct ForeignDepth {
    Grid<double>    values;
    DepthResolution resolution;
};

struct ForeignIds {
    Grid<std::int64_t> values;
    bool               areColours = false;  // of a PNG: they count from 0, and -1 is background
};

/// At least one of them is there; all have the camera's size.
struct Foreign {
    std::optional<ForeignDepth>        depth;
    std::optional<ForeignIds>          ids;
    std::optional<Grid<std::uint32_t>> picture;  // 0xRRGGBB
};

Result<ForeignDepth>        readDepth(const std::string& path, int width, int height);
Result<ForeignIds>          readIds(const std::string& path, int width, int height);
Result<Grid<std::uint32_t>> readPicture(const std::string& path, int width, int height);

enum class Rows { TopDown, BottomUp };
enum class MatrixOrder { Rows, Columns };
enum class DepthRange { MinusOneToOne, ZeroToOne, Reversed };

struct Dump {
    int                                   width = 0, height = 0;
    std::optional<std::array<double, 16>> view, projection;
    std::optional<ForeignDepth>           depth;
    std::optional<ForeignIds>             ids;
    // what the writer said
    std::optional<Rows>        rows;
    std::optional<MatrixOrder> order;
    std::optional<DepthRange>  range;
    std::optional<int>         idsFrom;
};

Result<Dump> readDump(const std::string& path);
/// The same of its bytes; `file` is named in errors.
Result<Dump> dumpOf(std::string_view bytes, const std::string& file);

}  // namespace zscope::check
