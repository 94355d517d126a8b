#include "graph/strut_placement.h"

#include "dlfl/errors.h"
#include "geom/angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace druse {

namespace {

constexpr double least_angle = radians(0.01);
constexpr std::uint32_t few = 24; // edges at a vertex that are compared each with each

double angle_between(const Vector& u, const Vector& w) { return std::atan2(glm::length(glm::cross(u, w)), glm::dot(u, w)); }

} // namespace

StrutPlacer::StrutPlacer(const Graph& graph, const Incidence& incidence, const StrutShape& shape)
    : graph_(graph), incidence_(incidence), shape_(shape), direction_(graph.edges.size()), length_(graph.edges.size()),
      nearest_(2 * graph.edges.size(), std::numeric_limits<double>::infinity()), half_angle_(2 * graph.edges.size())
{
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const auto& [a, b] = graph.edges[e];
        const Vector along = graph.vertices[b] - graph.vertices[a];
        length_[e] = glm::length(along);
        direction_[e] = druse::direction(along);
    }
    for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) find_nearest(v);
    for (std::size_t end = 0; end < half_angle_.size(); ++end) half_angle_[end] = std::min(0.5 * shape.gap * nearest_[end], radians(shape.spread));
}

/// The nearest of unit vectors by the distance of their tips, which rounding spoils at no angle; then the angle to it.
void StrutPlacer::find_nearest(std::uint32_t v)
{
    const auto ends = incidence_.ends(v);
    const auto n = static_cast<std::uint32_t>(ends.size());
    if (n < 2) return;
    std::vector<std::uint32_t>& order = order_;
    order.resize(n);
    std::iota(order.begin(), order.end(), 0u);
    place_.assign(n, 0.0);
    if (n > few) { // sorted along a line, only few lie near enough to be looked at
        const Vector line = unit(Vector(1.0, std::numbers::sqrt2, std::numbers::e));
        for (std::uint32_t i = 0; i < n; ++i) place_[i] = glm::dot(leaving(ends[i]), line);
        std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return place_[i] < place_[j] || (place_[i] == place_[j] && i < j); });
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t me = order[i];
        const Vector mine = leaving(ends[me]);
        double least = std::numeric_limits<double>::infinity();
        std::uint32_t nearest = me;
        const auto look = [&](std::uint32_t other) {
            const Vector d = leaving(ends[other]) - mine;
            if (const double square = glm::dot(d, d); square < least) {
                least = square;
                nearest = other;
            }
            const double gap = place_[other] - place_[me];
            return gap * gap <= least;
        };
        for (std::uint32_t j = i + 1; j < n && look(order[j]);) ++j;
        for (std::uint32_t j = i; j-- > 0 && look(order[j]);) {}
        const double angle = angle_between(mine, leaving(ends[nearest]));
        if (angle < least_angle) {
            const auto name = [&](std::uint32_t end) { return fmt::format("({} {})", graph_.edges[end / 2][end % 2], graph_.edges[end / 2][1 - end % 2]); };
            throw CommandError(fmt::format("edges {} and {} overlap", name(ends[std::min(me, nearest)]), name(ends[std::max(me, nearest)])));
        }
        nearest_[ends[me]] = angle;
    }
}

void StrutPlacer::place_leaf(StrutPlacement& p, std::uint32_t v, double wanted, double bound) const
{
    StrutPlacement::End& end = p.ends[incidence_.ends(v)[0]];
    const double half_angle = radians(shape_.spread);
    switch (shape_.cap) {
    case StrutCap::flat: // the polygon stands at the vertex
        end.radius = std::min(wanted, bound);
        p.reach[v] = end.radius;
        break;
    case StrutCap::round: // half a ball, as high as it is wide
        end.radius = std::min(wanted, bound / std::numbers::sqrt2);
        p.reach[v] = end.radius * std::numbers::sqrt2;
        break;
    case StrutCap::point:
        p.reach[v] = std::min(shape_.ball * wanted / std::sin(half_angle), bound);
        end.radius = std::min(wanted, p.reach[v] * std::sin(half_angle));
        break;
    }
}

StrutPlacement StrutPlacer::place(double factor, std::span<const double> of_vertices) const
{
    const auto vertices = static_cast<std::uint32_t>(graph_.vertices.size());
    StrutPlacement p;
    p.ends.resize(half_angle_.size());
    p.reach.resize(vertices);
    std::vector<double> wanted(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const auto ends = incidence_.ends(v);
        double sum = 0, shortest = std::numeric_limits<double>::infinity(), half_angle = pi;
        for (const std::uint32_t end : ends) {
            sum += length_[end / 2];
            shortest = std::min(shortest, length_[end / 2]);
            half_angle = std::min(half_angle, half_angle_[end]);
        }
        wanted[v] = factor * shape_.radius * (shape_.scale == StrutScale::length ? sum / double(ends.size()) : 1.0);
        if (!of_vertices.empty()) wanted[v] *= of_vertices[v];
        const double bound = 0.95 * shortest / 2;
        if (ends.size() == 1) {
            place_leaf(p, v, wanted[v], bound);
            continue;
        }
        p.reach[v] = std::min(shape_.ball * wanted[v] / std::sin(half_angle), bound);
        for (const std::uint32_t end : ends) p.ends[end].radius = std::min(wanted[v], p.reach[v] * std::sin(half_angle_[end]));
    }

    // A strut that widens to its far end stays in the cone that it begins in, where that touches others.
    for (std::uint32_t end = 0; end < p.ends.size(); ++end) {
        const auto &edge = graph_.edges[end / 2];
        const std::uint32_t here = edge[end % 2], there = edge[1 - end % 2];
        if (incidence_.valence(there) > 1)
            p.ends[end].radius = std::min(p.ends[end].radius, (length_[end / 2] - p.reach[here]) * std::tan(half_angle_[end ^ 1]));
    }
    for (std::uint32_t v = 0; v < vertices; ++v)
        for (const std::uint32_t i : incidence_.ends(v)) {
            StrutPlacement::End& end = p.ends[i];
            const bool leaf = incidence_.valence(v) == 1;
            if (!leaf) end.height = std::sqrt(p.reach[v] * p.reach[v] - end.radius * end.radius);
            else if (shape_.cap == StrutCap::flat) end.height = 0, p.reach[v] = end.radius;
            else if (shape_.cap == StrutCap::round) end.height = end.radius, p.reach[v] = end.radius * std::numbers::sqrt2;
            else end.height = p.reach[v] * std::cos(radians(shape_.spread));
            const double part = end.radius / wanted[v];
            if (part >= 1 - 1e-12) continue;
            ++p.thinned;
            if (part < p.least) {
                p.least = part;
                p.least_at = v;
            }
        }
    return p;
}

double StrutPlacer::fitting_factor() const
{
    if (place().thinned == 0) return 1;
    double fits = 0, thins = 1;
    while (fits < thins * (1 - 1e-9)) {
        const double middle = 0.5 * (fits + thins);
        (place(middle).thinned == 0 ? fits : thins) = middle;
        if (thins < 1e-12) break;
    }
    return fits;
}

} // namespace druse
