// rind.punch and rind.peel: openings in a crust.
#include "dlfl/errors.h"
#include "ops/group.h"
#include "ops/pipe.h"
#include "ops/rind.h"
#include "ops/rind_reassembly.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse {

void Opener::require_openable(const std::array<Corner, 2>& pair) const
{
    const Face first = mesh_.face(pair[0]), second = mesh_.face(pair[1]);
    require_pipe_end(mesh_, first);
    require_pipe_end(mesh_, second);
    require_apart(mesh_, first, second);
}

void Opener::punch(const std::array<Corner, 2>& pair, std::vector<Face>& walls)
{
    require_openable(pair);
    maker_.create_facing(pair[0], pair[1], walls);
}

void Opener::peel(const std::array<Corner, 2>& pair, std::vector<Face>& walls)
{
    require_openable(pair);
    if (!find_thin_walls(pair)) {
        maker_.create_facing(pair[0], pair[1], walls);
        return;
    }
    // A pipe, and then the thin walls away: their edges on both faces go, so that wall and faces become one, and what is left over the other
    // sides is cut up. A thin wall leaves the rungs that it ended in; there is no need for new ones.
    for (const Side& side : sides_)
        if (side.thin) {
            remove(side.outer);
            remove(side.inner);
        }
    const std::size_t n = sides_.size();
    for (std::size_t i = 0; i < n; ++i)
        if (sides_[i].thin && at(i + 1).thin) merge_rungs(sides_[i].rung, at(i + 1));
    for (std::size_t i = 0; i < n; ++i)
        if (!sides_[i].thin && at(i + n - 1).thin) build_walls(i, walls);
}

bool Opener::find_thin_walls(const std::array<Corner, 2>& pair)
{
    sides_.clear();
    bool any = false;
    Corner outer = pair[0], inner = pair[1];
    do {
        Side side;
        side.vertex = mesh_.vertex(outer);
        side.below = mesh_.vertex(inner);
        inner = mesh_.previous(inner); // where the side begins that belongs to the outer one
        side.outer = mesh_.edge(outer);
        side.inner = mesh_.edge(inner);
        const Corner across = mesh_.opposite(outer);
        side.thin = mesh_.face(across) == mesh_.face(mesh_.opposite(inner)) && !mesh_.face(across).is_boundary();
        side.rung = mesh_.edge(mesh_.previous(across));
        any = any || side.thin;
        sides_.push_back(side);
        outer = mesh_.next(outer);
    } while (outer != pair[0]);
    return any;
}

void Opener::remove(Edge e)
{
    if (mesh_.is_alive(e)) mesh_.delete_edge(e, true);
}

/// Each of two thin walls in succession leaves a rung at the corner between them. One of the two goes; where they are the same one, because no
/// face is left around it, the corners go too.
void Opener::merge_rungs(Edge rung, const Side& corner)
{
    if (!mesh_.is_alive(rung) || mesh_.is_on_boundary(rung)) return;
    const auto ends = mesh_.ends(rung);
    if (ends != std::array{corner.vertex, corner.below} && ends != std::array{corner.below, corner.vertex}) return; // of a wall changed by hand
    const auto [a, b] = mesh_.faces(rung);
    const Corner gap = mesh_.corner(rung, mesh_.valence(a) == 2 ? 0 : 1);
    if (a == b || mesh_.valence(mesh_.face(gap)) != 2) {
        remove(rung);
        return;
    }
    // The gap between two rungs goes to the face beyond, which stays what it was but for its id.
    const Face beyond = mesh_.face(mesh_.opposite(gap));
    const int group = mesh_.group(beyond);
    const Corner start = mesh_.corner(beyond);
    const Edge start_edge = mesh_.edge(start) == rung ? mesh_.edge(mesh_.next(gap)) : mesh_.edge(start);
    const Vertex start_vertex = mesh_.vertex(start);
    remove(rung);
    const Corner now = corner_from(mesh_, start_edge, start_vertex);
    mesh_.set_start(now);
    mesh_.set_group(mesh_.face(now), group);
}

