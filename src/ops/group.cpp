// Face groups: numbers that faces share, for choosing, colouring and extruding them together.
#include "ops/group.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "geom/sort_unique.h"
#include "ops/direction_grid.h"
#include "ops/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

namespace druse {

namespace {

constexpr int largest_id = std::numeric_limits<std::int32_t>::max();
constexpr std::uint32_t none = Face::none;

[[noreturn]] void no_such_group(int id) { throw CommandError(fmt::format("no face has group {}", id)); }

/// Writes start + key to every face. Keys count up from 0.
void write_keys(Mesh& mesh, const std::vector<std::uint32_t>& key, std::uint32_t keys, int start)
{
    if (std::int64_t(start) + keys - 1 > largest_id) throw CommandError(fmt::format("start={}: {} group ids from here on pass {}", start, keys, largest_id));
    const std::span<std::int32_t> out = mesh.write_groups();
    for (std::size_t f = 0; f < out.size(); ++f) out[f] = start + static_cast<std::int32_t>(key[f]);
}

} // namespace

std::vector<int> existing_groups(const Mesh& mesh, bool with_ungrouped)
{
    std::vector<int> ids;
    for (const std::int32_t g : mesh.groups())
        if ((g > 0 || with_ungrouped) && (ids.empty() || ids.back() != g)) ids.push_back(g);
    sort_unique(ids);
    return ids;
}

std::vector<int> resolve_groups(const Mesh& mesh, const OrWord<std::vector<int>>& ids)
{
    std::vector<int> there = existing_groups(mesh, ids.word.empty());
    if (!ids.word.empty()) return there;
    std::vector<int> asked = ids.value;
    sort_unique(asked);
    for (const int id : asked)
        if (!std::ranges::binary_search(there, id)) no_such_group(id);
    return asked;
}

int first_new_group(const Mesh& mesh, std::size_t count)
{
    const int largest = mesh.largest_group();
    if (count > std::size_t(largest_id - largest))
        throw CommandError(fmt::format("group ids would pass {}; group.renumber makes them small", largest_id));
    return largest + 1;
}

void split_groups(Mesh& mesh, const std::vector<int>& ids, SplitBy by, double angle)
{
    // Pieces in the order of their lowest faces, each with the place of its group in `ids`.
    std::vector<std::uint32_t> piece_of(mesh.face_limit(), none), group_of_piece;
    const auto new_piece = [&](std::size_t group) {
        group_of_piece.push_back(static_cast<std::uint32_t>(group));
        return static_cast<std::uint32_t>(group_of_piece.size() - 1);
    };
    std::map<std::pair<std::size_t, int>, std::uint32_t> by_sides;
    std::unordered_map<std::size_t, DirectionGrid> by_normal;
    std::vector<Face> reached;
    for (const Face f : mesh.faces()) {
        if (piece_of[f.index] != none) continue;
        const auto at = std::ranges::lower_bound(ids, mesh.group(f));
        if (at == ids.end() || *at != mesh.group(f)) continue;
        const auto group = static_cast<std::size_t>(at - ids.begin());
        if (by == SplitBy::sides) {
            const auto [it, made] = by_sides.try_emplace({group, mesh.valence(f)}, 0);
            if (made) it->second = new_piece(group);
            piece_of[f.index] = it->second;
        } else if (by == SplitBy::normal) {
            DirectionGrid& directions = by_normal.try_emplace(group, angle).first->second;
            const Vector n = unit_normal(mesh, f);
            std::uint32_t piece = directions.find(n);
            if (piece == DirectionGrid::none) directions.add(n, piece = new_piece(group));
            piece_of[f.index] = piece;
        } else {
            const std::uint32_t piece = new_piece(group);
            reached.assign(1, f);
            piece_of[f.index] = piece;
            while (!reached.empty()) {
                const Face g = reached.back();
                reached.pop_back();
                for (const Corner c : mesh.corners(g)) {
                    if (!mesh.edge(c).valid()) continue;
                    const Face h = mesh.face(mesh.opposite(c));
                    if (h.is_boundary() || piece_of[h.index] != none || mesh.group(h) != mesh.group(f)) continue;
                    piece_of[h.index] = piece;
                    reached.push_back(h);
                }
            }
        }
    }
    // The first piece of a group keeps its id.
    std::vector<std::uint32_t> order(group_of_piece.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::uint32_t piece) { return group_of_piece[piece]; });
    const std::size_t more = order.size() - ids.size();
    if (more == 0) return;
    std::vector<int> id_of_piece(order.size());
    int next = first_new_group(mesh, more);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t group = group_of_piece[order[i]];
        id_of_piece[order[i]] = i == 0 || group_of_piece[order[i - 1]] != group ? ids[group] : next++;
    }
    for (const Face f : mesh.faces())
        if (piece_of[f.index] != none && id_of_piece[piece_of[f.index]] != mesh.group(f)) mesh.set_group(f, id_of_piece[piece_of[f.index]]);
}

