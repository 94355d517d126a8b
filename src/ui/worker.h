#pragma once

#include "geom/progress.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace druse::ui {

/// A thread that does one thing at a time for a thread that must not wait long.
class Worker {
public:
    using Job = std::function<void(Progress&)>; // keeps to itself whatever it throws

    Worker();
    /// Cancels what is being done and waits for it.
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Precondition: not busy().
    void start(Job job);
    bool busy() const;
    /// Waits until the job is done, no longer than `patience`. @return true if it is done
    bool wait(std::chrono::milliseconds patience);
    void wait();
    /// Calls `wake` on the worker's thread when the job that runs now is done; at once, on this thread, if it is done already.
    void when_done(std::function<void()> wake);

    void cancel();
    double fraction() const;

private:
    void loop();

    mutable std::mutex mutex_;
    std::condition_variable work_, done_;
    Job job_;
    std::function<void()> wake_;
    std::shared_ptr<Progress> progress_;
    bool busy_ = false, quit_ = false;
    std::thread thread_;
};

} // namespace druse::ui