/// Cuts the face over the sides from `first` to the next thin one into walls.
void Opener::build_walls(std::size_t first, std::vector<Face>& walls)
{
    const auto start_of = [this](std::size_t i) { return corner_from(mesh_, at(i).outer, at(i).vertex); };
    std::size_t last = first;
    while (!at(last + 1).thin) ++last;
    mesh_.set_start(start_of(last)); // what is cut off is the wall behind, never the rest
    for (std::size_t i = first + 1; i <= last; ++i)
        mesh_.insert_edge(start_of(i), mesh_.next(corner_from(mesh_, at(i).inner, at(i + 1).below)));
    for (std::size_t i = first; i <= last; ++i) {
        const Corner start = start_of(i);
        mesh_.set_start(start);
        walls.push_back(mesh_.face(start));
    }
}

// --- columns ----------------------------------------------------------------------------------------------------------------------

std::vector<Corner> columns_between(const Mesh& mesh, Vertex v, Vertex w)
{
    std::vector<Corner> list;
    if (mesh.is_point_sphere(v)) return list;
    for (const Corner c : mesh.around(v))
        if (mesh.target(c) == w) list.push_back(c);
    return list;
}

bool is_pinched(const Mesh& mesh, Vertex v, Vertex w)
{
    // Between two columns in the rotation lies a wedge of faces, with two edges or more; or a wall without thickness, with one.
    const std::vector<Corner> columns = columns_between(mesh, v, w);
    int wedges = 0;
    for (const Corner column : columns) {
        const Corner first = mesh.rotate(column);
        if (mesh.target(first) != w && mesh.target(mesh.rotate(first)) != w) ++wedges;
    }
    return wedges >= 2;
}

void cut_columns(Scene& scene, const std::vector<std::array<Vertex, 2>>& columns)
{
    Mesh& mesh = scene.mesh;
    std::vector<std::uint32_t> settled(mesh.vertex_limit()); // the id that a vertex has without holes
    std::uint32_t alive = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_limit(); ++v) {
        settled[v] = alive;
        if (mesh.is_alive(Vertex(v))) ++alive;
    }
    settle(scene);

    const Reassembly old(mesh);
    MeshAssembler all;
    old.add_vertices(all);
    old.add_corners(all);
    std::vector<bool> cut(mesh.edge_limit(), false);
    for (const auto& [v, w] : columns) {
        const std::vector<Corner> around = columns_between(mesh, Vertex(settled[v.index]), Vertex(settled[w.index]));
        for (std::size_t k = 0; k < around.size(); ++k) {
            // The wedge from this column to the next has one of its own, between the walls at its two sides.
            all.add_edge(old.number(around[k]), old.number(mesh.opposite(around[(k + 1) % around.size()])));
            cut[mesh.edge(around[k]).index] = true;
        }
    }
    for (const Edge e : mesh.edges())
        if (!cut[e.index]) all.add_edge(old.number(mesh.corner(e, 0)), old.number(mesh.corner(e, 1)));
    std::vector<std::int32_t> groups;
    const auto add = [&](Face f) {
        for (const Corner c : mesh.corners(f)) all.add_to_face(old.number(c));
        all.end_face();
        groups.push_back(f.is_boundary() ? 0 : mesh.group(f));
        if (f.is_boundary()) all.mark_open(all.face_count() - 1);
    };
    for (const Face f : mesh.faces()) add(f);
    for (const Face f : mesh.boundary_faces()) add(f);

    const std::vector<Rind::Pair> pairs = scene.rind.pairs(mesh);
    old.put_in_place(scene, all, groups);
    scene.rind = Rind(mesh, pairs);
}

// --- the operators ----------------------------------------------------------------------------------------------------------------