void group_by_sides(Mesh& mesh, int start)
{
    std::vector<int> sides(mesh.face_limit());
    for (const Face f : mesh.faces()) sides[f.index] = mesh.valence(f);
    std::vector<int> distinct = sides;
    sort_unique(distinct);
    std::vector<std::uint32_t> key(sides.size());
    for (std::size_t f = 0; f < key.size(); ++f)
        key[f] = static_cast<std::uint32_t>(std::ranges::lower_bound(distinct, sides[f]) - distinct.begin());
    write_keys(mesh, key, static_cast<std::uint32_t>(distinct.size()), start);
}

void group_by_area(Mesh& mesh, int start)
{
    std::vector<std::pair<double, std::uint32_t>> areas;
    areas.reserve(mesh.face_count());
    for (const Face f : mesh.faces()) areas.emplace_back(area(mesh, f), f.index);
    std::ranges::sort(areas);
    std::vector<std::uint32_t> key(mesh.face_limit());
    std::uint32_t keys = 0;
    double least = 0.0; // of the present group
    for (const auto& [a, f] : areas) {
        if (keys == 0 || a > least * (1.0 + 1e-6)) {
            ++keys;
            least = a;
        }
        key[f] = keys - 1;
    }
    write_keys(mesh, key, keys, start);
}

void group_by_component(Mesh& mesh, int start)
{
    const Components parts = components(mesh);
    write_keys(mesh, parts.of_face, static_cast<std::uint32_t>(parts.parts.size()), start);
}

void group_by_normal(Mesh& mesh, double angle, int start)
{
    DirectionGrid directions(angle);
    std::vector<std::uint32_t> key(mesh.face_limit());
    std::uint32_t keys = 0;
    for (const Face f : mesh.faces()) {
        const Vector n = unit_normal(mesh, f);
        key[f.index] = directions.find(n);
        if (key[f.index] != DirectionGrid::none) continue;
        directions.add(n, keys);
        key[f.index] = keys++;
    }
    write_keys(mesh, key, keys, start);
}

void group_by_colour(Scene& scene, int tolerance, int start)
{
    Mesh& mesh = scene.mesh;
    // Colours in boxes one wider than the tolerance: two in one box are near, so a box holds one group's colour at most.
    const int width = tolerance + 1;
    const auto box = [width](int red, int green, int blue) { return ((red / width) << 20) + ((green / width) << 10) + blue / width; };
    std::unordered_map<int, std::uint32_t> key_in_box;
    std::vector<Colour> colours;
    const auto find = [&](Colour c) {
        std::uint32_t best = none;
        for (const int red : {c.red - width, int(c.red), c.red + width})
            for (const int green : {c.green - width, int(c.green), c.green + width})
                for (const int blue : {c.blue - width, int(c.blue), c.blue + width}) {
                    if (std::min({red, green, blue}) < 0) continue;
                    const auto at = key_in_box.find(box(red, green, blue));
                    if (at == key_in_box.end()) continue;
                    const Colour d = colours[at->second];
                    if (std::abs(c.red - d.red) <= tolerance && std::abs(c.green - d.green) <= tolerance && std::abs(c.blue - d.blue) <= tolerance)
                        best = std::min(best, at->second);
                }
        return best;
    };
    std::unordered_map<int, std::uint32_t> key_of_group;
    std::vector<std::uint32_t> key(mesh.face_limit());
    for (const Face f : mesh.faces()) {
        const auto [known, is_new] = key_of_group.try_emplace(mesh.group(f), 0);
        if (is_new) {
            const Colour c = scene.groups->colour(mesh.group(f));
            known->second = find(c);
            if (known->second == none) {
                known->second = static_cast<std::uint32_t>(colours.size());
                key_in_box.emplace(box(c.red, c.green, c.blue), known->second);
                colours.push_back(c);
            }
        }
        key[f.index] = known->second;
    }
    write_keys(mesh, key, static_cast<std::uint32_t>(colours.size()), start);
    GroupTable table = *scene.groups;
    for (std::size_t i = 0; i < colours.size(); ++i)
        if (const int id = start + static_cast<int>(i); table.colour(id) != colours[i]) table.set_colour(id, colours[i]);
    if (!(table == *scene.groups)) scene.groups = std::move(table);
}

