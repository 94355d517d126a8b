#pragma once

#include <atomic>
#include <exception>

namespace druse {

/// Thrown by Progress::step when the person has asked to stop; Document::apply then puts everything back.
struct Cancelled : std::exception {
    const char* what() const noexcept override { return "cancelled"; }
};

/// What a long computation and whoever waits for it tell each other, across threads.
///
/// The worker calls step() at least every 50 ms; the waiting side reads fraction() and may call cancel().
class Progress {
public:
    /// Reports the fraction done (0…1). Throws Cancelled after cancel() was called.
    void step(double fraction)
    {
        fraction_.store(fraction, std::memory_order_relaxed);
        if (cancelled_.load(std::memory_order_relaxed)) throw Cancelled();
    }
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
    double fraction() const { return fraction_.load(std::memory_order_relaxed); }

private:
    std::atomic<double> fraction_{0.0};
    std::atomic<bool> cancelled_{false};
};

} // namespace druse
