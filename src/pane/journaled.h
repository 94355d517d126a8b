#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace druse {

/// A flat array that, while an edit is recorded, remembers what the edit overwrites, block by block of 2^block_bits elements.
///
/// An edit of a pane touches some tens of elements, so they are kept one by one (a Column keeps pages of a thousand, for edits of whole
/// meshes), repeats and all as long as they are few. Going back puts them in place again in the reverse order and cuts off what was
/// added at the end: the bytes are those of before.
template <class T, unsigned block_bits = 0>
class Journaled {
public:
    static constexpr std::uint32_t block_size = 1u << block_bits;

    struct Kept {
        std::uint32_t block;
        std::array<T, block_size> value;
    };

    /// The way from one state to another: what differs before the shorter end, and what lies past it.
    struct Change {
        std::vector<Kept> kept;
        std::vector<T> tail;
        std::uint32_t size = 0; // of the state that is gone back to

        std::size_t bytes() const { return kept.capacity() * sizeof(Kept) + tail.capacity() * sizeof(T); }
    };

    std::size_t bytes() const { return items_.capacity() * sizeof(T) + kept_.capacity() * sizeof(Kept); }
    std::uint32_t size() const { return static_cast<std::uint32_t>(items_.size()); }
    const T& operator[](std::uint32_t i) const { return items_[i]; }
    const T* data() const { return items_.data(); }

    /// Element i for writing, after its block is kept.
    T& change(std::uint32_t i)
    {
        keep(i >> block_bits);
        return items_[i];
    }

    /// Element i for writing; keep() was called for its block since the edit began, or the edit added it.
    T& kept(std::uint32_t i) { return items_[i]; }

    /// All elements for writing, under the same conditions; until add() is called.
    T* writable() { return items_.data(); }

    void keep(std::uint32_t block)
    {
        if (block < minded_) [[unlikely]] remember(block);
    }

    /// Adds one block with this value in all its elements, and returns the first of them.
    std::uint32_t add(const T& value)
    {
        const std::uint32_t first = size();
        if (watching_) watched_.push_back(first >> block_bits);
        for (std::uint32_t i = 0; i < block_size; ++i) items_.push_back(value);
        return first;
    }

    void reserve(std::size_t count) { items_.reserve(count); }

    /// Begins to record, and throws away what the recording before kept.
    void begin()
    {
        kept_.clear();
        known_ = size();
        minded_ = known_ >> block_bits;
    }

    void end() noexcept
    {
        minded_ = 0;
        unwatch();
    }

    /// Within a recording: from now on, says which blocks change, new ones too. Repeats and all.
    void watch()
    {
        watching_ = true;
        minded_ = std::numeric_limits<std::uint32_t>::max();
    }
    bool is_recording() const { return minded_ != 0; }
    bool is_watching() const { return watching_; }
    const std::vector<std::uint32_t>& watched() const { return watched_; }
    void unwatch() noexcept
    {
        if (watching_ && minded_ != 0) minded_ = known_ >> block_bits;
        watching_ = false;
        watched_.clear();
    }

    /// What the last recording kept; once.
    Change take() { return {std::exchange(kept_, {}), {}, known_}; }

    /// Ends the recording, with all as it was when it began.
    void roll_back() noexcept
    {
        for (std::size_t i = kept_.size(); i-- > 0;) std::copy(kept_[i].value.begin(), kept_[i].value.end(), place(kept_[i].block));
        items_.erase(items_.begin() + known_, items_.end());
        kept_.clear();
        end();
    }

    /// Takes the memory that undo(), or else redo(), needs, so that they cannot fail.
    void prepare(Change& change, bool to_undo)
    {
        if (to_undo) change.tail.reserve(items_.size() - change.size);
        else items_.reserve(change.size + change.tail.size());
    }

    /// From the later state of a change to the earlier one; `change` then leads forwards. Precondition: prepare()
    void undo(Change& change) noexcept
    {
        change.tail.assign(items_.begin() + change.size, items_.end());
        items_.erase(items_.begin() + change.size, items_.end());
        for (std::size_t i = change.kept.size(); i-- > 0;) exchange(change.kept[i]);
    }

    /// From the earlier state to the later one. Precondition: prepare()
    void redo(Change& change) noexcept
    {
        for (Kept& kept : change.kept) exchange(kept);
        items_.insert(items_.end(), change.tail.begin(), change.tail.end());
        change.tail = {};
    }

private:
    auto place(std::uint32_t block) { return items_.begin() + (std::size_t(block) << block_bits); }
    void exchange(Kept& kept) { std::swap_ranges(kept.value.begin(), kept.value.end(), place(kept.block)); }

    void remember(std::uint32_t block)
    {
        if (watching_) watched_.push_back(block);
        if (block >= known_ >> block_bits) return;
        if (kept_.size() >= 2 * std::size_t(known_ >> block_bits) + 64) [[unlikely]] forget_repeats();
        Kept& kept = kept_.emplace_back();
        kept.block = block;
        std::copy_n(place(block), block_size, kept.value.begin());
    }

    /// Of a block that was kept again and again, the first value is that of before. So a recording is never more than twice the array.
    void forget_repeats()
    {
        std::vector<bool> met(known_ >> block_bits);
        std::erase_if(kept_, [&](const Kept& kept) {
            const bool repeats = met[kept.block];
            met[kept.block] = true;
            return repeats;
        });
    }

    std::vector<T> items_;
    std::vector<Kept> kept_;
    std::vector<std::uint32_t> watched_;
    std::uint32_t known_ = 0;  // size when the recording began
    std::uint32_t minded_ = 0; // blocks before this are looked at when they change; none where nothing is recorded
    bool watching_ = false;
};

} // namespace druse
