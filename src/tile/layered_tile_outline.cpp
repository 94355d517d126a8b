// Edits of the frame and the outline of a LayeredTile.
#include "tile/layered_tile.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace druse {

namespace {

/// What becomes of names when `path` gets another point at `index` (by = 1), or loses that one (by = −1).
auto shifted_names(int path, int index, int by)
{
    return [=](const PointName& name) -> std::optional<PointName> {
        if ((name.kind != PointName::Kind::path && name.kind != PointName::Kind::mirrored) || name.path != path || name.index < index) return name;
        if (by < 0 && name.index == index) return {};
        PointName moved = name;
        moved.index += by;
        return moved;
    };
}

/// As much of a path as fits another shape.
std::vector<Point2> refitted(std::span<const PathPoint> whole, const IsohedralType& type, int path)
{
    std::vector<Point2> kept;
    const PathShape shape = type.shapes[path];
    for (const PathPoint& p : whole) {
        if (shape == PathShape::straight && p.at.y != 0) continue;
        if (is_half_stored(type, path) && !(p.at.x < 0.5 || (p.at.x == 0.5 && shape != PathShape::half_turn))) break;
        kept.push_back(p.at);
        if (is_half_stored(type, path) && p.at.x == 0.5) break;
    }
    return kept;
}

/// Which points of the paths of one type are at the places of those of another, by their names on the first edge with that path.
std::map<PointName, PointName> same_places(const IsohedralType& type, std::span<const std::vector<Point2>> paths, const IsohedralType& next,
                                           std::span<const std::vector<Point2>> next_paths)
{
    constexpr double nearness = 1e-9; // of the length of an edge
    std::map<PointName, PointName> names;
    for (int path = 0; path < std::ssize(paths) && path < std::ssize(next_paths); ++path) {
        const std::vector<PathPoint> there = whole_path(next, path, next_paths[static_cast<std::size_t>(path)]);
        for (const PathPoint& p : whole_path(type, path, paths[static_cast<std::size_t>(path)]))
            for (const PathPoint& q : there)
                if (glm::length(p.at - q.at) <= nearness) names[{p.kind, path, p.index, -1}] = {q.kind, path, q.index, -1};
    }
    return names;
}

/// Heights of the points of a tile that have a place on another outline, and of those inside; an orbit there has that of the first of its points that has one. Says which
/// orbits cannot keep theirs.
std::map<PointName, double> heights_on(const TileOutline& outline, const IsohedralType& type, const LayeredTile& tile,
                                       const std::function<std::optional<PointName>(const PointName&)>& renamed, std::vector<std::string>& notes)
{
    std::map<PointName, double> heights;
    for (const auto& [name, height] : tile.design().heights)
        if (const auto now = renamed(name); now && now->kind == PointName::Kind::interior) heights[*now] = height;
    const auto orbit_of = [&](int i) { return tile.outline().points[i].orbit; };
    std::vector<int> there(tile.outline_count(), -1); // the orbit that each point comes to be in
    std::vector<double> height_there(outline.orbits);
    for (int i = 0; i < tile.outline_count(); ++i) {
        const auto now = renamed(tile.name(i));
        if (!now) continue;
        there[i] = outline.points[outline.find(type, *now)].orbit;
        if (tile.height(i) != 0 && height_there[there[i]] == 0) heights[*now] = height_there[there[i]] = tile.height(i);
    }
    // It is enough that one point of an orbit keeps its height; without any, nothing is lost if that was 0.
    std::vector<bool> met(tile.outline().orbits), kept(met), told(met);
    for (int i = 0; i < tile.outline_count(); ++i) {
        if (there[i] < 0) continue;
        met[orbit_of(i)] = true;
        if (height_there[there[i]] == tile.height(i)) kept[orbit_of(i)] = true;
    }
    constexpr int most_named = 5;
    int lost = 0;
    std::string names;
    for (int i = 0; i < tile.outline_count(); ++i) {
        const int orbit = orbit_of(i);
        if (told[orbit] || kept[orbit] || (!met[orbit] && tile.height(i) == 0)) continue;
        told[orbit] = true;
        if (lost++ < most_named) names += (lost == 1 ? "" : ", ") + tile.name(i).text();
    }
    if (lost > most_named) names += fmt::format(" and {} more", lost - most_named);
    if (lost > 0) notes.push_back(fmt::format("{} cannot stay as high as {} in {}: {}", lost == 1 ? "1 point" : fmt::format("{} points", lost), lost == 1 ? "it is" : "they are", type.name(), names));
    return heights;
}

} // namespace

