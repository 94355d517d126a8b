// rind.crust: a surface and its copy inside, joined by nothing but the table that says which faces belong together.
#include "dlfl/measures.h"
#include "dlfl/mesh_tables.h"
#include "geom/infinity.h"
#include "geom/least_squares.h"
#include "ops/group.h"
#include "ops/pipe.h"
#include "ops/rind.h"
#include "ops/rind_reassembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace druse {

namespace {

constexpr double no_sum = 1e-9; // of unit normals that add up to nothing

Vector normal_of_largest_face(const Mesh& mesh, Vertex v)
{
    Vector largest(0.0);
    for (const Corner c : mesh.around(v)) {
        if (mesh.face(c).is_boundary()) continue;
        const Vector a = area_vector(mesh, mesh.face(c));
        if (glm::dot(a, a) > glm::dot(largest, largest)) largest = a;
    }
    return direction(largest);
}

std::string counted(std::uint64_t n, const char* one, const char* many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

} // namespace

CrustOffsets crust_offsets(const Mesh& mesh, bool uniform, double limit)
{
    CrustOffsets result;
    std::vector<Vector>& sum = result.outward;
    sum.assign(mesh.vertex_limit(), Vector(0.0));
    std::vector<Symmetric3> squares(uniform ? mesh.vertex_limit() : 0);
    for (const Face f : mesh.faces()) {
        const Corner first = mesh.corner(f);
        const Point& p = mesh.position(first);
        Vector n(0.0); // Newell's, as a fan
        for (Corner b = mesh.next(first), c = mesh.next(b); c != first; b = c, c = mesh.next(c)) n += glm::cross(mesh.position(b) - p, mesh.position(c) - p);
        const double square = glm::dot(n, n);
        n = square > 1e-200 && square < 1e200 ? n * (1 / std::sqrt(square)) : direction(n);
        for (const Corner c : mesh.corners(f)) {
            sum[mesh.vertex(c).index] += n;
            if (uniform) squares[mesh.vertex(c).index].add_square(n);
        }
    }
    for (const Vertex v : mesh.vertices()) {
        Vector& d = sum[v.index];
        if (!(glm::dot(d, d) > no_sum * no_sum)) {
            if (mesh.is_point_sphere(v)) continue;
            d = normal_of_largest_face(mesh, v);
            ++(d == Vector(0.0) ? result.still : result.folded);
        } else if (!uniform) {
            d = unit(d);
        } else {
            d = least_squares(squares[v.index], d, 0.02);
            if (const double length = glm::length(d); length > limit) {
                d *= limit / length;
                ++result.limited;
            }
        }
    }
    return result;
}

Point shape_center(const Mesh& mesh, const OrWord<Point>& center)
{
    if (center.word.empty()) return center.value;
    if (center.word == "box") return bounds(mesh).center();
    Point mean(0.0);
    for (const Vertex v : mesh.vertices()) mean += mesh.position(v) / double(mesh.vertex_count());
    if (center.word == "vertices") return mean;
    // Of the tetrahedra between a point and the triangles of each face, fanned from its mean.
    double volume = 0, size = 0;
    Point moment(0.0);
    for (const Face f : mesh.faces()) {
        const Point m = vertex_mean(mesh, f) - mean;
        for (const Corner c : mesh.corners(f)) {
            const Point a = mesh.position(c) - mean, b = mesh.position(mesh.next(c)) - mean;
            const double six = glm::dot(m, glm::cross(a, b));
            volume += six;
            size += std::abs(six);
            moment += 0.25 * six * (m + a + b);
        }
    }
    if (!(std::abs(volume) > 1e-12 * size)) throw CommandError("center=volume: the model encloses no volume");
    return mean + moment / volume;
}

namespace {

/// Boundary faces take part as faces like all others, after the copies: those of the surface, then those of the copy.
void double_open(Scene& scene)
{
    const Mesh& mesh = scene.mesh;
    const Reassembly old(mesh);
    MeshAssembler all;
    old.add_vertices(all);
    old.add_vertices(all);
    old.add_corners(all);
    for (const Corner c : old.corners()) all.add_corner(mesh.vertex_limit() + mesh.vertex(c).index);
    const auto copy = [&old](Corner c) { return old.corner_count() + old.number(c); };
    for (const Edge e : mesh.edges()) all.add_edge(old.number(mesh.corner(e, 0)), old.number(mesh.corner(e, 1)));
    for (const Edge e : mesh.edges()) all.add_edge(copy(mesh.next(mesh.corner(e, 0))), copy(mesh.next(mesh.corner(e, 1))));
    std::vector<std::int32_t> groups;
    const auto add = [&](Face f, int group, bool reversed) {
        const Corner first = mesh.corner(f);
        Corner c = first;
        do {
            all.add_to_face(reversed ? copy(c) : old.number(c));
            c = reversed ? mesh.previous(c) : mesh.next(c);
        } while (c != first);
        all.end_face();
        groups.push_back(group);
    };
    for (const bool reversed : {false, true})
        for (const Face f : mesh.faces()) add(f, mesh.group(f), reversed);
    for (const bool reversed : {false, true})
        for (const Face f : mesh.boundary_faces()) add(f, 0, reversed);
    old.put_in_place(scene, all, groups);
}

} // namespace

std::vector<Face> add_reversed_copy(Scene& scene)
{
    Mesh& mesh = scene.mesh;
    const std::uint32_t boundaries = mesh.boundary_count(), faces = mesh.face_limit();
    if (boundaries == 0) {
        MeshTables::append_reversed(mesh);
        return {};
    }
    double_open(scene);
    std::vector<Face> walls;
    PipeMaker maker(mesh);
    for (std::uint32_t i = 0; i < boundaries; ++i) {
        const Face rim(2 * faces + i), its_copy(2 * faces + boundaries + i);
        maker.create_facing(mesh.corner(rim), mesh.corner(its_copy), walls);
    }
    return walls;
}

// --- the operator -----------------------------------------------------------------------------------------------------------------

namespace {

/// How many closed components of a surface have turned inside out by its move.
/// @param part of each face of the surface, in order; they are the first faces of the mesh. Its vertices are the first as well, then those of the copy.
std::uint32_t count_turned_over(const Mesh& mesh, const Components& parts, std::span<const std::uint32_t> part, std::uint32_t first_moved, std::uint32_t first_still)
{
    std::vector<double> before(parts.parts.size(), 0.0), after(parts.parts.size(), 0.0); // six times their volumes
    const Point origin = bounds(mesh).center();
    std::size_t i = 0;
    for (const Face f : mesh.faces()) {
        if (i == part.size()) break;
        for (const auto& [first, volumes] : {std::pair(first_still, &before), std::pair(first_moved, &after)}) {
            const auto at = [&](Vertex v) { return mesh.position(Vertex(first + v.index)) - origin; };
            Point mean(0.0);
            for (const Corner c : mesh.corners(f)) mean += at(mesh.vertex(c));
            mean /= double(mesh.valence(f));
            for (const Corner c : mesh.corners(f)) (*volumes)[part[i]] += glm::dot(mean, glm::cross(at(mesh.vertex(c)), at(mesh.target(c))));
        }
        ++i;
    }
    std::uint32_t count = 0;
    for (std::size_t k = 0; k < before.size(); ++k)
        if (parts.parts[k].boundary_loops == 0 && before[k] != 0 && !(after[k] / before[k] > 0)) ++count;
    return count;
}

/// What is decided before anything changes: where the vertices of the moved surface go, and which surface that is.
struct Placement {
    std::vector<Point> moved;           // by vertex
    bool outward = false;               // the given surface moves
    std::string beyond;                 // `thickness 2 is more than the safe 0.95`, or empty
    double thickness = 0;               // by=thickness: how thick, 0 or more
    bool chosen = false;                // not as it was given, or not given
    bool may_be_less = false;           // where it crosses itself
};

/// True if the corrected offsets would do where the published ones do not.
bool uniform_helps(const Mesh& mesh, const CrustShape& shape, bool outward, Progress& progress)
{
    if (shape.uniform) return false;
    const bool automatic = !shape.thickness.word.empty();
    const CrustOffsets offsets = crust_offsets(mesh, true, shape.limit);
    const double asked = std::abs(shape.thickness.value);
    const double safe = safe_thickness(mesh, offsets, outward, progress, automatic ? infinity : asked);
    if (!(safe > 0) || (automatic && std::isinf(safe)) || (shape.guard == Guard::error && safe < asked)) return false;
    const double thickness = automatic ? 0.5 * safe : std::min(safe, asked);
    return crust_crossings(mesh, offsets, outward ? -thickness : thickness, progress).pairs == 0;
}

std::string none_is_safe(const Mesh& mesh, const CrustShape& shape, const ThicknessLimit& limit, bool outward, Progress& progress)
{
    return fmt::format("no thickness is safe: {}{}", limit.text(), uniform_helps(mesh, shape, outward, progress) ? "; try uniform=true" : "");
}

Placement place_by_thickness(const Mesh& mesh, const CrustShape& shape, Context& context)
{
    CrustOffsets offsets = crust_offsets(mesh, shape.uniform, shape.limit);
    const bool automatic = !shape.thickness.word.empty();
    double thickness = shape.thickness.value;
    Placement result;
    result.outward = !automatic && thickness < 0;
    result.may_be_less = automatic || shape.guard == Guard::limit;
    if (automatic || shape.guard != Guard::off) {
        const double enough = automatic ? infinity : std::abs(thickness);
        const ThicknessLimit limit = thickness_limit(mesh, offsets, result.outward, context.progress, enough);
        const auto no_thickness = [&] { return none_is_safe(mesh, shape, limit, result.outward, context.progress); };
        if (automatic) {
            if (std::isinf(limit.safe)) throw CommandError("thickness=auto: the surface sets no limit to go by");
            if (!(limit.safe > 0)) throw CommandError("thickness=auto: " + no_thickness());
            thickness = 0.5 * limit.safe;
            result.chosen = true;
        } else if (std::abs(thickness) > limit.safe) {
            const bool none = !(limit.safe > 0);
            result.beyond = fmt::format("thickness {:.6g} is more than the safe {:.6g}", std::abs(thickness), limit.safe);
            if (shape.guard == Guard::error) throw CommandError(none ? no_thickness() : fmt::format("{}: {}", result.beyond, limit.text()));
            if (shape.guard == Guard::limit) {
                if (none) throw CommandError(no_thickness());
                thickness = std::copysign(limit.safe, thickness);
                result.chosen = true;
                result.beyond.clear();
            }
        }
    }
    if (offsets.folded > 0)
        context.note(counted(offsets.folded, "vertex is folded flat: moved square to its largest face", "vertices are folded flat: moved square to their largest faces"));
    if (offsets.still > 0)
        context.note(counted(offsets.still, "vertex has no face with an area: not moved", "vertices have no face with an area: not moved"));
    if (offsets.limited > 0) context.note(counted(offsets.limited, "vertex limited", "vertices limited"));
    result.thickness = std::abs(thickness);
    result.moved = std::move(offsets.outward);
    for (std::uint32_t v = 0; v < mesh.vertex_limit(); ++v) result.moved[v] = mesh.position(Vertex(v)) - thickness * result.moved[v];
    return result;
}

Placement place_by_scale(const Mesh& mesh, const CrustShape& shape)
{
    const Point center = shape_center(mesh, shape.center);
    Placement result;
    result.outward = shape.scale > 1;
    for (const Point& p : mesh.positions()) result.moved.push_back(center + shape.scale * (p - center));
    return result;
}

/// Takes the point spheres of both surfaces away. @return how many there were in the one
std::uint32_t drop_point_spheres(Mesh& mesh)
{
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_limit(); ++v)
        if (mesh.is_point_sphere(Vertex(v))) {
            mesh.delete_vertex(Vertex(v));
            ++count;
        }
    return count / 2;
}

/// Corners and the centres of faces tell when a crust turns over or comes up against a wall; that edges cross before is seen only when it is
/// there. Then the thickness is halved until they do not; where that is of no use, because the surface meets itself
/// without a crust, it stays as it was.
/// @return how often it was halved
int thin_until_apart(Mesh& mesh, std::uint32_t first_moved, const std::vector<Point>& moved, Progress& progress, SelfIntersections& met)
{
    constexpr int most = 20;
    const auto vertices = static_cast<std::uint32_t>(moved.size()), first_still = vertices - first_moved;
    const auto look_at = [&](int halvings) {
        for (std::uint32_t v = 0; v < vertices; ++v) {
            const Point& from = mesh.position(Vertex(first_still + v));
            mesh.set_position(Vertex(first_moved + v), halvings == 0 ? moved[v] : from + std::ldexp(1.0, -halvings) * (moved[v] - from));
        }
        return halvings == 0 ? SelfIntersections() : self_intersections(mesh, progress, 1);
    };
    if (look_at(most).pairs > 0) {
        look_at(0);
        return 0;
    }
    int halvings = 1;
    while (look_at(halvings).pairs > 0) ++halvings;
    met = {};
    return halvings;
}

void run_crust(Scene& scene, const CrustShape& shape, Context& context)
{
    Mesh& mesh = scene.mesh;
    if (shape.by == CrustBy::thickness && shape.thickness.word.empty() && shape.thickness.value == 0) throw CommandError("thickness must not be 0");
    if (shape.by == CrustBy::scale && shape.scale == 1) throw CommandError("scale must not be 1");
    if (mesh.edge_count() == 0) throw CommandError("there is no surface");
    const Placement placement = shape.by == CrustBy::scale ? place_by_scale(mesh, shape) : place_by_thickness(mesh, shape, context);
    const std::uint32_t vertices = mesh.vertex_limit(), faces = mesh.face_limit();
    Components parts;
    std::vector<std::uint32_t> part; // of each face
    if (shape.guard != Guard::off) {
        parts = components(mesh);
        for (const Face f : mesh.faces()) part.push_back(parts.of_face[f.index]);
    }

    const std::vector<Face> rim = add_reversed_copy(scene);
    const std::uint32_t first_moved = placement.outward ? 0 : vertices;
    for (std::uint32_t v = 0; v < vertices; ++v) mesh.set_position(Vertex(first_moved + v), placement.moved[v]);
    if (!rim.empty()) {
        const int group = first_new_group(mesh, 1);
        for (const Face f : rim) mesh.set_group(f, group);
    }
    scene.rind = Rind::of_copies(mesh, faces);

    CrustFaults faults;
    int halvings = 0;
    if (shape.guard != Guard::off) {
        faults.met = self_intersections(mesh, context.progress, CrustFaults::most);
        if (placement.may_be_less && faults.met.pairs > 0) halvings = thin_until_apart(mesh, first_moved, placement.moved, context.progress, faults.met);
        faults.turned_over = count_turned_over(mesh, parts, part, first_moved, vertices - first_moved);
    }
    if (placement.chosen || halvings > 0) {
        const bool given = shape.thickness.word.empty();
        context.note(fmt::format("thickness {}{:.6g}{}", !given ? "" : halvings == 0 ? "reduced to the safe " : "reduced to ",
                                 std::ldexp(placement.thickness, -halvings), halvings == 0 ? "" : ": a thicker one crosses itself"));
    }
    if (faults.any() || !placement.beyond.empty()) {
        const std::string found = faults.any() ? faults.text() : "";
        const std::string text = placement.beyond + (placement.beyond.empty() || found.empty() ? "" : ": ") + found;
        if (shape.guard == Guard::error) {
            const bool at_face = !faults.met.faces.empty() && faults.met.faces[0].index < 2 * faces; // not between walls of a rim only
            throw CommandError(at_face ? fmt::format("{}; look at face {}", text, faults.met.faces[0].index % faces) : text);
        }
        context.note(text);
    }
    if (const std::uint32_t spheres = drop_point_spheres(mesh); spheres > 0)
        context.note(counted(spheres, "point sphere is no surface: left out", "point spheres are no surface: left out"));
}

} // namespace

