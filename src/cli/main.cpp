#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "dlfl/errors.h"
#include "geom/predicates.h"
#include "geom/progress.h"

#include <csignal>
#include <variant>

#include <fcntl.h>
#include <unistd.h>

namespace {

druse::Progress progress;

/// The first Ctrl+C asks the run to stop, so that nothing half made is left; a second one ends the program.
void stop(int) { progress.cancel(); }

void listen_for_interrupts()
{
    struct sigaction action {};
    action.sa_handler = stop;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN); // a reader that goes away is an error of writing, and temporary files are taken away
}

/// Puts something unwritable where a standard stream is closed: else a file of ours would get its number, and what is said its bytes.
void fill_closed_streams()
{
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDONLY); // takes the lowest number that is free: this one
}

struct Perform {
    int operator()(const druse::WindowRequest& request) const { return druse::window(request); }
    int operator()(const druse::PrintRequest& request) const
    {
        druse::print(request.text);
        return 0;
    }
    int operator()(const druse::OpsRequest& request) const
    {
        druse::ops(request);
        return 0;
    }
    int operator()(const druse::ApplyRequest& request) const
    {
        listen_for_interrupts();
        druse::apply(request, progress);
        return 0;
    }
    int operator()(const druse::InfoRequest& request) const
    {
        listen_for_interrupts();
        druse::info(request, progress);
        return 0;
    }
    int operator()(const druse::RenderRequest& request) const
    {
        listen_for_interrupts();
        druse::render(request, progress);
        return 0;
    }
};

} // namespace

int main(int argc, char** argv)
{
    fill_closed_streams();
    try {
        ASSERT(druse::predicates_are_exact(), "the predicates give the signs that are known");
        return std::visit(Perform(), druse::parse_arguments(argc, argv));
    } catch (...) {
        return druse::report_exception();
    }
}