/// The tile of another design, in which points may have other names. Heights and segments go with their points; orbits that are new take the height
/// that the layer had where they are.
void LayeredTile::become(TileDesign design, const Rename& renamed)
{
    LayeredTile next;
    next.design_ = std::move(design);
    if (renamed) {
        std::map<PointName, double> heights;
        for (const auto& [name, height] : next.design_.heights)
            for (const int member : orbit(find(name))) // by all its points: the one that told it may be gone
                if (const auto now = renamed(this->name(member))) heights[*now] = height;
        next.design_.heights = std::move(heights);
        std::vector<std::vector<PointName>> segments;
        for (const auto& chain : next.design_.segments) {
            std::vector<PointName> kept;
            for (const PointName& name : chain)
                if (const auto now = renamed(name)) kept.push_back(*now);
            if (kept.size() >= 2) segments.push_back(std::move(kept));
        }
        next.design_.segments = std::move(segments);
    }
    next.derive_plane();
    // Names that the new tile has not were of points that its paths have no longer.
    const auto is_there = [&](const PointName& name) { return name.kind == PointName::Kind::interior || next.outline_.find(*next.type_, name) >= 0; };
    std::erase_if(next.design_.heights, [&](const auto& item) { return !is_there(item.first); });
    for (auto& chain : next.design_.segments) std::erase_if(chain, [&](const PointName& name) { return !is_there(name); });
    std::erase_if(next.design_.segments, [](const auto& chain) { return chain.size() < 2; });

    if (!design_.heights.empty() && type_ == next.type_) {
        std::vector<bool> known(static_cast<std::size_t>(next.outline_.orbits));
        for (const OutlinePoint& p : outline_.points) {
            const auto now = renamed ? renamed(p.name) : std::optional(p.name);
            const int there = now ? next.outline_.find(*next.type_, *now) : -1;
            if (there >= 0) known[static_cast<std::size_t>(next.outline_.points[there].orbit)] = true;
        }
        for (const OutlinePoint& p : next.outline_.points) {
            if (known[static_cast<std::size_t>(p.orbit)]) continue;
            known[static_cast<std::size_t>(p.orbit)] = true;
            if (const double height = layer_height(p.position); height != 0) next.design_.heights[p.name] = height;
        }
    }
    next.take_inside(next.make_pane(), this);
    *this = std::move(next);
}

void LayeredTile::set_frame(double size, double rotation, const Point2& origin)
{
    if (!(size > 0)) throw CommandError(fmt::format("size {}: expected above 0", size));
    TileDesign design = design_;
    const double factor = size / design.size;
    design.size = size;
    design.rotation = rotation;
    design.origin = origin;
    if (factor != 1) {
        for (Point2& p : design.interior) p *= factor;
        design.stack.offset *= factor;
    }
    become(std::move(design));
}

/// Takes the offset along with a lattice that changes, so that its class among those that are isohedral stays.
TileStack LayeredTile::stack_along(const TileDesign& design, std::vector<std::string>& notes) const
{
    TileStack stack = design.stack;
    if (stack.mode == TileStack::Mode::column || stack.mode == TileStack::Mode::free) return stack;
    const IsohedralType& type = isohedral_type(design.type);
    const CornerVector corners = type.corners_of(design.parameters);
    std::vector<Isometry> aspects;
    for (const CornerMotion& m : type.placed.representatives) aspects.push_back(isometry(m, corners, design.size));
    const std::array<Point2, 2> lattice{design.size * type.placed.lattice[0].at(corners), design.size * type.placed.lattice[1].at(corners)};
    const IsohedralOffsets offsets(aspects, lattice, stack_motion(stack));
    if (!offsets.any()) {
        notes.push_back("the mirror of the stack is none of the new tile: its layers form columns");
        return {};
    }
    if (stack.mode == TileStack::Mode::shift) {
        const Point2 c = lattice_coordinates(lattice_, stack.offset);
        stack.offset = c.x * lattice[0] + c.y * lattice[1];
    }
    const Point2 nearest = offsets.nearest(stack.offset);
    if (glm::length(nearest - stack.offset) > 1e-12 * design.size) stack.offset = nearest;
    return stack;
}

void LayeredTile::set_parameters(std::span<const double> values)
{
    TileDesign design = design_;
    design.parameters.assign(values.begin(), values.end());
    std::vector<std::string> notes;
    design.stack = stack_along(design, notes);
    become(std::move(design));
    notes_ = std::move(notes);
}

