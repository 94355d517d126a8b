#include "tile/tile_distance.h"

#include "geom/ear_clipping.h"
#include "geom/triangle_distance.h"

#include <algorithm>
#include <vector>

namespace druse {

namespace {

/// Top, bottom and walls in triangles.
std::vector<Triangle> facets(const TileSolid& solid, const SolidPlace& place)
{
    const auto at = [&](const Point& p) { return Point(place.motion(Point2(p)), p.z + place.up); };
    std::vector<Triangle> list;
    for (const HeightField* field : {&solid.top, &solid.bottom})
        for (const auto& t : field->triangles) list.push_back({at(field->points[t[0]]), at(field->points[t[1]]), at(field->points[t[2]])});
    std::vector<Point> wall;
    std::vector<Point2> flat;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t k = 0; k < solid.top_rim.size(); ++k) {
        wall.clear();
        for (const std::uint32_t v : solid.bottom_rim[k]) wall.push_back(solid.bottom.points[v]);
        for (std::size_t i = solid.top_rim[k].size(); i-- > 0;) wall.push_back(solid.top.points[solid.top_rim[k][i]]);
        flat.clear();
        const Point2 from(wall.front());
        for (const Point& p : wall) flat.emplace_back(glm::length(Point2(p) - from), p.z);
        triangles.clear();
        clip_ears(flat, triangles);
        for (const auto& t : triangles) list.push_back({at(wall[t[0]]), at(wall[t[1]]), at(wall[t[2]])});
    }
    return list;
}

} // namespace

double distance(const TileSolid& a, const SolidPlace& place_a, const TileSolid& b, const SolidPlace& place_b, double reach)
{
    const std::vector<Triangle> first = facets(a, place_a), second = facets(b, place_b);
    const auto box_of = [](const Triangle& f) {
        FlatBox box;
        for (const Point& p : f) box.add(Point2(p));
        return box;
    };
    std::vector<FlatBox> boxes;
    for (const Triangle& f : second) boxes.push_back(box_of(f));
    const FlatGrid grid(boxes);
    double least = reach;
    for (const Triangle& f : first)
        grid.for_each(box_of(f).grown(least), [&](std::uint32_t i) {
            const Triangle& g = second[i];
            const double under = std::min({f[0].z, f[1].z, f[2].z}) - std::max({g[0].z, g[1].z, g[2].z});
            const double over = std::min({g[0].z, g[1].z, g[2].z}) - std::max({f[0].z, f[1].z, f[2].z});
            if (std::max(under, over) < least) least = std::min(least, triangle_distance(f, g));
        });
    return least;
}

} // namespace druse
