#include "ui/autosave.h"

#include "app/registry.h"
#include "io/tile_file.h"
#include "support/folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <unistd.h>

namespace druse::ui {
namespace {

class AutosaveTest : public testing::Test {
protected:
    AutosaveTest() : folder(room / "kept"), session(all_operators()) {}
    void run(const char* command)
    {
        session.run(command);
        session.wait();
    }
    std::size_t files() const { return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {})); }

    const test::Folder room;
    const std::filesystem::path folder; // not there yet
    Session session;
};

TEST_F(AutosaveTest, KeepsModelAndHistoryWhileItRunsAndTakesThemAwayAtTheEnd)
{
    {
        Autosave autosave(session, folder);
        run("make.cube");
        autosave.save_now();
        EXPECT_EQ(files(), 3u); // with the lock
        EXPECT_TRUE(session.is_changed());
        EXPECT_TRUE(session.file().empty());
        EXPECT_TRUE(autosave.leftovers().empty()); // its own is none
    }
    EXPECT_EQ(files(), 0u);
}

TEST_F(AutosaveTest, WhatIsKeptCanBeRecovered)
{
    {
        Autosave autosave(session, folder);
        run("make.dodecahedron");
        autosave.save_now();
        autosave.keep();
    }
    EXPECT_EQ(files(), 2u);
    std::filesystem::path model;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".dlfl") model = entry.path();

    Session next(all_operators());
    Autosave autosave(next, folder); // in a process of the same number, as it happens in containers
    EXPECT_NE(autosave.own_model(), model);
    ASSERT_EQ(autosave.leftovers(), std::vector<std::filesystem::path>{model});
    const std::filesystem::path here = Autosave::set_aside(model);
    EXPECT_TRUE(autosave.leftovers().empty());
    next.open(here);
    next.wait();
    next.detach();
    EXPECT_EQ(next.display().counts, (Counts{20, 30, 12}));
    EXPECT_EQ(next.title(), "untitled*");
}

TEST_F(AutosaveTest, ALockOfALivingProcessKeepsOthersAway)
{
    Autosave first(session, folder);
    std::ifstream own(std::filesystem::path(first.own_model()).replace_extension(".lock"));
    std::string host;
    own >> host;
    std::ofstream(folder / "other.dlfl") << "\n";
    std::ofstream(folder / "other.lock") << host << " " << getppid() << "\n";
    EXPECT_TRUE(first.leftovers().empty());
    std::ofstream(folder / "other.lock") << "nowhere.example 1\n"; // on another host it may live
    EXPECT_TRUE(first.leftovers().empty());
    std::filesystem::remove(folder / "other.lock");
    EXPECT_EQ(first.leftovers().size(), 1u);
}

TEST_F(AutosaveTest, TheCopyGoesWhenTheWorkIsSaved)
{
    Autosave autosave(session, folder);
    run("make.cube");
    autosave.save_now();
    EXPECT_EQ(files(), 3u);
    autosave.follow();
    EXPECT_EQ(files(), 3u);
    session.save(room / "saved.obj");
    session.wait();
    autosave.follow();
    EXPECT_EQ(files(), 1u); // the lock
}

TEST_F(AutosaveTest, WorkThatIsSavedOrEmptyIsNotKept)
{
    Autosave autosave(session, folder);
    autosave.save_now();
    EXPECT_EQ(files(), 1u);
    session.open(DRUSE_MODELS "/cube.obj");
    session.wait();
    autosave.save_now();
    EXPECT_EQ(files(), 1u);
}

TEST_F(AutosaveTest, KeepsTheTileOfATileEditorBesideTheModel)
{
    Session tiles(all_operators());
    std::filesystem::path kept;
    {
        Autosave autosave(session, folder), tile_autosave(tiles, folder, Autosave::Kind::tile);
        tile_autosave.save_now();
        EXPECT_EQ(files(), 2u) << "two locks: there is nothing yet";
        run("make.cube");
        tiles.run("tile.new type=IH79 size=20");
        tiles.wait();
        autosave.save_now();
        tile_autosave.save_now();
        EXPECT_EQ(files(), 6u) << "each with its history and its lock";
        kept = tile_autosave.own_model();
        EXPECT_EQ(kept.extension(), ".tile");
        tile_autosave.keep();
    }
    EXPECT_EQ(files(), 2u) << "the tile and its history stay";
    Autosave next(session, folder);
    ASSERT_EQ(next.leftovers(), std::vector<std::filesystem::path>{kept});
    const std::filesystem::path here = Autosave::set_aside(kept);
    Session recovered(all_operators());
    recovered.open(here);
    recovered.wait();
    ASSERT_TRUE(recovered.scene() && std::holds_alternative<LayeredTile>(*recovered.scene()->source));
    EXPECT_EQ(std::get<LayeredTile>(*recovered.scene()->source).design().type, 79);
    EXPECT_FALSE(is_cell_file(here));
}

TEST_F(AutosaveTest, KeepsACellInAFileThatIsToldFromATile)
{
    Session cells(all_operators());
    Autosave autosave(cells, folder, Autosave::Kind::cell), tiles(session, folder, Autosave::Kind::tile);
    cells.run("cell.new cell=fcc size=20");
    cells.wait();
    autosave.save_now();
    ASSERT_EQ(files(), 4u) << "two locks, the cell and its history";
    EXPECT_NE(autosave.own_model(), tiles.own_model());
    EXPECT_TRUE(is_cell_file(autosave.own_model()));
    EXPECT_FALSE(is_cell_file(folder / "none.tile"));
}

} // namespace
} // namespace druse::ui
