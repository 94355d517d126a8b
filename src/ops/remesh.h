#pragma once

#include "dlfl/errors.h"
#include "dlfl/mesh_tables.h"
#include "geom/do_both.h"
#include "geom/progress.h"
#include "ops/registry.h"
#include "ops/remesh_again.h"
#include "ops/remesh_old_mesh.h"
#include "ops/remesh_scheme.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace druse {

/// Group ids of the new faces: those of the scheme, those of the old faces, or 0.
enum class RemeshGroups { absolute, keep, none };

namespace remesh {

/// Where a kernel writes the positions of the new vertices, by what they belong to; null where the scheme makes none of a kind.
struct NewPoints {
    Point* old_vertex = nullptr;   // by vertex
    Point* edge_point = nullptr;   // by edge
    Point* side_point = nullptr;   // by side: OldMesh::side(c)
    Point* face_point = nullptr;   // by face
    Point* corner_point = nullptr; // by corner
    Point* outer_point = nullptr;  // by corner
};

/// How the new vertices of a scheme are numbered: kind after kind.
template <const Scheme& scheme>
struct NewVertices {
    std::uint32_t first[kinds];
    std::uint64_t count = 0;

    explicit NewVertices(const OldMesh& old)
    {
        const std::uint32_t counts[kinds] = {old.vertices(), old.edges(), old.corners(), old.faces(), old.corners(), old.corners()};
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            first[kind] = static_cast<std::uint32_t>(count);
            if (makes(scheme, Kind(kind))) count += counts[kind];
        }
    }

    NewPoints points(Point* of_first) const
    {
        const auto at = [&](Kind kind) { return makes(scheme, kind) ? of_first + first[std::size_t(kind)] : nullptr; };
        return {at(Kind::old_vertex), at(Kind::edge_point), at(Kind::side_point), at(Kind::face_point), at(Kind::corner_point), at(Kind::outer_point)};
    }
};

template <Way way, std::size_t... I>
std::uint32_t walk(const OldMesh& old, std::uint32_t c, std::index_sequence<I...>)
{
    ((c = old.take<way.steps[I]>(c)), ...);
    return c;
}

template <Way way>
std::uint32_t walk(const OldMesh& old, std::uint32_t c)
{
    return walk<way>(old, c, std::make_index_sequence<way.size>());
}
/// The side at the end of a way. The sides of an edge are neighbours, so the last step across costs nothing.
template <Way way>
std::uint32_t side_after(const OldMesh& old, std::uint32_t c)
{
    if constexpr (way.size > 0 && way.steps[way.size - 1] == across) return old.side(walk<way.then(across)>(old, c)) ^ 1u;
    else return old.side(walk<way>(old, c));
}

/// Builds what a scheme makes of a mesh: all connectivity, numbering and groups, in one pass over the old corners. Ids and
/// references are sums of counts that the old corners know; nothing is searched.
///
/// New vertices: kept old ones, then those on edges, then those in faces (by face, then by corner). New faces: those from old faces (by
/// face, then by corner), then from edges, then from vertices. Edges: as the faces first use them.
template <const Scheme& scheme>
class Builder {
    static constexpr Links links = find_links(scheme);
    static_assert(links.complete, "a scheme each side of which meets one other");
    static constexpr Uses uses = find_uses(scheme, links);

    // Sizes for each old corner.
    static constexpr std::uint32_t face_part = polygon_of(scheme, face_layout).size, edge_part = polygon_of(scheme, edge_layout).size;
    static constexpr std::uint32_t at_side = size_of(scheme, side_layout, vertex_layout), vertex_part = polygon_of(scheme, vertex_layout).size;
    static_assert(edge_part == 0 || at_side == 0, "either one polygon over each edge or some at each of its sides");

public:
    static constexpr int least_valence = vertex_part > 0 ? 3 : 2;

    Builder(OldMesh& old, RemeshGroups groups, Progress& progress)
        : old_(old), groups_(groups), progress_(progress), corners_(old.corners()), vertices_(old),
          tables_(vertices_.count, std::uint64_t(growth(scheme)) * corners_ / 2, new_faces(old), std::uint64_t(growth(scheme)) * corners_)
    {
    }

    NewPoints points() const { return vertices_.points(tables_.position); }

