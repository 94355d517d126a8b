#include "io/ply_header.h"

#include "dlfl/errors.h"
#include "io/group_materials.h"
#include "io/limits.h"
#include "io/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace druse {

namespace {

/// A million groups with long names still fit.
constexpr std::size_t longest_header = std::size_t(1) << 28;

/// The size of the header, up to the line break after its last line; 0 if that is not in `text`.
std::size_t header_size(std::string_view text)
{
    constexpr std::string_view last = "\nend_header";
    for (std::size_t at = 0; (at = text.find(last, at)) != std::string_view::npos;) {
        at += last.size();
        std::size_t end = at;
        while (end < text.size() && scan::is_blank(text[end])) ++end;
        if (end < text.size() && text[end] == '\n') return end + 1;
    }
    return 0;
}

std::string header_text(ByteSource& source)
{
    const std::string_view title = source.head(4);
    if (!title.starts_with("ply") || (title.size() == 4 && !scan::ends_word(title[3])))
        throw InputError(source.name(), "is no PLY file: it does not begin with 'ply'");
    for (std::size_t count = 1 << 12; count <= longest_header; count *= 2) {
        const std::string_view head = source.head(count);
        if (const std::size_t size = header_size(head)) return std::string(head.substr(0, size));
        if (head.size() < count) break;
    }
    throw InputError(source.name(), "has no 'end_header'");
}

class HeaderReader {
public:
    explicit HeaderReader(ByteSource& source) : source_(source) {}
    PlyHeader read();

private:
    void line();
    void format();
    void comment();
    void element();
    void property();
    std::string_view word();
    PlyType type();
    [[noreturn]] void fail_at(const char* p, const std::string& expected) const
    {
        fail(fmt::format("expected {}, found {}", expected, scan::quoted_word(p)));
    }
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), header_.lines, what); }

    ByteSource& source_;
    PlyHeader header_;
    bool has_format_ = false;
    const char* p_ = nullptr; // the place in the line
};

std::string_view HeaderReader::word()
{
    while (scan::is_blank(*p_)) ++p_;
    const char* const begin = p_;
    p_ = scan::end_of_word(p_);
    return {begin, static_cast<std::size_t>(p_ - begin)};
}

PlyType HeaderReader::type()
{
    // The old names, and those with sizes in them.
    static constexpr std::pair<std::string_view, PlyType> names[] = {
        {"char", PlyType::int8},   {"uchar", PlyType::uint8},   {"short", PlyType::int16},     {"ushort", PlyType::uint16},
        {"int", PlyType::int32},   {"uint", PlyType::uint32},   {"float", PlyType::float32},   {"double", PlyType::float64},
        {"int8", PlyType::int8},   {"uint8", PlyType::uint8},   {"int16", PlyType::int16},     {"uint16", PlyType::uint16},
        {"int32", PlyType::int32}, {"uint32", PlyType::uint32}, {"float32", PlyType::float32}, {"float64", PlyType::float64},
    };
    const std::string_view name = word();
    for (const auto& [known, type] : names)
        if (name == known) return type;
    fail_at(name.data(), "a type of number");
}

void HeaderReader::format()
{
    const std::string_view encoding = word();
    if (encoding == "ascii")
        header_.encoding = PlyEncoding::ascii;
    else if (encoding == "binary_little_endian")
        header_.encoding = PlyEncoding::little_endian;
    else if (encoding == "binary_big_endian")
        header_.encoding = PlyEncoding::big_endian;
    else
        fail_at(encoding.data(), "ascii, binary_little_endian or binary_big_endian");
    if (const std::string_view version = word(); version != "1.0") fail_at(version.data(), "version 1.0");
    has_format_ = true;
}

/// Only a comment that names a group means anything.
void HeaderReader::comment()
{
    if (word() != "group") return;
    const std::string_view id = word();
    std::string name = group_name_in(word());
    std::int64_t number = 0;
    const char* const end = scan::integer(id.data(), number);
    if (end != id.data() + id.size() || number < 0 || number > std::numeric_limits<int>::max() || name.empty()) return;
    header_.group_names.emplace_back(static_cast<int>(number), std::move(name));
}

void HeaderReader::element()
{
    const std::string_view name = word(), count = word();
    if (name.empty()) fail_at(name.data(), "the name of an element");
    std::int64_t number = 0;
    if (scan::integer(count.data(), number) != count.data() + count.size() || number < 0)
        fail_at(count.data(), fmt::format("the number of elements called {}", scan::quoted_word(name.data())));
    if (static_cast<std::uint64_t>(number) > most_elements) fail(fmt::format("{}: expected at most {}", number, most_elements));
    for (const PlyElement& other : header_.elements)
        if (other.name == name) fail(fmt::format("there are elements called {} already", scan::quoted_word(name.data())));
    header_.elements.push_back({std::string(name), static_cast<std::uint64_t>(number)});
}

void HeaderReader::property()
{
    if (header_.elements.empty()) fail("expected 'element' first, found 'property'");
    PlyProperty property;
    const char* const before = p_;
    if (word() == "list") {
        const char* at = p_;
        while (scan::is_blank(*at)) ++at;
        property.length = type();
        if (*property.length >= PlyType::float32) fail_at(at, "a type of whole numbers");
    } else {
        p_ = before;
    }
    property.type = type();
    const std::string_view name = word();
    if (name.empty()) fail_at(name.data(), "the name of a property");
    property.name = name;
    header_.elements.back().properties.push_back(std::move(property));
}

void HeaderReader::line()
{
    const std::string_view keyword = word();
    if (keyword == "format")
        format();
    else if (keyword == "comment")
        comment();
    else if (keyword == "element")
        element();
    else if (keyword == "property")
        property();
    else if (header_.lines == 1 || keyword == "obj_info" || keyword == "end_header" || keyword.empty())
        return;
    else
        fail_at(keyword.data(), "a word of PLY");
}

PlyHeader HeaderReader::read()
{
    std::string text = header_text(source_);
    header_.size = text.size();
    text.append(8, '\n'); // scan:: looks at eight bytes at once
    p_ = text.data();
    const char* const end = text.data() + header_.size;
    while (p_ != end) {
        ++header_.lines;
        line();
        while (*p_ != '\n') ++p_;
        ++p_;
    }
    if (!has_format_) throw InputError(source_.name(), "has no 'format'");
    return std::move(header_);
}

} // namespace

PlyHeader read_ply_header(ByteSource& source)
{
    return HeaderReader(source).read();
}

} // namespace druse
