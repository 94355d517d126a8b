#include "app/info.h"

#include "app/registry.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "dlfl/errors.h"

namespace druse {

void info(const InfoRequest& request, Progress& progress)
{
    Document document(all_operators());
    const Document::Outcome outcome = open_input(document, request.input, request.format, progress);
    if (outcome.failed) throw CommandError(outcome.failure);
    const Scene& scene = document.scene();
    std::optional<SelfIntersections> met;
    if (request.check) met = self_intersections(scene, progress);
    print(request.json ? info_json(scene, request.input, met) + "\n" : info_text(scene, request.input, met));
    print_notes(outcome.notes);
}

} // namespace druse
