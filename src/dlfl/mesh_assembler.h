#pragma once

#include "dlfl/mesh.h"
#include "dlfl/mesh_builder.h"

#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Builds a mesh from a list of corners, the pairs of them that are edges, and the cycles of them that are faces: all that
/// MeshBuilder cannot see in polygons alone, as parallel edges, 2-gons and loops.
///
/// Vertices, corners, edges and faces are numbered from 0 as they are added. Each function tells with a CommandError what
/// contradicts what was added before; the rest is checked when everything is there.
class MeshAssembler {
public:
    void add_vertex(const Point& p) { positions_.push_back(p); } // precondition: finite
    void add_corner(std::uint32_t vertex);
    /// The sides that start at these two corners run against each other along one edge.
    void add_edge(std::uint32_t c1, std::uint32_t c2);
    /// Adds a corner to the face under construction.
    void add_to_face(std::uint32_t corner);
    /// Ends it. A face of one corner that gets no edge is a point sphere.
    void end_face();
    /// A face added before stands for an open boundary.
    void mark_open(std::uint32_t face);

    std::uint32_t vertex_count() const { return positions_.size(); }
    std::uint32_t corner_count() const { return vertex_.size(); }
    std::uint32_t face_count() const { return static_cast<std::uint32_t>(start_.size()); }

    /// The mesh; `groups` has an id for each face added, open ones included.
    ///
    /// Faces, vertices and corners keep their order, edges are numbered as the faces first use them. Sides without an edge are
    /// closed by boundary faces, a vertex with several rotations is split, one without a corner left out: `repairs` counts them.
    /// Cost: linear. Empties the assembler.
    Mesh assemble(std::span<const std::int32_t> groups, Repairs& repairs);

private:
    bool is_open(std::uint32_t corner) const { return open_[face_[corner].index]; }
    void check_sides() const;
    void number_faces(Mesh& mesh, std::span<const std::int32_t> groups);
    void close_openings(Mesh& mesh, Repairs& repairs);
    void number_edges(Mesh& mesh);
    void split_vertices(Mesh& mesh, Repairs& repairs);

    Column<Point> positions_;
    Column<Vertex> vertex_; // of each corner, as the columns that follow
    Column<Corner> next_, previous_;
    Column<Face> face_;
    Column<Edge> edge_;
    Column<std::array<Corner, 2>> edges_;
    std::vector<Corner> start_; // of each face
    std::vector<bool> open_;
    Corner last_; // of the face under construction
};

} // namespace druse
