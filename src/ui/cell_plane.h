#pragma once

#include "ui/plane_editor.h"
#include "ui/shown_pane.h"

#include <optional>
#include <set>
#include <string>

namespace druse::ui {

/// What lies under the pointer in a pane: a point, or a piece of the rim, or one of a line, or the inside.
struct PaneHit {
    int point = -1; // of the pane's mesh; −1: none
    int rim = -1;   // from this place along the rim to the next; −1: none
    int line = -1;  // of ShownPane::lines; −1: none
    bool inside = false;
    Point2 at{0.0}; // the pointer's place
};

/// A flat pane of a cell without its window: what is drawn of it, and what the mouse does. Each gesture is a command to the session, and one step.
class CellPlane : public PlaneEditor {
public:
    struct Shown {
        bool triangles = true, orbits = true, grid = true;
        bool snap = false; // new places are those of the grid
    };
    /// A point that is dragged, where it was asked to go and could not.
    struct Refused {
        int point = 0;
        Point2 at{0.0};
    };

    explicit CellPlane(Session& session) : PlaneEditor(session) {}

    /// The session's cell; while a command works on it, as it was before.
    const std::optional<CellTile>& cell() const { return cell_; }
    void session_changed() override;
    /// Shows another pair of panes, or none: −1. A cell of another kind begins with none.
    void show_pane(int pane);
    int pane() const { return shown_pane_.pane; }
    const ShownPane& shown_pane() const { return shown_pane_; }
    const Shown& shown() const { return shown_; }
    void set_shown(const Shown& shown);

    const std::optional<PaneHit>& hovered() const { return hovered_; }
    /// The orbits of what is under the pointer, to point at its partners elsewhere: of a point, or of the edge that a side is of; −1: none.
    int hovered_orbit() const;
    int hovered_edge() const;
    const std::optional<Refused>& refused() const { return refused_; }
    /// Points that are picked in space, by name, show as selected here too.
    void mark(std::set<std::string> names);
    bool is_marked(const std::string& name) const { return marked_.contains(name); }
    std::string hint() const override;
    std::string invitation() const override;

    void hover(const Pointer& pointer) override;
    void leave() override;
    void select_all();
    void remove() override;

private:
    PaneHit hit(const Point2& picture) const;
    int point_near(const Point2& place, double nearest) const; // −1: none is nearer
    void follow_selected(const CellTile* now);
    bool has_point_pressed() const;
    void grab(const PaneHit& what);
    void grab_again(const std::string& name);
    bool may_edit(); // else a note says why not
    void add_edge_point(const PaneHit& at);
    void remove_chain(int chain);

    std::optional<Line> framed() const override;
    bool snaps() const override { return shown_.snap; }
    bool may_constrain() const override { return shown_pane_.pane >= 0 && shown_pane_.is_flat; }
    Gesture begin(const Pointer& pointer) override;
    Gesture begin_drag(const Pointer& pointer) override;
    void click(const Pointer& pointer) override;
    void drag_to(const Point2& picture) override;
    void end_constraint(const Point2& picture) override;
    std::optional<Point2> constraint_start() const override;
    void select_box(const Point2& low, const Point2& high, const Pointer& pointer) override;
    void end_drag() override { refused_.reset(); }
    void forget_refused() override;

    std::optional<CellTile> cell_;
    std::uint64_t cell_version_ = 0;
    ShownPane shown_pane_;
    Shown shown_;
    PaneHit grabbed_;
    PanePoint grabbed_point_; // as it was then: what comes of a drag may have fewer points
    Point2 grip_{0.0};        // from the pointer to the point
    std::optional<PaneHit> hovered_;
    std::set<std::string> marked_;
    std::optional<Refused> refused_;
};

} // namespace druse::ui
