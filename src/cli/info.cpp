#include "app/info.h"

#include "app/registry.h"
#include "cli/commands.h"
#include "cli/console.h"

namespace druse {

void info(const InfoRequest& request, Progress& progress)
{
    Document document(all_operators());
    const Document::Outcome outcome = open_input(document, request.input, request.format, progress);
    print(request.json ? info_json(document.scene(), request.input) + "\n" : info_text(document.scene(), request.input));
    print_notes(outcome.notes);
}

} // namespace druse
