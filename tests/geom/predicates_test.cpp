// The predicates against rational arithmetic, where rounding would mislead.
#include "geom/predicates.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace druse {
namespace {

// --- the same signs by the definition, without rounding ---------------------------------------------------------------------------

using Row = std::vector<mpq_class>;

mpq_class determinant(const std::vector<Row>& m)
{
    if (m.size() == 1) return m[0][0];
    mpq_class sum = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
        std::vector<Row> minor;
        for (std::size_t j = 0; j < m.size(); ++j)
            if (j != i) minor.emplace_back(m[j].begin() + 1, m[j].end());
        const mpq_class term = m[i][0] * determinant(minor);
        if (i % 2 == 0) sum += term;
        else sum -= term;
    }
    return sum;
}

template <class P>
Row row(const P& p, const P& origin, bool lifted)
{
    Row r;
    mpq_class square = 0;
    for (int k = 0; k < P::length(); ++k) {
        r.push_back(mpq_class(p[k]) - mpq_class(origin[k]));
        square += r.back() * r.back();
    }
    if (lifted) r.push_back(square);
    return r;
}

/// The sign of the determinant of the differences from the last point.
template <class P, std::size_t n>
int sign_of_rows(const std::array<P, n>& points, bool lifted)
{
    std::vector<Row> rows;
    for (std::size_t i = 0; i + 1 < n; ++i) rows.push_back(row(points[i], points[n - 1], lifted));
    return sgn(determinant(rows));
}

struct Orient2 {
    using P = Point2;
    static constexpr std::size_t count = 3, alike = 3; // the first `alike` points are antisymmetric
    static int inexact(const std::array<P, 3>& p) { return filter::orient(p[0], p[1], p[2]); }
    static int asked(const std::array<P, 3>& p) { return orient(p[0], p[1], p[2]); }
    static int true_sign(const std::array<P, 3>& p) { return sign_of_rows(p, false); }
};
struct Orient3 {
    using P = Point;
    static constexpr std::size_t count = 4, alike = 4;
    static int inexact(const std::array<P, 4>& p) { return filter::orient(p[0], p[1], p[2], p[3]); }
    static int asked(const std::array<P, 4>& p) { return orient(p[0], p[1], p[2], p[3]); }
    static int true_sign(const std::array<P, 4>& p) { return -sign_of_rows(p, false); }
};
struct InCircle {
    using P = Point2;
    static constexpr std::size_t count = 4, alike = 3;
    static int inexact(const std::array<P, 4>& p) { return filter::incircle(p[0], p[1], p[2], p[3]); }
    static int asked(const std::array<P, 4>& p) { return incircle(p[0], p[1], p[2], p[3]); }
    static int true_sign(const std::array<P, 4>& p) { return sign_of_rows(p, true); }
};
struct InSphere {
    using P = Point;
    static constexpr std::size_t count = 5, alike = 4;
    static int inexact(const std::array<P, 5>& p) { return filter::insphere(p[0], p[1], p[2], p[3], p[4]); }
    static int asked(const std::array<P, 5>& p) { return insphere(p[0], p[1], p[2], p[3], p[4]); }
    static int true_sign(const std::array<P, 5>& p) { return -sign_of_rows(p, true); }
};

// --- points that nearly, or really, lie on one line, plane, circle or sphere ------------------------------------------------------

class Source {
public:
    explicit Source(unsigned seed) : random_(seed) {}

    double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
    int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

    /// The number, or one of its next neighbours.
    double nearly(double x)
    {
        for (int steps = whole(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1)
            x = std::nextafter(x, steps > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity());
        return x;
    }

    template <class P>
    P anywhere()
    {
        P p;
        for (int k = 0; k < P::length(); ++k) p[k] = number();
        return p;
    }
    template <class P>
    P on_grid(int size)
    {
        P p;
        for (int k = 0; k < P::length(); ++k) p[k] = whole(-size, size);
        return p;
    }
    template <class P>
    P at_any_scale()
    {
        P p;
        for (int k = 0; k < P::length(); ++k) p[k] = whole(0, 5) == 0 ? 0.0 : std::ldexp(number(), whole(-1070, 1020));
        return p;
    }
    /// On the flat through some of the points: a combination of them, rounded.
    template <class P>
    P on_flat_of(std::span<const P> points)
    {
        P p(0.0);
        double rest = 1;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double weight = i + 1 == points.size() ? rest : number();
            rest -= weight;
            p += weight * points[i];
        }
        for (int k = 0; k < P::length(); ++k) p[k] = nearly(p[k]);
        return p;
    }
    /// On a round curve about the origin, then moved.
    template <class P>
    P on_round(double radius, const P& centre)
    {
        P p = anywhere<P>();
        p = centre + p * (radius / glm::length(p));
        for (int k = 0; k < P::length(); ++k) p[k] = nearly(p[k]);
        return p;
    }

private:
    std::mt19937 random_;
};

