// Groups where faces are copied, joined, parted or walled in: copies and parts keep an id, the walls of one command share a new one, above all
// that were there before it.
#include "ops/registry.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <string>

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;

/// Every face is a group of its own; the higher the id of a face, the lower that of its group.
Mesh grouped(Mesh mesh)
{
    for (const Face f : mesh.faces()) mesh.set_group(f, int(mesh.face_limit() - f.index));
    return mesh;
}

/// What names a face wherever ids go: the places of its corners.
std::vector<std::array<double, 3>> places(const Mesh& mesh, Face f)
{
    std::vector<std::array<double, 3>> list;
    for (const Corner c : mesh.corners(f)) list.push_back({mesh.position(c).x, mesh.position(c).y, mesh.position(c).z});
    std::ranges::sort(list);
    return list;
}

/// The selected faces are `walls` in number and of the group `group`; all others were there before, and keep theirs.
void expect_new_walls(const Mesh& before, const Scene& after, std::size_t walls, int group)
{
    std::map<std::vector<std::array<double, 3>>, int> group_of;
    for (const Face f : before.faces()) group_of[places(before, f)] = before.group(f);
    EXPECT_EQ(after.selection->faces.size(), walls);
    for (const Face f : after.mesh.faces()) {
        const auto known = group_of.find(places(after.mesh, f));
        EXPECT_EQ(after.mesh.group(f), known != group_of.end() ? known->second : group) << "face " << f.index;
        EXPECT_EQ(std::ranges::binary_search(after.selection->faces, f), known == group_of.end()) << "face " << f.index;
    }
}

TEST(NewGroup, OfAPipeIsAboveThoseOfTheFacesItTakesAway)
{
    for (const auto& [command, segments] : std::array<std::pair<const char*, int>, 4>{{{"topology.pipe", 1}, {"topology.pipe", 3}, {"topology.handle", 1}, {"topology.handle", 5}}}) {
        for (const auto& [from, to] : {std::pair(2, 10), std::pair(10, 2)}) {
            Mesh mesh = two_cubes();
            for (const Face f : mesh.faces()) mesh.set_group(f, 1 + int(f.index) % 3);
            mesh.set_group(Face(std::uint32_t(from)), 5);
            mesh.set_group(Face(std::uint32_t(to)), 9);
            Scene scene = scene_of(mesh);
            run(scene, command, {{"from", std::to_string(from)}, {"to", std::to_string(to)}, {"segments", std::to_string(segments)}});
            expect_new_walls(mesh, scene, 4 * std::size_t(segments), 10);
        }
    }
}

TEST(NewGroup, OfHolesIsOneForACommandAndAboveThoseOfTheFacesItOpens)
{
    for (const Mesh& mesh : {cube(), dodecahedron(), torus(8, 5)}) {
        Scene crust = scene_of(grouped(mesh));
        run(crust, "rind.crust", {{"guard", "off"}, {"thickness", "0.05"}});
        Scene scene = crust;
        run(scene, "rind.punch", {{"faces", "0,2"}});
        const auto n = static_cast<std::size_t>(mesh.valence(Face(0)));
        expect_new_walls(crust.mesh, scene, 2 * n, int(mesh.face_count()) + 1); // that of face 0 was the largest
        const Mesh punched = scene.mesh;
        run(scene, "rind.punch", {{"faces", "1"}});
        EXPECT_EQ(scene.mesh.group(scene.selection->faces.front()), int(mesh.face_count()) + 2);
    }
}

TEST(NewGroup, OfPeeledHolesGoesToTheWallsThatStayAndToNoOtherFace)
{
    std::mt19937 random(20);
    for (const Mesh& mesh : {cube(), dodecahedron(), icosahedron(), torus(8, 5)}) {
        Scene crust = scene_of(grouped(mesh));
        run(crust, "rind.crust", {{"guard", "off"}, {"thickness", "0.05"}});
        for (int trial = 0; trial < 20; ++trial) {
            std::string faces = "0";
            std::vector<bool> open(mesh.face_limit(), false);
            open[0] = true;
            for (std::uint32_t f = 1; f + 1 < mesh.face_limit(); ++f)
                if (random() % 3 == 0) {
                    faces += "," + std::to_string(f);
                    open[f] = true;
                }
            std::size_t rims = 0;
            for (const Edge e : mesh.edges()) rims += open[mesh.faces(e)[0].index] != open[mesh.faces(e)[1].index];
            SCOPED_TRACE(faces);
            Scene scene = crust;
            run(scene, "rind.peel", {{"faces", faces}});
            EXPECT_SOUND(scene.mesh);
            expect_new_walls(crust.mesh, scene, rims, int(mesh.face_count()) + 1);
        }
    }
}

TEST(NewGroup, OfTheRimOfACrustIsAboveThoseOfItsFaces)
{
    const Mesh sheet = grouped(open_grid(3, 2));
    Scene scene = scene_of(sheet);
    run(scene, "rind.crust", {{"thickness", "0.5"}});
    for (std::uint32_t f = 0; f < 22; ++f) EXPECT_EQ(scene.mesh.group(Face(f)), f < 12 ? 6 - int(f % 6) : 7) << f;
}

TEST(NewGroup, IsNoneWhereFacesAreCopied)
{
    const Mesh mesh = grouped(dodecahedron());
    Scene crust = scene_of(mesh), nest = scene_of(mesh);
    run(crust, "rind.crust");
    run(nest, "rind.nest", {{"copies", "3"}});
    ASSERT_EQ(crust.mesh.face_count(), 24u);
    ASSERT_EQ(nest.mesh.face_count(), 48u);
    for (const Face f : crust.mesh.faces()) EXPECT_EQ(crust.mesh.group(f), 12 - int(f.index % 12));
    for (const Face f : nest.mesh.faces()) EXPECT_EQ(nest.mesh.group(f), 12 - int(f.index % 12));
}

TEST(NewGroup, IsNoneWhereFacesAreMergedOrFallApart)
{
    Scene scene = scene_of(grouped(two_cubes()));
    run(scene, "topology.insert_edge", {{"c1", "10:0"}, {"c2", "2:0"}});
    EXPECT_EQ(scene.mesh.group(Face(2)), 10) << "the lower face stays";
    EXPECT_EQ(scene.mesh.group(Face(10)), 1) << "the last one moved up";
    run(scene, "topology.delete_edge", {{"edges", "24"}});
    ASSERT_EQ(scene.mesh.face_count(), 12u);
    EXPECT_EQ(scene.mesh.group(Face(2)), 10);
    EXPECT_EQ(scene.mesh.group(Face(11)), 10) << "both parts keep the id of the face that fell apart";
}

} // namespace
} // namespace druse
