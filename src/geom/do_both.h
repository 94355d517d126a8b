#pragma once

#include <exception>
#include <system_error>
#include <thread>

namespace druse {

/// Does two things that do not touch what the other one writes: side by side where `apart` says that they are worth a thread and the
/// machine has one, else one after the other. What they make is the same either way.
///
/// Both are done when this returns. If one throws, the other one still ends first; if both do, what `first` threw goes on.
template <class First, class Second>
void do_both(bool apart, First&& first, Second&& second)
{
    std::exception_ptr failure;
    std::jthread beside; // joins wherever this is left
    if (apart && std::thread::hardware_concurrency() > 1) {
        try {
            beside = std::jthread([&] {
                try {
                    second();
                } catch (...) {
                    failure = std::current_exception();
                }
            });
        } catch (const std::system_error&) { // no thread to be had
        }
    }
    const bool alone = !beside.joinable();
    first();
    if (alone) return second();
    beside.join();
    if (failure) std::rethrow_exception(failure);
}

} // namespace druse
