#include "cli/program.h"
#include "support/folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace druse {
namespace {

using namespace test;
namespace fs = std::filesystem;


class Apply : public testing::Test {
protected:
    Ended apply(std::vector<std::string> arguments, const std::string& input = {}, Interrupt interrupt = Interrupt::never) const
    {
        arguments.insert(arguments.begin(), "apply");
        return druse(arguments, folder_.path(), input, interrupt);
    }
    /// A run that must end with this line, status 2 and nothing left behind.
    void expect_error(const std::vector<std::string>& arguments, const std::string& line) const
    {
        const std::string before = folder_.listing();
        const Ended ended = apply(arguments);
        EXPECT_EQ(ended.status, 2);
        EXPECT_EQ(ended.err, "druse: " + line + "\n");
        EXPECT_EQ(ended.out, "");
        EXPECT_EQ(folder_.listing(), before);
    }
    void expect_success(const Ended& ended) const
    {
        EXPECT_EQ(ended.status, 0);
        EXPECT_EQ(ended.err, "");
    }

    const Folder folder_;
};

TEST_F(Apply, WritesTheStateAtEachPlaceOfTheCommandLine)
{
    folder_.write("two.druse", "make.tetrahedron\nmake.tetrahedron\n");
    expect_success(apply({"-c", "make.cube", "-o", "1.obj", "-s", "two.druse", "-o", "2.obj", "-c", "document.undo", "-o", "3.obj"}));
    EXPECT_EQ(folder_.listing(), "1.obj 2.obj 3.obj two.druse");
    // A cube has 6 faces, each tetrahedron adds 4.
    for (const auto& [file, faces] : {std::pair("1.obj", 6), std::pair("2.obj", 14), std::pair("3.obj", 10)}) {
        const std::string text = folder_.read(file);
        int count = 0;
        for (std::size_t at = 0; (at = text.find("\nf ", at)) != std::string::npos; ++at) ++count;
        EXPECT_EQ(count, faces) << file;
    }
}

TEST_F(Apply, WritesNothingIfAnythingFailsLater)
{
    folder_.write("old.obj", "as it was");
    expect_error({"-c", "make.cube", "-o", "old.obj", "-o", "new.stl", "-c", "make.cube size=0"}, "make.cube: size=0: expected above 0 model units");
    expect_error({"-c", "make.cube", "-o", "new.obj", "-o", "no/folder.obj"}, "no/folder.obj: there is no folder 'no'");
    EXPECT_EQ(folder_.read("old.obj"), "as it was");
}

TEST_F(Apply, SaysInOneLineWhatIsWrongWithACommand)
{
    expect_error({"-c", "extrude.dodecahedral angle=270"}, "extrude.dodecahedral: angle=270: expected 1 to 179 degrees");
    expect_error({"-c", "extrude.dodecahedral height=2"}, "extrude.dodecahedral: unknown parameter 'height'; did you mean 'heights'?");
    expect_error({"-c", "extrude.dodecahedron"}, "unknown operator 'extrude.dodecahedron'; did you mean 'extrude.dodecahedral'?");
    expect_error({"-c", "make.cube", "-c", "document.undo", "-c", "document.undo"}, "document.undo: there is nothing to undo");
}

TEST_F(Apply, SaysInOneLineWhatIsWrongWithAFile)
{
    folder_.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    const Ended ended = apply({"bad.obj", "-o", "x.obj"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(ended.err.starts_with("druse: bad.obj:4: ")) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1);
    expect_error({"none.obj"}, "none.obj: no such file");
    expect_error({"-s", "none.druse"}, "none.druse: no such file");
    folder_.write("s.druse", "make.cube\n\nmake.cube size=x\n");
    expect_error({"-s", "s.druse"}, "s.druse:3: make.cube: size=x: expected above 0 model units");
    expect_error({"s.druse"}, "s.druse:3: make.cube: size=x: expected above 0 model units");
}

TEST_F(Apply, SaysInOneLineWhatIsWrongWithItsUse)
{
    expect_error({}, "apply: expected a file, -c COMMAND, -s SCRIPT or -o OUT");
    expect_error({"a.obj", "b.obj"}, "apply: 'b.obj' is one argument too many");
    expect_error({"--fromat", "obj"}, "apply: unknown option '--fromat'; did you mean '--format'?");
    expect_error({"-c", "make.cube", "-o", "-"}, "standard output: needs --format");
    expect_error({"-"}, "standard input: needs --format");
}

TEST_F(Apply, ReadsAndWritesStandardStreams)
{
    const Ended written = apply({"-c", "make.cube", "-o", "-", "--format", "obj"});
    EXPECT_EQ(written.status, 0);
    EXPECT_NE(written.out.find("\nf "), std::string::npos);
    const Ended copied = apply({"-", "--format", "obj", "-o", "-"}, written.out);
    EXPECT_EQ(copied.status, 0);
    EXPECT_EQ(copied.out, written.out);
    EXPECT_EQ(folder_.listing(), "");

    const Ended script = apply({"-", "--format", "druse", "-o", "-"}, "make.cube # one\nmake.torus\n");
    EXPECT_EQ(script.status, 0);
    EXPECT_EQ(script.out, "make.cube\nmake.torus\n");
    const Ended bad = apply({"-", "--format", "druse"}, "make.cube\nmake.cub\n");
    EXPECT_EQ(bad.err, "druse: standard input:2: unknown operator 'make.cub'; did you mean 'make.cube'?\n");
}

TEST_F(Apply, CannotWriteTheHistoryOfAModelFromStandardInput)
{
    const Ended ended = apply({"-", "--format", "obj", "-o", "x.druse"}, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "druse: the document began with standard input, which a script cannot open again\n");
    EXPECT_EQ(folder_.listing(), "");
}

TEST_F(Apply, GivesTheSameBytesEveryTime)
{
    const std::vector<std::string> session{models + "/dodecahedron.obj", "-c", "extrude.icosahedral faces=group:2", "-c", "remesh.doo_sabin", "-o"};
    std::vector<std::string> a = session, b = session;
    a.insert(a.end(), {"a.obj", "-o", "a.stl", "-o", "a.dlfl"});
    b.insert(b.end(), {"b.obj", "-o", "b.stl", "-o", "b.dlfl"});
    EXPECT_EQ(apply(a).status, 0);
    EXPECT_EQ(apply(b).status, 0);
    EXPECT_EQ(folder_.read("a.stl"), folder_.read("b.stl"));
    EXPECT_EQ(folder_.read("a.mtl"), folder_.read("b.mtl"));
    for (const char* extension : {".obj", ".dlfl"}) { // the first names its .mtl
        std::string first = folder_.read(std::string("a") + extension), second = folder_.read(std::string("b") + extension);
        const auto at = first.find("a.mtl");
        if (at != std::string::npos) first.replace(at, 5, "b.mtl");
        EXPECT_EQ(first, second) << extension;
    }
}

TEST_F(Apply, WritesAHistoryThatGivesTheSameBytes)
{
    EXPECT_EQ(apply({models + "/colored_cube.obj", "-c", "extrude.dodecahedral faces=group:2 iterations=2", "-c", "select.faces faces=sides:5", "-c",
                     "extrude.cubical heights=0.3", "-o", "out.obj", "-o", "history.druse"})
                  .status,
              0);
    const std::string obj = folder_.read("out.obj"), mtl = folder_.read("out.mtl"), history = folder_.read("history.druse");
    EXPECT_TRUE(history.starts_with("document.open file=")) << history;
    EXPECT_EQ(apply({"history.druse", "-o", "out.obj", "-o", "again.druse"}).status, 0);
    EXPECT_EQ(folder_.read("out.obj"), obj);
    EXPECT_EQ(folder_.read("out.mtl"), mtl);
    EXPECT_EQ(folder_.read("again.druse"), history);
}

TEST_F(Apply, PrintsWhatQueriesFindAndFailsIfTheyAreStrict)
{
    const Ended fine = apply({"-c", "make.cube", "-c", "check.manifold strict=true", "-o", "x.stl"});
    EXPECT_EQ(fine.status, 0);
    EXPECT_TRUE(fine.out.starts_with("{")) << fine.out;
    EXPECT_EQ(folder_.listing(), "x.stl");
    const Ended warped = apply({"-c", "make.cube", "-c", "mesh.transform vertices=0 move=0.3,0.1,0", "-c", "check.planarity strict=true", "-o", "y.stl"});
    EXPECT_EQ(warped.status, 2);
    EXPECT_TRUE(warped.out.starts_with("{")) << warped.out;
    EXPECT_EQ(warped.err, "druse: check.planarity: found something wrong, and strict=true\n");
    EXPECT_EQ(folder_.listing(), "x.stl");
}

TEST_F(Apply, SaysNotesOnlyIfItSucceeds)
{
    const std::vector<std::string> grouped{models + "/colored_cube.obj", "-o", "x.stl"};
    EXPECT_EQ(apply(grouped).err, "note: groups are not saved in STL\n");
    std::vector<std::string> failing = grouped;
    failing.insert(failing.end(), {"-c", "make.cub"});
    EXPECT_EQ(apply(failing).err, "druse: unknown operator 'make.cub'; did you mean 'make.cube'?\n");
}

TEST_F(Apply, EndsWith130AndLeavesNothingWhenInterrupted)
{
    // It speaks when it begins, and then has work for many seconds.
    std::vector<std::string> arguments{"-c", "make.grid nx=320 ny=320", "-o", "x.obj", "-c", "check.manifold"};
    for (int i = 0; i < 200; ++i) arguments.insert(arguments.end(), {"-c", "extrude.dodecahedral faces=0-99999", "-c", "document.undo"});
    const Ended ended = apply(arguments, {}, Interrupt::when_it_speaks);
    EXPECT_EQ(ended.status, 130);
    EXPECT_EQ(ended.err, "druse: cancelled\n");
    EXPECT_EQ(folder_.listing(), "");
}

TEST_F(Apply, SaysWhenStandardOutputTakesNoMore)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    const Ended ended = run_program("sh", {"-c", std::string(DRUSE_PROGRAM) + " ops > /dev/full"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "druse: standard output: cannot be written: No space left on device\n");
}

TEST_F(Apply, ChangesNoFileWhenStandardOutputTakesNoMore)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    const std::string command = std::string(DRUSE_PROGRAM) + " apply -c make.cube -o a.obj -o - -o b.obj --format obj ";
    for (const auto& [where, reason] : {std::pair("> /dev/full", "No space left on device"), std::pair(">&-", "Bad file descriptor")}) {
        const Ended ended = run_program("sh", {"-c", command + where}, folder_.path().string());
        EXPECT_EQ(ended.status, 2) << where;
        EXPECT_EQ(ended.err, std::string("druse: standard output: cannot be written: ") + reason + "\n");
        EXPECT_EQ(folder_.listing(), "") << where;
    }
}

TEST_F(Apply, LeavesNothingWhenItsReaderGoesAway)
{
    const std::string pipe = std::string(DRUSE_PROGRAM) + " apply -c 'make.grid nx=500 ny=500' -o a.obj -o - --format obj 2> errors | head -c 10 > begin";
    run_program("sh", {"-c", pipe}, folder_.path().string());
    EXPECT_EQ(folder_.listing(), "begin errors");
}

TEST_F(Apply, PrintsNoControlCharactersInErrors)
{
    const Ended ended = apply({"no\nsuch\x1b[31m.obj"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "druse: no?such?[31m.obj: no such file\n");
}

TEST_F(Apply, WritesPanesAndRefusesTheirEditsByOneWord)
{
    const std::string square = "pane.new loop=0,0,10,0,10,10,0,10";
    expect_success(apply({"-c", square, "-c", "pane.add at=5,5", "-o", "a.pane.json"}));
    expect_success(apply({"a.pane.json", "-o", "b.pane.json"}));
    EXPECT_EQ(folder_.read("b.pane.json"), folder_.read("a.pane.json"));
    expect_error({"a.pane.json", "-c", "pane.add at=12,5", "-o", "c.pane.json"}, "pane.add: outside: (12, 5) is outside the boundary");
    expect_error({"a.pane.json", "-c", "pane.move point=0 to=6,7", "-o", "c.pane.json"}, "pane.move: swallows-point: point 4 would be outside");
    expect_error({"a.pane.json", "-c", "pane.refine min_angle=31"}, "pane.refine: min_angle=31: angle-too-large: expected 0 to 30 degrees");
    expect_error({"a.pane.json", "-o", "c.obj"}, "c.obj: the document holds no faces and no graph to write");
    expect_error({"-c", "graph.lattice", "-o", "c.pane.json"}, "c.pane.json: the document holds a graph, not a pane");
    folder_.write("bad.pane.json", "{\n\"format\":\"druse-pane\",\n\"points\":[[0,0],[1,null]]}");
    expect_error({"bad.pane.json"}, "bad.pane.json:3: points[1][1]: expected a number, found null");
}

} // namespace
} // namespace druse
