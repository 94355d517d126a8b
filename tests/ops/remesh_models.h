#pragma once

#include "ops/remesh.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <algorithm>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

namespace druse::test {

using Ring = std::vector<std::uint32_t>;
using Rings = std::vector<Ring>;

template <class Kernel>
Mesh once(const Mesh& mesh, const Kernel& kernel = {}, RemeshGroups groups = RemeshGroups::absolute)
{
    Progress progress;
    return remeshed(mesh, kernel, 1, groups, progress);
}

/// What a command makes of a mesh.
inline Mesh made_of(const Mesh& mesh, std::string_view command, const std::vector<std::pair<std::string, std::string>>& arguments = {})
{
    Scene scene = scene_of(mesh);
    run(scene, command, arguments);
    return std::move(scene.mesh);
}

// --- shapes beside those of the family ------------------------------------------------------------------------------------------

/// A cube with two edges between vertices 0 and the next one, and five triangles between them: parallel edges, valences of 3 and more.
inline Mesh cube_with_parallel_triangles()
{
    Mesh mesh = cube_with_parallel_edges();
    const auto put_point_into = [&mesh](Face f) {
        std::vector<Corner> corners;
        for (const Corner c : mesh.corners(f)) corners.push_back(c);
        Point mean(0.0);
        for (const Corner c : corners) mean += mesh.position(c) / double(corners.size());
        const Vertex v = mesh.create_vertex(mean * 1.01);
        for (const Corner c : corners) mesh.insert_edge(mesh.corner(v), c);
        mesh.compact();
    };
    put_point_into(Face(6)); // the 2-gon
    put_point_into(Face(6)); // a triangle of it
    return mesh;
}

/// The same mesh whose faces start elsewhere, so that its corners are in no order.
inline Mesh with_turned_starts(Mesh mesh)
{
    for (const Face f : mesh.faces()) {
        Corner c = mesh.corner(f);
        for (std::uint32_t k = 0; k < f.index % 5; ++k) c = mesh.next(c);
        mesh.set_start(c);
    }
    return mesh;
}

/// A torus whose faces were extruded here and there: its edges are numbered in no particular order.
inline Mesh edited_torus()
{
    Scene scene = scene_of(torus(7, 5));
    run(scene, "extrude.cubical", {{"faces", "3,11,20-22"}});
    run(scene, "extrude.octahedral", {{"faces", "11,30"}});
    run(scene, "topology.insert_edge", {{"c1", "0:0"}, {"c2", "0:2"}});
    run(scene, "topology.delete_edge", {{"edges", "17"}});
    return with_turned_starts(scene.mesh);
}

struct Input {
    const char* name;
    Mesh (*make)();
    friend std::ostream& operator<<(std::ostream& out, const Input& input) { return out << input.name; }
};
inline const std::vector<Input> remeshed_models{
    {"Tetrahedron", tetrahedron},
    {"Cube", cube},
    {"Octahedron", octahedron},
    {"Dodecahedron", dodecahedron},
    {"Icosahedron", icosahedron},
    {"Torus", [] { return torus(7, 5); }},
    {"GenusTwoBlock", [] { return block_with_holes(2); }},
    {"GenusFiveBlock", [] { return block_with_holes(5); }},
    {"LPrism", l_prism},
    {"DentedCube", dented_cube},
    {"Pyramid", [] { return pyramid(7); }},
    {"TwoCubes", two_cubes},
    {"FaceThatVisitsVerticesTwice", tethered_cubes},
    {"FaceOnBothSidesOfAnEdge", cube_with_edge_handle},
    {"ParallelEdges", cube_with_parallel_triangles},
    {"StartsElsewhere", [] { return with_turned_starts(dodecahedron()); }},
    {"EditedTorus", edited_torus},
};

// --- the plain way --------------------------------------------------------------------------------------------------------------

/// The old mesh as lists: what the sources count with.
struct Lists {
    const Mesh& mesh;
    std::uint32_t V = mesh.vertex_count(), E = mesh.edge_count(), F = mesh.face_count();
    std::map<std::uint32_t, std::uint32_t> rank; // of a corner, faces by id and each from its start corner
    explicit Lists(const Mesh& m) : mesh(m)
    {
        for (const Face f : m.faces())
            for (const Corner c : m.corners(f)) rank.emplace(c.index, static_cast<std::uint32_t>(rank.size()));
    }
    std::uint32_t v(Corner c) const { return mesh.vertex(c).index; }
    std::uint32_t e(Corner c) const { return mesh.edge(c).index; }
    std::uint32_t f(Corner c) const { return mesh.face(c).index; }
    std::uint32_t k(Corner c) const { return rank.at(c.index); }
    /// The side of its edge: 0 where the edge starts.
    std::uint32_t s(Corner c) const { return mesh.corner(mesh.edge(c), 0) == c ? 0 : 1; }

    /// The corners around a vertex from the edge to its lowest-numbered neighbour on.
    std::vector<Corner> around(Vertex at) const
    {
        std::vector<Corner> list;
        for (const Corner c : mesh.around(at)) list.push_back(c);
        const auto first = std::ranges::min_element(list, {}, [&](Corner c) { return std::pair(mesh.target(c).index, e(c)); });
        std::rotate(list.begin(), first, list.end());
        return list;
    }
};

inline void expect_kind_kept(const Mesh& before, const Mesh& after)
{
    ASSERT_SOUND(after);
    EXPECT_EQ(genus(after), genus(before));
    EXPECT_EQ(components(after).parts.size(), components(before).parts.size());
    EXPECT_TRUE(edges_are_numbered_by_first_use(after));
}
inline void expect_genus_and_volume_kept(const Mesh& before, const Mesh& after)
{
    expect_kind_kept(before, after);
    EXPECT_GT(volume(after), 0.0);
}

} // namespace druse::test
