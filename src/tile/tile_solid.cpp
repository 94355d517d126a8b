#include "tile/tile_solid.h"

#include "tile/tile_inset.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace druse {

namespace {

/// `this stack has 4 solids, 0 to 3`; of one, `IH41 has 1 aspect, 0`.
std::string numbered_from_0(int count, const std::string& whose, const std::string& what)
{
    return count == 1 ? fmt::format("{} 1 {}, 0", whose, what) : fmt::format("{} {} {}s, 0 to {}", whose, count, what, count - 1);
}

/// The sides of the outline, each as a chain of two points.
std::vector<std::vector<std::uint32_t>> plain_rim(std::uint32_t count)
{
    std::vector<std::vector<std::uint32_t>> rim;
    for (std::uint32_t k = 0; k < count; ++k) rim.push_back({k, k + 1 == count ? 0 : k + 1});
    return rim;
}

void raise(HeightField& field, double by)
{
    for (Point& p : field.points) p.z += by;
}

/// Twice the volume over the plane, times three.
double sixfold_volume(const HeightField& field)
{
    double sum = 0;
    for (const auto& t : field.triangles) {
        const Point &a = field.points[t[0]], &b = field.points[t[1]], &c = field.points[t[2]];
        const Point2 u(b - a), v(c - a);
        sum += (u.x * v.y - u.y * v.x) * (a.z + b.z + c.z);
    }
    return sum;
}

const double steepest_cosine = std::cos(75.0 * std::numbers::pi / 180.0);

/// The cosine of how steep a triangle is.
double slope_cosine(const HeightField& field, const std::array<std::uint32_t, 3>& t)
{
    const Point &a = field.points[t[0]], &b = field.points[t[1]], &c = field.points[t[2]];
    return unit(glm::cross(b - a, c - a), 0.0, Vector(0, 0, 1)).z;
}

/// Moves the points of a field, which was cut out of `whole`, up or down so far that it is `by` away from that everywhere: as far as the steepest triangle asks that
/// lies within `by` of one of theirs, where 75° is the steepest. So what comes from the other side of the same relief is twice as far away.
/// @return how many triangles are nearer, for something is steeper there
int part(HeightField& field, const HeightField& whole, double by, double direction)
{
    std::vector<FlatBox> boxes;
    std::vector<double> cosine;
    for (const auto& t : whole.triangles) {
        FlatBox& box = boxes.emplace_back();
        for (const std::uint32_t v : t) box.add(Point2(whole.points[v]));
        cosine.push_back(slope_cosine(whole, t));
    }
    const FlatGrid grid(boxes);
    std::vector<double> least(field.points.size(), 1.0);
    int nearer = 0;
    for (const auto& t : field.triangles) {
        FlatBox box;
        for (const std::uint32_t v : t) box.add(Point2(field.points[v]));
        double steepest = slope_cosine(field, t);
        grid.for_each(box.grown(by), [&](std::uint32_t i) { steepest = std::min(steepest, cosine[i]); });
        nearer += steepest < steepest_cosine;
        for (const std::uint32_t v : t) least[v] = std::min(least[v], steepest);
    }
    for (std::size_t i = 0; i < least.size(); ++i) field.points[i].z += direction * by / std::max(least[i], steepest_cosine);
    return nearer;
}

} // namespace

int member_count(const LayeredTile& tile)
{
    const auto members = stack_members(tile.aspects(), tile.lattice(), tile.design().stack);
    return 1 + *std::max_element(members.begin(), members.end());
}

int aspect_of_member(const LayeredTile& tile, int member)
{
    const auto members = stack_members(tile.aspects(), tile.lattice(), tile.design().stack);
    const auto found = std::find(members.begin(), members.end(), member);
    if (found == members.end()) throw CommandError(fmt::format("member={}: {}", member, numbered_from_0(member_count(tile), "this stack has", "solid")));
    return static_cast<int>(found - members.begin());
}

std::vector<TilePart> tile_parts(const LayeredTile& tile)
{
    const auto members = stack_members(tile.aspects(), tile.lattice(), tile.design().stack);
    std::vector<TilePart> parts;
    const auto add = [&](int aspect, int member, int layer, const Isometry& place) {
        const bool mirrored = reflects(place);
        const bool known = std::ranges::any_of(parts, [&](const TilePart& p) { return p.member == member && p.mirrored == mirrored; });
        if (!known) parts.push_back({aspect, member, layer, mirrored, place});
    };
    for (int layer = 0; layer < (tile.design().stack.mode == TileStack::Mode::mirror ? 2 : 1); ++layer)
        for (int a = 0; a < tile.type().aspects(); ++a) {
            const Isometry& aspect = tile.aspects()[static_cast<std::size_t>(a)];
            add(a, members[static_cast<std::size_t>(a)], layer, layer == 0 ? aspect : stack_motion(tile.design().stack) * aspect);
        }
    return parts;
}

