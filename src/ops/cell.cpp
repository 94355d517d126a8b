// cell.*: tiles that fill space by translations. Here what all of them share, cell.new, cell.skew, solids and questions.
#include "ops/cell.h"

#include "cell/cell_assembly.h"
#include "cell/cell_check.h"
#include "dlfl/self_intersections.h"
#include "ops/registry.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace druse {

const CellTile& cell_of(const Scene& scene) { return held<CellTile>(scene.source, "cell", "cell.new makes one"); }

namespace {

struct CellNew {
    CellKind cell = CellKind::bcc;
    double size = 1;
    std::optional<double> height;
};

enum class MatrixEntry { xx, xy, xz, yx, yy, yz, zx, zy, zz };

struct CellSkew {
    std::optional<std::array<double, 9>> matrix;
    std::optional<MatrixEntry> entry;
    std::optional<double> value;
    bool reset = false;
};

void run_cell_skew(Scene& scene, const CellSkew& p, Context& context)
{
    CellMatrix matrix = p.matrix ? *p.matrix : p.entry ? cell_of(scene).matrix() : CellMatrix{1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (p.entry.has_value() != p.value.has_value()) throw CommandError("entry= and value= are given together");
    if (!p.matrix && !p.entry && !p.reset) throw CommandError("reset=false changes nothing");
    if (p.entry) matrix[static_cast<std::size_t>(*p.entry)] = *p.value;
    edit_cell(scene, context, [&](CellTile& cell) { cell.set_matrix(matrix); });
}

/// What cell.solid and cell.assemble have in common.
struct CellBody {
    double clearance = 0;
    CellJoint method = CellJoint::inset;
};

struct CellSolidParameters : CellBody {};

struct CellAssemble : CellBody {
    int shells = 1;
    double shrink = 1;
    CellColour color = CellColour::type;
};

/// Tells of joints that are narrower than asked for, where they can be measured.
void look_at_joints(const CellTile& tile, const CellSolid& solid, double clearance, Context& context)
{
    try {
        if (const auto narrow = narrow_joints(tile, solid, clearance, context.progress)) context.note(*narrow);
    } catch (const CommandError& error) {
        context.note(fmt::format("the joints were not measured: {}", error.what()));
    }
}

/// Tells of a cell that meets itself, and so its neighbours. With joints that is refused: who asks for them prints.
void look_at_contacts(const CellTile& tile, const CellBody& body, Context& context)
{
    MeshBuilder builder;
    const CellSolid solid = make_solid(tile, body.clearance, body.method);
    add_solid(builder, solid, std::array{0});
    const SelfIntersections met = self_intersections(builder.build(), context.progress);
    if (met.pairs == 0) {
        if (body.clearance > 0) look_at_joints(tile, solid, body.clearance, context);
        return;
    }
    const std::string what = fmt::format("the cell meets its neighbours in {} pair{} of triangles; cell.check says where", met.pairs, met.pairs == 1 ? "" : "s");
    if (body.clearance > 0) throw CellRefusal(CellRefusal::Reason::pierced, what);
    context.note(what);
}

void put_cells(Scene& scene, MeshBuilder& builder)
{
    scene.mesh.replace_with(builder.build());
    scene.selection = Selection();
}

void run_cell_solid(Scene& scene, const CellSolidParameters& p, Context& context)
{
    const CellTile& cell = cell_of(scene);
    look_at_contacts(cell, p, context);
    MeshBuilder builder;
    add_solid(builder, make_solid(cell, p.clearance, p.method), pane_groups(cell));
    put_cells(scene, builder);
}

void run_cell_assemble(Scene& scene, const CellAssemble& p, Context& context)
{
    const CellTile& cell = cell_of(scene);
    look_at_contacts(cell, p, context);
    MeshBuilder builder;
    assemble(builder, cell, {p.shells, p.shrink, p.color, p.clearance, p.method}, context.progress);
    put_cells(scene, builder);
}

struct CellCheckParameters : CellBody {
    bool strict = false;
};

nlohmann::ordered_json vector_json(const Vector& v) { return nlohmann::ordered_json::array({v.x, v.y, v.z}); }

void run_cell_check(Scene& scene, const CellCheckParameters& p, Context& context)
{
    const CellTile& cell = cell_of(scene);
    const CellCheck found = check(cell, {p.clearance, p.method, true}, context.progress);
    nlohmann::ordered_json json;
    json["sound"] = found.sound();
    json["faults"] = found.faults;
    json["cell"] = name(cell.cell().kind);
    json["volume"] = found.volume;
    json["volume_expected"] = found.volume_expected;
    json["pane_mismatch"] = found.pane_mismatch;
    json["vertices"] = found.vertices;
    json["edges"] = found.edges;
    json["faces"] = found.faces;
    json["components"] = found.components;
    json["genus"] = found.genus;
    json["self_intersections"] = found.self_intersections;
    json["pierced"] = nlohmann::ordered_json::array();
    for (const CellCheck::Pierced& pane : found.pierced) {
        const Vector step = cell.world(cell.cell().at(pane.neighbour));
        json["pierced"].push_back({{"pane", pane.side.pane}, {"far", pane.side.far}, {"neighbour", vector_json(step)}, {"triangles", pane.triangles}});
    }
    json["free"] = nlohmann::ordered_json::array();
    for (const Vector& direction : found.free) json["free"].push_back(vector_json(direction));
    json["interlocked"] = found.self_intersections == 0 ? nlohmann::ordered_json(found.free.empty()) : nlohmann::ordered_json(nullptr);
    if (found.has_clearance) {
        json["clearance"] = found.vanishes ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(found.clearance);
        json["volume_left"] = found.volume_left;
    }
    context.output = json.dump();
    context.failed = p.strict && !found.sound();
}

template <class P>
void add_cell_body(Definition<P>& definition)
{
    definition.param(&P::clearance, "clearance", Unit::length, at_least(0), "width of the joints between cells; 0: none")
        .param(&P::method, "method", words({"inset", "shrink"}), "move the surface inside, or scale the cell about its centre of mass, which is uneven");
}

} // namespace

Operator cell_new_operator()
{
    return define<CellNew>("cell.new", "Make a cell that fills space by translations, with flat panes")
        .param(&CellNew::cell, "cell", words({"bcc", "fcc", "cube", "hexprism", "elongated"}),
               "truncated octahedron, rhombic dodecahedron, cube, hexagonal prism or elongated dodecahedron")
        .param(&CellNew::size, "size", Unit::length, above(0), "how wide it is along x")
        .param(&CellNew::height, "height", Unit::length, above(0), "of a prism; unset, as its size")
        .only_where("cell", {"hexprism"})
        .keeps_euler()
        .example("cell.new cell=fcc size=20")
        .cites("Howison & Séquin 2009, section 3")
        .run([](Scene& scene, const CellNew& p, Context&) { scene.source.replace_with(CellTile::of_kind(p.cell, p.size, p.height)); });
}

Operator cell_skew_operator()
{
    return define<CellSkew>("cell.skew", "Scale and shear the cell with the whole lattice, by a matrix that is kept apart")
        .param(&CellSkew::matrix, "matrix", Unit::ratio, {}, "nine numbers, row by row")
        .param(&CellSkew::entry, "entry", words({"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"}), "or one of them: its row and column")
        .param(&CellSkew::value, "value", Unit::ratio, {}, "what that becomes")
        .param(&CellSkew::reset, "reset", "back to no skew")
        .exactly_one({"matrix", "entry", "reset"})
        .keeps_euler()
        .example("cell.skew entry=xy value=0.3")
        .cites("Howison & Séquin 2009, section 3.2")
        .run(run_cell_skew);
}

Operator cell_solid_operator()
{
    Definition<CellSolidParameters> definition("cell.solid", "Make the solid cell; groups are its panes, those of a pair alike");
    add_cell_body(definition);
    return definition.example("cell.solid").cites("Howison & Séquin 2009, section 3").run(run_cell_solid);
}

Operator cell_assemble_operator()
{
    using P = CellAssemble;
    Definition<P> definition("cell.assemble", "Make the cell with those around it");
    definition.param(&P::shells, "shells", Unit::count, {0, 3}, "how many times around; the first shell are those that share a pane")
        .param(&P::shrink, "shrink", Unit::ratio, Range{0, 1, true, false, false}, "by which each is scaled about its centre of mass")
        .param(&P::color, "color", words({"type", "layer", "aspect"}), "what groups tell apart: neighbours, layers of one height, or nothing");
    add_cell_body(definition);
    return definition.example("cell.assemble shells=1 shrink=0.9").cites("Howison & Séquin 2009, section 3.2").run(run_cell_assemble);
}

Operator cell_check_operator()
{
    using P = CellCheckParameters;
    Definition<P> definition("cell.check", "Say whether copies of the cell fill space, and in which directions one leaves the others");
    definition.param(&P::strict, "strict", "fail where anything is wrong");
    add_cell_body(definition);
    return definition.keeps_euler().example("cell.check strict=true").cites("Howison & Séquin 2009, section 3").query().run(run_cell_check);
}

void register_cell(Registry& registry)
{
    for (const auto& make : {cell_new_operator, cell_point_add_operator, cell_point_move_operator, cell_point_remove_operator, cell_edge_add_operator,
                             cell_edge_remove_operator, cell_constrain_operator, cell_unconstrain_operator, cell_refine_operator, cell_shape_operator,
                             cell_move_operator, cell_split_operator, cell_split_edge_operator, cell_flip_operator, cell_rollback_operator, cell_skew_operator,
                             cell_solid_operator, cell_assemble_operator, cell_check_operator})
        registry.add(make());
}

} // namespace druse
