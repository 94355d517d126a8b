// A LayeredTile: what follows from its design, and reading it. Edits are in layered_tile_outline.cpp, layered_tile_inside.cpp and layered_tile_relief.cpp.
#include "tile/layered_tile.h"

#include "geom/turn.h"
#include "pane/pane_names.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace druse {

namespace {

constexpr double least_area = 1e-6;  // of the square of the size
constexpr double least_angle = 1e-9; // of a corner, radians

void require_finite(double x, const char* what)
{
    if (!(std::abs(x) <= 1e100)) throw CommandError(fmt::format("{} {}: numbers go to 1e100", what, x));
}

/// Refuses corners that make no tile: an area of nothing, or two edges upon each other.
void check_corners(const IsohedralType& type, const CornerVector& corners)
{
    std::vector<Point2> polygon;
    for (int k = 0; k < type.corners; ++k) polygon.push_back(corner(corners, k));
    if (const double area = 0.5 * twice_area(polygon); !(area >= least_area))
        throw TileRefusal(TileRefusal::Reason::flat_corner, fmt::format("these parameters leave {} an area of {:.6g} times the square of its size", type.name(), area));
    for (int k = 0; k < type.corners; ++k) {
        const Point2 at = corner(corners, k), next = corner(corners, type.symbol.corner(k + 1)) - at, last = corner(corners, type.symbol.corner(k - 1)) - at;
        double angle = std::atan2(next.x * last.y - next.y * last.x, glm::dot(next, last));
        if (angle < -least_angle) angle += 2 * std::numbers::pi;
        if (!(angle > least_angle) || glm::length(next) < least_angle)
            throw TileRefusal(TileRefusal::Reason::flat_corner, fmt::format("these parameters leave corner v{} of {} no angle", k, type.name()));
    }
}

} // namespace

LayeredTile::LayeredTile(TileDesign design) : design_(std::move(design)) { derive(); }

LayeredTile LayeredTile::of_type(int number, double size)
{
    const IsohedralType& type = isohedral_type(number);
    TileDesign design;
    design.type = number;
    design.size = size;
    design.parameters = type.default_parameters();
    design.paths.resize(type.shapes.size());
    return LayeredTile(std::move(design));
}

void LayeredTile::derive(const LayeredTile* before)
{
    derive_plane();
    take_inside(make_pane(), before);
}

/// Type, corners, outline and copies: all but what lies inside.
void LayeredTile::derive_plane()
{
    type_ = &isohedral_type(design_.type);
    const auto finite = [](double x, const char* what) { require_finite(x, what); };
    if (!(design_.size > 0)) throw CommandError(fmt::format("size {}: expected above 0", design_.size));
    finite(design_.size, "size");
    finite(design_.rotation, "rotation");
    finite(design_.origin.x, "origin");
    finite(design_.origin.y, "origin");
    for (const double p : design_.parameters) finite(p, "parameter");
    if (design_.thickness && !(*design_.thickness > 0)) throw CommandError(fmt::format("thickness {}: expected above 0", *design_.thickness));
    corners_ = type_->corners_of(design_.parameters);
    check_corners(*type_, corners_);
    if (design_.paths.size() != type_->shapes.size())
        throw CommandError(fmt::format("{} has {} paths ({}), not {}", type_->name(), type_->shapes.size(), type_->shape_text(), design_.paths.size()));
    for (std::size_t p = 0; p < design_.paths.size(); ++p) check_path(*type_, static_cast<int>(p), design_.paths[p]);

    outline_ = make_outline(*type_, corners_, design_.size, design_.paths);
    area_ = 0.5 * twice_area(outline_.positions());
    aspects_.clear();
    for (const CornerMotion& m : type_->placed.representatives) aspects_.push_back(isometry(m, corners_, design_.size));
    for (std::size_t i = 0; i < 2; ++i) lattice_[i] = design_.size * type_->placed.lattice[i].at(corners_);

    if (design_.stack.mode == TileStack::Mode::shift || design_.stack.mode == TileStack::Mode::mirror) {
        const IsohedralOffsets offsets(aspects_, lattice_, stack_motion(design_.stack));
        if (!offsets.any() || !(glm::length(offsets.nearest(design_.stack.offset) - design_.stack.offset) <= weld()))
            throw TileRefusal(TileRefusal::Reason::offset_not_isohedral, not_isohedral_text(type_->name(), aspects_, lattice_, design_.stack));
    }
}

