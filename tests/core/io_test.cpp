// What core/io promises: complete or absent files, arrays NumPy can read, pictures with their command line inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/io/file_writer.h"
#include "core/io/npy.h"
#include "core/io/png.h"

namespace zscope {
namespace {

namespace fs = std::filesystem;

class Io : public testing::Test {
protected:
    void SetUp() override
    {
        std::string pattern = (fs::temp_directory_path() / "zscope-io-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
    }
    void TearDown() override { fs::remove_all(m_folder); }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }
    std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }
    static std::string contentsOf(const std::string& path)
    {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    fs::path m_folder;
};

TEST_F(Io, NothingIsVisibleBeforeCommit)
{
    Result<FileWriter> file = FileWriter::create(path("a.txt"));
    ASSERT_TRUE(file);
    file->write(std::string(kWriteBuffer * 2 + 7, 'x'));
    EXPECT_FALSE(fs::exists(path("a.txt")));
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(contentsOf(path("a.txt")), std::string(kWriteBuffer * 2 + 7, 'x'));
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(Io, AnAbandonedFileLeavesTheOldContentsAndNoLitter)
{
    ASSERT_TRUE(writeFile(path("a.txt"), "old"));
    {
        Result<FileWriter> file = FileWriter::create(path("a.txt"));
        ASSERT_TRUE(file);
        file->write("new");
    }
    EXPECT_EQ(contentsOf(path("a.txt")), "old");
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(Io, ReplacingKeepsTheModeAndFollowsASymbolicLink)
{
    ASSERT_TRUE(writeFile(path("real.txt"), "old"));
    ASSERT_EQ(::chmod(path("real.txt").c_str(), 0640), 0);
    ASSERT_EQ(::symlink("real.txt", path("link.txt").c_str()), 0);
    ASSERT_TRUE(writeFile(path("link.txt"), "new"));
    EXPECT_TRUE(fs::is_symlink(path("link.txt")));
    EXPECT_EQ(contentsOf(path("real.txt")), "new");
    EXPECT_EQ(filesInFolder(), 2u);
    EXPECT_EQ(fs::status(path("real.txt")).permissions(), fs::perms(0640));
}

TEST_F(Io, ALinkToAFileThatDoesNotExistCreatesThatFileInItsOwnFolder)
{
    fs::create_directory(path("folder"));
    fs::create_directory(path("links"));
    ASSERT_EQ(::symlink("../folder/new.txt", path("links/inner").c_str()), 0);
    ASSERT_EQ(::symlink("links/inner", path("outer").c_str()), 0);
    ASSERT_TRUE(writeFile(path("outer"), "new"));
    EXPECT_TRUE(fs::is_symlink(path("outer")));
    EXPECT_TRUE(fs::is_symlink(path("links/inner")));
    EXPECT_FALSE(fs::is_symlink(path("folder/new.txt")));
    EXPECT_EQ(contentsOf(path("folder/new.txt")), "new");

    ASSERT_EQ(::symlink("nowhere/new.txt", path("lost").c_str()), 0);
    ASSERT_EQ(::symlink("round", path("round").c_str()), 0);
    for (const char* name : {"lost", "round"}) {
        const Result<Done> done = writeFile(path(name), "x");
        ASSERT_FALSE(done) << name;
        EXPECT_EQ(done.error().kind, Trouble::Output) << name;
        EXPECT_TRUE(fs::is_symlink(path(name))) << name;
    }
}

TEST_F(Io, ANameAsLongAsTheSystemAllowsCanBeWrittenAndALongerOneIsRefusedAtOnce)
{
    const std::string name(255, 'n');
    ASSERT_TRUE(writeFile(path(name), "x"));
    EXPECT_EQ(contentsOf(path(name)), "x");
    std::string deep;
    while (deep.size() <= 4095) deep += "./";
    for (const std::string& tooLong : {name + "n", deep + "x"}) {
        const Result<FileWriter> file = FileWriter::create(path(tooLong));
        ASSERT_FALSE(file);
        EXPECT_EQ(file.error().kind, Trouble::Output);
        EXPECT_EQ(file.error().sentence, "cannot be created: File name too long");
    }
}

TEST_F(Io, WhatCannotBeWrittenIsAnOutputErrorInOneSentence)
{
    for (const std::string& target : {m_folder.string(), path("no/such/folder.txt"), std::string("/dev/full")}) {
        const Result<Done> done = writeFile(target, "x");
        ASSERT_FALSE(done) << target;
        EXPECT_EQ(done.error().kind, Trouble::Output) << target;
        EXPECT_FALSE(done.error().sentence.empty()) << target;
        EXPECT_EQ(done.error().sentence.find('\n'), std::string::npos) << target;
    }
    EXPECT_EQ(writeFile("", "x").error().kind, Trouble::Usage) << "no name is no fault of the system";
    EXPECT_EQ(filesInFolder(), 0u);
    struct stat device {};
    ASSERT_EQ(::stat("/dev/full", &device), 0);
    EXPECT_TRUE(S_ISCHR(device.st_mode)) << "a device must never be renamed over";
}

TEST_F(Io, AFullDeviceIsNoticedHoweverLittleIsWritten)
{
    for (const std::size_t size : {std::size_t{1}, kWriteBuffer - 1, kWriteBuffer, kWriteBuffer * 3}) {
        Result<FileWriter> file = FileWriter::create("/dev/full");
        ASSERT_TRUE(file);
        file->write(std::string(size, 'x'));
        EXPECT_FALSE(file->commit()) << size;
    }
}

TEST_F(Io, NpyHeaderIsVersionOneAndAligned)
{
    const std::vector<std::vector<std::uint64_t>> shapes{{1, 1}, {720, 1280}, {16384, 16384}, {0, 3, 3}, {7}};
    for (const std::vector<std::uint64_t>& shape : shapes) {
        const std::string header = npyHeader(NpyType::Int64, shape);
        EXPECT_EQ(header.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
        EXPECT_EQ(header.size() % 64, 0u);
        EXPECT_EQ(header.back(), '\n');
        const auto length = static_cast<unsigned char>(header[8]) + 256u * static_cast<unsigned char>(header[9]);
        EXPECT_EQ(length + 10u, header.size());
    }
    const std::uint64_t picture[]{720, 1280};
    const std::string   header = npyHeader(NpyType::Float32, picture);
    EXPECT_NE(header.find("{'descr': '<f4', 'fortran_order': False, 'shape': (720, 1280), }"), std::string::npos);
    const std::uint64_t one[]{7};
    EXPECT_NE(npyHeader(NpyType::Float64, one).find("(7,)"), std::string::npos);
}

TEST_F(Io, NpyGridsHoldTheTopRowFirst)
{
    Grid<std::int64_t> ids(3, 2, -1);
    ids.at(2, 0)                    = 41;
    ids.at(0, 1)                    = 42;
    const NpyRow<std::int64_t> fill = [&ids](int y, std::span<std::int64_t> row) {
        std::ranges::copy(ids.view().row(y), row.begin());
    };
    ASSERT_TRUE(writeNpy(path("ids.npy"), ids.width(), ids.height(), fill));
    const std::string   file    = contentsOf(path("ids.npy"));
    const std::uint64_t shape[] = {2, 3};
    const std::string   header  = npyHeader(NpyType::Int64, shape);
    ASSERT_EQ(file.size(), header.size() + 6 * sizeof(std::int64_t));
    EXPECT_EQ(file.substr(0, header.size()), header);
    std::int64_t values[6];
    std::memcpy(values, file.data() + header.size(), sizeof values);
    const std::int64_t expected[6]{-1, -1, 41, 42, -1, -1};
    EXPECT_TRUE(std::equal(std::begin(values), std::end(values), std::begin(expected)));
}

TEST_F(Io, TriangleArraysHoldOneRowPerTriangle)
{
    Result<NpyTriangleWriter> file = NpyTriangleWriter::create(path("t.npy"), 2);
    ASSERT_TRUE(file);
    const double first[9]{0, 1, 2, 3, 4, 5, 6, 7, 8};
    const double second[9]{9, 10, 11, 12, 13, 14, 15, 16, 0.1};
    file->triangle(first);
    file->triangle(second);
    ASSERT_TRUE(file->commit());
    const std::string contents = contentsOf(path("t.npy"));
    EXPECT_NE(contents.find("'<f8', 'fortran_order': False, 'shape': (2, 3, 3)"), std::string::npos);
    double last = 0;
    std::memcpy(&last, contents.data() + contents.size() - sizeof last, sizeof last);
    EXPECT_EQ(last, 0.1);
}

TEST_F(Io, AnArrayThatIsCancelledIsAbsent)
{
    std::atomic<bool>   cancel = false;
    const NpyRow<float> fill   = [&cancel](int y, std::span<float>) { cancel = y == 5; };
    const Result<Done>  done   = writeNpy(path("d.npy"), 4, 9, fill, &cancel);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, Trouble::Cancelled);
    EXPECT_EQ(filesInFolder(), 0u);
}

struct ReadPicture {
    Grid<std::uint32_t> argb;
    bool                hasAlpha = false;
};

ReadPicture readPng(const std::string& path)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&image, path.c_str())) << image.message;
    ReadPicture result;
    result.hasAlpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    image.format    = PNG_FORMAT_BGRA;  // 0xAARRGGBB as it lies in little-endian memory
    result.argb.reset(static_cast<int>(image.width), static_cast<int>(image.height));
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, result.argb.values().data(), 0, nullptr)) << image.message;
    return result;
}