namespace {

enum class Pinch { keep, cut };

struct Punch {
    FaceSelector faces;
};
struct Peel : Punch {
    Pinch pinch = Pinch::keep;
};

using CornerPair = std::array<Corner, 2>;

/// The pairs of the given faces that can be opened, each once. Says how many faces belong to none. @throws CommandError if all do
std::vector<CornerPair> live_pairs(const Scene& scene, const FaceSelector& selector, Context& context)
{
    const std::vector<Face> faces = selector.resolve(scene);
    if (faces.empty()) throw CommandError("no faces");
    const auto given = [&faces](Face f) { return std::ranges::binary_search(faces, f); };
    std::vector<CornerPair> pairs;
    std::size_t ignored = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (i % 4096 == 0) context.progress.step(0.3 * double(i) / double(faces.size()));
        const auto pair = scene.rind.find(scene.mesh, faces[i]);
        if (!pair) ++ignored;
        else if (const Face lower = scene.mesh.face((*pair)[0]); lower == faces[i] || !given(lower)) pairs.push_back(*pair);
    }
    if (pairs.empty() && faces.size() == 1) throw CommandError(fmt::format("face {} is not part of a rind", faces[0].index));
    if (pairs.empty()) throw CommandError(fmt::format("faces {}: none of them is part of a rind", FaceSelector::of(faces).text()));
    if (ignored > 0) context.note(fmt::format("{} not part of a rind: ignored", ignored == 1 ? "1 face is" : fmt::format("{} faces are", ignored)));
    return pairs;
}

void run_punch(Scene& scene, const Punch& p, Context& context)
{
    const int group = first_new_group(scene.mesh, 1);
    Opener opener(scene.mesh);
    std::vector<Face> walls;
    const std::vector<CornerPair> pairs = live_pairs(scene, p.faces, context);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (i % 4096 == 0) context.progress.step(0.3 + 0.7 * double(i) / double(pairs.size()));
        scene.rind.remove(scene.mesh.face(pairs[i][0]));
        opener.punch(pairs[i], walls);
    }
    select_walls(scene, std::move(walls), group);
}

void run_peel(Scene& scene, const Peel& p, Context& context)
{
    Mesh& mesh = scene.mesh;
    const int group = first_new_group(mesh, 1);
    Opener opener(mesh);
    std::vector<Face> walls, faces;
    std::vector<std::array<Vertex, 2>> corners; // of all faces that are peeled, each with the one below
    for (const CornerPair& pair : live_pairs(scene, p.faces, context)) faces.push_back(mesh.face(pair[0]));
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (i % 1024 == 0) context.progress.step(0.3 + 0.7 * double(i) / double(faces.size()));
        const auto pair = scene.rind.find(mesh, faces[i]);
        if (!pair) continue; // it stood between the two sides of another one, and went with that
        scene.rind.remove(faces[i]);
        Corner outer = (*pair)[0], inner = (*pair)[1];
        do {
            corners.push_back({mesh.vertex(outer), mesh.vertex(inner)});
            outer = mesh.next(outer);
            inner = mesh.previous(inner);
        } while (outer != (*pair)[0]);
        opener.peel(*pair, walls);
    }
    if (mesh.face_count() == 0) throw CommandError("would remove the whole surface");

    // Walls of one face may go again with the next one, or change their ids.
    std::erase_if(walls, [&mesh](Face f) { return !mesh.is_alive(f); });
    select_walls(scene, std::move(walls), group);

    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    std::erase_if(corners, [&mesh](const auto& c) { return !mesh.is_alive(c[0]) || !mesh.is_alive(c[1]) || !is_pinched(mesh, c[0], c[1]); });
    if (corners.empty()) return;
    if (p.pinch == Pinch::cut) cut_columns(scene, corners);
    else context.note(fmt::format("{} pinched column{}", corners.size(), corners.size() == 1 ? "" : "s"));
}

} // namespace

Operator rind_punch_operator()
{
    return define<Punch>("rind.punch", "Open holes in a crust, each over one face")
        .param(&Punch::faces, "faces", "faces to open, of either surface")
        .example("rind.punch faces=0")
        .cites("Özener, Akleman & Srinivasan 2005")
        .run(run_punch);
}

Operator rind_peel_operator()
{
    return define<Peel>("rind.peel", "Open holes in a crust, and take away the infinitely thin walls between neighbours")
        .param(&Peel::faces, "faces", "faces to open, of either surface")
        .param(&Peel::pinch, "pinch", words({"keep", "cut"}), "where holes meet at a corner: leave the columns that touch there, or part them")
        .example("rind.peel faces=0,1")
        .cites("Özener, Akleman & Srinivasan 2005")
        .run(run_peel);
}

} // namespace druse