    /// Everything but the positions.
    void connect()
    {
        if constexpr (vertex_part > 0) old_.order_around(looks_for_places());
        if constexpr (!uses.vertices_known) std::fill_n(tables_.vertex_corner, vertices_.count, Corner());
        const std::uint32_t all = growth(scheme) * corners_;
        auto report = [&, reported = std::uint32_t(0)](std::uint32_t done) mutable {
            if (done - reported < (1u << 17)) return;
            reported = done;
            progress_.step(double(done) / all);
        };
        Cursor at;
        for (std::uint32_t f = 0; f < old_.faces(); ++f) {
            report(at.corner);
            const std::uint32_t begin = old_.begin(f), end = old_.end(f), group = old_group(f);
            if constexpr (face_part > 0) {
                const std::uint32_t start = at.corner;
                for (std::uint32_t c = begin; c < end; ++c) write_part<face_layout>(c, at, c + 1 < end ? at.corner + face_part : start);
                end_face<face_layout>(at, start, group);
            }
            for (std::uint32_t c = begin; c < end; ++c) {
                write_polygon<corner_layout>(c, at, group);
                write_polygon<corner_layout + 1>(c, at, group);
                write_polygon<corner_layout + 2>(c, at, group);
            }
        }
        if constexpr (edge_part + at_side > 0)
            for (std::uint32_t side = 0; side < corners_; side += 2) {
                report(at.corner);
                const std::uint32_t a = old_.corner_of_side(side), b = old_.corner_of_side(side + 1);
                const std::uint32_t group = groups_ == RemeshGroups::keep ? old_group(std::min(old_.face(a), old_.face(b))) : 0;
                if constexpr (edge_part > 0) {
                    const std::uint32_t start = at.corner;
                    write_part<edge_layout>(a, at, start + edge_part);
                    write_part<edge_layout>(b, at, start);
                    end_face<edge_layout>(at, start, group);
                }
                for (const std::uint32_t c : {a, b}) {
                    write_polygon<side_layout>(c, at, group);
                    write_polygon<side_layout + 1>(c, at, group);
                }
            }
        if constexpr (vertex_part > 0)
            for (std::uint32_t i = 0, v = 0; v < old_.vertices(); ++v) {
                report(at.corner);
                const std::uint32_t end = i + old_.valence(v), start = at.corner;
                std::uint32_t face = ~std::uint32_t(0); // the lowest around
                for (; i < end; ++i) {
                    const std::uint32_t c = old_.corner_around(i);
                    if (groups_ == RemeshGroups::keep) face = std::min(face, old_.face(c));
                    write_part<vertex_layout>(c, at, i + 1 < end ? at.corner + vertex_part : start);
                }
                end_face<vertex_layout>(at, start, old_group(face));
            }
    }

    Mesh take() { return tables_.take(); }

private:
    static std::uint64_t new_faces(const OldMesh& old)
    {
        const std::uint64_t at_corners = count_of(scheme, corner_layout, edge_layout) + count_of(scheme, side_layout, vertex_layout);
        return (face_part > 0 ? old.faces() : 0) + at_corners * old.corners() + (edge_part > 0 ? old.edges() : 0) + (vertex_part > 0 ? old.vertices() : 0);
    }

    std::uint32_t old_group(std::uint32_t face) const
    {
        return groups_ == RemeshGroups::keep ? static_cast<std::uint32_t>(old_.group(face)) : 0;
    }

    template <std::size_t layout, std::size_t place>
    std::uint32_t vertex_of(std::uint32_t c) const
    {
        constexpr Name name = polygon_of(scheme, layout).names[place];
        const std::uint32_t first = vertices_.first[std::size_t(name.kind)];
        switch (name.kind) {
        case Kind::old_vertex: return first + old_.vertex(walk<name.way>(old_, c));
        case Kind::edge_point: return first + (side_after<name.way>(old_, c) >> 1);
        case Kind::side_point: return first + side_after<name.way>(old_, c);
        case Kind::face_point: return first + old_.face(walk<name.way>(old_, c));
        default: return first + walk<name.way>(old_, c);
        }
    }

