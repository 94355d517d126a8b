// Every remeshing operator against its connectivity, numbering, groups and positions, written out here a second time from the old mesh,
// on every model; one row a scheme.
#include "remesh_models.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace druse {
namespace {

using namespace test;

/// A new vertex: `v` an old one, `e` on an edge, `s` on a side near its corner, `f` in a face, `c` and `o` in a face by corner.
struct Name {
    char kind;
    Corner at;
};
using Names = std::vector<Name>;

/// The old mesh, from whose corners everything is named.
struct Old : Lists {
    explicit Old(const Mesh& m) : Lists(m) {}

    Corner next(Corner c) const { return mesh.next(c); }
    Corner before(Corner c) const { return mesh.previous(c); }
    Corner over(Corner c) const { return mesh.opposite(c); }
    Name v(Corner c) const { return {'v', c}; }
    Name e(Corner c) const { return {'e', c}; }
    Name s(Corner c) const { return {'s', c}; }
    Name far(Corner c) const { return {'s', over(c)}; } // on the side of c, near its end
    Name f(Corner c) const { return {'f', c}; }
    Name c(Corner c) const { return {'c', c}; }
    Name o(Corner c) const { return {'o', c}; }

    Point at(Corner c) const { return mesh.position(c); }
    Point h(Corner c, double t) const { return (1 - t) * at(c) + t * at(next(c)); }
    Point far(Corner c, double t) const { return (1 - t) * at(next(c)) + t * at(c); }
    Point mid(Corner c) const { return h(c, 0.5); }
    Point center(Corner c) const { return vertex_mean(mesh, mesh.face(c)); }
    Vector normal(Corner c) const { return unit_normal(mesh, mesh.face(c)); }
    Point inner(Corner c, double s, const Point& p) const { return center(c) + s * (p - center(c)); }
    double valence(Corner c) const { return mesh.valence(mesh.vertex(c)); }
    Point neighbours(Corner c) const
    {
        Point sum(0.0);
        for (const Corner d : mesh.around(mesh.vertex(c))) sum += at(next(d)) / valence(c);
        return sum;
    }
    /// Σ_j W(n, i, j; α) p(j) at corner c.
    template <class P>
    Point weighted(Corner c, double alpha, P&& p) const
    {
        const int n = mesh.valence(mesh.face(c));
        Point sum = alpha * p(c);
        Corner d = c;
        for (int j = 1; j < n; ++j) {
            d = next(d);
            sum += (1 - alpha) * (3 + 2 * std::cos(2 * std::numbers::pi * j / n)) / (3 * n - 5) * p(d);
        }
        return sum;
    }
    double honeycomb(Corner c) const { return std::sqrt(0.5) - 0.25 + 1.25 / mesh.valence(mesh.face(c)); }
    Point gyro(Corner c, double t, bool mirror) const
    {
        return (at(c) + center(c) + h(c, t) + far(before(c), t) + (mirror ? far(c, t) : h(before(c), t))) / 5.0;
    }
};

using Part = std::function<Names(const Old&, Corner)>;
using Where = std::function<Point(const Old&, Corner)>;
struct Piece {
    int group;
    Part part;
};
struct Row {
    std::string command;
    std::vector<std::pair<std::string, std::string>> arguments;
    std::array<int, 3> vertices; // V' = aV + bE + cF
    int edges;                   // E' / E
    std::array<int, 3> faces;
    std::vector<Piece> face, corner, edge, side, vertex; // face, edge, vertex: at most one, to which all corners add
    std::map<char, Where> where;                         // of new vertices; else old ones, midpoints, means
    friend std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.command; }
};

const Part inner_face = [](const Old& m, Corner c) { return Names{m.c(c)}; };
const Part doo_sabin_edge = [](const Old& m, Corner c) { return Names{m.c(c), m.c(m.next(m.over(c)))}; };
const Part hexagon = [](const Old& m, Corner c) { return Names{m.v(c), m.c(m.next(m.over(c))), m.c(m.over(c))}; };
const Part middles = [](const Old& m, Corner c) { return Names{m.e(c)}; };
const Part quad = [](const Old& m, Corner c) { return Names{m.v(c), m.e(c), m.f(c), m.e(m.before(c))}; };
const Part corner_triangle = [](const Old& m, Corner c) { return Names{m.v(c), m.e(c), m.e(m.before(c))}; };
const Part needles = [](const Old& m, Corner c) { return Names{m.v(c), m.f(m.over(c)), m.f(c)}; };
const Part wall = [](const Old& m, Corner c) { return Names{m.v(c), m.v(m.next(c)), m.c(c)}; };
const auto shrunk = [](double s) -> Where { return [s](const Old& m, Corner c) { return m.inner(c, s, m.at(c)); }; };
const auto shrunk_middle = [](double s) -> Where { return [s](const Old& m, Corner c) { return m.inner(c, s, m.mid(c)); }; };
const auto cut = [](double t) -> Where { return [t](const Old& m, Corner c) { return m.h(c, t); }; };
const auto relaxed = [](double (*weight)(double)) -> Where {
    return [weight](const Old& m, Corner c) { return m.at(c) + weight(m.valence(c)) * (m.neighbours(c) - m.at(c)); };
};

