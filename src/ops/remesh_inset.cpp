// Hart's and Conway's operators with a smaller face inside each face, and meta, which has a point there.
#include "ops/remesh.h"
#include "ops/remesh_points.h"

namespace druse {

namespace {

using namespace remesh;

/// Inner points: the middles of the sides, brought nearer to the middle of the face.
void write_inner_midpoints(const OldMesh& old, double s, Point* to, Progress& progress)
{
    write_inner_points(old, s, [&](std::uint32_t c) { return along(old, c, 0.5); }, to, progress);
}

/// A copy of the face inside it (group 1), joined to it by a quad on each side (2): V + 2E vertices, 5E edges, F + 2E faces.
struct Loft {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.corner[0] = polygon(2, old_vertex, old_vertex(on), corner_point(on), corner_point);
        return s;
    }();

    double s = 0.5;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_inner_points(old, s, [&](std::uint32_t c) { return old.position(c); }, to.corner_point, progress);
    }
};

/// An inner face turned by half a side (group 1), a triangle on each side (2) and in each corner (3): V + 2E vertices, 7E edges, F + 4E
/// faces.
struct Lace {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.corner[0] = polygon(2, old_vertex, old_vertex(on), corner_point);
        s.corner[1] = polygon(3, old_vertex, corner_point, corner_point(back));
        return s;
    }();

    double s = 0.5;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_inner_midpoints(old, s, to.corner_point, progress);
    }
};

/// The same inner points joined to the middle of the face: quads in the corners (group 1), triangles on the sides (2). V + 2E + F
/// vertices, 7E edges, 4E faces.
struct Stake {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex, corner_point, face_point, corner_point(back));
        s.corner[1] = polygon(2, old_vertex, old_vertex(on), corner_point);
        return s;
    }();

    double s = 0.5;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_face_means(old, to.face_point, progress);
        write_inner_midpoints(old, s, to.corner_point, progress);
    }
};

/// Turned faces between points of the sides (group 1), a quad in each corner (2), like the blades of a propeller: V + 2E vertices, 5E
/// edges, F + 2E faces. Source: Hart, *Sculpture based on propellorized polyhedra* (2000).
struct Propeller {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, side_point);
        s.corner[0] = polygon(2, old_vertex, side_point, side_point(back), side_point(back, across));
        return s;
    }();

    double t = 0.333333333333333;
    bool mirror = false;

    void place(const OldMesh& old, const NewPoints& to, Progress&) const
    {
        write_old_vertices(old, to.old_vertex);
        write_side_points(old, t, to.side_point);
    }
};

/// Smaller turned faces (group 1) and a hexagon on each side of each edge (2): V + 4E vertices, 7E edges, F + 2E faces. Source: Hart.
struct Whirl {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.face = polygon(1, corner_point);
        s.corner[0] = polygon(2, old_vertex, side_point, corner_point, corner_point(back), side_point(back), side_point(back, across));
        return s;
    }();

    double t = 0.333333333333333, s = 0.6;
    bool mirror = false;

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_side_points(old, t, to.side_point);
        // In the mirror the side that belongs to a corner is the one before it.
        const auto cut = [&](std::uint32_t c) { return to.side_point[old.side(mirror ? old.around(c) : c)]; };
        write_inner_points(old, s, cut, to.corner_point, progress);
    }
};

/// A triangle on each half of each side, to the middle of the face: those after a vertex are group 1, those before it 2. V + E + F
/// vertices, 6E edges, 4E faces.
struct Meta {
    static constexpr Scheme scheme = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex, edge_point, face_point);
        s.corner[1] = polygon(2, old_vertex(on), face_point, edge_point);
        return s;
    }();

    void place(const OldMesh& old, const NewPoints& to, Progress& progress) const
    {
        write_old_vertices(old, to.old_vertex);
        write_edge_midpoints(old, to.edge_point);
        write_face_means(old, to.face_point, progress);
    }
};

/// Registers an operator whose only parameter is the size of the inner face.
template <class Kernel>
void add_sized(Registry& registry, std::string_view name, std::string_view help)
{
    auto definition = define_remeshing<Kernel>(std::string(name), std::string(help));
    definition.param(&Kernel::s, "s", Unit::ratio, between(0, 1), "size of the inner face, as a fraction")
        .example(std::string(name) + " s=0.4")
        .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(definition));
}

} // namespace

void add_remesh_inset(Registry& registry)
{
    add_sized<Loft>(registry, "remesh.loft", "Put a smaller face inside each face, with a quad on each side");
    add_sized<Lace>(registry, "remesh.lace", "Put a smaller face inside each face, turned, with triangles around it");
    add_sized<Stake>(registry, "remesh.stake", "Put a quad in each corner of each face and a triangle on each side");

    auto propeller = define_remeshing<Propeller>("remesh.propeller", "Turn each face, and put a quad in each corner");
    propeller.param(&Propeller::t, "t", Unit::ratio, between(0, 0.5), "where edges are cut, as a fraction of their length from each end")
        .param(&Propeller::mirror, "mirror", "the other of the two forms that mirror each other")
        .example("remesh.propeller t=0.25")
        .cites("Hart 2000");
    registry.add(complete(propeller));

    auto whirl = define_remeshing<Whirl>("remesh.whirl", "Turn and shrink each face, and put a hexagon on each side of each edge");
    whirl.param(&Whirl::t, "t", Unit::ratio, between(0, 0.5), "where edges are cut, as a fraction of their length from each end")
        .param(&Whirl::s, "s", Unit::ratio, between(0, 1), "size of the inner face, as a fraction")
        .param(&Whirl::mirror, "mirror", "the other of the two forms that mirror each other")
        .example("remesh.whirl s=0.7")
        .cites("Hart 1998");
    registry.add(complete(whirl));

    auto meta = define_remeshing<Meta>("remesh.meta", "Cut each face into triangles, two on each side");
    meta.example("remesh.meta").cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21");
    registry.add(complete(meta));
}

} // namespace druse