void renumber_groups(Scene& scene)
{
    Mesh& mesh = scene.mesh;
    std::vector<int> old_ids; // by new id, from 1
    std::unordered_map<int, int> new_id;
    for (const Face f : mesh.faces())
        if (const int g = mesh.group(f); g > 0 && new_id.try_emplace(g, static_cast<int>(old_ids.size()) + 1).second) old_ids.push_back(g);

    GroupTable table = *scene.groups;
    std::vector<int> falling = old_ids;
    std::ranges::sort(falling, std::greater<>());
    for (const int id : falling) table.forget(id);
    for (std::size_t i = 0; i < old_ids.size(); ++i) {
        const int id = static_cast<int>(i) + 1;
        const Colour c = scene.groups->colour(old_ids[i]);
        if (scene.groups->has_own_colour(old_ids[i]) || c != GroupTable::default_colour(id)) table.set_colour(id, c);
        else table.set_default_colour(id);
        table.set_name(id, scene.groups->name(old_ids[i]));
    }
    if (!(table == *scene.groups)) scene.groups = std::move(table);
    for (const Face f : mesh.faces())
        if (const int g = mesh.group(f); g > 0 && new_id[g] != g) mesh.set_group(f, new_id[g]);
}

// --- registration ---------------------------------------------------------------------------------------------------------------

namespace {

struct AssignGroup {
    FaceSelector faces;
    OrWord<int> id;
};
struct ClearGroups {
    FaceSelector faces = FaceSelector::all();
};
struct MergeGroups {
    OrWord<std::vector<int>> ids;
    std::optional<int> into;
};
struct SplitGroups {
    OrWord<std::vector<int>> ids = "all";
    SplitBy by = SplitBy::components;
    double angle = 1;
};
struct GroupBy {
    enum class Rule { sides, components, normal, area, color } rule = Rule::sides;
    double angle = 1;
    int start = 1;
    std::optional<bool> absolute; // given with their rule only
    std::optional<int> tolerance;
};
struct ColourGroup {
    OrWord<int> id;
    OrWord<Colour> color;
};
struct NameGroup {
    int id = 0;
    std::string name;
};

constexpr Range id_range{0, double(largest_id)};

void set_groups(Mesh& mesh, const std::vector<Face>& faces, int id)
{
    for (const Face f : faces)
        if (mesh.group(f) != id) mesh.set_group(f, id);
}

void assign_group(Scene& scene, const AssignGroup& p, Context&)
{
    const std::vector<Face> faces = p.faces.resolve(scene);
    set_groups(scene.mesh, faces, p.id.word.empty() ? p.id.value : first_new_group(scene.mesh, 1));
}

void merge_groups(Scene& scene, const MergeGroups& p, Context&)
{
    const std::vector<int> ids = resolve_groups(scene.mesh, p.ids);
    if (ids.empty()) throw CommandError("no face has a group");
    const int into = p.into.value_or(ids.front());
    for (const Face f : scene.mesh.faces())
        if (const int g = scene.mesh.group(f); g != into && std::ranges::binary_search(ids, g)) scene.mesh.set_group(f, into);
}

void group_by(Scene& scene, const GroupBy& p, Context&)
{
    using Rule = GroupBy::Rule;
    if (p.absolute && p.rule != Rule::sides) throw CommandError(fmt::format("absolute={}: goes with rule=sides only", *p.absolute));
    if (p.tolerance && p.rule != Rule::color) throw CommandError(fmt::format("tolerance={}: goes with rule=color only", *p.tolerance));
    switch (p.rule) {
    case Rule::sides:
        if (!p.absolute.value_or(false)) return group_by_sides(scene.mesh, p.start);
        for (const Face f : scene.mesh.faces()) scene.mesh.set_group(f, scene.mesh.valence(f));
        return;
    case Rule::components: return group_by_component(scene.mesh, p.start);
    case Rule::normal: return group_by_normal(scene.mesh, p.angle, p.start);
    case Rule::area: return group_by_area(scene.mesh, p.start);
    case Rule::color: return group_by_colour(scene, p.tolerance.value_or(0), p.start);
    }
}

void colour_group(Scene& scene, const ColourGroup& p, Context&)
{
    OrWord<std::vector<int>> ids;
    ids.word = p.id.word;
    ids.value = {p.id.value};
    const std::vector<int> coloured = resolve_groups(scene.mesh, ids);
    GroupTable& table = scene.groups.edit();
    if (p.color.word.empty()) {
        for (const int id : coloured) table.set_colour(id, p.color.value);
    } else {
        for (auto id = coloured.rbegin(); id != coloured.rend(); ++id) table.set_default_colour(*id); // the table is shortest to cut from its end
    }
}

void name_group(Scene& scene, const NameGroup& p, Context&)
{
    for (const int id : resolve_groups(scene.mesh, std::vector<int>{p.id})) {
        const bool one_word = std::ranges::none_of(p.name, [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; });
        if (p.name.empty() || !one_word) throw CommandError(fmt::format("name=\"{}\": expected one word", p.name));
        scene.groups.edit().set_name(id, p.name);
    }
}

} // namespace

