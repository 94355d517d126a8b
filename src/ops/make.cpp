#include "ops/make.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "dlfl/mesh_tables.h"
#include "geom/turn.h"
#include "ops/registry.h"
#include "ops/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace druse {

namespace {

/// The radius on which points lie 1 apart.
double circumradius(int n) { return 0.5 / turn(1, 2 * n).y; }

Point on_circle(std::int64_t i, std::int64_t n, double radius, double z)
{
    const Point2 t = turn(i, n);
    return {radius * t.x, radius * t.y, z};
}

std::uint32_t wrap(int i, int n) { return static_cast<std::uint32_t>(i < n ? i : i - n); }

/// first, first + 1, … seen from above, or first, first + n − 1, … seen from below.
void add_ring_up(MeshBuilder& builder, int first, int n)
{
    for (int i = 0; i < n; ++i) builder.add_corner(static_cast<std::uint32_t>(first + i));
    builder.end_face();
}
void add_ring_down(MeshBuilder& builder, int first, int n)
{
    for (int i = 0; i < n; ++i) builder.add_corner(static_cast<std::uint32_t>(first) + wrap(n - i, n));
    builder.end_face();
}

void add_face(MeshBuilder& builder, std::initializer_list<std::uint32_t> ring)
{
    builder.add_face(std::span(ring.begin(), ring.size()));
}

/// number_edges() for large tables, reporting on the way.
template <class Opposite>
void number_edges(MeshTables& tables, std::uint64_t corners, Progress& progress, Opposite&& opposite)
{
    tables.number_edges([&](std::uint32_t c) {
        if (c % (1u << 20) == 0) progress.step(0.5 + 0.5 * double(c) / double(corners));
        return opposite(c);
    });
}

} // namespace

Mesh make_polygon(int n, double size)
{
    MeshBuilder builder;
    for (int i = 0; i < n; ++i) builder.add_vertex(on_circle(i, n, size * circumradius(n), 0));
    add_ring_up(builder, 0, n);
    add_ring_down(builder, 0, n);
    return builder.build();
}

Mesh make_prism(int n, double size)
{
    MeshBuilder builder;
    for (const double z : {-0.5 * size, 0.5 * size})
        for (int i = 0; i < n; ++i) builder.add_vertex(on_circle(i, n, size * circumradius(n), z));
    const auto m = static_cast<std::uint32_t>(n);
    add_ring_down(builder, 0, n);
    for (std::uint32_t i = 0; i < m; ++i) {
        const std::uint32_t j = i + 1 < m ? i + 1 : 0;
        add_face(builder, {i, j, m + j, m + i});
    }
    add_ring_up(builder, n, n);
    return builder.build();
}

Mesh make_antiprism(int n, double size)
{
    const double half_chord = 0.5 / turn(1, 4 * n).x; // horizontal distance from a corner to the nearest of the other ring
    const double z = 0.5 * size * std::sqrt(1 - half_chord * half_chord), radius = size * circumradius(n);
    MeshBuilder builder;
    for (int i = 0; i < n; ++i) builder.add_vertex(on_circle(i, n, radius, -z));
    for (int i = 0; i < n; ++i) builder.add_vertex(on_circle(2 * i + 1, 2 * n, radius, z));
    const auto m = static_cast<std::uint32_t>(n);
    add_ring_down(builder, 0, n);
    for (std::uint32_t i = 0; i < m; ++i) add_face(builder, {i, i + 1 < m ? i + 1 : 0, m + i});
    for (std::uint32_t i = 0; i < m; ++i) {
        const std::uint32_t j = i + 1 < m ? i + 1 : 0;
        add_face(builder, {j, m + j, m + i});
    }
    add_ring_up(builder, n, n);
    return builder.build();
}

