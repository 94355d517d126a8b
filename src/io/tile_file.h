#pragma once

#include "geom/colour.h"
#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"
#include "tile/layered_tile.h"

#include <filesystem>
#include <vector>

namespace druse {

/// Reads a layered tile as Druse writes it: JSON, `"format": "druse-tile"`. Keys that it does not know are kept for the writer.
/// @throws InputError with line and path of the key, as `paths[1].points[0]`, where something is not what it should be; a higher version than ours too
Model read_tile(ByteSource& source);

/// Is it a file of a cell? Not where it cannot be read, or is none of Druse's.
bool is_cell_file(const std::filesystem::path& file);

/// Writes the tile of a model, a line for each key; numbers are the shortest that read back as the same. @throws InputError if there is none
void write_tile(const ModelView& model, OutputFiles& out);

/// The copies that drawings of the flat tiling show, in their order.
std::vector<TileCopy> drawn_copies(const LayeredTile& tile);

/// The flat tiling as pictures show it: each copy with the way that it takes to its place in the world, its colour, and the box of all outlines.
struct DrawnTiling {
    struct Copy {
        Isometry motion;
        Colour colour;
    };
    std::vector<Copy> copies; // as drawn_copies()
    FlatBox box;
};
DrawnTiling drawn_tiling(const LayeredTile& tile);

/// Draws the flat tiling of the tile of a model: as many places of its lattice as its design says, in the colours of its type, in millimetres.
/// @throws InputError if there is no tile
void write_svg(const ModelView& model, OutputFiles& out);

/// Draws the same tiling as lines for a cutter: DXF, Release 12, in millimetres. Outlines are on layer CUT, each piece once though two tiles have it; segments are
/// on layer ENGRAVE. @throws InputError if there is no tile
void write_dxf(const ModelView& model, OutputFiles& out);

/// @throws InputError: drawings are for others to read
Model read_dxf(ByteSource& source);
Model read_svg(ByteSource& source);

} // namespace druse
