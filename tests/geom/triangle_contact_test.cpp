// Pairs of triangles, against their intersection computed in rational numbers.
#include "geom/triangle_contact.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace druse {
namespace {

using Number = mpq_class;

struct Place {
    Number x, y, z;
    friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend bool operator==(const Place& a, const Place& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};
Place rational(const Point& p) { return {p.x, p.y, p.z}; }
Number dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Place cross(const Place& a, const Place& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
bool is_zero(const Place& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

/// What of a convex polygon lies where dot(n, x - p) ≥ 0, or = 0 with `on`.
std::vector<Place> clipped(const std::vector<Place>& polygon, const Place& p, const Place& n, bool on)
{
    std::vector<Place> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Place &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const Number at = dot(n, a - p), bt = dot(n, b - p);
        if (on ? at == 0 : at >= 0) kept.push_back(a);
        if (sgn(at) * sgn(bt) < 0) {
            const Number s = at / (at - bt);
            kept.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)});
        }
    }
    return kept;
}

/// By the definition: the intersection is clipped out of one triangle, and its corners are held against what is common.
bool truly_meet(const Triangle& a, const Triangle& b)
{
    std::vector<Place> piece, other, common;
    for (const Point& p : a) piece.push_back(rational(p));
    for (const Point& p : b) other.push_back(rational(p));
    for (const Place& p : piece)
        if (std::find(other.begin(), other.end(), p) != other.end()) common.push_back(p);
    const Place normal = cross(other[1] - other[0], other[2] - other[0]);
    piece = clipped(piece, other[0], normal, true);
    for (std::size_t i = 0; i < 3; ++i) piece = clipped(piece, other[i], cross(normal, other[(i + 1) % 3] - other[i]), false);
    if (common.size() == 3) return true;
    return std::any_of(piece.begin(), piece.end(), [&](const Place& p) {
        if (common.empty()) return true;
        if (common.size() == 1) return !(p == common[0]);
        return !is_zero(cross(p - common[0], common[1] - common[0])); // on the line, it is on the side: the triangles go no farther
    });
}

bool has_area(const Triangle& t)
{
    const Place a = rational(t[0]);
    return !is_zero(cross(rational(t[1]) - a, rational(t[2]) - a));
}

bool meet(const Triangle& a, const Triangle& b) { return meet_beyond_common(a, shadow_of(a), b); }

/// Both ways, from every corner and in both directions.
void expect_meet(bool expected, Triangle a, Triangle b)
{
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            ASSERT_EQ(meet(a, b), expected);
            ASSERT_EQ(meet(b, a), expected);
            std::rotate(b.begin(), b.begin() + 1, b.end());
        }
        if (i == 1) std::swap(b[0], b[1]);
        std::rotate(a.begin(), a.begin() + 1, a.end());
    }
    std::swap(a[0], a[1]);
    ASSERT_EQ(meet(a, b), expected);
}

const Triangle floor_triangle{Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)};

TEST(TriangleContact, SeesThoseThatPierceEachOther)
{
    expect_meet(true, floor_triangle, {Point(1, 1, -1), Point(1, 1, 1), Point(5, 5, 0)});
    expect_meet(true, floor_triangle, {Point(1, 1, -1), Point(1, 2, 1), Point(2, 1, 1)});
    expect_meet(false, floor_triangle, {Point(3, 3, -1), Point(3, 3, 1), Point(5, 5, 0)});
    expect_meet(false, floor_triangle, {Point(1, 1, 1), Point(2, 1, 1), Point(1, 2, 2)});
}

TEST(TriangleContact, SeesThoseThatTouch)
{
    expect_meet(true, floor_triangle, {Point(1, 1, 0), Point(1, 2, 1), Point(2, 1, 1)});    // a corner inside
    expect_meet(true, floor_triangle, {Point(2, 0, 0), Point(2, -1, 1), Point(3, -1, -1)}); // a corner on a side
    expect_meet(true, floor_triangle, {Point(2, -1, 1), Point(2, 1, -1), Point(3, -3, 0)}); // sides cross in a point
    expect_meet(true, floor_triangle, {Point(1, 1, 0), Point(2, 1, 0), Point(1, 1, 1)});    // a side inside
    expect_meet(true, floor_triangle, {Point(1, 0, 0), Point(2, 0, 0), Point(1, 0, 1)});    // a side on a side
    expect_meet(false, floor_triangle, {Point(2, -0x1p-52, 0), Point(2, -1, 1), Point(3, -1, -1)});
}