    /// Numbers what each layout has so many of, in the order of the layouts: `count` of a layout for each old corner.
    template <class Count>
    struct Numbering {
        static constexpr std::uint32_t in_face = Count::of(face_layout), in_edge = Count::of(edge_layout);
        static constexpr std::uint32_t in_corners = Count::of(corner_layout) + Count::of(corner_layout + 1) + Count::of(corner_layout + 2);
        static constexpr std::uint32_t at_sides = Count::of(side_layout) + Count::of(side_layout + 1);

        /// The first one that the corner at the end of a way from c has.
        template <std::size_t layout, Way way>
        static std::uint32_t at(const OldMesh& old, std::uint32_t c)
        {
            constexpr auto before = [](std::size_t first) {
                std::uint32_t sum = 0;
                for (std::size_t l = first; l < layout; ++l) sum += Count::of(l);
                return sum;
            };
            const std::uint32_t edges = (in_face + in_corners) * old.corners();
            if constexpr (layout < edge_layout) {
                c = walk<way>(old, c);
                if constexpr (layout == face_layout) return in_corners > 0 ? in_corners * old.begin(old.face(c)) + in_face * c : in_face * c;
                else return (in_face > 0 ? in_face * old.end(old.face(c)) : 0) + in_corners * c + before(corner_layout);
            } else if constexpr (layout == edge_layout) return edges + in_edge * side_after<way>(old, c);
            else if constexpr (layout < vertex_layout) return edges + at_sides * side_after<way>(old, c) + before(side_layout);
            else return edges + (in_edge + at_sides) * old.corners() + Count::of(layout) * old.place_around(walk<way>(old, c));
        }
    };
    struct Corners {
        static constexpr std::uint32_t of(std::size_t layout) { return static_cast<std::uint32_t>(polygon_of(scheme, layout).size); }
    };
    struct FirstUses {
        static constexpr std::uint32_t of(std::size_t layout) { return static_cast<std::uint32_t>(first_uses(uses, scheme, layout)); }
    };

    /// The number of the new corner at a place, seen from the end of a way, and of the edge that it is the first to use.
    template <std::size_t layout, Way way>
    std::uint32_t corner_at(std::uint32_t c, std::uint32_t place) const
    {
        return Numbering<Corners>::template at<layout, way>(old_, c) + place;
    }
    template <std::size_t layout, std::size_t place, Way way>
    std::uint32_t edge_at(std::uint32_t c) const
    {
        return Numbering<FirstUses>::template at<layout, way>(old_, c) + static_cast<std::uint32_t>(first_uses(uses, scheme, layout, place));
    }
    /// New corners and faces are written in the order of their numbers: these are the next ones.
    struct Cursor {
        std::uint32_t corner = 0, face = 0;
    };

    /// Writes one new corner: its vertex, and its edge if it is the first to use it.
    template <std::size_t layout, std::size_t place>
    void write_corner(std::uint32_t c, std::uint32_t made, Face face)
    {
        const std::uint32_t v = vertex_of<layout, place>(c);
        tables_.vertex[made] = Vertex(v);
        tables_.face[made] = face;
        constexpr Use naming = uses.vertex[layout][place];
        if (naming == Use::first || (naming == Use::depends && !tables_.vertex_corner[v].valid())) tables_.vertex_corner[v] = Corner(made);

        constexpr Link link = links.of[layout][place];
        constexpr Use use = uses.edge[layout][place];
        const auto other = [&] { return corner_at<link.layout, link.way>(c, static_cast<std::uint32_t>(link.place)); };
        if constexpr (uses.edges_known && use == Use::later) {
            const std::uint32_t e = edge_at<link.layout, link.place, link.way>(c);
            tables_.edge[made] = Edge(e);
            if constexpr (completes_its_edge(layout, place)) tables_.edge_corners[e][1] = Corner(made);
        } else if (use == Use::later || (use == Use::depends && other() < made)) {
            tables_.edge[made] = tables_.edge[other()];
        } else {
            const std::uint32_t e = edges_++;
            tables_.edge_corners[e][0] = Corner(made);
            if constexpr (!completes_its_edge(link.layout, link.place)) tables_.edge_corners[e][1] = Corner(other());
            tables_.edge[made] = Edge(e);
        }
    }

