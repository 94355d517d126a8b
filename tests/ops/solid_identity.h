#pragma once

#include "dlfl/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace druse::test {

/// What tells a convex solid with regular faces from all others, found by index lists and positions alone: how many vertices have which
/// faces around them, and how far the solid is from having equal edges, flat faces and convex corners (in mean edge lengths).
/// Two such solids with the same vertex configurations are the same, but for the rhombicuboctahedron and its twisted twin.
/// Source: Johnson, Convex polyhedra with regular faces (1966).
struct Identity {
    std::map<std::string, int> vertices; // by configuration, as 3.4.3.4: of all ways round the one that is least
    double edge_spread = 0, out_of_plane = 0;
    double least_depth = 0; // of any vertex under the plane of any face that it is not a corner of; > 0: convex
    bool centrally_symmetric = false;
};

inline std::string configuration(std::vector<int> sides)
{
    std::vector<int> best = sides;
    for (int mirrored = 0; mirrored < 2; ++mirrored, std::ranges::reverse(sides))
        for (std::size_t i = 0; i < sides.size(); ++i) {
            std::rotate(sides.begin(), sides.begin() + 1, sides.end());
            best = std::min(best, sides);
        }
    std::string text;
    for (const int n : best) {
        if (!text.empty()) text += '.';
        text += std::to_string(n);
    }
    return text;
}

inline Identity identify(const Mesh& mesh)
{
    // From here on there are only lists of points and of polygons.
    std::vector<Point> points;
    std::vector<std::vector<std::uint32_t>> polygons;
    for (const Vertex v : mesh.vertices()) points.push_back(mesh.position(v));
    for (const Face f : mesh.faces()) {
        polygons.emplace_back();
        for (const Corner c : mesh.corners(f)) polygons.back().push_back(mesh.vertex(c).index);
    }

    Identity id;
    double shortest = 1e300, longest = 0, total = 0;
    std::size_t sides = 0;
    std::vector<std::map<std::uint32_t, std::pair<std::uint32_t, int>>> around(points.size()); // neighbour -> the next one round, and the face between
    Point middle(0.0);
    for (const Point& p : points) middle += p / double(points.size());
    for (const auto& ring : polygons)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t before = ring[(i + ring.size() - 1) % ring.size()], here = ring[i], after = ring[(i + 1) % ring.size()];
            around[here][after] = {before, int(ring.size())};
            const double length = glm::distance(points[here], points[after]);
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
            total += length;
            ++sides;
        }
    const double edge = total / double(sides);
    id.edge_spread = (longest - shortest) / edge;
    for (const auto& next : around) {
        std::vector<int> faces;
        std::uint32_t at = next.empty() ? 0 : next.begin()->first;
        for (std::size_t i = 0; i < next.size(); ++i) {
            const auto found = next.find(at);
            if (found == next.end()) break;
            faces.push_back(found->second.second);
            at = found->second.first;
        }
        ++id.vertices[configuration(faces)];
    }
    id.least_depth = 1e300;
    for (const auto& ring : polygons) {
        Point center(0.0);
        for (const std::uint32_t v : ring) center += points[v] / double(ring.size());
        Vector normal(0.0);
        for (std::size_t i = 0; i < ring.size(); ++i) normal += glm::cross(points[ring[i]] - center, points[ring[(i + 1) % ring.size()]] - center);
        normal = glm::normalize(normal);
        for (std::uint32_t v = 0; v < points.size(); ++v) {
            const double height = glm::dot(points[v] - center, normal) / edge;
            if (std::ranges::find(ring, v) != ring.end()) id.out_of_plane = std::max(id.out_of_plane, std::abs(height));
            else id.least_depth = std::min(id.least_depth, -height);
        }
    }
    id.centrally_symmetric = std::ranges::all_of(points, [&](const Point& p) {
        return std::ranges::any_of(points, [&](const Point& q) { return glm::length(p + q - 2.0 * middle) < 1e-9 * edge; });
    });
    return id;
}

} // namespace druse::test