TEST_F(Io, PngGivesBackEveryPixel)
{
    std::mt19937 random(20240607);
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{257, 193}, std::pair{1, 300}, std::pair{300, 1}}) {
        for (const bool opaque : {true, false}) {
            Grid<std::uint32_t> picture(width, height);
            for (std::uint32_t& c : picture.values())
                c = static_cast<std::uint32_t>(random()) | (opaque ? 0xFF000000u : 0x01000000u);
            if (!opaque) picture.at(0, 0) = 0x7F102030u;
            ASSERT_TRUE(writePng(path("p.png"), std::as_const(picture).view(), {}));
            const ReadPicture back = readPng(path("p.png"));
            EXPECT_EQ(back.hasAlpha, !opaque);
            EXPECT_EQ(back.argb, picture);
            // libpng's short way stops before the last chunk, whose checksum other readers hold against it.
            using namespace std::string_view_literals;
            EXPECT_TRUE(contentsOf(path("p.png")).ends_with("\0\0\0\0IEND\xAE\x42\x60\x82"sv));
        }
    }
}

TEST_F(Io, PngCarriesTheTextsAndIsTheSameTwice)
{
    const Grid<std::uint32_t>  picture(4, 3, 0xFF336699u);
    const std::vector<PngText> texts = reproducingTexts("zscope-cli render 模型.obj", "0123456789abcdef");
    ASSERT_TRUE(writePng(path("a.png"), picture.view(), texts));
    ASSERT_TRUE(writePng(path("b.png"), picture.view(), texts));
    const std::string file = contentsOf(path("a.png"));
    EXPECT_EQ(file, contentsOf(path("b.png")));
    for (const PngText& text : texts) {
        EXPECT_NE(file.find("iTXt" + text.keyword), std::string::npos) << text.keyword;
        EXPECT_NE(file.find(text.text), std::string::npos) << text.text;
    }
}

