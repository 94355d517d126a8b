#pragma once

#include "ui/live_step.h"
#include "ui/plane_view.h"
#include "ui/pointer.h"
#include "ui/session.h"
#include "ui/tile_offset.h"
#include "ui/shown_tile.h"

#include "render/image.h"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace druse::ui {

/// What lies under the pointer: a point, or an edge of the outline, or the inside of a copy of the tile.
struct TileHit {
    std::size_t copy = 0; // of those that are drawn
    int point = -1;       // of the tile; −1: none
    int edge = -1;        // of the outline, from this point to the next; −1: none
    bool inside = false;
    Point2 at{0.0};       // the pointer's place, pulled back to the tile

    friend bool operator==(const TileHit&, const TileHit&) = default;
};

/// A point that is dragged, where it was asked to go and could not.
struct RefusedPlace {
    std::size_t copy = 0;
    int point = 0;
    Point2 at{0.0}; // pulled back to the tile
};

/// The plane of a tile without its window: what is drawn of it, and what the mouse does. Each gesture is a command to the session, and one step.
class TileView {
public:
    enum class Tool { edit, heights, offset };
    struct Shown {
        bool neighbours = true, triangles = true, centres = true, arrows = false, grid = true;
        bool snap = false;    // new places are those of the grid
        bool colours = false; // the tiling in its colours, instead of grey
    };

    explicit TileView(Session& session) : session_(session) {}

    std::function<void()> on_redraw;
    std::function<void()> on_select;

    // --- what is shown ------------------------------------------------------------------------------------------------------------

    const ShownTile& tile() const { return tile_; }
    /// The session changed.
    void session_changed();
    void resize(int width, int height);
    const PlaneView& plane() const { return plane_; }
    void frame();
    void zoom(double factor);
    const Shown& shown() const { return shown_; }
    void set_shown(const Shown& shown);
    /// The picture to draw after, where there is one that can be read.
    const Image* picture() const { return picture_.width > 0 ? &picture_ : nullptr; }
    /// Another picture, or the same elsewhere, is shown until the tile changes.
    void try_trace(const std::optional<TileTrace>& trace);
    double grid() const; // units from line to line
    /// Another number when anything changed that is drawn below the tile itself.
    std::uint64_t backdrop() const { return backdrop_; }

    const std::optional<TileHit>& hovered() const { return hovered_; }
    const std::optional<Point2>& pointer() const { return pointer_; }
    const std::optional<RefusedPlace>& refused() const { return refused_; }
    using Line = std::pair<Point2, Point2>;
    /// Both ends of the line that would become a constraint.
    std::optional<Line> rubber() const;
    /// Of the one that could not become one.
    const std::optional<Line>& refused_line() const { return refused_line_; }
    /// Two corners of the box that is dragged, in the picture.
    std::optional<Line> box() const;
    /// Where the layer above would lie, while that is dragged.
    const std::optional<TileOffset>& offset() const { return offset_; }
    std::string hint() const;
    /// `x 3.2  y 1.7  grid 1: ` of the pointer; empty where it is elsewhere.
    std::string place_hint() const;

    // --- selection ----------------------------------------------------------------------------------------------------------------

    const std::set<std::string>& selected() const { return selected_; }
    void select(std::set<std::string> names);
    /// Their names as a command takes them; empty if none is.
    std::string selected_text() const;

    // --- the mouse ----------------------------------------------------------------------------------------------------------------

    Tool tool() const { return tool_; }
    void set_tool(Tool tool);
    /// Something is dragged, and the tile changes all the while.
    bool is_dragging() const { return gesture_ == Gesture::move || gesture_ == Gesture::offset || gesture_ == Gesture::trace; }
    void press(const Pointer& pointer);
    void drag(const Pointer& pointer);
    void release(const Pointer& pointer);
    void hover(const Pointer& pointer);
    void leave();
    void wheel(double notches, const Pointer& pointer);
    /// A drag from point to point makes a constraint from now on, once.
    void start_constraint();
    /// The next drag selects what is in a box.
    void start_box();
    void forget_box() { box_next_ = false; }
    /// Takes away what is selected, or else the point under the pointer.
    void remove();
    /// Escape. @return false if there was nothing to take back
    bool cancel();

private:
    enum class Gesture { none, click, pan, move, constrain, offset, box, trace };

    TileHit hit(const Point2& picture) const;
    int point_near(const Point2& place, std::size_t copy) const;
    std::string place_text(const Point2& p) const;
    Point2 tidy(const Point2& p) const;
    void move_to(const Point2& picture);
    void drag_corner_to(const Point2& at);
    void add_point(const TileHit& at);
    void end_constraint(const Point2& picture);
    void drag_offset(const Point2& picture);
    void drag_trace(const Point2& picture);
    void select_box(const Pointer& pointer);
    void click(const Pointer& pointer);
    void load_picture();
    void note(const std::string& text);
    void redraw();

    Session& session_;
    PlaneView plane_;
    ShownTile tile_;
    std::uint64_t tile_version_ = 0;
    bool framed_ = false;
    Shown shown_;
    Image picture_;
    std::string picture_name_; // the file it is of, or could not be read from
    std::uint64_t backdrop_ = 0;
    std::set<std::string> selected_;

    Tool tool_ = Tool::edit;
    Gesture gesture_ = Gesture::none;
    bool constrain_next_ = false, box_next_ = false;
    Point2 pressed_{0.0}, last_{0.0}; // in the picture
    int button_ = 0;
    TileHit grabbed_;                 // what was pressed
    TilePoint grabbed_point_;         // as it was then: what comes of a drag may have fewer points
    Point2 grip_{0.0};                // from the pointer to the point, pulled back
    std::optional<LiveStep> step_;
    std::optional<TileHit> hovered_;
    std::optional<Point2> pointer_;
    std::optional<TileOffset> offset_;
    Point2 offset_start_{0.0};
    TileTrace grabbed_trace_;
    std::optional<RefusedPlace> refused_;
    std::optional<Line> refused_line_;
};

} // namespace druse::ui
