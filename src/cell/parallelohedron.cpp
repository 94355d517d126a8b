#include "cell/parallelohedron.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace druse {

namespace {

constexpr double same_place = 1e-9; // of solids that are a few units wide

/// The corners of a solid and its lattice; what else there is follows.
struct CellTable {
    std::vector<Point> vertices;
    std::array<Vector, 3> lattice;
    double width = 1; // along x
};

/// All that a coordinate's signs make of a place, each once.
void add_signs(std::vector<Point>& list, const Point& p)
{
    for (const double x : {1.0, -1.0})
        for (const double y : {1.0, -1.0})
            for (const double z : {1.0, -1.0}) {
                const Point q(x * p.x, y * p.y, z * p.z);
                if (std::ranges::find(list, q) == list.end()) list.push_back(q);
            }
}

CellTable table_of(CellKind kind)
{
    CellTable t;
    switch (kind) {
    case CellKind::bcc:
        for (const Point& p : {Point(0, 1, 2), Point(1, 2, 0), Point(2, 0, 1), Point(0, 2, 1), Point(2, 1, 0), Point(1, 0, 2)}) add_signs(t.vertices, p);
        t.lattice = {Vector(-2, 2, 2), Vector(2, -2, 2), Vector(2, 2, -2)};
        t.width = 4;
        break;
    case CellKind::fcc:
        for (const Point& p : {Point(1, 1, 1), Point(2, 0, 0), Point(0, 2, 0), Point(0, 0, 2)}) add_signs(t.vertices, p);
        t.lattice = {Vector(0, 2, 2), Vector(2, 0, 2), Vector(2, 2, 0)};
        t.width = 4;
        break;
    case CellKind::cube:
        add_signs(t.vertices, Point(0.5));
        t.lattice = {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
        break;
    case CellKind::hexprism: {
        const double root = std::sqrt(3.0);
        for (const Point& p : {Point(0.5, root / 6, 0.5), Point(0, root / 3, 0.5)}) add_signs(t.vertices, p);
        t.lattice = {Vector(1, 0, 0), Vector(0.5, root / 2, 0), Vector(0, 0, 1)};
        break;
    }
    case CellKind::elongated: // the rhombic dodecahedron, cut at its equator and drawn apart
        for (const Point& p : {Point(1, 1, 2), Point(0, 0, 3), Point(2, 0, 1), Point(0, 2, 1)}) add_signs(t.vertices, p);
        t.lattice = {Vector(2, 2, 0), Vector(2, -2, 0), Vector(2, 0, 4)};
        t.width = 4;
        break;
    }
    return t;
}

/// Whether the first coordinate that is not 0 is positive.
bool is_near(const Vector& v)
{
    for (int k = 0; k < 3; ++k)
        if (std::abs(v[k]) > same_place) return v[k] > 0;
    return false;
}

/// A pane around its centre: axes, and its vertices in their order.
struct FlatFace {
    CellPane pane;
    std::vector<Point> ring;
};

FlatFace face_of(const LatticeStep& translation, const Point& centre, std::vector<Point> ring)
{
    FlatFace face;
    CellPane& pane = face.pane;
    pane.translation = translation;
    pane.both[1] = -translation;
    pane.centre = centre;
    for (const Point& p : ring) // two corners may be opposite each other
        if (const Vector n = glm::cross(ring.front() - centre, p - centre); glm::length(n) > same_place) pane.normal = unit(n);
    if (glm::dot(pane.normal, centre) < 0) pane.normal = -pane.normal;
    const bool level = std::abs(pane.normal.z) > 1 - same_place;
    pane.up = level ? Vector(0, 1, 0) : unit(Vector(0, 0, 1) - pane.normal.z * pane.normal);
    pane.right = glm::cross(pane.up, pane.normal);
    const auto angle = [&](const Point& p) {
        const double a = std::atan2(glm::dot(p - centre, pane.up), glm::dot(p - centre, pane.right));
        return a < -same_place ? a + 2 * std::numbers::pi : a;
    };
    std::ranges::sort(ring, {}, angle);
    face.ring = std::move(ring);
    return face;
}

/// Two panes of a pair lie where the solid and its translate meet: there are their vertices.
std::vector<FlatFace> faces_of(const CellTable& t)
{
    std::map<LatticeStep, std::vector<Point>> common;
    for (const Point& p : t.vertices)
        for (const Point& q : t.vertices)
            if (const auto step = step_of(t.lattice, p - q); step && is_near(p - q)) common[*step].push_back(p);
    std::vector<FlatFace> faces;
    for (auto& [step, ring] : common) {
        if (ring.size() < 3) continue; // an edge or a corner
        const Vector translation = double(step.i) * t.lattice[0] + double(step.j) * t.lattice[1] + double(step.k) * t.lattice[2];
        faces.push_back(face_of(step, 0.5 * translation, std::move(ring)));
    }
    const auto key = [](const FlatFace& f) { return std::tuple(-f.pane.centre.x, -f.pane.centre.y, -f.pane.centre.z); };
    std::ranges::sort(faces, {}, key);
    return faces;
}

void add_member(std::vector<LatticeStep>& list, const LatticeStep& step)
{
    if (std::ranges::find(list, step) == list.end()) list.push_back(step);
}

/// Gives corners and sides their orbits, in the order in which the panes meet them.
Parallelohedron with_orbits(const CellTable& t, std::vector<FlatFace> faces)
{
    Parallelohedron cell;
    cell.lattice = t.lattice;
    for (FlatFace& face : faces) {
        CellPane& pane = face.pane;
        for (const Point& p : face.ring) {
            OrbitMember found{-1, {}};
            for (std::size_t c = 0; c < cell.corners.size() && found.orbit < 0; ++c)
                if (const auto step = step_of(t.lattice, p - cell.corners[c].place)) found = {static_cast<int>(c), *step};
            if (found.orbit < 0) {
                found.orbit = static_cast<int>(cell.corners.size());
                cell.corners.push_back({p, {}});
            }
            pane.corners.push_back(found);
            pane.outline.emplace_back(glm::dot(p - pane.centre, pane.right), glm::dot(p - pane.centre, pane.up));
        }
        for (std::size_t k = 0; k < pane.corners.size(); ++k) {
            const OrbitMember from = pane.corners[k], to = pane.corners[(k + 1) % pane.corners.size()];
            CellSide side{{-1, {}}, false};
            for (std::size_t e = 0; e < cell.edges.size() && side.edge.orbit < 0; ++e) {
                const auto is = [&](const OrbitMember& first, const OrbitMember& last) {
                    return from.orbit == first.orbit && to.orbit == last.orbit && from.shift - first.shift == to.shift - last.shift;
                };
                const Parallelohedron::Edge& edge = cell.edges[e];
                if (is(edge.from, edge.to)) side = {{static_cast<int>(e), from.shift - edge.from.shift}, false};
                else if (is(edge.to, edge.from)) side = {{static_cast<int>(e), from.shift - edge.to.shift}, true};
            }
            if (side.edge.orbit < 0) {
                side.edge.orbit = static_cast<int>(cell.edges.size());
                cell.edges.push_back({from, to, {}});
            }
            pane.sides.push_back(side);
        }
        cell.panes.push_back(pane);
    }
    for (const bool far : {false, true})
        for (const CellPane& pane : cell.panes) {
            const LatticeStep back = far ? -pane.translation : LatticeStep{};
            for (const OrbitMember& c : pane.corners) add_member(cell.corners[static_cast<std::size_t>(c.orbit)].members, c.shift + back);
            for (const CellSide& s : pane.sides) add_member(cell.edges[static_cast<std::size_t>(s.edge.orbit)].members, s.edge.shift + back);
        }
    return cell;
}

} // namespace

const char* name(CellKind kind)
{
    constexpr std::array names{"bcc", "fcc", "cube", "hexprism", "elongated"};
    return names[static_cast<std::size_t>(kind)];
}

std::optional<LatticeStep> step_of(const std::array<Vector, 3>& lattice, const Vector& v)
{
    const std::array<Vector, 3> dual{glm::cross(lattice[1], lattice[2]), glm::cross(lattice[2], lattice[0]), glm::cross(lattice[0], lattice[1])};
    const double volume = glm::dot(lattice[0], dual[0]);
    std::array<int, 3> step{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double c = glm::dot(v, dual[k]) / volume;
        if (!(std::abs(c - std::round(c)) <= same_place)) return {};
        step[k] = static_cast<int>(std::round(c));
    }
    return LatticeStep{step[0], step[1], step[2]};
}

double Parallelohedron::volume() const { return std::abs(glm::dot(lattice[0], glm::cross(lattice[1], lattice[2]))); }

Parallelohedron make_parallelohedron(CellKind kind, double size, double height)
{
    const CellTable table = table_of(kind);
    Parallelohedron cell = with_orbits(table, faces_of(table));
    cell.kind = kind;
    // Which panes and orbits there are does not depend on the size. Only an upright prism is as high as one likes, so axes keep their directions.
    Vector scale(size / table.width);
    if (kind == CellKind::hexprism) scale.z = height;
    for (Vector& v : cell.lattice) v *= scale;
    for (Parallelohedron::Corner& c : cell.corners) c.place *= scale;
    for (CellPane& pane : cell.panes) {
        pane.centre *= scale;
        for (std::size_t k = 0; k < pane.corners.size(); ++k) {
            const Vector from_centre = cell.corner(pane.corners[k]) - pane.centre;
            pane.outline[k] = {glm::dot(from_centre, pane.right), glm::dot(from_centre, pane.up)};
        }
    }
    return cell;
}

} // namespace druse
