// rind.nest: the model again inside itself, smaller and turned, as the carved balls within balls.
#include "dlfl/measures.h"
#include "dlfl/self_intersections.h"
#include "dlfl/triangulate.h"
#include "geom/triangle_contact.h"
#include "geom/turn.h"
#include "ops/rind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace druse {

namespace {

/// The least distance of a point from a triangle. Source: Ericson 2005, 5.1.5.
double distance_to(const Triangle& t, const Point& p)
{
    const auto& [a, b, c] = t;
    const auto to_side = [&p](const Point& u, const Point& v) {
        const Vector side = v - u;
        const double square = glm::dot(side, side);
        const double at = square > 0 ? std::clamp(glm::dot(p - u, side) / square, 0.0, 1.0) : 0.0;
        return glm::distance(p, u + at * side);
    };
    const double least = std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
    const Vector n = glm::cross(b - a, c - a);
    const double square = glm::dot(n, n);
    if (!(square > 0)) return least;
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        if (glm::dot(glm::cross(v - u, p - u), n) < 0) return least; // it stands beside the triangle
    return std::min(least, std::abs(glm::dot(p - a, n)) / std::sqrt(square));
}

/// How near faces come to a point, and how far vertices go from it.
struct Reach {
    double inner = std::numeric_limits<double>::infinity(), outer = 0;
};

Reach reach(const Mesh& mesh, const Point& center, Progress& progress)
{
    Reach result;
    for (const Vertex v : mesh.vertices()) result.outer = std::max(result.outer, glm::distance(center, mesh.position(v)));
    Triangulator triangulator;
    for (const Face f : mesh.faces()) {
        if (f.index % 4096 == 0) progress.step(0.5 * f.index / mesh.face_limit());
        for (const auto& [a, b, c] : triangulator.triangles(mesh, f))
            result.inner = std::min(result.inner, distance_to({mesh.position(a), mesh.position(b), mesh.position(c)}, center));
    }
    return result;
}

struct Nest {
    int copies = 1;
    OrWord<double> ratio = "auto";
    Point axis{1, 1, 0.3};
    double angle = 30;
    OrWord<Point> center = "volume";
};

void run_nest(Scene& scene, const Nest& p, Context& context)
{
    Mesh& mesh = scene.mesh;
    if (mesh.edge_count() == 0) throw CommandError("there is no surface");
    const Vector axis = direction(p.axis);
    if (axis == Vector(0.0)) throw CommandError("axis=0,0,0: expected a direction, not 0");
    const Point center = shape_center(mesh, p.center);
    const Reach room = reach(mesh, center, context.progress);
    const double fits = room.outer > 0 ? room.inner / room.outer : 0.0;
    if (!p.ratio.word.empty() && !(fits > 1e-12))
        throw CommandError("ratio=auto: the center lies in the surface; give a ratio");
    const double ratio = p.ratio.word.empty() ? p.ratio.value : 0.95 * fits;

    const Mesh shell = mesh;
    const std::uint32_t vertices = mesh.vertex_limit();
    double size = 1;
    for (int copy = 1; copy <= p.copies; ++copy) {
        context.progress.step(0.5 * double(copy) / p.copies);
        size *= ratio;
        const Point2 turn = turn_by_degrees(p.angle * copy);
        mesh.append(shell);
        for (std::uint32_t v = 0; v < vertices; ++v) {
            const Vector d = shell.position(Vertex(v)) - center, along = glm::dot(d, axis) * axis;
            const Vector turned = along + turn.x * (d - along) + turn.y * glm::cross(axis, d);
            mesh.set_position(Vertex(vertices * std::uint32_t(copy) + v), center + size * turned);
        }
    }
    if (ratio <= fits) return;
    const SelfIntersections met = self_intersections(mesh, context.progress);
    if (met.pairs > 0)
        context.note(fmt::format("ratio {:.6g} is more than the {:.6g} that fits however it is turned: {} of triangles cross{}", ratio, fits,
                                 met.pairs == 1 ? "1 pair" : fmt::format("{} pairs", met.pairs), met.pairs == 1 ? "es" : ""));
}

} // namespace

Operator rind_nest_operator()
{
    return define<Nest>("rind.nest", "Put smaller, turned copies of the model inside it, one in the other")
        .param(&Nest::copies, "copies", Unit::count, {1, 100}, "how many")
        .param(&Nest::ratio, "ratio", Unit::ratio, between(0, 1), words({"auto"}), "size of each, relative to the one around it; auto: as large as turns freely")
        .param(&Nest::axis, "axis", "what each is turned about")
        .param(&Nest::angle, "angle", Unit::degrees, {-360, 360}, "how far each is turned from the one around it")
        .param(&Nest::center, "center", words({"vertices", "box", "volume"}), "the point that stays")
        .example("rind.nest copies=2 angle=20 center=box")
        .cites("Özener, Akleman & Srinivasan 2005")
        .run(run_nest);
}

} // namespace druse
