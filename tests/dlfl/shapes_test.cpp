// The test family itself: counts, genus and volume by arithmetic, so that other tests may lean on it.
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace druse {
namespace {

using namespace test;

class EveryShape : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShape, IsSoundWithoutHoles)
{
    const Mesh mesh = GetParam().make();
    EXPECT_SOUND(mesh);
    EXPECT_FALSE(mesh.has_holes());
}

TEST_P(EveryShape, IsTheSameEachTime) { EXPECT_EQ(GetParam().make(), GetParam().make()); }

/// A volume of NaN: the face is so warped that its volume depends on how it is filled.
struct Expected {
    const char* name;
    Counts counts;
    std::int64_t genus;
    double volume;
};

TEST(Shapes, HaveTheCountsGenusAndVolumeOfTheLiterature)
{
    const double s5 = std::sqrt(5.0);
    const double hexagon = 1.5 * std::sqrt(3.0);
    for (const Expected& x : {
             Expected{"Triangle", {3, 3, 2}, 0, 0},
             {"Tetrahedron", {4, 6, 4}, 0, std::sqrt(2.0) / 12},
             {"Cube", {8, 12, 6}, 0, 1},
             {"Octahedron", {6, 12, 8}, 0, std::sqrt(2.0) / 3},
             {"Dodecahedron", {20, 30, 12}, 0, (15 + 7 * s5) / 4},
             {"Icosahedron", {12, 30, 20}, 0, 5 * (3 + s5) / 12},
             {"HexagonalPrism", {12, 18, 8}, 0, hexagon},
             {"Pyramid", {8, 14, 8}, 0, 7 / (4 * std::tan(std::numbers::pi / 7)) / 3},
             {"Torus", {48, 96, 48}, 1, std::nan("")},
             {"Grid", {20, 31, 13}, 0, 0},
             {"LPrism", {12, 18, 8}, 0, 3},
             // A slab with g holes: 5g + 3 cells, 8(2g + 2) vertices, and 2(5g + 3) squares above and below, 4g + 8 around, 4g inside.
             {"GenusTwoBlock", {48, 100, 50}, 2, 13},
             {"GenusFiveBlock", {96, 208, 104}, 5, 28},
             {"TwoCubes", {16, 24, 12}, 0, 2},
             {"CubeWithAntenna", {9, 13, 6}, 0, std::nan("")},
             {"TetheredCubes", {16, 25, 11}, 0, std::nan("")},
             {"CubeWithParallelEdges", {8, 13, 7}, 0, 1},
             {"CubeWithEdgeHandle", {8, 13, 5}, 1, std::nan("")},
             {"CubeWithLoop", {8, 13, 7}, 0, 1},
             {"Segment", {2, 1, 1}, 0, 0},
             {"ThreeLunes", {2, 3, 3}, 0, 0},
             {"PointSphere", {1, 0, 1}, 0, 0},
             {"OpenGrid", {12, 17, 6}, 0, 0},
             {"OpenTube", {10, 15, 5}, 0, 5 / (4 * std::tan(std::numbers::pi / 5))},
             {"Nothing", {0, 0, 0}, 0, 0},
         }) {
        SCOPED_TRACE(x.name);
        const auto shape = std::find_if(all_shapes().begin(), all_shapes().end(), [&](const NamedShape& s) { return s.name == x.name; });
        ASSERT_NE(shape, all_shapes().end());
        const Mesh mesh = shape->make();
        EXPECT_EQ(counts(mesh), x.counts);
        EXPECT_EQ(genus(mesh), x.genus);
        if (!std::isnan(x.volume)) {
            EXPECT_NEAR(volume(mesh), x.volume, 1e-12);
        }
    }
}

} // namespace
} // namespace druse
