#include "support/shapes.h"

#include "dlfl/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace druse::test {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double phi = std::numbers::phi;
using Ids = std::vector<std::uint32_t>;

std::uint32_t id(int i) { return static_cast<std::uint32_t>(i); }

/// Corners of a regular n-gon with edges of length 1, counter-clockwise seen from above.
std::vector<Point> regular_polygon(int n, double z)
{
    const double radius = 0.5 / std::sin(pi / n);
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) points.emplace_back(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), z);
    return points;
}

Ids count_up(int from, int n)
{
    Ids ids;
    for (int i = 0; i < n; ++i) ids.push_back(id(from + i));
    return ids;
}

Ids count_down(int from, int n)
{
    Ids ids{id(from)}; // the lowest comes first here too
    for (int i = n - 1; i > 0; --i) ids.push_back(id(from + i));
    return ids;
}

/// The convex solid with the given vertices, scaled, whose faces look along `normals`; each face starts at its lowest vertex.
Mesh convex(const std::vector<Point>& points, const std::vector<Vector>& normals, double scale)
{
    MeshBuilder builder;
    for (const Point& p : points) builder.add_vertex(scale * p);
    for (const Vector& direction : normals) {
        const Vector n = unit(direction);
        double reach = 0;
        for (const Point& p : points) reach = std::max(reach, glm::dot(n, p));
        Ids face;
        for (std::uint32_t i = 0; i < points.size(); ++i)
            if (glm::dot(n, points[i]) > reach - 1e-6) face.push_back(i);
        const Vector x = unit(points[face[0]] - reach * n), y = glm::cross(n, x);
        const auto angle = [&](std::uint32_t i) {
            const double a = std::atan2(glm::dot(points[i], y), glm::dot(points[i], x));
            return a < -1e-6 ? a + 2 * pi : a;
        };
        std::sort(face.begin(), face.end(), [&](std::uint32_t a, std::uint32_t b) { return angle(a) < angle(b); });
        builder.add_face(face);
    }
    return builder.build();
}

const std::vector<Point> cube_points{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
const std::vector<Point> axes{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};

std::vector<Point> icosahedron_points()
{
    std::vector<Point> points;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-phi, phi}) {
            points.emplace_back(0, a, b);
            points.emplace_back(a, b, 0);
            points.emplace_back(b, 0, a);
        }
    return points;
}

std::vector<Point> dodecahedron_points()
{
    std::vector<Point> points = cube_points;
    for (const double a : {-1 / phi, 1 / phi})
        for (const double b : {-phi, phi}) {
            points.emplace_back(0, b, a); // its edges lie across those of the icosahedron above
            points.emplace_back(b, a, 0);
            points.emplace_back(a, 0, b);
        }
    return points;
}

Mesh cube_with_corner(const Point& corner)
{
    Mesh mesh = cube();
    mesh.set_position(Vertex(6), corner);
    return mesh;
}

void move(Mesh& mesh, const Vector& by)
{
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + by);
}

} // namespace

Mesh dihedron(int n)
{
    MeshBuilder builder;
    for (const Point& p : regular_polygon(n, 0)) builder.add_vertex(p);
    builder.add_face(count_up(0, n));
    builder.add_face(count_down(0, n));
    return builder.build();
}

