#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"

#include <map>
#include <span>
#include <vector>

namespace druse {

/// Newell's area vector of a polygon: square to it, counter-clockwise outward, twice its area long. Exact for a warped polygon
/// as the area-weighted mean. Source: Newell's method, in Sutherland, Sproull & Schumacker (1974).
Vector area_vector(const Mesh& mesh, Face f); // length = area
Vector unit_normal(const Mesh& mesh, Face f); // zero where the face has no area
Point vertex_mean(const Mesh& mesh, Face f);  // mean of the corners
double area(const Mesh& mesh, Face f);        // |area_vector|
double length(const Mesh& mesh, Edge e);
/// How far the corners of a face lie from its plane (Newell normal through the vertex mean): the largest distance, in model units.
double nonplanarity(const Mesh& mesh, Face f);

/// Signed volume inside the faces, each fanned from its vertex mean; positive if they look outward. An open boundary is closed
/// the same way.
double volume(const Mesh& mesh);
double surface_area(const Mesh& mesh);
Box bounds(const Mesh& mesh);

/// The components of a mesh, numbered by their lowest face.
struct Components {
    std::vector<std::uint32_t> of_face; // by face index; Handle::none in holes
    struct Part {
        std::int64_t euler = 0; // V − E + F without boundary faces
        std::uint32_t faces = 0, boundary_loops = 0;
        double genus() const { return (2.0 - double(euler) - boundary_loops) / 2.0; }
    };
    std::vector<Part> parts;
};
Components components(const Mesh& mesh);

/// Sum of the genera of the components; an open boundary counts as closed.
std::int64_t genus(const Mesh& mesh);
/// V − E + F, boundary faces left out.
std::int64_t euler_characteristic(const Mesh& mesh);
std::uint32_t boundary_edge_count(const Mesh& mesh);

/// The facts of a mesh that `druse info` prints.
struct MeshFacts {
    Counts counts;
    std::uint32_t corners = 0, components = 0, boundary_edges = 0, point_spheres = 0;
    std::uint32_t parallel_edges = 0;       // beside another one with the same two ends
    std::uint32_t zero_thickness_walls = 0; // pairs of faces upon each other: the same three vertices or more, in opposite rotation
    std::int64_t euler = 0, genus = 0;
    std::vector<std::int64_t> component_genus;
    double volume = 0, area = 0, max_nonplanarity = 0;
    Box bounds;
    double shortest_edge = 0, mean_edge = 0, longest_edge = 0;
    std::map<int, std::uint32_t> sides, valences; // how many faces with so many sides, vertices with so many edges
    std::map<int, std::uint32_t> groups;          // faces in each group, group 0 included if it has any
};
MeshFacts facts(const Mesh& mesh);
/// The same, for whoever may lose interest. It hears of a cancellation within a few milliseconds, whatever the mesh's size.
/// @throws Cancelled
MeshFacts facts(const Mesh& mesh, Progress& progress);

} // namespace druse
