#pragma once

#include "ui/live_step.h"
#include "ui/plane_view.h"
#include "ui/pointer.h"
#include "ui/session.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace druse::ui {

/// The foot of the perpendicular on a straight piece, or the end that is nearer.
Point2 foot_on_piece(const Point2& p, const Point2& a, const Point2& b);

/// A plane with points that are edited by the mouse, without its window: what part of it is seen, its grid, what is selected, and what press, drag and release come to.
/// Each gesture is a command to the session, and one step.
class PlaneEditor {
public:
    using Line = std::pair<Point2, Point2>;

    explicit PlaneEditor(Session& session) : session_(session) {}
    virtual ~PlaneEditor() = default;
    PlaneEditor(const PlaneEditor&) = delete;
    PlaneEditor& operator=(const PlaneEditor&) = delete;

    std::function<void()> on_redraw;
    std::function<void()> on_select;
    std::function<void()> on_box; // one was dragged

    // --- what is shown ------------------------------------------------------------------------------------------------------------

    virtual void session_changed() = 0;
    void resize(int width, int height);
    const PlaneView& plane() const { return plane_; }
    /// Shows all there is.
    void frame();
    void zoom(double factor);
    double grid() const; // units from line to line
    /// Another number when anything changed that is drawn below what is edited.
    std::uint64_t backdrop() const { return backdrop_; }
    const std::optional<Point2>& pointer() const { return pointer_; } // in the picture
    /// Two corners of the box that is dragged, in the picture.
    std::optional<Line> box() const;
    /// Both ends of the line that would become a constraint.
    std::optional<Line> rubber() const;
    /// Of the one that could not become one.
    const std::optional<Line>& refused_line() const { return refused_line_; }
    /// What the mouse does now.
    virtual std::string hint() const = 0;
    /// `x 3.2  y 1.7  grid 1: ` of the pointer; empty where it is elsewhere.
    std::string place_hint() const;
    /// What is said in the middle of an empty plane; nothing where there is something to show.
    virtual std::string invitation() const = 0;

    // --- selection ----------------------------------------------------------------------------------------------------------------

    /// Names of points as commands take them.
    const std::set<std::string>& selected() const { return selected_; }
    void select(std::set<std::string> names);

    // --- the mouse ----------------------------------------------------------------------------------------------------------------

    /// Something is dragged, and the tile changes all the while.
    bool is_dragging() const { return gesture_ == Gesture::edit; }
    void press(const Pointer& pointer);
    void drag(const Pointer& pointer);
    void release(const Pointer& pointer);
    virtual void hover(const Pointer& pointer) = 0;
    virtual void leave() = 0;
    void wheel(double notches, const Pointer& pointer);
    /// A drag from point to point makes a constraint from now on, once.
    void start_constraint();
    /// The next drag selects what is in a box.
    void start_box();
    bool is_gesturing() const { return gesture_ != Gesture::none; }
    bool is_box_next() const { return box_next_ && gesture_ == Gesture::none; }
    void forget_box() { box_next_ = false; }
    /// Takes away what is selected, or else what is under the pointer.
    virtual void remove() = 0;
    /// Escape. @return false if there was nothing to take back
    virtual bool cancel();

protected:
    enum class Gesture { none, click, pan, constrain, box, edit };

    /// The box that frame() shows, if there is anything.
    virtual std::optional<Line> framed() const = 0;
    virtual bool snaps() const = 0; // new places are those of the grid
    virtual bool may_constrain() const { return true; }
    /// What a press of the left button begins where there is something: click, constrain, box, edit or pan.
    virtual Gesture begin(const Pointer& pointer) = 0;
    /// What a click becomes that is dragged: pan, box, constrain or edit.
    virtual Gesture begin_drag(const Pointer& pointer) = 0;
    virtual void click(const Pointer& pointer) = 0;
    /// Of `edit`, to a place in the picture.
    virtual void drag_to(const Point2& picture) = 0;
    /// `edit` is over: it was released, or taken back.
    virtual void end_drag() {}
    virtual void end_constraint(const Point2& picture) = 0;
    /// Where the constraint begins that is dragged.
    virtual std::optional<Point2> constraint_start() const = 0;
    virtual void select_box(const Point2& low, const Point2& high, const Pointer& pointer) = 0;
    virtual void forget_refused() { refused_line_.reset(); }
    /// Ends what is dragged, and what the next drag would do. @return false if there was nothing
    bool take_back();

    /// On the grid if that is asked for; else to a tenth of a pixel, so that commands can be read.
    Point2 tidy(const Point2& p) const;
    std::string place_text(const Point2& p) const;
    double reach() const; // in the plane, of what the pointer means
    /// What a click with these keys selects on a point.
    void select_clicked(const std::string& name, const Pointer& pointer);
    /// Runs a command that draws this line; where it is refused, that is shown.
    void draw_line(const std::string& command, const Line& line);
    bool is_refused() const; // the last command
    void note(const std::string& text);
    void redraw();

    Session& session_;
    PlaneView plane_;
    bool is_framed_ = false;
    std::uint64_t backdrop_ = 0;
    std::set<std::string> selected_;

    Gesture gesture_ = Gesture::none;
    bool constrain_next_ = false, box_next_ = false;
    Point2 pressed_{0.0}, last_{0.0}; // in the picture
    int button_ = 0;
    std::optional<LiveStep> step_;
    std::optional<Point2> pointer_;
    std::optional<Line> refused_line_;
};

} // namespace druse::ui