/// The pane of the design: its points have our numbers, and behind them come those where segments cross without one of the design.
Pane LayeredTile::make_pane() const
{
    const int outside = outline_count();
    try {
        Pane pane(outline_.positions(), {}, {.snap = 0.0, .weld = weld()});
        if (!pane.report().notes.empty()) throw TileRefusal(TileRefusal::Reason::boundary_crosses, "the outline turns the wrong way");
        std::vector<PointId> ids;
        try {
            ids = pane.add_all(design_.interior);
        } catch (const PaneRefusal& refusal) {
            throw TileRefusal(TileRefusal::Reason::swallows_point, fmt::format("a point inside would not be inside: {}", refusal.what()));
        }
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (std::size_t(ids[i]) == std::size_t(outside) + i && pane.kind(ids[i]) == PointKind::interior) continue;
            throw TileRefusal(TileRefusal::Reason::swallows_point, fmt::format("point i{} would be on the outline, or on another point", i));
        }
        for (const auto& chain : design_.segments) {
            std::vector<PointId> path;
            for (const PointName& name : chain) path.push_back(PointId(find(name)));
            pane.constrain(path);
        }
        return pane;
    } catch (const PaneRefusal& refusal) {
        throw PaneRefusal(refusal.reason(), named(refusal.what()));
    }
}

/// Points, segments and triangles of a pane whose first ids are our numbers. Points that are new take their height from the surface `before`.
void LayeredTile::take_inside(const Pane& pane, const LayeredTile* before, Progress* progress)
{
    const int rim = outline_count(), known = rim + static_cast<int>(design_.interior.size());
    std::vector<std::uint32_t> number(std::size_t(pane.next_point()), Pane::none);
    std::vector<Point2> interior;
    std::map<PointName, double> inner_heights;
    std::optional<HeightFinder> finder;
    if (before && !before->design_.heights.empty()) finder.emplace(before->surface_);
    for (const PointId id : pane.points()) {
        const int old = static_cast<int>(id);
        number[std::size_t(id)] = static_cast<std::uint32_t>(old < rim ? old : rim + std::ssize(interior));
        if ((pane.kind(id) == PointKind::boundary) != (old < rim))
            throw TileRefusal(TileRefusal::Reason::boundary_crosses, fmt::format("a point inside would be on the outline at ({:.6g}, {:.6g})", pane.position(id).x, pane.position(id).y));
        if (old < rim) continue;
        const PointName name = PointName::interior(static_cast<int>(std::ssize(interior)));
        interior.push_back(pane.position(id));
        if (old < known) {
            if (const auto height = design_.heights.find(PointName::interior(old - rim)); height != design_.heights.end()) inner_heights[name] = height->second;
        } else if (finder) {
            if (progress && old % 256 == 0) progress->step(1.0);
            const Point2& p = interior.back();
            if (const double height = finder->at(inverse(before->motion(before->copy_at(p)))(p)); height != 0) inner_heights[name] = height;
        }
    }
    design_.interior = std::move(interior);
    std::erase_if(design_.heights, [](const auto& item) { return item.first.kind == PointName::Kind::interior; });
    design_.heights.merge(inner_heights);

    surface_.points.clear();
    for (const OutlinePoint& p : outline_.points) surface_.points.emplace_back(p.position, 0.0);
    for (const Point2& p : design_.interior) surface_.points.emplace_back(p, 0.0);
    design_.segments.clear();
    for (const SegmentId segment : pane.segments()) {
        auto& chain = design_.segments.emplace_back();
        for (const PointId id : pane.chain(segment)) chain.push_back(name(static_cast<int>(number[std::size_t(id)])));
    }
    // In an order that depends on the design only.
    surface_.triangles.clear();
    pane.for_triangles([&](PointId a, PointId b, PointId c) {
        std::array<std::uint32_t, 3> t{number[std::size_t(a)], number[std::size_t(b)], number[std::size_t(c)]};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        surface_.triangles.push_back(t);
    });
    std::sort(surface_.triangles.begin(), surface_.triangles.end());
    take_heights();
}

/// Gives each orbit its height; of the design, the first point of an orbit tells it afterwards.
void LayeredTile::take_heights()
{
    std::vector<std::optional<double>> of_orbit(outline_.orbits);
    std::map<PointName, double> kept;
    for (int i = outline_count(); i < point_count(); ++i) surface_.points[i].z = 0; // the design tells of the others only
    for (const auto& [point, height] : design_.heights) {
        require_finite(height, "height");
        const int i = find(point);
        if (i < outline_count()) {
            auto& known = of_orbit[outline_.points[i].orbit];
            if (known && *known != height)
                throw CommandError(fmt::format("points of one orbit have one height: {} has {}, another of them {}", point.text(), height, *known));
            known = height;
        } else {
            surface_.points[i].z = height;
            if (height != 0) kept[name(i)] = height;
        }
    }
    std::vector<bool> told(outline_.orbits);
    for (int i = 0; i < outline_count(); ++i) {
        const int orbit = outline_.points[i].orbit;
        surface_.points[i].z = of_orbit[orbit].value_or(0.0);
        if (!told[orbit] && surface_.points[i].z != 0) kept[name(i)] = surface_.points[i].z;
        told[orbit] = true;
    }
    design_.heights = std::move(kept);
}

/// A message of the pane, with our names of its points.
std::string LayeredTile::named(const std::string& text) const
{
    const auto known = static_cast<std::uint32_t>(outline_count()) + design_.interior.size();
    return with_names(text, [&](std::uint32_t number) { return number < known ? name(static_cast<int>(number)).text() : std::string(); });
}

