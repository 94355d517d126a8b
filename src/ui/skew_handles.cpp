#include "ui/skew_handles.h"

#include "ui/layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace druse::ui {

namespace {

constexpr double handle_gap = 0.3;  // from the tip of an axis, in units
constexpr double steepest_line = 0.2; // what is seen of a unit at least, so that a handle can be dragged along it

std::size_t entry_at(int row, int column) { return static_cast<std::size_t>(3 * row + column); }

/// Where the matrix takes the end of an axis.
Vector tip_of(const CellMatrix& m, int axis) { return {m[entry_at(0, axis)], m[entry_at(1, axis)], m[entry_at(2, axis)]}; }

/// What the determinant grows by for 1 of an entry.
double cofactor(const CellMatrix& m, int entry)
{
    const int row = entry / 3, column = entry % 3;
    const int r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    return m[entry_at(r1, c1)] * m[entry_at(r2, c2)] - m[entry_at(r1, c2)] * m[entry_at(r2, c1)];
}

} // namespace

SkewHandles::SkewHandles(const CellMatrix& matrix, const Camera& camera, const Place& place) : matrix_(matrix), origin_(place.origin)
{
    const glm::dmat3 turn = camera.rotation();
    std::array<double, 3> depths{};
    const auto seen = [&](const Vector& v) { return place.pixels * Point2(v.x, -v.y); };
    for (int axis = 0; axis < 3; ++axis) {
        const Vector tip = turn * tip_of(matrix, axis);
        tips_[static_cast<std::size_t>(axis)] = origin_ + seen(tip);
        depths[static_cast<std::size_t>(axis)] = tip.z;
        for (int row = 0; row < 3; ++row) {
            Handle& handle = handles_[entry_at(row, axis)];
            handle.line = seen(turn[row]);
            handle.place = tips_[static_cast<std::size_t>(axis)] + handle_gap * handle.line;
            handle.can_move = glm::length(handle.line) >= steepest_line * place.pixels;
        }
    }
    std::ranges::sort(order_, [&](int a, int b) { return depths[static_cast<std::size_t>(a)] < depths[static_cast<std::size_t>(b)]; });
}

SkewHandles::Place SkewHandles::fitting(const CellMatrix& matrix, const Camera& camera, const Point2& middle, double width, double height)
{
    std::vector<Point> ends{Point(0.0)};
    for (int axis = 0; axis < 3; ++axis)
        for (int row = 0; row < 3; ++row) {
            Point end = tip_of(matrix, axis);
            end[row] += handle_gap;
            ends.push_back(end);
        }
    double farthest = 0; // from another
    Box seen;
    for (const Point& a : ends) {
        for (const Point& b : ends) farthest = std::max(farthest, glm::distance(a, b));
        seen.add(camera.rotation() * a);
    }
    const double pixels = std::max(1.0, std::min(width, height) - 2 * layout().margin()) / farthest;
    const Point centre = seen.center();
    return {middle - pixels * Point2(centre.x, -centre.y), pixels};
}

std::optional<int> SkewHandles::at(const Point2& place) const
{
    std::optional<int> found;
    double nearest = layout().pick_radius();
    for (int entry = 0; entry < 9; ++entry) {
        const double away = glm::distance(handle(entry).place, place);
        if (!handle(entry).can_move || away > nearest) continue;
        nearest = away;
        found = entry;
    }
    return found;
}

double SkewHandles::dragged(int entry, const Point2& by) const
{
    const Point2& line = handle(entry).line;
    return matrix_[static_cast<std::size_t>(entry)] + glm::dot(by, line) / glm::dot(line, line);
}

const char* skew_entry_name(int entry)
{
    constexpr std::array names{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    return names[static_cast<std::size_t>(entry)];
}

double determinant(const CellMatrix& m) { return m[0] * cofactor(m, 0) + m[1] * cofactor(m, 1) + m[2] * cofactor(m, 2); }

double stopped_skew(const CellMatrix& matrix, int entry, double wanted)
{
    constexpr double thousand = 1000;
    const double now = matrix[static_cast<std::size_t>(entry)], most = std::max(SkewHandles::farthest, std::abs(now)), det = determinant(matrix), slope = cofactor(matrix, entry);
    const double least = std::min(det, SkewHandles::least_determinant);
    const auto allowed = [&](double value) { return det + (value - now) * slope >= least - 1e-12; };
    double value = std::round(std::clamp(wanted, -most, most) * thousand) / thousand;
    if (allowed(value)) return value + 0.0;
    // The determinant is linear in each entry: it is the least one at one value. The thousandth before that is meant.
    const double end = (now + (least - det) / slope) * thousand;
    value = (value > now ? std::floor(end + 1e-6) : std::ceil(end - 1e-6)) / thousand;
    return (value > now) == (wanted > now) && allowed(value) ? value + 0.0 : now;
}

} // namespace druse::ui
