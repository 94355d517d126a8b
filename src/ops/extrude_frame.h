#pragma once

#include "dlfl/mesh.h"
#include "geom/angle.h"
#include "geom/cycle.h"

#include <cmath>
#include <span>
#include <vector>

namespace druse {

/// An interior dihedral angle by its sine and cosine.
struct Angle {
    double sine = 1.0, cosine = 0.0;

    Angle() = default;
    explicit Angle(double degrees);
};

inline constexpr double level_line = 0.15; // sine of a slope: lines that rise less are bent towards the steepest direction

/// Everything a tiered extrusion measures at its base face, corner by corner from the start corner.
///
/// The *walls* are the planes over the base edges that meet the base at the interior dihedral angle. All directions are of
/// length 1; distances along them are heights times `edge`.
struct BaseFrame {
    int n = 0;
    Vector normal{0.0};            // Newell, outward
    double edge = 0.0;             // mean length of the base edges
    Angle angle;                   // between base and walls
    Cycle<const Point> foot;       // the base corners
    Cycle<const Vector> along;     // base edge i, from corner i to corner i + 1
    Cycle<const Vector> outward;   // in the base plane, square to edge i
    Cycle<const Vector> up;        // square to both: the base's normal where the base is flat
    Cycle<const Vector> climb;     // up wall i, square to edge i
    Cycle<const Vector> wall;      // outward normal of wall i

    Point middle(int i) const { return 0.5 * (foot[i] + foot[i + 1]); }
    /// Up the line that walls i − 1 and i share; defined at convex, straight and reflex corners alike.
    Vector crest(int i) const;
    /// Up the line in which two planes with these unit normals meet, gliding to the mean steepest direction where that line is
    /// nearly level (it rises by less than 8.6°), so that it never fails and never jumps.
    Vector meet(const Vector& a, const Vector& b) const;

private:
    Vector crest_of_one_plane(int i) const;
    Vector meet_level(const Vector& a, const Vector& b) const;
};

/// The neighbour of a face with outward normal `normal` across its side p → q, at an interior dihedral angle.
struct Hinge {
    Vector away;   // leaves the side square to it, within the neighbour
    Vector normal; // of the neighbour, outward

    Hinge(const Point& p, const Point& q, const Vector& face_normal, const Angle& angle)
    {
        const Vector side = unit(q - p);
        away = angle.cosine * glm::cross(face_normal, side) - angle.sine * face_normal;
        normal = glm::cross(away, side);
    }
};

/// Measures one base face after the other into memory of its own.
class FrameMaker {
public:
    explicit FrameMaker(double angle_in_degrees);

    /// The frame over these corners, valid until the next call.
    /// @throws CommandError `face ID: has 2 corners`, `has no area`, `edge I has no length`, and with `mitred` `folds back at corner I`
    const BaseFrame& measure(const Mesh& mesh, Face face, std::span<const Corner> ring, bool mitred);

private:
    BaseFrame frame_;
    std::vector<Vector> values_;
};

// --- called for every corner of every face, so they are here to be inlined ----------------------------------------------------

inline Vector BaseFrame::crest(int i) const
{
    const Vector line = glm::cross(wall[i - 1], wall[i]);
    const double square = glm::dot(line, line);
    if (square < 1e-6) return crest_of_one_plane(i);
    return line * (std::copysign(1.0, glm::dot(line, up[i - 1] + up[i])) / std::sqrt(square));
}

inline Vector BaseFrame::meet(const Vector& a, const Vector& b) const
{
    const Vector line = glm::cross(a, b);
    const double square = glm::dot(line, line), rise = glm::dot(normal, line);
    if (square < 1e-6 || rise * rise < level_line * level_line * square) return meet_level(a, b);
    return line * (std::copysign(1.0, rise) / std::sqrt(square));
}

} // namespace druse