    /// Whether the second corner of an edge, rather than the first, tells the edge of it: around a vertex, where the first would have to
    /// look for its place.
    static constexpr bool completes_its_edge(std::size_t layout, std::size_t place)
    {
        return uses.edges_known && layout == vertex_layout && uses.edge[layout][place] == Use::later;
    }
    /// Whether some corner asks for the number of one around a vertex.
    static constexpr bool looks_for_places()
    {
        for (std::size_t layout = 0; layout < layouts; ++layout)
            for (std::size_t place = 0; place < polygon_of(scheme, layout).size; ++place)
                if (const Link& link = links.of[layout][place]; link.layout == vertex_layout && !completes_its_edge(link.layout, link.place)) return true;
        return false;
    }

    template <std::size_t layout>
    void end_face(Cursor& at, std::uint32_t start, std::uint32_t kept_group)
    {
        tables_.start[at.face] = Corner(start);
        tables_.group[at.face] = groups_ == RemeshGroups::absolute ? polygon_of(scheme, layout).group : static_cast<std::int32_t>(kept_group);
        ++at.face;
    }

    /// What one old corner adds to a polygon; `after` is the new corner that follows.
    template <std::size_t layout>
    void write_part(std::uint32_t c, Cursor& at, std::uint32_t after)
    {
        constexpr std::uint32_t size = polygon_of(scheme, layout).size;
        const std::uint32_t first = at.corner;
        const Face face(at.face);
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (write_corner<layout, I>(c, first + std::uint32_t(I), face), ...);
            ((tables_.next[first + I] = Corner(I + 1 < size ? first + std::uint32_t(I) + 1 : after)), ...);
        }(std::make_index_sequence<size>());
        for (std::uint32_t i = 1; i < size; ++i) tables_.previous[first + i] = Corner(first + i - 1);
        tables_.previous[after] = Corner(first + size - 1);
        at.corner += size;
    }

    /// A polygon that one old corner has to itself.
    template <std::size_t layout>
    void write_polygon(std::uint32_t c, Cursor& at, std::uint32_t kept_group)
    {
        if constexpr (polygon_of(scheme, layout).size > 0) {
            const std::uint32_t start = at.corner;
            write_part<layout>(c, at, start);
            end_face<layout>(at, start, kept_group);
        }
    }

    OldMesh& old_;
    RemeshGroups groups_;
    Progress& progress_;
    std::uint32_t corners_, edges_ = 0;
    NewVertices<scheme> vertices_;
    MeshTables tables_;
};

/// @throws CommandError `would make N edges, more than 20 million` if N, after `iterations` steps of that growth, is more than 20 million
void refuse_too_large(std::uint64_t edges, std::size_t growth, int iterations);
/// The same where a step adds `n` edges for each of `found` faces with n sides, or vertices with n edges. It makes others with three
/// in their place, so that further steps do nothing unless n is 3.
void refuse_too_large_where(std::uint64_t edges, std::uint32_t n, std::uint64_t found, int iterations);

template <const Scheme& scheme, class Kernel>
Mesh apply_scheme(const Mesh& mesh, const Kernel& kernel, RemeshGroups groups, Progress& progress)
{
    OldMesh old(mesh, Builder<scheme>::least_valence);
    Builder<scheme> builder(old, groups, progress);
    do_both(old.corners() > worth_a_thread, [&] { builder.connect(); }, [&] { kernel.place(old, builder.points(), progress); });
    return builder.take();
}

template <class Kernel>
inline constexpr Scheme mirrored_scheme = mirrored(Kernel::scheme);

/// One step of a kernel: `static constexpr Scheme scheme`, and `void place(const OldMesh&, const NewPoints&, Progress&) const`,
/// which writes the positions. If it has a `bool mirror`, that chooses the mirror image of the scheme.
template <class Kernel>
Mesh apply_once(const Mesh& mesh, const Kernel& kernel, RemeshGroups groups, Progress& progress)
{
    if constexpr (requires { kernel.mirror; })
        if (kernel.mirror) return apply_scheme<mirrored_scheme<Kernel>>(mesh, kernel, groups, progress);
    return apply_scheme<Kernel::scheme>(mesh, kernel, groups, progress);
}

} // namespace remesh

