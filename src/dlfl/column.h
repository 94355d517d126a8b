#pragma once

#include "dlfl/storage.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace druse {

/// What one command changed in one column: the other state's pages where they differ, and its end where it was longer; or the
/// other state's whole block, where the command put a new one in its place.
template <class T>
struct ColumnChange {
    bool whole = false;
    Storage block;                    // whole: the other state
    std::uint32_t size = 0;           // of the other state
    std::uint32_t common = 0;         // indices below this are in `pages` if they differ
    std::vector<std::uint32_t> pages; // page numbers
    std::vector<T> contents;          // page after page, each full but perhaps the last
    std::vector<T> tail;              // elements common … size of the other state

    /// Memory held, in bytes.
    std::size_t bytes() const
    {
        return block.capacity() + pages.capacity() * sizeof(std::uint32_t) + (contents.capacity() + tail.capacity()) * sizeof(T);
    }
};

/// One property of all elements of one kind, in contiguous memory.
///
/// While a change is being recorded, the first write to a page of `page_size` elements keeps a copy of it. Going back and forth
/// between two states then costs what the command touched, not what the mesh holds; reads cost nothing extra, ever.
template <class T>
class Column {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    static constexpr std::uint32_t page_bits = 10;
    static constexpr std::uint32_t page_size = 1u << page_bits;

    Column() = default;
    Column(Column&& other) noexcept { take(other); }
    /// Inside a recording an assignment is a change like any other.
    Column& operator=(Column&& other) noexcept
    {
        if (this == &other) return *this;
        if (recording_) replace(std::move(other));
        else take(other);
        return *this;
    }
    Column(const Column& other) { assign(other); }
    Column& operator=(const Column& other)
    {
        if (this != &other) assign(other);
        return *this;
    }

    std::uint32_t size() const { return size_; }
    const T& operator[](std::uint32_t i) const { return data()[i]; }
    std::span<const T> view() const { return {data(), size_}; }

    void set(std::uint32_t i, const T& value)
    {
        if (recording_) keep(i >> page_bits);
        data()[i] = value;
    }

    /// Elements first … first + count − 1 for writing in bulk; their pages are kept first. Valid until the column grows.
    T* write(std::uint32_t first, std::uint32_t count)
    {
        if (recording_ && count > 0)
            for (std::uint32_t page = first >> page_bits; page <= (first + count - 1) >> page_bits; ++page) keep(page);
        return data() + first;
    }

    void push_back(T value) // a copy: it may come from this column, which may move
    {
        if (size_ == limit_) grow(std::uint64_t(size_) + 1);
        data()[size_++] = value;
    }

    void reserve(std::uint32_t count)
    {
        block_.reserve(std::size_t(count) * sizeof(T));
        measure();
    }

    /// Memory past the end for `count` more elements; extend() takes them over as they were written.
    T* room(std::uint32_t count)
    {
        if (count > limit_ - size_) grow(std::uint64_t(size_) + count);
        return data() + size_;
    }

    /// Adds `count` elements with the values written to room(), or else not set yet, and returns the first of them.
    T* extend(std::uint32_t count)
    {
        T* first = room(count);
        size_ += count;
        return first;
    }

    /// Precondition: count ≤ size().
    void truncate(std::uint32_t count)
    {
        if (recording_ && count < known_)
            for (std::uint32_t page = count >> page_bits; page < kept_.size(); ++page) keep(page);
        size_ = count;
    }

    void begin_change()
    {
        kept_.assign((std::size_t(size_) + page_size - 1) >> page_bits, false);
        change_ = {};
        change_.size = known_ = size_;
        recording_ = true;
    }

    bool is_recording() const { return recording_; }

    /// Ends the recording; the result holds what the column was at begin_change().
    ColumnChange<T> end_change()
    {
        if (!change_.whole) {
            change_.common = std::min(known_, size_);
            if (size_ < known_) cut_tail();
        }
        recording_ = false;
        kept_.clear();
        return std::exchange(change_, {});
    }

    /// Ends the recording and puts back what the column was at begin_change(). Needs no memory, so it works when there is none left.
    void roll_back() noexcept
    {
        put_back();
        recording_ = false;
        kept_.clear();
        change_ = {};
    }

