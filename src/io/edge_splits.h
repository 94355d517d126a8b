#pragma once

#include "dlfl/mesh.h"
#include "io/output_files.h"

#include <cstdint>
#include <vector>

namespace druse {

/// The vertices that a format with index lists needs inside edges: one in all but one of the edges that join the same two
/// vertices, two in a loop, and one in an edge that is a whole component, whose face would have but two corners. Only the file
/// has them, numbered after the mesh's own.
class EdgeSplits {
public:
    /// Cost: O(edges).
    explicit EdgeSplits(const Mesh& mesh);

    bool empty() const { return added_.empty(); }
    /// Says how many edges of each kind are split, and whether there are walls without thickness between them, as rind.punch leaves.
    void note(OutputFiles& out) const;
    const std::vector<Point>& added() const { return added_; }

    /// Calls `f` with the number of each vertex along the side that starts at `c`, in its direction.
    template <class F> void along(const Mesh& mesh, Corner c, F&& f) const
    {
        const Edge e = mesh.edge(c);
        if (empty() || !e.valid() || first_[e.index] == 0) return;
        const std::uint32_t number = mesh.vertex_limit() + first_[e.index] - 1;
        if (mesh.vertex(mesh.corner(e, 0)) != mesh.target(mesh.corner(e, 0))) {
            f(number);
        } else {
            const bool forward = mesh.corner(e, 0) == c;
            f(forward ? number : number + 1);
            f(forward ? number + 1 : number);
        }
    }

private:
    std::vector<std::uint32_t> first_; // per edge: 1 + its first place in `added_`; 0 if it is not split; empty if none is
    std::vector<Point> added_;
    std::uint32_t parallel_ = 0, loops_ = 0, lone_ = 0, thin_walls_ = 0;
};

/// Warns of walls without thickness, if there are any.
void note_thin_walls(std::uint32_t count, OutputFiles& out);

} // namespace druse
