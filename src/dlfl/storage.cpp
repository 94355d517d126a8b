#include "dlfl/storage.h"

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
#if defined(__SANITIZE_ADDRESS__)
constexpr bool use_mapping = false;
#else
constexpr bool use_mapping = true;
#endif

std::byte* map(std::size_t bytes)
{
    void* p = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    madvise(p, bytes, MADV_HUGEPAGE);
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
            void* p = mremap(data_, capacity_, rounded, MREMAP_MAYMOVE);
            if (p == MAP_FAILED) throw std::bad_alloc();
            madvise(p, rounded, MADV_HUGEPAGE);
            data_ = static_cast<std::byte*>(p);
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
