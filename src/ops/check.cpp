// check.*: questions about the mesh. They change nothing and print one JSON object.
#include "dlfl/check.h"
#include "dlfl/measures.h"
#include "ops/registry.h"

#include <nlohmann/json.hpp>

namespace druse {

namespace {

using Json = nlohmann::ordered_json;

struct CheckManifold {
    bool strict = false;
};

void check_manifold(Scene& scene, const CheckManifold& p, Context& context)
{
    const std::string broken = check(scene.mesh);
    const MeshFacts f = facts(scene.mesh);
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

} // namespace

void register_check(Registry& registry)
{
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
