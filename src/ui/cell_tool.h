#pragma once

#include "ui/cell_picture.h"
#include "ui/cell_plane.h"
#include "ui/cell_selection.h"
#include "ui/live_step.h"
#include "ui/tool.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace druse::ui {

/// Picks panes of a cell in space, and picks and moves its points once they may move. Each view has one, on one selection.
class CellTool : public Tool {
public:
    enum class Mode { select, split, flip };
    /// Directions of the arrow at the point that was picked last.
    enum class Along { radial, normal, x, y, z };

    CellTool(Session& session, const Camera& camera, const CellPlane& plane, const CellPicture& picture, CellSelection& selection)
        : Tool(session, camera), plane_(plane), picture_(picture), selection_(selection)
    {
    }

    /// A pane was picked by a right click; −1: the click was beside the cell.
    std::function<void(int pane, bool far)> on_pane;
    /// A right click was on a neighbour.
    std::function<void()> on_neighbour;
    /// A box was dragged.
    std::function<void()> on_box;
    /// For View::on_menu.
    void pick_pane(const Pointer& pointer) const;

    Mode mode() const { return mode_; }
    void set_mode(Mode mode) { mode_ = mode; }
    Along along() const { return along_; }
    void set_along(Along along) { along_ = along; }

    /// Something is dragged, and the cell changes all the while.
    bool is_moving() const { return is_moving_; }
    /// The session changed: what was waiting may go.
    void go_on()
    {
        if (step_) step_->go_on();
    }
    /// Both ends of the arrow in the picture, where there is one.
    std::optional<std::pair<Point2, Point2>> arrow() const;
    /// Where a point of the cell is seen, if nothing of the cell is before it.
    std::optional<Point2> seen(const OrbitMember& member) const;

    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::unique_ptr<Gesture> press(const Pointer& start, const ShowTarget& show) override;
    void add_marks(Overlay& overlay) const override;
    bool take_box(const Point2& low, const Point2& high, const Pointer& end) override;
    void act_on_nothing() override;
    std::string hint() const override;
    std::string pressed_hint() const override;
    bool holds_through_edits() const override { return true; }

private:
    /// What moves along with the pointer: one step of the history.
    class Move;
    /// A straight way for what is picked: what the command says of it, and where it goes in the world for 1.
    struct Way {
        std::string words; // `along=radial`
        Vector step{0.0};
        double sign = 1; // of the amount in the command
    };
    /// What is under the pointer on the cell.
    struct Spot {
        CellSolid::Side side;
        int triangle = 0;
        std::array<Vertex, 3> corners{};
        std::array<PaneMesh::Index, 3> points{}; // the same in the pane
        Point at{0.0};
        Face face;
        int nearest_side = -1; // of the triangle, where it is near the pointer
    };

    bool is_drawn() const { return picture_.cell() && picture_.is_shown; }
    bool is_shaped() const { return is_drawn() && picture_.cell()->phase() == 2; }
    const Point& place(Vertex v) const { return picture_.solid().points[v.index]; }
    std::optional<Vertex> vertex_under(const Pointer& pointer) const;
    std::optional<Spot> spot_under(const Pointer& pointer) const;
    bool is_on_arrow(const Pointer& pointer) const;
    bool is_hidden(const Point& place) const;
    bool is_seen(Vertex v) const; // and not only its place
    std::optional<Way> way() const;
    std::optional<CellSolid::Side> side_at(const OrbitMember& member) const;
    void split(const Spot& spot);
    void flip(const Spot& spot);
    void add_panes(Overlay& overlay) const;
    void add_hovered_edge(Overlay& overlay) const;
    std::vector<double> spacing() const;
    void add_points(Overlay& overlay) const;
    void add_arrow(Overlay& overlay) const;

    const CellPlane& plane_;
    const CellPicture& picture_;
    CellSelection& selection_;
    Mode mode_ = Mode::select;
    Along along_ = Along::radial;
    std::optional<LiveStep> step_;
    bool is_moving_ = false;
};

/// `radial`, `normal`, `x`, `y`, `z`, as in commands.
const char* name(CellTool::Along along);

} // namespace druse::ui
