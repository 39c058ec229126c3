#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <string>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "core/scene/obj/material_library.h"
#include "tests/core/obj_support.h"

namespace zscope {
namespace {

using test::kSquare;
using test::TemporaryFolder;

const std::string kFaces = std::string(kSquare) + "usemtl red\nf 1 2 3 4\n";

/// The import of a file that must end soon; the future would wait for ever, so the test program is ended.
Result<ObjImport> soon(const std::string& path)
{
    auto import = std::async(std::launch::async, [path] { return importObj(path); });
    if (import.wait_for(std::chrono::seconds(30)) != std::future_status::ready) {
        ADD_FAILURE() << path << " hangs";
        std::abort();
    }
    return import.get();
}

void expectRefused(const std::string& path, const std::string& sentence)
{
    const auto import = soon(path);
    ASSERT_FALSE(import.ok()) << path;
    EXPECT_EQ(import.error().kind, Trouble::Input);
    EXPECT_EQ(import.error().text(), path + ": " + sentence);
}

/// Expects the square with this one warning about its library, and the standard colour.
void expectWithoutLibrary(const std::string& path, const std::string& warning)
{
    const auto import = soon(path);
    ASSERT_TRUE(import.ok()) << import.error().text();
    ASSERT_FALSE(import->warnings.empty());
    EXPECT_NE(import->warnings.front().sentence.find(warning), std::string::npos) << import->warnings.front().sentence;
    EXPECT_EQ(import->warnings.front().line, 1);
    EXPECT_EQ(import->warnings.front().file, path);
    EXPECT_EQ(import->mesh->materialOf(PolygonId{0}).diffuse, Material{}.diffuse);
}

TEST(ObjFile, ThatIsNoFileIsRefusedWithoutWaiting)
{
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo.obj").c_str(), 0600), 0);
    expectRefused(folder / "fifo.obj", "is a FIFO, not a file");
    expectRefused("/dev/zero", "is a device, not a file");
    std::filesystem::create_directory(folder / "directory.obj");
    expectRefused(folder / "directory.obj", "is a directory, not a file");
    expectRefused(folder / "missing.obj", "cannot be opened: No such file or directory");
    const int   server = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    (folder / "s.obj").copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    expectRefused(folder / "s.obj", "is a socket, not a file");
    ::close(server);
}

TEST(ObjFile, ThatIsALinkToADeviceIsRefused)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/zero", folder / "zero.obj");
    expectRefused(folder / "zero.obj", "is a device, not a file");
}

TEST(ObjFile, ThatIsEmptyIsRefused)
{
    const TemporaryFolder folder;
    expectRefused(folder.write("empty.obj", ""), "the file is empty");
}

TEST(ObjFile, ThatMayNotBeReadIsRefused)
{
    if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const TemporaryFolder folder;
    const std::string     path = folder.write("locked.obj", kFaces);
    ::chmod(path.c_str(), 0);
    expectRefused(path, "cannot be opened: Permission denied");
}

TEST(ObjFile, LargerThanTheMemoryLimitIsRefused)
{
    const TemporaryFolder folder;
    const auto            import =
        importObj(folder.write("large.obj", kFaces + std::string(100'000, '\n')), {.memoryLimit = 50'000});
    ASSERT_FALSE(import.ok());
    EXPECT_EQ(import.error().kind, Trouble::Limit);
}

TEST(MaterialLibraries, GiveColourAndOpacity)
{
    const TemporaryFolder folder;
    folder.write("m/colours.mtl",
                 "\xEF\xBB\xBFnewmtl red\r\nKd 1 0.25 0\r\nd 0.5 # half\r\nmap_Kd /dev/zero\r\n"
                 "newmtl glass\nTr 0.75\nnewmtl grey\nKd 0.1\nnewmtl plain\nKs 1 1 1\n"
                 "newmtl red\nKd 0 0 1\nnewmtl bright\nKd 7 -1 0.5\nd -halo 2\n");
    std::string text = "mtllib m/colours.mtl\n" + std::string(kSquare);
    for (const char* name : {"red", "glass", "grey", "plain", "bright"})
        text += std::string("usemtl ") + name + "\nf 1 2 3 4\n";
    const auto import = importObj(folder.write("a.obj", text));
    ASSERT_TRUE(import.ok()) << import.error().text();
    EXPECT_EQ(test::warningsOf(*import),
              std::filesystem::canonical(folder / "m/colours.mtl").string()
                  + ":4: textures ('map_Kd') are not read; materials have the colour of Kd\n");
    const auto material = [&](std::uint32_t polygon) { return import->mesh->materialOf(PolygonId{polygon}); };
    EXPECT_EQ(material(0).diffuse, (Rgb{1, 0.25f, 0})) << "the first of two of the same name";
    EXPECT_EQ(material(0).opacity, 0.5f);
    EXPECT_EQ(material(1).opacity, 0.25f);
    EXPECT_EQ(material(1).diffuse, Material{}.diffuse);
    EXPECT_EQ(material(2).diffuse, (Rgb{0.1f, 0.1f, 0.1f}));
    EXPECT_EQ(material(3).diffuse, Material{}.diffuse);
    EXPECT_EQ(material(4).diffuse, (Rgb{1, 0, 0.5f}));
    EXPECT_EQ(material(4).opacity, 1);
}

TEST(MaterialLibraries, MayComeAfterTheirUseBeSeveralAndHaveBlanksInTheirNames)
{
    const TemporaryFolder folder;
    folder.write("my colours.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("b.mtl", "newmtl blue\nKd 0 0 1\n");
    folder.write("c.mtl", "newmtl green\nKd 0 1 0\n");
    const auto import = importObj(folder.write("a.obj", kFaces
                                                            + "usemtl blue\nf 1 2 3\nusemtl green\nf 1 2 3\n"
                                                              "mtllib my colours.mtl\nmtllib b.mtl .\\c.mtl\n"));
    ASSERT_TRUE(import.ok()) << import.error().text();
    EXPECT_EQ(test::warningsOf(*import), "");
    EXPECT_EQ(import->mesh->materialOf(PolygonId{0}).diffuse, (Rgb{1, 0, 0}));
    EXPECT_EQ(import->mesh->materialOf(PolygonId{1}).diffuse, (Rgb{0, 0, 1}));
    EXPECT_EQ(import->mesh->materialOf(PolygonId{2}).diffuse, (Rgb{0, 1, 0}));
}

TEST(MaterialLibraries, ThatAreMissingAreAWarning)
{
    const TemporaryFolder folder;
    expectWithoutLibrary(folder.write("a.obj", "mtllib gone.mtl\n" + kFaces),
                         "'gone.mtl' cannot be opened: No such file");
    expectWithoutLibrary(folder.write("b.obj", "mtllib\n" + kFaces), "mtllib names no file");
    const auto import = importObj(folder / "a.obj");
    EXPECT_EQ(import->warnings.back().sentence, "material 'red' is in no material library; it has the standard colour");
    EXPECT_EQ(import->warnings.back().line, 6);
}

TEST(MaterialLibraries, OutsideTheFolderAreNeverOpened)
{
    const TemporaryFolder folder;
    folder.write("secret.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("in/keep", "");
    const std::string leadsOut = "leads out of the folder";
    expectWithoutLibrary(folder.write("in/a.obj", "mtllib ../secret.mtl\n" + kFaces), leadsOut);
    expectWithoutLibrary(folder.write("in/b.obj", "mtllib ../../../../../../dev/zero\n" + kFaces), leadsOut);
    expectWithoutLibrary(folder.write("in/c.obj", "mtllib " + folder / "secret.mtl" + "\n" + kFaces), "absolute");
    expectWithoutLibrary(folder.write("in/d.obj", "mtllib /dev/zero\n" + kFaces), "absolute");
    expectWithoutLibrary(folder.write("in/w.obj", "mtllib ..\\secret.mtl\n" + kFaces), leadsOut);
    std::filesystem::create_symlink(folder / "secret.mtl", folder / "in/link.mtl");
    expectWithoutLibrary(folder.write("in/e.obj", "mtllib link.mtl\n" + kFaces), leadsOut);
    std::filesystem::create_directory_symlink(folder / ".", folder / "in/up");
    expectWithoutLibrary(folder.write("in/f.obj", "mtllib up/secret.mtl\n" + kFaces), leadsOut);
    std::filesystem::create_symlink("/dev/zero", folder / "in/zero.mtl");
    expectWithoutLibrary(folder.write("in/g.obj", "mtllib zero.mtl\n" + kFaces), leadsOut);
}

TEST(MaterialLibraries, ThatAreNoFilesAreAWarningAndDoNotHang)
{
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "fifo.mtl").c_str(), 0600), 0);
    expectWithoutLibrary(folder.write("a.obj", "mtllib fifo.mtl\n" + kFaces), "is a FIFO, not a file");
    std::filesystem::create_directory(folder / "folder.mtl");
    expectWithoutLibrary(folder.write("b.obj", "mtllib folder.mtl\n" + kFaces), "is a directory, not a file");
    folder.write("wide.mtl", std::string("\xFF\xFEn\0e\0w\0", 8));
    expectWithoutLibrary(folder.write("c.obj", "mtllib wide.mtl\n" + kFaces), "UTF-16");
    folder.write("large.mtl", std::string(obj::kMaxLibraryBytes + 1, '\n'));
    expectWithoutLibrary(folder.write("d.obj", "mtllib large.mtl\n" + kFaces),
                         "has 16777217 bytes, and at most 16 MiB are read");
}

TEST(MaterialLibraries, WithBadNumbersSayWhereAndKeepTheRest)
{
    const TemporaryFolder folder;
    folder.write("bad.mtl", "Kd 1 1 1\nnewmtl\nnewmtl red\nKd 1,5 0 0\nKd spectral file.rfl\nd nan\nd\nKd 0 1 0\n");
    const auto import = importObj(folder.write("a.obj", "mtllib bad.mtl\n" + kFaces));
    ASSERT_TRUE(import.ok());
    ASSERT_EQ(import->warnings.size(), 5u);
    const std::string path = std::filesystem::canonical(folder / "bad.mtl");
    EXPECT_EQ(import->warnings[0].file, path);
    EXPECT_EQ(import->warnings[0].line, 2);
    EXPECT_EQ(import->warnings[1].sentence, "Kd: '1,5' is not a number; the statement is left out");
    EXPECT_EQ(import->warnings[1].line, 4);
    EXPECT_EQ(import->warnings[3].sentence, "d: 'nan' is not a finite number; the statement is left out");
    EXPECT_EQ(import->warnings[4].sentence, "d: a number is missing; the statement is left out");
    EXPECT_EQ(import->mesh->materialOf(PolygonId{0}).diffuse, (Rgb{0, 1, 0}));
    EXPECT_EQ(import->mesh->materialOf(PolygonId{0}).opacity, 1);
}

TEST(MaterialLibraries, WithoutAnyMaterialAreHarmless)
{
    const TemporaryFolder folder;
    folder.write("none.mtl", "# nothing\n");
    const auto import = importObj(folder.write("a.obj", "mtllib none.mtl\nmtllib none.mtl\n" + kFaces));
    ASSERT_TRUE(import.ok());
    EXPECT_EQ(import->warnings.size(), 1u);
}

}  // namespace
}  // namespace zscope