Mesh make_grid(int nx, int ny, double size, Progress& progress)
{
    const auto w = static_cast<std::uint32_t>(nx), h = static_cast<std::uint32_t>(ny), squares = w * h, rim = 4 * squares;
    const std::uint64_t corners = std::uint64_t(rim) + 2 * (w + h);
    MeshTables t((w + 1) * (h + 1), corners / 2, squares + 1, corners);
    const auto at = [w](std::uint32_t x, std::uint32_t y) { return y * (w + 1) + x; };

    for (std::uint32_t y = 0; y <= h; ++y)
        for (std::uint32_t x = 0; x <= w; ++x) t.position[at(x, y)] = {size * (x - 0.5 * nx), size * (y - 0.5 * ny), 0.0};
    for (std::uint32_t y = 0; y < h; ++y) {
        progress.step(0.5 * y / h);
        for (std::uint32_t x = 0; x < w; ++x) {
            const std::uint32_t f = y * w + x, c = 4 * f;
            t.vertex[c] = Vertex(at(x, y));
            t.vertex[c + 1] = Vertex(at(x + 1, y));
            t.vertex[c + 2] = Vertex(at(x + 1, y + 1));
            t.vertex[c + 3] = Vertex(at(x, y + 1));
            t.close_face(f, c, 4);
        }
    }
    // The rim seen from below: up the left side, right along the top, down, and back along the bottom.
    std::uint32_t c = rim;
    for (std::uint32_t y = 0; y < h; ++y) t.vertex[c++] = Vertex(at(0, y));
    for (std::uint32_t x = 0; x < w; ++x) t.vertex[c++] = Vertex(at(x, h));
    for (std::uint32_t y = h; y > 0; --y) t.vertex[c++] = Vertex(at(w, y));
    for (std::uint32_t x = w; x > 0; --x) t.vertex[c++] = Vertex(at(x, 0));
    t.close_face(squares, rim, 2 * (w + h));
    std::fill_n(t.group, squares + 1, 0);

    number_edges(t, corners, progress, [=](std::uint32_t corner) {
        if (corner >= rim) {
            std::uint32_t i = corner - rim;
            if (i < h) return 4 * (i * w) + 3;
            i -= h;
            if (i < w) return 4 * ((h - 1) * w + i) + 2;
            i -= w;
            if (i < h) return 4 * ((h - 1 - i) * w + w - 1) + 1;
            i -= h;
            return 4 * (w - 1 - i);
        }
        const std::uint32_t f = corner / 4, x = f % w, y = f / w;
        switch (corner % 4) {
        case 0: return y > 0 ? corner - 4 * w + 2 : rim + h + w + h + (w - 1 - x);
        case 1: return x + 1 < w ? corner + 4 + 2 : rim + h + w + (h - 1 - y);
        case 2: return y + 1 < h ? corner + 4 * w - 2 : rim + h + x;
        default: return x > 0 ? corner - 4 - 2 : rim + y;
        }
    });
    t.find_vertex_corners();
    return t.take();
}

Mesh make_torus(int nu, int nv, double major, double minor, Progress& progress)
{
    const auto n = static_cast<std::uint32_t>(nu), m = static_cast<std::uint32_t>(nv), count = n * m;
    const std::uint64_t corners = 4 * std::uint64_t(count);
    MeshTables t(count, corners / 2, count, corners);
    const auto at = [m](std::uint32_t i, std::uint32_t j) { return i * m + j; };

    std::vector<Point2> around(m);
    for (std::uint32_t j = 0; j < m; ++j) around[j] = turn(j, nv);
    for (std::uint32_t i = 0; i < n; ++i) {
        progress.step(0.5 * i / n);
        const Point2 u = turn(i, nu);
        const std::uint32_t next_i = i + 1 < n ? i + 1 : 0;
        for (std::uint32_t j = 0; j < m; ++j) {
            const double r = major + minor * around[j].x;
            t.position[at(i, j)] = {r * u.x, r * u.y, minor * around[j].y};
            const std::uint32_t f = at(i, j), c = 4 * f, next_j = j + 1 < m ? j + 1 : 0;
            t.vertex[c] = Vertex(f);
            t.vertex[c + 1] = Vertex(at(next_i, j));
            t.vertex[c + 2] = Vertex(at(next_i, next_j));
            t.vertex[c + 3] = Vertex(at(i, next_j));
            t.close_face(f, c, 4);
        }
    }
    std::fill_n(t.group, count, 0);
    number_edges(t, corners, progress, [=](std::uint32_t corner) {
        const std::uint32_t f = corner / 4, i = f / m, j = f % m;
        switch (corner % 4) {
        case 0: return 4 * at(i, j > 0 ? j - 1 : m - 1) + 2;
        case 1: return 4 * at(i + 1 < n ? i + 1 : 0, j) + 3;
        case 2: return 4 * at(i, j + 1 < m ? j + 1 : 0);
        default: return 4 * at(i > 0 ? i - 1 : n - 1, j) + 1;
        }
    });
    t.find_vertex_corners();
    return t.take();
}

