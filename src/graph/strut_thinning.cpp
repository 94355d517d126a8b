#include "graph/strut_thinning.h"

#include "geom/sort_unique.h"
#include "graph/strut_ball.h"
#include "graph/strut_part.h"
#include "graph/strut_rim.h"

#include <algorithm>

namespace druse {

namespace {

constexpr int gentle_rounds = 16;

/// Makes single parts, in triangles.
class PartMaker {
public:
    PartMaker(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutShape& shape, Progress& progress)
        : graph_(graph), incidence_(incidence), shape_(in_triangles(shape)), rim_placer_(graph, placer, shape_), n_(static_cast<std::uint32_t>(shape.sides)),
          rims_(std::size_t(2) * n_ * graph.edges.size()), ball_maker_(graph, incidence, placer, placement, shape_, rims_, progress)
    {
    }

    StrutPlacement placement; // of what is made from now on

    void make(std::uint32_t part, PartTriangles& out)
    {
        out.clear();
        const auto edges = static_cast<std::uint32_t>(graph_.edges.size());
        if (part < edges) make_strut(part, out);
        else make_ball(part - edges, out);
    }

private:
    static StrutShape in_triangles(StrutShape shape)
    {
        shape.triangulate = true;
        return shape;
    }
    Point* place(std::uint32_t edge)
    {
        Point* const rims = rims_.data() + std::size_t(2) * n_ * edge;
        rim_placer_.place(placement, edge, rims);
        return rims;
    }
    void make_strut(std::uint32_t edge, PartTriangles& out)
    {
        const Point *const a = place(edge), *const b = a + n_;
        const bool from_first = rim_placer_.diagonal(a, b) >= 0; // as the surface is cut
        for (std::uint32_t k = 0; k < n_; ++k) {
            const std::uint32_t l = k + 1 < n_ ? k + 1 : 0;
            out.add({a[k], a[l], from_first ? b[l] : b[k]});
            out.add({from_first ? a[k] : a[l], b[l], b[k]});
        }
    }
    void make_ball(std::uint32_t v, PartTriangles& out)
    {
        for (const std::uint32_t end : incidence_.ends(v)) place(end / 2);
        faces_.corners.clear();
        faces_.apexes.clear();
        ball_maker_.make(v, faces_);
        const auto corner = [this](std::size_t i) { return faces_.corners[i] & BallFaces::apex ? faces_.apexes[0] : rims_[faces_.corners[i]]; };
        for (std::size_t i = 0; i < faces_.corners.size(); i += 3) out.add({corner(i), corner(i + 1), corner(i + 2)});
    }

    const Graph& graph_;
    const Incidence& incidence_;
    StrutShape shape_;
    RimPlacer rim_placer_;
    std::uint32_t n_;
    std::vector<Point> rims_; // those that were asked for
    BallMaker ball_maker_;
    BallFaces faces_;
};

} // namespace

void thin(const Graph& graph, const Incidence& incidence, const StrutPlacement& placement, std::span<const PartPair> pairs, int round,
          std::vector<double>& factors)
{
    const auto edges = static_cast<std::uint32_t>(graph.edges.size());
    std::vector<std::uint32_t> vertices;
    for (const PartPair& pair : pairs)
        for (const std::uint32_t part : pair) {
            if (part >= edges) vertices.push_back(part - edges);
            else vertices.insert(vertices.end(), graph.edges[part].begin(), graph.edges[part].end());
        }
    sort_unique(vertices);
    const double step = round < gentle_rounds ? 0.8 : 0.5;
    for (const std::uint32_t v : vertices) {
        double largest = 0;
        for (const std::uint32_t end : incidence.ends(v)) largest = std::max(largest, placement.ends[end].radius);
        factors[v] *= step * std::min(largest / placement.wanted[v], 1.0);
    }
}

bool thin_out(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutShape& shape, const std::vector<PartPair>& pairs,
              std::vector<double>& factors, Progress& progress)
{
    PartMaker maker(graph, incidence, placer, shape, progress);
    PartTriangles first, second;
    std::vector<PartPair> left = pairs, met;
    for (int round = 0; round < most_thinnings; ++round) {
        maker.placement = placer.place(1, factors);
        met.clear();
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (i % 64 == 0) progress.step(double(round) / most_thinnings);
            if (i == 0 || left[i][0] != left[i - 1][0]) maker.make(left[i][0], first);
            maker.make(left[i][1], second);
            bool meet = false;
            first.for_each_contact(second, [&meet](const auto&, const auto&) { return !(meet = true); });
            if (meet) met.push_back(left[i]);
        }
        if (met.empty()) return true;
        thin(graph, incidence, maker.placement, met, round, factors);
        std::swap(left, met);
    }
    return false;
}

} // namespace druse
