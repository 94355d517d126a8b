#include "ops/selector.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace druse {

namespace {

using TermKind = SelectorTerm::Kind;

template <class H>
constexpr bool is_face = std::is_same_v<H, Face>;
template <class H>
constexpr bool is_edge = std::is_same_v<H, Edge>;
template <class H>
constexpr const char* one = is_face<H> ? "face" : is_edge<H> ? "edge" : "vertex";
template <class H>
constexpr const char* many = is_face<H> ? "faces" : is_edge<H> ? "edges" : "vertices";
template <class H>
constexpr const char* grammar = is_face<H>   ? "expected all, none, selected, ids like 0,4,7-9, group:3, sides:5, component:0, normal:x,y,z,angle, strut:4 or ball:9, joined by +"
                                : is_edge<H> ? "expected all, none, selected, ids like 0,4,7-9 or end vertices like 4~9, joined by +"
                                             : "expected all, none, selected, ids like 0,4,7-9 or valence:3, joined by +";

template <class H>
SelectorTerm parse_term(std::string_view text)
{
    SelectorTerm term;
    if (text == "all") term.kind = TermKind::all;
    else if (text == "none") term.kind = TermKind::none;
    else if (text == "selected") term.kind = TermKind::selected;
    else if (const auto colon = text.find(':'); colon != std::string_view::npos) {
        const std::string_view key = text.substr(0, colon), value = text.substr(colon + 1);
        if (is_face<H> && key == "normal") {
            const auto pieces = split(value, ',');
            if (pieces.size() != 4) throw CommandError(grammar<H>);
            term.kind = TermKind::normal;
            term.direction = {parse_number(pieces[0]), parse_number(pieces[1]), parse_number(pieces[2])};
            term.angle = parse_number(pieces[3]);
            if (direction(term.direction) == Vector(0.0) || term.angle < 0.0 || term.angle > 180.0)
                throw CommandError("expected normal:x,y,z,angle with a direction and an angle of 0 to 180 degrees");
            return term;
        }
        if (is_face<H> && key == "group") term.kind = TermKind::group;
        else if (is_face<H> && key == "sides") term.kind = TermKind::sides;
        else if (is_face<H> && key == "component") term.kind = TermKind::component;
        else if (is_face<H> && key == "strut") term.kind = TermKind::strut;
        else if (is_face<H> && key == "ball") term.kind = TermKind::ball;
        else if (!is_face<H> && !is_edge<H> && key == "valence") term.kind = TermKind::valence;
        else throw CommandError(grammar<H>);
        term.number = parse_id(value);
    } else if (const auto tilde = text.find('~'); is_edge<H> && tilde != std::string_view::npos) {
        term.kind = TermKind::ends;
        for (const std::string_view piece : split(text, ',')) {
            const auto at = piece.find('~');
            if (at == std::string_view::npos) throw CommandError(grammar<H>);
            term.ids.push_back({parse_id(piece.substr(0, at)), parse_id(piece.substr(at + 1))});
        }
    } else {
        term.kind = TermKind::ids;
        if (text.empty()) throw CommandError(grammar<H>);
        for (const std::string_view piece : split(text, ',')) {
            const auto dash = piece.find('-');
            const std::uint32_t first = parse_id(piece.substr(0, dash));
            const std::uint32_t last = dash == std::string_view::npos ? first : parse_id(piece.substr(dash + 1));
            if (last < first) throw CommandError(fmt::format("expected {} ids that ascend, found {}", one<H>, piece));
            term.ids.push_back({first, last});
        }
    }
    return term;
}

template <class H>
std::string term_text(const SelectorTerm& term)
{
    const auto ids = [&term](char between) {
        std::string text;
        for (const auto& r : term.ids) {
            if (!text.empty()) text += ',';
            text += r.first == r.last && between == '-' ? std::to_string(r.first) : fmt::format("{}{}{}", r.first, between, r.last);
        }
        return text;
    };
    switch (term.kind) {
    case TermKind::all: return "all";
    case TermKind::none: return "none";
    case TermKind::selected: return "selected";
    case TermKind::ids: return ids('-');
    case TermKind::ends: return ids('~');
    case TermKind::group: return fmt::format("group:{}", term.number);
    case TermKind::sides: return fmt::format("sides:{}", term.number);
    case TermKind::component: return fmt::format("component:{}", term.number);
    case TermKind::strut: return fmt::format("strut:{}", term.number);
    case TermKind::ball: return fmt::format("ball:{}", term.number);
    case TermKind::valence: return fmt::format("valence:{}", term.number);
    case TermKind::normal:
        return fmt::format("normal:{},{},{},{}", number_text(term.direction.x), number_text(term.direction.y), number_text(term.direction.z),
                           number_text(term.angle));
    }
    return {};
}

template <class H>
std::uint32_t count(const Mesh& mesh)
{
    return is_face<H> ? mesh.face_limit() : is_edge<H> ? mesh.edge_limit() : mesh.vertex_limit();
}

template <class H>
[[noreturn]] void not_there(std::uint32_t id, std::uint32_t limit)
{
    if (limit == 0) throw CommandError(fmt::format("there is no {} {}: the mesh has no {}", one<H>, id, many<H>));
    throw CommandError(fmt::format("there is no {} {}: the {} are 0 to {}", one<H>, id, many<H>, limit - 1));
}

Edge edge_between(const Mesh& mesh, std::uint32_t a, std::uint32_t b)
{
    for (const std::uint32_t v : {a, b})
        if (v >= mesh.vertex_limit()) not_there<Vertex>(v, mesh.vertex_limit());
    Edge best;
    if (!mesh.is_point_sphere(Vertex(a)))
        for (const Corner c : mesh.around(Vertex(a)))
            if (mesh.target(c) == Vertex(b)) best = std::min(best, mesh.edge(c));
    if (!best.valid()) throw CommandError(fmt::format("no edge joins vertices {} and {}", a, b));
    return best;
}

template <class H, class Test>
void add_where(const Mesh& mesh, std::vector<H>& result, Test&& test)
{
    for (std::uint32_t i = 0; i < count<H>(mesh); ++i)
        if (test(H(i))) result.push_back(H(i));
}

template <class H>
const std::vector<H>& selected(const Selection& selection)
{
    if constexpr (is_face<H>) return selection.faces;
    else if constexpr (is_edge<H>) return selection.edges;
    else return selection.vertices;
}

template <class H>
void add_term(const Scene& scene, const SelectorTerm& term, std::vector<H>& result)
{
    const Mesh& mesh = scene.mesh;
    switch (term.kind) {
    case TermKind::all: add_where(mesh, result, [](H) { return true; }); return;
    case TermKind::none: return;
    case TermKind::selected: {
        const auto& list = selected<H>(*scene.selection);
        if (list.empty()) throw CommandError(fmt::format("no {} are selected", many<H>));
        result.insert(result.end(), list.begin(), list.end());
        return;
    }
    case TermKind::ids: {
        for (const auto& [first, last] : term.ids)
            if (last >= count<H>(mesh)) not_there<H>(std::max(first, count<H>(mesh)), count<H>(mesh));
        std::vector<SelectorTerm::Range> ranges = term.ids;
        std::ranges::sort(ranges, {}, &SelectorTerm::Range::first);
        std::uint32_t next = 0; // ids below it are in
        for (const auto& [first, last] : ranges) {
            for (std::uint32_t i = std::max(first, next); i <= last; ++i) result.push_back(H(i));
            next = std::max(next, last + 1);
        }
        return;
    }
    case TermKind::ends:
        if constexpr (is_edge<H>)
            for (const auto& [a, b] : term.ids) result.push_back(edge_between(mesh, a, b));
        return;
    default: break;
    }
    if constexpr (is_face<H>) {
        const std::size_t before = result.size();
        if (term.kind == TermKind::group) {
            add_where(mesh, result, [&](Face f) { return mesh.group(f) == term.number; });
            if (result.size() == before) throw CommandError(fmt::format("no face has group {}", term.number));
        } else if (term.kind == TermKind::sides) {
            add_where(mesh, result, [&](Face f) { return mesh.valence(f) == term.number; });
        } else if (term.kind == TermKind::component) {
            const Components parts = components(mesh);
            if (std::size_t(term.number) >= parts.parts.size())
                throw CommandError(fmt::format("there is no component {}: the mesh has {}", term.number, parts.parts.size()));
            add_where(mesh, result, [&](Face f) { return parts.of_face[f.index] == term.number; });
        } else if (term.kind == TermKind::strut || term.kind == TermKind::ball) {
            const Graph* graph = std::get_if<Graph>(&*scene.source);
            const auto id = static_cast<std::uint32_t>(term.number);
            std::vector<Face> faces;
            if (graph) faces = term.kind == TermKind::strut ? graph->struts.strut(mesh, id) : graph->struts.ball(mesh, id);
            if (faces.empty()) throw CommandError(fmt::format("no faces are known to be the {} of the graph", term_text<H>(term)));
            result.insert(result.end(), faces.begin(), faces.end());
        } else {
            // The angle between unit vectors from their difference and sum: exact at 0 and 180 degrees, where acos is not.
            const Vector direction = druse::direction(term.direction);
            add_where(mesh, result, [&](Face f) {
                const Vector normal = unit_normal(mesh, f);
                if (glm::dot(normal, normal) == 0.0) return false;
                const double angle = 2.0 * std::atan2(glm::length(normal - direction), glm::length(normal + direction));
                return angle * 57.29577951308232 <= term.angle + 1e-9;
            });
        }
    } else if constexpr (!is_edge<H>) {
        add_where(mesh, result, [&](Vertex v) { return mesh.valence(v) == term.number; });
    }
}

} // namespace

