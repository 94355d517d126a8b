#pragma once

#include "ui/live_step.h"
#include "ui/panel.h"
#include "ui/skew_handles.h"

#include <FL/Fl_Button.H>
#include <FL/Fl_Input.H>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace druse::ui {

/// The skew of a cell: handles to drag in a picture of the axes that turns with the camera, and its nine numbers, to be typed. A drag is one step of the history.
class SkewWidget : public Panel {
public:
    SkewWidget(Session& session, const Camera& camera);

    /// The matrix of the cell that is shown, or nothing without one.
    void show_matrix(const std::optional<CellMatrix>& matrix);
    /// The session changed: what was waiting may go.
    void go_on()
    {
        if (step_) step_->go_on();
    }
    bool is_dragging() const { return dragged_.has_value(); }
    /// Escape: takes back what is dragged, or forgets what was typed into a field. @return false if there was neither
    bool cancel();
    /// What the pointer would do here; empty beside the handles.
    std::string hint() const;
    /// Where the handles are in the window: `xx 12,34`, one after the other; for those who test it.
    std::string places() const;

    int handle(int event) override;

protected:
    void arrange() override;
    void draw() override;

private:
    SkewHandles::Place place() const;
    SkewHandles handles() const { return SkewHandles(*matrix_, camera_, dragged_ ? place_ : place()); }
    int picture_width() const;
    void drag();
    void typed(int entry);
    void show_numbers();

    Session& session_;
    const Camera& camera_;
    std::optional<CellMatrix> matrix_;
    std::array<std::unique_ptr<Fl_Input>, 9> fields_;
    Fl_Button reset_;

    std::optional<int> hovered_, dragged_;
    SkewHandles::Place place_; // of the picture, while one is dragged
    Point2 pressed_at_{0.0};
    CellMatrix pressed_{};  // the matrix then
    std::optional<SkewHandles> pressed_handles_;
    std::optional<LiveStep> step_;
    bool sent_ = false; // something, for it
};

} // namespace druse::ui
