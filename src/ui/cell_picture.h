#pragma once

#include "cell/cell_solid.h"
#include "render/camera.h"
#include "render/draw_lists.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace druse::ui {

/// A cell in space, as it is drawn while it is edited, its neighbours being copies of it.
///
/// Where points are moved only what is elsewhere is put again; where triangles are others, all is.
class CellPicture {
public:
    using Side = CellSolid::Side;
    static constexpr std::size_t most_faces = 2'000'000; // shells are left out, the outermost first, but for one, where more would be drawn

    bool is_shown = true; // else a mesh is, in its place

    /// Cells around it, which are shown where `shrink` is above 0: scaled about their own centres of mass, so that joints open; 1 is touching.
    void set_neighbours(double shrink, int shells);
    double neighbours() const { return shrink_; }
    int shells() const { return shells_; }

    /// Follows a cell; without one nothing is drawn. `pane`: the pair that is edited, which is brighter; −1: none.
    void follow(const CellTile* cell, int pane);

    const DrawLists& lists() const { return lists_; }
    const std::optional<CellTile>& cell() const { return cell_; } // as it is drawn
    int pane() const { return pane_; }
    const CellSolid& solid() const { return solid_; } // of the cell alone

    Side pane_of(Face f) const { return solid_.sides[f.index]; }
    OrbitMember orbit_of(Vertex v) const;
    /// Its number among those of its pane. Precondition: a face of the cell
    int triangle_of(Face f) const;
    std::optional<Vertex> vertex_of(const OrbitMember& member) const;
    std::optional<Edge> edge_between(Vertex a, Vertex b) const;
    /// Which vertices of the cell are on a triangle that turns its outside to the camera, whatever is before it.
    std::vector<bool> facing(const Camera& camera) const;

private:
    void build();
    void update();
    void place_neighbours();
    GroupColours colours() const;

    std::optional<CellTile> cell_;
    CellSolid solid_;
    std::vector<std::uint32_t> first_;          // vertex of each orbit
    std::vector<int> orbit_;                    // of each vertex
    std::vector<std::uint32_t> first_triangle_; // of each pane: those of the near one, and of the far one behind them
    int pane_ = -1;

    double shrink_ = 0;
    int shells_ = 1;

    Mesh mesh_;
    DrawLists lists_;
};

/// Outward, of length 1, in the world, as it is before points are moved.
Vector normal_of(const CellTile& cell, const CellSolid::Side& side);

} // namespace druse::ui