Mesh make_sphere(int nu, int nv, double radius, Progress& progress)
{
    const auto n = static_cast<std::uint32_t>(nu), bands = static_cast<std::uint32_t>(nv);
    const std::uint32_t quads = n * (bands - 2), south = 3 * n, north = south + 4 * quads; // first corners of quads and upper triangles
    const std::uint32_t vertices = n * (bands - 1) + 2, faces = n * bands;
    const std::uint64_t corners = std::uint64_t(north) + 3 * n;
    MeshTables t(vertices, corners / 2, faces, corners);
    const auto at = [n](std::uint32_t i, std::uint32_t ring) { return 1 + (ring - 1) * n + (i < n ? i : 0); }; // ring 1 … bands − 1

    t.position[0] = {0, 0, -radius};
    t.position[vertices - 1] = {0, 0, radius};
    std::vector<Point2> meridian(n);
    for (std::uint32_t i = 0; i < n; ++i) meridian[i] = turn(i, nu);
    for (std::uint32_t ring = 1; ring < bands; ++ring) {
        const Point2 up = turn(2 * std::int64_t(ring) - nv, 4 * nv); // from −90 to 90 degrees
        for (std::uint32_t i = 0; i < n; ++i) t.position[at(i, ring)] = {radius * up.x * meridian[i].x, radius * up.x * meridian[i].y, radius * up.y};
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t low = 3 * i, high = north + 3 * i;
        t.vertex[low] = Vertex(0);
        t.vertex[low + 1] = Vertex(at(i + 1, 1));
        t.vertex[low + 2] = Vertex(at(i, 1));
        t.close_face(i, low, 3);
        t.vertex[high] = Vertex(at(i, bands - 1));
        t.vertex[high + 1] = Vertex(at(i + 1, bands - 1));
        t.vertex[high + 2] = Vertex(vertices - 1);
        t.close_face(n + quads + i, high, 3);
    }
    for (std::uint32_t band = 1; band + 1 < bands; ++band) {
        progress.step(0.5 * band / bands);
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t q = (band - 1) * n + i, c = south + 4 * q;
            t.vertex[c] = Vertex(at(i, band));
            t.vertex[c + 1] = Vertex(at(i + 1, band));
            t.vertex[c + 2] = Vertex(at(i + 1, band + 1));
            t.vertex[c + 3] = Vertex(at(i, band + 1));
            t.close_face(n + q, c, 4);
        }
    }
    std::fill_n(t.group, faces, 0);

    const auto right = [n](std::uint32_t i) { return i + 1 < n ? i + 1 : 0; };
    const auto left = [n](std::uint32_t i) { return i > 0 ? i - 1 : n - 1; };
    number_edges(t, corners, progress, [=](std::uint32_t c) {
        if (c < south) {
            const std::uint32_t i = c / 3;
            if (c % 3 == 0) return 3 * right(i) + 2;
            if (c % 3 == 2) return 3 * left(i);
            return quads > 0 ? south + 4 * i : north + 3 * i;
        }
        if (c >= north) {
            const std::uint32_t i = (c - north) / 3;
            if ((c - north) % 3 == 1) return north + 3 * right(i) + 2;
            if ((c - north) % 3 == 2) return north + 3 * left(i) + 1;
            return quads > 0 ? north - 4 * n + 4 * i + 2 : 3 * i + 1;
        }
        const std::uint32_t q = (c - south) / 4, i = q % n, row = q - i;
        switch ((c - south) % 4) {
        case 0: return row > 0 ? c - 4 * n + 2 : 3 * i + 1;
        case 1: return south + 4 * (row + right(i)) + 3;
        case 2: return row + n < quads ? c + 4 * n - 2 : north + 3 * i;
        default: return south + 4 * (row + left(i)) + 1;
        }
    });
    t.find_vertex_corners();
    return t.take();
}

