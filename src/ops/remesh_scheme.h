#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

/// The words in which a remeshing scheme says what it makes, and what follows from them at compile time.
///
/// Everything is named from a corner of the old mesh: `edge_point` is the new vertex on the edge that starts there, and
/// `edge_point(back)` the one on the edge before it in the face. A scheme lists polygons of such names; how often each occurs, which
/// sides meet, and where everything is numbered follows from the names alone, for any mesh: also where a face visits a vertex
/// twice, or two edges join the same vertices.
namespace druse::remesh {

/// From a corner to the next or the previous one of its face, or to the corner whose side runs against its own along the same edge.
enum class Step : unsigned char { on, back, across };
inline constexpr Step on = Step::on, back = Step::back, across = Step::across;

/// Steps in order, without any that undoes the one before it; so two ways are the same everywhere if they are equal.
struct Way {
    std::array<Step, 24> steps{};
    std::size_t size = 0;

    constexpr Way then(Step s) const
    {
        Way way = *this;
        const Step undone = s == on ? back : s == back ? on : across;
        if (way.size > 0 && way.steps[way.size - 1] == undone) {
            --way.size;
            way.steps[way.size] = Step{};
        } else {
            way.steps[way.size++] = s;
        }
        return way;
    }
    constexpr Way then(const Way& more) const
    {
        Way way = *this;
        for (std::size_t i = 0; i < more.size; ++i) way = way.then(more.steps[i]);
        return way;
    }
    constexpr Way reversed() const
    {
        Way way;
        for (std::size_t i = size; i > 0; --i) way = way.then(steps[i - 1] == on ? back : steps[i - 1] == back ? on : across);
        return way;
    }
    friend constexpr bool operator==(const Way&, const Way&) = default;
};
/// Counter-clockwise around a vertex, from corner to corner.
inline constexpr Way around_vertex = Way().then(back).then(across);

/// What a new vertex belongs to: the old vertex, edge, side of an edge, or face of a corner, or the corner itself.
enum class Kind : unsigned char { old_vertex, edge_point, side_point, face_point, corner_point, outer_point };
inline constexpr std::size_t kinds = 6;

struct Name {
    Kind kind = Kind::old_vertex;
    Way way;

