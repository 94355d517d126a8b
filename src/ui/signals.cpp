#include "ui/signals.h"

#include <FL/Fl.H>

#include <array>
#include <cerrno>
#include <csignal>
#include <unistd.h>
#include <utility>

namespace druse::ui {

namespace {

std::array<int, 2> channel{-1, -1};

// All that is allowed in a handler: a byte for the main loop. What was interrupted may yet look at errno.
void pass_on(int)
{
    const int error = errno;
    const char byte = 0;
    [[maybe_unused]] const auto written = write(channel[1], &byte, 1);
    errno = error;
}

} // namespace

EndSignals::EndSignals(std::function<void()> end) : end_(std::move(end))
{
    if (pipe(channel.data()) != 0) return; // then the signals end the program as they always do
    Fl::add_fd(channel[0], FL_READ, [](int fd, void* self) {
        char byte;
        if (read(fd, &byte, 1) == 1) static_cast<EndSignals*>(self)->end_();
    }, this);
    std::signal(SIGTERM, pass_on);
    std::signal(SIGHUP, pass_on);
}

EndSignals::~EndSignals()
{
    if (channel[0] < 0) return;
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
    Fl::remove_fd(channel[0]);
    close(channel[0]);
    close(channel[1]);
    channel = {-1, -1};
}

} // namespace druse::ui
