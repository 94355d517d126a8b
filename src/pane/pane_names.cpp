#include "pane/pane_names.h"

#include <algorithm>

namespace druse {

std::string with_names(const std::string& text, const std::function<std::string(std::uint32_t)>& name)
{
    // Without the word for the reason, which the next refusal puts before it again.
    const std::size_t begin = text.find(": ");
    std::string result, rest = begin == std::string::npos ? text : text.substr(begin + 2);
    static const std::string word = "point ";
    for (std::size_t at; (at = rest.find(word)) != std::string::npos;) {
        result += rest.substr(0, at);
        rest.erase(0, at + word.size());
        std::size_t digits = 0;
        std::uint32_t number = 0;
        while (digits < rest.size() && digits < 9 && rest[digits] >= '0' && rest[digits] <= '9') number = 10 * number + static_cast<std::uint32_t>(rest[digits++] - '0');
        const std::string known = digits > 0 ? name(number) : "";
        result += known.empty() ? word + rest.substr(0, digits) : known;
        rest.erase(0, digits);
    }
    return result + rest;
}

std::optional<SegmentId> segment_along(const Pane& pane, std::span<const PointId> path)
{
    if (path.size() < 2) return {};
    for (const SegmentId segment : pane.segments()) {
        const auto chain = pane.chain(segment);
        const bool same_ends = (chain.front() == path.front() && chain.back() == path.back()) || (chain.front() == path.back() && chain.back() == path.front());
        if (same_ends && std::ranges::all_of(path, [&](PointId id) { return std::ranges::find(chain, id) != chain.end(); })) return segment;
    }
    return {};
}

} // namespace druse