// clang-format off
const std::vector<Row> rows{
    {"linear", {}, {1, 1, 1}, 4, {0, 2, 0}, {}, {{1, quad}}, {}, {}, {}, {}},
    {"corner_cutting", {{"alpha", "0.7"}}, {0, 2, 0}, 4, {1, 1, 1}, {{1, inner_face}}, {}, {{2, doo_sabin_edge}}, {}, {{3, inner_face}},
     {{'c', [](const Old& m, Corner c) { return m.weighted(c, 0.7, [&](Corner d) { return m.at(d); }); }}}},
    {"expand", {{"s", "0.4"}}, {0, 2, 0}, 4, {1, 1, 1}, {{1, inner_face}}, {}, {{2, doo_sabin_edge}}, {}, {{3, inner_face}}, {{'c', shrunk(0.4)}}},
    {"loop", {}, {1, 1, 0}, 4, {1, 2, 0}, {{1, middles}}, {{2, corner_triangle}}, {}, {}, {},
     {{'v', relaxed([](double m) { return 0.625 - std::pow(0.375 + std::cos(2 * std::numbers::pi / m) / 4, 2); })},
      {'e', [](const Old& m, Corner c) {
           const auto others = [&](Corner d) { // the mean of the corners of its face but the ends of its side
               const double n = m.mesh.valence(m.mesh.face(d));
               return (n * m.center(d) - m.at(d) - m.at(m.next(d))) / (n - 2);
           };
           return 0.375 * (m.at(c) + m.at(m.next(c))) + 0.125 * (others(c) + others(m.over(c)));
       }}}},
    {"subdivide", {}, {1, 1, 0}, 4, {1, 2, 0}, {{1, middles}}, {{2, corner_triangle}}, {}, {}, {}, {}},
    {"truncate", {{"t", "0.3"}}, {0, 2, 0}, 3, {1, 0, 1}, {{1, [](const Old& m, Corner c) { return Names{m.s(c), m.far(c)}; }}}, {}, {}, {},
     {{2, [](const Old& m, Corner c) { return Names{m.s(c)}; }}}, {{'s', cut(0.3)}}},
    {"honeycomb", {}, {0, 2, 0}, 3, {1, 0, 1}, {{1, inner_face}}, {}, {}, {}, {{2, [](const Old& m, Corner c) { return Names{m.c(c), m.c(m.before(c))}; }}},
     {{'c', [](const Old& m, Corner c) { return m.weighted(c, m.honeycomb(c), [&](Corner d) { return m.mid(d); }); }}}},
    {"ambo", {}, {0, 1, 0}, 2, {1, 0, 1}, {{1, middles}}, {}, {}, {}, {{2, middles}}, {}},
    {"bevel", {{"s", "0.7"}, {"t", "0.3"}}, {0, 4, 0}, 6, {1, 1, 1}, {{1, [](const Old& m, Corner c) { return Names{m.c(c), m.o(c)}; }}}, {},
     {{2, [](const Old& m, Corner c) { return Names{m.c(c), m.o(m.over(c))}; }}}, {}, {{3, [](const Old& m, Corner c) { return Names{m.c(c), m.o(m.before(c))}; }}},
     {{'c', [](const Old& m, Corner c) { return m.inner(c, 0.7, m.h(c, 0.3)); }}, {'o', [](const Old& m, Corner c) { return m.inner(c, 0.7, m.far(c, 0.3)); }}}},
    {"pentagonal", {{"t", "0.3"}, {"offset", "0.2"}}, {1, 2, 1}, 5, {0, 2, 0}, {},
     {{1, [](const Old& m, Corner c) { return Names{m.v(c), m.s(c), m.f(c), m.s(m.before(c)), m.far(m.before(c))}; }}}, {}, {}, {},
     {{'s', [](const Old& m, Corner c) { return m.inner(c, 0.8, m.h(c, 0.3)); }}}},
    {"pentagonal", {{"mirror", "true"}, {"offset", "0.2"}, {"t", "0.3"}}, {1, 2, 1}, 5, {0, 2, 0}, {},
     {{1, [](const Old& m, Corner c) { return Names{m.v(c), m.s(c), m.far(c), m.f(c), m.far(m.before(c))}; }}}, {}, {}, {},
     {{'s', [](const Old& m, Corner c) { return m.inner(m.over(c), 0.8, m.h(c, 0.3)); }}}},
    {"pentagon_preserving", {{"s", "0.6"}}, {1, 3, 0}, 6, {1, 2, 0}, {{1, inner_face}},
     {{2, [](const Old& m, Corner c) { return Names{m.v(c), m.e(c), m.c(c), m.c(m.before(c)), m.e(m.before(c))}; }}}, {}, {}, {}, {{'c', shrunk_middle(0.6)}}},
    {"snub", {{"t", "0.25"}}, {0, 2, 0}, 5, {1, 2, 1}, {{1, inner_face}}, {}, {},
     {{2, [](const Old& m, Corner c) { return Names{m.c(m.next(c)), m.c(c), m.c(m.next(m.over(c)))}; }}}, {{3, inner_face}},
     {{'c', [](const Old& m, Corner c) { return m.gyro(c, 0.25, false); }}}},
    {"snub", {{"t", "0.25"}, {"mirror", "true"}}, {0, 2, 0}, 5, {1, 2, 1}, {{1, inner_face}}, {}, {},
     {{2, [](const Old& m, Corner c) { return Names{m.c(c), m.c(m.over(c)), m.c(m.next(c))}; }}}, {{3, inner_face}},
     {{'c', [](const Old& m, Corner c) { return m.gyro(c, 0.25, true); }}}},
    {"sqrt3", {}, {1, 0, 1}, 3, {0, 2, 0}, {}, {}, {}, {{1, needles}}, {}, {{'v', relaxed([](double m) { return (4 - 2 * std::cos(2 * std::numbers::pi / m)) / 9; })}}},
    {"sqrt3", {{"smooth", "false"}}, {1, 0, 1}, 3, {0, 2, 0}, {}, {}, {}, {{1, needles}}, {}, {}},
    {"needle", {}, {1, 0, 1}, 3, {0, 2, 0}, {}, {}, {}, {{1, needles}}, {}, {}},
    {"root4", {{"weight", "0.4"}, {"twist", "0.2"}}, {1, 2, 0}, 4, {1, 1, 0}, {{1, inner_face}}, {}, {{2, hexagon}}, {}, {},
     {{'c', [](const Old& m, Corner c) { return m.weighted(c, m.honeycomb(c), [&](Corner d) { return m.h(d, 0.2); }); }},
      {'v', [](const Old& m, Corner c) {
           Point sum(0.0);
           for (const Corner d : m.mesh.around(m.mesh.vertex(c))) sum += m.weighted(d, m.honeycomb(d), [&](Corner x) { return m.h(x, 0.2); }) / m.valence(c);
           return 0.6 * m.at(c) + 0.4 * sum;
       }}}},
    {"chamfer", {{"s", "0.6"}}, {1, 2, 0}, 4, {1, 1, 0}, {{1, inner_face}}, {}, {{2, hexagon}}, {}, {}, {{'c', shrunk(0.6)}}},
    {"dual", {}, {0, 0, 1}, 1, {0, 0, 1}, {}, {}, {}, {}, {{1, [](const Old& m, Corner c) { return Names{m.f(c)}; }}}, {}},
    {"join", {}, {1, 0, 1}, 2, {0, 1, 0}, {}, {}, {{1, [](const Old& m, Corner c) { return Names{m.v(c), m.f(m.over(c))}; }}}, {}, {}, {}},
    {"stellate", {{"height", "0.25"}}, {1, 0, 1}, 3, {0, 2, 0}, {}, {{1, [](const Old& m, Corner c) { return Names{m.v(c), m.v(m.next(c)), m.f(c)}; }}}, {}, {}, {},
     {{'f', [](const Old& m, Corner c) { return m.center(c) + 0.25 * m.normal(c); }}}},
    {"star", {{"offset", "0.2"}}, {1, 2, 1}, 9, {0, 6, 0}, {},
     {{1, wall}, {2, [](const Old& m, Corner c) { return Names{m.v(m.next(c)), m.f(c), m.c(c)}; }}, {2, [](const Old& m, Corner c) { return Names{m.v(c), m.c(c), m.f(c)}; }}},
     {}, {}, {},
     {{'c', [](const Old& m, Corner c) { return (m.at(c) + m.at(m.next(c)) + m.center(c)) / 3.0; }},
      {'f', [](const Old& m, Corner c) { return m.center(c) + 0.2 * m.normal(c); }}}},
    {"meta", {}, {1, 1, 1}, 6, {0, 4, 0}, {},
     {{1, [](const Old& m, Corner c) { return Names{m.v(c), m.e(c), m.f(c)}; }}, {2, [](const Old& m, Corner c) { return Names{m.v(m.next(c)), m.f(c), m.e(c)}; }}}, {}, {}, {}, {}},
    {"propeller", {{"t", "0.3"}}, {1, 2, 0}, 5, {1, 2, 0}, {{1, [](const Old& m, Corner c) { return Names{m.s(c)}; }}},
     {{2, [](const Old& m, Corner c) { return Names{m.v(c), m.s(c), m.s(m.before(c)), m.far(m.before(c))}; }}}, {}, {}, {}, {{'s', cut(0.3)}}},
    {"propeller", {{"t", "0.3"}, {"mirror", "true"}}, {1, 2, 0}, 5, {1, 2, 0}, {{1, [](const Old& m, Corner c) { return Names{m.far(m.before(c))}; }}},
     {{2, [](const Old& m, Corner c) { return Names{m.v(c), m.s(c), m.far(c), m.far(m.before(c))}; }}}, {}, {}, {}, {{'s', cut(0.3)}}},
    {"whirl", {{"t", "0.3"}, {"s", "0.7"}}, {1, 4, 0}, 7, {1, 2, 0}, {{1, inner_face}},
     {{2, [](const Old& m, Corner c) { return Names{m.v(c), m.s(c), m.c(c), m.c(m.before(c)), m.s(m.before(c)), m.far(m.before(c))}; }}}, {}, {}, {},
     {{'s', cut(0.3)}, {'c', [](const Old& m, Corner c) { return m.inner(c, 0.7, m.h(c, 0.3)); }}}},
    {"whirl", {{"t", "0.3"}, {"s", "0.7"}, {"mirror", "true"}}, {1, 4, 0}, 7, {1, 2, 0}, {{1, inner_face}},
     {{2, [](const Old& m, Corner c) { return Names{m.v(c), m.s(c), m.far(c), m.c(m.next(c)), m.c(c), m.far(m.before(c))}; }}}, {}, {}, {},
     {{'s', cut(0.3)}, {'c', [](const Old& m, Corner c) { return m.inner(c, 0.7, m.far(m.before(c), 0.3)); }}}},
    {"loft", {{"s", "0.4"}}, {1, 2, 0}, 5, {1, 2, 0}, {{1, inner_face}},
     {{2, [](const Old& m, Corner c) { return Names{m.v(c), m.v(m.next(c)), m.c(m.next(c)), m.c(c)}; }}}, {}, {}, {}, {{'c', shrunk(0.4)}}},
    {"lace", {{"s", "0.4"}}, {1, 2, 0}, 7, {1, 4, 0}, {{1, inner_face}},
     {{2, wall}, {3, [](const Old& m, Corner c) { return Names{m.v(c), m.c(c), m.c(m.before(c))}; }}}, {}, {}, {}, {{'c', shrunk_middle(0.4)}}},
    {"stake", {{"s", "0.4"}}, {1, 2, 1}, 7, {0, 4, 0}, {},
     {{1, [](const Old& m, Corner c) { return Names{m.v(c), m.c(c), m.f(c), m.c(m.before(c))}; }}, {2, wall}}, {}, {}, {}, {{'c', shrunk_middle(0.4)}}},
};
// clang-format on

