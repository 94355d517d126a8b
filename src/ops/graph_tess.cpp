// graph.tess: patches of tessellations of the hyperbolic plane.
#include "graph/tess.h"

#include "dlfl/mesh_builder.h"
#include "ops/graph.h"

#include <fmt/format.h>

namespace druse {

namespace {

struct TessParameters : TessShape {
    std::string at = "face";
    std::array<double, 2> shift{0, 0};
    bool faces = false;
};

/// `face`, `face:N`, `vertex`, `edge` or `edge:S`.
void read_tess_center(std::string_view text, TessShape& shape)
{
    const auto colon = text.find(':');
    const std::string_view word = text.substr(0, colon);
    const bool known = word == "face" || word == "edge" || word == "vertex";
    shape.center = word == "face" ? Disk::Center::face : word == "edge" ? Disk::Center::edge : Disk::Center::vertex;
    try {
        if (!known || (word == "vertex" && colon != std::string_view::npos)) throw CommandError("");
        if (colon == std::string_view::npos) return;
        const std::uint32_t number = parse_id(text.substr(colon + 1));
        if (number > 1000) throw CommandError("");
        shape.center_number = static_cast<int>(number);
    } catch (const CommandError&) {
        throw CommandError(fmt::format("center={}: expected face, face:N, vertex, edge or edge:S", text));
    }
}

/// The polygons as a mesh: a disk with an open boundary.
Mesh tess_mesh(const Tess& tess)
{
    MeshBuilder builder;
    builder.reserve(static_cast<std::uint32_t>(tess.graph.vertices.size()), static_cast<std::uint32_t>(tess.polygon_ends.size()),
                    static_cast<std::uint32_t>(tess.polygon_corners.size()));
    for (const Point& p : tess.graph.vertices) builder.add_vertex(p);
    std::uint32_t c = 0;
    for (const std::uint32_t end : tess.polygon_ends) {
        for (; c < end; ++c) builder.add_corner(tess.polygon_corners[c]);
        builder.end_face();
    }
    Repairs repairs;
    return builder.build(repairs);
}

void run_tess(Scene& scene, const TessParameters& p, Context& context)
{
    TessShape shape = p;
    shape.shift_x = p.shift[0];
    shape.shift_y = p.shift[1];
    if (!(shape.shift_x * shape.shift_x + shape.shift_y * shape.shift_y < 1))
        throw CommandError(fmt::format("shift={},{}: expected a point inside the unit disk", shape.shift_x, shape.shift_y));
    read_tess_center(p.at, shape);
    Tess tess = tessellate(shape, p.faces, context.progress);
    if (p.faces && !tess.polygon_ends.empty()) {
        const std::uint32_t first = scene.mesh.face_limit();
        Mesh disk = tess_mesh(tess);
        std::vector<Face> made(disk.face_limit());
        for (std::uint32_t i = 0; i < made.size(); ++i) made[i] = Face(first + i);
        if (scene.mesh.corner_limit() == 0) scene.mesh.replace_with(std::move(disk));
        else scene.mesh.append(disk);
        scene.selection.edit().faces = std::move(made);
    }
    scene.source.replace_with(std::move(tess.graph));
}

} // namespace

Operator graph_tess_operator()
{
    using P = TessParameters;
    return define<P>("graph.tess", "Make a graph of the edges of a tessellation of the hyperbolic plane")
        .param(&P::config, "config", Unit::count, {3, 40}, {3, 12}, "sides of the polygons round every vertex, in order")
        .param(&P::at, "center", "what is at the centre: face, face:N (of N sides), vertex, edge or edge:S (in slot S of its vertex)")
        .param(&P::layers, "layers", Unit::count, {0, 12}, "how often all vertices that are there are completed")
        .param(&P::model, "model", words({"poincare", "klein", "halfplane"}), "Poincaré's disk, Klein's with straight edges, or the upper half-plane")
        .param(&P::turn, "turn", Unit::degrees, {-360, 360}, "turn about the centre")
        .param(&P::shift, "shift", Unit::ratio, {-1, 1}, "point of the unit disk to which the centre is moved")
        .param(&P::arc, "arc", Unit::count, {1, 64}, "straight pieces of each edge, equally long in the hyperbolic plane")
        .param(&P::mirror, "mirror", "the other hand of a chiral tessellation")
        .param(&P::faces, "faces", "add the polygons to the mesh too, as a disk with an open boundary")
        .example("graph.tess config=7,6,6 center=face:7 layers=2")
        .cites("Hart 2009; Anderson 1999; Grünbaum & Shephard 1987")
        .run(run_tess);
}

} // namespace druse
