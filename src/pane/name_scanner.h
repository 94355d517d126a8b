#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace druse {

/// Reads names that are made of letters and whole numbers, as `e0:2m`, from the front. What is not there is not taken.
class NameScanner {
public:
    explicit NameScanner(std::string_view text) : rest_(text) {}

    bool done() const { return rest_.empty(); }

    bool take(char c)
    {
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    /// Whatever stands at the front; a blank where nothing does.
    char take_any()
    {
        const char c = done() ? ' ' : rest_.front();
        rest_.remove_prefix(done() ? 0 : 1);
        return c;
    }

    /// A number without a sign, `least` or more.
    std::optional<int> take_number(int least = 0)
    {
        int value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || rest_.front() == '-' || value < least) return {};
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

private:
    std::string_view rest_;
};

} // namespace druse
