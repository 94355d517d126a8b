#include "ui/opposite_camera.h"

namespace druse::ui {

Camera opposite(const Camera& camera, const Point& centre)
{
    Camera other = camera;
    const ViewAngles angles = camera.angles();
    other.set_angles({angles.azimuth + 180, -angles.elevation, -angles.roll});
    other.set_target(2.0 * centre - camera.target());
    return other;
}

OppositeCamera::OppositeCamera(View& one, View& other) : one_(one), other_(other)
{
    one_.on_camera = [this] { follow(one_, other_); };
    other_.on_camera = [this] { follow(other_, one_); };
    follow(one_, other_);
}

OppositeCamera::~OppositeCamera()
{
    one_.on_camera = nullptr;
    other_.on_camera = nullptr;
}

void OppositeCamera::follow(const View& leader, View& follower) const
{
    if (is_linked_) follower.set_camera(opposite(leader.camera(), centre_));
}

void OppositeCamera::set_linked(bool on)
{
    is_linked_ = on;
    follow(one_, other_);
}

void OppositeCamera::set_centre(const Point& centre)
{
    centre_ = centre;
    follow(one_, other_);
}

void OppositeCamera::look_at(const Vector& normal)
{
    one_.look_from(normal, pane_turn_seconds);
    if (!is_linked_) other_.look_from(-normal, pane_turn_seconds);
}

} // namespace druse::ui