void LayeredTile::drag_corner(int k, const Point2& to)
{
    if (k < 0 || k >= type_->corners) throw TileRefusal(TileRefusal::Reason::no_such_point, fmt::format("the tile has no point v{}", k));
    if (type_->parameters.empty()) throw TileRefusal(TileRefusal::Reason::fixed, fmt::format("corners of {} are fixed", type_->name()));
    const Point2 from = corner(corners_, k);
    double step = 1;
    for (int halvings = 0;; ++halvings, step *= 0.5) {
        const MovedTile moved = druse::drag_corner(*type_, design_.parameters, k, from + step * (to / size() - from));
        TileDesign design = design_;
        design.parameters = moved.parameters;
        if (moved.frame.size != 1 || moved.frame.rotation != 0 || moved.frame.origin != Point2(0.0)) {
            // The corner is held in the frame: the frame moves, and what is inside stays where it is in the world.
            design.size = size() * moved.frame.size;
            design.rotation = std::remainder(design_.rotation + moved.frame.rotation * (180.0 / std::numbers::pi), 360.0);
            design.origin = frame().world(moved.frame.origin);
            for (Point2& p : design.interior) p = design.size * moved.frame.canonical(p / size());
        }
        std::vector<std::string> notes;
        try {
            design.stack = stack_along(design, notes);
            become(std::move(design));
            if (halvings > 0) notes.push_back(fmt::format("corner v{} stops before the tile would fold", k));
            notes_ = std::move(notes);
            return;
        } catch (const CommandError&) {
            if (halvings == 20) throw;
        }
    }
}

void LayeredTile::set_path(int path, std::vector<Point2> points)
{
    if (path < 0 || path >= std::ssize(design_.paths))
        throw TileRefusal(TileRefusal::Reason::no_such_path, fmt::format("{} has no path {}: it has {}", type_->name(), path, design_.paths.size()));
    TileDesign design = design_;
    design.paths[path] = std::move(points);
    become(std::move(design));
}

/// A place of the plane in the frame of the path of an edge, in its stored half for what is stored there.
LayeredTile::PathPlace LayeredTile::place_in_path(int edge, const Point2& at, bool mirrored) const
{
    const auto [path, preparation] = type_->edges[edge];
    const Point2 from = size() * corner(corners_, edge), to = size() * corner(corners_, type_->symbol.corner(edge + 1));
    PathPlace place{path, prepared_point(off_edge(at, from, to), preparation)};
    if (mirrored) place.at = prepared_point(place.at, type_->shapes[path] == PathShape::half_turn ? Preparation::half_turn : Preparation::flip);
    if (type_->shapes[path] == PathShape::straight) place.at.y = 0;
    return place;
}

PointName LayeredTile::add_path_point(const Point2& at)
{
    const int i = nearest_side(outline_.positions(), at).side, edge = outline_.points[i].edge;
    const int inner = outline_.corner[edge + 1] - outline_.corner[edge] - 1;
    const auto [path, preparation] = type_->edges[edge];
    // The new point comes behind `index` inner points of the path.
    int index = runs_backwards(preparation) ? inner - outline_.points[i].place : outline_.points[i].place;
    bool mirrored = false;
    if (is_half_stored(*type_, path)) {
        mirrored = index > inner - index || (index == inner - index && place_in_path(edge, at, false).at.x > 0.5);
        if (index > inner - index) index = inner - index;
    }
    PathPlace place = place_in_path(edge, at, mirrored);
    TileDesign design = design_;
    auto& points = design.paths[path];
    if (is_half_stored(*type_, path) && type_->shapes[path] != PathShape::half_turn && index == std::ssize(points)) {
        // Near the middle it is its own mirror image.
        const double length = glm::length(size() * (corner(corners_, type_->symbol.corner(edge + 1)) - corner(corners_, edge)));
        if (std::abs(place.at.x - 0.5) * length <= snap()) place.at.x = 0.5;
    }
    points.insert(points.begin() + index, place.at);
    become(std::move(design), shifted_names(path, index, 1));
    const int here = outline_.find(*type_, {mirrored ? PointName::Kind::mirrored : PointName::Kind::path, path, index, edge});
    return here >= 0 ? outline_.points[here].name : PointName{PointName::Kind::path, path, index, -1};
}

void LayeredTile::move_path_point(const PointName& point, const Point2& to)
{
    const OutlinePoint& p = outline_.points[path_point(point)];
    move_path_point_in_path(point, place_in_path(p.edge, to, p.name.kind == PointName::Kind::mirrored).at);
}

void LayeredTile::move_path_point_in_path(const PointName& point, const Point2& uv)
{
    const PointName name = outline_.points[path_point(point)].name;
    TileDesign design = design_;
    Point2& stored = design.paths[name.path][name.index];
    const bool is_middle = is_half_stored(*type_, name.path) && stored.x == 0.5;
    stored = uv;
    if (is_middle) stored.x = 0.5; // its own mirror image, across only
    if (type_->shapes[name.path] == PathShape::straight) stored.y = 0;
    become(std::move(design));
}

