#include "ops/extrude_frame.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

/// `v` without its part along `axis`, which need not be of length 1; `v` itself where the axis is shorter than `least`.
Vector without(const Vector& v, const Vector& axis, double least)
{
    const double square = glm::dot(axis, axis);
    return square < least * least ? v : v - (glm::dot(v, axis) / square) * axis;
}

constexpr double same_plane = 1e-8; // two unit normals whose sum or difference is shorter count as opposite or equal

} // namespace

// Two walls share one line. Where they are nearly one plane (a straight corner), or nearly opposite, that line loses its digits, and
// what is left of `up` in both walls takes its place; the two agree wherever both are good.
Vector BaseFrame::crest_of_one_plane(int i) const
{
    const Vector &a = wall[i - 1], &b = wall[i];
    return unit(without(without(up[i - 1] + up[i], a + b, same_plane), a - b, same_plane));
}

Vector BaseFrame::meet_level(const Vector& a, const Vector& b) const
{
    Vector steepest(0.0);
    for (const Vector& plane : {a, b}) steepest += unit(normal - glm::dot(normal, plane) * plane, 1e-9);
    steepest = unit(steepest, 1e-9, normal);
    const Vector line = without(without(normal, a + b, same_plane), a - b, same_plane);
    const double rise = glm::length(line); // sine of the line's slope above the base
    const double x = std::clamp((rise - 0.05) / (level_line - 0.05), 0.0, 1.0);
    const double weight = x * x * (3.0 - 2.0 * x);
    return unit(weight * unit(line) + (1.0 - weight) * steepest);
}

Angle::Angle(double degrees)
    : sine(std::sin(radians(degrees))), cosine(degrees == 90.0 ? 0.0 : std::cos(radians(degrees))) // upright is 0, not 6e-17
{
}

FrameMaker::FrameMaker(double angle_in_degrees) { frame_.angle = Angle(angle_in_degrees); }

const BaseFrame& FrameMaker::measure(const Mesh& mesh, Face face, std::span<const Corner> ring, bool mitred)
{
    const auto fail = [face](const std::string& reason) { throw CommandError(fmt::format("face {}: {}", face.index, reason)); };
    const int n = frame_.n = static_cast<int>(ring.size());
    if (n < 3) fail(fmt::format("has {} corner{}", n, n == 1 ? "" : "s"));
    if (values_.size() < 6 * ring.size()) values_.resize(6 * ring.size());
    const auto cycle = [&](int which) { return Cycle<Vector>(values_.data() + std::size_t(which) * ring.size(), n); };
    const auto foot = cycle(0), along = cycle(1), outward = cycle(2), up = cycle(3), climb = cycle(4), wall = cycle(5);

    for (int i = 0; i < n; ++i) foot[i] = mesh.position(ring[std::size_t(i)]);
    Vector newell(0.0), spoke(0.0); // the spokes run from corner 0, so that a face far from the origin loses no digits
    double total = 0.0, longest = 0.0, shortest = std::numeric_limits<double>::infinity();
    int shortest_at = 0;
    for (int i = 0; i < n; ++i) {
        const Vector side = foot[i + 1] - foot[i], next_spoke = foot[i + 1] - foot[0];
        const double length = glm::length(side);
        newell += glm::cross(spoke, next_spoke);
        spoke = next_spoke;
        total += length;
        longest = std::max(longest, length);
        if (length < shortest) {
            shortest = length;
            shortest_at = i;
        }
        along[i] = side * (1.0 / length);
    }
    const double doubled_area = glm::length(newell);
    if (!(doubled_area > 1e-12 * longest * longest)) fail("has no area");
    frame_.edge = total / n;
    if (shortest < 1e-9 * frame_.edge) fail(fmt::format("edge {} has no length", shortest_at));
    frame_.normal = newell / doubled_area;

    const auto [sine, cosine] = frame_.angle;
    for (int i = 0; i < n; ++i) {
        outward[i] = unit(glm::cross(along[i], frame_.normal));
        up[i] = glm::cross(outward[i], along[i]);
        climb[i] = sine * up[i] - cosine * outward[i];
        wall[i] = sine * outward[i] + cosine * up[i]; // along × climb
    }
    if (mitred)
        for (int i = 0; i < n; ++i)
            if (1.0 + glm::dot(outward[i - 1], outward[i]) < 1e-9) fail(fmt::format("folds back at corner {}", i));

    const auto view = [](Cycle<Vector> c) { return Cycle<const Vector>(c.begin(), c.size()); };
    frame_.foot = view(foot);
    frame_.along = view(along);
    frame_.outward = view(outward);
    frame_.up = view(up);
    frame_.climb = view(climb);
    frame_.wall = view(wall);
    return frame_;
}

} // namespace druse
