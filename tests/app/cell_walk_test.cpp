// Cells through long sessions of commands: what is refused changes nothing, undo and files give every bit back.
#include "app/documents.h"
#include "app/registry.h"
#include "app/save.h"
#include "cell/cell_shapes.h"
#include "io/output.h"
#include "support/folder.h"

#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

namespace druse {
namespace {

using namespace test;

class CellWalk : public testing::TestWithParam<CellKind> {
protected:
    const CellTile& cell() const { return std::get<CellTile>(*document_.scene().source); }
    static std::string bytes_of(const Document& document, const Folder& folder)
    {
        OutputSet output;
        write_document(document, output, folder.path() / "walk.tile");
        output.commit();
        return folder.read("walk.tile");
    }
    std::string bytes() const { return bytes_of(document_, folder_); }

    int below(std::size_t n) { return n == 0 ? 0 : int(random_() % unsigned(n)); }
    int pane() { return below(std::size_t(cell().pane_count())); }
    std::string point() { return cell().name(below(std::size_t(cell().point_count()))).text(); }
    std::string point_in(int p) { return cell().pane_name(p, PaneMesh::Index(below(cell().mesh(p).point_count()))).text(); }
    std::string at(int p)
    {
        const Point2 &a = cell().cell().panes[std::size_t(p)].outline[0], &b = cell().cell().panes[std::size_t(p)].outline[2];
        const double u = uniform(random_, 0.05, 0.45), v = uniform(random_, 0.05, 0.45);
        const Point2 q = u * a + v * b;
        return fmt::format("{},{}", q.x, q.y);
    }
    double small() { return uniform(random_, -0.5, 0.5); }

    /// Any edit; perhaps one that is refused.
    std::string any()
    {
        const int p = pane();
        const auto edge_in = [&] {
            const auto& t = cell().mesh(p).triangles[std::size_t(below(cell().mesh(p).triangles.size()))];
            return cell().pane_name(p, t[0]).text() + "," + cell().pane_name(p, t[1]).text();
        };
        switch (random_() % 16) {
        case 0: return fmt::format("cell.point_add pane={} at={}", p, at(p));
        case 1: return fmt::format("cell.point_move point=p{}:i{} to={}", p, below(cell().interior(p).size()), at(p));
        case 2: return fmt::format("cell.point_remove point=p{}:i{}", p, below(cell().interior(p).size()));
        case 3: return fmt::format("cell.edge_add edge={} t={}", below(cell().cell().edges.size()), uniform(random_, 0.05, 0.95));
        case 4: return fmt::format("cell.edge_remove point=x{}:1", below(cell().cell().edges.size()));
        case 5: return fmt::format("cell.constrain pane={} from={} to={}", p, point_in(p), point_in(p));
        case 6: return fmt::format("cell.unconstrain pane={} from={} to={}", p, point_in(p), point_in(p));
        case 7: return fmt::format("cell.move points={},{} by={},{},{}", point(), point(), small(), small(), small());
        case 8: return fmt::format("cell.move points={} along=radial amount={}", point(), small());
        case 9: return fmt::format("cell.move points={} pane={} plane={},{}", point(), p, small(), small());
        case 10: return fmt::format("cell.split face=p{}:{} at=0.25,0.25,0.5", p, below(cell().mesh(p).triangles.size()));
        case 11: return fmt::format("cell.split_edge pane={} edge={} t={}", p, edge_in(), uniform(random_, 0.2, 0.8));
        case 12: return fmt::format("cell.flip pane={} edge={}", p, edge_in());
        case 13: return fmt::format("cell.skew entry={} value={}", std::array{"xx", "xy", "zy", "zz"}[random_() % 4], 1 + 0.2 * small());
        case 14: return fmt::format("cell.rollback pane={} keep={}", p, random_() % 2 == 0);
        default: return "cell.shape";
        }
    }

    Folder folder_;
    Document document_{all_operators()};
    std::mt19937 random_{static_cast<unsigned>(GetParam()) + 7};
};

TEST_P(CellWalk, ComesBackByUndoAndFromFilesToTheByte)
{
    document_.apply(fmt::format("cell.new cell={} size=40", name(GetParam())));
    std::vector<std::string> states{bytes()};
    int refused = 0;
    for (int step = 0; step < 160; ++step) {
        // The first are on flat panes, and phase II begins in the middle.
        std::string command = step == 50 ? "cell.shape" : any();
        if (step < 50 && command == "cell.shape") command = fmt::format("cell.point_add pane=0 at={}", at(0));
        SCOPED_TRACE(command);
        if (!complaint(document_, command).empty()) {
            ++refused;
            ASSERT_EQ(bytes(), states.back());
            continue;
        }
        states.push_back(bytes());
        if (step % 10 != 0) continue;
        Document again(all_operators());
        Progress progress;
        again.open(folder_.path() / "walk.tile", progress);
        ASSERT_EQ(bytes_of(again, folder_), states.back());
        const CellSolid solid = make_solid(cell()), other = make_solid(std::get<CellTile>(*again.scene().source));
        EXPECT_EQ(solid.points, other.points);
        EXPECT_EQ(solid.triangles, other.triangles);
        EXPECT_NEAR(volume(solid), cell().volume(), 1e-9 * cell().volume());
    }
    EXPECT_GT(refused, 20);
    ASSERT_GT(states.size(), 60u);
    ASSERT_EQ(document_.history().done() + 0, states.size());
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        document_.apply("document.undo");
        ASSERT_EQ(bytes(), states[i]) << i;
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
        document_.apply("document.redo");
        ASSERT_EQ(bytes(), states[i]) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CellWalk, testing::ValuesIn(every_cell), [](const auto& made) { return std::string(name(made.param)); });

} // namespace
} // namespace druse
