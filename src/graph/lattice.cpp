#include "graph/lattice.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "graph/clean_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace druse {

namespace {

using Cell = std::array<int, 3>;

constexpr int most_vertices = 10'000'000; // of a net; one of 64 cells each way has 2 million

constexpr Cell diamond_sites[] = {{0, 0, 0}, {0, 2, 2}, {2, 0, 2}, {2, 2, 0}, {1, 1, 1}, {1, 3, 3}, {3, 1, 3}, {3, 3, 1}};
constexpr Cell srs_sites[] = {{0, 0, 0}, {1, 2, 3}, {2, 3, 1}, {3, 1, 2}, {2, 2, 2}, {3, 0, 1}, {0, 1, 3}, {1, 3, 0}};

int wrapped(int x) { return ((x % 4) + 4) % 4; }

/// Which of the 64 places of a cell are vertices of a net: eight of them.
class Sites {
public:
    static constexpr std::uint8_t per_cell = 8, none = per_cell;

    Sites(Net kind, bool twin)
    {
        number_.fill(none);
        std::uint8_t count = 0;
        for (const Cell& p : kind == Net::diamond ? std::span<const Cell>(diamond_sites) : std::span<const Cell>(srs_sites)) {
            Cell q = p;
            // The shifts that keep the nets farthest apart; that of srs is the mirror image.
            for (int& x : q)
                if (twin) x = kind == Net::diamond ? x + 2 : 3 - x;
            number_[place(q)] = count++;
        }
    }
    /// Its number among them, or none.
    std::uint8_t operator()(const Cell& p) const { return number_[place(p)]; }

private:
    static std::size_t place(const Cell& p) { return static_cast<std::size_t>(16 * wrapped(p[2]) + 4 * wrapped(p[1]) + wrapped(p[0])); }
    std::array<std::uint8_t, 64> number_;
};

/// Differences of the ends of an edge: of the lattice points that far apart, those above, so that each edge is met once, from its lower end.
std::vector<Cell> bonds(Net kind)
{
    std::vector<Cell> list;
    const int square = kind == Net::diamond ? 3 : 2;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x * x + y * y + z * z == square && std::array{z, y, x} > std::array{0, 0, 0}) list.push_back({x, y, z});
    return list;
}

/// The region that is searched, and what of it is kept.
class Region {
public:
    explicit Region(const LatticeShape& shape) : trim_(shape.trim)
    {
        const int least = *std::min_element(shape.cells.begin(), shape.cells.end());
        const double cells = shape.size.value_or(0.5 * least);
        radius_ = 4 * cells;
        if (const double vertices = 8 * 4.0 / 3 * pi * cells * cells * cells; trim_ == Trim::ball && vertices > most_vertices)
            throw CommandError(fmt::format("size={:.6g}: the ball would hold more than {} million vertices", cells, most_vertices / 1'000'000));
        for (std::size_t k = 0; k < 3; ++k) {
            center_[k] = 2 * shape.cells[k];
            const int reach = trim_ == Trim::ball ? static_cast<int>(std::floor(radius_)) : center_[k];
            low_[k] = center_[k] - reach;
            width_[k] = 2 * reach + (trim_ == Trim::cell ? 0 : 1);
            first_cell_[k] = (low_[k] - wrapped(low_[k])) / 4;
            cells_[k] = static_cast<std::size_t>((low_[k] + width_[k] - 1) / 4 - first_cell_[k] + 1);
        }
    }
    const Cell& low() const { return low_; }
    const Cell& width() const { return width_; }
    bool holds(const Cell& p) const
    {
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (p[k] < low_[k] || p[k] >= low_[k] + width_[k]) return false;
            square += double(p[k] - center_[k]) * (p[k] - center_[k]);
        }
        return trim_ != Trim::ball || square <= radius_ * radius_;
    }
    /// The number of the cell of a place in it, and how many there are.
    std::size_t cell(const Cell& p) const
    {
        const auto at = [&](std::size_t k) { return static_cast<std::size_t>((p[k] - wrapped(p[k])) / 4 - first_cell_[k]); };
        return (at(2) * cells_[1] + at(1)) * cells_[0] + at(0);
    }
    std::size_t cell_count() const { return cells_[0] * cells_[1] * cells_[2]; }

