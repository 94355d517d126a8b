#include "ui/layout.h"
#include "ui/skew_handles.h"

#include <gtest/gtest.h>

#include <random>

namespace druse::ui {
namespace {

constexpr CellMatrix no_skew{1, 0, 0, 0, 1, 0, 0, 0, 1};

Camera looking(ViewAngles angles)
{
    Camera camera;
    camera.set_angles(angles);
    return camera;
}

TEST(SkewHandles, LieAlongTheAxesAsTheCameraSeesThem)
{
    const SkewHandles front(no_skew, looking({0, 0}), {{100, 80}, 50}); // x to the right, z upward
    EXPECT_NEAR(front.tip(0).x, 150, 1e-9);
    EXPECT_NEAR(front.tip(0).y, 80, 1e-9);
    EXPECT_NEAR(front.tip(2).x, 100, 1e-9);
    EXPECT_NEAR(front.tip(2).y, 30, 1e-9);
    EXPECT_GT(front.handle(0).place.x, 150); // xx goes on along x, zx up from there, and xz to the right of the tip of z
    EXPECT_NEAR(front.handle(6).place.x, 150, 1e-9);
    EXPECT_LT(front.handle(6).place.y, 80);
    EXPECT_GT(front.handle(2).place.x, 100);
    EXPECT_NEAR(front.handle(2).place.y, 30, 1e-9);
    const SkewHandles right(no_skew, looking({90, 0}), {{100, 80}, 50}); // y to the right
    EXPECT_NEAR(right.tip(1).x, 150, 1e-9);
}

TEST(SkewHandles, ShowTheTipsWhereTheMatrixTakesTheAxes)
{
    const CellMatrix matrix{1.5, 0, 0, 0, 1, 0, 0.5, 0, 1};
    const SkewHandles front(matrix, looking({0, 0}), {{0, 0}, 10});
    EXPECT_NEAR(front.tip(0).x, 15, 1e-9);
    EXPECT_NEAR(front.tip(0).y, -5, 1e-9);
}

TEST(SkewHandles, MoveAlongOneLineOnly)
{
    const Camera camera = looking({0, 0});
    const SkewHandles front(no_skew, camera, {{100, 80}, 50});
    EXPECT_NEAR(front.dragged(0, {25, 0}), 1.5, 1e-9);
    EXPECT_NEAR(front.dragged(0, {25, 300}), 1.5, 1e-9); // what goes across it is nothing
    EXPECT_NEAR(front.dragged(6, {300, -10}), 0.2, 1e-9);
}

TEST(SkewHandles, CannotBeDraggedThatAreSeenEndOn)
{
    const SkewHandles front(no_skew, looking({0, 0}), {{100, 80}, 50});
    EXPECT_FALSE(front.handle(4).can_move); // yy
    EXPECT_FALSE(front.handle(3).can_move); // yx
    EXPECT_TRUE(front.handle(1).can_move);  // xy: the tip of y goes along x
    ASSERT_TRUE(front.at(front.handle(1).place));
    EXPECT_EQ(*front.at(front.handle(1).place), 1);
    EXPECT_FALSE(front.at({100, 140}));
}

TEST(SkewHandles, AreAllInThePicture)
{
    for (const CellMatrix& matrix : {no_skew, CellMatrix{3, 0, 1, 0, 1, 0, 2, 0, 1}})
        for (const ViewAngles angles : {ViewAngles{0, 0}, ViewAngles{37, 21}, ViewAngles{200, -70}, ViewAngles{45, 90}}) {
            const Camera camera = looking(angles);
            const SkewHandles all(matrix, camera, SkewHandles::fitting(matrix, camera, {90, 60}, 180, 120));
            for (int entry = 0; entry < 9; ++entry) {
                EXPECT_GT(all.handle(entry).place.x, 0);
                EXPECT_LT(all.handle(entry).place.x, 180);
                EXPECT_GT(all.handle(entry).place.y, 0);
                EXPECT_LT(all.handle(entry).place.y, 120);
            }
        }
}

TEST(SkewHandles, StopBeforeTheCellIsFlat)
{
    EXPECT_DOUBLE_EQ(stopped_skew(no_skew, 0, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(stopped_skew(no_skew, 0, -3), 0.05); // the determinant is this entry
    EXPECT_DOUBLE_EQ(stopped_skew(no_skew, 1, 0.75), 0.75); // shear keeps it
    const CellMatrix sheared{1, 0.5, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_DOUBLE_EQ(stopped_skew(sheared, 3, 5), 1.9); // 1 − x/2 = 0.05
    EXPECT_DOUBLE_EQ(stopped_skew({150, 0, 0, 0, 1, 0, 0, 0, 1}, 0, 150.25), 150.25); // one that was typed goes on from where it is
    EXPECT_DOUBLE_EQ(stopped_skew({30000, 0, 0, 0, 1, 0, 0, 0, 1}, 0, 30001), 30000);
    // One that is flatter already may only grow.
    const CellMatrix flat{0.01, 0, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_DOUBLE_EQ(stopped_skew(flat, 0, 0.005), 0.01);
    EXPECT_DOUBLE_EQ(stopped_skew(flat, 0, 0.3), 0.3);
}

TEST(SkewHandles, NeverReachAFlatCellWhereverTheyAreDragged)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-4, 4);
    CellMatrix matrix = no_skew;
    for (int i = 0; i < 2000; ++i) {
        const int entry = i % 9;
        const double before = matrix[std::size_t(entry)], wanted = any(random), value = stopped_skew(matrix, entry, wanted);
        EXPECT_LE(std::min(before, wanted) - 5e-4, value);
        EXPECT_GE(std::max(before, wanted) + 5e-4, value);
        matrix[std::size_t(entry)] = value;
        ASSERT_GE(determinant(matrix), SkewHandles::least_determinant - 1e-9) << "after step " << i;
    }
}

} // namespace
} // namespace druse::ui
