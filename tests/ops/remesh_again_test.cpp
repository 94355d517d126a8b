// Runs that are kept: positions to the bit as a whole run has them, and nothing kept where more than these would change.
#include "ops/remesh_again.h"

#include "remesh_models.h"

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;

std::shared_ptr<void> parameters_of(const Operator& op, const Arguments& arguments)
{
    const auto parameters = op.make();
    for (const auto& [key, value] : arguments) op.find(key)->set(parameters.get(), value);
    return parameters;
}

struct Case {
    const char* command;
    Arguments moved; // what a slider changes
    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.command; }
};
const std::vector<Case> cases{
    {"remesh.checkerboard", {{"t", "0.2"}}},
    {"remesh.catmull_clark", {{"smooth", "false"}}},
    {"remesh.linear", {}},
    {"remesh.doo_sabin", {}},
    {"remesh.corner_cutting", {{"alpha", "0.7"}}},
    {"remesh.expand", {{"s", "0.3"}}},
    {"remesh.loop", {{"smooth", "false"}}},
    {"remesh.subdivide", {}},
    {"remesh.truncate", {{"t", "0.2"}}},
    {"remesh.honeycomb", {}},
    {"remesh.pentagonal", {{"t", "0.2"}, {"offset", "0.3"}}},
    {"remesh.pentagon_preserving", {{"s", "0.3"}}},
    {"remesh.sqrt3", {{"smooth", "false"}}},
    {"remesh.root4", {{"weight", "0.2"}, {"twist", "0.3"}}},
    {"remesh.chamfer", {{"s", "0.3"}}},
    {"remesh.dual", {}},
    {"remesh.ambo", {}},
    {"remesh.join", {}},
    {"remesh.stellate", {{"height", "0.3"}}},
    {"remesh.star", {{"offset", "0.3"}}},
    {"remesh.needle", {}},
    {"remesh.bevel", {{"s", "0.3"}, {"t", "0.2"}}},
    {"remesh.meta", {}},
    {"remesh.snub", {{"t", "0.2"}}},
    {"remesh.propeller", {{"t", "0.2"}}},
    {"remesh.whirl", {{"t", "0.2"}, {"s", "0.3"}}},
    {"remesh.loft", {{"s", "0.3"}}},
    {"remesh.lace", {{"s", "0.3"}}},
    {"remesh.stake", {{"s", "0.3"}}},
};

class EveryKeptRemeshing : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Remesh, EveryKeptRemeshing, testing::ValuesIn(cases));

TEST_P(EveryKeptRemeshing, PutsVerticesWhereAWholeRunDoes)
{
    const Operator& op = ops_registry().get(GetParam().command);
    const KeepRun keep = op.keep;
    ASSERT_NE(keep, nullptr);
    Progress progress;
    for (const Input& input : {Input{"Dodecahedron", dodecahedron}, Input{"EditedTorus", edited_torus}})
        for (const char* iterations : {"1", "2"})
            for (const bool mirror : {false, true}) {
                if (mirror && !op.find("mirror")) continue;
                Arguments first{{"iterations", iterations}}, second = GetParam().moved;
                if (mirror) first.emplace_back("mirror", "true");
                second.insert(second.end(), first.begin(), first.end());
                const Mesh old = input.make();
                const auto before = parameters_of(op, first), now = parameters_of(op, second);
                const auto again = keep(old, before.get(), now.get(), progress);
                ASSERT_NE(again, nullptr);
                for (const auto& [parameters, arguments] : {std::pair(now, second), std::pair(before, first), std::pair(now, second)}) {
                    const Mesh whole = made_of(old, op.name, arguments);
                    std::vector<Point> points(whole.vertex_limit());
                    ASSERT_TRUE(again->place(parameters.get(), points, progress));
                    EXPECT_TRUE(std::ranges::equal(points, whole.positions())) << input.name << " iterations=" << iterations;
                }
            }
}

TEST_P(EveryKeptRemeshing, IsNotKeptWhereMoreThanPositionsChanges)
{
    const Operator& op = ops_registry().get(GetParam().command);
    const auto plain = parameters_of(op, {});
    Progress progress;
    const Mesh old = cube();
    const auto again = op.keep(old, plain.get(), plain.get(), progress);
    std::vector<Point> points(made_of(old, op.name).vertex_limit());
    const auto expect_other_mesh = [&](const Arguments& arguments) {
        const auto other = parameters_of(op, arguments);
        EXPECT_EQ(op.keep(old, plain.get(), other.get(), progress), nullptr);
        EXPECT_FALSE(again->place(other.get(), points, progress));
    };
    expect_other_mesh({{"iterations", "2"}});
    expect_other_mesh({{"groups", "keep"}});
    if (op.find("mirror")) expect_other_mesh({{"mirror", "true"}});
    if (op.find("only")) expect_other_mesh({{"only", "3"}});
}

TEST(KeptRemeshing, IsEveryOneThatTreatsAllFacesAlike)
{
    for (const Operator& op : ops_registry().operators()) {
        const bool is_case = std::ranges::any_of(cases, [&](const Case& c) { return c.command == op.name; });
        EXPECT_EQ(op.keep != nullptr, is_case) << op.name;
        EXPECT_EQ(is_case, op.family() == "remesh" && op.name != "remesh.conway" && op.name != "remesh.triangulate" && op.name != "remesh.subdivide_limit") << op.name;
    }
}

} // namespace
} // namespace druse
