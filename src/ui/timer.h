#pragma once

#include <FL/Fl.H>

#include <functional>
#include <utility>

namespace druse::ui {

/// Calls a function some time later, on the main loop; never after the timer itself is gone.
class Timer {
public:
    explicit Timer(std::function<void()> run) : run_(std::move(run)) {}
    ~Timer() { stop(); }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

    /// Once, after so many seconds from now; an earlier start is forgotten.
    void start(double seconds)
    {
        stop();
        Fl::add_timeout(seconds, fire, this);
    }
    void stop() { Fl::remove_timeout(fire, this); }
    bool is_running() const { return Fl::has_timeout(fire, const_cast<Timer*>(this)) != 0; }

private:
    static void fire(void* timer) { static_cast<Timer*>(timer)->run_(); }
    std::function<void()> run_;
};

} // namespace druse::ui