Mesh tetrahedron()
{
    const std::vector<Point> points{{-1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
    std::vector<Vector> opposite;
    for (const Point& p : points) opposite.push_back(-p);
    return convex(points, opposite, 1 / std::sqrt(8.0));
}
Mesh cube() { return convex(cube_points, axes, 0.5); }
Mesh octahedron() { return convex(axes, cube_points, 1 / std::sqrt(2.0)); }
Mesh dodecahedron() { return convex(dodecahedron_points(), icosahedron_points(), phi / 2); }
Mesh icosahedron() { return convex(icosahedron_points(), dodecahedron_points(), 0.5); }

Mesh prism(int n)
{
    MeshBuilder builder;
    for (const double z : {-0.5, 0.5})
        for (const Point& p : regular_polygon(n, z)) builder.add_vertex(p);
    builder.add_face(count_down(0, n));
    for (int i = 0; i < n; ++i) builder.add_face(Ids{id(i), id((i + 1) % n), id(n + (i + 1) % n), id(n + i)});
    builder.add_face(count_up(n, n));
    return builder.build();
}

Mesh pyramid(int n)
{
    MeshBuilder builder;
    for (const Point& p : regular_polygon(n, 0)) builder.add_vertex(p);
    const std::uint32_t apex = builder.add_vertex(Point(0, 0, 1));
    builder.add_face(count_down(0, n));
    for (int i = 0; i < n; ++i) builder.add_face(Ids{id(i), id((i + 1) % n), apex});
    return builder.build();
}

Mesh torus(int nu, int nv)
{
    MeshBuilder builder;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
            const double u = 2 * pi * i / nu, v = 2 * pi * j / nv, r = 1 + 0.4 * std::cos(v);
            builder.add_vertex(Point(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)));
        }
    const auto at = [=](int i, int j) { return id((i % nu) * nv + j % nv); };
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) builder.add_face(Ids{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return builder.build();
}

namespace {

/// The squares of a grid, and its border, counter-clockwise seen from above.
Ids add_squares(MeshBuilder& builder, int nx, int ny)
{
    const std::uint32_t first = builder.vertex_count();
    for (int y = 0; y <= ny; ++y)
        for (int x = 0; x <= nx; ++x) builder.add_vertex(Point(x, y, 0));
    const auto at = [=](int x, int y) { return first + id(y * (nx + 1) + x); };
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) builder.add_face(Ids{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    Ids border;
    for (int x = 0; x < nx; ++x) border.push_back(at(x, 0));
    for (int y = 0; y < ny; ++y) border.push_back(at(nx, y));
    for (int x = nx; x > 0; --x) border.push_back(at(x, ny));
    for (int y = ny; y > 0; --y) border.push_back(at(0, y));
    return border;
}

} // namespace

Mesh grid(int nx, int ny)
{
    MeshBuilder builder;
    Ids border = add_squares(builder, nx, ny);
    std::reverse(border.begin() + 1, border.end());
    builder.add_face(border);
    return builder.build();
}

Mesh open_grid(int nx, int ny)
{
    MeshBuilder builder;
    add_squares(builder, nx, ny);
    Repairs repairs;
    return builder.build(repairs);
}

Mesh open_tube(int n)
{
    MeshBuilder builder;
    for (const double z : {-0.5, 0.5})
        for (const Point& p : regular_polygon(n, z)) builder.add_vertex(p);
    for (int i = 0; i < n; ++i) builder.add_face(Ids{id(i), id((i + 1) % n), id(n + (i + 1) % n), id(n + i)});
    Repairs repairs;
    return builder.build(repairs);
}

Mesh l_prism()
{
    MeshBuilder builder;
    for (const double z : {0.0, 1.0})
        for (const Point2& p : {Point2(0, 0), Point2(2, 0), Point2(2, 1), Point2(1, 1), Point2(1, 2), Point2(0, 2)})
            builder.add_vertex(Point(p.x, p.y, z));
    builder.add_face(count_down(0, 6));
    for (int i = 0; i < 6; ++i) builder.add_face(Ids{id(i), id((i + 1) % 6), id(6 + (i + 1) % 6), id(6 + i)});
    builder.add_face(count_up(6, 6));
    return builder.build();
}

Mesh warped_cube() { return cube_with_corner({0.9, 0.8, 0.7}); }
Mesh dented_cube() { return cube_with_corner({-0.2, -0.1, -0.15}); }

Mesh voxels(const std::vector<std::array<int, 3>>& cells)
{
    const std::set<std::array<int, 3>> solid(cells.begin(), cells.end());
    std::map<std::array<int, 3>, std::uint32_t> vertex_at;
    MeshBuilder builder;
    const Mesh unit_cube = cube();
    for (const auto& cell : solid)
        for (const Face f : unit_cube.faces()) {
            std::array<int, 3> beyond = cell;
            for (std::size_t k = 0; k < 3; ++k) beyond[k] += int(axes[f.index][int(k)]);
            if (solid.contains(beyond)) continue;
            for (const Corner c : unit_cube.corners(f)) {
                std::array<int, 3> at = cell;
                for (std::size_t k = 0; k < 3; ++k) at[k] += unit_cube.position(c)[int(k)] > 0 ? 1 : 0;
                const auto [it, made] = vertex_at.try_emplace(at, builder.vertex_count());
                if (made) builder.add_vertex(Point(at[0], at[1], at[2]));
                builder.add_corner(it->second);
            }
            builder.end_face();
        }
    return builder.build();
}

Mesh block_with_holes(int genus)
{
    std::vector<std::array<int, 3>> cells;
    for (int x = 0; x < 2 * genus + 1; ++x)
        for (int y = 0; y < 3; ++y)
            if (y != 1 || x % 2 == 0) cells.push_back({x, y, 0});
    return voxels(cells);
}

Mesh two_cubes()
{
    Mesh mesh = cube(), other = cube();
    move(other, {2, 0, 0});
    mesh.append(other);
    return mesh;
}

Mesh cube_with_antenna()
{
    Mesh mesh = cube();
    const Vertex tip = mesh.create_vertex(Point(-0.5, -0.5, -1.5));
    mesh.insert_edge(mesh.corner(Face(0)), mesh.corner(tip));
    mesh.compact();
    return mesh;
}

Mesh tethered_cubes()
{
    Mesh mesh = two_cubes();
    mesh.insert_edge(mesh.corner(Face(2)), mesh.corner(Face(6 + 4))); // +x of the first, −x of the second
    mesh.compact();
    return mesh;
}

Mesh cube_with_parallel_edges()
{
    Mesh mesh = cube();
    const Corner c = mesh.corner(Edge(0), 0);
    mesh.insert_edge(c, mesh.next(c));
    return mesh;
}

Mesh cube_with_edge_handle()
{
    Mesh mesh = cube();
    mesh.insert_edge(mesh.corner(Face(0)), mesh.corner(Face(5), 2)); // along a space diagonal
    mesh.compact();
    return mesh;
}

Mesh cube_with_loop()
{
    Mesh mesh = cube_with_antenna();
    // The base of the antenna has two corners in face 0: an edge between them turns the antenna's side into a face of its own.
    const Vertex tip(8);
    const Corner at_tip = mesh.corner(tip), in = mesh.next(at_tip);
    mesh.insert_edge(in, mesh.previous(at_tip));
    mesh.delete_edge(mesh.edge(at_tip), true);
    mesh.compact();
    return mesh;
}

Mesh segment()
{
    Mesh mesh;
    const Vertex a = mesh.create_vertex(Point(0, 0, 0)), b = mesh.create_vertex(Point(1, 0, 0));
    mesh.insert_edge(mesh.corner(a), mesh.corner(b));
    mesh.compact();
    return mesh;
}

Mesh three_lunes()
{
    Mesh mesh = segment();
    for (int i = 0; i < 2; ++i) mesh.insert_edge(mesh.corner(Face(0)), mesh.next(mesh.corner(Face(0))));
    return mesh;
}

Mesh point_sphere()
{
    Mesh mesh;
    mesh.create_vertex(Point(0, 0, 0));
    return mesh;
}

Mesh mixed()
{
    Mesh mesh = prism(5);
    double x = 0;
    for (Mesh part : {torus(6, 4), open_grid(2, 3), cube_with_antenna(), point_sphere()}) {
        move(part, {x += 4, 0, 0});
        mesh.append(part);
    }
    for (const Face f : mesh.faces()) mesh.set_group(f, int(f.index % 4));
    return mesh;
}

const std::vector<NamedShape>& all_shapes()
{
    static const std::vector<NamedShape> shapes{
        {"Triangle", [] { return dihedron(3); }},
        {"Pentagon", [] { return dihedron(5); }},
        {"TwentyGon", [] { return dihedron(20); }},
        {"Tetrahedron", tetrahedron},
        {"Cube", cube},
        {"Octahedron", octahedron},
        {"Dodecahedron", dodecahedron},
        {"Icosahedron", icosahedron},
        {"HexagonalPrism", [] { return prism(6); }},
        {"Pyramid", [] { return pyramid(7); }},
        {"Torus", [] { return torus(8, 6); }},
        {"Grid", [] { return grid(4, 3); }},
        {"LPrism", l_prism},
        {"WarpedCube", warped_cube},
        {"DentedCube", dented_cube},
        {"GenusTwoBlock", [] { return block_with_holes(2); }},
        {"GenusFiveBlock", [] { return block_with_holes(5); }},
        {"TwoCubes", two_cubes},
        {"CubeWithAntenna", cube_with_antenna},
        {"TetheredCubes", tethered_cubes},
        {"CubeWithParallelEdges", cube_with_parallel_edges},
        {"CubeWithEdgeHandle", cube_with_edge_handle},
        {"CubeWithLoop", cube_with_loop},
        {"Segment", segment},
        {"ThreeLunes", three_lunes},
        {"PointSphere", point_sphere},
        {"OpenGrid", [] { return open_grid(3, 2); }},
        {"OpenTube", [] { return open_tube(5); }},
        {"Mixed", mixed},
        {"Nothing", [] { return Mesh(); }},
    };
    return shapes;
}

} // namespace druse::test
