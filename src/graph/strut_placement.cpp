#include "graph/strut_placement.h"

#include "dlfl/errors.h"
#include "geom/angle.h"

#include "graph/largest_factor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace druse {

namespace {

constexpr double least_angle = radians(0.01);
constexpr double largest_wanted = 1e200; // so that it can be multiplied and divided on; no strut comes anywhere near

} // namespace

StrutPlacer::StrutPlacer(const CleanGraph& clean, const Incidence& incidence, const StrutShape& shape)
    : clean_(clean), graph_(clean.graph), incidence_(incidence), shape_(shape), direction_(graph_.edges.size()), length_(graph_.edges.size()),
      nearest_(2 * graph_.edges.size(), std::numeric_limits<double>::infinity()), half_angle_(2 * graph_.edges.size())
{
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
        const auto& [a, b] = graph_.edges[e];
        const Vector along = graph_.vertices[b] - graph_.vertices[a];
        length_[e] = std::hypot(along.x, along.y, along.z); // also where a square is too small for a double
        direction_[e] = druse::direction(along);
        if (!(length_[e] >= StrutPlacement::least_size))
            throw CommandError(fmt::format("edge {} is {:.3g} long: struts need {} at least; mesh.transform makes a model larger, weld= joins ends", clean.edge_name(static_cast<std::uint32_t>(e)),
                                           length_[e], StrutPlacement::least_size));
    }
    for (std::uint32_t v = 0; v < graph_.vertices.size(); ++v) find_nearest(v);
    for (std::size_t end = 0; end < half_angle_.size(); ++end) half_angle_[end] = std::min(0.5 * shape.gap * nearest_[end], radians(shape.spread));
}

void StrutPlacer::find_nearest(std::uint32_t v)
{
    const auto ends = incidence_.ends(v);
    if (ends.size() < 2) return;
    star_.clear();
    for (const std::uint32_t end : ends) star_.push_back(leaving(end));
    finder_.find(star_);
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
        const std::uint32_t j = finder_[i];
        nearest_[ends[i]] = angle_between(star_[i], star_[j]);
        if (nearest_[ends[i]] >= least_angle) continue;
        const auto name = [&](std::uint32_t k) { return clean_.edge_name(ends[k] / 2, ends[k] % 2); };
        throw CommandError(fmt::format("edges {} and {} overlap", name(std::min(i, j)), name(std::max(i, j))));
    }
}

/// What is as large as asked for, and fits.
void StrutPlacer::place_leaf(StrutPlacement& p, std::uint32_t v, double bound) const
{
    StrutPlacement::End& end = p.ends[incidence_.ends(v)[0]];
    const double wanted = p.wanted[v], sine = std::sin(radians(shape_.spread));
    if (shape_.cap == StrutCap::point) p.reach[v] = std::min(shape_.ball * wanted / sine, bound);
    const double largest = shape_.cap == StrutCap::point ? p.reach[v] * sine : shape_.cap == StrutCap::round ? bound / std::numbers::sqrt2 : bound;
    end.radius = std::min(wanted, largest);
    shape_leaf(p, v);
}

/// The rest of what follows from the radius of its polygon.
void StrutPlacer::shape_leaf(StrutPlacement& p, std::uint32_t v) const
{
    StrutPlacement::End& end = p.ends[incidence_.ends(v)[0]];
    switch (shape_.cap) {
    case StrutCap::flat: // the polygon stands at the vertex
        end.height = 0;
        p.reach[v] = end.radius;
        break;
    case StrutCap::round: // half a ball, as high as it is wide
        end.height = end.radius;
        p.reach[v] = end.radius * std::numbers::sqrt2;
        break;
    case StrutCap::point: end.height = p.reach[v] * std::cos(radians(shape_.spread)); break;
    }
}

StrutPlacement StrutPlacer::place(double factor, std::span<const double> of_vertices) const
{
    const auto vertices = static_cast<std::uint32_t>(graph_.vertices.size());
    StrutPlacement p;
    p.ends.resize(half_angle_.size());
    p.wanted.resize(vertices);
    p.reach.resize(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const auto ends = incidence_.ends(v);
        double sum = 0, shortest = std::numeric_limits<double>::infinity(), half_angle = pi;
        for (const std::uint32_t end : ends) {
            sum += length_[end / 2];
            shortest = std::min(shortest, length_[end / 2]);
            half_angle = std::min(half_angle, half_angle_[end]);
        }
        double& wanted = p.wanted[v];
        wanted = factor * shape_.radius * (shape_.scale == StrutScale::length ? sum / double(ends.size()) : 1.0);
        if (!of_vertices.empty()) wanted *= of_vertices[v];
        wanted = std::min(wanted, largest_wanted);
        const double bound = 0.95 * shortest / 2;
        if (ends.size() == 1) {
            place_leaf(p, v, bound);
            continue;
        }
        p.reach[v] = std::min(shape_.ball * wanted / std::sin(half_angle), bound);
        for (const std::uint32_t end : ends) p.ends[end].radius = std::min(wanted, p.reach[v] * std::sin(half_angle_[end]));
    }

    // A strut that widens to its far end stays in the cone that it begins in, where that touches others.
    for (std::uint32_t end = 0; end < p.ends.size(); ++end) {
        const auto &edge = graph_.edges[end / 2];
        const std::uint32_t here = edge[end % 2], there = edge[1 - end % 2];
        if (incidence_.valence(there) > 1)
            p.ends[end].radius = std::min(p.ends[end].radius, (length_[end / 2] - p.reach[here]) * std::tan(half_angle_[end ^ 1]));
    }
    for (std::uint32_t v = 0; v < vertices; ++v) {
        if (incidence_.valence(v) == 1) shape_leaf(p, v);
        for (const std::uint32_t i : incidence_.ends(v)) {
            StrutPlacement::End& end = p.ends[i];
            if (incidence_.valence(v) > 1) end.height = std::sqrt(p.reach[v] * p.reach[v] - end.radius * end.radius);
            const double part = end.radius / p.wanted[v];
            if (part >= 1 - 1e-12) continue;
            ++p.thinned;
            if (part < p.least) {
                p.least = part;
                p.least_at = v;
            }
        }
    }
    return p;
}

double StrutPlacer::fitting_factor() const
{
    return largest_factor([this](double factor) { return place(factor).thinned == 0; });
}

} // namespace druse
