#include "cli/commands.h"

#ifdef DRUSE_HAS_WINDOW
#include "ui/run_window.h"
#else
#include "dlfl/errors.h"
#endif

namespace druse {

int window([[maybe_unused]] const WindowRequest& request)
{
#ifdef DRUSE_HAS_WINDOW
    return run_window({request.file, request.test, request.geometry, request.event_log, request.record, request.replay, request.ui_scale});
#else
    throw SystemError("this program was built without its window; `druse --help` lists what it does in a terminal");
#endif
}

} // namespace druse