SolidPlan::SolidPlan(const LayeredTile& tile, TileBottom bottom, int aspect, double clearance)
    : bottom_(bottom), clearance_(clearance), size_(tile.size()), outline_count_(tile.outline_count()), plane_(tile.surface()), aspects_(tile.aspects()),
      lattice_(tile.lattice()), stack_(tile.design().stack)
{
    if (!tile.is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "a solid comes after tile.extrude");
    if (aspect < 0 || aspect >= tile.type().aspects())
        throw CommandError(fmt::format("aspect={}: {}", aspect, numbered_from_0(tile.type().aspects(), tile.type().name() + " has", "aspect")));
    const std::vector<Point2> outline = tile.outline().positions();
    const auto below = inverse(stack_motion(stack_) * tile.aspects()[aspect]);
    const bool is_carved = bottom == TileBottom::carved;
    if (clearance > 0) {
        const double weld = joint_weld * tile.size();
        const auto [cutter, lost] = inset(outline, 0.5 * clearance, weld);
        lost_ = lost;
        if (cutter.empty()) throw TileRefusal(TileRefusal::Reason::vanishes, fmt::format("clearance {} leaves nothing of the tile", clearance));
        top_ = carve(tile, cutter, {}, weld);
        if (is_carved) under_ = carve(tile, cutter, below, weld);
        if (is_carved) whole_under_ = carve(tile, outline, below);
    } else if (is_carved && stack_.mode != TileStack::Mode::column) {
        under_ = carve(tile, outline, below);
    }
}

bool SolidPlan::fits(const LayeredTile& tile) const
{
    const HeightField& surface = tile.surface();
    const auto same_place = [](const Point& p, const Point& q) { return Point2(p) == Point2(q); };
    const auto same_motion = [](const Isometry& g, const Isometry& h) { return g.x == h.x && g.y == h.y && g.shift == h.shift; };
    return tile.is_extruded() && tile.size() == size_ && tile.outline_count() == outline_count_ && std::ranges::equal(tile.aspects(), aspects_, same_motion) &&
           tile.lattice() == lattice_ && tile.design().stack == stack_ && surface.triangles == plane_.triangles &&
           std::ranges::equal(surface.points, plane_.points, same_place);
}

TileSolid SolidPlan::solid(const LayeredTile& tile) const
{
    ASSERT(fits(tile), "the plan of a solid is of the same plane");
    const Carving* top = top_ ? &*top_ : nullptr;
    const Carving* under = under_ ? &*under_ : top;
    const auto field = [&](const Carving* cut) { return cut ? cut->over(tile.surface()) : tile.surface(); };
    const auto rim = [&](const Carving* cut) { return cut ? cut->rim : plain_rim(static_cast<std::uint32_t>(outline_count_)); };
    TileSolid solid;
    solid.top = field(top);
    solid.bottom = field(under);
    solid.top_rim = rim(top);
    solid.bottom_rim = rim(under);
    solid.lost = lost_;
    if (clearance_ > 0) {
        const HeightField whole_under = field(whole_under_ ? &*whole_under_ : nullptr);
        solid.steep = part(solid.top, tile.surface(), 0.5 * clearance_, -1) + part(solid.bottom, whole_under, 0.5 * clearance_, 1);
    }
    if (bottom_ == TileBottom::flat)
        for (Point& p : solid.bottom.points) p.z = 0.5 * clearance_;
    raise(solid.top, tile.thickness());
    solid.thinnest = thinnest(solid.top, solid.bottom);
    return solid;
}

TileSolid make_solid(const LayeredTile& tile, TileBottom bottom, int aspect, double clearance) { return SolidPlan(tile, bottom, aspect, clearance).solid(tile); }

double volume(const TileSolid& solid) { return (sixfold_volume(solid.top) - sixfold_volume(solid.bottom)) / 6.0; }

void add_solid(MeshBuilder& builder, const TileSolid& solid, const SolidPlace& place, const std::array<int, 3>& groups)
{
    const std::uint32_t first = builder.vertex_count(), below = first + static_cast<std::uint32_t>(solid.top.points.size());
    for (const HeightField* field : {&solid.top, &solid.bottom})
        for (const Point& p : field->points) builder.add_vertex(Point(place.motion(Point2(p)), p.z + place.up));
    const bool mirrored = reflects(place.motion);
    std::vector<std::uint32_t> face;
    const auto add = [&](int group) {
        if (mirrored) std::reverse(face.begin() + 1, face.end());
        builder.add_face(face, group);
    };
    for (const auto& t : solid.top.triangles) {
        face.assign({first + t[0], first + t[1], first + t[2]});
        add(groups[0]);
    }
    for (const auto& t : solid.bottom.triangles) {
        face.assign({below + t[0], below + t[2], below + t[1]});
        add(groups[1]);
    }
    for (std::size_t k = 0; k < solid.top_rim.size(); ++k) {
        face.clear();
        for (const std::uint32_t v : solid.bottom_rim[k]) face.push_back(below + v);
        for (std::size_t i = solid.top_rim[k].size(); i-- > 0;) face.push_back(first + solid.top_rim[k][i]);
        add(groups[2]);
    }
}

} // namespace druse
