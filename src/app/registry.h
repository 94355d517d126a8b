#pragma once

#include "ops/registry.h"

namespace druse {

/// Every operator of the program, in menu order. Built once, at the first call.
const Registry& all_operators();

void register_tile_image(Registry& registry); // tile.height_image: it needs a file
void register_document(Registry& registry); // document.open, undo, redo, goto, clear: they need files and history

} // namespace druse
