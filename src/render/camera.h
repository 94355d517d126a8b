#pragma once

#include "geom/point.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <optional>
#include <span>
#include <string_view>

namespace druse {

/// A half line; `direction` has length 1.
struct Ray {
    Point origin;
    Vector direction;
};

/// Where the eye stands, in degrees: AZ turns it counter-clockwise seen from above, EL lifts it. `front` is 0,0. `roll` tilts the head to its
/// left; at 0 z is up in the picture.
struct ViewAngles {
    double azimuth = 0, elevation = 0, roll = 0;
    friend bool operator==(const ViewAngles&, const ViewAngles&) = default;
};

/// The angles of `iso front back left right top bottom` or of two numbers `AZ,EL` (EL from −90 to 90); nothing if `text` is
/// neither.
std::optional<ViewAngles> view_from_text(std::string_view text);

/// A camera whose eye turns about a target, on a turntable with z upright in the picture (orbit()) or any way (turn()).
///
/// Places in the picture are in pixels from its top left corner, y downward; the centre of the first pixel is (0.5, 0.5).
/// Everything is computed in double and in model coordinates; the renderer goes over to float last, relative to the model.
class Camera {
public:
    static constexpr double field_of_view = 30.0; // degrees, over the shorter side of the picture

    // --- where it is ----------------------------------------------------------------------------------------------------

    int width() const { return width_; }
    int height() const { return height_; }
    /// Size of the picture in pixels. Precondition: both at least 1.
    void resize(int width, int height);

    ViewAngles angles() const { return angles_; }
    /// Turns to these angles about the target; elevation is kept within ±90.
    void set_angles(ViewAngles angles);

    const Point& target() const { return target_; }
    void set_target(const Point& target) { target_ = target; }
    /// From the eye to the target. In a parallel view it sets the scale, which is that of the perspective view at the target.
    double distance() const { return distance_; }
    void set_distance(double distance);

    bool parallel() const { return parallel_; }
    void set_parallel(bool on) { parallel_ = on; }

    Vector right() const;    // unit vectors in model space: to the right in the picture,
    Vector up() const;       // upward in the picture,
    Vector backward() const; // and from the target to the eye
    Point eye() const { return target_ + distance_ * backward(); }

    /// Model units per pixel at the target, and at another depth (`ahead`: distance from the eye along the viewing direction).
    double unit_per_pixel() const { return unit_per_pixel_at(distance_); }
    double unit_per_pixel_at(double ahead) const;

    // --- moving it ------------------------------------------------------------------------------------------------------

    /// Aims at the middle of the box and steps back until all of it is in the picture, with a margin; the angles stay.
    /// An empty box, or one of no size, is framed as if it measured 1.
    void fit(const Box& box);
    /// The same for a set of points, which may fill less than its box.
    void fit(std::span<const Point> points);
    /// Degrees added to azimuth and elevation.
    void orbit(double azimuth, double elevation);
    /// Turns about a line through the target, counter-clockwise seen from where `axis` points (of length 1).
    void turn(const Vector& axis, double degrees);
    /// Moves the model by so many pixels, at the depth of the target.
    void pan(double dx, double dy);
    /// Goes nearer by `factor` (2 shows everything twice as large); what is at (x, y) at the depth of the target stays there.
    void zoom(double factor, double x, double y);

    // --- between model and picture --------------------------------------------------------------------------------------

    /// The half line of all that is seen at (x, y).
    Ray ray(double x, double y) const;
    /// Where `p` is seen, whether or not inside the picture; nothing if it lies behind the eye.
    std::optional<Point2> project(const Point& p) const;

    /// Model to eye space, rotation only: x right, y up, z toward the viewer.
    glm::dmat3 rotation() const;
    /// Coordinates relative to `origin` to clip space, with near and far planes just wide enough for `scene`.
    glm::dmat4 to_clip(const Point& origin, const Box& scene) const;
    /// What brings a point nearer to the eye by so many pixels (as long as they are at its depth): to be taken from its
    /// normalised depth once divided by w.
    double depth_shift(double pixels, const Box& scene) const;

    friend bool operator==(const Camera&, const Camera&) = default;

private:
    struct Depths {
        double near_end, far_end; // from the eye, along the viewing direction
    };
    Depths depths(const Box& scene) const;
    Point2 tangents() const; // of half the field of view, across and up
    void step_back(std::span<const Point> points);

    int width_ = 1280, height_ = 800;
    ViewAngles angles_{45.0, 35.264389682754654};
    Point target_{0.0};
    double distance_ = 4.0;
    bool parallel_ = false;
};

} // namespace druse
