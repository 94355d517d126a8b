#include "dlfl/overhang.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace druse::test {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

/// A block of 3 × 1 × 2 cells with a tunnel below its middle: two legs, and a ceiling between them.
Mesh bridge() { return voxels({{0, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}}); }

TEST(Overhang, IsTheCeilingOfATunnel)
{
    const Overhang o = overhang(bridge(), right_angle / 2);
    EXPECT_EQ(o.faces.size(), 1u);
    EXPECT_NEAR(o.area, 1, 1e-12);
    EXPECT_EQ(overhang(bridge(), right_angle).faces.size(), 0u); // more than a right angle is not to be had
    EXPECT_EQ(overhang(bridge(), 0).faces.size(), 1u);           // walls lean out by nothing
}

TEST(Overhang, IsNothingOfWhatLiesOnTheBed)
{
    EXPECT_TRUE(overhang(cube(), 0).faces.empty());
    EXPECT_TRUE(overhang(prism(7), 0).faces.empty());
    EXPECT_TRUE(overhang(Mesh(), 0).faces.empty());
}

TEST(Overhang, IsMeasuredFromTheWall)
{
    // The lower half of an octahedron leans out by asin(1/√3), 35.26 degrees.
    const double lean = std::asin(1 / std::sqrt(3.0));
    EXPECT_EQ(overhang(octahedron(), lean - 1e-6).faces.size(), 4u);
    EXPECT_EQ(overhang(octahedron(), lean).faces.size(), 0u);
    EXPECT_NEAR(overhang(octahedron(), 0.1).area, 4 * std::sqrt(3.0) / 4, 1e-9); // triangles of side 1
}

} // namespace
} // namespace druse::test
