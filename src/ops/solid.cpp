#include "ops/solid.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "geom/turn.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace druse {

namespace {

using Points = std::vector<Point>;
constexpr double phi = std::numbers::phi;
constexpr double sqrt2 = std::numbers::sqrt2;

// --- points by symmetry -------------------------------------------------------------------------------------------------------

/// The three even permutations of coordinates.
std::array<Point, 3> turned(const Point& p) { return {{{p.x, p.y, p.z}, {p.z, p.x, p.y}, {p.y, p.z, p.x}}}; }
Point swapped(const Point& p) { return {p.y, p.x, p.z}; }

/// p with the signs of `signs` (a bit for each coordinate), and how many of them are minus.
Point signed_point(const Point& p, int signs) { return {signs & 1 ? -p.x : p.x, signs & 2 ? -p.y : p.y, signs & 4 ? -p.z : p.z}; }
int minus_count(int signs) { return (signs & 1) + (signs >> 1 & 1) + (signs >> 2 & 1); }

void add_once(Points& points, const Point& p)
{
    if (std::ranges::find(points, p) == points.end()) points.push_back(p);
}

/// Even permutations of the given points with all signs.
Points even_permutations(std::initializer_list<Point> seeds)
{
    Points points;
    for (const Point& seed : seeds)
        for (const Point& p : turned(seed))
            for (int signs = 0; signs < 8; ++signs) add_once(points, signed_point(p, signs));
    return points;
}

/// All permutations with all signs.
Points permutations(const Point& seed) { return even_permutations({seed, swapped(seed)}); }

/// Permutations whose number of minus signs is even.
Points with_even_signs(const Point& seed)
{
    Points points;
    for (const Point& s : {seed, swapped(seed)})
        for (const Point& p : turned(s))
            for (int signs = 0; signs < 8; ++signs)
                if (minus_count(signs) % 2 == 0) add_once(points, signed_point(p, signs));
    return points;
}

/// Even permutations with an odd number of minus signs (so an even number of plus signs), odd ones with an even number.
Points snub_cube()
{
    const double root = 3 * std::sqrt(33.0);
    const double t = (1 + std::cbrt(19 + root) + std::cbrt(19 - root)) / 3; // the tribonacci constant: t³ = t² + t + 1
    const Point seed(1, 1 / t, t);
    Points points;
    for (int signs = 0; signs < 8; ++signs)
        for (const Point& p : turned(minus_count(signs) % 2 == 1 ? seed : swapped(seed))) points.push_back(signed_point(p, signs));
    return points;
}

/// The orbit, under the 60 rotations of the icosahedron, of the point that lies equally far from its images under the turns by a
/// fifth, a third and a half about neighbouring axes.
Points snub_dodecahedron()
{
    // The icosahedron's vertices are (0, ±1, ±φ) and their even permutations.
    const Vector five = unit(Vector(0, 1, phi)), three = unit(Vector(1 / phi, 0, phi)), two(0, 0, 1);
    const Point2 fifth = turn(1, 5);
    // The image of p under a turn by 2α about an axis is 2 sin α |p × axis| away. So the squares of sin α |p × axis| are equal.
    const double s5 = (1 - fifth.x) / 2, s3 = 0.75, s2 = 1.0;
    Point p = unit(five + three + two);
    for (int k = 0; k < 60; ++k) {
        // Newton's step for the two differences, with |p| kept.
        const auto square = [&p](const Vector& axis, double s) { const Vector c = glm::cross(p, axis); return s * glm::dot(c, c); };
        const auto slope = [&p](const Vector& axis, double s) { return 2 * s * (p - glm::dot(p, axis) * axis); };
        const double f = square(five, s5) - square(three, s3), g = square(three, s3) - square(two, s2);
        const Vector df = slope(five, s5) - slope(three, s3), dg = slope(three, s3) - slope(two, s2);
        // Solve df·x = −f, dg·x = −g, p·x = 0.
        const double det = glm::dot(p, glm::cross(df, dg));
        const Vector x = (-f * glm::cross(dg, p) - g * glm::cross(p, df)) / det;
        p = unit(p + x);
        if (glm::length(x) < 1e-16) break;
    }
    Points points;
    for (int k = 0; k < 5; ++k) {
        const Point2 t = turn(k, 5);
        const Point q = t.x * p + t.y * glm::cross(five, p) + (1 - t.x) * glm::dot(five, p) * five;
        for (int signs = 0; signs < 8; ++signs)
            if (minus_count(signs) % 2 == 0)
                for (const Point& r : turned(q)) points.push_back(signed_point(r, signs));
    }
    return points;
}

// --- points in rings about the z axis, edges of length 1 --------------------------------------------------------------------

double circumradius(int n) { return 0.5 / turn(1, 2 * n).y; }
double apothem(int n)
{
    const Point2 half = turn(1, 2 * n);
    return 0.5 * half.x / half.y;
}

/// n points at height z, the first one at the fraction i/of of a turn.
void add_ring(Points& points, int n, double radius, double z, int i = 0, int of = 1)
{
    for (int k = 0; k < n; ++k) {
        const Point2 t = turn(std::int64_t(i) * n + std::int64_t(k) * of, std::int64_t(of) * n);
        points.emplace_back(radius * t.x, radius * t.y, z);
    }
}
void add_ring_of_edges(Points& points, int n, double z, int i = 0, int of = 1) { add_ring(points, n, circumradius(n), z, i, of); }

double antiprism_height(int n)
{
    const double half = 0.5 / turn(1, 4 * n).x; // horizontal distance between neighbours of two rings
    return std::sqrt(1 - half * half);
}
double pyramid_height(int n) { return std::sqrt(1 - circumradius(n) * circumradius(n)); }
double cupola_height(int n)
{
    const double run = apothem(2 * n) - apothem(n); // of the squares
    return std::sqrt(1 - run * run);
}

/// The upper ring of a cupola whose lower ring of 2n has an edge across +x, where the upper one has an edge too, or a corner.
void add_cupola_top(Points& points, int n, double z, bool edge_across_x = true)
{
    if (edge_across_x) add_ring_of_edges(points, n, z, 1, 2 * n);
    else add_ring_of_edges(points, n, z);
}
void add_cupola_base(Points& points, int n, double z) { add_ring_of_edges(points, 2 * n, z, 1, 4 * n); }

struct Family {
    const char* name; // before `:`, or the whole name
    int least, most;  // of N; 0: the name has no N
    Points (*points)(int n);
};

const std::vector<Family>& families()
{
    static const std::vector<Family> list{
        {"tetrahedron", 0, 0, [](int) { return with_even_signs({1, 1, 1}); }},
        {"cube", 0, 0, [](int) { return permutations({1, 1, 1}); }},
        {"octahedron", 0, 0, [](int) { return permutations({0, 0, 1}); }},
        {"dodecahedron", 0, 0, [](int) { return even_permutations({{1, 1, 1}, {0, phi, 1 / phi}}); }},
        {"icosahedron", 0, 0, [](int) { return even_permutations({{0, 1, phi}}); }},
        {"truncated_tetrahedron", 0, 0, [](int) { return with_even_signs({1, 1, 3}); }},
        {"cuboctahedron", 0, 0, [](int) { return permutations({0, 1, 1}); }},
        {"truncated_cube", 0, 0, [](int) { return permutations({1, 1 + sqrt2, 1 + sqrt2}); }},
        {"truncated_octahedron", 0, 0, [](int) { return permutations({0, 1, 2}); }},
        {"rhombicuboctahedron", 0, 0, [](int) { return permutations({1, 1, 1 + sqrt2}); }},
        {"truncated_cuboctahedron", 0, 0, [](int) { return permutations({1, 1 + sqrt2, 1 + 2 * sqrt2}); }},
        {"snub_cube", 0, 0, [](int) { return snub_cube(); }},
        {"icosidodecahedron", 0, 0, [](int) { return even_permutations({{0, 0, phi}, {0.5, phi / 2, phi * phi / 2}}); }},
        {"truncated_dodecahedron", 0, 0,
         [](int) { return even_permutations({{0, 1 / phi, 2 + phi}, {1 / phi, phi, 2 * phi}, {phi, 2, phi + 1}}); }},
        {"truncated_icosahedron", 0, 0,
         [](int) { return even_permutations({{0, 1, 3 * phi}, {1, 2 + phi, 2 * phi}, {phi, 2, 2 * phi + 1}}); }},
        {"rhombicosidodecahedron", 0, 0,
         [](int) { return even_permutations({{1, 1, 2 * phi + 1}, {phi + 1, phi, 2 * phi}, {2 + phi, 0, phi + 1}}); }},
        {"truncated_icosidodecahedron", 0, 0,
         [](int) {
             return even_permutations({{1 / phi, 1 / phi, 3 + phi},
                                       {2 / phi, phi, 1 + 2 * phi},
                                       {1 / phi, phi + 1, 3 * phi - 1},
                                       {2 * phi - 1, 2, 2 + phi},
                                       {phi, 3, 2 * phi}});
         }},
        {"snub_dodecahedron", 0, 0, [](int) { return snub_dodecahedron(); }},
        {"prism", 3, 100,
         [](int n) {
             Points p;
             add_ring_of_edges(p, n, 0);
             add_ring_of_edges(p, n, 1);
             return p;
         }},
        {"antiprism", 3, 100,
         [](int n) {
             Points p;
             add_ring_of_edges(p, n, 0);
             add_ring_of_edges(p, n, antiprism_height(n), 1, 2 * n);
             return p;
         }},
        {"pyramid", 3, 5,
         [](int n) {
             Points p{{0, 0, pyramid_height(n)}};
             add_ring_of_edges(p, n, 0);
             return p;
         }},
        {"cupola", 3, 5,
         [](int n) {
             Points p;
             add_cupola_base(p, n, 0);
             add_cupola_top(p, n, cupola_height(n));
             return p;
         }},
        {"rotunda", 0, 0,
         [](int) {
             // Half of the icosidodecahedron, whose vertices are the midpoints of the edges, 2 long, of an icosahedron.
             const double top = std::sqrt(phi + 2), ring = top / std::sqrt(5.0);
             Points p;
             add_ring_of_edges(p, 10, 0, 1, 20);
             add_ring(p, 5, 2 * apothem(5), ring, 1, 10);
             add_ring_of_edges(p, 5, (top + ring) / 2);
             return p;
         }},
        {"bipyramid", 3, 5,
         [](int n) {
             Points p{{0, 0, pyramid_height(n)}, {0, 0, -pyramid_height(n)}};
             add_ring_of_edges(p, n, 0);
             return p;
         }},
        {"elongated_pyramid", 3, 5,
         [](int n) {
             Points p{{0, 0, 1 + pyramid_height(n)}};
             add_ring_of_edges(p, n, 0);
             add_ring_of_edges(p, n, 1);
             return p;
         }},
        {"gyroelongated_pyramid", 4, 5,
         [](int n) {
             Points p{{0, 0, antiprism_height(n) + pyramid_height(n)}};
             add_ring_of_edges(p, n, 0, 1, 2 * n);
             add_ring_of_edges(p, n, antiprism_height(n));
             return p;
         }},
        {"elongated_cupola", 3, 5,
         [](int n) {
             Points p;
             add_cupola_base(p, n, 0);
             add_cupola_base(p, n, 1);
             add_cupola_top(p, n, 1 + cupola_height(n));
             return p;
         }},
        {"gyroelongated_cupola", 3, 5,
         [](int n) {
             Points p;
             add_ring_of_edges(p, 2 * n, 0); // a corner below each edge of the cupola's base
             add_cupola_base(p, n, antiprism_height(2 * n));
             add_cupola_top(p, n, antiprism_height(2 * n) + cupola_height(n));
             return p;
         }},
        {"orthobicupola", 3, 5,
         [](int n) {
             Points p;
             add_cupola_top(p, n, -cupola_height(n));
             add_cupola_base(p, n, 0);
             add_cupola_top(p, n, cupola_height(n));
             return p;
         }},
        {"gyrobicupola", 3, 5,
         [](int n) {
             Points p;
             add_cupola_top(p, n, -cupola_height(n), false);
             add_cupola_base(p, n, 0);
             add_cupola_top(p, n, cupola_height(n));
             return p;
         }},
    };
    return list;
}

// --- from points to a mesh -----------------------------------------------------------------------------------------------------

/// Sorts by elevation, then by azimuth from +x; what differs by less than 1e-6 is level.
std::tuple<std::int64_t, std::int64_t> reading_order(const Point& p)
{
    const bool on_axis = std::hypot(p.x, p.y) < 1e-6;
    double azimuth = on_axis ? 0.0 : std::atan2(p.y, p.x);
    if (azimuth < -1e-6) azimuth += 2 * std::numbers::pi;
    return {std::llround(p.z * 1e6), std::llround(azimuth * 1e6)};
}

/// The convex solid whose edges are the pairs of points at the least distance, scaled to edges of length `size`.
Mesh equal_edged(Points points, double size)
{
    Point mean(0.0);
    for (const Point& p : points) mean += p / double(points.size());
    for (int k = 0; k < 3; ++k)
        if (std::abs(mean[k]) < 1e-12) mean[k] = 0.0; // symmetric points keep their digits
    for (Point& p : points) p -= mean;
    double edge = glm::distance(points[0], points[1]);
    for (const Point& p : points)
        if (p != points[0]) edge = std::min(edge, glm::distance(p, points[0]));
    for (Point& p : points) p /= edge;
    std::ranges::sort(points, {}, reading_order);

    // The neighbours of a vertex, counter-clockwise seen from outside. In no regular-faced solid do others come nearer than 1.05.
    const auto count = static_cast<std::uint32_t>(points.size());
    std::vector<std::vector<std::uint32_t>> around(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        std::vector<std::pair<double, std::uint32_t>> turns;
        Vector x(0.0), y(0.0);
        for (std::uint32_t w = 0; w < count; ++w) {
            const Vector to = points[w] - points[v];
            if (w == v || glm::length(to) > 1.02) continue;
            if (turns.empty()) {
                const Vector out = unit(points[v]);
                x = unit(to - glm::dot(to, out) * out);
                y = glm::cross(out, x);
            }
            const double angle = turns.empty() ? 0.0 : std::atan2(glm::dot(to, y), glm::dot(to, x));
            turns.emplace_back(angle < 0 ? angle + 2 * std::numbers::pi : angle, w);
        }
        std::ranges::sort(turns);
        for (const auto& [angle, w] : turns) around[v].push_back(w);
    }
    // A face keeps to the left: after u → v comes the neighbour of v before u.
    struct Polygon {
        Point centre;
        std::vector<std::uint32_t> ring;
    };
    std::vector<Polygon> polygons;
    for (std::uint32_t v = 0; v < count; ++v)
        for (const std::uint32_t w : around[v]) {
            Polygon polygon{Point(0.0), {v}};
            std::uint32_t from = v, to = w;
            while (to != v && to > v) {
                polygon.ring.push_back(to);
                const auto& list = around[to];
                const auto at = std::ranges::find(list, from) - list.begin();
                from = std::exchange(to, list[(std::size_t(at) + list.size() - 1) % list.size()]);
            }
            if (to != v) continue; // it has a lower vertex, and is found from there
            for (const std::uint32_t i : polygon.ring) polygon.centre += points[i] / double(polygon.ring.size());
            polygons.push_back(std::move(polygon));
        }
    std::ranges::sort(polygons, {}, [](const Polygon& p) { return reading_order(p.centre); });

    MeshBuilder builder;
    for (const Point& p : points) builder.add_vertex(size * p);
    for (const Polygon& p : polygons) builder.add_face(p.ring);
    return builder.build();
}

} // namespace

