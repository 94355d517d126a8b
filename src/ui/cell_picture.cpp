#include "ui/cell_picture.h"

#include "cell/cell_assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace druse::ui {

namespace {

constexpr double seen_shift = 1e-3; // of the size of a cell, by which the middle of a neighbour may be off

} // namespace

Vector normal_of(const CellTile& cell, const CellSolid::Side& side)
{
    const CellPane& pane = cell.cell().panes[static_cast<std::size_t>(side.pane)];
    const Vector normal = direction(glm::cross(cell.world(pane.right), cell.world(pane.up)));
    return side.far ? -normal : normal;
}

void CellPicture::set_neighbours(double shrink, int shells)
{
    const bool same_cells = shells == shells_ && (shrink > 0) == (shrink_ > 0);
    is_old_ = is_old_ || !same_cells;
    shrink_ = shrink;
    shells_ = shells;
}

GroupColours CellPicture::colours() const
{
    // Pane k is 2k + 1, and its far one 2k + 2; then come the neighbours.
    const int panes = cell_ ? cell_->pane_count() : 0;
    return [panes, shown = pane_](int group) {
        const auto turned = [](double hue, int i) { return std::fmod(hue + 0.618034 * i, 1.0); };
        if (group > 2 * panes) return colour_from_hsv(turned(0.55, group - 2 * panes - 1), 0.25, 0.5);
        const int pane = (group - 1) / 2;
        return colour_from_hsv(turned(0.09, pane), pane == shown ? 0.5 : 0.4, pane == shown ? 0.97 : group % 2 == 1 ? 0.74 : 0.66);
    };
}

void CellPicture::follow(const CellTile* cell, int pane)
{
    if (!cell) {
        cell_.reset();
        solid_ = {};
        pane_ = -1;
        mesh_ = Mesh();
        lists_ = DrawLists();
        return;
    }
    const bool other_pane = std::exchange(pane_, pane) != pane;
    CellSolid solid = make_solid(*cell);
    const bool same = cell_ && !is_old_ && cell_->cell().kind == cell->cell().kind && solid.points.size() == solid_.points.size() &&
                      solid.triangles == solid_.triangles && solid.sides == solid_.sides;
    cell_ = *cell;
    solid_ = std::move(solid);
    if (!same) build();
    else update();
    if (same && other_pane) lists_.recolour(mesh_, colours());
}

/// Where a vertex of the mesh is: those of the cell itself, then those of each neighbour.
Point CellPicture::place(std::size_t vertex) const
{
    const std::size_t count = solid_.points.size();
    if (vertex < count) return solid_.points[vertex];
    return centre_ + shrink_ * (solid_.points[vertex % count] - centre_) + shifts_[vertex / count - 1];
}

void CellPicture::build()
{
    is_old_ = false;
    const std::size_t vertices = solid_.points.size(), faces = solid_.triangles.size();
    first_.clear();
    orbit_.clear();
    for (int i = 0; i < cell_->point_count(); ++i) {
        first_.push_back(static_cast<std::uint32_t>(orbit_.size()));
        orbit_.insert(orbit_.end(), cell_->members(i).size(), i);
    }
    first_triangle_.clear();
    std::uint32_t next = 0;
    for (int p = 0; p < cell_->pane_count(); ++p) {
        first_triangle_.push_back(next);
        next += 2 * static_cast<std::uint32_t>(cell_->mesh(p).triangles.size());
    }

    int shells = shrink_ > 0 ? shells_ : 0;
    around_ = cells_around(cell_->cell(), shells);
    while (shells > 1 && around_.size() * faces > most_faces) around_ = cells_around(cell_->cell(), --shells);
    around_.erase(around_.begin());
    shifts_.clear();
    for (const LatticeStep& step : around_) shifts_.push_back(cell_->world(cell_->cell().at(step)));
    centre_ = centre_of_mass(solid_);

    MeshBuilder builder;
    const auto copies = static_cast<std::uint32_t>(around_.size() + 1);
    builder.reserve(static_cast<std::uint32_t>(vertices) * copies, static_cast<std::uint32_t>(faces) * copies, 3 * static_cast<std::uint32_t>(faces) * copies);
    for (std::size_t v = 0; v < vertices * copies; ++v) builder.add_vertex(place(v));
    for (std::uint32_t copy = 0; copy < copies; ++copy) {
        const auto first = static_cast<std::uint32_t>(copy * vertices);
        const int neighbour = 2 * cell_->pane_count() + static_cast<int>(copy);
        for (std::size_t f = 0; f < faces; ++f) {
            const auto [a, b, c] = solid_.triangles[f];
            const Side side = solid_.sides[f];
            builder.add_face(std::array{first + a, first + b, first + c}, copy > 0 ? neighbour : 2 * side.pane + (side.far ? 2 : 1));
        }
    }
    mesh_ = builder.build();
    lists_.build(mesh_, colours());
}

