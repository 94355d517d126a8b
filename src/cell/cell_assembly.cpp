#include "cell/cell_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace druse {

std::vector<LatticeStep> cells_around(const Parallelohedron& cell, int shells)
{
    std::vector<LatticeStep> list{{}};
    std::set<LatticeStep> known{{}};
    std::size_t from = 0;
    for (int shell = 0; shell < shells; ++shell) {
        std::set<LatticeStep> next;
        for (const std::size_t end = list.size(); from < end; ++from)
            for (const CellPane& pane : cell.panes)
                for (const LatticeStep& step : {list[from] + pane.translation, list[from] - pane.translation})
                    if (!known.contains(step)) next.insert(step);
        list.insert(list.end(), next.begin(), next.end());
        known.merge(next);
    }
    return list;
}

int LatticeColours::of(const LatticeStep& step) const
{
    const int sum = (weights[0] * (step.i % count) + weights[1] * (step.j % count) + weights[2] * (step.k % count)) % count;
    return sum < 0 ? sum + count : sum;
}

LatticeColours colour_cells(const Parallelohedron& cell)
{
    LatticeColours colours;
    for (colours.count = 2; colours.count <= 8; ++colours.count)
        for (int a = 0; a < colours.count; ++a)
            for (int b = 0; b < colours.count; ++b)
                for (int c = 0; c < colours.count; ++c) {
                    colours.weights = {a, b, c};
                    if (std::ranges::none_of(cell.panes, [&](const CellPane& pane) { return colours.of(pane.translation) == 0; })) return colours;
                }
    ASSERT(false, "a colouring of a lattice with eight colours at most");
    return colours;
}

void assemble(MeshBuilder& builder, const CellTile& tile, const CellAssembly& assembly, Progress& progress)
{
    const CellSolid solid = make_solid(tile, assembly.clearance, assembly.joint);
    const std::vector<LatticeStep> steps = cells_around(tile.cell(), assembly.shells);
    if (steps.size() * solid.triangles.size() > most_cell_faces)
        throw CommandError(fmt::format("{} faces: an assembly may have {}", steps.size() * solid.triangles.size(), most_cell_faces));
    const LatticeColours colours = colour_cells(tile.cell());
    std::vector<double> heights; // of layers
    for (const LatticeStep& step : steps) heights.push_back(tile.world(tile.cell().at(step)).z);
    const std::vector<double> of_steps = heights;
    std::ranges::sort(heights);
    const double same = 1e-9 * (heights.back() - heights.front());
    heights.erase(std::unique(heights.begin(), heights.end(), [same](double a, double b) { return b - a <= same; }), heights.end());
    const Point about = centre_of_mass(solid);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        progress.step(double(i) / double(steps.size()));
        int colour = 0;
        if (assembly.color == CellColour::type) colour = colours.of(steps[i]);
        if (assembly.color == CellColour::layer) colour = static_cast<int>(std::ranges::upper_bound(heights, of_steps[i]) - heights.begin()) - 1;
        add_solid(builder, solid, std::array{colour + 1}, tile.world(tile.cell().at(steps[i])), assembly.shrink, about);
    }
}

} // namespace druse
