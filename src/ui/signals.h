#pragma once

#include <functional>

namespace druse::ui {

/// Calls a function on the main loop when the system asks the program to end (SIGTERM, SIGHUP). Only one at a time.
class EndSignals {
public:
    explicit EndSignals(std::function<void()> end);
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

private:
    std::function<void()> end_;
};

} // namespace druse::ui
