// Pentagons: Conway's gyro with its dual snub, which both come in a left and a right form, and quinto.
#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

namespace {

using namespace remesh;

/// A pentagon in each corner: V + 2E + F vertices, 5E edges, 2E faces. Every edge is cut twice, at the fraction `t` from its ends; the
/// middle of a face is joined to the first of the two cuts on each of its sides, in the mirror image to the second. These cuts then
/// move the fraction `offset` of the way to the middle.
/// Source: Akleman, Srinivasan, Melek & Edmundson, *Semi-regular pentagonal subdivisions* (2004); Conway's gyro.
struct Pentagonal {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex, side_point, face_point, side_point(back), side_point(back, across));
        return s;
    }();

    double t = 0.333333333333333, offset = 0;
    bool mirror = false;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_side_points(old, t, to.side_point);
        for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
            const Point center = to.face_point[f] = mean(old, f);
            for (std::uint32_t c = begin; c < end; ++c) {
                Point& joined = to.side_point[old.side(mirror ? old.across(c) : c)];
                joined += offset * (center - joined);
            }
        });
    }
};

/// The dual of gyro: faces shrink and turn (group 1), two triangles open on each edge (2), a face on each vertex (3). 2E vertices, 5E
/// edges, V + 2E + F faces; every new vertex has five edges. Source: Conway.
struct Snub {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.side[0] = polygon(2, corner_point(on), corner_point, corner_point(across, on));
        s.vertex = polygon(3, corner_point);
        return s;
    }();

    double t = 0.333333333333333;
    bool mirror = false;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
            const Point center = mean(old, f);
            for (std::uint32_t c = begin; c < end; ++c) {
                const std::uint32_t before = old.back(c);
                const Point cuts = along(old, c, t) + along(old, old.across(before), t) + (mirror ? along(old, old.across(c), t) : along(old, before, t));
                to.corner_point[c] = 0.2 * (old.position(c) + center + cuts);
            }
        });
    }
};

/// A smaller face between the middles of the sides (group 1), and a pentagon in each corner (2): V + 3E vertices, 6E edges, F + 2E
/// faces. Source: as for gyro, and TopMod; Conway's quinto.
struct PentagonPreserving {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.corner[0] = polygon(2, old_vertex, edge_point, corner_point, corner_point(back), edge_point(back));
        return s;
    }();

    double s = 0.75;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_edge_midpoints(old, to.edge_point);
        write_inner_points(old, s, [&](std::uint32_t c) { return to.edge_point[old.edge(c)]; }, to.corner_point, progress);
    }
};

} // namespace

void add_remesh_pentagonal(Registry& registry)
{
    auto pentagonal = define_remeshing<Pentagonal>("remesh.pentagonal", "Make a pentagon in each corner");
    pentagonal.param(&Pentagonal::t, "t", Unit::ratio, between(0, 0.5), "where edges are cut, as a fraction of their length from each end")
        .param(&Pentagonal::offset, "offset", Unit::ratio, {0, 1}, "how far the cuts move towards the middles of the faces")
        .param(&Pentagonal::mirror, "mirror", "the other of the two forms that mirror each other")
        .alias("remesh.gyro")
        .example("remesh.pentagonal t=0.3 offset=0.1")
        .cites("Akleman, Srinivasan, Melek & Edmundson 2004; Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(pentagonal));

    auto preserving = define_remeshing<PentagonPreserving>("remesh.pentagon_preserving", "Make a smaller face inside, and a pentagon in each corner");
    preserving.param(&PentagonPreserving::s, "s", Unit::ratio, between(0, 1), "size of the inner face, as a fraction")
        .alias("remesh.quinto")
        .example("remesh.pentagon_preserving s=0.6")
        .cites("Akleman, Srinivasan, Melek & Edmundson 2004");
    registry.add(complete(preserving));

    auto snubbed = define_remeshing<Snub>("remesh.snub", "Shrink and turn the faces, and open two triangles on every edge and a face on every vertex");
    snubbed.param(&Snub::t, "t", Unit::ratio, between(0, 0.5), "of the pentagons between whose middles the edges run")
        .param(&Snub::mirror, "mirror", "the other of the two forms that mirror each other")
        .example("remesh.snub")
        .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(snubbed));
}

} // namespace druse
