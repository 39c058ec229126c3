#include "core/io/npy.h"

#include <bit>
#include <string_view>
#include <type_traits>
#include <vector>

namespace zscope {
namespace {

static_assert(std::endian::native == std::endian::little, "the values are written as they lie in memory");

std::string_view descriptionOf(NpyType type)
{
    switch (type) {
        case NpyType::Int64:
            return "<i8";
        case NpyType::Float32:
            return "<f4";
        case NpyType::Float64:
            break;
    }
    return "<f8";
}

template <class T>
std::string_view bytesOf(std::span<T> values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

template <class T>
Result<Done> writeRows(const std::string& path, NpyType type, int width, int height, const NpyRow<T>& fill,
                       const std::atomic<bool>* cancel)
{
    Result<FileWriter> file = FileWriter::create(path);
    if (!file) return file.error();
    const std::uint64_t shape[]{static_cast<std::uint64_t>(height), static_cast<std::uint64_t>(width)};
    file->write(npyHeader(type, shape));
    std::vector<T> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height && !file->failed(); ++y) {
        if (cancel && cancel->load(std::memory_order_relaxed))
            return Error{Trouble::Cancelled, "writing was cancelled"};
        fill(y, row);
        file->write(bytesOf(std::span<const T>(row)));
    }
    return file->commit();
}

}  // namespace

std::string npyHeader(NpyType type, std::span<const std::uint64_t> shape)
{
    std::string dictionary = "{'descr': '";
    dictionary += descriptionOf(type);
    dictionary += "', 'fortran_order': False, 'shape': (";
    for (std::size_t i = 0; i < shape.size(); ++i) dictionary += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
    dictionary += shape.size() == 1 ? ",), }" : "), }";

    constexpr std::size_t kFixed = 10;  // magic (6), version (2), length of the dictionary (2)
    // Spaces up to the multiple of 64 at which the data starts; the dictionary ends in a newline.
    while ((kFixed + dictionary.size() + 1) % 64 != 0) dictionary += ' ';
    dictionary += '\n';

    std::string header = "\x93NUMPY";
    header += '\x01';
    header += '\x00';
    header += static_cast<char>(dictionary.size() & 0xFF);
    header += static_cast<char>(dictionary.size() >> 8);
    return header + dictionary;
}

Result<Done> writeNpy(const std::string& path, int width, int height, const NpyRow<std::int64_t>& fill,
                      const std::atomic<bool>* cancel)
{
    return writeRows(path, NpyType::Int64, width, height, fill, cancel);
}

Result<Done> writeNpy(const std::string& path, int width, int height, const NpyRow<float>& fill,
                      const std::atomic<bool>* cancel)
{
    return writeRows(path, NpyType::Float32, width, height, fill, cancel);
}

Result<NpyTriangleWriter> NpyTriangleWriter::create(const std::string& path, std::uint64_t triangles)
{
    Result<FileWriter> file = FileWriter::create(path);
    if (!file) return file.error();
    const std::uint64_t shape[]{triangles, 3, 3};
    file->write(npyHeader(NpyType::Float64, shape));
    return NpyTriangleWriter(std::move(*file), triangles);
}

void NpyTriangleWriter::triangle(std::span<const double, 9> corners)
{
    assert(m_missing > 0);
    --m_missing;
    m_file.write(bytesOf(std::span<const double>(corners)));
}

Result<Done> NpyTriangleWriter::commit()
{
    assert(m_missing == 0 || failed());
    return m_file.commit();
}

}  // namespace zscope
