#include "cell/cell_check.h"

#include "cell/freedom.h"
#include "dlfl/measures.h"
#include "dlfl/self_intersections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace druse {

namespace {

constexpr double close = 1e-9; // of the volume

Mesh mesh_of(const CellTile& tile, const CellSolid& solid)
{
    MeshBuilder builder;
    add_solid(builder, solid, pane_groups(tile));
    return builder.build();
}

/// The cell that has a pane of this one too.
LatticeStep across(const CellTile& tile, const CellSolid::Side& side)
{
    const LatticeStep there = tile.cell().panes[static_cast<std::size_t>(side.pane)].translation;
    return side.far ? -there : there;
}

/// Each near pane is followed by its far one.
double pane_mismatch(const CellTile& tile, const CellSolid& solid)
{
    double most = 0;
    std::size_t begin = 0;
    for (int p = 0; p < tile.pane_count(); ++p) {
        const std::size_t count = tile.mesh(p).triangles.size();
        const Vector translation = tile.world(tile.cell().at(tile.cell().panes[static_cast<std::size_t>(p)].translation));
        for (std::size_t i = begin; i < begin + count; ++i) {
            const auto &near = solid.triangles[i], &far = solid.triangles[i + count];
            for (std::size_t k = 0; k < 3; ++k)
                most = std::max(most, glm::length(solid.points[near[k]] - solid.points[far[(3 - k) % 3]] - translation));
        }
        begin += 2 * count;
    }
    return most;
}

bool falls_short(const CellTile& tile, double width, double asked) { return !(width >= asked - 1e-6 * tile.size()); }

std::string joints_text(double width, double asked) { return fmt::format("joints are {:.6g} wide at the narrowest, not {:.6g}", width, asked); }

} // namespace

CellCheck check(const CellTile& tile, const CellCheckRequest& request, Progress& progress)
{
    CellCheck found;
    const auto require = [&](bool holds, const std::string& what) {
        if (!holds) found.faults.push_back(what);
    };
    const CellSolid solid = make_solid(tile);
    const Mesh mesh = mesh_of(tile, solid);
    Box box;
    for (const Point& p : solid.points) box.add(p);
    const double size = std::max(box.diagonal(), tile.size());
    found.volume = volume(solid);
    found.volume_expected = tile.volume();
    require(std::abs(found.volume - found.volume_expected) <= close * std::max(found.volume_expected, 1e-3 * size * size * size), "the volume is not that of a cell of the lattice");
    found.pane_mismatch = pane_mismatch(tile, solid);
    require(found.pane_mismatch <= 1e-12 * size, "two panes of a pair are not alike");
    const Counts counts = mesh.counts();
    found.vertices = static_cast<std::uint32_t>(counts.vertices);
    found.edges = static_cast<std::uint32_t>(counts.edges);
    found.faces = static_cast<std::uint32_t>(counts.faces);
    found.components = static_cast<std::uint32_t>(components(mesh).parts.size());
    found.genus = genus(mesh);
    require(found.components == 1 && found.genus == 0, "the solid is no ball");

    const SelfIntersections met = self_intersections(mesh, progress);
    found.self_intersections = met.pairs;
    std::map<CellSolid::Side, std::uint32_t> sides;
    for (const Face f : met.faces) ++sides[solid.sides[f.index]];
    for (const auto& [side, triangles] : sides) {
        const LatticeStep step = across(tile, side);
        found.pierced.push_back({side, step, triangles});
        const Vector by = tile.world(tile.cell().at(step));
        found.faults.push_back(fmt::format("pierced: pane {} of the neighbour at {:.6g},{:.6g},{:.6g} is met, in {} triangle{}", side.pane, by.x, by.y, by.z, triangles, triangles == 1 ? "" : "s"));
    }
    if (request.directions && met.pairs == 0) found.free = free_directions(tile, solid, progress);

    if (request.clearance > 0) {
        found.has_clearance = true;
        CellSolid thin;
        try {
            thin = make_solid(tile, request.clearance, request.joint);
        } catch (const CellRefusal& refusal) {
            found.vanishes = true;
            found.faults.emplace_back(refusal.what());
            return found;
        }
        found.volume_left = volume(thin);
        found.clearance = least_distance(tile, thin, 2 * request.clearance, progress);
        require(!falls_short(tile, found.clearance, request.clearance), joints_text(found.clearance, request.clearance));
        require(self_intersections(mesh_of(tile, thin), progress, 1).pairs == 0, "the clearance makes the solid meet itself");
    }
    return found;
}

std::optional<std::string> narrow_joints(const CellTile& tile, const CellSolid& solid, double clearance, Progress& progress)
{
    const double width = least_distance(tile, solid, clearance, progress);
    return falls_short(tile, width, clearance) ? std::optional(joints_text(width, clearance)) : std::nullopt;
}

} // namespace druse
