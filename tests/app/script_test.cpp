#include "app/script.h"

#include "app/documents.h"
#include "app/registry.h"
#include "app/save.h"
#include "io/output.h"

#include <fmt/format.h>

namespace druse {
namespace {

using namespace test;
namespace fs = std::filesystem;

std::string complaint_of_opening(const fs::path& file)
{
    Document document(all_operators());
    Progress progress;
    try {
        document.open(file, progress);
    } catch (const InputError& e) {
        return e.what();
    }
    return {};
}

/// The bytes that a document is written as.
std::string written(const Document& document, const Folder& folder, const std::string& name)
{
    OutputSet output;
    write_document(document, output, folder / name);
    output.commit();
    return folder.read(name);
}

TEST(Script, GivesTheSameBytesAsTheSessionItWasSavedFrom)
{
    const Folder folder;
    Document session(all_operators());
    Progress progress;
    session.open(fs::path(DRUSE_MODELS) / "colored_cube.obj", progress);
    for (const char* command :
         {"extrude.dodecahedral faces=group:2 iterations=2", "select.faces faces=sides:5", "document.undo", "make.torus", "document.undo",
          "group.assign faces=0 id=new", "extrude.icosahedral faces=group:3", "remesh.doo_sabin", "select.faces faces=0",
          "select.similar by=sides", "group.by rule=sides"})
        session.apply(command);
    const std::string obj = written(session, folder, "a.obj"), stl = written(session, folder, "a.stl"), script = written(session, folder, "a.druse");

    Document again(all_operators());
    again.open(folder / "a.druse", progress);
    EXPECT_EQ(State(again), State(session));
    const std::string mtl = folder.read("a.mtl");
    EXPECT_EQ(written(again, folder, "a.obj"), obj);
    EXPECT_EQ(folder.read("a.mtl"), mtl);
    EXPECT_EQ(written(again, folder, "a.stl"), stl);
    EXPECT_EQ(written(again, folder, "a.druse"), script);
}

TEST(Script, IsReadLineByLineWithCommentsAndAnyLineEnds)
{
    const Folder folder;
    folder.write("s.druse", "\xef\xbb\xbf# a comment\r\n\r\nmake.cube # another\r\n\tmake.torus\nmake.prism n=5");
    Document document(all_operators());
    Progress progress;
    document.open(folder / "s.druse", progress);
    EXPECT_EQ(document.script({}), "make.cube\nmake.torus\nmake.prism n=5\n");
    document.apply("document.undo steps=3");
}

TEST(Script, IsKnownByItsExtensionInEitherCase)
{
    for (const char* name : {"a.druse", "a.DRUSE", "x/a.b.Druse"}) EXPECT_TRUE(is_script(name)) << name;
    for (const char* name : {"druse", "a.druse.obj", "a.drus", "a.", ""}) EXPECT_FALSE(is_script(name)) << name;
}

TEST(Script, NamesFileLineAndOperatorInErrors)
{
    const Folder folder;
    const std::string name = folder.write("s.druse", "make.cube\n\n# x\nmake.cube size=0\n").string();
    EXPECT_EQ(complaint_of_opening(name), name + ":4: make.cube: size=0: expected above 0 model units");
    folder.write("s.druse", "make.cub\n");
    EXPECT_EQ(complaint_of_opening(name), name + ":1: unknown operator 'make.cub'; did you mean 'make.cube'?");
    folder.write("s.druse", "make.cube\nopen file=none.obj\n");
    EXPECT_EQ(complaint_of_opening(name), name + ":2: document.open: " + (folder / "none.obj").string() + ": no such file");
    folder.write("s.druse", std::string("make.cube\0\n", 11));
    EXPECT_EQ(complaint_of_opening(name), name + ":1: a command is one line without control characters");
}

TEST(Script, NamesFilesRelativeToItsFolder)
{
    const Folder folder;
    fs::copy_file(fs::path(DRUSE_MODELS) / "cube.obj", folder / "cube.obj");
    folder.write("deep/down/s.druse", "document.open file=../../cube.obj\nmake.torus\ndocument.open file=../../cube.obj\n");
    Document document(all_operators());
    Progress progress;
    document.open(folder / "deep/down/s.druse", progress);
    EXPECT_EQ(document.scene().mesh.face_count(), 6u);
    EXPECT_EQ(document.script(folder.path()), "document.open file=cube.obj\nmake.torus\ndocument.open file=cube.obj\n");
    EXPECT_EQ(document.script(folder / "deep"), "document.open file=../cube.obj\nmake.torus\ndocument.open file=../cube.obj\n");
    EXPECT_EQ(document.script(folder / "deep/down"), "document.open file=../../cube.obj\nmake.torus\ndocument.open file=../../cube.obj\n");
}

TEST(Script, NamesFilesAsTheFoldersReallyAre)
{
    // Where the script's folder is a link, `..` does not lead to the folder that holds the link.
    const Folder folder;
    fs::copy_file(fs::path(DRUSE_MODELS) / "cube.obj", folder / "cube.obj");
    fs::create_directories(folder / "a/b");
    fs::create_directory_symlink(folder / "a/b", folder / "link");
    Document document(all_operators());
    Progress progress;
    document.apply("document.open file=cube.obj", progress, folder.path());
    EXPECT_EQ(document.script(folder / "link"), "document.open file=../../cube.obj\n");
}

TEST(Script, KeepsAnAbsoluteNameOfAFileElsewhere)
{
    const Folder folder;
    const std::string cube = fs::canonical(fs::path(DRUSE_MODELS) / "cube.obj").string();
    Document document(all_operators());
    Progress progress;
    document.open(cube, progress);
    EXPECT_EQ(document.script(folder.path()), fmt::format("document.open {}\n", argument_text("file", cube)));
    EXPECT_EQ(document.script(fs::path(cube).parent_path()), "document.open file=cube.obj\n");
}

TEST(Script, QuotesFileNamesWithBlanks)
{
    const Folder folder;
    fs::copy_file(fs::path(DRUSE_MODELS) / "cube.obj", folder / "a cube #1.obj");
    Document document(all_operators());
    Progress progress;
    document.open(folder / "a cube #1.obj", progress);
    EXPECT_EQ(document.script(folder.path()), "document.open file=\"a cube #1.obj\"\n");
    folder.write("s.druse", document.script(folder.path()));
    document.open(folder / "s.druse", progress);
    EXPECT_EQ(document.scene().mesh.face_count(), 6u);
}

TEST(Script, MayOpenAnotherButNotItself)
{
    const Folder folder;
    folder.write("inner.druse", "make.cube\nextrude.cubical faces=0\n");
    folder.write("outer.druse", "make.torus\ndocument.open file=inner.druse\nselect.faces faces=0\n");
    Document document(all_operators());
    Progress progress;
    document.open(folder / "outer.druse", progress);
    EXPECT_EQ(document.scene().mesh.face_count(), 10u);
    EXPECT_EQ(document.history().size(), 3u);
    EXPECT_EQ(document.script(folder.path()), "make.torus\ndocument.open file=inner.druse\nselect.faces faces=0\n");

    const std::string self = folder.write("self.druse", "open file=self.druse\n").string();
    EXPECT_EQ(complaint_of_opening(self), self + ":1: document.open: " + self + ": this script is being run already: it would open itself without end");
    const std::string a = folder.write("a.druse", "make.cube\nopen file=b.druse\n").string();
    folder.write("b.druse", "make.cube\nopen file=./x/../a.druse\n");
    fs::create_directory(folder / "x");
    EXPECT_NE(complaint_of_opening(a).find("this script is being run already"), std::string::npos);
}

TEST(Script, MayBeNestedOnlySoDeep)
{
    const Folder folder;
    for (int i = 0; i < 40; ++i) folder.write(fmt::format("{}.druse", i), fmt::format("make.cube\nopen file={}.druse\n", i + 1));
    folder.write("40.druse", "make.cube\n");
    EXPECT_NE(complaint_of_opening(folder / "0.druse").find("scripts open each other more than 16 deep"), std::string::npos);
    EXPECT_EQ(complaint_of_opening(folder / "30.druse"), "");
}

TEST(Script, LeavesTheDocumentAsItWasIfOpeningItFails)
{
    const Folder folder;
    folder.write("s.druse", "make.torus\nmake.cube size=0\n");
    Document document(all_operators());
    Progress progress;
    document.apply("make.cube");
    const State before(document);
    EXPECT_THROW(document.open(folder / "s.druse", progress), InputError);
    EXPECT_EQ(State(document), before);
    EXPECT_THROW(document.apply("document.open file=s.druse", progress, folder.path()), InputError);
    EXPECT_EQ(State(document), before);
    EXPECT_EQ(document.script({}), "make.cube\n");
}

TEST(Script, StopsAtAStrictCheckThatFails)
{
    const Folder folder;
    const std::string name = folder.write("s.druse", "make.cube\ntopology.create_vertex at=5,5,5\nmesh.transform vertices=0 move=0.3,0,0\n"
                                                     "check.planarity strict=true\nmake.torus\n")
                                 .string();
    Document document(all_operators());
    Progress progress;
    document.apply("make.prism");
    const State before(document);
    const Document::Outcome outcome = document.open(name, progress);
    EXPECT_TRUE(outcome.failed);
    EXPECT_EQ(outcome.failure, name + ":4: check.planarity: found something wrong, and strict=true");
    EXPECT_EQ(State(document), before);

    const std::string outer = folder.write("outer.druse", "document.open file=s.druse\n").string();
    EXPECT_EQ(document.open(outer, progress).failure, outer + ":1: document.open: " + name + ":4: check.planarity: found something wrong, and strict=true");
}

TEST(Script, CannotBeMadeOfADocumentThatBeganWithoutAFile)
{
    Document document = document_of(all_operators(), Mesh());
    EXPECT_THROW(document.script({}), CommandError);
}

TEST(Script, MustNotBeTooLarge)
{
    const Folder folder;
    folder.write("s.druse", std::string(Script::most_bytes + 1, '\n'));
    EXPECT_EQ(complaint_of_opening(folder / "s.druse"), (folder / "s.druse").string() + ": expected a script of at most 64 MiB");
}

} // namespace
} // namespace druse
