#include "dlfl/errors.h"
#include "dlfl/mesh_tables.h"
#include "dlfl/rung.h"

namespace druse {

void MeshTables::join_faces(Mesh& mesh, std::span<const Corner> first, std::span<const Corner> second, std::span<const Rung> rungs,
                            std::vector<Face>& walls)
{
    const std::size_t count = rungs.size(), before = walls.size();
    const Face a = mesh.face(first[0]), b = mesh.face(second[0]);
    ASSERT(count > 0 && a != b && !a.is_boundary() && !b.is_boundary(), "two faces to join");
    const int group = mesh.group(a);
    mesh.free_face(a);
    mesh.free_face(b);
    const auto next_of = [count](std::size_t k) { return k + 1 < count ? k + 1 : 0; };
    const auto take_over = [&mesh](Corner fresh, Corner old) { // the side that starts at `old`
        const Edge e = mesh.corner_edge_[old.index];
        mesh.corner_edge_.set(fresh.index, e);
        mesh.replace_edge_corner(e, old, fresh);
    };
    // At a corner, the first rung of the first face keeps the old corner, and the last rung of the second: the old ones keep the edge that
    // comes in. Each wall runs from where it starts along the first face, down the next rung, along the second face, and up its own rung.
    for (std::size_t k = 0; k < count; ++k) {
        const Rung &rung = rungs[k], &following = rungs[next_of(k)];
        const bool stays_above = count > 1 && rung.from == following.from, stays_below = count > 1 && rung.to == following.to;
        ASSERT(!(stays_above && stays_below), "rungs that go on in a face");
        const Corner old_above = first[std::size_t(rung.from)], old_below = second[std::size_t(rung.to)];

        const Corner start = mesh.new_corner(mesh.vertex(old_above));
        if (!stays_above) take_over(start, old_above);
        const Corner down = stays_above ? start : first[std::size_t(following.from)];
        const Corner up = stays_below ? mesh.new_corner(mesh.vertex(old_below)) : old_below;
        const Face wall = mesh.new_face(start, group);
        mesh.corner_face_.set(start.index, wall);
        mesh.corner_face_.set(down.index, wall);
        mesh.corner_face_.set(up.index, wall);
        if (!stays_above) mesh.link(start, down);
        if (stays_below) {
            mesh.link(down, up);
        } else {
            const Corner next_below = second[std::size_t(following.to)], along = mesh.new_corner(mesh.vertex(next_below));
            take_over(along, next_below);
            mesh.corner_face_.set(along.index, wall);
            mesh.link(down, along);
            mesh.link(along, up);
        }
        mesh.link(up, start);
        walls.push_back(wall);
    }
    // Rungs as the walls first use them: the second one, the first one, and then the others.
    const auto start_of = [&](std::size_t k) { return mesh.corner(walls[before + k]); };
    const auto up_of = [&](std::size_t k) { return mesh.previous(start_of(k)); };
    const auto down_of = [&](std::size_t k) {
        const std::size_t behind = k > 0 ? k - 1 : count - 1;
        const bool stays_above = count > 1 && rungs[behind].from == rungs[k].from;
        return stays_above ? start_of(behind) : mesh.next(start_of(behind));
    };
    if (count > 1) mesh.new_edge(down_of(1), up_of(1));
    if (count > 1) mesh.new_edge(up_of(0), down_of(0));
    else mesh.new_edge(down_of(0), up_of(0));
    for (std::size_t k = 2; k < count; ++k) mesh.new_edge(down_of(k), up_of(k));
}

} // namespace druse