constexpr int kinds = 8;

template <class Predicate>
std::array<typename Predicate::P, Predicate::count> some_points(Source& source, int kind)
{
    using P = typename Predicate::P;
    std::array<P, Predicate::count> points;
    const P centre = 100.0 * source.anywhere<P>();
    const auto first = [&](std::size_t n) { return std::span<const P>(points.data(), n); };
    for (std::size_t i = 0; i < points.size(); ++i) switch (kind) {
        case 0: points[i] = source.anywhere<P>(); break;
        case 1: points[i] = source.on_grid<P>(2); break;
        case 2: points[i] = source.on_grid<P>(1 << 26); break;
        case 3: points[i] = i + 1 < points.size() ? source.anywhere<P>() : source.on_flat_of<P>(first(std::size_t(P::length()))); break;
        case 4: points[i] = source.on_round<P>(1.0, P(0.0)); break;
        case 5: points[i] = source.on_round<P>(1e-3, centre); break;
        case 6: points[i] = (i + 1 < points.size() ? source.anywhere<P>() : source.on_flat_of<P>(first(std::size_t(P::length())))) + P(16) - P(16); break; // of one last digit
        default: points[i] = source.at_any_scale<P>(); break;
        }
    return points;
}

template <class Predicate>
class Predicates : public testing::Test {};
using All = testing::Types<Orient2, Orient3, InCircle, InSphere>;

class Names {
public:
    template <class Predicate>
    static std::string GetName(int i)
    {
        return std::array{"Orient2", "Orient3", "InCircle", "InSphere"}[std::size_t(i)];
    }
};
TYPED_TEST_SUITE(Predicates, All, Names);

TYPED_TEST(Predicates, AgreeWithRationalArithmetic)
{
    for (int kind = 0; kind < kinds; ++kind) {
        Source source(unsigned(kind) + 1);
        std::array<int, 3> met{};
        for (int i = 0; i < 1500; ++i) {
            const auto points = some_points<TypeParam>(source, kind);
            const int expected = TypeParam::true_sign(points);
            ASSERT_EQ(TypeParam::asked(points), expected) << "kind " << kind << ", case " << i;
            const int inexact = TypeParam::inexact(points);
            ASSERT_TRUE(inexact == 0 || inexact == expected) << "kind " << kind << ", case " << i;
            ++met[std::size_t(expected + 1)];
        }
        EXPECT_GT(met[0], 100) << kind;
        EXPECT_GT(met[2], 100) << kind;
        EXPECT_GT(met[1], kind == 1 ? 100 : -1); // points of a small grid are often degenerate
    }
}

TYPED_TEST(Predicates, TurnRoundWithEveryExchange)
{
    for (int kind = 0; kind < kinds; ++kind) {
        Source source(unsigned(kind) + 100);
        for (int i = 0; i < 200; ++i) {
            const auto points = some_points<TypeParam>(source, kind);
            const int sign = TypeParam::asked(points);
            std::array<std::size_t, TypeParam::alike> order;
            std::iota(order.begin(), order.end(), 0u);
            do {
                int inversions = 0;
                for (std::size_t a = 0; a < order.size(); ++a)
                    for (std::size_t b = 0; b < a; ++b) inversions += order[b] > order[a];
                auto exchanged = points;
                for (std::size_t a = 0; a < order.size(); ++a) exchanged[a] = points[order[a]];
                ASSERT_EQ(TypeParam::asked(exchanged), inversions % 2 == 0 ? sign : -sign) << "kind " << kind << ", case " << i;
            } while (std::next_permutation(order.begin(), order.end()));
        }
    }
}

TYPED_TEST(Predicates, NeedNoExactArithmeticForMostPoints)
{
    Source source(7);
    int decided = 0;
    for (int i = 0; i < 10000; ++i) decided += TypeParam::inexact(some_points<TypeParam>(source, 0)) != 0;
    EXPECT_GT(decided, 9990);
}

TYPED_TEST(Predicates, AreZeroWherePointsCoincide)
{
    Source source(8);
    for (int i = 0; i < 200; ++i) {
        auto points = some_points<TypeParam>(source, i % kinds);
        points[std::size_t(source.whole(1, int(TypeParam::count) - 1))] = points[0];
        EXPECT_EQ(TypeParam::asked(points), 0);
    }
}

// --- constructed places -----------------------------------------------------------------------------------------------------------

