#pragma once

#include "render/draw_lists.h"
#include "render/image.h"
#include "render/renderer.h"

#include <optional>

namespace druse {

/// What `druse render` can be asked for; the defaults are its own.
struct StillOptions {
    int width = 1280, height = 800; // pixels
    ViewAngles view{45.0, 35.264389682754654};
    bool parallel = false;
    Style::Shading shading = Style::Shading::flat;
    bool edges = false;
    bool groups = false;              // colours of groups; else all faces are of the colour of group 0
    bool transparent = false;         // no background
    std::optional<Colour> background; // one colour in place of the gradient
    int samples = 4;                  // per pixel; one in pictures of more than 32 million pixels
};

/// A picture of the mesh, framed; drawn off screen, on a thread of its own, and the same to the byte whenever it is repeated.
/// @throws SystemError if OSMesa is missing
Image draw_still(const Mesh& mesh, const GroupColours& colours, const StillOptions& options);

/// The same of a mesh that shows another one smooth.
Image draw_still(const Mesh& mesh, const Division& division, const GroupColours& colours, const StillOptions& options);

/// The same of a graph: its edges as lines.
Image draw_still(const Graph& graph, const StillOptions& options);

} // namespace druse
