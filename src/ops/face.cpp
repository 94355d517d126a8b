// face.start: where a face begins, which decides what groups its extrusion hands out.
#include "ops/face.h"

#include "dlfl/errors.h"
#include "ops/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace druse {

bool start_at(Mesh& mesh, Face f, Vertex v)
{
    for (const Corner c : mesh.corners(f))
        if (mesh.vertex(c) == v) {
            mesh.set_start(c);
            return true;
        }
    return false;
}

void shift_start(Mesh& mesh, Face f, int corners)
{
    const int n = mesh.valence(f);
    mesh.set_start(mesh.corner(f, ((corners % n) + n) % n));
}

void start_toward(Mesh& mesh, Face f, const Vector& direction)
{
    const auto reach = [&](Corner c) { return glm::dot(mesh.position(c), direction); };
    double largest = 0.0; // of the products, so that noise in the last digits breaks no tie
    for (const Corner c : mesh.corners(f)) largest = std::max(largest, std::abs(reach(c)));
    Corner best = mesh.corner(f);
    for (const Corner c : mesh.corners(f))
        if (reach(c) > reach(best) + 1e-12 * largest) best = c;
    mesh.set_start(best);
}

namespace {

struct FaceStart {
    FaceSelector faces;
    std::optional<VertexId> vertex;
    std::optional<int> shift;
    std::optional<Point> toward;
};

void set_starts(Scene& scene, const FaceStart& p, Context&)
{
    const std::vector<Face> faces = p.faces.resolve(scene);
    Mesh& mesh = scene.mesh;
    if (p.vertex) {
        const Vertex v = p.vertex->resolve(mesh);
        bool found = false;
        for (const Face f : faces) found = start_at(mesh, f, v) || found;
        if (!found) throw CommandError(fmt::format("vertex={}: none of the faces has this vertex", v.index));
    } else if (p.shift) {
        for (const Face f : faces) shift_start(mesh, f, *p.shift);
    } else {
        const Vector direction = druse::direction(*p.toward);
        if (direction == Vector(0.0)) throw CommandError("toward=0,0,0: expected a direction, not 0");
        for (const Face f : faces) start_toward(mesh, f, direction);
    }
}

} // namespace

void register_face(Registry& registry)
{
    registry.add(define<FaceStart>("face.start", "Choose the corner at which faces start; exactly one of vertex, shift and toward is given")
                     .param(&FaceStart::faces, "faces", "faces to change")
                     .param(&FaceStart::vertex, "vertex", "the faces that have this vertex start there")
                     .param(&FaceStart::shift, "shift", Unit::count, {-2147483647, 2147483647}, "corners to move on, counter-clockwise")
                     .param(&FaceStart::toward, "toward", "start at the corner farthest in this direction")
                     .exactly_one({"vertex", "shift", "toward"})
                     .example("face.start faces=group:1 toward=0,0,1")
                     .cites("Landreneau 2005, III.4 and III.5")
                     .keeps_euler()
                     .run(set_starts));
}

} // namespace druse
