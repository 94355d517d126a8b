#pragma once

#include "ui/live_step.h"
#include "ui/relief_picture.h"
#include "ui/tile_view.h"
#include "ui/tool.h"

#include <optional>

namespace druse::ui {

/// Selects points on the relief of a tile, and raises and lowers what is selected. The points are the first vertices of what is drawn.
class ReliefTool : public Tool {
public:
    ReliefTool(Session& session, const Camera& camera, TileView& plane, const ReliefPicture& relief) : Tool(session, camera), plane_(plane), relief_(relief)
    {
    }

    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::unique_ptr<Gesture> press(const Pointer& start, const ShowTarget& show) override;
    void add_marks(Overlay& overlay) const override;
    bool take_box(const Point2& low, const Point2& high, const Pointer& end) override;
    /// Something is dragged up or down.
    bool is_raising() const { return is_raising_; }
    void act_on_nothing() override { plane_.select({}); }
    std::string hint() const override;
    bool holds_through_edits() const override { return true; }
    std::string pressed_hint() const override { return "up and down; Escape takes it back"; }
    /// The session changed: what was waiting may go.
    void go_on()
    {
        if (step_) step_->go_on();
    }

private:
    /// Raises by as much as the pointer goes along the vertical as it is seen at the point that was pressed.
    class Raise : public Gesture {
    public:
        Raise(ReliefTool& tool, const Target& target, const Pointer& start);
        ~Raise() override { tool_.is_raising_ = false; }
        void move(const Pointer& pointer) override;
        void release(const Pointer& pointer) override;
        void cancel() override;

    private:
        ReliefTool& tool_;
        Target target_;
        Pointer start_;
        Point2 up_{0.0}; // pixels for a unit
        bool moved_ = false;
        std::string points_;
    };

    TileView& plane_;
    const ReliefPicture& relief_;
    std::optional<LiveStep> step_;
    bool is_raising_ = false;
};

} // namespace druse::ui
