#pragma once

#include "geom/progress.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// Where a reader gets its bytes from: a file, standard input, or memory.
class ByteSource {
public:
    /// Throws InputError if there is no such file, if it is a folder, or if it cannot be read.
    static ByteSource file(const std::filesystem::path& path);
    static ByteSource standard_input();
    /// `name` is what errors call it; side files are looked for beside it. `bytes` are borrowed.
    static ByteSource memory(std::string_view bytes, const std::filesystem::path& name);

    ByteSource(ByteSource&& other) noexcept;
    ByteSource& operator=(ByteSource&&) = delete;
    ~ByteSource();

    const std::string& name() const { return name_; }
    /// How many bytes there are in all, where that is known beforehand.
    std::optional<std::uint64_t> size() const { return size_; }

    /// Fills up to `room` bytes; fewer only at the end, none after it. Throws InputError if the system cannot read on.
    std::size_t read(char* into, std::size_t room);
    /// All bytes. Throws InputError if there are more than `most`.
    std::vector<char> read_all(std::uint64_t most);
    /// The first bytes, as many as `count` if there are; read() gives them again. Precondition: nothing was read yet.
    std::string_view head(std::size_t count);

    /// From now on read() tells how far it is, and throws Cancelled when asked to stop. The progress must outlive the source.
    void report_to(Progress& progress) { progress_ = &progress; }

    /// Looks for a file that this one names: beside it, and beside the file itself where this is a link to it.
    std::optional<std::filesystem::path> find_side_file(const std::filesystem::path& named) const;

private:
    ByteSource() = default;
    std::size_t read_on(char* into, std::size_t room);

    std::string name_;
    std::filesystem::path path_;
    std::optional<std::uint64_t> size_;
    int descriptor_ = -1;
    bool owned_ = false;
    std::string_view memory_;
    Progress* progress_ = nullptr;
    std::uint64_t given_ = 0; // bytes, by read()
    std::vector<char> head_;
    std::size_t head_used_ = 0;
};

} // namespace druse