/// Flat areas, lines and noise, so that all of zlib's ways are met.
Grid<std::uint32_t> patchwork(int width, int height, std::uint32_t leastAlpha)
{
    std::mt19937        random(7);
    Grid<std::uint32_t> picture(width, height, 0xFFF3F5F8u);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if ((x / 64 + y / 16) % 3 != 0)
                picture.at(x, y) =
                    (static_cast<std::uint32_t>(x / 64 % 2 == 0 ? random() : random() % 2) | leastAlpha << 24);
    return picture;
}

TEST_F(Io, PngIsTheSameByAnyNumberOfThreadsAndComesBackFromManyStrips)
{
    // A row longer than a strip, rows of which some or many make one, rows that are filtered and rows that are not, a
    // last strip of one row, one column of many rows.
    const int longRow = static_cast<int>(kPngStripBytes) / 3 + 1;
    for (const auto& [width, height] : {std::pair{longRow, 3}, std::pair{5001, 241}, std::pair{1280, 720},
                                        std::pair{333, 263 * 3 + 1}, std::pair{1, 300'001}, std::pair{70'001, 1}}) {
        for (const std::uint32_t leastAlpha : {0xFFu, 0x01u}) {
            SCOPED_TRACE(testing::Message() << width << 'x' << height << ' ' << leastAlpha);
            const Grid<std::uint32_t> picture = patchwork(width, height, leastAlpha);
            ASSERT_TRUE(writePng(path("1.png"), picture.view(), {}, {.threads = 1}));
            EXPECT_EQ(readPng(path("1.png")).argb, picture);
            for (const int threads : {2, 3, 8, 0}) {
                ASSERT_TRUE(writePng(path("n.png"), picture.view(), {}, {.threads = threads}));
                EXPECT_EQ(contentsOf(path("n.png")), contentsOf(path("1.png"))) << threads;
            }
        }
    }
}

TEST_F(Io, AFlatPictureTakesLittleHoweverManyStripsItHas)
{
    for (const int width : {1280, 5000}) {
        const Grid<std::uint32_t> picture(width, 3000, 0xFF336699u);
        ASSERT_TRUE(writePng(path("flat.png"), picture.view(), {}));
        EXPECT_LT(fs::file_size(path("flat.png")) * 500, picture.values().size_bytes()) << width;
    }
}

TEST_F(Io, PngThatIsCancelledIsAbsent)
{
    const Grid<std::uint32_t> picture(640, 480, 0xFF336699u);
    const std::atomic<bool>   cancel = true;
    const Result<Done>        done   = writePng(path("p.png"), picture.view(), {}, {.cancel = &cancel});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, Trouble::Cancelled);
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(Io, PngThatCannotBeWrittenSaysSo)
{
    const Grid<std::uint32_t> picture(64, 64, 0xFF336699u);
    const Result<Done>        done = writePng("/dev/full", picture.view(), {});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, Trouble::Output);
}

}  // namespace
}  // namespace zscope
