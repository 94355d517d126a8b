#pragma once

#include <cstdint>
#include <utility>

namespace druse {

/// The largest group id of the faces of a mesh, and how many faces have it, so that a command on a large mesh need not ask all of them.
///
/// Known while faces change one by one; forgotten where groups are written in bulk, or the last face of the largest group goes.
/// The changes of a mesh take it along: going back and forth costs nothing.
class LargestGroup {
public:
    struct State {
        std::int32_t group = 0; // 0: no face is grouped; negative: not known
        std::uint32_t faces = 0; // in it, unless it is 0
    };

    LargestGroup() = default;
    // A mesh that takes the place of another inside a recording leaves what the recording began with.
    LargestGroup(const LargestGroup& other) : now_(other.now_) {}
    LargestGroup(LargestGroup&& other) noexcept : now_(std::exchange(other.now_, {})) {}
    LargestGroup& operator=(const LargestGroup& other)
    {
        now_ = other.now_;
        return *this;
    }
    LargestGroup& operator=(LargestGroup&& other) noexcept
    {
        now_ = std::exchange(other.now_, {});
        return *this;
    }

    bool is_known() const { return now_.group >= 0; }
    std::int32_t value() const { return now_.group; } // precondition: it is known
    const State& state() const { return now_; }

    void set(const State& state) { now_ = state; }
    void forget() { now_.group = -1; }
    void add(std::int32_t group, std::uint32_t faces = 1)
    {
        if (!is_known() || group < now_.group || group == 0) return;
        if (group == now_.group) now_.faces += faces;
        else now_ = {group, faces};
    }
    void remove(std::int32_t group)
    {
        if (is_known() && group == now_.group && group > 0 && --now_.faces == 0) forget();
    }
    void replace(std::int32_t group, std::int32_t by)
    {
        add(by); // first, so that a larger group needs no memory of the smaller
        remove(group);
    }

    void begin_change() { before_ = now_; }
    State end_change() const { return before_; }
    void exchange(State& state) { std::swap(now_, state); }
    void roll_back() { now_ = before_; }

private:
    State now_, before_;
};

} // namespace druse
