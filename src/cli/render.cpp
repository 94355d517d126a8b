#include "app/registry.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "dlfl/errors.h"
#include "io/output.h"
#include "render/png.h"
#include "render/still.h"

#include <variant>

namespace druse {

void render(const RenderRequest& request, Progress& progress)
{
    Document document(all_operators());
    const Document::Outcome outcome = open_input(document, request.input, request.format, progress);
    if (outcome.failed) throw CommandError(outcome.failure);
    const Scene& scene = document.scene();
    const Graph* graph = std::get_if<Graph>(&*scene.source);
    const Image image = scene.mesh.face_count() == 0 && graph
                            ? draw_still(*graph, request.options)
                            : draw_still(scene.mesh, [&](int group) { return scene.groups->colour(group); }, request.options);
    const std::vector<std::uint8_t> png = encode_png(image);
    progress.step(1.0);

    OutputSet output;
    output.open(request.output).put(std::string_view(reinterpret_cast<const char*>(png.data()), png.size()));
    output.commit();
    print_notes(outcome.notes);
}

} // namespace druse
