#include "dlfl/mesh_assembler.h"

#include "dlfl/errors.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace druse::test {
namespace {

/// Takes a mesh apart into lists and puts it together again.
Mesh reassembled(const Mesh& mesh, Repairs& repairs)
{
    MeshAssembler assembler;
    for (const Vertex v : mesh.vertices()) assembler.add_vertex(mesh.position(v));
    std::vector<std::uint32_t> number(mesh.corner_limit());
    std::vector<std::int32_t> groups;
    const auto add_corners = [&](Face f) {
        for (const Corner c : mesh.corners(f)) {
            number[c.index] = assembler.corner_count();
            assembler.add_corner(mesh.vertex(c).index);
        }
    };
    for (const Face f : mesh.faces()) add_corners(f);
    for (const Face f : mesh.boundary_faces()) add_corners(f);
    for (const Edge e : mesh.edges()) assembler.add_edge(number[mesh.corner(e, 0).index], number[mesh.corner(e, 1).index]);
    const auto add_face = [&](Face f) {
        for (const Corner c : mesh.corners(f)) assembler.add_to_face(number[c.index]);
        assembler.end_face();
        groups.push_back(f.is_boundary() ? 0 : mesh.group(f));
    };
    for (const Face f : mesh.faces()) add_face(f);
    for (const Face f : mesh.boundary_faces()) {
        add_face(f);
        assembler.mark_open(assembler.face_count() - 1);
    }
    return assembler.assemble(groups, repairs);
}

class EveryShapeAssembled : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(MeshAssembler, EveryShapeAssembled, testing::ValuesIn(all_shapes()),
                         shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeAssembled, IsTheSameAgain)
{
    const Mesh mesh = GetParam().make();
    Repairs repairs;
    const Mesh again = reassembled(mesh, repairs);
    EXPECT_SOUND(again);
    EXPECT_EQ(counts(again), counts(mesh));
    EXPECT_EQ(again.boundary_count(), mesh.boundary_count());
    EXPECT_EQ(rings(again), rings(mesh));
    EXPECT_EQ(genus(again), genus(mesh));
    EXPECT_TRUE(repairs.notes().empty());
    for (const Face f : mesh.faces()) EXPECT_EQ(again.group(f), mesh.group(f));
    Repairs none;
    EXPECT_TRUE(reassembled(again, none) == again);
}

std::string error_of(void (*build)(MeshAssembler&))
{
    MeshAssembler assembler;
    for (int i = 0; i < 3; ++i) assembler.add_vertex({i, 0, 0});
    for (const std::uint32_t v : {0u, 1u, 2u, 1u, 0u, 2u}) assembler.add_corner(v);
    try {
        build(assembler);
        Repairs repairs;
        assembler.assemble(std::vector<std::int32_t>(assembler.face_count()), repairs);
    } catch (const CommandError& error) {
        return error.what();
    }
    return "no error";
}

void add_faces(MeshAssembler& a)
{
    for (const std::uint32_t c : {0u, 1u, 2u}) a.add_to_face(c);
    a.end_face();
    for (const std::uint32_t c : {3u, 4u, 5u}) a.add_to_face(c);
    a.end_face();
}

TEST(MeshAssembler, SaysWhatContradictsWhat)
{
    EXPECT_EQ(error_of([](MeshAssembler& a) { a.add_corner(3); }), "corner names vertex 3, there are 3");
    EXPECT_EQ(error_of([](MeshAssembler& a) { a.add_edge(0, 6); }), "edge names corner 6, there are 6");
    EXPECT_EQ(error_of([](MeshAssembler& a) { a.add_edge(2, 2); }), "edge names corner 2 twice");
    EXPECT_EQ(error_of([](MeshAssembler& a) { a.add_to_face(6); }), "face names corner 6, there are 6");
    EXPECT_EQ(error_of([](MeshAssembler& a) { a.end_face(); }), "a face without corners");
    EXPECT_EQ(error_of([](MeshAssembler& a) { a.mark_open(0); }), "open names face 0, there are 0");
    EXPECT_EQ(error_of([](MeshAssembler& a) {
                  add_faces(a);
                  a.add_edge(0, 4);
              }),
              "the sides at corners 0 and 4 do not run against each other, as edge 0 says");
    EXPECT_EQ(error_of(&add_faces), "no error"); // two open triangles
}

TEST(MeshAssembler, ClosesEachOpenTriangleForItself)
{
    MeshAssembler assembler;
    for (int i = 0; i < 3; ++i) assembler.add_vertex({i, i * i, 0});
    for (const std::uint32_t v : {0u, 1u, 2u, 1u, 0u, 2u}) assembler.add_corner(v);
    add_faces(assembler);
    Repairs repairs;
    const Mesh mesh = assembler.assemble(std::vector<std::int32_t>{4, 0}, repairs);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{6, 6, 2}));
    EXPECT_EQ(mesh.boundary_count(), 2u);
    EXPECT_EQ(mesh.group(Face(0)), 4);
    EXPECT_EQ(repairs.vertices_split, 3u);
    EXPECT_EQ(repairs.boundary_edges, 6u);
    EXPECT_EQ(repairs.boundary_loops, 2u);
}

} // namespace
} // namespace druse::test
