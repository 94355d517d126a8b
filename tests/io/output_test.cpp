#include "io/output.h"

#include "io/io_support.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace druse::test {
namespace {

namespace fs = std::filesystem;

Mesh grouped_cube()
{
    Mesh mesh = cube();
    mesh.set_group(Face(0), 1);
    return mesh;
}

mode_t mode(const fs::path& path)
{
    struct stat status {};
    return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

TEST(OutputSet, ShowsNothingBeforeTheCommit)
{
    const TemporaryFolder folder;
    OutputSet out;
    out.write({cube(), GroupTable()}, folder / "a.obj");
    EXPECT_FALSE(fs::exists(folder / "a.obj"));
    out.commit();
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.obj"}));
}

TEST(OutputSet, WritesTheStateAtTheTimeOfTheCall)
{
    const TemporaryFolder folder;
    Mesh mesh = cube();
    OutputSet out;
    out.write({mesh, GroupTable()}, folder / "before.obj");
    mesh.clear();
    mesh.create_vertex({1, 2, 3});
    out.write({mesh, GroupTable()}, folder / "after.obj");
    out.commit();
    EXPECT_EQ(read_model(folder / "before.obj").mesh.face_count(), 6u);
    EXPECT_EQ(contents(folder / "after.obj"), "v 1 2 3\np 1\n");
}

TEST(OutputSet, LeavesEverythingAsItWasWithoutACommit)
{
    const TemporaryFolder folder;
    put_contents(folder / "a.obj", "old");
    put_contents(folder / "a.mtl", "old too");
    {
        OutputSet out;
        out.write({grouped_cube(), GroupTable()}, folder / "a.obj");
        out.write({grouped_cube(), GroupTable()}, folder / "b.stl");
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.mtl", "a.obj"}));
    EXPECT_EQ(contents(folder / "a.obj"), "old");
    EXPECT_EQ(contents(folder / "a.mtl"), "old too");
}

TEST(OutputSet, LeavesEverythingAsItWasWhenAWriterFails)
{
    const TemporaryFolder folder;
    put_contents(folder / "a.stl", "old");
    Mesh far = cube();
    far.set_position(Vertex(7), {1e39, 0, 0}); // refused half way through
    {
        OutputSet out;
        out.write({cube(), GroupTable()}, folder / "first.obj");
        EXPECT_THROW(out.write({far, GroupTable()}, folder / "a.stl"), InputError);
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.stl"}));
    EXPECT_EQ(contents(folder / "a.stl"), "old");
}

TEST(OutputSet, ReplacesAFileAndKeepsItsPermissions)
{
    const TemporaryFolder folder;
    put_contents(folder / "a.obj", "old");
    fs::permissions(folder / "a.obj", fs::perms(0640));
    const mode_t mask = umask(0022);
    OutputSet out;
    out.write({grouped_cube(), GroupTable()}, folder / "a.obj");
    out.commit();
    umask(mask);
    EXPECT_EQ(mode(folder / "a.obj"), 0640u);
    EXPECT_EQ(mode(folder / "a.mtl"), 0644u);
    EXPECT_EQ(read_model(folder / "a.obj").mesh.group(Face(0)), 1);
}

TEST(OutputSet, FollowsLinksAndLeavesThemLinks)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "real");
    put_contents(folder / "real/model.obj", "old");
    fs::create_symlink("real/model.obj", folder / "link.obj");
    fs::create_symlink("real/new.obj", folder / "nowhere.obj");
    OutputSet out;
    out.write({grouped_cube(), GroupTable()}, folder / "link.obj");
    out.write({cube(), GroupTable()}, folder / "nowhere.obj");
    out.commit();
    EXPECT_TRUE(fs::is_symlink(folder / "link.obj"));
    EXPECT_TRUE(fs::is_symlink(folder / "nowhere.obj"));
    EXPECT_TRUE(fs::is_regular_file(folder / "real/new.obj"));
    const Model model = read_model(folder / "link.obj"); // its .mtl is found beside the file it leads to
    EXPECT_EQ(model.mesh.group(Face(0)), 1);
    EXPECT_TRUE(model.notes.empty());
}

TEST(OutputSet, LetsTheLastOfTwoOutputsOfOneNameStand)
{
    const TemporaryFolder folder;
    OutputSet out;
    out.write({cube(), GroupTable()}, folder / "a.obj");
    out.write({tetrahedron(), GroupTable()}, folder / "a.obj");
    out.commit();
    EXPECT_EQ(read_model(folder / "a.obj").mesh.face_count(), 4u);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.obj"}));
}

TEST(OutputSet, SaysWhyATargetWillNotDo)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "d.obj");
    const auto error = [](const fs::path& path, const WriteOptions& options = {}) {
        return error_of([&] { OutputSet().write({cube(), GroupTable()}, path, options); });
    };
    const std::string here = folder.path().string();
    EXPECT_EQ(error(folder / "d.obj"), here + "/d.obj: is a folder, not a file");
    EXPECT_EQ(error(folder / "gone/a.obj"), here + "/gone/a.obj: there is no folder '" + here + "/gone'");
    EXPECT_EQ(error(folder / "a.xyz"), here + "/a.xyz: unknown format 'xyz'; expected obj, stl, dlfl, ply, off, glb, gltf, 3mf, pane.json, tile, svg or dxf");
    EXPECT_EQ(error("-"), "standard output: needs --format");
    EXPECT_EQ(error("-", {.format = "x"}), "standard output: unknown format 'x'; expected obj, stl, dlfl, ply, off, glb, gltf, 3mf, pane.json, tile, svg or dxf");
    EXPECT_EQ(error(folder / "a.xyz", {.format = "stl"}), "no error");
    EXPECT_EQ(error_of([&] {
                  OutputSet().write({Mesh(), GroupTable()}, folder / "a.obj");
              }),
              here + "/a.obj: the document holds no faces and no graph to write");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"d.obj"}));
}

