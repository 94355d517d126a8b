// What is known of Conway's operators: identities, the Archimedean solids they lead to, flat faces; and recipes.
#include "remesh_models.h"

#include <cmath>
#include <set>

namespace druse {
namespace {

using namespace test;

Mesh recipe(const Mesh& mesh, const std::string& letters) { return made_of(mesh, "remesh.conway", {{"recipe", letters}}); }

/// Whether some corner of `b` goes with the first corner of `a` so that all others follow. Precondition: connected.
bool same_connectivity(const Mesh& a, const Mesh& b)
{
    if (!(counts(a) == counts(b))) return false;
    const Corner first = a.corner(Face(0));
    for (const Face f : b.faces())
        for (const Corner start : b.corners(f)) {
            CornerData<Corner> there(a), back(b);
            std::vector<Corner> open{first};
            there[first] = start;
            back[start] = first;
            bool agree = true;
            while (agree && !open.empty()) {
                const Corner c = open.back();
                open.pop_back();
                for (const auto& [x, y] : {std::pair(a.next(c), b.next(there[c])), std::pair(a.opposite(c), b.opposite(there[c]))}) {
                    if (!there[x].valid() && !back[y].valid()) {
                        there[x] = y;
                        back[y] = x;
                        open.push_back(x);
                    }
                    agree = agree && there[x] == y && back[y] == x;
                }
            }
            if (agree) return true;
        }
    return false;
}

struct Solid {
    const char* name;
    Mesh (*make)();
    double t, s; // that make its truncation and its expansion regular
    friend std::ostream& operator<<(std::ostream& out, const Solid& solid) { return out << solid.name; }
};
// t = 1/(2 + 2 cos(π/n)); s from the literature on the cuboctahedron, the rhombicuboctahedron and the rhombicosidodecahedron.
const std::vector<Solid> solids{
    {"Tetrahedron", tetrahedron, 1.0 / 3, 0.25},
    {"Cube", cube, 1 / (2 + std::sqrt(2.0)), std::sqrt(2.0) - 1},
    {"Octahedron", octahedron, 1.0 / 3, 0.320377241017},
    {"Dodecahedron", dodecahedron, 0.276393202250021, 0.539344662917},
    {"Icosahedron", icosahedron, 1.0 / 3, 0.350372906023},
};
class EveryPlatonicSolid : public testing::TestWithParam<Solid> {};
INSTANTIATE_TEST_SUITE_P(Remesh, EveryPlatonicSolid, testing::ValuesIn(solids), shape_name<testing::TestParamInfo<Solid>>);

/// How much the corners of a face differ in distance from its mean, at most: 0 where equal sides mean a regular face.
double unevenness(const Mesh& mesh)
{
    double most = 0;
    for (const Face f : mesh.faces()) {
        const Point mean = vertex_mean(mesh, f);
        const double first = glm::distance(mesh.position(mesh.corner(f)), mean);
        for (const Corner c : mesh.corners(f)) most = std::max(most, std::abs(glm::distance(mesh.position(c), mean) - first));
    }
    return most / edge_lengths(mesh).mean;
}

TEST_P(EveryPlatonicSolid, IsTruncatedToRegularFacesAtTheRightRatio)
{
    const Mesh mesh = made_of(GetParam().make(), "remesh.truncate", {{"t", number_text(GetParam().t)}});
    EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-12);
    EXPECT_LT(unevenness(mesh), 1e-12);
    EXPECT_LT(flatness(mesh), 1e-12);
}

TEST_P(EveryPlatonicSolid, IsExpandedToSquaresAtTheRightRatio)
{
    const Mesh mesh = made_of(GetParam().make(), "remesh.expand", {{"s", number_text(GetParam().s)}});
    EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-11); // the ratios have twelve digits
    EXPECT_LT(unevenness(mesh), 1e-11);
    EXPECT_LT(flatness(mesh), 1e-11);
}

TEST_P(EveryPlatonicSolid, HasAmboWithEqualEdgesAndADualOfFlatFaces)
{
    const Mesh old = GetParam().make(), ambo = recipe(old, "a");
    EXPECT_LT(edge_lengths(ambo).relative_spread(), 1e-13);
    EXPECT_LT(flatness(ambo), 1e-13);
    const Mesh dual = made_of(old, "remesh.dual", {{"polar", "true"}});
    EXPECT_LT(edge_lengths(dual).relative_spread(), 1e-13);
    // The poles of a solid whose midsphere has the radius of the edges' middles: its edges touch the same sphere.
    double least = 1e300, most = 0;
    for (const Mesh* mesh : {&old, &dual})
        for (const Edge e : mesh->edges()) {
            const double r = glm::length(0.5 * (mesh->position(mesh->ends(e)[0]) + mesh->position(mesh->ends(e)[1])));
            least = std::min(least, r);
            most = std::max(most, r);
        }
    EXPECT_LT(most - least, 1e-12);
}

TEST(RemeshDual, IsFlatForConvexModelsWithPolarVertices)
{
    for (const char* letters : {"a", "t", "e", "b"}) { // Archimedean, but not regular, after these
        const Mesh old = made_of(recipe(cube(), letters), "remesh.conway", {{"recipe", "d"}, {"planarize", "1000"}});
        EXPECT_LT(flatness(old), 1e-7) << letters;
        EXPECT_LT(flatness(made_of(recipe(octahedron(), letters), "remesh.dual", {{"polar", "true"}})), 1e-12) << letters;
    }
    Mesh off = cube();
    for (Point& p : off.write_positions()) p.z = 0;
    EXPECT_EQ(complaint(scene_of(off), "remesh.dual", {{"polar", "true"}}).substr(0, 5), "face ");
}