/// The new mesh as the row says.
struct Expected {
    Rings rings;
    std::vector<int> groups;
    std::vector<Point> points;

    Expected(const Row& row, const Old& old)
    {
        std::map<char, std::uint32_t> first;
        const auto use = [&](const std::vector<Piece>& pieces) {
            for (const Piece& p : pieces)
                for (const Name& n : p.part(old, old.mesh.corner(Face(0)))) first[n.kind] = 0;
        };
        for (const auto* pieces : {&row.face, &row.corner, &row.edge, &row.side, &row.vertex}) use(*pieces);
        const std::map<char, std::uint32_t> counts{{'v', old.V}, {'e', old.E}, {'s', 2 * old.E}, {'f', old.F}, {'c', 2 * old.E}, {'o', 2 * old.E}};
        std::uint32_t count = 0;
        for (const char kind : std::string("vesfco"))
            if (first.contains(kind)) {
                first[kind] = count;
                count += counts.at(kind);
            }
        points.resize(count);

        const auto id = [&](const Name& n) {
            const Corner c = n.at;
            const std::uint32_t own = n.kind == 'v' ? old.Lists::v(c) : n.kind == 'e' ? old.Lists::e(c) : n.kind == 's' ? 2 * old.Lists::e(c) + old.Lists::s(c)
                                      : n.kind == 'f' ? old.Lists::f(c) : old.k(c);
            return first.at(n.kind) + own;
        };
        const auto add = [&](const std::vector<Piece>& pieces, const std::vector<Corner>& corners) {
            for (const Piece& p : pieces) {
                Ring ring;
                for (const Corner c : corners)
                    for (const Name& n : p.part(old, c)) ring.push_back(id(n));
                rings.push_back(ring);
                groups.push_back(p.group);
            }
        };
        for (const Face f : old.mesh.faces()) {
            std::vector<Corner> corners;
            for (const Corner c : old.mesh.corners(f)) corners.push_back(c);
            add(row.face, corners);
            for (const Corner c : corners) add(row.corner, {c});
        }
        for (const Edge e : old.mesh.edges()) {
            const Corner a = old.mesh.corner(e, 0), b = old.mesh.corner(e, 1);
            add(row.edge, {a, b});
            add(row.side, {a});
            add(row.side, {b});
        }
        for (const Vertex v : old.mesh.vertices()) add(row.vertex, old.around(v));

        for (const Face f : old.mesh.faces())
            for (const Corner c : old.mesh.corners(f))
                for (const auto& [kind, start] : first) {
                    Point p = kind == 'v' ? old.at(c) : kind == 'e' ? old.mid(c) : old.center(c);
                    if (row.where.contains(kind)) p = row.where.at(kind)(old, c);
                    points[id({kind, c})] = p;
                }
    }
};

