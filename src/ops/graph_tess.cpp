// graph.tess: patches of tessellations of the hyperbolic plane.
#include "graph/tess.h"

#include "dlfl/mesh_builder.h"
#include "ops/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace druse {

/// What lies at the centre of the disk, and of a face the number of its sides, of an edge its slot; −1: the first one.
struct TessCenter {
    Disk::Center what = Disk::Center::face;
    int number = -1;
};

/// A word, after `face` and `edge` also with a number: `face:5`.
template <>
struct ParameterType<TessCenter> {
    static constexpr auto type = Parameter::Type::text;
    static TessCenter parse(std::string_view t, const Domain& d)
    {
        const auto colon = t.find(':');
        const auto at = std::ranges::find(d.words, t.substr(0, colon));
        TessCenter center{static_cast<Disk::Center>(at - d.words.begin())};
        try {
            if (at == d.words.end()) throw CommandError("");
            if (colon == std::string_view::npos) return center;
            const long long number = parse_integer(t.substr(colon + 1));
            if (center.what == Disk::Center::vertex || number < 0 || number > std::numeric_limits<int>::max()) throw CommandError("");
            center.number = static_cast<int>(number);
            return center;
        } catch (const CommandError&) {
            throw CommandError("expected face, face:N, vertex, edge or edge:S");
        }
    }
    static std::string text(const TessCenter& x, const Domain& d)
    {
        const std::string& word = d.words.at(static_cast<std::size_t>(x.what));
        return x.number < 0 ? word : fmt::format("{}:{}", word, x.number);
    }
};

namespace {

struct TessParameters : TessShape {
    TessCenter at;
    std::array<double, 2> shift{0, 0};
    bool faces = false;
};

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
    shape.center = p.at.what;
    shape.center_number = p.at.number;
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
        .param(&P::at, "center", words({"face", "vertex", "edge"}), "what is at the centre: face, face:N (of N sides), vertex, edge or edge:S (in slot S of its vertex)")
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