TEST(TriangleContact, SeesThoseThatOverlapInAPlane)
{
    expect_meet(true, floor_triangle, {Point(1, 1, 0), Point(2, 1, 0), Point(1, 2, 0)});   // within
    expect_meet(true, floor_triangle, {Point(1, -1, 0), Point(2, -1, 0), Point(1, 8, 0)}); // across
    expect_meet(true, floor_triangle, {Point(2, 2, 0), Point(5, 5, 0), Point(5, 6, 0)});   // a corner on a side
    expect_meet(false, floor_triangle, {Point(3, 3, 0), Point(5, 5, 0), Point(5, 6, 0)});
    expect_meet(true, floor_triangle, floor_triangle);
}

TEST(TriangleContact, LeavesNeighboursAlone)
{
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(4, 0, 0), Point(1, -3, 0)});  // over a side, flat
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(4, 0, 0), Point(1, 3, 1)});   // over a side, bent
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(-4, 0, 0), Point(0, -4, 0)}); // at a corner, flat
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(1, 1, 1), Point(1, 2, 1)});   // at a corner, bent
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(1, 0, 1), Point(-1, 0, 0)});  // and in line with a side
}

TEST(TriangleContact, SeesNeighboursFoldedOntoEachOther)
{
    expect_meet(true, floor_triangle, {Point(0, 0, 0), Point(4, 0, 0), Point(1, 3, 0)});   // over a side
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(4, 0, 0), Point(1, 3, 0x1p-1000)});
    expect_meet(true, floor_triangle, {Point(0, 0, 0), Point(2, 1, 0), Point(1, 2, 0)});   // at a corner, within
    expect_meet(true, floor_triangle, {Point(0, 0, 0), Point(8, 0, 0), Point(0, -8, 0)});  // along a side
    expect_meet(true, floor_triangle, {Point(0, 0, 0), Point(2, 2, 1), Point(2, 2, -1)});  // at a corner, through the other
    expect_meet(true, floor_triangle, {Point(0, 0, 0), Point(2, 0, 0), Point(2, 0, -1)});  // at a corner, along a side
    expect_meet(true, floor_triangle, {Point(0, 0, 0), Point(2, 1, 0), Point(2, 0, -1)});  // at a corner, a side in the plane
    expect_meet(false, floor_triangle, {Point(0, 0, 0), Point(-2, -1, 0), Point(2, 0, -1)});
}

class GridSource {
public:
    explicit GridSource(unsigned seed) : random_(seed) {}
    int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
    double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
    Point on_grid(int size) { return Point(whole(0, size), whole(0, size), whole(0, size)); }

private:
    std::mt19937 random_;
};

TEST(TriangleContact, AgreesWithRationalNumbersOnAGrid)
{
    // So few places that all ways to touch, overlap and share come up.
    for (const int size : {1, 2, 3, 5}) {
        GridSource source{unsigned(size)};
        int met = 0, compared = 0, shared = 0;
        for (int i = 0; i < 6000; ++i) {
            Triangle a, b;
            for (Point& p : a) p = source.on_grid(size);
            for (Point& p : b) p = source.on_grid(size);
            for (std::size_t k = 0; k < 3; ++k) // more neighbours than chance makes
                if (source.whole(0, 3) == 0) b[k] = a[std::size_t(source.whole(0, 2))];
            ASSERT_EQ(shadow_of(a).turn != 0, has_area(a));
            if (!has_area(a) || !has_area(b)) continue;
            ++compared;
            const bool expected = truly_meet(a, b);
            ASSERT_EQ(meet(a, b), expected) << "size " << size << ", case " << i;
            met += expected;
            for (const Point& p : a) shared += std::find(b.begin(), b.end(), p) != b.end();
        }
        EXPECT_GT(compared, 500);
        EXPECT_GT(shared, compared / 4);
        EXPECT_GT(met, compared / 5);
        EXPECT_LT(met, compared);
    }
}

TEST(TriangleContact, AgreesWithRationalNumbersBesideAPlane)
{
    // Corners on a tilted plane, but for rounding: whether they are in it is in the last digit only.
    GridSource source(9);
    int met = 0, flat = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto place = [&] {
            const double x = source.whole(0, 8) * 0.1, y = source.whole(0, 8) * 0.1;
            return Point(x, y, 0.3 * x + 0.7 * y + 0.1);
        };
        Triangle a, b;
        for (Point& p : a) p = place();
        for (Point& p : b) p = place();
        if (i % 2 == 0) b[0] = a[0];
        if (i % 4 == 0) b[1] = a[1];
        if (!has_area(a) || !has_area(b)) continue;
        const bool expected = truly_meet(a, b);
        ASSERT_EQ(meet(a, b), expected) << "case " << i;
        ASSERT_EQ(meet(b, a), expected) << "case " << i;
        met += expected;
        ++flat;
    }
    EXPECT_GT(met, flat / 10);
    EXPECT_LT(met, flat);
}

} // namespace
} // namespace druse
