#include "graph/strut_rim.h"

#include "geom/angle.h"
#include "geom/predicates.h"
#include "graph/strut_ball.h"

#include <cmath>

namespace druse {

StrutAxes strut_axes(const Graph& graph, const StrutPlacer& placer, StrutFrame frame, std::uint32_t edge)
{
    const Vector& along = placer.direction(edge);
    const auto square_to_edge = [&along](const Vector& v) { return v - glm::dot(v, along) * along; };
    Vector f(0.0);
    if (frame != StrutFrame::axis && !graph.normals.empty()) f = unit(square_to_edge(graph.normals[edge]), 1e-3);
    if (f == Vector(0.0)) {
        const bool steep = std::abs(along.z) > std::cos(radians(26));
        f = unit(square_to_edge(steep ? Vector(1, 0, 0) : Vector(0, 0, 1)));
    }
    return {f, glm::cross(along, f)};
}

RimPlacer::RimPlacer(const Graph& graph, const StrutPlacer& placer, const StrutShape& shape) : graph_(graph), placer_(placer), shape_(shape)
{
    const double side = 360.0 / shape.sides, rest = shape.twist - side * std::round(shape.twist / side); // the least turn that looks the same
    twist_ = std::abs(rest) > 1e-9 ? rest : 0.0;
    for (const int end : {0, 1})
        for (int k = 0; k < shape.sides; ++k) {
            const double angle = 2 * pi * k / shape.sides + radians(shape.phase + end * twist_);
            circles_[end].emplace_back(std::cos(angle), std::sin(angle));
        }
}

int RimPlacer::diagonal(const Point* a, const Point* b) const
{
    if (twist_ == 0) return 0;
    return orient(a[0], a[1], b[1], b[0]) < 0 ? 1 : -1;
}

void RimPlacer::place(const StrutPlacement& placement, std::uint32_t edge, Point* corners) const
{
    const StrutAxes axes = strut_axes(graph_, placer_, shape_.frame, edge);
    for (const std::uint32_t side : {0u, 1u}) {
        const std::uint32_t v = graph_.edges[edge][side];
        const auto& [radius, height] = placement.ends[2 * edge + side];
        const CoordinateGrid grid(graph_.vertices[v], placement.reach[v]);
        const Point center = graph_.vertices[v] + (side == 0 ? height : -height) * placer_.direction(edge);
        for (const Point2& step : circles_[side]) *corners++ = grid(center + radius * (step.x * axes.f + step.y * axes.g));
    }
}

} // namespace druse
