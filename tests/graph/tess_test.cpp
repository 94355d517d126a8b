#include "graph/tess.h"

#include "dlfl/errors.h"
#include "graph/hyperbolic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <ostream>
#include <string>

namespace druse {
namespace {

using Complex = std::complex<double>;
using Config = std::vector<int>;
using Center = Disk::Center;

Tess tess(const TessShape& shape, bool with_polygons = true)
{
    Progress progress;
    return tessellate(shape, with_polygons, progress);
}

std::string complaint(const TessShape& shape)
{
    try {
        tess(shape);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

Complex complex(const Point& p) { return {p.x, p.y}; }

/// Between two points of the Poincaré disk (Anderson 1999).
double distance(const Complex& z, const Complex& w) { return 2 * std::asinh(std::abs(z - w) / std::sqrt((1 - std::norm(z)) * (1 - std::norm(w)))); }

/// The least distance of two vertices, hyperbolic, of those whose places in the disk are near in x.
double closest(const Graph& graph)
{
    std::vector<Complex> places;
    for (const Point& p : graph.vertices) places.push_back(complex(p));
    std::ranges::sort(places, {}, [](const Complex& z) { return z.real(); });
    double least = 1e9;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = i + 1; j < places.size() && places[j].real() - places[i].real() < 0.5 * least * (1 - std::norm(places[i])) + 1e-12; ++j)
            least = std::min(least, distance(places[i], places[j]));
    return least;
}

// --- counts ---------------------------------------------------------------------------------------------------------------------

struct Counts {
    std::size_t vertices, edges, faces;
    friend bool operator==(const Counts&, const Counts&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Counts& c) { return out << c.vertices << "/" << c.edges << "/" << c.faces; }
};

struct Row {
    Config config;
    Center center;
    int number;
    std::vector<Counts> after; // 0, 1, … layers
};

// Verified with an independent program.
const std::vector<Row> rows{
    {{7, 7, 7}, Center::face, -1, {{7, 7, 1}, {35, 42, 8}, {112, 140, 29}, {315, 399, 85}, {847, 1078, 232}, {2240, 2856, 617}}},
    {{7, 7, 7}, Center::vertex, -1, {{1, 0, 0}, {16, 18, 3}, {61, 75, 15}, {181, 228, 48}, {496, 630, 135}, {1321, 1683, 363}}},
    {{7, 7, 7}, Center::edge, -1, {{2, 1, 0}, {20, 23, 4}, {72, 89, 18}, {210, 265, 56}, {572, 727, 156}, {1520, 1937, 418}}},
    {{7, 6, 6}, Center::face, 7, {{7, 7, 1}, {28, 35, 8}, {70, 91, 22}, {147, 196, 50}, {280, 378, 99}, {511, 693, 183}}},
    {{7, 6, 6}, Center::face, 6, {{6, 6, 1}, {27, 33, 7}, {69, 90, 22}, {144, 192, 49}, {276, 372, 97}, {504, 684, 181}}},
    {{7, 6, 6}, Center::vertex, -1, {{1, 0, 0}, {14, 16, 3}, {44, 56, 13}, {100, 132, 33}, {199, 267, 69}, {371, 502, 132}}},
    {{3, 3, 3, 3, 3, 3, 3}, Center::face, -1, {{3, 3, 1}, {15, 30, 16}, {48, 108, 61}, {135, 315, 181}, {363, 858, 496}, {960, 2280, 1321}}},
    {{3, 3, 3, 3, 3, 3, 3}, Center::vertex, -1, {{1, 0, 0}, {8, 14, 7}, {29, 63, 35}, {85, 196, 112}, {232, 546, 315}, {617, 1463, 847}}},
    {{5, 4, 5, 4}, Center::face, 5, {{5, 5, 1}, {25, 35, 11}, {80, 120, 41}, {225, 345, 121}, {605, 935, 331}, {1600, 2480, 881}}},
    {{5, 4, 5, 4}, Center::face, 4, {{4, 4, 1}, {20, 28, 9}, {64, 96, 33}, {180, 276, 97}, {484, 748, 265}, {1280, 1984, 705}}},
    {{5, 4, 5, 4}, Center::vertex, -1, {{1, 0, 0}, {11, 14, 4}, {41, 60, 20}, {121, 184, 64}, {331, 510, 180}, {881, 1364, 484}}},
    {{5, 3, 4, 3, 3}, Center::face, 5, {{5, 5, 1}, {20, 35, 16}, {55, 100, 46}, {120, 240, 121}, {255, 495, 241}, {500, 1025, 526}}},
    {{5, 3, 4, 3, 3}, Center::face, 4, {{4, 4, 1}, {20, 32, 13}, {52, 100, 49}, {120, 228, 109}, {244, 496, 253}, {500, 980, 481}}},
    {{5, 3, 4, 3, 3}, Center::vertex, -1, {{1, 0, 0}, {9, 13, 5}, {30, 53, 24}, {75, 142, 68}, {163, 320, 158}, {334, 665, 332}}},
};

TEST(Tess, HasAsManyVerticesEdgesAndFacesAfterEachLayerAsTheTablesSay)
{
    for (const Row& row : rows)
        for (int layers = 0; layers < int(row.after.size()); ++layers) {
            const Tess t = tess({.config = row.config, .center = row.center, .center_number = row.number, .layers = layers});
            EXPECT_EQ((Counts{t.graph.vertices.size(), t.graph.edges.size(), t.polygon_ends.size()}), row.after[std::size_t(layers)])
                << testing::PrintToString(row.config) << " layers " << layers;
        }
}

// --- shapes ---------------------------------------------------------------------------------------------------------------------

const std::vector<Config> configs{
    {7, 7, 7},       {7, 6, 6},       {3, 3, 3, 3, 3, 3, 3}, {5, 4, 5, 4},       {5, 3, 4, 3, 3}, {3, 7, 3, 7},    {3, 4, 7, 4},
    {4, 6, 14},      {3, 3, 3, 3, 7}, {3, 14, 14},           {8, 8, 8},          {5, 5, 5, 5},    {4, 4, 4, 4, 4}, {4, 8, 8, 8},
    {6, 6, 6, 6},    {4, 5, 4, 5, 4, 5}, {3, 8, 3, 8},       {3, 3, 4, 3, 5},    {4, 4, 4, 6},    {3, 3, 3, 3, 3, 3, 3, 3},
    {12, 12, 4},     {3, 3, 3, 4, 4, 4}, {3, 5, 3, 5, 3, 5}, {4, 8, 12},         {40, 40, 3},     {3, 4, 3, 4, 3, 4, 3, 4},
};

class EveryConfig : public testing::TestWithParam<Config> {};
INSTANTIATE_TEST_SUITE_P(Tess, EveryConfig, testing::ValuesIn(configs));

TEST_P(EveryConfig, HasEqualEdgesAndNoVertexTwiceWhateverIsAtTheCentre)
{
    const Config& config = GetParam();
    const double length = edge_length(config);
    for (const Center center : {Center::face, Center::vertex, Center::edge}) {
        // As many layers as places near the rim can still be measured in.
        int layers = 1;
        while (layers < 5 && tess({.config = config, .center = center, .layers = layers + 1}).graph.vertices.size() < 1500) ++layers;
        const Tess t = tess({.config = config, .center = center, .layers = layers});
        double longest = 0, shortest = 1e9;
        for (const auto& [a, b] : t.graph.edges) {
            const double d = distance(complex(t.graph.vertices[a]), complex(t.graph.vertices[b]));
            longest = std::max(longest, d);
            shortest = std::min(shortest, d);
        }
        EXPECT_NEAR(longest, length, 1e-7);
        EXPECT_NEAR(shortest, length, 1e-7);
        EXPECT_NEAR(closest(t.graph), length, 0.6 * length); // corners of a polygon may be a little nearer than two along an edge, never as near as a copy
        EXPECT_EQ(t.graph.vertices.size() + t.polygon_ends.size(), t.graph.edges.size() + 1);
        std::vector<int> valence(t.graph.vertices.size());
        for (const auto& edge : t.graph.edges)
            for (const std::uint32_t v : edge) ++valence[v];
        EXPECT_LE(*std::ranges::max_element(valence), int(config.size()));
        EXPECT_EQ(valence[0], int(config.size()));
    }
}

TEST(Tess, KeepsEqualEdgesOverManyLayers)
{
    for (const auto& [config, layers] : std::initializer_list<std::pair<Config, int>>{{{7, 7, 7}, 9}, {{3, 3, 3, 3, 3, 3, 3}, 9}, {{5, 4, 5, 4}, 8}, {{5, 3, 4, 3, 3}, 11}, {{4, 6, 14}, 12}})
        for (const Center center : {Center::face, Center::vertex}) {
            const double length = edge_length(config);
            const Tess t = tess({.config = config, .center = center, .layers = layers});
            double worst = 0;
            for (const auto& [a, b] : t.graph.edges)
                worst = std::max(worst, std::abs(distance(complex(t.graph.vertices[a]), complex(t.graph.vertices[b])) - length));
            EXPECT_LT(worst, 1e-7) << testing::PrintToString(config);
        }
}

TEST(Tess, HasAtItsCentreWhatIsAskedFor)
{
    const auto mean_of_first = [](const Tess& t, int n) {
        Point sum(0.0);
        for (int i = 0; i < n; ++i) sum += t.graph.vertices[std::size_t(i)] / double(n);
        return glm::length(sum);
    };
    const Tess face = tess({.config = {7, 6, 6}, .center_number = 6});
    EXPECT_LT(mean_of_first(face, 6), 1e-15);
    EXPECT_NEAR(face.graph.vertices[0].y, 0, 1e-16);
    EXPECT_GT(face.graph.vertices[0].x, 0);
    EXPECT_EQ(face.graph.disk->sides, 6);
    EXPECT_EQ(face.graph.disk->folds, 3);
    EXPECT_FALSE(face.graph.disk->mirrored);
    const Tess vertex = tess({.center = Center::vertex});
    EXPECT_EQ(vertex.graph.vertices[0], Point(0.0));
    EXPECT_NEAR(vertex.graph.vertices[1].y, 0, 1e-16); // its first edge leaves along +x
    for (const int slot : {0, 1, 2}) {
        const Tess edge = tess({.config = {7, 6, 6}, .center = Center::edge, .center_number = slot});
        EXPECT_LT(mean_of_first(edge, 2), 1e-15);
        EXPECT_NEAR(edge.graph.vertices[0].y, 0, 1e-16);
        EXPECT_LT(edge.graph.vertices[0].x, 0);
    }
}

TEST(Tess, LiesInThePlaceOfItsModel)
{
    // The distance d from the centre is at radius tanh(d/2), tanh d in Klein's model; the half-plane has the centre at i.
    const double length = edge_length(Config{7, 7, 7});
    const auto neighbour = [](DiskModel model, double turn = 0) { return complex(tess({.center = Center::vertex, .model = model, .turn = turn}).graph.vertices[1]); };
    EXPECT_NEAR(std::abs(neighbour(DiskModel::poincare) - std::tanh(0.5 * length)), 0, 1e-15);
    EXPECT_NEAR(std::abs(neighbour(DiskModel::klein) - std::tanh(length)), 0, 1e-15);
    EXPECT_NEAR(std::abs(neighbour(DiskModel::halfplane) - Complex(0, std::exp(length))), 0, 1e-14);
    EXPECT_NEAR(std::abs(neighbour(DiskModel::poincare, 90) - Complex(0, std::tanh(0.5 * length))), 0, 1e-15);
    const Tess shifted = tess({.center = Center::vertex, .shift_x = 0.3, .shift_y = -0.4});
    EXPECT_NEAR(glm::distance(shifted.graph.vertices[0], Point(0.3, -0.4, 0)), 0, 1e-15);
    EXPECT_NEAR(distance(complex(shifted.graph.vertices[0]), complex(shifted.graph.vertices[1])), length, 1e-12);
    EXPECT_EQ(shifted.graph.disk->center, Center::elsewhere);
    EXPECT_FALSE(tess({.model = DiskModel::halfplane}).graph.disk);
}

TEST(Tess, CutsArcsIntoPiecesOfTheSameHyperbolicLength)
{
    const Tess t = tess({.layers = 2, .arc = 4});
    EXPECT_EQ(t.graph.vertices.size(), 112u + 140 * 3);
    EXPECT_EQ(t.graph.edges.size(), 140u * 4);
    for (const auto& [a, b] : t.graph.edges)
        EXPECT_NEAR(distance(complex(t.graph.vertices[a]), complex(t.graph.vertices[b])), 0.25 * edge_length(Config{7, 7, 7}), 1e-9);
    EXPECT_EQ(t.polygon_corners.size(), 29u * 7 * 4);
}

TEST(Tess, RunsRoundItsPolygonsCounterClockwiseAlsoInAMirror)
{
    for (const bool mirror : {false, true})
        for (const DiskModel model : {DiskModel::poincare, DiskModel::halfplane}) {
            const Tess t = tess({.config = {5, 3, 4, 3, 3}, .model = model, .turn = 10, .arc = 2, .mirror = mirror});
            std::uint32_t begin = 0;
            for (const std::uint32_t end : t.polygon_ends) {
                double area = 0;
                for (std::uint32_t i = begin; i < end; ++i) {
                    const Point &p = t.graph.vertices[t.polygon_corners[i]], &q = t.graph.vertices[t.polygon_corners[i + 1 < end ? i + 1 : begin]];
                    area += p.x * q.y - p.y * q.x;
                }
                EXPECT_GT(area, 0);
                begin = end;
            }
        }
    const Tess one = tess({.config = {5, 3, 4, 3, 3}}), other = tess({.config = {5, 3, 4, 3, 3}, .mirror = true});
    ASSERT_EQ(one.graph.edges, other.graph.edges);
    for (std::size_t v = 0; v < one.graph.vertices.size(); ++v)
        EXPECT_EQ(one.graph.vertices[v] * Point(1, -1, 1), other.graph.vertices[v]);
}

// --- refusals -------------------------------------------------------------------------------------------------------------------

TEST(Tess, RefusesWhatIsNotHyperbolicOrNotVertexUniform)
{
    EXPECT_EQ(complaint({.config = {3, 3, 3, 3, 3, 3}}), "config=3,3,3,3,3,3: six triangles are flat; did you mean 3,3,3,3,3,3,3?");
    EXPECT_EQ(complaint({.config = {4, 4, 4, 4}}), "config=4,4,4,4 is Euclidean: the angles make exactly 360 degrees; expected more polygons, or larger ones");
    EXPECT_EQ(complaint({.config = {5, 6, 6}}), "config=5,6,6 is spherical: the angles make less than 360 degrees; expected more polygons, or larger ones");
    EXPECT_EQ(complaint({.config = {5, 5, 5, 4}}), "config=5,5,5,4 has no vertex-uniform tessellation");
}

TEST(Tess, RefusesACentreThatIsNotThere)
{
    EXPECT_EQ(complaint({.config = {7, 6, 6}, .center_number = 5}), "center=face:5: config=7,6,6 has no such polygon");
    EXPECT_EQ(complaint({.config = {7, 6, 6}, .center = Center::edge, .center_number = 3}), "center=edge:3: expected a slot 0 to 2");
}

TEST(Tess, RefusesMoreThanFitsAndSaysHowMuchDoes)
{
    // 3^8 grows by 2 + sqrt 3 squared a layer.
    const std::string many = complaint({.config = Config(12, 12), .layers = 12});
    EXPECT_NE(many.find("layers=12 would give "), std::string::npos) << many;
    const auto largest = many.find("; expected ");
    ASSERT_NE(largest, std::string::npos) << many;
    const int fits = std::stoi(many.substr(largest + 11));
    EXPECT_EQ(complaint({.config = Config(12, 12), .layers = fits}), "(none)");
    EXPECT_EQ(complaint({.config = Config(12, 12), .layers = fits + 1}).substr(0, 9), "layers=" + std::to_string(fits + 1) + " ");
    EXPECT_EQ(complaint({.config = {7, 7, 7}, .shift_x = 1 - 1e-13}), "layers=3 would give edges shorter than 1e-06, and so would layers=0; expected a smaller shift");
    EXPECT_EQ(complaint({.center = Center::vertex, .model = DiskModel::halfplane, .shift_x = 1 - 1e-10}), "model=halfplane: a vertex lies at infinity; another turn moves it away");
}

TEST(Tess, RefusesPiecesOfEdgesThatAreTooShort)
{
    // 1e-5 from the rim of the disk a heptagon has edges of 3e-6 to 1e-5.
    const TessShape whole{.layers = 0, .shift_x = 1 - 1e-5}, pieces{.layers = 0, .shift_x = 1 - 1e-5, .arc = 64};
    EXPECT_EQ(complaint(whole), "(none)");
    EXPECT_EQ(complaint(pieces), "layers=0 would give pieces of edges shorter than 1e-06, and so would layers=0; expected a smaller shift");
}

TEST(Tess, CountsThePiecesOfEdgesAmongItsVertices)
{
    // 7,7,7 around a face: V = 15 435 and E = 19 698 after seven layers, 40 432 and 51 597 after eight. With 63 points on each edge
    // that is 1 256 409, and 3 291 043.
    EXPECT_EQ(complaint({.layers = 9, .arc = 64}), "layers=9 would give more than 2000000 vertices; expected 7 or less");
}

TEST(Tess, StopsWhenAskedTo)
{
    Progress progress;
    progress.cancel();
    EXPECT_THROW(tessellate({}, false, progress), Cancelled);
}

} // namespace
} // namespace druse