class EveryRow : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Remesh, EveryRow, testing::ValuesIn(rows), [](const auto& given) { return given.param.command + std::to_string(given.index); });

TEST_P(EveryRow, IsMadeOfEveryModelAsTheSourceSays)
{
    const Row& row = GetParam();
    for (const Input& input : remeshed_models) {
        SCOPED_TRACE(input.name);
        const Mesh model = input.make(), mesh = made_of(model, "remesh." + row.command, row.arguments);
        const Old old(model);
        const auto count = [&](const std::array<int, 3>& k, std::uint32_t last) { return std::uint32_t(k[0]) * (&k == &row.vertices ? old.V : old.F) + std::uint32_t(k[1]) * old.E + std::uint32_t(k[2]) * last; };
        EXPECT_EQ(counts(mesh), (Counts{count(row.vertices, old.F), std::uint32_t(row.edges) * old.E, count(row.faces, old.V)}));
        expect_kind_kept(model, mesh);
        // The dual of the cube whose lid and floor are one face has five vertices in a plane.
        if (row.command != "dual" || input.make != cube_with_edge_handle) {
            EXPECT_GT(volume(mesh), 0.0);
        }
        const Expected expected(row, old);
        EXPECT_EQ(rings(mesh), expected.rings);
        EXPECT_EQ(groups(mesh), expected.groups);
        ASSERT_EQ(mesh.vertex_count(), expected.points.size());
        for (const Vertex v : mesh.vertices()) ASSERT_LT(glm::distance(mesh.position(v), expected.points[v.index]), 1e-12) << "vertex " << v.index;
    }
}

