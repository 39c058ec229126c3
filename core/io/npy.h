// NumPy's file format for arrays, version 1.0: what ids, depth and triangle corners are handed on in.
//
// Layout     little-endian, row-major (fortran_order False); the data starts at a multiple of 64 bytes
// Source     numpy.lib.format, "Format Version 1.0"
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/io/file_writer.h"

namespace zscope {

enum class NpyType { Int64, Float32, Float64 };

/// The bytes in front of the data.
std::string npyHeader(NpyType type, std::span<const std::uint64_t> shape);

/// Fills one row, the y-th from the top.
template <class T>
using NpyRow = std::function<void(int y, std::span<T> row)>;

/// Shape (height, width), row 0 is the top line. One row is held at a time. `cancel` set to true: the file is left out,
/// and the error is Cancelled.
Result<Done> writeNpy(const std::string& path, int width, int height, const NpyRow<std::int64_t>& fill,
                      const std::atomic<bool>* cancel = nullptr);
Result<Done> writeNpy(const std::string& path, int width, int height, const NpyRow<float>& fill,
                      const std::atomic<bool>* cancel = nullptr);

/// float64, shape (triangles, 3, 3): corners of one triangle after another, so that no array of all is ever held.
class NpyTriangleWriter {
public:
    static Result<NpyTriangleWriter> create(const std::string& path, std::uint64_t triangles);

    /// x, y, z of the corners 0, 1, 2. Must be called once per triangle announced to create().
    void         triangle(std::span<const double, 9> corners);
    bool         failed() const { return m_file.failed(); }
    Result<Done> commit();

private:
    NpyTriangleWriter(FileWriter file, std::uint64_t triangles) : m_file(std::move(file)), m_missing(triangles) {}

    FileWriter    m_file;
    std::uint64_t m_missing;  // triangles announced and not yet written; 0 at commit(), unless writing failed
};

}  // namespace zscope
