#include "graph/map_polyhedron.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "geom/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace druse {

namespace {

constexpr std::uint32_t no_number = std::numeric_limits<std::uint32_t>::max();
constexpr double nearly_on_ray = 1e-9; // the symmetric places of a tessellation are that exact

/// The part of a graph between two mirror rays: what lies inside, and what lies on them.
///
/// Points are numbered: first those inside, then those of the first ray from the centre out, then those of the second ray, of which there are as many.
class Sector {
public:
    Sector(const Graph& graph, const Disk& disk) : graph_(graph), angle_(2 * pi / disk.folds), sides_(graph.vertices.size(), outside), number_(graph.vertices.size(), no_number)
    {
        const Point2 turn = turn_by_degrees(-disk.turn);
        for (const Point& p : graph.vertices) turned_.emplace_back(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
        const Point2 far = druse::turn(1, disk.folds);
        for (std::size_t v = 0; v < turned_.size(); ++v) sides_[v] = side(turned_[v], far);
        find_points(far);
        find_edges();
    }

    std::uint32_t inner_count() const { return static_cast<std::uint32_t>(inner_.size()); }
    std::uint32_t ray_count() const { return static_cast<std::uint32_t>(radii_[0].size()); }
    double radius(std::uint32_t rank) const { return radii_[0][rank]; }
    struct Polar {
        double r, part; // of the sector, 0 to 1
    };
    const Polar& inner(std::uint32_t i) const { return inner_[i]; }
    const std::vector<std::array<std::uint32_t, 2>>& edges() const { return edges_; }
    /// Edges along a ray, by ranks.
    const std::vector<std::array<std::uint32_t, 2>>& ray_edges() const { return ray_edges_; }

private:
    enum Side : char { inside, on_first, on_second, outside };

    static double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

    /// A sector is at most half a disk.
    static Side side(const Point2& p, const Point2& far)
    {
        const double above_first = p.y, below_second = cross(p, far);
        if (std::abs(above_first) < nearly_on_ray && p.x > 0) return on_first;
        if (std::abs(below_second) < nearly_on_ray && glm::dot(p, far) > 0) return on_second;
        return above_first > 0 && below_second > 0 ? inside : outside;
    }

    /// A point of a ray: the crossing of an edge, or a vertex, whose number then stands beyond those of all edges.
    struct OnRay {
        double radius;
        std::uint32_t name;
    };

    void find_points(const Point2& far)
    {
        std::array<std::vector<OnRay>, 2> rays;
        const auto first_name = static_cast<std::uint32_t>(graph_.edges.size());
        for (std::uint32_t v = 0; v < turned_.size(); ++v) {
            const double r = glm::length(turned_[v]);
            if (sides_[v] == inside) {
                number_[v] = inner_count();
                inner_.push_back({r, std::atan2(turned_[v].y, turned_[v].x) / angle_});
            } else if (sides_[v] != outside) {
                rays[sides_[v] == on_first ? 0 : 1].push_back({r, first_name + v});
            }
        }
        crossing_.assign(graph_.edges.size(), no_number);
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            const auto [a, b] = graph_.edges[e];
            if ((sides_[a] == inside) == (sides_[b] == inside) || sides_[a] == on_first || sides_[a] == on_second || sides_[b] == on_first || sides_[b] == on_second)
                continue;
            const Point2 in = sides_[a] == inside ? turned_[a] : turned_[b], out = sides_[a] == inside ? turned_[b] : turned_[a];
            // It ends in the mirror image of where it begins, so it crosses half-way.
            const bool first = out.y < 0 && glm::distance(out, Point2(in.x, -in.y)) < glm::distance(out, mirrored(in, far));
            rays[first ? 0 : 1].push_back({glm::length(0.5 * (in + out)), e});
            crossing_[e] = first ? 0 : 1;
        }
        ASSERT(rays[0].size() == rays[1].size(), "as much on one mirror ray as on the other");
        vertex_rank_.assign(turned_.size(), no_number);
        edge_rank_.assign(graph_.edges.size(), no_number);
        for (int k = 0; k < 2; ++k) {
            std::ranges::sort(rays[std::size_t(k)], {}, &OnRay::radius);
            for (std::uint32_t rank = 0; rank < rays[std::size_t(k)].size(); ++rank) {
                const OnRay& point = rays[std::size_t(k)][rank];
                radii_[std::size_t(k)].push_back(point.radius);
                if (point.name < first_name) edge_rank_[point.name] = rank;
                else vertex_rank_[point.name - first_name] = rank;
            }
        }
        for (std::uint32_t v = 0; v < turned_.size(); ++v)
            if (vertex_rank_[v] != no_number) number_[v] = inner_count() + (sides_[v] == on_first ? 0 : ray_count()) + vertex_rank_[v];
    }