template <class H>
Selector<H> Selector<H>::parse(std::string_view text)
{
    Selector result;
    result.terms_.clear();
    for (const std::string_view piece : split(text, '+')) {
        try {
            result.terms_.push_back(parse_term<H>(piece));
        } catch (const CommandError& e) {
            // Whatever was wrong with a number inside, what helps is the grammar.
            const std::string_view what = e.what();
            if (what == "expected a number" || what.starts_with("expected an id")) throw CommandError(grammar<H>);
            throw;
        }
    }
    if (result.terms_.empty()) throw CommandError(grammar<H>);
    return result;
}

template <class H>
Selector<H> Selector<H>::all()
{
    return parse("all");
}

template <class H>
Selector<H> Selector<H>::none()
{
    return parse("none");
}

template <class H>
Selector<H> Selector<H>::of(const std::vector<H>& handles)
{
    if (handles.empty()) return none();
    Selector result;
    SelectorTerm& term = result.terms_[0];
    term.kind = TermKind::ids;
    for (const H h : handles) {
        if (!term.ids.empty() && term.ids.back().last + 1 == h.index) term.ids.back().last = h.index;
        else term.ids.push_back({h.index, h.index});
    }
    return result;
}

template <class H>
std::string Selector<H>::text() const
{
    std::string text;
    for (const SelectorTerm& term : terms_) {
        if (!text.empty()) text += '+';
        text += term_text<H>(term);
    }
    return text;
}

