#include "graph/tess.h"

#include "dlfl/errors.h"
#include "geom/turn.h"
#include "graph/hyperbolic.h"
#include "graph/symbol.h"
#include "graph/tess_growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace druse {

namespace {

using Complex = Motion::Complex;

std::string config_text(const std::vector<int>& config)
{
    std::string text;
    for (const int p : config) text += fmt::format("{}{}", text.empty() ? "" : ",", p);
    return text;
}

void require_hyperbolic(const std::vector<int>& config)
{
    const Geometry geometry = geometry_of(config);
    if (geometry == Geometry::hyperbolic) return;
    const std::string text = config_text(config);
    if (text == "3,3,3,3,3,3") throw CommandError("config=3,3,3,3,3,3: six triangles are flat; did you mean 3,3,3,3,3,3,3?");
    if (geometry == Geometry::euclidean)
        throw CommandError(fmt::format("config={} is Euclidean: the angles make exactly 360 degrees; expected more polygons, or larger ones", text));
    throw CommandError(fmt::format("config={} is spherical: the angles make less than 360 degrees; expected more polygons, or larger ones", text));
}

/// From where it grew to where it is wanted.
class Placement {
public:
    explicit Placement(const TessShape& shape)
        : model_(shape.model), mirror_(shape.mirror), shift_(Motion::to({shape.shift_x, shape.shift_y})), is_shifted_(shape.shift_x != 0 || shape.shift_y != 0)
    {
        const Point2 turn = turn_by_degrees(shape.turn);
        turn_ = {turn.x, turn.y};
    }

    Point operator()(Complex z) const
    {
        if (mirror_) z = std::conj(z);
        z *= turn_;
        if (is_shifted_) z = shift_(z);
        if (model_ == DiskModel::klein) z *= 2.0 / (1.0 + std::norm(z));
        if (model_ == DiskModel::halfplane) {
            if (std::abs(1.0 - z) < 1e-9) throw CommandError("model=halfplane: a vertex lies at infinity; another turn moves it away");
            z = Complex(0, 1) * (1.0 + z) / (1.0 - z);
        }
        return {z.real(), z.imag(), 0.0};
    }

private:
    DiskModel model_;
    bool mirror_;
    Complex turn_;
    Motion shift_;
    bool is_shifted_;
};

/// Grows the patch layer by layer, and places its vertices.
class GrowingPatch {
public:
    GrowingPatch(const TessShape& shape, AdjacencySymbol symbol) : shape_(shape), place_(shape), growth_(shape.config, std::move(symbol)) {}

    /// @return whether it fits: what is wrong is in complaint() else
    bool seed(int corner)
    {
        switch (shape_.center) {
        case Disk::Center::vertex: growth_.seed_vertex(); break;
        case Disk::Center::edge: growth_.seed_edge(corner); break;
        default: growth_.seed_face(corner); break;
        }
        return fits() && place_new();
    }

    bool add_layer(Progress& progress)
    {
        const std::uint32_t count = growth_.vertex_count();
        for (std::uint32_t v = 0; v < count; ++v) {
            if (v % 1024 == 0) progress.step(double(v) / count);
            growth_.complete(v);
            if (!fits()) return false;
        }
        ASSERT(std::int64_t(growth_.vertex_count()) - growth_.edge_count() + growth_.face_count() == 1, "V - E + F = 1");
        return place_new();
    }

    const std::string& complaint() const { return complaint_; }

    Tess take(bool with_polygons)
    {
        Tess result;
        Graph& graph = result.graph;
        graph.vertices = std::move(points_);
        graph.vertices.insert(graph.vertices.end(), along_.begin(), along_.end());
        const auto inner = static_cast<std::uint32_t>(shape_.arc - 1), vertices = growth_.vertex_count(), edges = growth_.edge_count();
        graph.edges.reserve(std::size_t(edges) * (inner + 1));
        std::vector<std::uint32_t> number(inner > 0 && with_polygons ? std::size_t(vertices) * shape_.config.size() : 0); // of the edge of a half-edge
        for (std::uint32_t e = 0; e < edges; ++e) {
            const TessGrowth::Half h = growth_.edge(e);
            std::uint32_t last = growth_.vertex(h);
            for (std::uint32_t next = vertices + e * inner; next < vertices + (e + 1) * inner; ++next) {
                graph.edges.push_back({last, next});
                last = next;
            }
            graph.edges.push_back({last, growth_.vertex(growth_.other(h))});
            if (!number.empty()) number[h] = number[growth_.other(h)] = e;
        }
        if (!with_polygons) return result;
        for (std::uint32_t f = 0; f < growth_.face_count(); ++f) {
            const std::size_t begin = result.polygon_corners.size();
            TessGrowth::Half h = growth_.face(f);
            for (int i = growth_.sides(h); i > 0; --i, h = growth_.next_in_face(h)) {
                result.polygon_corners.push_back(growth_.vertex(h));
                if (inner == 0) continue;
                const std::uint32_t e = number[h], first = vertices + e * inner;
                const bool forth = growth_.edge(e) == h;
                for (std::uint32_t j = 0; j < inner; ++j) result.polygon_corners.push_back(first + (forth ? j : inner - 1 - j));
            }
            // In the mirror it runs the other way; its first corner stays so.
            if (shape_.mirror) std::reverse(result.polygon_corners.begin() + static_cast<std::ptrdiff_t>(begin) + 1, result.polygon_corners.end());
            result.polygon_ends.push_back(static_cast<std::uint32_t>(result.polygon_corners.size()));
        }
        return result;
    }

private:
    bool fits()
    {
        if (growth_.vertex_count() + std::uint64_t(growth_.edge_count()) * static_cast<std::uint64_t>(shape_.arc - 1) <= most_tess_vertices) return true;
        complaint_ = fmt::format("more than {} vertices", most_tess_vertices);
        return false;
    }