TEST(RemeshTruncate, KeepsFacesFlatWhereThreeMeetAtEveryVertex)
{
    for (const Mesh& old : {tetrahedron(), cube(), dodecahedron(), prism(7), l_prism()})
        EXPECT_LT(flatness(made_of(old, "remesh.truncate", {{"iterations", "3"}})), 1e-12);
}

// --- identities ---------------------------------------------------------------------------------------------------------------------

TEST(RemeshConway, KeepsTheIdentitiesOfTheNotation)
{
    const std::vector<std::pair<std::string, std::string>> identities{
        {"dd", ""}, {"z", "dk"}, {"n", "kd"}, {"a", "dj"}, {"e", "aa"}, {"o", "de"}, {"b", "ta"}, {"m", "kj"}, {"s", "dg"}, {"t", "dkd"},
        {"u", "dcd"}, {"rs", "drg"}, {"o", "jj"}, {"dpd", "p"}, {"aa", "dod"},
    };
    for (const Input& input : remeshed_models) {
        const Mesh old = input.make();
        if (components(old).parts.size() > 1) continue;
        for (const auto& [left, right] : identities)
            EXPECT_TRUE(same_connectivity(recipe(old, left), right.empty() ? old : recipe(old, right))) << input.name << ": " << left << " = " << right;
    }
    // It tells the two snub cubes apart.
    EXPECT_FALSE(same_connectivity(recipe(cube(), "s"), recipe(cube(), "rs")));
    EXPECT_TRUE(same_connectivity(recipe(cube(), "rs"), recipe(octahedron(), "s")));
}

// --- recipes ------------------------------------------------------------------------------------------------------------------------

TEST(RemeshConway, AppliesLettersFromRightToLeft)
{
    Mesh expected = made_of(dodecahedron(), "remesh.truncate", {{"t", "0.333333333333333"}});
    expected = made_of(expected, "remesh.stellate", {{"only", "3"}});
    expected = made_of(expected, "remesh.whirl", {{"mirror", "true"}});
    EXPECT_TRUE(recipe(dodecahedron(), "rwk3t") == expected);
    EXPECT_TRUE(made_of(cube(), "remesh.conway", {{"recipe", "ad"}, {"iterations", "2"}}) == recipe(cube(), "adad"));
    EXPECT_TRUE(recipe(cube(), "ra") == recipe(cube(), "a")); // its own mirror image
    EXPECT_EQ(counts(recipe(cube(), "t3")), counts(recipe(cube(), "t")));
    EXPECT_EQ(counts(recipe(cube(), "t4")), counts(cube()));
}

TEST(RemeshConway, GrowsByTheFactorOfEachLetter)
{
    const std::string letters = "dajkztneogsmbcpwlqLKuC";
    const int growth[] = {1, 2, 2, 3, 3, 3, 3, 4, 4, 5, 5, 6, 6, 4, 5, 7, 5, 6, 7, 7, 4, 9};
    for (std::size_t i = 0; i < letters.size(); ++i) {
        EXPECT_EQ(recipe(cube(), letters.substr(i, 1)).edge_count(), 12u * unsigned(growth[i])) << letters[i];
        // It is refused by the same factor.
        std::uint64_t edges = 12;
        for (int k = 0; k < 20 && edges <= 20'000'000; ++k) edges *= std::uint64_t(growth[i]);
        if (edges > 20'000'000) {
            EXPECT_EQ(complaint(scene_of(cube()), "remesh.conway", {{"recipe", std::string(20, letters[i])}}), "would make " + std::to_string(edges) + " edges, more than 20 million");
        }
    }
}

TEST(RemeshConway, SaysWhereARecipeIsWrong)
{
    const auto says = [](const char* letters) { return complaint(scene_of(cube()), "remesh.conway", {{"recipe", letters}}); };
    EXPECT_EQ(says("tXk"), "recipe=tXk: unknown letter 'X' at position 2");
    EXPECT_EQ(says("tr"), "recipe=tr: expected a letter after 'r' at position 3");
    EXPECT_EQ(says("k2"), "recipe=k2: expected 3 to 100 at position 2");
    EXPECT_EQ(says("tk5000000000000000000000"), "recipe=tk5000000000000000000000: expected 3 to 100 at position 3");
    EXPECT_EQ(says("da4"), "recipe=da4: a number, which 'a' does not take, at position 3");
    EXPECT_EQ(says("4"), "recipe=4: unknown letter '4' at position 1");
    EXPECT_EQ(says(""), "recipe=: expected 1 to 20 letters");
    EXPECT_EQ(says("ddddddddddddddddddddd"), "recipe=ddddddddddddddddddddd: expected 1 to 20 letters");
}

TEST(RemeshConway, MakesFacesFlatterAndKeepsTheMiddle)
{
    const Mesh bent = recipe(warped_cube(), "gt"), flat = made_of(warped_cube(), "remesh.conway", {{"recipe", "gt"}, {"planarize", "1000"}});
    EXPECT_GT(flatness(bent), 1e-3);
    EXPECT_LT(flatness(flat), 0.1 * flatness(bent));
    EXPECT_EQ(rings(flat), rings(bent));
    const auto middle = [](const Mesh& mesh) {
        Point sum(0.0);
        for (const Point& p : mesh.positions()) sum += p;
        return sum / double(mesh.vertex_count());
    };
    EXPECT_LT(glm::distance(middle(flat), middle(bent)), 1e-12);
    // What is flat stays as it is.
    const Mesh once = recipe(dodecahedron(), "a"), again = made_of(dodecahedron(), "remesh.conway", {{"recipe", "a"}, {"planarize", "1000"}});
    for (const Vertex v : once.vertices()) EXPECT_LT(glm::distance(once.position(v), again.position(v)), 1e-14);
}

} // namespace
} // namespace druse