// --- reading ------------------------------------------------------------------------------------------------------------------------------

TileFrame LayeredTile::frame() const { return {design_.origin, design_.size, design_.rotation * (std::numbers::pi / 180.0)}; }

Isometry LayeredTile::to_world() const
{
    const Point2 t = turn_by_degrees(design_.rotation);
    return {t, {-t.y, t.x}, design_.origin};
}

PointName LayeredTile::name(int point) const
{
    return point < outline_count() ? outline_.points[point].name : PointName::interior(point - outline_count());
}

int LayeredTile::find(const PointName& name) const
{
    int found = -1;
    if (name.kind != PointName::Kind::interior) found = outline_.find(*type_, name);
    else if (name.index >= 0 && name.index < std::ssize(design_.interior)) found = outline_count() + name.index;
    if (found < 0) throw TileRefusal(TileRefusal::Reason::no_such_point, fmt::format("the tile has no point {}", name.text()));
    return found;
}

std::vector<int> LayeredTile::orbit(int point) const
{
    if (point >= outline_count()) return {point};
    std::vector<int> members;
    for (int i = 0; i < outline_count(); ++i)
        if (outline_.points[i].orbit == outline_.points[point].orbit) members.push_back(i);
    return members;
}

PointName LayeredTile::orbit_name(int point) const { return name(orbit(point).front()); }

std::vector<std::array<int, 2>> LayeredTile::constrained_edges() const
{
    std::vector<std::array<int, 2>> edges;
    for (const auto& chain : design_.segments)
        for (std::size_t i = 1; i < chain.size(); ++i) edges.push_back({find(chain[i - 1]), find(chain[i])});
    return edges;
}

std::size_t LayeredTile::bytes() const
{
    std::size_t sum = surface_.points.size() * sizeof(Point) + surface_.triangles.size() * sizeof(surface_.triangles[0]) + design_.interior.size() * sizeof(Point2) +
                      outline_.points.size() * sizeof(OutlinePoint) + design_.heights.size() * 2 * sizeof(*design_.heights.begin()) + design_.kept.size();
    for (const auto& chain : design_.segments) sum += sizeof(chain) + chain.size() * sizeof(PointName);
    return sum;
}

// --- copies -------------------------------------------------------------------------------------------------------------------------------

Isometry LayeredTile::motion(const TileCopy& copy) const
{
    Isometry m = aspects_[copy.aspect];
    m.shift += double(copy.shift.i) * lattice_[0] + double(copy.shift.j) * lattice_[1];
    return m;
}

TileCopy LayeredTile::neighbour(const TileCopy& copy, int edge) const
{
    const TileNeighbour& next = type_->neighbours[copy.aspect][edge];
    return {next.aspect, {copy.shift.i + next.shift.i, copy.shift.j + next.shift.j}};
}

std::vector<TileCopy> LayeredTile::copies_in(const FlatBox& box, const Isometry& after) const
{
    std::vector<TileCopy> found;
    const std::array<Point2, 2> step{turned(after, lattice_[0]), turned(after, lattice_[1])};
    for (int a = 0; a < type_->aspects(); ++a) {
        const Isometry there = after * aspects_[a];
        FlatBox tile;
        for (const OutlinePoint& p : outline_.points) tile.add(there(p.position));
        // Shifts that bring one box over the other, in coordinates of the lattice.
        const FlatBox shifts{box.min - tile.max, box.max - tile.min};
        FlatBox places;
        for (const double x : {shifts.min.x, shifts.max.x})
            for (const double y : {shifts.min.y, shifts.max.y}) places.add(lattice_coordinates(step, {x, y}));
        for (int i = static_cast<int>(std::floor(places.min.x)); i <= static_cast<int>(std::ceil(places.max.x)); ++i)
            for (int j = static_cast<int>(std::floor(places.min.y)); j <= static_cast<int>(std::ceil(places.max.y)); ++j) {
                const Point2 shift = double(i) * step[0] + double(j) * step[1];
                if (FlatBox{tile.min + shift, tile.max + shift}.meets(box)) found.push_back({a, {i, j}});
            }
    }
    return found;
}

TileCopy LayeredTile::copy_at(const Point2& p) const
{
    const std::vector<Point2> polygon = outline_.positions();
    TileCopy best;
    double nearest = 1e300;
    for (const TileCopy& copy : copies_in(FlatBox{p, p}.grown(weld()))) {
        const Point2 q = inverse(motion(copy))(p);
        if (contains(polygon, q)) return copy;
        // Rounding may leave a place on a common boundary outside of all.
        const double distance = nearest_side(polygon, q).distance;
        if (distance >= nearest) continue;
        nearest = distance;
        best = copy;
    }
    return best;
}

double LayeredTile::layer_height(const Point2& p) const { return HeightFinder(surface_).at(inverse(motion(copy_at(p)))(p)); }

} // namespace druse
