#include "app/save.h"

#include "app/script.h"

#include <variant>

namespace druse {

void write_document(const Document& document, OutputSet& output, const std::filesystem::path& target, const WriteOptions& options)
{
    if (options.format.empty() ? is_script(target) : is_script_format(options.format)) {
        output.open(target).put(document.script(target.parent_path()));
        return;
    }
    const Scene& scene = document.scene();
    output.write({scene.mesh, *scene.groups, std::get_if<Graph>(&*scene.source), &scene.rind, std::get_if<Pane>(&*scene.source), std::get_if<LayeredTile>(&*scene.source),
                  std::get_if<CellTile>(&*scene.source)}, target, options);
}

} // namespace druse
