#include "cell/cell_solid.h"

#include "geom/least_squares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace druse {

namespace {

Vector triangle_normal(const CellSolid& solid, const std::array<std::uint32_t, 3>& t)
{
    const Point &a = solid.points[t[0]], &b = solid.points[t[1]], &c = solid.points[t[2]];
    return direction(glm::cross(b - a, c - a));
}

double angle_between(const Vector& u, const Vector& v) { return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)); }

void inset(CellSolid& solid, double clearance)
{
    constexpr double least = 1e-4; // directions in which the planes of a vertex hardly differ are none to go
    const double depth = 0.5 * clearance, farthest = 4 * clearance;
    struct Planes {
        Symmetric3 squares;
        Vector sum{0.0};
    };
    std::vector<Planes> at(solid.points.size());
    std::vector<Vector> normals;
    for (const auto& t : solid.triangles) {
        const Vector n = normals.emplace_back(triangle_normal(solid, t));
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& p = solid.points[t[k]];
            const double weight = angle_between(solid.points[t[(k + 1) % 3]] - p, solid.points[t[(k + 2) % 3]] - p);
            at[t[k]].squares.add_square(std::sqrt(weight) * n);
            at[t[k]].sum -= weight * depth * n;
        }
    }
    std::vector<Vector> move(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) move[i] = least_squares(at[i].squares, at[i].sum, least);
    std::vector<double> deep(at.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (normals[i] != Vector(0.0))
            for (const std::uint32_t v : solid.triangles[i]) deep[v] = std::min(deep[v], -glm::dot(move[v], normals[i]));
    for (std::size_t i = 0; i < move.size(); ++i) {
        if (deep[i] > 0 && deep[i] < depth) move[i] *= depth / deep[i];
        if (const double length = glm::length(move[i]); length > farthest) move[i] *= farthest / length;
        solid.points[i] += move[i];
    }
}

CellRefusal nothing_left(double clearance) { return {CellRefusal::Reason::vanishes, fmt::format("clearance {} leaves nothing of the cell", clearance)}; }

/// Whether a solid that was moved inside came out on the other side. One that went through itself along one axis or three is inside out; along two it is turned
/// half way round, and so are most of its triangles.
bool is_turned(const CellSolid& before, const CellSolid& after)
{
    constexpr double least = 1e-9; // of the volume
    if (!(volume(after) > least * volume(before))) return true;
    double turned = 0, kept = 0; // areas
    for (const auto& [a, b, c] : before.triangles) {
        const Vector was = glm::cross(before.points[b] - before.points[a], before.points[c] - before.points[a]);
        const Vector is = glm::cross(after.points[b] - after.points[a], after.points[c] - after.points[a]);
        (glm::dot(was, is) < 0 ? turned : kept) += glm::length(was);
    }
    return turned >= kept;
}

/// The least distance between two panes of a pair before they are deformed.
double least_width(const CellTile& tile)
{
    double least = std::numeric_limits<double>::infinity();
    for (const CellPane& pane : tile.cell().panes) {
        const Vector normal = direction(glm::cross(tile.world(pane.right), tile.world(pane.up)));
        least = std::min(least, std::abs(glm::dot(tile.world(tile.cell().at(pane.translation)), normal)));
    }
    return least;
}

} // namespace

CellSolid make_solid(const CellTile& tile, double clearance, CellJoint joint)
{
    CellSolid solid;
    std::vector<std::uint32_t> first;
    for (int i = 0; i < tile.point_count(); ++i) {
        first.push_back(static_cast<std::uint32_t>(solid.points.size()));
        const Point place = tile.world(tile.position(i));
        for (const LatticeStep& step : tile.members(i)) solid.points.push_back(place + tile.world(tile.cell().at(step)));
    }
    const auto vertex = [&](const OrbitMember& member) {
        const auto members = tile.members(member.orbit);
        return first[static_cast<std::size_t>(member.orbit)] + static_cast<std::uint32_t>(std::ranges::find(members, member.shift) - members.begin());
    };
    std::vector<std::uint32_t> number;
    for (int p = 0; p < tile.pane_count(); ++p)
        for (const bool far : {false, true}) {
            const PaneMesh& mesh = tile.mesh(p);
            const LatticeStep back = far ? -tile.cell().panes[static_cast<std::size_t>(p)].translation : LatticeStep{};
            number.clear();
            for (PaneMesh::Index i = 0; i < mesh.point_count(); ++i) {
                const OrbitMember member = tile.pane_point(p, i);
                number.push_back(vertex({member.orbit, member.shift + back}));
            }
            for (const auto& [a, b, c] : mesh.triangles) {
                if (far) solid.triangles.push_back({number[a], number[c], number[b]});
                else solid.triangles.push_back({number[a], number[b], number[c]});
                solid.sides.push_back({p, far});
            }
        }
    if (clearance > 0 && joint == CellJoint::inset) {
        Box box;
        for (const Point& p : solid.points) box.add(p);
        if (!(clearance < box.diagonal())) throw nothing_left(clearance);
        const CellSolid whole = solid;
        inset(solid, clearance);
        if (is_turned(whole, solid)) throw nothing_left(clearance);
    }
    if (clearance > 0 && joint == CellJoint::shrink) {
        const double scale = 1 - clearance / least_width(tile);
        if (!(scale > 0)) throw nothing_left(clearance);
        const Point centre = centre_of_mass(solid);
        for (Point& p : solid.points) p = centre + scale * (p - centre);
    }
    return solid;
}

double volume(const CellSolid& solid)
{
    double sixfold = 0;
    for (const auto& t : solid.triangles) sixfold += glm::dot(solid.points[t[0]], glm::cross(solid.points[t[1]], solid.points[t[2]]));
    return sixfold / 6;
}

Point centre_of_mass(const CellSolid& solid)
{
    double sixfold = 0;
    Vector moment(0.0), sum(0.0);
    for (const auto& t : solid.triangles) {
        const Point &a = solid.points[t[0]], &b = solid.points[t[1]], &c = solid.points[t[2]];
        const double its = glm::dot(a, glm::cross(b, c));
        sixfold += its;
        moment += its * 0.25 * (a + b + c);
    }
    for (const Point& p : solid.points) sum += p;
    return sixfold > 0 ? moment / sixfold : sum / double(solid.points.size());
}

void add_solid(MeshBuilder& builder, const CellSolid& solid, std::span<const int> groups, const Vector& shift, double scale, const Point& about)
{
    const std::uint32_t first = builder.vertex_count();
    for (const Point& p : solid.points) builder.add_vertex(scale == 1 ? p + shift : about + scale * (p - about) + shift);
    for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
        const auto [a, b, c] = solid.triangles[i];
        builder.add_face(std::array{first + a, first + b, first + c}, groups.size() == 1 ? groups.front() : groups[static_cast<std::size_t>(solid.sides[i].pane)]);
    }
}

std::vector<int> pane_groups(const CellTile& tile)
{
    std::vector<int> groups;
    for (int p = 0; p < tile.pane_count(); ++p) groups.push_back(p + 1);
    return groups;
}

} // namespace druse
