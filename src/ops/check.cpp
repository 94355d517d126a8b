// check.*: questions about the mesh. They change nothing and print one JSON object.
#include "dlfl/check.h"
#include "dlfl/measures.h"
#include "dlfl/overhang.h"
#include "dlfl/self_intersections.h"
#include "dlfl/wall_thickness.h"
#include "geom/angle.h"
#include "ops/registry.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace druse {

namespace {

using Json = nlohmann::ordered_json;

struct CheckManifold {
    bool strict = false;
};

void check_manifold(Scene& scene, const CheckManifold& p, Context& context)
{
    const std::string broken = check(scene.mesh);
    const MeshFacts f = facts(scene.mesh, context.progress);
    const bool watertight = f.boundary_edges == 0;
    Json json;
    json["manifold"] = broken.empty();
    if (!broken.empty()) json["broken"] = broken;
    json["oriented"] = broken.empty();
    json["watertight"] = watertight;
    json["boundary_edges"] = f.boundary_edges;
    json["boundary_loops"] = scene.mesh.boundary_count();
    json["components"] = f.components;
    json["euler"] = f.euler;
    json["genus"] = f.genus;
    json["point_spheres"] = f.point_spheres;
    json["parallel_edges"] = f.parallel_edges;
    json["zero_thickness_walls"] = f.zero_thickness_walls;
    context.output = json.dump();
    context.failed = p.strict && !(broken.empty() && watertight);
}

struct CheckPlanarity {
    double tolerance = 1e-9;
    bool strict = false;
};

void check_planarity(Scene& scene, const CheckPlanarity& p, Context& context)
{
    const Mesh& mesh = scene.mesh;
    double mean = 0.0, most = 0.0;
    for (const Edge e : mesh.edges()) mean += length(mesh, e) / mesh.edge_count();
    std::uint32_t warped = 0;
    Face worst;
    for (const Face f : mesh.faces()) {
        if (f.index % 4096 == 0) context.progress.step(double(f.index) / mesh.face_limit());
        const double d = nonplanarity(mesh, f);
        if (d > p.tolerance * mean) ++warped;
        if (d > most) {
            most = d;
            worst = f;
        }
    }
    Json json;
    json["planar"] = warped == 0;
    json["tolerance"] = p.tolerance;
    json["mean_edge"] = mean;
    json["max_nonplanarity"] = most;
    json["warped_faces"] = warped;
    json["worst_face"] = worst.valid() ? Json(worst.index) : Json();
    context.output = json.dump();
    context.failed = p.strict && warped > 0;
}

// --- check.print --------------------------------------------------------------------------------------------------------------

struct CheckPrint {
    double nozzle = 0.4, wall = 0.8, overhang = 45;
    bool strict = false;
};

/// The components that are inside out, counted: they enclose less than nothing, and are no cavity of others.
std::uint32_t count_inside_out(const Mesh& mesh, const RayCast& rays)
{
    const Components components = druse::components(mesh);
    const Point origin = bounds(mesh).center();
    const TriangleList& triangles = rays.triangles();
    const auto part_of = [&](std::uint32_t triangle) { return components.of_face[triangles.face(triangle).index]; };
    std::vector<double> volumes(components.parts.size(), 0.0);
    std::vector<std::uint32_t> first(components.parts.size(), RayCast::none); // triangle of each
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto [a, b, c] = triangles[i];
        volumes[part_of(i)] += glm::dot(a - origin, glm::cross(b - origin, c - origin));
        if (first[part_of(i)] == RayCast::none) first[part_of(i)] = i;
    }
    std::uint32_t count = 0;
    for (std::uint32_t part = 0; part < volumes.size(); ++part) {
        if (volumes[part] >= 0 || components.parts[part].boundary_loops > 0) continue;
        const auto [a, b, c] = triangles[first[part]];
        if (rays.winding((a + b + c) / 3.0, [&](std::uint32_t i) { return part_of(i) != part; }) <= 0) ++count;
    }
    return count;
}

/// How many faces, and which, as a selector that can be given back.
Json faces_json(const std::vector<Face>& faces) { return {{"count", faces.size()}, {"faces", faces.empty() ? "none" : FaceSelector::of(faces).text()}}; }

