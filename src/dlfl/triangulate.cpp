#include "dlfl/triangulate.h"

#include "geom/ear_clipping.h"

#include <algorithm>
#include <cmath>

namespace druse {

const std::vector<std::array<Corner, 3>>& Triangulator::triangles(const Mesh& mesh, Face f)
{
    triangles_.clear();
    corners_.clear();
    for (Corner c : mesh.corners(f)) corners_.push_back(c);
    if (corners_.size() < 3) return triangles_;
    if (corners_.size() == 3) {
        triangles_.push_back({corners_[0], corners_[1], corners_[2]});
    } else if (corners_.size() == 4) {
        cut_quad(mesh);
    } else {
        const bool backward = order_by_ids(mesh);
        flatten(mesh);
        clip_ears(flat_, cut_);
        for (const auto& t : cut_) triangles_.push_back({corners_[t[0]], corners_[t[backward ? 2 : 1]], corners_[t[backward ? 1 : 2]]});
    }
    return triangles_;
}

/// Puts the lowest vertex first, and after it the higher one of its neighbours, or of theirs where these are the same. If the lowest one comes
/// twice the start corner is first. True if the corners then run against the face.
bool Triangulator::order_by_ids(const Mesh& mesh)
{
    const std::size_t n = corners_.size();
    const auto id = [&](std::size_t k) { return mesh.vertex(corners_[k < n ? k : k - n]).index; };
    std::size_t first = 0;
    bool twice = false;
    for (std::size_t k = 1; k < n; ++k) {
        twice = id(k) == id(first) || (twice && id(k) > id(first));
        if (id(k) < id(first)) first = k;
    }
    if (twice) first = 0;
    std::size_t k = 1;
    while (2 * k < n && id(first + k) == id(first + n - k)) ++k;
    const bool backward = id(first + k) < id(first + n - k);
    std::ranges::rotate(corners_, corners_.begin() + std::ptrdiff_t(first));
    if (backward) std::reverse(corners_.begin() + 1, corners_.end());
    return backward;
}

void Triangulator::cut_quad(const Mesh& mesh)
{
    const Point &a = mesh.position(corners_[0]), &b = mesh.position(corners_[1]);
    const Point &c = mesh.position(corners_[2]), &d = mesh.position(corners_[3]);
    const Vector ac = c - a, bd = d - b;
    const Vector normal = cross(ac, bd); // Newell's, for a quad
    // A half with no more than this has its area from rounding: there is a straight corner, and the other diagonal goes to it.
    const double least = 1e-10 * dot(normal, normal);
    const bool ac_inside = dot(normal, cross(b - a, ac)) > least && dot(normal, cross(ac, d - a)) > least;
    const bool bd_inside = dot(normal, cross(c - b, bd)) > least && dot(normal, cross(bd, a - b)) > least;
    // Diagonals of a length, but for rounding, are no choice: a turned or moved quad shall be cut like the first one.
    constexpr double same = 1 - 1e-9;
    const bool along_bd = ac_inside == bd_inside ? dot(bd, bd) < same * dot(ac, ac) : bd_inside;
    if (along_bd) {
        triangles_.push_back({corners_[0], corners_[1], corners_[3]});
        triangles_.push_back({corners_[1], corners_[2], corners_[3]});
    } else {
        triangles_.push_back({corners_[0], corners_[1], corners_[2]});
        triangles_.push_back({corners_[0], corners_[2], corners_[3]});
    }
}

/// The corners as seen against the Newell normal, so that the face runs counter-clockwise.
void Triangulator::flatten(const Mesh& mesh)
{
    const Point origin = mesh.position(corners_[0]); // small numbers keep their digits
    Vector normal(0.0);
    for (std::size_t i = 2; i < corners_.size(); ++i)
        normal += cross(mesh.position(corners_[i - 1]) - origin, mesh.position(corners_[i]) - origin);
    normal = unit(normal, 0.0, Vector(0, 0, 1));

    // Duff et al., *Building an orthonormal basis, revisited* (2017): no jump but at normals that look straight down.
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z), b = normal.x * normal.y * a;
    const Vector u(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    const Vector v(b, sign + normal.y * normal.y * a, -normal.y);
    flat_.clear();
    for (const Corner c : corners_) {
        const Vector p = mesh.position(c) - origin;
        flat_.emplace_back(dot(p, u), dot(p, v));
    }
}

} // namespace druse
