#include "dlfl/storage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

#include <sys/mman.h>

namespace druse {

namespace {

constexpr std::size_t huge_page = std::size_t(2) << 20;
constexpr std::size_t least_mapped = std::size_t(1) << 20;
constexpr std::size_t page = 4096, cache_line = 64;

// Address sanitizer knows nothing of mapped memory, so under it every block comes from malloc.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define __SANITIZE_ADDRESS__ 1 // as GCC says it
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
constexpr bool use_mapping = false;
#else
constexpr bool use_mapping = true;
#endif

/// Fresh memory that begins at a huge page. Precondition: a multiple of huge_page.
std::byte* map(std::size_t bytes)
{
    void* got = mmap(nullptr, bytes + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (got == MAP_FAILED) throw std::bad_alloc();
    auto* const begin = static_cast<std::byte*>(got);
    const std::size_t lead = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
    if (lead > 0) munmap(begin, lead);
    if (lead < huge_page) munmap(begin + lead + bytes, huge_page - lead);
    madvise(begin + lead, bytes, MADV_HUGEPAGE);
    return begin + lead;
}

/// Makes a mapped block longer: in place, or by moving its pages, whole huge pages at a time, to a place that has room.
std::byte* remap(std::byte* block, std::size_t bytes, std::size_t longer)
{
    void* p = mremap(block, bytes, longer, 0);
    if (p == MAP_FAILED) {
        std::byte* const place = map(longer);
        p = mremap(block, bytes, longer, MREMAP_MAYMOVE | MREMAP_FIXED, place);
        if (p == MAP_FAILED) {
            munmap(place, longer);
            throw std::bad_alloc();
        }
    }
    madvise(p, longer, MADV_HUGEPAGE);
    return static_cast<std::byte*>(p);
}

struct Block {
    std::byte* data = nullptr;
    std::size_t bytes = 0;
};

/// How far into its mapped block the data of a column begin, below a page: elsewhere for each block in turn. A load waits for an earlier
/// store whose address differs by whole pages, and the cache has few places for such lines; columns that all began alike would be in each
/// other's way at every index.
std::size_t next_lead()
{
    static constinit std::atomic<std::size_t> blocks{0};
    return blocks.fetch_add(1, std::memory_order_relaxed) * (5 * cache_line) % page; // 5 goes round all lines of a page
}

/// The mapped block with these data, which begin in its first page and leave so much out at its end.
Block block_of(std::byte* data, std::size_t capacity)
{
    return {data - reinterpret_cast<std::uintptr_t>(data) % huge_page, capacity + page};
}

constexpr std::size_t most_kept = std::size_t(1) << 30; // bytes

/// Mapped blocks that nobody uses, the oldest first, for the next column that needs one: a dragged slider makes the same mesh again and
/// again, and pages that the system has to clear each time would be a third of the work. Meanwhile the system may take their pages for
/// others that need memory. Columns are made and dropped on several threads.
class KeptBlocks {
public:
    /// `bytes` of the smallest block that has as many, and not over twice that; else nothing.
    std::byte* take(std::size_t bytes) noexcept
    {
        const std::lock_guard lock(mutex_);
        std::size_t best = count_;
        for (std::size_t i = 0; i < count_; ++i)
            if (blocks_[i].bytes >= bytes && blocks_[i].bytes <= 2 * bytes && (best == count_ || blocks_[i].bytes < blocks_[best].bytes)) best = i;
        if (best == count_) return nullptr;
        const Block block = remove(best);
        if (block.bytes > bytes) munmap(block.data + bytes, block.bytes - bytes); // so that capacities never depend on what was before
        return block.data;
    }

    void give(Block block) noexcept
    {
        if (block.bytes > most_kept) {
            munmap(block.data, block.bytes);
            return;
        }
        madvise(block.data, block.bytes, MADV_FREE);
        const std::lock_guard lock(mutex_);
        while (count_ == blocks_.size() || bytes_ + block.bytes > most_kept) {
            const Block oldest = remove(0);
            munmap(oldest.data, oldest.bytes);
        }
        blocks_[count_++] = block;
        bytes_ += block.bytes;
    }

private:
    Block remove(std::size_t at) noexcept
    {
        const Block block = blocks_[at];
        std::copy(blocks_.begin() + at + 1, blocks_.begin() + count_, blocks_.begin() + at);
        --count_;
        bytes_ -= block.bytes;
        return block;
    }

    std::mutex mutex_;
    std::array<Block, 64> blocks_; // a mesh has eleven columns
    std::size_t count_ = 0, bytes_ = 0;
};

KeptBlocks& kept_blocks()
{
    static constinit KeptBlocks blocks;
    return blocks;
}

} // namespace

Storage::Storage(Storage&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), capacity_(std::exchange(other.capacity_, 0)),
      mapped_(std::exchange(other.mapped_, false))
{
}

Storage& Storage::operator=(Storage&& other) noexcept
{
    if (this != &other) {
        release();
        data_ = std::exchange(other.data_, nullptr);
        capacity_ = std::exchange(other.capacity_, 0);
        mapped_ = std::exchange(other.mapped_, false);
    }
    return *this;
}

Storage::~Storage() { release(); }

void Storage::release()
{
    if (mapped_) kept_blocks().give(block_of(data_, capacity_));
    else std::free(data_);
}

void Storage::reserve(std::size_t bytes)
{
    if (bytes <= capacity_) return;
    if (use_mapping && bytes >= least_mapped) {
        const std::size_t total = (bytes + page + huge_page - 1) / huge_page * huge_page;
        const bool copies_less = total >= 2 * capacity_; // than the system would have to clear
        std::byte* block = copies_less ? kept_blocks().take(total) : nullptr;
        if (mapped_ && !block) {
            const Block old = block_of(data_, capacity_);
            data_ = remap(old.data, old.bytes, total) + (data_ - old.data);
        } else {
            std::byte* const data = (block ? block : map(total)) + next_lead();
            if (capacity_ > 0) std::memcpy(data, data_, capacity_);
            release();
            data_ = data;
            mapped_ = true;
        }
        capacity_ = total - page;
        return;
    }
    void* p = std::realloc(data_, bytes);
    if (!p) throw std::bad_alloc();
    data_ = static_cast<std::byte*>(p);
    capacity_ = bytes;
}

} // namespace druse
