#include "cell/freedom.h"

#include "dlfl/ray_cast.h"
#include "geom/box_tree.h"
#include "geom/triangle_contact.h"
#include "geom/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace druse {

namespace {

constexpr double aside = 1e-9; // a cosine that is nothing

Box box_of(const CellSolid& solid)
{
    Box box;
    for (const Point& p : solid.points) box.add(p);
    return box;
}

Triangle triangle_at(const CellSolid& solid, std::size_t i, const Vector& shift)
{
    const auto& t = solid.triangles[i];
    return {solid.points[t[0]] + shift, solid.points[t[1]] + shift, solid.points[t[2]] + shift};
}

/// How far apart the boxes of two triangles are along the axis that parts them most.
double box_gap(const Triangle& a, const Triangle& b)
{
    const Vector above = glm::min(glm::min(b[0], b[1]), b[2]) - glm::max(glm::max(a[0], a[1]), a[2]);
    const Vector below = glm::min(glm::min(a[0], a[1]), a[2]) - glm::max(glm::max(b[0], b[1]), b[2]);
    return std::max({0.0, above.x, above.y, above.z, below.x, below.y, below.z});
}

bool cross_each_other(const Triangle& a, const Triangle& b)
{
    const Shadow shadow = shadow_of(a);
    return shadow.turn != 0 && shadow_of(b).turn != 0 && meet_beyond_common(a, shadow, b);
}

} // namespace

std::vector<LatticeStep> cells_near(const CellTile& tile, const CellSolid& solid, double reach)
{
    constexpr double most = 100'000;
    const Vector extent = box_of(solid).size() + Vector(reach);
    const std::array<Vector, 3> lattice{tile.world(tile.cell().lattice[0]), tile.world(tile.cell().lattice[1]), tile.world(tile.cell().lattice[2])};
    const double det = glm::dot(lattice[0], glm::cross(lattice[1], lattice[2]));
    std::array<double, 3> far{}; // in steps
    for (std::size_t k = 0; k < 3; ++k) far[k] = std::floor(glm::dot(glm::abs(glm::cross(lattice[(k + 1) % 3], lattice[(k + 2) % 3])), extent) / std::abs(det));
    if (!((2 * far[0] + 1) * (2 * far[1] + 1) * (2 * far[2] + 1) <= most)) throw CommandError("the cell is so large in its lattice that it reaches more than 100 000 others");
    std::vector<LatticeStep> near;
    const auto n = [&](std::size_t k) { return static_cast<int>(far[k]); };
    for (int i = -n(0); i <= n(0); ++i)
        for (int j = -n(1); j <= n(1); ++j)
            for (int k = -n(2); k <= n(2); ++k) {
                const Vector away = glm::abs(double(i) * lattice[0] + double(j) * lattice[1] + double(k) * lattice[2]);
                if (LatticeStep{i, j, k} != LatticeStep{} && away.x <= extent.x && away.y <= extent.y && away.z <= extent.z) near.push_back({i, j, k});
            }
    return near;
}

std::vector<Vector> free_directions(const CellTile& tile, const CellSolid& solid, Progress& progress)
{
    const std::vector<LatticeStep> near = cells_near(tile, solid, 0);
    std::vector<Vector> centres;
    MeshBuilder builder;
    for (const LatticeStep& step : near) {
        centres.push_back(tile.world(tile.cell().at(step)));
        add_solid(builder, solid, std::array{static_cast<int>(centres.size())}, centres.back());
    }
    const Mesh others = builder.build();
    const RayCast rays(others, progress, 0.3);
    const double far = 4 * box_of(solid).diagonal();

    // Who moves ahead of a neighbour leaves it behind: so where one goes, the opposite way is open too.
    constexpr std::array<std::array<int, 3>, 13> half{{{1, 1, 1}, {1, 1, 0}, {1, 1, -1}, {1, 0, 1}, {1, 0, 0}, {1, 0, -1}, {1, -1, 1}, {1, -1, 0}, {1, -1, -1},
                                                       {0, 1, 1}, {0, 1, 0}, {0, 1, -1}, {0, 0, 1}}};
    std::vector<Vector> free;
    for (std::size_t k = 0; k < half.size(); ++k) {
        const Vector way(half[k][0], half[k][1], half[k][2]), ahead = glm::normalize(way);
        std::vector<bool> there; // whether a cell is
        for (const Vector& c : centres) there.push_back(glm::dot(c, ahead) <= aside * far);
        const auto looks_ahead = [&](const Triangle& t) { return glm::dot(direction(glm::cross(t[1] - t[0], t[2] - t[0])), ahead); };
        bool leaves = true;
        std::vector<std::size_t> front;
        for (std::size_t i = 0; i < solid.triangles.size() && leaves; ++i) {
            if (!(looks_ahead(triangle_at(solid, i, Vector(0.0))) > aside)) continue;
            front.push_back(i);
            const CellSolid::Side& side = solid.sides[i];
            const Vector across = tile.world(tile.cell().at(tile.cell().panes[static_cast<std::size_t>(side.pane)].translation));
            leaves = (side.far ? -1 : 1) * glm::dot(across, ahead) > aside * far; // else it is against one that stays
        }
        const auto stops = [&](std::uint32_t t) {
            return there[static_cast<std::size_t>(others.group(rays.triangles().face(t))) - 1] && looks_ahead(rays.triangles()[t]) < -aside;
        };
        for (std::size_t i = 0; i < front.size() && leaves; ++i) {
            if (i % 256 == 0) progress.step(0.3 + 0.7 * (double(k) + double(i) / double(front.size())) / double(half.size()));
            const Triangle t = triangle_at(solid, front[i], Vector(0.0));
            leaves = !rays.first_of((t[0] + t[1] + t[2]) / 3.0, ahead, far, stops);
        }
        if (!leaves) continue;
        free.push_back(way);
        free.push_back(Vector(0.0) - way); // without a zero below zero
    }
    return free;
}

double least_distance(const CellTile& tile, const CellSolid& solid, double reach, Progress& progress)
{
    const auto count = static_cast<std::uint32_t>(solid.triangles.size());
    double least = reach;
    for (const LatticeStep& step : cells_near(tile, solid, reach)) {
        progress.step(0);
        if (step < LatticeStep{}) continue; // the cell the other way is as far
        const Vector shift = tile.world(tile.cell().at(step));
        std::vector<Box> boxes;
        for (const Vector& by : {Vector(0.0), shift})
            for (std::size_t i = 0; i < count; ++i) {
                Box& box = boxes.emplace_back();
                for (const Point& p : triangle_at(solid, i, by)) box.add(p);
                box.min -= Vector(0.5 * least);
                box.max += Vector(0.5 * least);
            }
        const BoxTree tree(boxes, progress, 0, 0.5);
        tree.for_each_pair(progress, 0.5, [&](std::uint32_t i, std::uint32_t j) {
            if (i > j) std::swap(i, j);
            if (i >= count || j < count) return true;
            const Triangle a = triangle_at(solid, i, Vector(0.0)), b = triangle_at(solid, j - count, shift);
            const double gap = box_gap(a, b);
            if (gap < least) least = gap == 0 && cross_each_other(a, b) ? 0 : std::min(least, triangle_distance(a, b));
            return least > 0;
        });
    }
    return least;
}

} // namespace druse
