#include "io/pane_file.h"

#include "dlfl/errors.h"
#include "io/text_walk.h"
#include "pane/pane_record.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace druse {

namespace {

using Number = PaneRecord::Number;

constexpr std::uint64_t largest_pane_file = 0xffffffff;
constexpr std::size_t deepest_list = 64; // of what is skipped; ours go four deep

/// What is said of a value when it is met.
struct PaneFault {
    std::string path, what;
};

/// Puts the values of a pane file where they belong while the text is read; nothing else is kept of it.
class PaneFileReader {
public:
    static constexpr Number any = 0xffffffff;

    /// `points`: how many there are; indices may not reach it. `fault`: what is said of one value.
    PaneFileReader(const TextPlace& place, const std::string& file, Number points, const PaneFault& fault)
        : place_(place), file_(file), points_(points), fault_(fault)
    {
    }

    PaneRecord& record() { return record_; }

    // --- what the parser calls; false would stop it, but complaints are thrown ---------------------------------------------------
    bool null() { return other("null"); }
    bool boolean(bool) { return other("a switch"); }
    bool binary(nlohmann::json::binary_t&) { return other("binary data"); }
    bool number_integer(std::int64_t n) { return number(double(n), n == 0 ? std::optional<std::uint64_t>(0) : std::nullopt); }
    bool number_unsigned(std::uint64_t n) { return number(double(n), n); }
    bool number_float(double x, const std::string&) { return number(x, std::nullopt); }

    bool string(const std::string& text)
    {
        value();
        if (key_ == Key::format && depth() == 0) {
            if (text != "druse-pane") fail(R"(expected "druse-pane")");
            return true;
        }
        if (key_ != Key::none) fail(fmt::format("expected {}, found a text", wanted()));
        return true;
    }

    bool start_array(std::size_t)
    {
        value();
        if (key_ != Key::none && !is_list()) fail(fmt::format("expected {}, found a list", wanted()));
        open();
        if (key_ == Key::boundary && depth() == 2) record_.boundary.emplace_back();
        if (key_ == Key::points && depth() == 2) record_.points.emplace_back();
        if (key_ == Key::constraints && depth() == 2) record_.constraints.emplace_back();
        if (key_ == Key::triangles && depth() == 2) record_.triangles.emplace_back();
        if (key_ == Key::segments && depth() == 2) record_.segments.emplace_back();
        return true;
    }

    bool end_array()
    {
        const std::size_t count = counts_.back();
        counts_.pop_back();
        const std::size_t least = key_ == Key::points ? 2 : key_ == Key::constraints ? 2 : key_ == Key::triangles ? 3 : key_ == Key::segments ? 2 : 0;
        if (depth() == 1 && count < least) fail(fmt::format("expected {} items, found {}", least, count));
        if (depth() == 0 && key_ == Key::next && count < 2) fail("expected 2 numbers");
        return true;
    }

    bool start_object(std::size_t)
    {
        if (!began_) {
            began_ = true;
            return true;
        }
        value();
        if (key_ != Key::none) fail(fmt::format("expected {}, found an object", wanted()));
        open();
        return true;
    }

    bool key(std::string& name)
    {
        if (depth() > 0) return true; // of something that is skipped
        key_ = Key::none;
        for (std::size_t i = 0; i < std::size(keys); ++i)
            if (name == keys[i]) key_ = static_cast<Key>(i);
        if (key_ == Key::none) return true;
        if (met_[static_cast<std::size_t>(key_)]) fail("is given twice");
        met_[static_cast<std::size_t>(key_)] = true;
        return true;
    }

    bool end_object()
    {
        if (depth() > 0) {
            counts_.pop_back();
            return true;
        }
        key_ = Key::none;
        for (const Key needed : {Key::format, Key::version, Key::points, Key::boundary, Key::ids, Key::segments, Key::locked, Key::snap, Key::weld, Key::next})
            if (!met_[static_cast<std::size_t>(needed)]) fail(fmt::format("\"{}\" is missing", keys[static_cast<std::size_t>(needed)]));
        return true;
    }

