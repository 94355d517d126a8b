#include "ui/opposite_camera.h"

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr double degrees_per_radian = 57.295779513082323;
constexpr double nearly_flat = 1e-9; // of a normal's part in the plane of x and y, below which a pane lies flat

} // namespace

ViewAngles facing(const Vector& normal)
{
    // In a pane that lies flat y is upright; seen from below that is so from behind.
    if (std::hypot(normal.x, normal.y) < nearly_flat) return normal.z > 0 ? ViewAngles{0, 90} : ViewAngles{180, -90};
    return {std::atan2(normal.x, -normal.y) * degrees_per_radian, std::asin(std::clamp(normal.z / glm::length(normal), -1.0, 1.0)) * degrees_per_radian};
}

Camera opposite(const Camera& camera, const Point& centre)
{
    Camera other = camera;
    const ViewAngles angles = camera.angles();
    other.set_angles({angles.azimuth + 180, -angles.elevation});
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
    one_.look(facing(normal), pane_turn_seconds);
    if (!is_linked_) other_.look(facing(-normal), pane_turn_seconds);
}

} // namespace druse::ui
