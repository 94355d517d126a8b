#pragma once

#include "dlfl/mesh.h"
#include "ops/remesh_scheme.h"

#include <cstdint>
#include <span>

namespace druse::remesh {

/// Work on so many corners is worth a thread of its own.
inline constexpr std::uint32_t worth_a_thread = 1u << 16;

/// A closed mesh for reading, its corners numbered face after face from the start corners.
///
/// Where the mesh has them in that order already, as every mesh from a file or from a remeshing has, its own columns are read.
class OldMesh {
public:
    /// Precondition: no holes, and the mesh outlives this.
    /// @throws CommandError `the model is open: N boundary edges`, `vertex ID has valence N` (less than `least_valence`),
    /// `face ID has N sides` (less than 3)
    OldMesh(const Mesh& mesh, int least_valence);

    std::uint32_t vertices() const { return mesh_.vertex_limit(); }
    std::uint32_t edges() const { return mesh_.edge_limit(); }
    std::uint32_t faces() const { return mesh_.face_limit(); }
    std::uint32_t corners() const { return mesh_.corner_limit(); }

    std::uint32_t begin(std::uint32_t f) const { return begin_[f]; } // the start corner
    std::uint32_t end(std::uint32_t f) const { return begin_[f + 1]; }

    std::uint32_t vertex(std::uint32_t c) const { return vertex_[c].index; }
    std::uint32_t face(std::uint32_t c) const { return face_[c].index; }
    std::uint32_t on(std::uint32_t c) const { return next_[c].index; }
    std::uint32_t back(std::uint32_t c) const { return previous_[c].index; }
    std::uint32_t across(std::uint32_t c) const { return across_[c]; }
    std::uint32_t side(std::uint32_t c) const { return side_[c]; } // 2 · edge, and 1 more at the edge's second corner
    std::uint32_t edge(std::uint32_t c) const { return side(c) >> 1; }
    std::uint32_t around(std::uint32_t c) const { return across(back(c)); }
    std::uint32_t corner_of_side(std::uint32_t side) const { return corner_of_side_[side >> 1][side & 1].index; }

    template <Step step>
    std::uint32_t take(std::uint32_t c) const
    {
        if constexpr (step == Step::on) return on(c);
        else if constexpr (step == Step::back) return back(c);
        else return across(c);
    }

    std::uint32_t valence(std::uint32_t v) const { return valence_[v]; }
    std::span<const Point> positions() const { return mesh_.positions(); }
    const Point& position(std::uint32_t c) const { return mesh_.positions()[vertex(c)]; }
    std::int32_t group(std::uint32_t f) const { return mesh_.groups()[f]; }

    /// Puts the corners of each vertex in order: vertices by id, each counter-clockwise from the edge to its lowest-numbered
    /// neighbour. Needed before corner_around(), and before place_around() with `with_places`.
    void order_around(bool with_places = true);
    std::uint32_t place_around(std::uint32_t c) const { return place_around_[c]; }   // of a corner in that order
    std::uint32_t corner_around(std::uint32_t at) const { return corner_around_[at]; } // at a place in that order

    /// Memory held beside the mesh, in bytes.
    std::size_t bytes() const;

private:
    void read_in_order();
    void renumber();

    const Mesh& mesh_;
    std::span<const Vertex> vertex_;
    std::span<const Face> face_;
    std::span<const Corner> next_, previous_;
    std::span<const std::array<Corner, 2>> corner_of_side_;
    Column<std::uint32_t> begin_, across_, side_, valence_, place_around_, corner_around_;

    // Own columns, where the mesh's corners come in another order; and the number of each of them in ours.
    Column<std::uint32_t> number_;
    Column<Vertex> own_vertex_;
    Column<Face> own_face_;
    Column<Corner> own_next_, own_previous_;
    Column<std::array<Corner, 2>> own_corner_of_side_;
};

} // namespace druse::remesh
