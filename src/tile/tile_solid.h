#pragma once

#include "dlfl/mesh_builder.h"
#include "tile/carve.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace druse {

/// What the bottom of a tile is: the top of the layer below, its own top (which fills columns), or flat (which fills nothing, but prints well).
enum class TileBottom { carved, column, flat };

/// Face groups of a solid.
inline constexpr int top_group = 1, bottom_group = 2, wall_group = 3;

/// Points of a solid with clearance are so far apart in the plane, in units of the size of the tile: nearer ones could be one in the 32 bits that STL has for a
/// coordinate. Joints get narrower by four times as much at most, which check() does not mind.
inline constexpr double joint_weld = 2.5e-7;

/// A layered tile as a solid: two reliefs over one polygon, and a wall below each of its sides. In the tile frame, z from the layer's own plane.
struct TileSolid {
    HeightField top, bottom;
    std::vector<std::vector<std::uint32_t>> top_rim, bottom_rim; // over and below each side of the polygon, both corners among them
    Thinnest thinnest;
    int steep = 0;   // triangles where a clearance is not reached, as reliefs are steeper than 75° there
    double lost = 0; // area of what a clearance cuts off the outline: pieces that hang on it by less than a joint

    std::size_t vertices() const { return top.points.size() + bottom.points.size(); }
    std::size_t faces() const { return top.triangles.size() + bottom.triangles.size() + top_rim.size(); }
};

/// The aspect that stands for a solid of the stack: of a free stack, the first one with that member. @throws CommandError where there is none
int aspect_of_member(const LayeredTile& tile, int member);
int member_count(const LayeredTile& tile);

/// One of the different solids that a stack is built from.
struct TilePart {
    int aspect = 0, member = 0; // with which make_solid() makes it
    int layer = 0;              // 1: above one of those, in a stack of mirrors
    bool mirrored = false;      // the mirror image of the proto-tile, or of that member's other part
    Isometry place;             // of one tile that looks so, in the tile frame
};

/// All of them, the proto-tile first: one for each member of a free stack, and the mirror images where aspects or layers are reflections.
std::vector<TilePart> tile_parts(const LayeredTile& tile);

/// The solid of the tile in an aspect, moved back into the tile frame. It may be pierced: see thinnest.
/// With a clearance, joints between solids are that wide, half of it taken from each: the outline shrinks, and top and bottom move apart; steeper than 75° counts
/// as 75°.
/// @throws TileRefusal phase before extrude(), vanishes where the clearance leaves nothing
TileSolid make_solid(const LayeredTile& tile, TileBottom bottom = TileBottom::carved, int aspect = 0, double clearance = 0);

/// A solid but for its heights: what its outline, its place in the stack and the triangles in the plane decide, which takes most of the time to make. So solids follow
/// heights while these are edited; they are those that make_solid() makes, to the last digit.
class SolidPlan {
public:
    /// As make_solid(), which is a plan and its solid. @throws what that throws
    explicit SolidPlan(const LayeredTile& tile, TileBottom bottom = TileBottom::carved, int aspect = 0, double clearance = 0);

    /// Whether only heights and thickness of the tile may differ from those that the plan was made from. Cost: linear, some microseconds for 2 000 points.
    bool fits(const LayeredTile& tile) const;
    /// Precondition: fits(tile).
    TileSolid solid(const LayeredTile& tile) const;

private:
    TileBottom bottom_;
    double clearance_, lost_ = 0;
    std::optional<Carving> top_, under_, whole_under_; // none: as the tile is; under_: as the top is

    // What it follows from.
    double size_;
    int outline_count_;
    HeightField plane_; // its heights do not count
    std::vector<Isometry> aspects_;
    std::array<Point2, 2> lattice_;
    TileStack stack_;
};

/// ∫ over the region of the top minus that of the bottom: the volume, also where the top pierces the bottom.
double volume(const TileSolid& solid);

/// Where a solid goes: a motion in the plane, then up.
struct SolidPlace {
    Isometry motion;
    double up = 0;
};

/// Adds the solid to a mesh. V = Vt + Vb, F = Tt + Tb + sides, genus 0; a reflection gives the mirror image, still turned outside out.
/// `groups`: of top, bottom and walls.
void add_solid(MeshBuilder& builder, const TileSolid& solid, const SolidPlace& place, const std::array<int, 3>& groups = {top_group, bottom_group, wall_group});

} // namespace druse
