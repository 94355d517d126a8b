#include "render/camera.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace druse {

namespace {

constexpr double pi = 3.141592653589793;
constexpr double margin = 0.9; // of the picture that a framed box may fill

double radians(double degrees)
{
    return degrees * pi / 180.0;
}

double degrees_of(double radians)
{
    return radians * 180.0 / pi;
}

/// Sine and cosine of degrees that are exact where the views along the axes need it.
std::pair<double, double> sin_cos(double degrees)
{
    const double turns = std::remainder(degrees, 360.0);
    if (turns == 0.0) return {0.0, 1.0};
    if (turns == 90.0) return {1.0, 0.0};
    if (turns == -90.0) return {-1.0, 0.0};
    if (std::abs(turns) == 180.0) return {0.0, -1.0};
    return {std::sin(radians(turns)), std::cos(radians(turns))};
}

std::optional<double> number(std::string_view text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

} // namespace

std::optional<ViewAngles> view_from_text(std::string_view text)
{
    static constexpr std::pair<std::string_view, ViewAngles> named[] = {
        {"iso", {45.0, 35.264389682754654}}, // atan(1/√2): the eye on a diagonal of the cube
        {"front", {0, 0}},
        {"back", {180, 0}},
        {"left", {-90, 0}},
        {"right", {90, 0}},
        {"top", {0, 90}},
        {"bottom", {0, -90}},
    };
    for (const auto& [name, angles] : named)
        if (text == name) return angles;
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const auto azimuth = number(text.substr(0, comma)), elevation = number(text.substr(comma + 1));
    if (!azimuth || !elevation || std::abs(*elevation) > 90) return std::nullopt;
    return ViewAngles{*azimuth, *elevation};
}

void Camera::resize(int width, int height)
{
    ASSERT(width >= 1 && height >= 1, "a picture has at least one pixel");
    width_ = width;
    height_ = height;
}

void Camera::set_angles(ViewAngles angles)
{
    angles_.azimuth = std::remainder(angles.azimuth, 360.0);
    angles_.elevation = std::clamp(angles.elevation, -90.0, 90.0);
    angles_.roll = std::remainder(angles.roll, 360.0);
}

void Camera::set_distance(double distance)
{
    distance_ = std::clamp(distance, 1e-12, 1e12);
}

Vector Camera::right() const
{
    const auto [sin_az, cos_az] = sin_cos(angles_.azimuth);
    const Vector level(cos_az, sin_az, 0.0);
    if (angles_.roll == 0) return level;
    const auto [sin_roll, cos_roll] = sin_cos(angles_.roll);
    return cos_roll * level + sin_roll * glm::cross(backward(), level);
}

Vector Camera::backward() const
{
    const auto [sin_az, cos_az] = sin_cos(angles_.azimuth);
    const auto [sin_el, cos_el] = sin_cos(angles_.elevation);
    return {sin_az * cos_el, -cos_az * cos_el, sin_el};
}

Vector Camera::up() const
{
    return glm::cross(backward(), right());
}

Point2 Camera::tangents() const
{
    const double half = std::tan(radians(field_of_view / 2));
    const double shorter = std::min(width_, height_);
    return {half * width_ / shorter, half * height_ / shorter};
}

double Camera::unit_per_pixel_at(double ahead) const
{
    return (parallel_ ? distance_ : ahead) * 2.0 * tangents().y / height_;
}

void Camera::fit(const Box& box)
{
    target_ = box.center();
    const bool has_size = !box.empty() && box.diagonal() > 0;
    const Point low = has_size ? box.min : target_ - 0.5, high = has_size ? box.max : target_ + 0.5;
    std::array<Point, 8> corners;
    for (unsigned i = 0; i < 8; ++i) corners[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    step_back(corners);
}

void Camera::fit(std::span<const Point> points)
{
    Box box;
    for (const Point& p : points) box.add(p);
    if (box.empty() || box.diagonal() == 0) return fit(box);
    target_ = box.center();
    step_back(points);
}

/// Chooses the least distance from the target at which all points are inside the margin.
void Camera::step_back(std::span<const Point> points)
{
    const Point2 tangent = tangents() * margin;
    const Vector across = right(), upward = up(), toward_eye = backward();
    double least = 0;
    for (const Point& point : points) {
        const Vector p = point - target_;
        const double toward = parallel_ ? 0.0 : glm::dot(p, toward_eye);
        least = std::max(least, std::abs(glm::dot(p, across)) / tangent.x + toward);
        least = std::max(least, std::abs(glm::dot(p, upward)) / tangent.y + toward);
    }
    set_distance(least);
}

void Camera::orbit(double azimuth, double elevation)
{
    set_angles({angles_.azimuth + azimuth, angles_.elevation + elevation, angles_.roll});
}

void Camera::turn(const Vector& axis, double degrees)
{
    const auto [sine, cosine] = sin_cos(degrees);
    const auto turned = [&](const Vector& v) { return cosine * v + sine * glm::cross(axis, v) + (1 - cosine) * glm::dot(axis, v) * axis; };
    const Vector across = turned(right()), toward = turned(backward());
    // From straight above or below, where any azimuth would do, there is no roll.
    constexpr double nearly_vertical = 1e-9;
    const bool vertical = std::hypot(toward.x, toward.y) < nearly_vertical;
    if (vertical) set_angles({degrees_of(std::atan2(across.y, across.x)), std::copysign(90.0, toward.z)});
    else set_angles({degrees_of(std::atan2(toward.x, -toward.y)), degrees_of(std::atan2(toward.z, std::hypot(toward.x, toward.y)))});
    const double roll = degrees_of(std::atan2(glm::dot(across, up()), glm::dot(across, right())));
    constexpr double rounding = 1e-9;
    angles_.roll = std::abs(roll) < rounding ? 0 : roll;
}

void Camera::pan(double dx, double dy)
{
    target_ += unit_per_pixel() * (dy * up() - dx * right());
}

void Camera::zoom(double factor, double x, double y)
{
    const double before = distance_;
    set_distance(distance_ / factor);
    // The place under the pointer lies so far from the target in the plane through it; that offset shrinks with the distance.
    const double unit_before = before * 2.0 * tangents().y / height_;
    const Vector offset = unit_before * ((x - width_ / 2.0) * right() + (height_ / 2.0 - y) * up());
    target_ += (1.0 - distance_ / before) * offset;
}

Ray Camera::ray(double x, double y) const
{
    const Vector offset = unit_per_pixel() * ((x - width_ / 2.0) * right() + (height_ / 2.0 - y) * up());
    // In a parallel view the half line starts far enough back to meet all that the picture shows.
    if (parallel_) return {target_ + offset + 1e4 * distance_ * backward(), -backward()};
    return {eye(), unit(offset - distance_ * backward())};
}

std::optional<Point2> Camera::project(const Point& p) const
{
    const Vector from_target = p - target_;
    const double ahead = distance_ - glm::dot(from_target, backward());
    if (!parallel_ && ahead <= 0) return std::nullopt;
    const double unit = unit_per_pixel_at(ahead);
    return Point2(width_ / 2.0 + glm::dot(from_target, right()) / unit, height_ / 2.0 - glm::dot(from_target, up()) / unit);
}

glm::dmat3 Camera::rotation() const
{
    return glm::transpose(glm::dmat3(right(), up(), backward()));
}

Camera::Depths Camera::depths(const Box& scene) const
{
    // How far the scene reaches from the eye; a little more, so that nothing lies on the planes.
    const double radius = scene.empty() ? 1.0 : 0.505 * scene.diagonal();
    const double middle = distance_ - glm::dot((scene.empty() ? target_ : scene.center()) - target_, backward());
    const double far_end = std::max(middle + radius, distance_ * 1e-3);
    const double least_depth = 1e-9 * distance_;
    if (parallel_) return {middle - radius - least_depth, middle + radius + least_depth};
    // Depth is stored to 24 bits, so the near plane does not come nearer than the farthest thing over a few thousand.
    return {std::max(middle - radius, far_end / 4000.0), far_end + least_depth};
}

double Camera::depth_shift(double pixels, const Box& scene) const
{
    const auto [near_end, far_end] = depths(scene);
    const double shift = pixels * unit_per_pixel_at(1.0); // in a perspective view, of a unit of depth
    return parallel_ ? 2.0 * shift / (far_end - near_end) : 2.0 * near_end * far_end / (far_end - near_end) * shift;
}

glm::dmat4 Camera::to_clip(const Point& origin, const Box& scene) const
{
    const auto [near_end, far_end] = depths(scene);
    const double depth = far_end - near_end;
    const glm::dmat3 turn = rotation();
    const Vector shift = turn * (origin - target_) - Vector(0.0, 0.0, distance_);
    const Point2 tangent = tangents();
    glm::dmat4 clip(0.0);
    if (parallel_) {
        clip[0][0] = 1.0 / (tangent.x * distance_);
        clip[1][1] = 1.0 / (tangent.y * distance_);
        clip[2][2] = -2.0 / depth;
        clip[3][2] = -(near_end + far_end) / depth;
        clip[3][3] = 1.0;
    } else {
        clip[0][0] = 1.0 / tangent.x;
        clip[1][1] = 1.0 / tangent.y;
        clip[2][2] = -(near_end + far_end) / depth;
        clip[2][3] = -1.0;
        clip[3][2] = -2.0 * near_end * far_end / depth;
    }
    glm::dmat4 view(turn);
    view[3] = glm::dvec4(shift, 1.0);
    return clip * view;
}

} // namespace druse
