#include "tile/tile_assembly.h"

#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace druse {

Thinnest assemble(MeshBuilder& builder, const LayeredTile& tile, const TileAssembly& assembly, Progress& progress)
{
    const auto members = stack_members(tile.aspects(), tile.lattice(), tile.design().stack);
    std::map<int, TileSolid> solids; // by member
    Thinnest thinnest{1e300, Point2(0.0)};
    std::size_t faces = 0;
    for (int a = 0; a < tile.type().aspects(); ++a) {
        const int member = members[static_cast<std::size_t>(a)];
        if (!solids.contains(member)) solids.emplace(member, make_solid(tile, assembly.bottom, a, assembly.clearance));
        const TileSolid& solid = solids.at(member);
        if (solid.thinnest.thickness < thinnest.thickness) thinnest = solid.thinnest;
        faces += solid.faces() * std::size_t(assembly.nx) * std::size_t(assembly.ny) * std::size_t(assembly.layers);
    }
    if (faces > most_assembly_faces) throw CommandError(fmt::format("{} faces: an assembly may have {}", faces, most_assembly_faces));

    Point2 centre(0.0);
    for (const OutlinePoint& p : tile.outline().points) centre += p.position / double(tile.outline_count());
    const double spread = assembly.gap / std::sqrt(tile.area());
    const Isometry world = tile.to_world(), step = stack_motion(tile.design().stack);
    const auto [t1, t2] = tile.lattice();
    Point2 middle = 0.5 * (assembly.nx - 1) * t1 + 0.5 * (assembly.ny - 1) * t2; // of the block
    for (int a = 0; a < tile.type().aspects(); ++a) middle += tile.motion({a, {0, 0}})(centre) / double(tile.type().aspects());
    Isometry carried;
    for (int k = 0; k < assembly.layers; ++k, carried = step * carried) {
        progress.step(double(k) / assembly.layers);
        Isometry layer = carried;
        if (layer.x.x * layer.y.y - layer.x.y * layer.y.x < 0) { // a mirror takes the block to its other side: of its layer's tiles, those over the block
            const Point2 back = lattice_coordinates(tile.lattice(), middle - layer(middle));
            layer.shift += std::round(back.x) * t1 + std::round(back.y) * t2;
        }
        for (int j = 0; j < assembly.ny; ++j)
            for (int i = 0; i < assembly.nx; ++i)
                for (int a = 0; a < tile.type().aspects(); ++a) {
                    Isometry place = layer * tile.motion({a, {i, j}});
                    place.shift += spread * place(centre);
                    const int colour = assembly.color == TileColour::layer    ? k
                                       : assembly.color == TileColour::aspect ? a
                                                                              : tile.type().colours.of(a, i, j);
                    add_solid(builder, solids.at(members[static_cast<std::size_t>(a)]), {world * place, k * (tile.thickness() + assembly.gap)},
                              {colour + 1, colour + 1, colour + 1});
                }
    }
    return thinnest;
}

} // namespace druse
