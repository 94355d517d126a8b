#include "tile/tile_check.h"

#include "tile/tile_distance.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

constexpr double close = 1e-9; // of the size

double field_area(const HeightField& field)
{
    double twice = 0;
    for (const auto& t : field.triangles) twice += twice_area(std::array{Point2(field.points[t[0]]), Point2(field.points[t[1]]), Point2(field.points[t[2]])});
    return 0.5 * twice;
}

/// How far the pieces of the outline are from those of the neighbours beyond them.
double edge_mismatch(const LayeredTile& tile)
{
    const IsohedralType& type = tile.type();
    const TileOutline& outline = tile.outline();
    double most = 0;
    for (int k = 0; k < type.corners; ++k) {
        const Isometry there = tile.motion(tile.neighbour({}, k));
        const int partner = type.neighbours[0][k].partner, from = outline.corner[k], count = outline.corner[k + 1] - from;
        if (outline.corner[partner + 1] - outline.corner[partner] != count) return 1e300;
        // A copy that is not turned over runs along a common piece the other way.
        for (int s = 0; s <= count; ++s) {
            const int other = outline.corner[partner] + (reflects(there) ? s : count - s);
            const Point2 ours = outline.points[(from + s) % outline.size()].position, its = outline.points[other % outline.size()].position;
            most = std::max(most, glm::length(ours - there(its)));
        }
    }
    return most;
}

/// How far the bottom is from the top of the layer below.
double bottom_mismatch(const LayeredTile& tile, const HeightField& bottom, int aspect)
{
    const Isometry below = stack_motion(tile.design().stack) * tile.aspects()[aspect];
    const HeightFinder finder(tile.surface());
    double most = 0;
    for (const Point& p : bottom.points) {
        const Point2 q = below(Point2(p));
        most = std::max(most, std::abs(p.z - finder.at(inverse(tile.motion(tile.copy_at(q)))(q))));
    }
    return most;
}

/// The least distance of the solids from all that they may come near: around them in their own layer, and above and below. `solids` are by member.
double clearance_found(const LayeredTile& tile, const std::vector<TileSolid>& solids, double reach)
{
    const auto members = stack_members(tile.aspects(), tile.lattice(), tile.design().stack);
    const auto solid_of = [&](int aspect) -> const TileSolid& { return solids[static_cast<std::size_t>(members[static_cast<std::size_t>(aspect)])]; };
    const Isometry up = stack_motion(tile.design().stack);
    double least = reach;
    for (int member = 0; member < static_cast<int>(solids.size()); ++member) {
        const TileCopy own{aspect_of_member(tile, member), {}};
        const Isometry here = tile.motion(own);
        FlatBox box;
        for (const OutlinePoint& p : tile.outline().points) box.add(here(p.position));
        for (int layer = -1; layer <= 1; ++layer) {
            const Isometry carried = layer == 0 ? Isometry{} : layer > 0 ? up : inverse(up);
            for (const TileCopy& copy : tile.copies_in(box.grown(reach), carried))
                if (layer != 0 || !(copy == own))
                    least = std::min(least, distance(solid_of(own.aspect), {here, 0.0}, solid_of(copy.aspect), {carried * tile.motion(copy), layer * tile.thickness()}, least));
        }
    }
    return least;
}

/// Which ways a tile that nothing lies upon can go, where it touches tiles around it and below it: those that lead into none of its walls and of its bottom.
std::vector<std::array<int, 3>> leaving_directions(const LayeredTile& tile, const TileSolid& solid)
{
    std::vector<Vector> barred; // outward normals
    for (int i = 0; i < tile.outline_count(); ++i) {
        const Point2 along = tile.position(tile.outline().next(i)) - tile.position(i);
        barred.push_back(unit(Vector(along.y, -along.x, 0)));
    }
    for (const auto& t : solid.bottom.triangles) {
        const Point &a = solid.bottom.points[t[0]], &b = solid.bottom.points[t[1]], &c = solid.bottom.points[t[2]];
        barred.push_back(unit(glm::cross(c - a, b - a), 0.0, Vector(0, 0, -1)));
    }
    std::vector<std::array<int, 3>> free;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if ((x != 0 || y != 0 || z != 0) && std::ranges::none_of(barred, [&](const Vector& n) { return glm::dot(n, Vector(x, y, z)) > close; })) free.push_back({x, y, z});
    return free;
}

} // namespace