Mesh make_geodesic(int frequency, double radius)
{
    const Mesh solid = make_solid("icosahedron", 1);
    const auto f = static_cast<std::uint32_t>(frequency);
    MeshBuilder builder;
    builder.reserve(10 * f * f + 2, 20 * f * f, 60 * f * f);
    // Vertices: the icosahedron's, then those inside its edges, then those inside its faces.
    const auto add = [&](const Point& p) { return builder.add_vertex(radius * unit(p)); };
    for (const Vertex v : solid.vertices()) add(solid.position(v));
    for (const Edge e : solid.edges()) {
        const auto [a, b] = solid.ends(e);
        for (std::uint32_t k = 1; k < f; ++k) add((double(f - k) * solid.position(a) + double(k) * solid.position(b)) / double(f));
    }
    const auto on_side = [&](Corner c, std::uint32_t k) { // the k-th point of the side that starts at c
        if (k == 0) return solid.vertex(c).index;
        if (k == f) return solid.target(c).index;
        const Edge e = solid.edge(c);
        return 12 + e.index * (f - 1) + (solid.corner(e, 0) == c ? k : f - k) - 1;
    };
    std::vector<std::uint32_t> row, above;
    for (const Face face : solid.faces()) {
        const Corner a = solid.corner(face), b = solid.next(a), c = solid.next(b);
        row.clear();
        for (std::uint32_t i = 0; i <= f; ++i) row.push_back(on_side(a, i));
        for (std::uint32_t j = 1; j <= f; ++j) {
            above.clear();
            above.push_back(on_side(c, f - j));
            for (std::uint32_t i = 1; i + j < f; ++i)
                above.push_back(add((double(f - i - j) * solid.position(a) + double(i) * solid.position(b) + double(j) * solid.position(c)) / double(f)));
            if (j < f) above.push_back(on_side(b, j));
            for (std::uint32_t i = 0; i + j <= f; ++i) {
                add_face(builder, {row[i], row[i + 1], above[i]});
                if (i + j < f) add_face(builder, {row[i + 1], above[i + 1], above[i]});
            }
            row.swap(above);
        }
    }
    return builder.build();
}

// --- registration ---------------------------------------------------------------------------------------------------------------

namespace {

/// Adds a shape to the scene; its faces become the selected ones.
void add_to_scene(Scene& scene, Mesh shape)
{
    for (const Point& p : shape.positions())
        if (!is_in_reach(p)) throw CommandError(fmt::format("the shape is too large: it reaches beyond {}", largest_coordinate));
    const std::uint32_t first = scene.mesh.face_limit(), count = shape.face_limit();
    if (scene.mesh.corner_limit() == 0) scene.mesh.replace_with(std::move(shape));
    else scene.mesh.append(shape);
    std::vector<Face> made(count);
    for (std::uint32_t i = 0; i < count; ++i) made[i] = Face(first + i);
    scene.selection.edit().faces = std::move(made);
}

struct SolidSize {
    double size = 1;
};
struct NamedSolid {
    std::string name;
    double size = 1;
};
struct Sides {
    int n = 6;
    double size = 1;
};
struct Grid {
    int nx = 10, ny = 10;
    double size = 1;
};
struct Torus {
    int nu = 24, nv = 12;
    double major = 1, minor = 0.4;
};
struct Sphere {
    int nu = 24, nv = 12;
    double radius = 1;
};
struct Geodesic {
    int frequency = 4;
    double radius = 1;
};

constexpr const char* edge_help = "length of the edges";

void add_platonic(Registry& registry, const std::string& name, const char* help)
{
    registry.add(define<SolidSize>("make." + name, help)
                     .param(&SolidSize::size, "size", Unit::length, above(0), edge_help)
                     .example("make." + name + " size=2")
                     .cites("Coxeter 1973")
                     .run([name](Scene& scene, const SolidSize& p, Context&) { add_to_scene(scene, make_solid(name, p.size)); }));
}

void add_n_sided(Registry& registry, const char* name, const char* help, const char* example, Mesh (*make)(int, double))
{
    registry.add(define<Sides>(name, help)
                     .param(&Sides::n, "n", Unit::count, {3, 10000}, "number of sides")
                     .param(&Sides::size, "size", Unit::length, above(0), edge_help)
                     .example(example)
                     .cites("Coxeter 1973")
                     .run([make](Scene& scene, const Sides& p, Context&) { add_to_scene(scene, make(p.n, p.size)); }));
}

} // namespace

