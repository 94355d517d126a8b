#include "graph/map.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "graph/clean_graph.h"
#include "graph/expression.h"
#include "graph/map_knot.h"
#include "graph/map_polyhedron.h"

#include <fmt/format.h>

#include <cmath>

namespace druse {

namespace {

void require_center_face(const Disk& disk)
{
    if (disk.center == Disk::Center::face) return;
    if (disk.center == Disk::Center::elsewhere) throw CommandError("expected a face at the centre; the tessellation was shifted away from it");
    throw CommandError(fmt::format("expected a face at the centre, not {}; graph.tess with center=face or face:N makes one",
                                   disk.center == Disk::Center::vertex ? "a vertex" : "an edge"));
}

// --- heights --------------------------------------------------------------------------------------------------------------------

Graph polyp(const Graph& graph, const MapShape& shape)
{
    Graph result{.vertices = graph.vertices, .edges = graph.edges};
    const auto at_rim = [&](double r) { return shape.height * (1.0 - (r - shape.rim) / shape.rim * ((r - shape.rim) / shape.rim)); };
    if (!shape.height_expr) {
        for (Point& p : result.vertices) p.z = at_rim(std::hypot(p.x, p.y));
        return result;
    }
    try {
        const Expression height(*shape.height_expr);
        for (std::size_t v = 0; v < result.vertices.size(); ++v) {
            Point& p = result.vertices[v];
            try {
                p.z = height({p.x, p.y, std::hypot(p.x, p.y), std::atan2(p.y, p.x)});
            } catch (const CommandError& e) {
                throw CommandError(fmt::format("{}, at vertex {} ({}, {})", e.what(), v, p.x, p.y));
            }
        }
    } catch (const CommandError& e) {
        throw CommandError(fmt::format("height_expr={}: {}", *shape.height_expr, e.what()));
    }
    return result;
}

// --- sweeps ---------------------------------------------------------------------------------------------------------------------

/// Sweeps the disk about its centre: copy j of vertex v is at radius r[v] and angle theta[v] + 2 pi j.
class Sweep {
public:
    explicit Sweep(const Graph& graph, Progress& progress) : graph_(graph), progress_(progress)
    {
        for (const Point& p : graph.vertices) {
            r_.push_back(std::hypot(p.x, p.y));
            double theta = std::atan2(p.y, p.x);
            if (theta < 0) theta += 2 * pi;
            theta_.push_back(theta > 2 * pi - 1e-9 ? 0.0 : theta);
        }
    }

    /// `copies` of it, the last joined to the first if `closed`; `place(r, theta)` puts each vertex where it goes.
    template <class Place>
    Graph make(int copies, bool closed, Place&& place) const
    {
        const std::size_t count = graph_.vertices.size();
        if (count * static_cast<std::size_t>(copies) > most || graph_.edges.size() * static_cast<std::size_t>(copies) > most)
            throw CommandError(fmt::format("{} times round would make more than {} vertices or edges", copies, most));
        Graph result;
        result.vertices.reserve(count * static_cast<std::size_t>(copies));
        result.edges.reserve(graph_.edges.size() * static_cast<std::size_t>(copies));
        for (int j = 0; j < copies; ++j) {
            for (std::size_t v = 0; v < count; ++v) {
                if (v % 4096 == 0) progress_.step((j + double(v) / double(count)) / copies);
                result.vertices.push_back(place(r_[v], theta_[v] + 2 * pi * j));
            }
            for (const auto& [a, b] : graph_.edges) {
                // The short way round: over the ray at angle 0 it leads to the copy before or after.
                const double turn = theta_[b] - theta_[a];
                int other = turn > pi ? j - 1 : turn < -pi ? j + 1 : j;
                if (other < 0 || other == copies) {
                    if (!closed) continue;
                    other = other < 0 ? copies - 1 : 0;
                }
                result.edges.push_back({static_cast<std::uint32_t>(count) * static_cast<std::uint32_t>(j) + a,
                                        static_cast<std::uint32_t>(count) * static_cast<std::uint32_t>(other) + b});
            }
        }
        return result;
    }

private:
    static constexpr std::size_t most = 20'000'000;