    /// Gives the vertices and edges that are new their places and lengths.
    bool place_new()
    {
        for (auto v = static_cast<std::uint32_t>(points_.size()); v < growth_.vertex_count(); ++v) points_.push_back(place_(growth_.place(v)));
        for (; measured_ < growth_.edge_count(); ++measured_) {
            const TessGrowth::Half h = growth_.edge(measured_);
            Point last = points_[growth_.vertex(h)];
            for (int i = 1; i < shape_.arc; ++i) {
                along_.push_back(place_(growth_.along(h, double(i) / shape_.arc)));
                if (!is_long_enough(last, along_.back())) return false;
                last = along_.back();
            }
            if (!is_long_enough(last, points_[growth_.vertex(growth_.other(h))])) return false;
        }
        return true;
    }

    bool is_long_enough(const Point& a, const Point& b)
    {
        if (glm::distance(a, b) >= shortest_tess_edge) return true;
        complaint_ = fmt::format("{} shorter than {}", shape_.arc > 1 ? "pieces of edges" : "edges", shortest_tess_edge);
        return false;
    }

    const TessShape& shape_;
    Placement place_;
    TessGrowth growth_;
    std::vector<Point> points_, along_; // of vertices, and of what lies between the ends of an edge, edge after edge
    std::uint32_t measured_ = 0;
    std::string complaint_;
};

/// The corner or slot that `center` names.
int find_center(const TessShape& shape)
{
    const int k = static_cast<int>(shape.config.size());
    if (shape.center_number < 0 || shape.center == Disk::Center::vertex) return 0;
    if (shape.center == Disk::Center::edge) {
        if (shape.center_number < k) return shape.center_number;
        throw CommandError(fmt::format("center=edge:{}: expected a slot 0 to {}", shape.center_number, k - 1));
    }
    const auto at = std::ranges::find(shape.config, shape.center_number);
    if (at == shape.config.end())
        throw CommandError(fmt::format("center=face:{}: config={} has no such polygon", shape.center_number, config_text(shape.config)));
    return static_cast<int>(at - shape.config.begin());
}

Disk disk_of(const TessShape& shape, const AdjacencySymbol& symbol, int corner)
{
    Disk disk;
    disk.klein = shape.model == DiskModel::klein;
    if (shape.shift_x != 0 || shape.shift_y != 0) return disk;
    disk.center = shape.center;
    disk.turn = shape.turn;
    if (shape.center != Disk::Center::face) return disk;
    disk.sides = shape.config[std::size_t(corner)];
    disk.folds = disk.sides / symbol.period(corner);
    disk.mirrored = symbol.is_mirrored_at(corner);
    return disk;
}

} // namespace

Tess tessellate(const TessShape& shape, bool with_polygons, Progress& progress)
{
    require_hyperbolic(shape.config);
    const auto symbol = find_symbol(shape.config);
    if (!symbol) throw CommandError(fmt::format("config={} has no vertex-uniform tessellation", config_text(shape.config)));
    const int corner = find_center(shape);

    GrowingPatch patch(shape, *symbol);
    if (!patch.seed(corner)) {
        const bool is_shifted = shape.shift_x != 0 || shape.shift_y != 0;
        throw CommandError(fmt::format("layers={} would give {}, and so would layers=0{}", shape.layers, patch.complaint(), is_shifted ? "; expected a smaller shift" : ""));
    }
    for (int done = 0; done < shape.layers; ++done)
        if (!patch.add_layer(progress)) throw CommandError(fmt::format("layers={} would give {}; expected {} or less", shape.layers, patch.complaint(), done));
    Tess result = patch.take(with_polygons);
    if (shape.model != DiskModel::halfplane) result.graph.disk = disk_of(shape, *symbol, corner);
    return result;
}

} // namespace druse
