#include "ui/cell_picture.h"

#include "cell/cell_assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace druse::ui {

namespace {

Colour turned(double hue, int i, double saturation, double value) { return colour_from_hsv(std::fmod(hue + 0.618034 * i, 1.0), saturation, value); }

} // namespace

Vector normal_of(const CellTile& cell, const CellSolid::Side& side)
{
    const CellPane& pane = cell.cell().panes[static_cast<std::size_t>(side.pane)];
    const Vector normal = direction(glm::cross(cell.world(pane.right), cell.world(pane.up)));
    return side.far ? -normal : normal;
}

void CellPicture::set_neighbours(double shrink, int shells)
{
    shrink_ = shrink;
    shells_ = shells;
    place_neighbours();
}

GroupColours CellPicture::colours() const
{
    // Pane k is 2k + 1, and its far one 2k + 2.
    return [shown = pane_](int group) {
        const int pane = (group - 1) / 2;
        return turned(0.09, pane, pane == shown ? 0.5 : 0.4, pane == shown ? 0.97 : group % 2 == 1 ? 0.74 : 0.66);
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
    const bool same = cell_ && cell_->cell().kind == cell->cell().kind && solid.points.size() == solid_.points.size() &&
                      solid.triangles == solid_.triangles && solid.sides == solid_.sides;
    cell_ = *cell;
    solid_ = std::move(solid);
    if (!same) build();
    else update();
    if (same && other_pane) lists_.recolour(mesh_, colours());
    place_neighbours();
}

void CellPicture::build()
{
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

    MeshBuilder builder;
    const auto vertices = static_cast<std::uint32_t>(solid_.points.size()), faces = static_cast<std::uint32_t>(solid_.triangles.size());
    builder.reserve(vertices, faces, 3 * faces);
    for (const Point& p : solid_.points) builder.add_vertex(p);
    for (std::size_t f = 0; f < faces; ++f) builder.add_face(solid_.triangles[f], 2 * solid_.sides[f].pane + (solid_.sides[f].far ? 2 : 1));
    mesh_ = builder.build();
    lists_.build(mesh_, colours());
}

void CellPicture::update()
{
    MeshDelta delta;
    for (std::uint32_t v = 0; v < mesh_.vertex_limit(); ++v) {
        if (mesh_.position(Vertex(v)) == solid_.points[v]) continue;
        mesh_.set_position(Vertex(v), solid_.points[v]);
        delta.vertices.push_back(Vertex(v));
    }
    if (!delta.vertices.empty()) lists_.update(mesh_, delta, colours());
}

void CellPicture::place_neighbours()
{
    std::vector<DrawLists::Copy> copies;
    if (cell_ && shrink_ > 0) {
        int shells = shells_;
        std::vector<LatticeStep> around = cells_around(cell_->cell(), shells);
        while (shells > 1 && around.size() * solid_.triangles.size() > most_faces) around = cells_around(cell_->cell(), --shells);
        const Point centre = centre_of_mass(solid_);
        for (std::size_t i = 1; i < around.size(); ++i) // the first is the cell itself
            copies.push_back({shrink_, (1 - shrink_) * centre + cell_->world(cell_->cell().at(around[i])), turned(0.55, static_cast<int>(i) - 1, 0.3, 0.58)});
    }
    lists_.set_copies(std::move(copies));
}

// --- looking things up --------------------------------------------------------------------------------------------------------------------

OrbitMember CellPicture::orbit_of(Vertex v) const
{
    const int orbit = orbit_[v.index];
    return {orbit, cell_->members(orbit)[v.index - first_[static_cast<std::size_t>(orbit)]]};
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