void register_group(Registry& registry)
{
    const char* ids_help = "group ids, or all groups";
    registry.add(define<AssignGroup>("group.assign", "Put faces into a group")
                     .param(&AssignGroup::faces, "faces", "faces to put into the group")
                     .param(&AssignGroup::id, "id", Unit::id, id_range, words({"new"}), "the group; new: the largest id + 1; 0: none")
                     .required()
                     .example("group.assign faces=0,4 id=new")
                     .cites("Landreneau 2005, III.5")
                     .keeps_euler()
                     .run(assign_group));
    registry.add(define<ClearGroups>("group.clear", "Take faces out of their groups")
                     .param(&ClearGroups::faces, "faces", "faces to ungroup")
                     .example("group.clear faces=group:3")
                     .cites("Landreneau 2005, III.5")
                     .keeps_euler()
                     .run([](Scene& scene, const ClearGroups& p, Context&) { set_groups(scene.mesh, p.faces.resolve(scene), 0); }));
    registry.add(define<MergeGroups>("group.merge", "Make one group of several")
                     .param(&MergeGroups::ids, "ids", Unit::id, id_range, words({"all"}), ids_help)
                     .required()
                     .param(&MergeGroups::into, "into", Unit::id, id_range, "id of the result; unset: the smallest of ids")
                     .example("group.merge ids=3,5,7 into=3")
                     .cites("Landreneau 2005, III.5")
                     .keeps_euler()
                     .run(merge_groups));
    registry.add(define<SplitGroups>("group.split", "Make several groups of one; its first piece keeps the id")
                     .param(&SplitGroups::ids, "ids", Unit::id, id_range, words({"all"}), ids_help)
                     .param(&SplitGroups::by, "by", words({"components", "sides", "normal"}), "what holds a piece together")
                     .required()
                     .param(&SplitGroups::angle, "angle", Unit::degrees, {0, 180}, "with by=normal: largest angle from the first face of a piece")
                     .example("group.split ids=2 by=components")
                     .cites("Landreneau 2005, III.5")
                     .keeps_euler()
                     .run([](Scene& scene, const SplitGroups& p, Context&) {
                         split_groups(scene.mesh, resolve_groups(scene.mesh, p.ids), p.by, p.angle);
                     }));
    registry.add(define<GroupBy>("group.by", "Group all faces anew by a rule")
                     .param(&GroupBy::rule, "rule", words({"sides", "components", "normal", "area", "color"}), "what the faces of a group share")
                     .required()
                     .param(&GroupBy::angle, "angle", Unit::degrees, {0, 180}, "with rule=normal: largest angle from the first face of a group")
                     .param(&GroupBy::start, "start", Unit::id, {1, double(largest_id)}, "the first id")
                     .param(&GroupBy::absolute, "absolute", "with rule=sides only: true makes the number of sides the id")
                     .param(&GroupBy::tolerance, "tolerance", Unit::count, {0, 255}, "with rule=color only: largest difference in each 8-bit channel, 0 unless given")
                     .example("group.by rule=normal angle=5")
                     .cites("Landreneau 2005, III.5 and IV.4")
                     .keeps_euler()
                     .run(group_by));
    registry.add(define<NoParameters>("group.renumber", "Number the groups 1, 2, 3, … by their lowest faces; colours travel along")
                     .example("group.renumber")
                     .cites("Landreneau 2005, III.5")
                     .keeps_euler()
                     .run([](Scene& scene, const NoParameters&, Context&) { renumber_groups(scene); }));
    registry.add(define<ColourGroup>("group.color", "Colour a group")
                     .param(&ColourGroup::id, "id", Unit::id, id_range, words({"all"}), "the group, or all groups")
                     .required()
                     .param(&ColourGroup::color, "color", words({"auto"}), "the colour; auto: the one every new group has")
                     .required()
                     .example("group.color id=2 color=#3366ff")
                     .cites("Landreneau 2005, IV.3")
                     .keeps_euler()
                     .run(colour_group));
    registry.add(define<NameGroup>("group.name", "Name a group")
                     .param(&NameGroup::id, "id", Unit::id, id_range, "the group")
                     .required()
                     .param(&NameGroup::name, "name", "one word")
                     .required()
                     .example("group.name id=2 name=roof")
                     .cites("Druse")
                     .keeps_euler()
                     .run(name_group));
}

} // namespace druse