    template <class Error>
    bool parse_error(std::size_t, const std::string&, const Error& error)
    {
        constexpr int too_large = 406; // the parser's number for a number that is
        if (error.id == too_large) {
            value();
            fail("a number that is too large");
        }
        throw InputError(file_, place_.line(), place_.at == place_.end ? "ends where more of its JSON should be" : "is no JSON from here on");
    }

private:
    enum class Key : std::size_t { format, version, points, boundary, constraints, triangles, ids, segments, locked, crossings, refined, snap, weld, next, none };
    static constexpr std::array keys{"format", "version",  "points", "boundary",  "constraints", "triangles", "ids",
                                     "segments", "locked", "crossings", "refined", "snap",       "weld",      "next"};

    std::size_t depth() const { return counts_.size(); }

    /// `points[3][0]`: the place of the value being read.
    std::string path() const
    {
        std::string text = key_ == Key::none ? "" : keys[static_cast<std::size_t>(key_)];
        if (key_ != Key::none)
            for (const std::size_t count : counts_) text += fmt::format("[{}]", count > 0 ? count - 1 : 0);
        return text;
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        const std::string where = path();
        throw InputError(file_, place_.line(), where.empty() ? what : where + ": " + what);
    }

    /// A value begins here.
    void value()
    {
        if (!began_) fail("expected an object of JSON");
        if (!counts_.empty()) ++counts_.back();
        if (!fault_.path.empty() && path() == fault_.path) fail(fault_.what);
    }

    void open()
    {
        if (depth() >= deepest_list) fail(fmt::format("lists in lists, more than {} deep", deepest_list));
        counts_.push_back(0);
    }

    /// Whether a list may stand here: counts_ holds the lists around it.
    bool is_list() const
    {
        switch (key_) {
        case Key::points:
        case Key::boundary:
        case Key::constraints:
        case Key::triangles: return depth() < 2;
        case Key::segments: return depth() < 2 || (depth() == 2 && counts_.back() == 2);
        case Key::ids:
        case Key::locked:
        case Key::crossings:
        case Key::refined:
        case Key::next: return depth() < 1;
        default: return false;
        }
    }

    const char* wanted() const
    {
        if (is_list()) return "a list";
        switch (key_) {
        case Key::format: return "\"druse-pane\"";
        case Key::points:
        case Key::snap:
        case Key::weld: return "a number";
        default: return "a whole number";
        }
    }

    bool other(const char* what)
    {
        value();
        if (key_ != Key::none) fail(fmt::format("expected {}, found {}", wanted(), what));
        return true;
    }

    Number whole(std::optional<std::uint64_t> n, std::uint64_t below) const
    {
        if (!n) fail("expected a whole number, 0 or more");
        if (*n >= below) fail(fmt::format("expected a whole number below {}, found {}", below, *n));
        return static_cast<Number>(*n);
    }
    Number index(std::optional<std::uint64_t> n) const { return whole(n, points_); }
    Number id(std::optional<std::uint64_t> n) const { return whole(n, any); }

    template <class Items>
    void put(Items& items, const typename Items::value_type& item) const
    {
        if (counts_.back() > items.size()) fail(fmt::format("expected {} items", items.size()));
        items[counts_.back() - 1] = item;
    }

