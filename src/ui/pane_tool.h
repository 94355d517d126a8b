#pragma once

#include "ui/live_step.h"
#include "ui/tool.h"

#include "pane/pane.h"

#include <optional>
#include <string>
#include <utility>

namespace druse::ui {

/// Edits the pane that a document shows in place of a mesh: the armed operator of its family acts on the point, the line or the place that is clicked, or takes a
/// point along with a drag.
///
/// What is near is meant: within the snap of the pane, or some pixels if those are more. The command then names it, so that a script does the same.
class PaneTool : public Tool {
public:
    enum class Act { add, add_boundary, move, remove, lock, constrain, unconstrain };
    PaneTool(Act act, Session& session, const Camera& camera) : Tool(session, camera), act_(act) {}

    /// What clicks do for an operator of the pane family; nothing if it acts on the pane as a whole.
    static std::optional<Act> act_of(const std::string& op);

    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::unique_ptr<Gesture> press(const Pointer& start, const ShowTarget& show) override;
    void add_marks(Overlay& overlay) const override;
    void add_pointer(const Pointer& pointer, Overlay& overlay) const override;
    void act_on_nothing() override { first_.reset(); }
    bool take_back() override { return std::exchange(first_, std::nullopt).has_value(); }
    std::string hint() const override;
    std::string pressed_hint() const override;
    bool holds_through_edits() const override { return act_ == Act::move; }

private:
    /// What the pointer means.
    struct Found {
        Point2 at{0.0};
        std::optional<PointId> point;
        std::optional<PaneEdge> edge; // of the boundary, or a piece of a segment
        std::optional<SegmentId> segment;
    };
    /// Takes a point along.
    class Move : public Gesture {
    public:
        Move(PaneTool& tool, PointId point) : tool_(tool), point_(point), step_(tool.session_) {}
        void move(const Pointer& pointer) override;
        void release(const Pointer& pointer) override { move(pointer); }
        void cancel() override { step_.cancel(); }

    private:
        PaneTool& tool_;
        PointId point_;
        LiveStep step_;
    };

    const Pane* pane() const;
    std::optional<Point2> place(const Pointer& pointer) const;
    std::optional<Found> find(const Pointer& pointer, std::optional<PointId> besides = {}) const;
    double reach(const Pane& pane) const;
    Point2 tidy(const Point2& p) const;
    void add_dot(const Point2& at, double size, Overlay& overlay) const;

    Act act_;
    std::optional<PointId> first_; // that a segment begins at
};

} // namespace druse::ui