void LayeredTile::remove_path_point(const PointName& point)
{
    const PointName name = outline_.points[path_point(point)].name;
    TileDesign design = design_;
    auto& points = design.paths[name.path];
    points.erase(points.begin() + name.index);
    become(std::move(design), shifted_names(name.path, name.index, -1));
}

/// The number of a point of a path that can be edited.
int LayeredTile::path_point(const PointName& point) const
{
    const int i = find(point);
    if (point.kind == PointName::Kind::middle)
        throw TileRefusal(TileRefusal::Reason::fixed, fmt::format("{} is the middle of a path that a half turn keeps: it stays where it is", point.text()));
    if (!point.is_of_path()) throw TileRefusal(TileRefusal::Reason::no_such_point, fmt::format("{} is no point of a path", point.text()));
    return i;
}

void LayeredTile::switch_type(int number)
{
    const IsohedralType& type = isohedral_type(number);
    if (&type == type_) return;
    std::vector<std::string> notes;
    TileDesign design = design_;
    design.type = number;
    if (type.net == type_->net) {
        const MovedTile moved = nearest_tile(type, corners_);
        design.parameters = moved.parameters;
        design.size = size() * moved.frame.size;
        design.rotation = std::remainder(design_.rotation + moved.frame.rotation * (180.0 / std::numbers::pi), 360.0);
        design.origin = frame().world(moved.frame.origin);
        for (Point2& p : design.interior) p = design.size * moved.frame.canonical(p / size());
    } else {
        design.parameters = type.default_parameters();
    }
    design.paths.assign(type.shapes.size(), {});
    for (std::size_t p = 0; p < std::min(design.paths.size(), design_.paths.size()); ++p)
        design.paths[p] = refitted(whole_path(*type_, static_cast<int>(p), design_.paths[p]), type, static_cast<int>(p));
    if (design.stack.mode != TileStack::Mode::column) notes.push_back("layers form columns: the offset was of another type");
    design.stack = {};

    // Paths that do not fit go, from the last on; then what is not inside.
    const auto outline_of = [&] { return make_outline(type, type.corners_of(design.parameters), design.size, design.paths).positions(); };
    const auto is_simple = [&] {
        try {
            const Pane pane(outline_of(), {}, {.snap = 0.0, .weld = 1e-9 * design.size});
            return pane.report().notes.empty();
        } catch (const PaneRefusal&) {
            return false;
        }
    };
    for (std::size_t p = design.paths.size(); p-- > 0 && !is_simple();) {
        if (design.paths[p].empty()) continue;
        design.paths[p].clear();
        notes.push_back(fmt::format("path {} does not fit {}, and is straight", p, type.name()));
    }
    const std::vector<Point2> polygon = outline_of();
    std::vector<std::optional<int>> kept;
    std::vector<Point2> inside;
    for (const Point2& p : design.interior) {
        const bool is_inside = contains(polygon, p) && nearest_side(polygon, p).distance > design.size * 1e-9;
        kept.push_back(is_inside ? std::optional(static_cast<int>(inside.size())) : std::nullopt);
        if (is_inside) inside.push_back(p);
    }
    if (inside.size() < design.interior.size())
        notes.push_back(fmt::format("{} points are not inside {}, and go", design.interior.size() - inside.size(), type.name()));
    design.interior = std::move(inside);
    const TileOutline outline = make_outline(type, type.corners_of(design.parameters), design.size, design.paths);
    const auto of_paths = same_places(*type_, design_.paths, type, design.paths);
    const auto renamed = [&](const PointName& name) -> std::optional<PointName> {
        if (name.kind == PointName::Kind::interior) {
            const auto now = kept[static_cast<std::size_t>(name.index)];
            return now ? std::optional(PointName::interior(*now)) : std::nullopt;
        }
        PointName now = name;
        if (name.is_of_path()) {
            const auto found = of_paths.find({name.kind, name.path, name.index, -1});
            if (found == of_paths.end()) return {};
            now = found->second;
            now.edge = name.edge;
        }
        return outline.find(type, now) >= 0 ? std::optional(now) : std::nullopt;
    };
    if (is_extruded()) design.heights = heights_on(outline, type, *this, renamed, notes);
    std::vector<std::vector<PointName>> segments;
    for (const auto& chain : design.segments) {
        std::vector<PointName> rest;
        for (const PointName& name : chain)
            if (const auto now = renamed(name)) rest.push_back(*now);
        if (rest.size() == chain.size()) segments.push_back(std::move(rest));
    }
    if (segments.size() < design.segments.size()) notes.push_back(fmt::format("{} segments go with their points", design.segments.size() - segments.size()));
    design.segments = std::move(segments);
    try {
        become(design);
    } catch (const PaneRefusal&) {
        notes.push_back("segments that leave the outline go");
        design.segments.clear();
        become(design);
    }
    notes_ = std::move(notes);
}

} // namespace druse
