#include "geom/least_squares.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>

namespace druse {
namespace {

/// The shortest d with n · d = 1 for all these normals, as nearly as there is one.
Vector offset(std::initializer_list<Vector> normals)
{
    Symmetric3 a;
    Vector b(0.0);
    for (const Vector& n : normals) {
        a.add_square(n);
        b += n;
    }
    return least_squares(a, b, 0.02);
}

void expect_near(const Vector& a, const Vector& b) { EXPECT_LT(glm::distance(a, b), 1e-13); }

TEST(LeastSquares, MeetsThePlanesOfACorner)
{
    expect_near(offset({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), {1, 1, 1});
    expect_near(offset({{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, -1}}), {1, 1, -1});
}

TEST(LeastSquares, StaysInTheSpanOfFewerPlanes)
{
    expect_near(offset({{0, 0, 1}}), {0, 0, 1});
    expect_near(offset({{0.6, 0.8, 0}, {0.6, 0.8, 0}}), {0.6, 0.8, 0});
    expect_near(offset({{1, 0, 0}, {0, 0, 1}}), {1, 0, 1});
    expect_near(offset({}), {0, 0, 0});
}

TEST(LeastSquares, LeavesOutDirectionsThatHardlyCount)
{
    // Planes that nearly coincide meet far away; it goes to the nearest point of both instead.
    const double s = 0.01, c = std::sqrt(1 - s * s);
    expect_near(offset({{s, 0, c}, {-s, 0, c}}), {0, 0, 1 / c});
}

TEST(LeastSquares, SolvesWhatHasASolution)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Vector x(number(random), number(random), number(random));
        Symmetric3 a;
        Vector b(0.0);
        for (const Vector& axis : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)}) {
            const Vector n = axis + 0.4 * Vector(number(random), number(random), number(random));
            a.add_square(n);
            b += n * glm::dot(n, x);
        }
        EXPECT_LT(glm::distance(least_squares(a, b, 1e-6), x), 1e-10);
    }
}

} // namespace
} // namespace druse