void register_make(Registry& registry)
{
    add_platonic(registry, "tetrahedron", "Add a regular tetrahedron");
    add_platonic(registry, "cube", "Add a cube");
    add_platonic(registry, "octahedron", "Add a regular octahedron");
    add_platonic(registry, "dodecahedron", "Add a regular dodecahedron");
    add_platonic(registry, "icosahedron", "Add a regular icosahedron");
    registry.add(define<NamedSolid>("make.solid", "Add a Platonic, Archimedean or other convex solid with regular faces")
                     .param(&NamedSolid::name, "name", listing(solid_names()))
                     .required()
                     .param(&NamedSolid::size, "size", Unit::length, above(0), edge_help)
                     .example("make.solid name=snub_cube size=2")
                     .cites("Coxeter 1973; Johnson 1966")
                     .run([](Scene& scene, const NamedSolid& p, Context&) { add_to_scene(scene, make_solid(p.name, p.size)); }));
    add_n_sided(registry, "make.prism", "Add a prism of squares between two regular polygons", "make.prism n=5", make_prism);
    add_n_sided(registry, "make.antiprism", "Add two turned regular polygons joined by triangles", "make.antiprism n=5", make_antiprism);
    add_n_sided(registry, "make.polygon", "Add a flat regular polygon with two sides, to extrude from", "make.polygon n=5 size=2", make_polygon);
    registry.add(define<Grid>("make.grid", "Add a rectangle of squares, closed by one face below")
                     .param(&Grid::nx, "nx", Unit::count, {1, 4096}, "squares along x")
                     .param(&Grid::ny, "ny", Unit::count, {1, 4096}, "squares along y")
                     .param(&Grid::size, "size", Unit::length, above(0), edge_help)
                     .example("make.grid nx=8 ny=6")
                     .cites("Druse")
                     .run([](Scene& scene, const Grid& p, Context& context) { add_to_scene(scene, make_grid(p.nx, p.ny, p.size, context.progress)); }));
    registry.add(define<Torus>("make.torus", "Add a torus of quads around the z axis")
                     .param(&Torus::nu, "nu", Unit::count, {3, 4096}, "quads round the axis")
                     .param(&Torus::nv, "nv", Unit::count, {3, 4096}, "quads round the tube")
                     .param(&Torus::major, "major", Unit::length, above(0), "from the axis to the middle of the tube")
                     .param(&Torus::minor, "minor", Unit::length, above(0), "radius of the tube, less than major")
                     .example("make.torus nu=32 nv=16 major=2 minor=0.5")
                     .cites("Druse")
                     .run([](Scene& scene, const Torus& p, Context& context) {
                         if (p.minor >= p.major)
                             throw CommandError(fmt::format("minor={}: expected less than major={}", number_text(p.minor), number_text(p.major)));
                         add_to_scene(scene, make_torus(p.nu, p.nv, p.major, p.minor, context.progress));
                     }));
    registry.add(define<Sphere>("make.sphere", "Add a sphere of meridians and bands, with triangles at the poles")
                     .param(&Sphere::nu, "nu", Unit::count, {3, 4096}, "meridians")
                     .param(&Sphere::nv, "nv", Unit::count, {2, 4096}, "bands from pole to pole")
                     .param(&Sphere::radius, "radius", Unit::length, above(0), "from the centre to the vertices")
                     .example("make.sphere nu=32 nv=16")
                     .cites("Druse")
                     .run([](Scene& scene, const Sphere& p, Context& context) {
                         add_to_scene(scene, make_sphere(p.nu, p.nv, p.radius, context.progress));
                     }));
    registry.add(define<Geodesic>("make.geodesic", "Add a sphere of triangles, the icosahedron's faces cut finer")
                     .param(&Geodesic::frequency, "frequency", Unit::count, {1, 128}, "parts of each edge of the icosahedron")
                     .param(&Geodesic::radius, "radius", Unit::length, above(0), "from the centre to the vertices")
                     .example("make.geodesic frequency=6")
                     .cites("Clinton 1971")
                     .run([](Scene& scene, const Geodesic& p, Context&) { add_to_scene(scene, make_geodesic(p.frequency, p.radius)); }));
}

} // namespace druse