private:
    Trim trim_;
    double radius_;
    Cell center_, low_, width_, first_cell_;
    std::array<std::size_t, 3> cells_;
};

void add_net(Graph& graph, const LatticeShape& shape, bool twin, Progress& progress)
{
    const Sites sites(shape.kind, twin);
    const Region region(shape);
    const std::vector<Cell> above = bonds(shape.kind);
    const std::size_t first_edge = graph.edges.size();
    std::vector<std::uint32_t> number(Sites::per_cell * region.cell_count()); // of sites, cell after cell
    const auto find = [&](const Cell& p) -> std::uint32_t* {
        const std::uint8_t site = sites(p);
        return site != Sites::none && region.holds(p) ? &number[Sites::per_cell * region.cell(p) + site] : nullptr;
    };
    const auto for_each_site = [&](double share, auto&& f) {
        const auto& [x0, y0, z0] = region.low();
        const auto& [nx, ny, nz] = region.width();
        for (int z = 0; z < nz; ++z) {
            progress.step((twin ? 0.5 : 0.0) + share * z / nz);
            for (int y = 0; y < ny; ++y)
                for (int x = 0; x < nx; ++x) {
                    const Cell p{x0 + x, y0 + y, z0 + z};
                    if (std::uint32_t* n = find(p)) f(p, *n);
                }
        }
    };
    for_each_site(0.2, [&](const Cell& p, std::uint32_t& n) {
        n = static_cast<std::uint32_t>(graph.vertices.size());
        graph.vertices.emplace_back(p[0], p[1], p[2]);
    });
    for_each_site(0.5, [&](const Cell& p, std::uint32_t n) {
        for (const Cell& d : above) {
            if (const std::uint32_t* other = find({p[0] + d[0], p[1] + d[1], p[2] + d[2]})) graph.edges.push_back({n, *other});
        }
    });
    std::sort(graph.edges.begin() + static_cast<std::ptrdiff_t>(first_edge), graph.edges.end());
}

/// Takes away vertices with one edge, again and again: each is looked at once more when it loses an edge.
void drop_leaves(Graph& graph)
{
    std::vector<std::uint32_t> valence(graph.vertices.size(), 0), across(graph.vertices.size(), 0), leaves;
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e)
        for (const std::uint32_t v : graph.edges[e]) {
            ++valence[v];
            across[v] ^= e; // of a leaf, its edge
        }
    for (std::uint32_t v = 0; v < valence.size(); ++v)
        if (valence[v] == 1) leaves.push_back(v);
    std::vector<bool> gone(graph.edges.size(), false);
    while (!leaves.empty()) {
        const std::uint32_t v = leaves.back();
        leaves.pop_back();
        if (valence[v] != 1) continue;
        const std::uint32_t e = across[v], w = graph.edges[e][0] ^ graph.edges[e][1] ^ v;
        gone[e] = true;
        valence[v] = 0;
        across[w] ^= e;
        if (--valence[w] == 1) leaves.push_back(w);
    }
    std::size_t kept = 0;
    for (std::size_t e = 0; e < gone.size(); ++e)
        if (!gone[e]) graph.edges[kept++] = graph.edges[e];
    graph.edges.resize(kept);
}

} // namespace

Graph lattice(const LatticeShape& shape, Progress& progress)
{
    Graph graph;
    add_net(graph, shape, false, progress);
    if (shape.twin) add_net(graph, shape, true, progress);
    if (!shape.leaves) drop_leaves(graph);
    drop_isolated(graph);
    if (graph.edges.empty()) throw CommandError("no edge is left: take more cells, or keep the leaves");

    Box box;
    for (const Point& p : graph.vertices) box.add(p);
    const double scale = shape.bond / std::sqrt(shape.kind == Net::diamond ? 3.0 : 2.0);
    for (Point& p : graph.vertices) {
        p = scale * (p - box.center());
        if (!is_in_reach(p)) throw CommandError(fmt::format("bond={}: the net would reach beyond {}", shape.bond, largest_coordinate));
    }
    return graph;
}

} // namespace druse
