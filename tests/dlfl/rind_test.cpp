// The table of corresponding faces: what keeps an entry alive, and what does not.
#include "dlfl/rind.h"

#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace druse {
namespace {

using namespace test;

/// A shape and its copy inside out, face i over face F + i, as rind.crust makes it.
struct Crust {
    Mesh mesh;
    Rind rind;

    explicit Crust(Mesh shape) : mesh(std::move(shape))
    {
        const std::uint32_t count = mesh.face_limit();
        mesh.append(mesh);
        std::vector<Face> copies;
        for (std::uint32_t f = count; f < 2 * count; ++f) copies.emplace_back(f);
        mesh.reverse_components(copies);
        rind = Rind::of_copies(mesh, count);
    }
    std::size_t live() const { return rind.pairs(mesh).size(); }
};

TEST(Rind, FindsTheCornersOfEitherFace)
{
    const Crust crust(dodecahedron());
    for (std::uint32_t f = 0; f < 12; ++f) {
        const auto pair = crust.rind.find(crust.mesh, Face(f));
        ASSERT_TRUE(pair);
        EXPECT_EQ(*pair, (std::array{crust.mesh.corner(Face(f)), crust.mesh.corner(Face(12 + f))}));
        EXPECT_EQ(crust.rind.find(crust.mesh, Face(12 + f)), pair);
    }
    EXPECT_FALSE(crust.rind.find(crust.mesh, Face(24)));
    EXPECT_FALSE(crust.rind.find(crust.mesh, Face()));
    EXPECT_FALSE(Rind().find(crust.mesh, Face(0)));
    EXPECT_TRUE(Rind().empty());
}

TEST(Rind, PairsCornersThatRunAgainstEachOther)
{
    for (const NamedShape& shape : all_shapes()) {
        const Mesh original = shape.make();
        if (original.boundary_count() > 0 || original.edge_count() == 0) continue;
        const Crust crust(original);
        for (const Rind::Pair& p : crust.rind.pairs(crust.mesh)) {
            Corner c = crust.mesh.corner(p.first, int(p.first_corner)), d = crust.mesh.corner(p.second, int(p.second_corner));
            for (int i = 0; i < original.valence(p.first); ++i) {
                EXPECT_EQ(crust.mesh.vertex(d).index, crust.mesh.vertex(c).index + original.vertex_limit()) << shape.name;
                c = crust.mesh.next(c);
                d = crust.mesh.previous(d);
            }
        }
    }
}

TEST(Rind, OutlivesMovingAndOtherStarts)
{
    Crust crust(cube());
    for (const Vertex v : crust.mesh.vertices()) crust.mesh.set_position(v, 2.0 * crust.mesh.position(v));
    for (const Face f : crust.mesh.faces()) crust.mesh.set_start(crust.mesh.corner(f, int(f.index) % 4));
    EXPECT_EQ(crust.live(), 6u);
    for (const Rind::Pair& p : crust.rind.pairs(crust.mesh)) {
        EXPECT_EQ(p.first_corner, (4 - p.first.index % 4) % 4);
        EXPECT_EQ(p.second_corner, (4 - p.second.index % 4) % 4);
    }
    std::vector<Face> all;
    for (const Face f : crust.mesh.faces()) all.push_back(f);
    crust.mesh.reverse_components(all);
    EXPECT_EQ(crust.live(), 6u);
}

TEST(Rind, LosesPairsWhoseFacesChange)
{
    Crust crust(cube());
    crust.mesh.insert_edge(crust.mesh.corner(Face(2), 0), crust.mesh.corner(Face(2), 2));
    EXPECT_EQ(crust.live(), 5u);
    EXPECT_FALSE(crust.rind.find(crust.mesh, Face(2)));
    EXPECT_FALSE(crust.rind.find(crust.mesh, Face(8)));
    crust.mesh.delete_edge(Edge(24)); // it is what it was
    EXPECT_EQ(crust.live(), 6u);
    crust.mesh.delete_edge(Edge(0)); // merges two faces
    close_holes(crust.mesh, crust.rind);
    EXPECT_EQ(crust.live(), 4u);
    crust.mesh.reverse_components(std::array{Face(10)}); // the copies alone: now both run the same way
    EXPECT_EQ(crust.live(), 0u);
}

TEST(Rind, ForgetsAPairThatIsRemoved)
{
    Crust crust(cube());
    crust.rind.remove(Face(9));
    EXPECT_FALSE(crust.rind.find(crust.mesh, Face(3)));
    EXPECT_FALSE(crust.rind.find(crust.mesh, Face(9)));
    crust.rind.remove(Face(3));
    crust.rind.remove(Face(77));
    EXPECT_EQ(crust.live(), 5u);
}

TEST(Rind, IsRebuiltFromItsPairs)
{
    Crust crust(icosahedron());
    for (const Face f : crust.mesh.faces()) crust.mesh.set_start(crust.mesh.corner(f, int(f.index) % 3));
    const auto pairs = crust.rind.pairs(crust.mesh);
    EXPECT_EQ(Rind(crust.mesh, pairs).pairs(crust.mesh), pairs);
    EXPECT_TRUE(Rind(crust.mesh, {}).empty());
}

TEST(Rind, FollowsFacesAndVerticesWhenHolesClose)
{
    Crust crust(prism(5));
    // A face is merged away and an antenna's end with it: later ids move down.
    crust.mesh.append(segment());
    crust.mesh.delete_edge(Edge(2));
    const std::size_t live = crust.live();
    crust.mesh.delete_edge(Edge(crust.mesh.edge_limit() - 1), true);
    ASSERT_TRUE(crust.mesh.has_holes());
    close_holes(crust.mesh, crust.rind);
    EXPECT_SOUND(crust.mesh);
    EXPECT_EQ(crust.live(), live);
    EXPECT_EQ(live, 5u);
    for (const Rind::Pair& p : crust.rind.pairs(crust.mesh)) {
        const Corner c = crust.mesh.corner(p.first, int(p.first_corner)), d = crust.mesh.corner(p.second, int(p.second_corner));
        EXPECT_EQ(crust.mesh.position(c), crust.mesh.position(d));
    }
}

TEST(Rind, RecordsWhatACommandChanges)
{
    Crust crust(torus(60, 60));
    const Rind before = crust.rind;
    crust.rind.begin_change();
    crust.rind.remove(Face(5));
    const Rind after = crust.rind;
    EXPECT_FALSE(crust.rind.is_replaced());
    Rind::Change change = crust.rind.end_change();
    EXPECT_LT(change.bytes(), 40'000u); // two pages, of 7200 faces
    EXPECT_FALSE(crust.rind == before);
    crust.rind.exchange(change);
    EXPECT_TRUE(crust.rind == before);
    crust.rind.exchange(change);
    EXPECT_TRUE(crust.rind == after);

    crust.rind.begin_change();
    crust.rind = {};
    EXPECT_TRUE(crust.rind.is_replaced());
    crust.rind.roll_back();
    EXPECT_TRUE(crust.rind == after);
}

} // namespace
} // namespace druse