    bool number(double x, std::optional<std::uint64_t> n)
    {
        value();
        if (key_ == Key::none) return true;
        if (is_list()) fail("expected a list, found a number");
        switch (key_) {
        case Key::format: fail("expected \"druse-pane\", found a number");
        case Key::version:
            if (n != 1u) fail("expected version 1");
            break;
        case Key::points: {
            std::array<double, 2> p{record_.points.back().x, record_.points.back().y};
            put(p, x);
            record_.points.back() = {p[0], p[1]};
            break;
        }
        case Key::boundary: record_.boundary.back().push_back(index(n)); break;
        case Key::constraints: put(record_.constraints.back(), index(n)); break;
        case Key::triangles: put(record_.triangles.back(), index(n)); break;
        case Key::ids: record_.ids.push_back(id(n)); break;
        case Key::segments:
            if (depth() == 3) record_.segments.back().second.push_back(index(n));
            else if (counts_.back() == 1) record_.segments.back().first = id(n);
            else fail("expected 2 items");
            break;
        case Key::locked: record_.locked.push_back(index(n)); break;
        case Key::crossings: record_.crossings.push_back(index(n)); break;
        case Key::refined: record_.refined.push_back(index(n)); break;
        case Key::snap: record_.snap = x; break;
        case Key::weld: record_.weld = x; break;
        case Key::next: {
            std::array<Number, 2> next{record_.next_point, record_.next_segment};
            put(next, id(n));
            record_.next_point = next[0];
            record_.next_segment = next[1];
            break;
        }
        case Key::none: break;
        }
        return true;
    }

    const TextPlace& place_;
    const std::string& file_;
    Number points_;
    const PaneFault& fault_;
    PaneRecord record_;
    bool began_ = false;
    Key key_ = Key::none;
    std::array<bool, std::size(keys)> met_{};
    std::vector<std::size_t> counts_; // of items so far, in the lists around the value that is read
};

PaneRecord parse_pane(std::string_view text, const std::string& file, Number points, const PaneFault& fault = {})
{
    TextPlace place{text.data(), text.data(), text.data() + text.size()};
    PaneFileReader reader(place, file, points, fault);
    nlohmann::json::sax_parse(TextWalk(place, text.data()), TextWalk(place, text.data() + text.size()), &reader);
    return std::move(reader.record());
}

/// Reads the text once more, to say on which line the value at a path stands.
[[noreturn]] void fail_at(std::string_view text, const std::string& file, const PaneFault& fault)
{
    parse_pane(text, file, PaneFileReader::any, fault);
    throw InputError(file, fault.path + ": " + fault.what);
}

} // namespace

Model read_pane(ByteSource& source)
{
    const std::vector<char> bytes = source.read_all(largest_pane_file);
    std::string_view text(bytes.data(), bytes.size());
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    PaneRecord told = parse_pane(text, source.name(), PaneFileReader::any);
    const auto count = static_cast<Number>(told.points.size());
    const auto beyond = [count](Number i) { return i >= count; };
    const auto any_beyond = [&](const auto& lists) { return std::ranges::any_of(lists, [&](const auto& list) { return std::ranges::any_of(list, beyond); }); };
    bool bad = any_beyond(told.boundary) || any_beyond(told.constraints) || any_beyond(told.triangles);
    for (const auto& [id, chain] : told.segments) bad |= std::ranges::any_of(chain, beyond);
    for (const auto* list : {&told.locked, &told.crossings, &told.refined}) bad |= std::ranges::any_of(*list, beyond);
    if (bad) parse_pane(text, source.name(), count); // which says where
    // Ids may be far more than points, but not so many that a small file takes much memory.
    if (const std::uint64_t most = (std::uint64_t(1) << 24) + 64 * std::uint64_t(count); std::max(told.next_point, told.next_segment) > most)
        fail_at(text, source.name(), {"next", fmt::format("expected at most {} for {} points", most, count)});

    Model model;
    try {
        model.pane.emplace(restore(told));
    } catch (const PaneRecordRefusal& refusal) {
        fail_at(text, source.name(), {refusal.path(), refusal.what()});
    }
    const PaneRecord made = record(*model.pane);
    if (told.triangles != made.triangles) model.notes.push_back("the triangles in the file were not those of its points and segments; they are made anew");
    if (told.constraints != made.constraints) model.notes.push_back("the constraints in the file were not the pieces of its segments");
    return model;
}

} // namespace druse