std::string CrustFaults::text() const
{
    std::string text;
    if (met.pairs >= most) text = fmt::format("{} pairs of triangles or more cross", most);
    else if (met.pairs > 0) text = counted(met.pairs, "pair of triangles crosses", "pairs of triangles cross");
    if (turned_over > 0) text += (text.empty() ? "" : ", ") + counted(turned_over, "surface is turned inside out", "surfaces are turned inside out");
    return text;
}

Operator rind_crust_operator()
{
    using P = CrustShape;
    return define<P>("rind.crust", "Make a crust: a second surface under the first one, to be opened by rind.punch and rind.peel")
        .param(&P::by, "by", words({"thickness", "scale"}), "how the second surface is placed")
        .param(&P::thickness, "thickness", Unit::length, {-1e6, 1e6}, words({"auto"}), "above 0 a copy goes inward, below 0 the given surface goes outward; auto: half of what is safe")
        .only_where("by", {"thickness"})
        .param(&P::uniform, "uniform", "move vertices so that the walls are as thick as asked, not less")
        .only_where("by", {"thickness"})
        .param(&P::limit, "limit", Unit::ratio, {1, 100}, "most a vertex may move with uniform=true, in thicknesses")
        .only_where("by", {"thickness"})
        .param(&P::scale, "scale", Unit::ratio, above(0), "by=scale: below 1 of the copy, above 1 of the given surface")
        .only_where("by", {"scale"})
        .param(&P::center, "center", words({"vertices", "box", "volume"}), "by=scale: the point that stays")
        .only_where("by", {"scale"})
        .param(&P::guard, "guard", words({"warn", "limit", "error", "off"}), "where the crust is thicker than safe, or meets itself: say so, make it thinner, refuse, or do not look")
        .example("rind.crust thickness=0.15 uniform=true")
        .cites("Özener, Akleman & Srinivasan 2005")
        .run(run_crust);
}

} // namespace druse