TEST(OutputSet, SaysThatADiskIsFull)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    OutputSet out;
    out.write({cube(), GroupTable()}, "/dev/full", {.format = "obj"});
    EXPECT_EQ(error_of([&] { out.commit(); }), "/dev/full: cannot be written: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full")); // and was not replaced
}

TEST(OutputSet, PassesBytesToStandardOutputAtTheCommit)
{
    const TemporaryFolder folder;
    const int file = open((folder / "stdout").c_str(), O_RDWR | O_CREAT, 0600), kept = dup(STDOUT_FILENO);
    std::fflush(stdout);
    dup2(file, STDOUT_FILENO);
    OutputSet out;
    out.write({grouped_cube(), GroupTable()}, "-", {.format = "obj"});
    const bool early = fs::file_size(folder / "stdout") > 0;
    out.commit();
    dup2(kept, STDOUT_FILENO);
    close(kept);
    close(file);
    EXPECT_FALSE(early);
    const Model model = read_text(contents(folder / "stdout"), "obj");
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(out.notes(),
              (std::vector<std::string>{"group colours and names are not saved: there is no place for a .mtl file"}));
}

TEST(OutputSet, TakesWhateverTheCallerWrites)
{
    const TemporaryFolder folder;
    OutputSet out;
    out.open(folder / "note.txt").put(std::string_view("hello\n"));
    EXPECT_FALSE(fs::exists(folder / "note.txt"));
    out.commit();
    EXPECT_EQ(contents(folder / "note.txt"), "hello\n");
}

TEST(OutputSet, KeepsTheNotesOfAllWriters)
{
    const TemporaryFolder folder;
    OutputSet out;
    out.write({grouped_cube(), GroupTable()}, folder / "a.stl");
    out.write({three_lunes(), GroupTable()}, folder / "b.obj");
    EXPECT_EQ(out.notes(), (std::vector<std::string>{"groups are not saved in STL", "2 parallel edges split"}));
}

TEST(ReadModel, IsCancelledWhileItReads)
{
    Progress progress;
    progress.cancel();
    EXPECT_THROW(read_model(std::filesystem::path(DRUSE_MODELS) / "cube.obj", progress), Cancelled);
}

} // namespace
} // namespace druse::test
