#include "geom/segments.h"

#include <gtest/gtest.h>

namespace druse {
namespace {

TEST(NearestPoints, OfSegmentsAreWhereTheyCrossOrEnd)
{
    const auto near = [](Point a, Point b, Point c, Point d) { return nearest_points(a, b, c, d); };
    EXPECT_NEAR(near({0, 0, 0}, {2, 0, 0}, {1, -1, 0.5}, {1, 3, 0.5}).distance, 0.5, 1e-15);
    EXPECT_NEAR(near({0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 3, 0}).s, 0.5, 1e-15);
    EXPECT_NEAR(near({0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 3, 0}).t, 0.25, 1e-15);
    EXPECT_NEAR(near({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}).distance, 1, 1e-15);         // one after the other
    EXPECT_NEAR(near({0, 0, 0}, {4, 0, 0}, {1, 2, 0}, {2, 2, 0}).distance, 2, 1e-15);         // side by side
    EXPECT_NEAR(near({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}).distance, 5, 1e-15);         // two points
    EXPECT_NEAR(near({0, 0, 0}, {1, 1e-12, 0}, {0, 1e-3, 0}, {1, 1e-3, 0}).distance, 1e-3, 1e-11);
    EXPECT_NEAR(distance_to_segment({5, 3, 4}, {0, 0, 0}, {5, 0, 0}), 5, 1e-15);
}

TEST(NearestPoints, OfNearParallelsAreWhereTheyCross)
{
    for (const double slant : {1e-5, 1e-7, 1e-9, 1e-12}) { // both go through (0.3, 0.3 slant, 0)
        const NearestPoints found = nearest_points({-0.7, -0.7 * slant, 0}, {1.3, 1.3 * slant, 0}, {1.3, -0.7 * slant, 0}, {-1.7, 2.3 * slant, 0});
        EXPECT_NEAR(found.s, 0.5, 1e-9) << slant;
        EXPECT_NEAR(found.t, 1.0 / 3, 1e-9) << slant;
        EXPECT_LT(found.distance, 1e-15);
    }
}

} // namespace
} // namespace druse
