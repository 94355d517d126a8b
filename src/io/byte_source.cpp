#include "io/byte_source.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace druse {

ByteSource ByteSource::file(const std::filesystem::path& path)
{
    ByteSource source;
    source.name_ = path.string();
    source.path_ = path;
    source.descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (source.descriptor_ < 0)
        throw InputError(source.name_, errno == ENOENT ? "no such file" : std::string("cannot be read: ") + std::strerror(errno));
    source.owned_ = true;
    struct stat status {};
    if (fstat(source.descriptor_, &status) != 0)
        throw InputError(source.name_, std::string("cannot be read: ") + std::strerror(errno));
    if (S_ISDIR(status.st_mode)) throw InputError(source.name_, "is a folder, not a file");
    if (S_ISREG(status.st_mode)) source.size_ = static_cast<std::uint64_t>(status.st_size);
    return source;
}

ByteSource ByteSource::standard_input()
{
    ByteSource source;
    source.name_ = "standard input";
    source.descriptor_ = STDIN_FILENO;
    return source;
}

ByteSource ByteSource::memory(std::string_view bytes, const std::filesystem::path& name)
{
    ByteSource source;
    source.name_ = name.string();
    source.path_ = name;
    source.size_ = bytes.size();
    source.memory_ = bytes;
    return source;
}

ByteSource::ByteSource(ByteSource&& other) noexcept
    : name_(std::move(other.name_)), path_(std::move(other.path_)), size_(other.size_),
      descriptor_(std::exchange(other.descriptor_, -1)), owned_(std::exchange(other.owned_, false)), memory_(other.memory_),
      progress_(other.progress_), given_(other.given_), head_(std::move(other.head_)), head_used_(other.head_used_)
{
}

ByteSource::~ByteSource()
{
    if (owned_) close(descriptor_);
}

std::size_t ByteSource::read(char* into, std::size_t room)
{
    const std::size_t again = std::min(room, head_.size() - head_used_);
    std::copy_n(head_.data() + head_used_, again, into);
    head_used_ += again;
    const std::size_t count = again + read_on(into + again, room - again);
    given_ += count;
    if (progress_) progress_->step(size_ && *size_ > 0 ? std::min(1.0, double(given_) / double(*size_)) : 0.0);
    return count;
}

std::vector<char> ByteSource::read_all(std::uint64_t most)
{
    std::vector<char> bytes(static_cast<std::size_t>(std::min(size_.value_or(1 << 16), most) + 1));
    std::size_t used = 0;
    while (true) {
        const std::size_t wanted = std::min(bytes.size() - used, std::size_t(1) << 20); // between reads a person can stop it
        const std::size_t count = read(bytes.data() + used, wanted);
        used += count;
        if (count < wanted) break;
        if (used > most) throw InputError(name_, fmt::format("is larger than {} bytes", most));
        if (used == bytes.size()) bytes.resize(static_cast<std::size_t>(std::min(2 * std::uint64_t(used), most + 1)));
    }
    bytes.resize(used);
    return bytes;
}

std::string_view ByteSource::head(std::size_t count)
{
    if (head_.size() < count) {
        const std::size_t had = head_.size();
        head_.resize(count);
        head_.resize(had + read_on(head_.data() + had, count - had));
    }
    return {head_.data(), std::min(count, head_.size())};
}

std::size_t ByteSource::read_on(char* into, std::size_t room)
{
    if (descriptor_ < 0) {
        const std::size_t count = std::min(room, memory_.size());
        std::copy_n(memory_.data(), count, into);
        memory_.remove_prefix(count);
        return count;
    }
    std::size_t filled = 0;
    while (filled < room) {
        const ssize_t count = ::read(descriptor_, into + filled, room - filled);
        if (count == 0) break;
        if (count > 0)
            filled += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            throw InputError(name_, std::string("cannot be read: ") + std::strerror(errno));
    }
    return filled;
}

std::optional<std::filesystem::path> ByteSource::find_side_file(const std::filesystem::path& named) const
{
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path_, error);
    for (const std::filesystem::path& beside : {path_, real}) {
        std::filesystem::path candidate = beside.parent_path() / named;
        if (std::filesystem::is_regular_file(candidate, error)) return candidate;
    }
    return std::nullopt;
}

} // namespace druse