    const Graph& graph_;
    Progress& progress_;
    std::vector<double> r_, theta_;
};

Graph helix(const Sweep& sweep, const MapShape& shape)
{
    const double alpha = shape.span * 0.5 * pi / (2 * pi * shape.turns);
    Graph result = sweep.make(2 * shape.turns, false, [&](double r, double swept) {
        const double theta = swept - 2 * pi * shape.turns, c = std::cos(theta), s = std::sin(theta);
        if (shape.shape == HelixShape::cylinder) return Point(r * c, r * s, shape.pitch * theta / (2 * pi));
        return Point(r * std::cos(alpha * theta) * c, r * std::cos(alpha * theta) * s, std::sin(alpha * theta));
    });
    drop_isolated(result);
    return result;
}

Graph torus(const Sweep& sweep, const MapShape& shape)
{
    constexpr SweepSize usual = usual_sweep(MapTo::torus);
    const int cycles = shape.cycles.value_or(usual.cycles);
    const double major = shape.major.value_or(usual.major), rho = shape.rho.value_or(usual.rho);
    if (!(rho < major)) throw CommandError(fmt::format("rho={}: expected less than major={}, or the tube would meet itself", rho, major));
    return sweep.make(cycles, true, [&](double r, double theta) {
        const double along = theta / cycles, out = major + rho * r * std::cos(theta);
        return Point(out * std::cos(along), out * std::sin(along), rho * r * std::sin(theta));
    });
}

Graph knot(const Sweep& sweep, const MapShape& shape, std::vector<std::string>& notes)
{
    constexpr SweepSize usual = usual_sweep(MapTo::knot);
    const int cycles = shape.cycles.value_or(usual.cycles);
    const double major = shape.major.value_or(usual.major), rho = shape.rho.value_or(usual.rho), phase = radians(shape.phase);
    if (!(shape.minor < major)) throw CommandError(fmt::format("minor={}: expected less than major={}", shape.minor, major));
    const Trefoil line(major, shape.minor);
    if (!line.is_bent()) throw CommandError(fmt::format("major={} minor={}: the centre line is straight in a place, and has no frame there", major, shape.minor));
    if (!shape.force)
        if (const double most = line.thickness(); !(rho < most))
            throw CommandError(fmt::format("rho={}: expected less than {:.4g}, or the tube would meet itself; force=true allows that", rho, most));
    if (cycles % 3 != 0) notes.push_back(fmt::format("cycles={} is no multiple of 3, so the knot is not the same after a third of a turn", cycles));
    return sweep.make(cycles, true, [&](double r, double theta) {
        const Trefoil::Frame f = line.frame(theta / cycles);
        return f.place + rho * r * (std::cos(theta + phase) * f.normal + std::sin(theta + phase) * f.binormal);
    });
}

Graph mapped(const Graph& graph, const MapShape& shape, const Graph& solid, std::vector<std::string>& notes, Progress& progress)
{
    if (shape.to == MapTo::disk) return {.vertices = graph.vertices, .edges = graph.edges};
    if (graph.disk->klein) notes.push_back("the tessellation lies in Klein's disk: it comes nearer to the rim than in Poincaré's, and figures look different");
    if (shape.to == MapTo::polyp) return polyp(graph, shape);
    require_center_face(*graph.disk);
    if (shape.to == MapTo::polyhedron) return map_to_polyhedron(graph, solid);
    const Sweep sweep(graph, progress);
    if (shape.to == MapTo::helix) return helix(sweep, shape);
    return shape.to == MapTo::torus ? torus(sweep, shape) : knot(sweep, shape, notes);
}

} // namespace

Graph map_disk(const Graph& graph, const MapShape& shape, const Graph& solid, std::vector<std::string>& notes, Progress& progress)
{
    if (!graph.disk) throw CommandError("expected a tessellation of the disk, as graph.tess makes one; a file keeps only its points and lines");
    if (graph.edges.empty()) throw CommandError("the graph has no edges");
    Graph result = mapped(graph, shape, solid, notes, progress);
    for (std::size_t v = 0; v < result.vertices.size(); ++v) {
        Point& p = result.vertices[v];
        p *= shape.size;
        if (!is_in_reach(p)) throw CommandError(fmt::format("vertex {} would lie beyond {}", v, largest_coordinate));
    }
    if (result.edges.empty()) throw CommandError("nothing is left of the graph: it has no edges there");
    return result;
}

} // namespace druse
