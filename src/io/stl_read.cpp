#include "io/stl.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/limits.h"
#include "io/point_welder.h"
#include "io/scan.h"
#include "io/text_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>

namespace druse {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

bool equal_ignoring_case(std::string_view text, std::string_view lower_case)
{
    return std::equal(text.begin(), text.end(), lower_case.begin(), lower_case.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + ('a' - 'A')) : a) == b; });
}

std::uint32_t promised_triangles(std::string_view head)
{
    std::uint32_t count = 0;
    std::memcpy(&count, head.data() + 80, sizeof count);
    return count;
}

/// ASCII files begin with `solid`, but so do some binary ones: those have the size their header says, or zeros behind the word.
bool is_ascii(ByteSource& source)
{
    std::string_view head = source.head(512);
    if (head.size() >= stl_header_size && source.size() == stl_header_size + stl_record_size * std::uint64_t(promised_triangles(head)))
        return false;
    if (head.find('\0') != std::string_view::npos) return false;
    while (!head.empty() && (head.front() == '\n' || scan::is_blank(head.front()))) head.remove_prefix(1);
    return head.size() >= 5 && equal_ignoring_case(head.substr(0, 5), "solid");
}

class StlReader {
public:
    explicit StlReader(ByteSource& source) : source_(source) {}
    Model read()
    {
        if (is_ascii(source_))
            read_ascii();
        else
            read_binary();
        return finish();
    }

private:
    void read_binary();
    void read_ascii();
    const char* word(const char* p);
    const char* number(const char* p, double& value);
    void add_corner(const Point& p);
    void end_facet();
    Model finish();
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), line_, what); }

    ByteSource& source_;
    MeshBuilder builder_;
    PointWelder weld_{builder_};
    std::vector<std::string> notes_;

    enum class Inside { nothing, facet, loop } inside_ = Inside::nothing;
    int corners_in_loop_ = 0;
    long line_ = 0;
};

void StlReader::add_corner(const Point& p)
{
    builder_.add_corner(weld_.vertex(p));
}

void StlReader::end_facet()
{
    builder_.end_face();
    if (builder_.corner_count() > most_elements)
        throw InputError(source_.name(), fmt::format("more than {} corners", most_elements));
}

void StlReader::read_binary()
{
    char header[stl_header_size];
    if (source_.read(header, stl_header_size) < stl_header_size)
        throw InputError(source_.name(), "is no STL file: shorter than the header of one");
    const std::uint32_t promised = promised_triangles({header, stl_header_size});

    constexpr std::size_t block = 20000 * stl_record_size;
    const auto buffer = std::make_unique_for_overwrite<char[]>(block);
    for (std::uint32_t done = 0; done < promised;) {
        const std::size_t wanted = std::min<std::size_t>(block, (promised - done) * stl_record_size);
        const std::size_t there = source_.read(buffer.get(), wanted);
        for (std::size_t at = 0; at + stl_record_size <= there; at += stl_record_size) {
            ++done;
            float place[9];
            std::memcpy(place, buffer.get() + at + 12, sizeof place);
            for (int i = 0; i < 9; ++i)
                if (!(std::abs(place[i]) <= largest_coordinate))
                    throw InputError(source_.name(), fmt::format("triangle {}: coordinate {}: expected at most {} in size", done,
                                                                 place[i], largest_coordinate));
            for (int i = 0; i < 9; i += 3) add_corner({place[i], place[i + 1], place[i + 2]});
            end_facet();
        }
        if (there < wanted)
            throw InputError(source_.name(),
                             fmt::format("ends in triangle {}, its header promises {}", std::uint64_t(done) + 1, promised));
    }
    char more = 0;
    if (source_.read(&more, 1) > 0) notes_.push_back("there is more after the last triangle: passed over");
}

const char* StlReader::number(const char* p, double& value)
{
    p = scan::skip_blanks(p, line_);
    const char* after = scan::number(p, value);
    if (!after || !scan::ends_word(*after)) fail("expected a number, found " + scan::quoted_word(p));
    if (!(std::abs(value) <= largest_coordinate))
        fail(fmt::format("coordinate {}: expected at most {} in size", value, largest_coordinate));
    return after;
}

/// Takes one word and what belongs to it. Facets may be spread over lines in any way, but numbers stand in the line of their
/// word.
const char* StlReader::word(const char* p)
{
    const char* end = scan::end_of_word(p);
    const std::string_view text(p, static_cast<std::size_t>(end - p));
    const auto is = [&](std::string_view name) { return equal_ignoring_case(text, name); };
    const auto must_be = [&](Inside where, const char* expected) {
        if (inside_ != where) fail(fmt::format("expected {}, found {}", expected, scan::quoted_word(p)));
    };
    if (is("vertex")) {
        must_be(Inside::loop, "'outer loop' first");
        Point at;
        for (int i = 0; i < 3; ++i) end = number(end, at[i]);
        add_corner(at);
        ++corners_in_loop_;
    } else if (is("facet")) {
        must_be(Inside::nothing, "'endfacet' first");
        inside_ = Inside::facet;
    } else if (is("normal")) {
        for (int i = 0; i < 3; ++i) end = scan::end_of_word(scan::skip_blanks(end, line_)); // whatever it is
    } else if (is("outer")) {
        must_be(Inside::facet, "'facet' first");
        inside_ = Inside::loop;
        corners_in_loop_ = 0;
    } else if (is("endloop")) {
        must_be(Inside::loop, "'outer loop' first");
        if (corners_in_loop_ < 3)
            fail(
                fmt::format("a facet with {} corner{}; expected at least 3", corners_in_loop_, corners_in_loop_ == 1 ? "" : "s"));
        end_facet();
        inside_ = Inside::facet;
    } else if (is("endfacet")) {
        must_be(Inside::facet, "'endloop' first");
        inside_ = Inside::nothing;
    } else if (is("solid") || is("endsolid")) {
        must_be(Inside::nothing, "'endfacet' first");
        while (*end != '\n') ++end; // its name
    } else if (!is("loop")) {
        fail("expected a word of STL, found " + scan::quoted_word(p));
    }
    return end;
}

void StlReader::read_ascii()
{
    TextBlocks blocks(source_);
    const char *p = nullptr, *end = nullptr;
    while (blocks.next(p, end)) {
        ++line_;
        while (true) {
            p = scan::skip_blanks(p, line_);
            if (*p != '\n') {
                p = word(p);
            } else {
                if (++p >= end) break;
                ++line_;
            }
        }
    }
    if (inside_ != Inside::nothing) fail("the file ends inside a facet");
}

Model StlReader::finish()
{
    if (builder_.face_count() == 0) throw InputError(source_.name(), "holds no triangles");
    Model model;
    model.notes = std::move(notes_);
    build_mesh(builder_, source_, model, most_elements); // loose vertices are corners of facets left out, not something the file lists
    return model;
}

} // namespace

Model read_stl(ByteSource& source)
{
    return StlReader(source).read();
}

} // namespace druse
