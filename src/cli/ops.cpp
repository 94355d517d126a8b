#include "app/reference.h"
#include "app/registry.h"
#include "cli/commands.h"
#include "cli/console.h"

namespace druse {

namespace {

template <class What>
std::string reference(const What& what, OpsRequest::Form form)
{
    switch (form) {
    case OpsRequest::Form::json: return reference_json(what);
    case OpsRequest::Form::markdown: return reference_markdown(what);
    case OpsRequest::Form::text: break;
    }
    return reference_text(what);
}

} // namespace

void ops(const OpsRequest& request)
{
    const Registry& registry = all_operators();
    print(request.name.empty() ? reference(registry, request.form) : reference(registry.get(request.name), request.form));
}

} // namespace druse
