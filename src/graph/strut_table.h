#pragma once

#include "dlfl/mesh.h"

#include <cstdint>
#include <vector>

namespace druse {

/// Which faces of a mesh were made from which part of a graph. Balls come first, by vertex, then struts, by edge, then caps, by vertex.
///
/// The table is not told what happens to the mesh. It holds as long as these faces have the corners they had: not when others have come to their places.
struct StrutTable {
    std::uint64_t corners = 0;     // a fingerprint of all that the faces have
    std::uint32_t first_face = 0;  // faces before were there before
    std::uint32_t per_strut = 0;   // faces
    std::vector<std::uint32_t> ball_ends, cap_ends; // by vertex made from, one past its last face
    std::vector<std::uint32_t> vertex_ids, edge_ids; // what the graph calls them

    /// Add the faces of a part, by its place in the lists above. A vertex has a ball or a cap.
    void add_strut(std::uint32_t edge, std::vector<Face>& faces) const;
    void add_ball(std::uint32_t vertex, std::vector<Face>& faces) const;
    void add_cap(std::uint32_t vertex, std::vector<Face>& faces) const;

    /// Takes note of the corners that the faces have. Precondition: they are there. Cost: O(faces)
    void hold(const Mesh& mesh) { corners = fingerprint(mesh); }

    /// The faces of the strut of an edge of the graph, or of the ball or cap at a vertex; none where there are none, or the table no longer holds. Cost: O(graph), and of all faces.
    std::vector<Face> strut(const Mesh& now, std::uint32_t edge) const;
    std::vector<Face> ball(const Mesh& now, std::uint32_t vertex) const;

    friend bool operator==(const StrutTable&, const StrutTable&) = default;

private:
    std::uint32_t face_count() const;
    std::uint64_t fingerprint(const Mesh& mesh) const;
    bool holds(const Mesh& now) const;
};

} // namespace druse