    static Point2 mirrored(const Point2& p, const Point2& ray) { return 2.0 * glm::dot(p, ray) * ray - p; }

    void find_edges()
    {
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            const auto [a, b] = graph_.edges[e];
            if (sides_[a] == on_second && sides_[b] == on_second) continue; // its like is on the first ray
            if (sides_[a] == on_first && sides_[b] == on_first) {
                ray_edges_.push_back({vertex_rank_[a], vertex_rank_[b]});
            } else if (number_[a] != no_number && number_[b] != no_number) {
                edges_.push_back({number_[a], number_[b]});
            } else if (crossing_[e] != no_number) {
                const std::uint32_t in = number_[a] != no_number ? number_[a] : number_[b];
                edges_.push_back({in, inner_count() + crossing_[e] * ray_count() + edge_rank_[e]});
            }
        }
    }

    const Graph& graph_;
    double angle_;
    std::vector<Point2> turned_;
    std::vector<Side> sides_;
    std::vector<std::uint32_t> number_, vertex_rank_, edge_rank_, crossing_;
    std::vector<Polar> inner_;
    std::array<std::vector<double>, 2> radii_;
    std::vector<std::array<std::uint32_t, 2>> edges_, ray_edges_;
};

} // namespace

Graph map_to_polyhedron(const Graph& graph, const Graph& solid)
{
    const Disk& disk = *graph.disk;
    if (!disk.mirrored || disk.folds < 2)
        throw CommandError(fmt::format("expected mirror rays through the corners of the face at the centre; this face of {} sides has {}", disk.sides,
                                       disk.mirrored ? "no other ray like its first" : "none, or the tessellation is chiral"));
    const Sector sector(graph, disk);
    const std::uint32_t inner = sector.inner_count(), on_ray = sector.ray_count();
    const std::size_t corners = solid.vertices.size();

    Graph result;
    result.vertices.reserve(corners * on_ray + solid.edges.size() * inner);
    result.edges.reserve(corners * sector.ray_edges().size() + solid.edges.size() * sector.edges().size());
    for (const Point& corner : solid.vertices) {
        const auto first = static_cast<std::uint32_t>(result.vertices.size());
        for (std::uint32_t rank = 0; rank < on_ray; ++rank) result.vertices.push_back(sector.radius(rank) * corner);
        for (const auto& [p, q] : sector.ray_edges()) result.edges.push_back({first + p, first + q});
    }
    for (const auto& [a, b] : solid.edges) {
        const Point &from = solid.vertices[a], &to = solid.vertices[b];
        const Vector square = unit(to - glm::dot(to, from) * from);
        const double beta = std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
        const auto first = static_cast<std::uint32_t>(result.vertices.size());
        for (std::uint32_t i = 0; i < inner; ++i) {
            const auto& [r, part] = sector.inner(i);
            result.vertices.push_back(r * (std::cos(beta * part) * from + std::sin(beta * part) * square));
        }
        const auto number = [&, a = a, b = b](std::uint32_t point) {
            if (point < inner) return first + point;
            const std::uint32_t rank = point - inner;
            return rank < on_ray ? a * on_ray + rank : b * on_ray + rank - on_ray;
        };
        for (const auto& [p, q] : sector.edges()) result.edges.push_back({number(p), number(q)});
    }
    return result;
}

} // namespace druse