TileCheck check(const LayeredTile& tile, double clearance)
{
    TileCheck found;
    const auto require = [&](bool holds, const std::string& what) {
        if (!holds) found.faults.push_back(what);
    };
    const auto [t1, t2] = tile.lattice();
    const double size = tile.size();
    found.aspects = tile.type().aspects();
    found.orbits = tile.outline().orbits;
    found.area = tile.area();
    found.cell = std::abs(t1.x * t2.y - t1.y * t2.x);
    found.edge_mismatch = edge_mismatch(tile);
    require(std::abs(found.aspects * found.area - found.cell) <= close * found.cell, "the tiles of a cell have not its area");
    require(found.edge_mismatch <= close * size, "a piece of the outline is not that of the neighbour beyond it");
    found.parts = tile_parts(tile);
    if (!tile.is_extruded()) return found;

    TileCheck::Solid& solid = found.solid.emplace();
    const bool is_free = tile.design().stack.mode == TileStack::Mode::free;
    solid.members = member_count(tile);
    solid.thinnest.thickness = 1e300;
    const double steep = size + tile.thickness();
    std::optional<TileSolid> first;
    double volumes = 0;
    for (int a = 0; a < found.aspects; ++a) {
        if (is_free && aspect_of_member(tile, stack_members(tile.aspects(), tile.lattice(), tile.design().stack)[static_cast<std::size_t>(a)]) != a) continue;
        TileSolid made = make_solid(tile, TileBottom::carved, a);
        volumes += volume(made);
        solid.carved_area = field_area(made.bottom);
        require(std::abs(solid.carved_area - found.area) <= close * found.area, fmt::format("what is carved for aspect {} has not the area of the tile", a));
        solid.bottom_mismatch = std::max(solid.bottom_mismatch, bottom_mismatch(tile, made.bottom, a));
        if (made.thinnest.thickness < solid.thinnest.thickness) solid.thinnest = made.thinnest;
        if (!first) {
            first = std::move(made);
        } else if (!is_free) {
            const HeightFinder finder(first->bottom);
            for (const Point& p : made.bottom.points) solid.aspect_mismatch = std::max(solid.aspect_mismatch, std::abs(p.z - finder.at(Point2(p))));
        }
    }
    // Of a free stack, its members have the volume together that they would have alike.
    const int counted = is_free ? solid.members : found.aspects;
    solid.volume = volumes / counted;
    solid.volume_expected = tile.thickness() * found.area;
    require(std::abs(solid.volume - solid.volume_expected) <= close * solid.volume_expected, "the volume is not thickness times area");
    require(solid.bottom_mismatch <= 1e3 * close * steep, "the bottom is not the top of the layer below");
    require(solid.aspect_mismatch <= 1e3 * close * steep, "aspects have different bottoms");
    require(solid.thinnest.thickness > 0, fmt::format("top-under-bottom: {:.6g} at {:.6g},{:.6g}", solid.thinnest.thickness, solid.thinnest.at.x, solid.thinnest.at.y));
    solid.leaves = leaving_directions(tile, *first);
    if (clearance > 0) {
        std::vector<TileSolid> thin;
        for (int m = 0; m < solid.members; ++m) {
            thin.push_back(make_solid(tile, TileBottom::carved, aspect_of_member(tile, m), clearance));
            solid.volume_left += volume(thin.back()) / solid.members;
            solid.lost += thin.back().lost;
            require(thin.back().thinnest.thickness > 0, "the clearance leaves no thickness");
        }
        solid.clearance = clearance_found(tile, thin, 2 * clearance);
        require(solid.clearance >= clearance - 1e-6 * size, fmt::format("joints are {:.6g} wide, not {:.6g}", solid.clearance, clearance));
    }
    return found;
}

} // namespace druse
