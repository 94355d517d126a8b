// mesh.*: operators on the whole mesh.
#include "ops/mesh.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "geom/turn.h"
#include "ops/registry.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace druse {

Vector Transform::linear(const Vector& d) const
{
    const Point2 x = turn_by_degrees(rotate.x), y = turn_by_degrees(rotate.y), z = turn_by_degrees(rotate.z);
    Vector v = scale * d;
    v = {v.x, x.x * v.y - x.y * v.z, x.y * v.y + x.x * v.z};
    v = {y.x * v.x + y.y * v.z, v.y, y.x * v.z - y.y * v.x};
    return {z.x * v.x - z.y * v.y, z.y * v.x + z.x * v.y, v.z};
}

void transform(Mesh& mesh, const std::vector<Vertex>& vertices, const Transform& t)
{
    const std::array<Vector, 3> axis{t.linear({1, 0, 0}), t.linear({0, 1, 0}), t.linear({0, 0, 1})};
    const Point origin = t.about + t.move;
    for (const Vertex v : vertices) {
        const Vector d = mesh.position(v) - t.about;
        const Point p = origin + (axis[0] * d.x + axis[1] * d.y + axis[2] * d.z);
        if (!is_in_reach(p)) throw CommandError(fmt::format("vertex {} would lie beyond {}", v.index, largest_coordinate));
        mesh.set_position(v, p);
    }
    if (!t.mirrors()) return;

    std::vector<bool> moved(mesh.vertex_limit(), false);
    for (const Vertex v : vertices) moved[v.index] = true;
    const Components parts = components(mesh);
    std::vector<bool> whole(parts.parts.size(), true);
    for (const Face f : mesh.faces())
        for (const Corner c : mesh.corners(f))
            if (!moved[mesh.vertex(c).index]) whole[parts.of_face[f.index]] = false;
    std::vector<Face> mirrored;
    for (const Face f : mesh.faces())
        if (whole[parts.of_face[f.index]]) mirrored.push_back(f);
    mesh.reverse_components(mirrored);
}

namespace {

struct TransformParameters {
    VertexSelector vertices = VertexSelector::all();
    std::vector<double> scale{1.0};
    std::array<double, 3> rotate{0, 0, 0};
    Point move{0.0};
    OrWord<Point> about = "origin";
};

void run_transform(Scene& scene, const TransformParameters& p, Context&)
{
    if (p.scale.size() == 2) throw CommandError("scale: expected one or three numbers, found 2");
    const std::vector<Vertex> vertices = p.vertices.resolve(scene);
    Transform t;
    t.scale = p.scale.size() == 1 ? Vector(p.scale[0]) : Vector(p.scale[0], p.scale[1], p.scale[2]);
    t.rotate = {p.rotate[0], p.rotate[1], p.rotate[2]};
    t.move = p.move;
    if (p.about.word.empty()) t.about = p.about.value;
    else if (p.about.word == "center") {
        Box box;
        for (const Vertex v : vertices) box.add(scene.mesh.position(v));
        t.about = box.center();
    }
    transform(scene.mesh, vertices, t);
}

} // namespace

void register_mesh(Registry& registry)
{
    using P = TransformParameters;
    registry.add(define<P>("mesh.transform", "Scale, then rotate, then move")
                     .param(&P::vertices, "vertices", "vertices to move")
                     .param(&P::scale, "scale", Unit::ratio, nonzero(), {1, 3}, "one factor, or one each for x, y and z; a mirror image is turned to stay outward")
                     .param(&P::rotate, "rotate", Unit::degrees, {-1e6, 1e6}, "about x, then y, then z")
                     .param(&P::move, "move", "added last")
                     .param(&P::about, "about", words({"origin", "center"}), "the point that scaling and rotating leave in place; center: of the vertices' box")
                     .example("mesh.transform scale=2,1,1 rotate=0,0,45 about=center")
                     .cites("Druse")
                     .keeps_euler()
                     .run(run_transform));
}

} // namespace druse
