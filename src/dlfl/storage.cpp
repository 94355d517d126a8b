#include "dlfl/storage.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include <sys/mman.h>

namespace druse {

namespace {

constexpr std::size_t huge_page = std::size_t(2) << 20;
constexpr std::size_t least_mapped = std::size_t(1) << 20;

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
    if (mapped_) munmap(data_, capacity_);
    else std::free(data_);
}

void Storage::reserve(std::size_t bytes)
{
    if (bytes <= capacity_) return;
    if (use_mapping && bytes >= least_mapped) {
        const std::size_t rounded = (bytes + huge_page - 1) / huge_page * huge_page;
        if (mapped_) {
            data_ = remap(data_, capacity_, rounded);
        } else {
            std::byte* p = map(rounded);
            if (capacity_ > 0) std::memcpy(p, data_, capacity_);
            std::free(data_);
            data_ = p;
            mapped_ = true;
        }
        capacity_ = rounded;
        return;
    }
    void* p = std::realloc(data_, bytes);
    if (!p) throw std::bad_alloc();
    data_ = static_cast<std::byte*>(p);
    capacity_ = bytes;
}

} // namespace druse
