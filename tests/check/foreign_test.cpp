// Files of other programs: every format gives back the numbers that were written, and whatever is malformed gives one
// sentence that names the file, at once.
#include <chrono>

#include "tests/check/check_support.h"

namespace zscope::tests {
namespace {

using check::readDepth, check::readIds, check::readPicture, check::readDump;

constexpr int kWidth = 5, kHeight = 3;

std::string npy(const std::string& description, const std::string& data, bool isFortran = false, int version = 1,
                const std::string& shape = "(3, 5)")
{
    std::string header = "{'descr': '" + description + "', 'fortran_order': " + (isFortran ? "True" : "False")
                         + ", 'shape': " + shape + ", }\n";
    std::string bytes = std::string("\x93NUMPY") + static_cast<char>(version) + '\0';
    if (version == 1)
        append(bytes, static_cast<std::uint16_t>(header.size()));
    else
        append(bytes, static_cast<std::uint32_t>(header.size()));
    return bytes + header + data;
}

/// The numbers 0, 1, 2, ... as `T`, in either byte order.
template <class T>
std::string counting(bool isBig, bool isFortran = false)
{
    std::string data;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        std::string one;
        append(one, static_cast<T>(isFortran ? i % kHeight * kWidth + i / kHeight : i));
        if (isBig) std::ranges::reverse(one);
        data += one;
    }
    return data;
}

class Foreign : public CheckFiles {
protected:
    void expectCounting(const Grid<double>& grid, double unit, const std::string& what)
    {
        for (int i = 0; i < kWidth * kHeight; ++i)
            EXPECT_DOUBLE_EQ(grid.values()[static_cast<std::size_t>(i)], i * unit) << what << ' ' << i;
    }
    template <class Read>
    void expectRefused(const std::string& file, const Read& read)
    {
        const auto                          begin  = std::chrono::steady_clock::now();
        const auto                          result = read(file);
        const std::chrono::duration<double> took   = std::chrono::steady_clock::now() - begin;
        ASSERT_FALSE(result) << file;
        EXPECT_EQ(result.error().kind, Trouble::Input) << result.error().text();
        EXPECT_EQ(result.error().file, file);
        EXPECT_GT(result.error().sentence.size(), 10u);
        EXPECT_EQ(result.error().sentence.find('\n'), std::string::npos);
        EXPECT_LT(took.count(), 2) << file;
    }
};

const auto readDepthHere   = [](const std::string& file) { return readDepth(file, kWidth, kHeight); };
const auto readIdsHere     = [](const std::string& file) { return readIds(file, kWidth, kHeight); };
const auto readPictureHere = [](const std::string& file) { return readPicture(file, kWidth, kHeight); };

TEST_F(Foreign, NpyFloatsComeBackInEitherByteOrderAndLayoutAndHeaderVersion)
{
    for (const bool isBig : {false, true})
        for (const bool isFortran : {false, true})
            for (const int version : {1, 2, 3}) {
                const std::string order = isBig ? ">" : "<";
                const auto        four  = readDepthHere(
                            write("four.npy", npy(order + "f4", counting<float>(isBig, isFortran), isFortran, version)));
                const auto eight = readDepthHere(
                    write("eight.npy", npy(order + "f8", counting<double>(isBig, isFortran), isFortran, version)));
                ASSERT_TRUE(four && eight);
                expectCounting(four->values, 1, "float32");
                expectCounting(eight->values, 1, "float64");
            }
    std::string half;
    for (const int bits : {0x0000, 0x3c00, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600, 0x4700, 0x4800, 0x4880, 0x4900,
                           0x4980, 0x4a00, 0x4a80, 0x4b00})
        append(half, static_cast<std::uint16_t>(bits));
    const auto two = readDepthHere(write("two.npy", npy("<f2", half)));
    ASSERT_TRUE(two);
    expectCounting(two->values, 1, "float16");
    EXPECT_EQ(two->resolution.at(1.5), 0x1p-10);
}

TEST_F(Foreign, UnsignedDepthsAreFractionsOfTheirLargestValue)
{
    const auto expect = [&]<class T>(T most, const std::string& type) {
        const auto depth = readDepthHere(write("d.npy", npy(type, counting<T>(type[0] == '>'))));
        ASSERT_TRUE(depth) << type;
        expectCounting(depth->values, 1 / static_cast<double>(most), type);
        EXPECT_DOUBLE_EQ(depth->resolution.at(0), 1 / static_cast<double>(most));
    };
    expect(std::uint8_t{255}, "|u1");
    expect(std::uint16_t{65535}, ">u2");
    expect(std::uint32_t{4294967295}, "<u4");
    expect(std::numeric_limits<std::uint64_t>::max(), "<u8");
}

TEST_F(Foreign, IdsOfEveryIntegerTypeComeBack)
{
    const auto expect = [&]<class T>(T, const std::string& type) {
        const auto ids = readIdsHere(write("i.npy", npy(type, counting<T>(type[0] == '>'))));
        ASSERT_TRUE(ids) << type;
        for (int i = 0; i < kWidth * kHeight; ++i)
            EXPECT_EQ(ids->values.values()[static_cast<std::size_t>(i)], i) << type;
    };
    expect(std::int8_t{}, "|i1"), expect(std::uint8_t{}, "|u1");
    expect(std::int16_t{}, "<i2"), expect(std::uint16_t{}, ">u2");
    expect(std::int32_t{}, ">i4"), expect(std::uint32_t{}, "<u4");
    expect(std::int64_t{}, "<i8"), expect(std::uint64_t{}, ">u8");
    std::string negative;
    for (int i = 0; i < kWidth * kHeight; ++i) append(negative, std::int16_t{-1});
    EXPECT_EQ(readIdsHere(write("n.npy", npy("<i2", negative)))->values.values()[3], -1);
}

TEST_F(Foreign, RawAndPfmAndDepthPngComeBack)
{
    const auto raw = readDepthHere(write("d.raw", counting<float>(false)));
    ASSERT_TRUE(raw);
    expectCounting(raw->values, 1, "raw");
    const auto ids = readIdsHere(write("i.raw", counting<std::int32_t>(false)));
    ASSERT_TRUE(ids);
    EXPECT_EQ(ids->values.at(4, 2), 14);

    for (const bool isBig : {false, true}) {
        const auto pfm = readDepthHere(
            write("d.pfm", std::string("Pf\n5 3\n") + (isBig ? "1.0\n" : "-1.0\n") + counting<float>(isBig)));
        ASSERT_TRUE(pfm) << pfm.error().text();
        EXPECT_EQ(pfm->values.at(0, 0), 10) << "the bottom line comes first in the file";
        EXPECT_EQ(pfm->values.at(4, 2), 4);
    }
}

TEST_F(Foreign, PicturesComeBackTopRowFirst)
{
    std::string p6 = "P6 # a comment\n5 3\n255\n", p3 = "P3\n5 3 255\n", bmp = "BM";
    for (int i = 0; i < 15; ++i) {
        p6 += static_cast<char>(i), p6 += '\1', p6 += '\2';
        p3 += std::to_string(i) + " 1 2\n";
    }
    const auto u32 = [&bmp](std::uint32_t value) { append(bmp, value); };
    u32(54 + 48), u32(0), u32(54), u32(40), u32(5), u32(3);
    append(bmp, std::uint16_t{1}), append(bmp, std::uint16_t{24});
    u32(0), u32(48), u32(0), u32(0), u32(0), u32(0);
    for (int y = 2; y >= 0; --y) {
        for (int x = 0; x < 5; ++x) bmp += '\2', bmp += '\1', bmp += static_cast<char>(5 * y + x);
        bmp += '\0';
    }
    for (const auto& [name, bytes] : {std::pair("a.ppm", p6), std::pair("b.ppm", p3), std::pair("c.bmp", bmp)}) {
        const auto picture = readPictureHere(write(name, bytes));
        ASSERT_TRUE(picture) << picture.error().text();
        for (std::uint32_t i = 0; i < 15; ++i) EXPECT_EQ(picture->values()[i], i << 16 | 0x0102) << name;
    }
}

TEST_F(Foreign, MalformedFilesGiveOneSentenceAtOnce)
{
    const std::string good = npy("<f4", counting<float>(false));
    for (std::size_t length = 0; length < good.size(); length += 7)
        expectRefused(write("cut.npy", good.substr(0, length)), readDepthHere);
    expectRefused(write("long.npy", good + "x"), readDepthHere);
    expectRefused(write("text.npy", "these are words"), readDepthHere);
    expectRefused(write("other.npy", npy("<f4", counting<float>(false), false, 1, "(5, 3)")), readDepthHere);
    expectRefused(write("flat.npy", npy("<f4", counting<float>(false), false, 1, "(15,)")), readDepthHere);
    expectRefused(write("huge.npy", npy("<f8", "", false, 1, "(40000, 40000)")), readDepthHere);
    expectRefused(write("overflow.npy", npy("<f8", "", false, 1, "(4294967296, 4294967296)")), readDepthHere);
    expectRefused(write("complex.npy", npy("<c8", counting<double>(false))), readDepthHere);
    expectRefused(write("object.npy", npy("|O", counting<double>(false))), readDepthHere);
    expectRefused(write("signed.npy", npy("<i4", counting<float>(false))), readDepthHere);
    expectRefused(write("float.npy", good), readIdsHere);
    expectRefused(write("short.raw", "abc"), readDepthHere);
    expectRefused(write("short2.raw", "abc"), readIdsHere);
    expectRefused(write("header.pfm", "Pf\n5 3\nx\n"), readDepthHere);
    expectRefused(write("size.pfm", "Pf\n99999999999 99999999999\n-1\n"), readDepthHere);
    expectRefused(write("cut.pfm", "Pf\n5 3\n-1.0\nabc"), readDepthHere);
    expectRefused(write("text.png", "\x89PNG\r\n\x1a\nnot at all"), readDepthHere);
    expectRefused(write("text2.png", "\x89PNG\r\n\x1a\nnot at all"), readIdsHere);
    expectRefused(write("unknown.txt", good), readDepthHere);
    expectRefused(write("unknown.ids", good), readIdsHere);
    expectRefused(write("cut.ppm", "P6\n5 3\n255\nabc"), readPictureHere);
    expectRefused(write("cut3.ppm", "P3\n5 3\n255\n1 2 3"), readPictureHere);
    expectRefused(write("size.ppm", "P6\n100000 100000\n255\n"), readPictureHere);
    expectRefused(write("cut.bmp", "BM123"), readPictureHere);
    expectRefused(write("zeros.bmp", "BM" + std::string(60, '\0')), readPictureHere);
    expectRefused(write("words.png", "words"), readPictureHere);
    expectRefused(path("absent.npy"), readDepthHere);
    std::filesystem::create_directory(path("folder.npy"));
    expectRefused(path("folder.npy"), readDepthHere);
}

std::string dump(std::uint32_t contents, bool isBig = false, std::uint32_t rows = 0)
{
    std::string bytes = "ZSDUMP1\n";
    const auto  put   = [&](auto value) {
        std::string one;
        append(one, value);
        if (isBig) std::ranges::reverse(one);
        bytes += one;
    };
    for (const std::uint32_t word : {0x01020304u, 5u, 3u, contents, rows, 2u, 3u, 2u, 0u}) put(word);
    if (contents & 4)
        for (int i = 0; i < 16; ++i) put(i + 0.5);
    if (contents & 8)
        for (int i = 0; i < 16; ++i) put(i + 0.25);
    if (contents & 1)
        for (int i = 0; i < 15; ++i) put(static_cast<float>(i) + 0.1f);
    if (contents & 2)
        for (int i = 0; i < 15; ++i) put(std::int32_t{i - 1});
    return bytes;
}

TEST_F(Foreign, DumpsComeBackToTheBitInEitherByteOrder)
{
    for (const bool isBig : {false, true}) {
        const auto read = readDump(write("d.zdump", dump(15, isBig, 2)));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->width, 5);
        EXPECT_EQ(read->height, 3);
        EXPECT_EQ(read->rows, check::Rows::BottomUp);
        EXPECT_EQ(read->order, check::MatrixOrder::Columns);
        EXPECT_EQ(read->range, check::DepthRange::Reversed);
        EXPECT_EQ(read->idsFrom, 1);
        EXPECT_EQ((*read->view)[3], 3.5);
        EXPECT_EQ((*read->projection)[15], 15.25);
        EXPECT_EQ(read->depth->values.at(4, 2), 14 + 0.1f);
        EXPECT_EQ(read->ids->values.at(0, 0), -1);
        EXPECT_EQ(read->ids->values.at(4, 2), 13);
    }
    const auto depthOnly = readDump(write("e.zdump", dump(1)));
    ASSERT_TRUE(depthOnly);
    EXPECT_FALSE(depthOnly->ids || depthOnly->view || depthOnly->projection || depthOnly->rows);
}

TEST_F(Foreign, DamagedDumpsAreRefused)
{
    const std::string good = dump(15);
    for (std::size_t length = 0; length < good.size(); length += 5)
        expectRefused(write("cut.zdump", good.substr(0, length)), readDump);
    expectRefused(write("long.zdump", good + "x"), readDump);
    for (std::size_t word = 0; word < 9; ++word) {
        std::string bad       = good;
        bad[8 + 4 * word + 3] = '\x7f';  // the most significant byte
        expectRefused(write("bad.zdump", bad), readDump);
    }
    expectRefused(write("none.zdump", dump(12)), readDump);
}

}  // namespace
}  // namespace zscope::tests