template <class H>
std::vector<H> Selector<H>::resolve(const Scene& scene) const
{
    std::vector<H> result;
    const auto settle = [&result] {
        if (!std::ranges::is_sorted(result)) std::ranges::sort(result);
        result.erase(std::unique(result.begin(), result.end()), result.end());
    };
    for (const SelectorTerm& term : terms_) {
        add_term(scene, term, result);
        if (result.size() > 2 * std::size_t(count<H>(scene.mesh))) settle(); // what is named again and again takes no more room
    }
    settle();
    return result;
}

template class Selector<Face>;
template class Selector<Edge>;
template class Selector<Vertex>;

Face FaceId::resolve(const Mesh& mesh) const
{
    if (id >= mesh.face_limit()) not_there<Face>(id, mesh.face_limit());
    return Face(id);
}

Vertex VertexId::resolve(const Mesh& mesh) const
{
    if (id >= mesh.vertex_limit()) not_there<Vertex>(id, mesh.vertex_limit());
    return Vertex(id);
}

Edge EdgeId::resolve(const Mesh& mesh) const
{
    if (other_end != Edge::none) return edge_between(mesh, id, other_end);
    if (id >= mesh.edge_limit()) not_there<Edge>(id, mesh.edge_limit());
    return Edge(id);
}

Corner CornerId::resolve(const Mesh& mesh) const
{
    const Face f = FaceId{face}.resolve(mesh);
    const auto n = static_cast<std::uint32_t>(mesh.valence(f));
    if (place >= n) throw CommandError(fmt::format("face {} has corners 0 to {}, not {}", face, n - 1, place));
    return mesh.corner(f, static_cast<int>(place));
}

} // namespace druse