void CellPicture::update()
{
    for (std::size_t i = 0; i < around_.size(); ++i) shifts_[i] = cell_->world(cell_->cell().at(around_[i]));
    // Each move moves the centre of mass a little, and with it all neighbours: that can wait until it is seen.
    if (const Point centre = centre_of_mass(solid_); (1 - shrink_) * glm::distance(centre, centre_) > seen_shift * cell_->size()) centre_ = centre;
    MeshDelta delta;
    for (std::uint32_t v = 0; v < mesh_.vertex_limit(); ++v) {
        const Point to = place(v);
        if (mesh_.position(Vertex(v)) == to) continue;
        mesh_.set_position(Vertex(v), to);
        delta.vertices.push_back(Vertex(v));
    }
    if (!delta.vertices.empty()) lists_.update(mesh_, delta, colours());
}

// --- looking things up --------------------------------------------------------------------------------------------------------------------

std::optional<CellPicture::Side> CellPicture::pane_of(Face f) const
{
    return f.index < solid_.sides.size() ? std::optional(solid_.sides[f.index]) : std::nullopt;
}

std::optional<OrbitMember> CellPicture::orbit_of(Vertex v) const
{
    if (!cell_ || v.index >= solid_.points.size()) return {};
    const int orbit = orbit_[v.index];
    return OrbitMember{orbit, cell_->members(orbit)[v.index - first_[static_cast<std::size_t>(orbit)]]};
}

int CellPicture::triangle_of(Face f) const
{
    const Side side = solid_.sides[f.index];
    const auto own = static_cast<std::uint32_t>(cell_->mesh(side.pane).triangles.size());
    return static_cast<int>(f.index - first_triangle_[static_cast<std::size_t>(side.pane)] - (side.far ? own : 0));
}

std::optional<Vertex> CellPicture::vertex_of(const OrbitMember& member) const
{
    if (!cell_ || member.orbit < 0 || member.orbit >= cell_->point_count()) return {};
    const auto members = cell_->members(member.orbit);
    const auto found = std::ranges::find(members, member.shift);
    if (found == members.end()) return {};
    return Vertex(first_[static_cast<std::size_t>(member.orbit)] + static_cast<std::uint32_t>(found - members.begin()));
}

std::optional<Edge> CellPicture::edge_between(Vertex a, Vertex b) const
{
    for (const Corner c : mesh_.around(a))
        if (mesh_.target(c) == b) return mesh_.edge(c);
    return {};
}

std::vector<bool> CellPicture::facing(const Camera& camera) const
{
    std::vector<bool> seen(solid_.points.size(), false);
    const Point eye = camera.eye();
    for (const auto& t : solid_.triangles) {
        const Point &a = solid_.points[t[0]], &b = solid_.points[t[1]], &c = solid_.points[t[2]];
        const Vector toward = camera.parallel() ? camera.backward() : eye - a;
        if (glm::dot(glm::cross(b - a, c - a), toward) <= 0) continue;
        for (const std::uint32_t v : t) seen[v] = true;
    }
    return seen;
}

} // namespace druse::ui
