#pragma once

#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

namespace druse {

/// Collects what a writer makes and hands it to the system a megabyte at a time.
class ByteSink {
public:
    /// `name` is what errors call the file; the descriptor is borrowed.
    ByteSink(int descriptor, std::string name);
    ByteSink(const ByteSink&) = delete;
    ByteSink& operator=(const ByteSink&) = delete;

    const std::string& name() const { return name_; }

    /// Room for `count` bytes (at most 64 KiB), to be followed by use() with how many of them were written.
    char* room(std::size_t count)
    {
        if (capacity - used_ < count) flush();
        return buffer_.get() + used_;
    }
    void use(std::size_t count) { used_ += count; }

    void put(char c)
    {
        *room(1) = c;
        use(1);
    }
    void put(std::string_view text);
    void put(std::uint64_t number) { put_shortest(number); }
    /// The shortest decimal that reads back as the same number.
    void put(double number) { put_shortest(number); }
    void put(float number) { put_shortest(number); }

    /// Hands over what is collected. Throws InputError if the system does not take it.
    void flush();
    /// Replaces bytes already written, from `offset` on. Precondition: a regular file.
    void overwrite(std::uint64_t offset, std::string_view bytes);

private:
    static constexpr std::size_t capacity = std::size_t(1) << 20;

    template <class T> void put_shortest(T number)
    {
        char* const at = room(32);
        use(static_cast<std::size_t>(std::to_chars(at, at + 32, number).ptr - at));
    }
    void write_all(const char* bytes, std::size_t count);

    int descriptor_;
    std::string name_;
    std::unique_ptr<char[]> buffer_;
    std::size_t used_ = 0;
};

} // namespace druse