TEST_P(EveryRow, KeepsGroupsOrLeavesThemOut)
{
    // Every face of the model is a group of its own, so the group kept tells which face a new one comes from.
    const Row& row = GetParam();
    Mesh model = edited_torus();
    for (const Face f : model.faces()) model.set_group(f, 1 + int(f.index));
    std::vector<int> expected;
    for (const Face f : model.faces()) expected.insert(expected.end(), row.face.size() + row.corner.size() * std::size_t(model.valence(f)), model.group(f));
    for (const Edge e : model.edges()) expected.insert(expected.end(), row.edge.size() + 2 * row.side.size(), std::min(model.group(model.faces(e)[0]), model.group(model.faces(e)[1])));
    for (const Vertex v : model.vertices()) {
        int lowest = 1 << 30;
        for (const Corner c : model.around(v)) lowest = std::min(lowest, model.group(model.face(c)));
        expected.insert(expected.end(), row.vertex.size(), lowest);
    }
    auto arguments = row.arguments;
    arguments.emplace_back("groups", "keep");
    EXPECT_EQ(groups(made_of(model, "remesh." + row.command, arguments)), expected);
    arguments.back().second = "none";
    EXPECT_EQ(groups(made_of(model, "remesh." + row.command, arguments)), std::vector<int>(expected.size(), 0));
}

} // namespace
} // namespace druse
