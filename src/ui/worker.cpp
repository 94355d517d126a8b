#include "ui/worker.h"

#include "dlfl/errors.h"

#include <utility>

namespace druse::ui {

Worker::Worker() : progress_(std::make_shared<Progress>()), thread_([this] { loop(); }) {}

Worker::~Worker()
{
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
        progress_->cancel();
    }
    work_.notify_all();
    thread_.join();
}

void Worker::start(Job job)
{
    {
        const std::lock_guard lock(mutex_);
        ASSERT(!busy_, "one job at a time");
        job_ = std::move(job);
        progress_ = std::make_shared<Progress>();
        busy_ = true;
    }
    work_.notify_all();
}

bool Worker::busy() const
{
    const std::lock_guard lock(mutex_);
    return busy_;
}

bool Worker::wait(std::chrono::milliseconds patience)
{
    std::unique_lock lock(mutex_);
    return done_.wait_for(lock, patience, [this] { return !busy_; });
}

void Worker::wait()
{
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return !busy_; });
}

void Worker::when_done(std::function<void()> wake)
{
    {
        const std::lock_guard lock(mutex_);
        if (busy_) {
            wake_ = std::move(wake);
            return;
        }
    }
    wake();
}

void Worker::cancel()
{
    const std::lock_guard lock(mutex_);
    progress_->cancel();
}

double Worker::fraction() const
{
    const std::lock_guard lock(mutex_);
    return progress_->fraction();
}

void Worker::loop()
{
    std::unique_lock lock(mutex_);
    while (true) {
        work_.wait(lock, [this] { return quit_ || job_; });
        if (!job_) return;
        const Job job = std::exchange(job_, nullptr);
        const std::shared_ptr<Progress> progress = progress_;
        if (quit_) progress->cancel();
        lock.unlock();
        job(*progress);
        lock.lock();
        busy_ = false;
        const std::function<void()> wake = std::exchange(wake_, nullptr);
        done_.notify_all();
        if (wake && !quit_) {
            lock.unlock();
            wake();
            lock.lock();
        }
    }
}

} // namespace druse::ui