TEST(ConstructedPlaces, MissTheTrueOnesByTheirRoundingOnly)
{
    Source source(11);
    for (const double scale : {1.0, 1e140, 1e-130})
        for (int i = 0; i < 2000; ++i) {
            const Point2 m = source.anywhere<Point2>(), u = source.anywhere<Point2>() * (i % 3 == 0 ? 1e-9 : 1.0);
            const Point2 v = i % 2 == 0 ? source.anywhere<Point2>() : u + 1e-12 * source.anywhere<Point2>(); // half of them all but parallel
            const Point2 a = scale * (m - u), b = scale * (m + u), c = scale * (m - v), d = scale * (m + v);
            if (orient(a, b, c) * orient(a, b, d) >= 0 || orient(c, d, a) * orient(c, d, b) >= 0) continue;
            const mpq_class ux = mpq_class(b.x) - mpq_class(a.x), uy = mpq_class(b.y) - mpq_class(a.y);
            const mpq_class vx = mpq_class(d.x) - mpq_class(c.x), vy = mpq_class(d.y) - mpq_class(c.y);
            const mpq_class t = ((mpq_class(c.x) - mpq_class(a.x)) * vy - (mpq_class(c.y) - mpq_class(a.y)) * vx) / (ux * vy - uy * vx);
            const Point2 x = crossing(a, b, c, d), p = scale * source.anywhere<Point2>(), f = foot(p, a, b);
            mpq_class s = ((mpq_class(p.x) - mpq_class(a.x)) * ux + (mpq_class(p.y) - mpq_class(a.y)) * uy) / (ux * ux + uy * uy);
            if (s < 0) s = 0;
            if (s > 1) s = 1;
            for (int k = 0; k < 2; ++k) {
                const mpq_class line = k == 0 ? ux : uy, origin = mpq_class(a[k]);
                EXPECT_LE(std::abs(mpq_class(mpq_class(x[k]) - origin - t * line).get_d()), std::abs(x[k]) * 0x1.01p-53) << i;
                EXPECT_LE(std::abs(mpq_class(mpq_class(f[k]) - origin - s * line).get_d()), std::abs(f[k]) * 0x1.01p-53) << i;
            }
        }
}

TEST(PredicateSigns, BreakTiesOfACircleAtItsFirstPoint)
{
    // A square: of its two diagonals the one from the lower left corner is kept, whichever way round and from whichever side it is asked.
    const std::array<Point2, 4> p{Point2(0, 0), Point2(1, 0), Point2(1, 1), Point2(0, 1)};
    for (std::size_t i = 0; i < 4; ++i) {
        const int expected = i % 2 == 0 ? -1 : 1; // the diagonal i, i + 2: 0–2 stays, 1–3 goes
        EXPECT_EQ(incircle_in_order(p[i], p[(i + 2) % 4], p[(i + 3) % 4], p[(i + 1) % 4]), expected);
    }
}

// --- conventions ------------------------------------------------------------------------------------------------------------------

TEST(PredicateSigns, AreThoseOfTheDocumentation)
{
    EXPECT_EQ(orient(Point2(0, 0), Point2(1, 0), Point2(0, 1)), 1);
    EXPECT_EQ(orient(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)), 1); // above a face that looks up
    EXPECT_EQ(incircle({1, 0}, {0, 1}, {-1, 0}, {0, 0}), 1);
    EXPECT_EQ(incircle({1, 0}, {0, 1}, {-1, 0}, {2, 0}), -1);
    EXPECT_EQ(incircle({1, 0}, {0, 1}, {-1, 0}, {0, -1}), 0);
    ASSERT_EQ(orient(Point(1, 0, 0), Point(-1, 1, 0), Point(-1, -1, 0), Point(0, 0, 1)), 1);
    EXPECT_EQ(insphere({1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, 0.5}), 1);
    EXPECT_EQ(insphere({1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, 5}), -1);
}

TEST(PredicateSigns, TellTheLeastStepFromAPlaneThatRoundingHides)
{
    // 0.1, 0.2 and 0.3 are not what they are called: their sum misses 0.6 by a digit, which a plane x + y + z = c shows.
    const Point a(0.1, 0.2, 0.3);
    const double c = 0.1 + 0.2 + 0.3;
    const std::array<Point, 4> points{Point(c, 0, 0), Point(0, c, 0), Point(0, 0, c), a};
    const mpq_class excess = mpq_class(0.1) + mpq_class(0.2) + mpq_class(0.3) - mpq_class(c);
    EXPECT_NE(sgn(excess), 0);
    EXPECT_EQ(orient(points[0], points[1], points[2], points[3]), sgn(excess));
}

TEST(PredicateSigns, AreRightOnThisMachine) { EXPECT_TRUE(predicates_are_exact()); }

} // namespace
} // namespace druse