const std::vector<std::string>& solid_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Family& family : families()) list.push_back(family.least > 0 ? fmt::format("{}:N", family.name) : family.name);
        return list;
    }();
    return names;
}

namespace {

struct Member {
    const Family& family;
    int n; // 0 where the family is one solid
};

/// @throws CommandError that does not repeat the name
Member find_solid(std::string_view name)
{
    const auto colon = name.find(':');
    const std::string_view word = name.substr(0, colon);
    for (const Family& family : families()) {
        if (word != family.name) continue;
        if (family.least == 0) {
            if (colon != std::string_view::npos) throw CommandError(fmt::format("expected {} without a number", word));
            return {family, 0};
        }
        std::uint32_t n = 0;
        try {
            if (colon != std::string_view::npos) n = parse_id(name.substr(colon + 1));
        } catch (const CommandError&) {
        }
        if (n < std::uint32_t(family.least) || n > std::uint32_t(family.most))
            throw CommandError(fmt::format("expected {}:N with N {} to {}", word, family.least, family.most));
        return {family, int(n)};
    }
    std::vector<std::string> words;
    for (const Family& family : families()) words.emplace_back(family.name);
    const std::string best = nearest(word, words);
    throw CommandError(best.empty() ? "expected " + listing(solid_names()) : fmt::format("there is no such solid; did you mean '{}'?", best));
}

} // namespace

void check_solid_name(std::string_view name) { find_solid(name); }

Mesh make_solid(std::string_view name, double size)
{
    try {
        const Member solid = find_solid(name);
        return equal_edged(solid.family.points(solid.n), size);
    } catch (const CommandError& e) {
        throw CommandError(fmt::format("name={}: {}", name, e.what()));
    }
}

} // namespace druse
