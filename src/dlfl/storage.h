#pragma once

#include <cstddef>

namespace druse {

/// A block of raw memory for one column. Large blocks come straight from the system on huge pages, because page faults cost
/// more than the work of most operators, and grow by remapping, so that appending to a column of a large mesh copies nothing.
class Storage {
public:
    Storage() = default;
    Storage(Storage&& other) noexcept;
    Storage& operator=(Storage&& other) noexcept;
    ~Storage();

    std::byte* data() const { return data_; }
    std::size_t capacity() const { return capacity_; } // bytes

    /// Makes room for at least `bytes`; what is in the block stays. Throws std::bad_alloc.
    void reserve(std::size_t bytes);

private:
    void release();

    std::byte* data_ = nullptr;
    std::size_t capacity_ = 0;
    bool mapped_ = false;
};

} // namespace druse
