#include "cell/pane_mesh.h"

#include <algorithm>

namespace druse {

auto PaneMesh::find(Index a, Index b) const -> std::optional<Place>
{
    for (Index t = 0; t < triangles.size(); ++t)
        for (Index k = 0; k < 3; ++k)
            if (triangles[t][k] == a && triangles[t][(k + 1) % 3] == b) return Place{t, k};
    return {};
}

auto PaneMesh::split_triangle(Index triangle, int split) -> Index
{
    const Index s = point_count();
    made.push_back({split, -1});
    const auto [a, b, c] = triangles[triangle];
    triangles[triangle] = {a, b, s};
    triangles.push_back({b, c, s});
    triangles.push_back({c, a, s});
    return s;
}

auto PaneMesh::split_edge(Index a, Index b, int split, int side) -> Index
{
    const Index s = point_count();
    std::vector<Place> places;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
        if (const auto place = find(from, to)) places.push_back(*place);
    std::ranges::sort(places, {}, &Place::triangle);
    made.push_back({split, side});
    for (const Place& p : places) {
        const Index from = triangles[p.triangle][p.side], to = triangles[p.triangle][(p.side + 1) % 3], top = opposite(p);
        triangles[p.triangle] = {from, s, top};
        triangles.push_back({s, to, top});
    }
    if (side >= 0) {
        const auto before = std::ranges::find(rim, next_on_rim(a) == b ? a : b);
        rim.insert(before + 1, s);
    }
    return s;
}

void PaneMesh::flip(Index a, Index b)
{
    Place p = *find(a, b), q = *find(b, a);
    if (q.triangle < p.triangle) std::swap(p, q);
    const Index from = triangles[p.triangle][p.side], to = triangles[q.triangle][q.side];
    const Index left = opposite(p), right = opposite(q);
    triangles[p.triangle] = {from, right, left};
    triangles[q.triangle] = {to, left, right};
}

auto PaneMesh::next_on_rim(Index point) const -> Index
{
    const auto at = std::ranges::find(rim, point);
    return at + 1 == rim.end() ? rim.front() : at[1];
}

} // namespace druse
