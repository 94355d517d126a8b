#pragma once

#include "dlfl/mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace druse {

/// What had to be mended to make a manifold of a list of polygons; 0 and empty where nothing had to.
struct Repairs {
    std::uint32_t faces_turned = 0;        // wound against their neighbours
    std::uint32_t vertices_split = 0;      // joined surfaces in a point only
    std::uint32_t edges_split = 0;         // had three or more faces
    std::uint32_t boundary_edges = 0;      // sides without a neighbour
    std::uint32_t boundary_loops = 0;      // boundary faces made
    std::uint32_t loose_vertices = 0;      // in no face: left out
    std::uint32_t sides_dropped = 0;       // from a vertex to itself: left out
    std::uint32_t faces_dropped = 0;       // had fewer than three corners without such sides: left out
    std::vector<std::string> notes() const; // one line each, as readers print them
};

/// Builds a whole mesh from vertices and polygons given by vertex number.
///
/// Polygons run counter-clockwise seen from outside and become faces in the order given, each starting at its first vertex.
/// Edges are numbered as the faces first use them. Cost: linear in the number of corners, whatever the valences.
class MeshBuilder {
public:
    /// Makes room; guesses are good enough.
    void reserve(std::uint32_t vertices, std::uint32_t faces, std::uint32_t corners);

    std::uint32_t add_vertex(const Point& p)
    {
        positions_.push_back(p);
        return positions_.size() - 1;
    }
    /// Adds one corner to the polygon under construction.
    void add_corner(std::uint32_t vertex) { corners_.push_back(Vertex(vertex)); }
    /// Ends the polygon under construction. Precondition: at least 3 corners (2 are accepted from meshes of our own).
    void end_face(int group = 0)
    {
        ends_.push_back(corners_.size());
        groups_.push_back(group);
    }
    void add_face(std::span<const std::uint32_t> vertices, int group = 0)
    {
        Vertex* out = corners_.extend(static_cast<std::uint32_t>(vertices.size()));
        for (const std::uint32_t v : vertices) *out++ = Vertex(v);
        end_face(group);
    }
    /// A vertex alone on a one-cornered face.
    void add_point_sphere(std::uint32_t vertex)
    {
        add_corner(vertex);
        end_face();
    }

    std::uint32_t vertex_count() const { return positions_.size(); }
    std::uint32_t face_count() const { return ends_.size(); }
    std::uint32_t corner_count() const { return corners_.size(); }
    const Point& position(std::uint32_t v) const { return positions_[v]; }
    std::span<const Vertex> corners() const { return corners_.view(); }
    std::span<const std::uint32_t> face_ends() const { return ends_.view(); } // one past the last corner of each face
    /// One group per face, for writing.
    std::span<std::int32_t> groups() { return {groups_.write(0, groups_.size()), groups_.size()}; }

    /// The mesh, for polygons that make a closed oriented 2-manifold; anything else fails an ASSERT. Empties the builder.
    Mesh build();

    /// The mesh, for polygons from anywhere.
    ///
    /// Sides from a vertex to itself are left out, and so are faces that keep fewer than three corners, and vertices in no face.
    /// Faces of a component wound against each other are turned (the fewer of the two kinds); vertices that join surfaces in a
    /// point are split, the new ones appended; edges with three or more faces are split into pairs, each enclosing a wedge of the
    /// solid; an open boundary is closed by boundary faces. `repairs` says what was done.
    /// @throws CommandError if the surface is one-sided (a Möbius strip, a Klein bottle)
    Mesh build(Repairs& repairs);

private:
    bool connect(Mesh& mesh);        // false: something has to be mended, and the builder still holds everything
    Mesh mend(Repairs& repairs);
    void leave_out_repetitions(Repairs& repairs);
    void leave_out_loose_vertices(Repairs& repairs);
    void hand_over(Mesh& mesh);      // positions, corners and groups become the mesh's columns

    Column<Point> positions_;
    Column<Vertex> corners_;
    Column<std::uint32_t> ends_;
    Column<std::int32_t> groups_;
};

} // namespace druse
