#pragma once

#include "ui/view.h"

namespace druse::ui {

/// How long a turn to a pane takes.
inline constexpr double pane_turn_seconds = 0.35;

/// From the opposite side through a centre: what stands upright still does.
Camera opposite(const Camera& camera, const Point& centre);

/// Keeps two views linked: what one does, the other follows from the opposite side of a cell. Views must outlive it.
class OppositeCamera {
public:
    OppositeCamera(View& one, View& other);
    ~OppositeCamera();
    OppositeCamera(const OppositeCamera&) = delete;
    OppositeCamera& operator=(const OppositeCamera&) = delete;

    bool is_linked() const { return is_linked_; }
    /// Linked again, the other follows the one.
    void set_linked(bool on);
    const Point& centre() const { return centre_; }
    void set_centre(const Point& centre);
    /// Turns one to a pane by the smallest angle, and so the other to the pane opposite.
    void look_at(const Vector& normal);

private:
    void follow(const View& leader, View& follower) const;

    View& one_;
    View& other_;
    Point centre_{0.0};
    bool is_linked_ = true;
};

} // namespace druse::ui
