#pragma once

#include "dlfl/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace druse {

struct Rung;

/// The columns of a whole new mesh, for code that knows every reference in closed form and writes it where it belongs.
///
/// The caller fills all columns and calls take(); nothing is searched, and nothing is checked but that the counts can be
/// addressed. Corners are to be numbered face after face, each from its start corner, as MeshBuilder does.
class MeshTables {
public:
    /// Room for so many elements, whose values are not set yet.
    /// @throws CommandError if there are 2^31 of a kind or more
    MeshTables(std::uint64_t vertices, std::uint64_t edges, std::uint64_t faces, std::uint64_t corners);

    // By corner.
    Vertex* vertex;
    Corner *next, *previous;
    Face* face;
    Edge* edge;
    // By edge, face and vertex.
    std::array<Corner, 2>* edge_corners; // the first user of the edge first
    Corner* start;
    std::int32_t* group;
    Point* position;
    Corner* vertex_corner;

    /// Numbers the edges as the corners in ascending order first use them, and fills `edge` and `edge_corners`: one pass.
    /// `opposite(c)` is the corner whose side runs against that of c, by index.
    template <class Opposite>
    void number_edges(Opposite&& opposite)
    {
        std::uint32_t count = 0;
        for (std::uint32_t c = 0; c < corners_; ++c) {
            const std::uint32_t other = opposite(c);
            if (other < c) {
                edge[c] = edge[other];
                continue;
            }
            edge_corners[count] = {Corner(c), Corner(other)};
            edge[c] = Edge(count++);
        }
    }

    /// Makes the corners first … first + sides − 1 a face. Its sides start at the vertices of those corners.
    void close_face(std::uint32_t f, std::uint32_t first, std::uint32_t sides)
    {
        start[f] = Corner(first);
        for (std::uint32_t i = 0; i < sides; ++i) {
            face[first + i] = Face(f);
            next[first + i] = Corner(first + (i + 1 < sides ? i + 1 : 0));
            previous[first + i] = Corner(first + (i > 0 ? i : sides) - 1);
        }
    }

    /// Gives each vertex the first corner that names it: one pass. Every vertex must have one.
    void find_vertex_corners()
    {
        for (std::uint32_t c = corners_; c > 0; --c) vertex_corner[vertex[c - 1].index] = Corner(c - 1);
    }

    /// The mesh; the tables are empty afterwards.
    Mesh take();

    /// The columns of a mesh for reading in bulk. Boundary faces and holes show as they are kept.
    struct View {
        std::span<const Vertex> vertex;
        std::span<const Corner> next, previous;
        std::span<const Face> face;
        std::span<const Edge> edge;
        std::span<const std::array<Corner, 2>> edge_corners;
        std::span<const Corner> start;
    };
    static View view(const Mesh& mesh);

    /// Puts these positions in place of all, and the old ones in theirs. Preconditions: as many as there are, and no change is being recorded.
    static void exchange_positions(Mesh& mesh, Column<Point>& positions);

    /// Adds a copy of everything, turned inside out: vertex v becomes V + v, face f F + f, each face from the same start vertex, and edges follow
    /// from E on as the new faces first use them. Preconditions: no holes, no open boundary. Cost: what is added is written once.
    /// @throws CommandError if there would be 2^31 of a kind or more
    static void append_reversed(Mesh& mesh);

    /// CreatePipe: takes two faces away and joins their boundaries, given by all corners in face order, by a band of walls: V + 0, E + k, F + k − 2,
    /// χ − 2 for k rungs. Each rung goes on by a corner in the first face, or back by one in the second, or both, and in all once round each; as far
    /// as two share a corner the wall between them is a triangle. Walls are made from the first rung on, edges as they first use them; they take freed
    /// ids first, beginning with those of the two faces, and the group of the first one. Each starts where its first rung meets the first face.
    /// Preconditions: two different faces, no open boundary. Cost: O(k). Adds the walls to a list.
    /// Source: Akleman, Chen & Srinivasan 2003; Özener, Akleman & Srinivasan 2005, fig. 4.
    static void join_faces(Mesh& mesh, std::span<const Corner> first, std::span<const Corner> second, std::span<const Rung> rungs, std::vector<Face>& walls);

private:
    Mesh mesh_;
    std::uint32_t corners_;
};

} // namespace druse
