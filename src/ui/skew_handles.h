#pragma once

#include "cell/cell_design.h"
#include "geom/point.h"
#include "render/camera.h"

#include <array>
#include <optional>

namespace druse::ui {

/// The nine handles of a skew, one for each entry of its matrix, in a picture of what it makes of the three axes, turned as a camera sees the cell.
///
/// At the tip of each axis are three: the one along the axis's own direction scales it, the two others shear. Each moves along one line. Entries are
/// numbered row by row: the handle of row r at the tip of axis c moves that tip along axis r.
/// Source: Howison & Séquin 2009, section 3.2, fig. 9b.
class SkewHandles {
public:
    /// Handles do not go below this; cell.skew itself goes on to 1e-6.
    static constexpr double least_determinant = 0.05;
    /// Nor farther from 0 than this, unless the entry is there already: numbers that are typed have no such end.
    static constexpr double farthest = 10000;

    struct Handle {
        Point2 place{0.0}; // in pixels from the top left corner of the picture
        Point2 line{0.0};  // by how many pixels it goes for 1
        bool can_move = false; // its line is not seen end on
    };

    /// Where the picture is, in pixels: the place where the axes begin, and how many are a unit.
    struct Place {
        Point2 origin{0.0};
        double pixels = 1;
    };

    SkewHandles(const CellMatrix& matrix, const Camera& camera, const Place& place);
    /// So that all of it is in the middle of a picture, from whichever side it is seen. The scale depends on the matrix only.
    static Place fitting(const CellMatrix& matrix, const Camera& camera, const Point2& middle, double width, double height);

    const Handle& handle(int entry) const { return handles_[static_cast<std::size_t>(entry)]; }
    const Point2& origin() const { return origin_; }
    /// Where the tip of an axis is seen.
    const Point2& tip(int axis) const { return tips_[static_cast<std::size_t>(axis)]; }
    /// Axes from the farthest to the nearest.
    const std::array<int, 3>& order() const { return order_; }
    /// The one at a place, of those that can move.
    std::optional<int> at(const Point2& place) const;
    /// What its entry becomes when the pointer is dragged so far: what is seen of the way goes along the handle's line. Precondition: it can move
    double dragged(int entry, const Point2& by) const;

private:
    CellMatrix matrix_;
    Point2 origin_;
    std::array<Handle, 9> handles_;
    std::array<Point2, 3> tips_;
    std::array<int, 3> order_{0, 1, 2};
};

/// `xx` to `zz`, as in commands.
const char* skew_entry_name(int entry);
double determinant(const CellMatrix& matrix);
/// What an entry may become on the way from what it is to what is wanted, in thousandths: as far as the determinant stays above the least one. One that is below
/// already only grows.
double stopped_skew(const CellMatrix& matrix, int entry, double wanted);

} // namespace druse::ui