/// Remeshes a closed mesh `iterations` times. Genus, components and orientation stay.
/// @throws CommandError for an open mesh, faces with fewer than 3 sides, valences that the scheme cannot use, or more than 20
/// million edges
template <class Kernel>
Mesh remeshed(const Mesh& mesh, const Kernel& kernel, int iterations, RemeshGroups groups, Progress& progress)
{
    remesh::refuse_too_large(mesh.edge_count(), remesh::growth(Kernel::scheme), iterations);
    Mesh result = remesh::apply_once(mesh, kernel, groups, progress);
    for (int i = 1; i < iterations; ++i) result = remesh::apply_once(result, kernel, groups, progress);
    return result;
}

/// The parameters of a remeshing operator: its kernel's own, and what all of them share.
template <class Kernel>
struct Remeshing : Kernel {
    int iterations = 1;
    RemeshGroups groups = RemeshGroups::absolute;
};

template <class Kernel>
Definition<Remeshing<Kernel>> define_remeshing(std::string name, std::string help)
{
    return define<Remeshing<Kernel>>(std::move(name), std::move(help));
}

namespace remesh {

/// Where faces or vertices are left out, a run is not kept.
template <class P>
bool makes_same_mesh(const P& a, const P& b)
{
    if constexpr (requires { a.only; })
        if (a.only || b.only) return false;
    if constexpr (requires { a.mirror; })
        if (a.mirror != b.mirror) return false;
    return a.iterations == b.iterations && a.groups == b.groups;
}

template <class Kernel, class P>
class KeptRun final : public RemeshAgain {
public:
    KeptRun(const Mesh& mesh, const P& p, Progress& progress) : parameters_(p)
    {
        steps_.push_back(std::make_unique<Step>(Mesh(mesh)));
        for (int i = 1; i < p.iterations; ++i)
            steps_.push_back(std::make_unique<Step>(apply_once<Kernel>(steps_.back()->mesh, p, p.groups, progress)));
    }

    bool place(const void* parameters, std::span<Point> to, Progress& progress) override
    {
        const P& p = *static_cast<const P*>(parameters);
        if (!makes_same_mesh(parameters_, p)) return false;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const OldMesh& old = steps_[i]->old;
            const std::span<Point> made = i + 1 < steps_.size() ? steps_[i + 1]->mesh.write_positions() : to;
            const NewVertices<Kernel::scheme> vertices(old); // the mirror image has them, too
            ASSERT(vertices.count == made.size(), "as many vertices as the scheme makes");
            static_cast<const Kernel&>(p).place(old, vertices.points(made.data()), progress);
        }
        return true;
    }

    std::size_t bytes() const override
    {
        std::size_t sum = sizeof(*this);
        for (const auto& step : steps_) sum += sizeof(Step) + step->mesh.bytes() + step->old.bytes();
        return sum;
    }

private:
    struct Step {
        Mesh mesh;
        OldMesh old;
        explicit Step(Mesh&& m) : mesh(std::move(m)), old(mesh, Builder<Kernel::scheme>::least_valence) {}
    };
    P parameters_;
    std::vector<std::unique_ptr<Step>> steps_; // the meshes that the iterations read
};

template <class Kernel, class P>
std::unique_ptr<RemeshAgain> keep_run_of(const Mesh& mesh, const void* before, const void* now, Progress& progress)
{
    const P& p = *static_cast<const P*>(now);
    if (!makes_same_mesh(*static_cast<const P*>(before), p)) return nullptr;
    return std::make_unique<KeptRun<Kernel, P>>(mesh, p, progress);
}

} // namespace remesh

/// Adds the parameters that all of them share.
template <class P>
void add_shared_parameters(Definition<P>& definition)
{
    definition.param(&P::iterations, "iterations", Unit::count, {1, 20}, "how often")
        .param(&P::groups, "groups", words({"absolute", "keep", "none"}), "group ids: by where a new face comes from, of the old faces, or none");
}

/// Ends a registration begun with define_remeshing: the parameters that all of them share, and what runs.
template <class Kernel>
Operator complete(Definition<Remeshing<Kernel>>& definition)
{
    add_shared_parameters(definition);
    definition.keeps_euler().run([](Scene& scene, const Remeshing<Kernel>& p, Context& context) {
        scene.mesh.replace_with(remeshed<Kernel>(scene.mesh, p, p.iterations, p.groups, context.progress));
        scene.selection.edit() = Selection();
    });
    definition.keeps_runs_by(remesh::keep_run_of<Kernel, Remeshing<Kernel>>);
    return definition;
}

} // namespace druse