    /// The same at the corner that these steps lead to.
    template <class... Steps>
    constexpr Name operator()(Steps... steps) const
    {
        Name name = *this;
        ((name.way = name.way.then(steps)), ...);
        return name;
    }
};
inline constexpr Name old_vertex{Kind::old_vertex, {}};
inline constexpr Name edge_point{Kind::edge_point, {}};     // one on each edge
inline constexpr Name side_point{Kind::side_point, {}};     // two on each edge: this one nearer to the corner
inline constexpr Name face_point{Kind::face_point, {}};     // one in each face
inline constexpr Name corner_point{Kind::corner_point, {}}; // in the face, one for each corner
inline constexpr Name outer_point{Kind::outer_point, {}};   // a second one for each corner

/// A polygon, counter-clockwise seen from outside, or what one corner adds to a polygon that several corners make together.
struct Polygon {
    std::array<Name, 6> names{};
    std::size_t size = 0;
    int group = 0;
};
/// Counter-clockwise; begins at the start corner. `group` is the absolute group id.
template <class... Names>
constexpr Polygon polygon(int group, Names... names)
{
    return {{names...}, sizeof...(names), group};
}

/// What a scheme makes of a closed mesh.
struct Scheme {
    Polygon face;                    // inside each old face: one polygon, to which each of its corners adds this
    std::array<Polygon, 3> corner{}; // in each corner of each old face: these polygons
    Polygon edge;                    // over each old edge: one polygon, to which each of its two sides adds this
    std::array<Polygon, 2> side{};   // at each side of each old edge: these polygons
    Polygon vertex;                  // over each old vertex: one polygon, to which each of its corners adds this
};

// --- the mirror image ----------------------------------------------------------------------------------------------------------

/// In a mirror `on` and `back` change places, and the side that ends at a corner is the one that starts there.
constexpr Way mirrored(const Way& way)
{
    Way result;
    for (std::size_t i = 0; i < way.size; ++i) {
        const Step s = way.steps[i];
        result = s == on ? result.then(back) : s == back ? result.then(on) : result.then(back).then(across).then(on);
    }
    return result;
}
constexpr Name mirrored(Name name)
{
    name.way = mirrored(name.way);
    if (name.kind == Kind::edge_point) name.way = name.way.then(back);
    if (name.kind == Kind::side_point) name.way = name.way.then(back).then(across);
    return name;
}
/// `kept` names stay in front, the others run the other way round them; `first` is where the polygon is seen from.
constexpr Polygon mirrored(Polygon p, std::size_t kept, const Way& first = {})
{
    for (Name& name : p.names) {
        name = mirrored(name);
        name.way = first.then(name.way);
    }
    if (p.size > kept) std::reverse(p.names.begin() + kept, p.names.begin() + p.size);
    return p;
}

/// The same on a mesh seen in a mirror. What belongs to a corner belongs to it there too.
constexpr Scheme mirrored(Scheme s)
{
    s.face = mirrored(s.face, 0);
    for (Polygon& p : s.corner) p = mirrored(p, 1);
    s.edge = mirrored(s.edge, 0, Way().then(on));
    for (Polygon& p : s.side) p = mirrored(p, 1, Way().then(on));
    s.vertex = mirrored(s.vertex, 0);
    return s;
}

// --- layouts: where polygons come from, in the order in which faces are numbered --------------------------------------------

inline constexpr std::size_t layouts = 8;
inline constexpr std::size_t face_layout = 0, corner_layout = 1, edge_layout = 4, side_layout = 5, vertex_layout = 7;

constexpr const Polygon& polygon_of(const Scheme& s, std::size_t layout)
{
    return layout == face_layout   ? s.face
           : layout < edge_layout  ? s.corner[layout - corner_layout]
           : layout == edge_layout ? s.edge
           : layout < vertex_layout ? s.side[layout - side_layout]
                                    : s.vertex;
}

/// From a corner to the one that adds the next part of the polygon; no way where a corner has the polygon to itself.
constexpr Way next_part(std::size_t layout)
{
    return layout == face_layout     ? Way().then(on)
           : layout == edge_layout   ? Way().then(across)
           : layout == vertex_layout ? around_vertex
                                     : Way();
}

constexpr std::size_t size_of(const Scheme& s, std::size_t first, std::size_t last)
{
    std::size_t size = 0;
    for (std::size_t i = first; i < last; ++i) size += polygon_of(s, i).size;
    return size;
}
constexpr std::size_t count_of(const Scheme& s, std::size_t first, std::size_t last)
{
    std::size_t count = 0;
    for (std::size_t i = first; i < last; ++i) count += polygon_of(s, i).size > 0 ? 1 : 0;
    return count;
}

/// New corners for each old corner; so many times the edges of the old mesh has the new one.
constexpr std::size_t growth(const Scheme& s) { return size_of(s, 0, layouts); }

constexpr bool makes(const Scheme& s, Kind kind)
{
    for (std::size_t layout = 0; layout < layouts; ++layout)
        for (std::size_t i = 0; i < polygon_of(s, layout).size; ++i)
            if (polygon_of(s, layout).names[i].kind == kind) return true;
    return false;
}

// --- which sides meet -----------------------------------------------------------------------------------------------------------

/// A side of the new mesh, seen from an old corner: in which polygon, at which place in it, and at which old corner.
struct Link {
    std::size_t layout = layouts, place = 0;
    Way way;
};
struct Links {
    std::array<std::array<Link, 6>, layouts> of{};
    bool complete = true; // every side meets exactly one other, and they agree on it
};

/// True if names of this kind at the ends of two ways are the same new vertex, on every mesh.
constexpr bool same(Kind kind, const Way& x, const Way& y)
{
    const Way z = y.reversed().then(x);
    if (z.size == 0) return true;
    const auto only = [&z](Step a, Step b) {
        for (std::size_t i = 0; i < z.size; ++i)
            if (z.steps[i] != (i % 2 == 0 ? a : b)) return false;
        return z.size % 2 == 0 || a == b;
    };
    switch (kind) {
    case Kind::old_vertex: return only(back, across) || only(across, on);
    case Kind::edge_point: return z.size == 1 && z.steps[0] == across;
    case Kind::face_point: return only(on, on) || only(back, back);
    default: return false;
    }
}

struct Side {
    Name from, to;
};
constexpr Side side_at(const Scheme& s, std::size_t layout, std::size_t place)
{
    const Polygon& p = polygon_of(s, layout);
    Name to = p.names[place + 1 < p.size ? place + 1 : 0];
    if (place + 1 == p.size) to.way = next_part(layout).then(to.way);
    return {p.names[place], to};
}

/// All ways of at most four steps, the shorter ones first.
struct ShortWays {
    std::array<Way, 46> ways{};
    constexpr ShortWays()
    {
        std::size_t count = 1;
        for (std::size_t i = 0; i < count && ways[i].size < 4; ++i)
            for (const Step s : {on, back, across})
                if (const Way w = ways[i].then(s); w.size > ways[i].size) ways[count++] = w;
    }
};

constexpr Links find_links(const Scheme& s)
{
    constexpr ShortWays short_ways;
    Links links;
    for (std::size_t layout = 0; layout < layouts; ++layout)
        for (std::size_t place = 0; place < polygon_of(s, layout).size; ++place) {
            const Side side = side_at(s, layout, place);
            std::size_t found = 0;
            for (std::size_t other = 0; other < layouts; ++other)
                for (std::size_t at = 0; at < polygon_of(s, other).size; ++at) {
                    const Side against = side_at(s, other, at);
                    if (against.from.kind != side.to.kind || against.to.kind != side.from.kind) continue;
                    for (const Way& way : short_ways.ways)
                        if (same(side.to.kind, way.then(against.from.way), side.to.way) &&
                            same(side.from.kind, way.then(against.to.way), side.from.way)) {
                            links.of[layout][place] = {other, at, way};
                            ++found;
                        }
                }
            if (found != 1) links.complete = false;
        }
    for (std::size_t layout = 0; layout < layouts && links.complete; ++layout)
        for (std::size_t place = 0; place < polygon_of(s, layout).size; ++place) {
            const Link& link = links.of[layout][place];
            const Link& answer = links.of[link.layout][link.place];
            if (answer.layout != layout || answer.place != place || link.way.then(answer.way).size != 0) links.complete = false;
        }
    return links;
}

// --- which corner is the first to use an edge, or to name a vertex -----------------------------------------------------------------

/// Of the places where something is used: before all others, after another one, or as the mesh has it.
enum class Use : unsigned char { first, later, depends };

struct Uses {
    std::array<std::array<Use, 6>, layouts> edge{}, vertex{}; // by layout and place
    bool edges_known = true, vertices_known = true;           // none depends on the mesh
};

/// Polygons in faces are numbered before those over edges, and these before those over vertices.
constexpr int stage(std::size_t layout) { return layout < edge_layout ? 0 : layout < vertex_layout ? 1 : 2; }
constexpr bool stays_in_face(const Way& way)
{
    for (std::size_t i = 0; i < way.size; ++i)
        if (way.steps[i] == across) return false;
    return true;
}

constexpr Use use_of_edge(std::size_t layout, const Link& link)
{
    if (stage(layout) != stage(link.layout)) return stage(layout) < stage(link.layout) ? Use::first : Use::later;
    // In a face, the polygon inside comes before those in the corners.
    if (stays_in_face(link.way) && (layout == face_layout) != (link.layout == face_layout)) return layout == face_layout ? Use::first : Use::later;
    return Use::depends;
}

constexpr Use use_of_vertex(const Scheme& s, std::size_t layout, std::size_t place)
{
    const Name& name = polygon_of(s, layout).names[place];
    const bool one_each = name.kind == Kind::side_point || name.kind == Kind::corner_point || name.kind == Kind::outer_point;
    std::size_t places = 0, of_faces = 0;
    bool in_faces = true;
    for (std::size_t l = 0; l < layouts; ++l)
        for (std::size_t i = 0; i < polygon_of(s, l).size; ++i) {
            const Name& other = polygon_of(s, l).names[i];
            if (other.kind != name.kind || stage(l) > stage(layout)) continue;
            if (stage(l) < stage(layout)) return Use::later; // every place names all of a kind
            ++places;
            of_faces += l == face_layout ? 1 : 0;
            in_faces = in_faces && stage(l) == 0 && stays_in_face(other.way);
        }
    if (one_each && places == 1) return Use::first;
    if (one_each && in_faces && of_faces == 1) return layout == face_layout ? Use::first : Use::later;
    return Use::depends;
}

constexpr Uses find_uses(const Scheme& s, const Links& links)
{
    Uses uses;
    for (std::size_t layout = 0; layout < layouts; ++layout)
        for (std::size_t place = 0; place < polygon_of(s, layout).size; ++place) {
            uses.edge[layout][place] = use_of_edge(layout, links.of[layout][place]);
            uses.vertex[layout][place] = use_of_vertex(s, layout, place);
            uses.edges_known = uses.edges_known && uses.edge[layout][place] != Use::depends;
            uses.vertices_known = uses.vertices_known && uses.vertex[layout][place] != Use::depends;
        }
    return uses;
}

/// How many places of a layout, before one of them, are the first to use their edge.
constexpr std::size_t first_uses(const Uses& uses, const Scheme& s, std::size_t layout, std::size_t before = 6)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < polygon_of(s, layout).size && i < before; ++i) count += uses.edge[layout][i] == Use::first ? 1 : 0;
    return count;
}

} // namespace druse::remesh