    /// Changes places with the other state; `change` then holds this one.
    void exchange(ColumnChange<T>& change)
    {
        if (change.whole) {
            std::swap(block_, change.block);
            std::swap(size_, change.size);
            measure();
            return;
        }
        std::vector<T> tail(data() + std::min(change.common, size_), data() + size_);
        std::size_t at = 0;
        for (const std::uint32_t page : change.pages) {
            const std::uint32_t first = page << page_bits;
            const std::uint32_t count = std::min(page_size, change.common - first);
            std::swap_ranges(data() + first, data() + first + count, change.contents.data() + at);
            at += count;
        }
        const std::uint32_t before = size_;
        if (change.size > limit_) grow(change.size);
        size_ = change.size;
        std::copy(change.tail.begin(), change.tail.end(), data() + change.common);
        change.tail = std::move(tail);
        change.size = before;
    }

    /// Puts the elements of `other` in place of all; inside a recording the old block is kept as it was at its beginning.
    void replace(Column&& other) noexcept
    {
        if (recording_ && !change_.whole) {
            put_back();
            change_ = {};
            change_.whole = true;
            change_.block = std::move(block_);
            change_.size = known_;
            kept_.clear();
        }
        block_ = std::move(other.block_);
        size_ = std::exchange(other.size_, 0);
        measure();
        other.measure();
    }

    bool changed_whole() const { return change_.whole; }
    std::size_t bytes() const { return block_.capacity(); }

private:
    T* data() { return reinterpret_cast<T*>(block_.data()); }
    const T* data() const { return reinterpret_cast<const T*>(block_.data()); }
    static constexpr std::uint64_t most = 0xfffffffe; // indices stay below Handle::none
    void measure() { limit_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(block_.capacity() / sizeof(T), most)); }

    void grow(std::uint64_t least)
    {
        if (least > most) throw std::bad_alloc();
        const std::uint64_t more = std::uint64_t(size_) + size_ / 2 + 16;
        reserve(static_cast<std::uint32_t>(std::min(std::max(least, more), most)));
    }

    void take(Column& other)
    {
        block_ = std::move(other.block_);
        size_ = std::exchange(other.size_, 0);
        limit_ = std::exchange(other.limit_, 0);
        known_ = other.known_;
        recording_ = std::exchange(other.recording_, false);
        kept_ = std::move(other.kept_);
        change_ = std::exchange(other.change_, {});
    }

    void assign(const Column& other)
    {
        truncate(0);
        if (other.size_ > 0) std::memcpy(extend(other.size_), other.data(), std::size_t(other.size_) * sizeof(T));
    }

    void keep(std::uint32_t page)
    {
        if (page >= kept_.size() || kept_[page]) return;
        const std::uint32_t first = page << page_bits;
        const std::uint32_t count = std::min(page_size, known_ - first);
        change_.pages.push_back(page);
        try {
            change_.contents.insert(change_.contents.end(), data() + first, data() + first + count);
        } catch (...) {
            change_.pages.pop_back(); // out of memory: roll_back() must still find a copy for each page
            throw;
        }
        kept_[page] = true;
    }

    /// Makes the elements what they were at begin_change(); what was kept of them is used up.
    void put_back() noexcept
    {
        if (change_.whole) {
            std::swap(block_, change_.block);
            measure();
        } else {
            const T* from = change_.contents.data();
            for (const std::uint32_t page : change_.pages) {
                const std::uint32_t first = page << page_bits;
                const std::uint32_t count = std::min(page_size, known_ - first);
                std::copy_n(from, count, data() + first);
                from += count;
            }
        }
        size_ = known_;
    }

    // The column became shorter: what lay past its new end moves from the kept pages to the tail.
    void cut_tail()
    {
        change_.tail.resize(known_ - size_);
        std::size_t from = 0, to = 0, pages = 0;
        for (const std::uint32_t page : change_.pages) {
            const std::uint32_t first = page << page_bits;
            const std::uint32_t count = std::min(page_size, known_ - first);
            const std::uint32_t stays = size_ > first ? std::min(count, size_ - first) : 0;
            if (count > stays)
                std::copy_n(change_.contents.data() + from + stays, count - stays, change_.tail.data() + (first + stays - size_));
            if (stays > 0) {
                std::copy_n(change_.contents.data() + from, stays, change_.contents.data() + to);
                change_.pages[pages++] = page;
                to += stays;
            }
            from += count;
        }
        change_.pages.resize(pages);
        change_.contents.resize(to);
    }

    Storage block_;
    std::uint32_t size_ = 0;
    std::uint32_t limit_ = 0; // how many fit into the block
    std::uint32_t known_ = 0; // size at begin_change()
    bool recording_ = false;
    std::vector<bool> kept_;
    ColumnChange<T> change_;
};

} // namespace druse
