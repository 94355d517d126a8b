#include "app/registry.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/flat_tiling.h"
#include "dlfl/errors.h"
#include "io/output.h"
#include "ops/shown_lines.h"
#include "ops/smooth_surface.h"
#include "ops/tile.h"
#include "render/png.h"
#include "render/still.h"

namespace druse {

namespace {

Image picture_of(const Scene& scene, const RenderRequest& request, Progress& progress)
{
    const GroupColours colours = [&](int group) { return scene.groups->colour(group); };
    if (request.flat) return flat_tiling(tile_of(scene), request.options);
    if (const ShownLines lines(scene); lines.graph()) return draw_still(*lines.graph(), request.options);
    if (!request.smooth) return draw_still(scene.mesh, colours, request.options);
    try {
        const SmoothSurface surface(scene.mesh, progress);
        return draw_still(surface.mesh(), Division(scene.mesh, surface.old_face(), surface.normals()), colours, request.options);
    } catch (const CommandError& e) {
        throw CommandError(std::string("render: --smooth: ") + e.what());
    }
}

} // namespace

void render(const RenderRequest& request, Progress& progress)
{
    Document document(all_operators());
    const Document::Outcome outcome = open_input(document, request.input, request.format, progress);
    if (outcome.failed) throw CommandError(outcome.failure);
    const Image image = picture_of(document.scene(), request, progress);
    const std::vector<std::uint8_t> png = encode_png(image);
    progress.step(1.0);

    OutputSet output;
    output.open(request.output).put(std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
    output.commit();
    print_notes(outcome.notes);
}

} // namespace druse
