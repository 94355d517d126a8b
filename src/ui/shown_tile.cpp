#include "ui/shown_tile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace druse::ui {

namespace {

Point2 middle(const IsohedralType& type, const CornerVector& corners)
{
    Point2 sum(0.0);
    for (int k = 0; k < type.corners; ++k) sum += corner(corners, k);
    return sum / double(type.corners);
}

struct PlacedCopy {
    DrawnCopy copy;
    double distance;
};

/// All copies a few places of the lattice around the tile, the nearest first, itself at the front.
std::vector<PlacedCopy> copies_near(const IsohedralType& type, const CornerVector& corners, int reach)
{
    const Point2 t0 = type.placed.lattice[0].at(corners), t1 = type.placed.lattice[1].at(corners), own = middle(type, corners);
    std::vector<PlacedCopy> list;
    for (int a = 0; a < type.aspects(); ++a) {
        const Isometry own_map = isometry(type.placed.representatives[std::size_t(a)], corners, 1);
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j) {
                const Isometry map{own_map.x, own_map.y, own_map.shift + double(i) * t0 + double(j) * t1};
                const bool self = a == 0 && i == 0 && j == 0;
                list.push_back({{map, a, {i, j}, type.colours.of(a, i, j)}, self ? -1 : glm::distance(map(own), own)});
            }
    }
    std::ranges::stable_sort(list, {}, &PlacedCopy::distance);
    return list;
}

} // namespace

std::vector<Point2> ShownTile::outline_points() const
{
    std::vector<Point2> list(static_cast<std::size_t>(outline));
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = points[i].at;
    return list;
}

Point2 ShownTile::low() const
{
    Point2 p(0.0);
    for (int i = 0; i < outline; ++i) p = i == 0 ? points[0].at : glm::min(p, points[std::size_t(i)].at);
    return p;
}

Point2 ShownTile::high() const
{
    Point2 p(0.0);
    for (int i = 0; i < outline; ++i) p = i == 0 ? points[0].at : glm::max(p, points[std::size_t(i)].at);
    return p;
}

int ShownTile::find(const std::string& name) const
{
    const auto found = std::ranges::find(points, name, &TilePoint::name);
    return found == points.end() ? -1 : int(found - points.begin());
}

bool ShownTile::holds(const Point2& p) const
{
    bool inside = false;
    for (int i = 0, last = outline - 1; i < outline; last = i++) {
        const Point2 &a = points[std::size_t(i)].at, &b = points[std::size_t(last)].at;
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

std::vector<DrawnCopy> copies_around(const IsohedralType& type, const CornerVector& corners, std::size_t count)
{
    // A cell of one aspect needs the widest reach; one more aspect means as many more copies.
    const int reach = 1 + static_cast<int>(std::ceil(std::sqrt(double(count + 1) / type.aspects())));
    std::vector<DrawnCopy> list;
    for (const PlacedCopy& near : copies_near(type, corners, reach)) {
        if (list.size() > count) break;
        list.push_back(near.copy);
    }
    return list;
}

std::vector<RotationCentre> rotation_centres(const IsohedralType& type, const CornerVector& corners)
{
    const Point2 own = middle(type, corners);
    double reach = 0;
    for (int k = 0; k < type.corners; ++k) reach = std::max(reach, glm::distance(corner(corners, k), own));
    std::vector<RotationCentre> centres;
    for (const PlacedCopy& near : copies_near(type, corners, 3)) {
        const Isometry& m = near.copy.map;
        const double cosine = m.x.x, sine = m.x.y;
        if (reflects(m) || cosine > 1 - 1e-9) continue; // a reflection or a translation
        // (1 − R) c = t
        const double a = 1 - cosine, det = a * a + sine * sine;
        const Point2 c = Point2(a * m.shift.x - sine * m.shift.y, sine * m.shift.x + a * m.shift.y) / det;
        if (glm::distance(c, own) > 1.25 * reach) continue;
        const int order = static_cast<int>(std::lround(2 * std::numbers::pi / std::acos(std::clamp(cosine, -1.0, 1.0))));
        const auto known = std::ranges::find_if(centres, [&](const RotationCentre& k) { return glm::distance(k.at, c) < 1e-6 * reach; });
        if (known == centres.end()) centres.push_back({c, order});
        else known->order = std::max(known->order, order);
    }
    return centres;
}

} // namespace druse::ui