void check_print(Scene& scene, const CheckPrint& p, Context& context)
{
    constexpr double small = 1, large = 1000; // mm: beyond them, a model was likely made in other units
    const Mesh& mesh = scene.mesh;
    Progress& progress = context.progress;
    const MeshFacts f = facts(mesh, progress);
    const SelfIntersections met = self_intersections(mesh, progress);
    const RayCast rays(mesh, progress, 0.4);
    const std::uint32_t inside_out = count_inside_out(mesh, rays);
    const WallThickness thickness = wall_thickness(mesh, rays, std::max(p.wall, p.nozzle), progress, 0.4);
    std::vector<Face> thin_walls, thin_features;
    for (const Face face : mesh.faces()) {
        if (thickness.under[face.index] < p.wall) thin_walls.push_back(face);
        if (thickness.under[face.index] < p.nozzle) thin_features.push_back(face);
    }
    const Overhang over = overhang(mesh, radians(p.overhang));
    const Vector size = f.bounds.size();
    const double longest = std::max({size.x, size.y, size.z});

    Json problems = Json::array(), warnings = Json::array();
    const auto note = [](Json& list, bool wrong, const char* what) {
        if (wrong) list.push_back(what);
    };
    note(problems, f.counts.faces == 0, "empty");
    note(problems, f.boundary_edges > 0, "open");
    note(problems, inside_out > 0, "inside_out");
    note(problems, met.pairs > 0, "self_intersections");
    note(problems, !thin_walls.empty(), "thin_walls");
    note(problems, !thin_features.empty(), "thin_features");
    note(warnings, !over.faces.empty(), "overhang");
    note(warnings, f.counts.faces > 0 && (longest < small || longest > large), "units");

    Json json;
    json["printable"] = problems.empty();
    json["problems"] = problems;
    json["warnings"] = warnings;
    json["units"] = "mm";
    json["size"] = {size.x, size.y, size.z};
    json["volume"] = f.volume;
    json["components"] = f.components;
    json["watertight"] = f.boundary_edges == 0;
    json["boundary_edges"] = f.boundary_edges;
    json["oriented"] = inside_out == 0;
    json["components_inside_out"] = inside_out;
    json["self_intersections"] = met.pairs;
    json["self_intersecting"] = faces_json(met.faces);
    json["zero_thickness_walls"] = f.zero_thickness_walls;
    json["thinnest_wall"] = thickness.where.valid() ? Json(thickness.thinnest) : Json();
    json["thinnest_face"] = thickness.where.valid() ? Json(thickness.where.index) : Json();
    json["thin_walls"] = faces_json(thin_walls);
    json["thin_features"] = faces_json(thin_features);
    json["overhang"] = faces_json(over.faces);
    json["overhang"]["area"] = over.area;
    json["overhang"]["share"] = f.area > 0 ? over.area / f.area : 0.0;
    context.output = json.dump();
    context.failed = p.strict && !problems.empty();
    if (f.zero_thickness_walls > 0)
        context.note(fmt::format("{} zero-thickness wall{}, which cannot be printed: rind.peel leaves none", f.zero_thickness_walls,
                                 f.zero_thickness_walls == 1 ? "" : "s"));
}

} // namespace

void register_check(Registry& registry)
{
    registry.add(define<CheckPrint>("check.print", "Say whether the model can be printed, and where it cannot")
                     .param(&CheckPrint::nozzle, "nozzle", Unit::length, above(0), "width of what the printer lays: features below it are lost")
                     .param(&CheckPrint::wall, "wall", Unit::length, above(0), "thickness below which a wall is thin")
                     .param(&CheckPrint::overhang, "overhang", Unit::degrees, {0, 90}, "angle from upright that faces may lean out by without support, a warning")
                     .param(&CheckPrint::strict, "strict", "fail where something cannot be printed; warnings do not count")
                     .example("check.print wall=1.2 strict=true")
                     .cites("Möller & Trumbore 1997; Guigue & Devillers 2003; Shewchuk 1997")
                     .keeps_euler()
                     .query()
                     .run(check_print));
    registry.add(define<CheckManifold>("check.manifold", "Say whether the surface is a closed oriented 2-manifold, and of which kind")
                     .param(&CheckManifold::strict, "strict", "fail where it is not")
                     .example("check.manifold strict=true")
                     .cites("Akleman & Chen 1999")
                     .keeps_euler()
                     .query()
                     .run(check_manifold));
    registry.add(define<CheckPlanarity>("check.planarity", "Say how far the corners of faces lie from the faces' planes")
                     .param(&CheckPlanarity::tolerance, "tolerance", Unit::ratio, at_least(0), "largest distance that counts as flat, in mean edge lengths")
                     .param(&CheckPlanarity::strict, "strict", "fail where a face is warped")
                     .example("check.planarity tolerance=1e-6")
                     .cites("Sutherland, Sproull & Schumacker 1974")
                     .keeps_euler()
                     .query()
                     .run(check_planarity));
}

} // namespace druse
