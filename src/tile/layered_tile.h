#pragma once

#include "pane/pane.h"
#include "tile/height_field.h"
#include "tile/isohedral_type.h"
#include "tile/tile_design.h"
#include "tile/tile_motion.h"
#include "tile/tile_outline.h"
#include "tile/tile_refusal.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace druse {

/// One of the tiles of a tiling: the tile itself, moved by an aspect and then by a place of the lattice.
struct TileCopy {
    int aspect = 0;
    LatticePlace shift;

    friend bool operator==(const TileCopy&, const TileCopy&) = default;
};

/// An isohedral tile of the plane with points and lines inside, and with a relief upon it: a value, of which a TileDesign tells all.
///
/// Points are numbered: those of the outline anticlockwise from corner 0, then those inside as the design has them. All positions are in the tile frame (see
/// TileDesign); the outline is derived from the paths, so that copies fit whatever is edited. Triangles are those of a Pane, a function of
/// the design alone. Heights belong to orbits of points of the outline, and to each point inside.
///
/// An edit happens whole or throws (TileRefusal, PaneRefusal or another CommandError) and changes nothing; notes() then tells of the last one. Points keep their heights
/// through edits of the plane, and new ones take the height that the surface had there.
/// Cost: an edit of the plane triangulates anew, some milliseconds for 5 000 points; a height, the points. Reading is safe in several threads.
/// Source: Howison & Séquin 2009, section 2.
class LayeredTile {
public:
    /// @throws CommandError where the design is none of a tile
    explicit LayeredTile(TileDesign design);
    /// The tile of that type as it is by default.
    static LayeredTile of_type(int number, double size = 1.0);

    // --- reading ---------------------------------------------------------------------------------------------------------------------------
    const TileDesign& design() const { return design_; }
    const IsohedralType& type() const { return *type_; }
    double size() const { return design_.size; }
    double weld() const { return 1e-9 * design_.size; } // points nearer than this are one
    double snap() const { return design_.size / 500; }  // new places this near to something mean it
    const CornerVector& corners() const { return corners_; } // in the frame of the type: size 1
    TileFrame frame() const;
    /// Where a place of the tile frame lies in the world, and back.
    Isometry to_world() const;

    const TileOutline& outline() const { return outline_; }
    int outline_count() const { return outline_.size(); }
    int point_count() const { return static_cast<int>(surface_.points.size()); }
    Point2 position(int point) const { return Point2(surface_.points[point]); }
    double height(int point) const { return surface_.points[point].z; }
    PointName name(int point) const;
    /// @throws TileRefusal no_such_point
    int find(const PointName& name) const;
    /// The points that have their height in common with this one, itself among them.
    std::vector<int> orbit(int point) const;
    /// By what heights() of the design call the orbit of a point: its first one.
    PointName orbit_name(int point) const;
    /// Segments as pairs of points that are neighbours on one.
    std::vector<std::array<int, 2>> constrained_edges() const;
    const HeightField& surface() const { return surface_; } // the top: heights, without the thickness
    double area() const { return area_; }

    // --- copies ----------------------------------------------------------------------------------------------------------------------------
    const std::vector<Isometry>& aspects() const { return aspects_; }
    const std::array<Point2, 2>& lattice() const { return lattice_; }
    Isometry motion(const TileCopy& copy) const;
    TileCopy neighbour(const TileCopy& copy, int edge) const;
    /// All copies that may meet a box, in order of aspect, i and j. `after`: a motion of the whole tiling.
    std::vector<TileCopy> copies_in(const FlatBox& box, const Isometry& after = {}) const;
    /// The copy that holds a place; on a common boundary, one of them.
    TileCopy copy_at(const Point2& p) const;
    /// The relief of the whole layer at any place.
    double layer_height(const Point2& p) const;

    // --- phase I: the frame and the outline ----------------------------------------------------------------------------------------------------
    void set_frame(double size, double rotation, const Point2& origin);
    void set_parameters(std::span<const double> values);
    /// Moves corner k as near to a place as it can come; where it cannot go on, it stops. Points inside stay where they are in the world.
    void drag_corner(int k, const Point2& to);
    void set_path(int path, std::vector<Point2> points);
    /// A point on the piece of the outline nearest to `at`, which may be drawn out of it.
    PointName add_path_point(const Point2& at);
    /// Moves a point of a path, of any edge that has it: in the tile frame, or in the frame of the path.
    void move_path_point(const PointName& point, const Point2& to);
    void move_path_point_in_path(const PointName& point, const Point2& uv);
    void remove_path_point(const PointName& point);
    /// Keeps paths by letter as far as they fit the new type, and what then is inside.
    void switch_type(int number);

    // --- phase I: points and segments inside -----------------------------------------------------------------------------------------------------
    /// The point made, or the one that is there within snap(); near the outline, a point of a path.
    PointName add_point(const Point2& at);
    void move_point(const PointName& point, const Point2& to);
    void remove_point(const PointName& point);
    void constrain(std::span<const PointName> path);
    /// Takes away the segment that runs from the first point of the path to the last, by those between.
    void unconstrain(std::span<const PointName> path);
    Pane::Refined refine(const Pane::Refinement& refinement, Progress* progress = nullptr);

    // --- stack and phase II ------------------------------------------------------------------------------------------------------------------------
    /// Moves the offset to the nearest one that keeps the stack isohedral, where it is within `reach`. Refused else: offset-not-isohedral.
    void set_stack(const TileStack& stack, std::optional<double> reach = {});
    void extrude(double thickness);
    bool is_extruded() const { return design_.thickness.has_value(); }
    double thickness() const { return design_.thickness.value_or(0.0); }
    /// Sets the heights of points and of all in their orbits, or adds to them. Refused before extrude(): phase.
    void set_heights(std::span<const int> points, double height);
    void add_heights(std::span<const int> points, double by);
    /// A height for each of the points; of those in one orbit, the first one given decides.
    void set_heights(std::span<const int> points, std::span<const double> heights);

    /// How many places of the lattice a drawing of the tiling shows.
    void set_across(int x, int y) { design_.across = {x, y}; }

    std::size_t bytes() const; // of memory, beside the tile itself
    friend bool operator==(const LayeredTile& a, const LayeredTile& b) { return a.design_ == b.design_; }

    /// What there is to say about the last edit, one line each.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    using Rename = std::function<std::optional<PointName>(const PointName&)>;
    struct PathPlace {
        int path = 0;
        Point2 at{0.0}; // in the path, as it is stored
    };

    LayeredTile() = default;
    void derive(const LayeredTile* before = nullptr);
    void derive_plane();
    Pane make_pane() const;
    void take_inside(const Pane& pane, const LayeredTile* before, Progress* progress = nullptr);
    void take_heights();
    TileStack stack_along(const TileDesign& design, std::vector<std::string>& notes) const;
    PathPlace place_in_path(int edge, const Point2& at, bool mirrored) const;
    int path_point(const PointName& point) const;
    int inner_point(const PointName& point) const;
    void become(TileDesign design, const Rename& renamed = {});
    template <class F>
    PointName change_inside(F&& change, Progress* progress = nullptr);
    template <class F>
    void change_heights(std::span<const int> points, F&& f);
    std::string named(const std::string& text) const;

    TileDesign design_;
    std::vector<std::string> notes_;

    // What follows from it.
    const IsohedralType* type_ = nullptr;
    CornerVector corners_{};
    TileOutline outline_;
    std::vector<Isometry> aspects_;
    std::array<Point2, 2> lattice_{};
    HeightField surface_;
    double area_ = 0;
};

} // namespace druse
