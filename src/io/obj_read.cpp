#include "io/obj.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/face_colours.h"
#include "io/limits.h"
#include "io/scan.h"
#include "io/text_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace druse {

namespace {

/// Numbers of elements that come later in the file, or never.
class Announced {
public:
    struct Record {
        std::int64_t number;
        long line;
        const char* by; // `face`, `line` or `point`
    };
    void see(const Record& record)
    {
        if (records_.empty() || record.number > records_.back().number) records_.push_back(record);
    }
    /// The first place that names one beyond `count`.
    const Record* first_beyond(std::int64_t count) const
    {
        const auto found = std::upper_bound(records_.begin(), records_.end(), count,
                                            [](std::int64_t n, const Record& r) { return n < r.number; });
        return found == records_.end() ? nullptr : &*found;
    }

private:
    std::vector<Record> records_; // ascending
};

class ObjReader {
public:
    explicit ObjReader(ByteSource& source) : source_(source) {}
    Model read();

private:
    // Each takes the place after the keyword and hands back one in the rest of the line.
    const char* vertex(const char* p);
    const char* face(const char* p);
    const char* polyline(const char* p);
    const char* points(const char* p);
    const char* colour(const char* p);
    const char* other(const char* p);

    const char* coordinate(const char* p, double& value);
    const char* corner(const char* p, std::uint32_t& v);
    const char* corner_in_full(const char* p, std::uint32_t& v);
    const char* element(const char* p, std::int64_t count, Announced& announced, const char* what, std::uint32_t& index);
    void keep_vertex_colour(const double* rgb);
    std::string_view rest_of_line(const char* p) const;
    void read_block(const char* p, const char* end);
    const char* skip_rest(const char* p, const char* end);

    void check_announced(const Announced& announced, std::int64_t count, const char* what) const;
    void make_groups(Model& model);
    void make_graph(Model& model);
    std::uint32_t count_on_lines_only() const;
    [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.name(), line_, what); }

    ByteSource& source_;
    long line_ = 0;
    const char* named_by_ = ""; // what is being read
    MeshBuilder builder_;
    std::int64_t texture_count_ = 0, normal_count_ = 0;
    Announced announced_, announced_textures_, announced_normals_;

    FacePaints paints_;
    std::int32_t paint_ = 0;
    std::vector<std::string> libraries_;
    std::set<std::string> libraries_met_; // some writers name theirs before every object
    Column<Vector> vertex_colours_;       // as long as there are vertices, or empty; no number where a vertex has none
    double brightest_ = 0;

    std::vector<std::uint32_t> polygon_;
    std::vector<std::array<std::uint32_t, 2>> lines_;
    std::uint64_t unknown_ = 0;
    std::string first_unknown_;
};

std::string_view ObjReader::rest_of_line(const char* p) const
{
    while (scan::is_blank(*p)) ++p;
    const char* end = p;
    while (*end != '\n') ++end;
    while (end != p && scan::is_blank(end[-1])) --end;
    return {p, static_cast<std::size_t>(end - p)};
}

inline const char* ObjReader::coordinate(const char* p, double& value)
{
    const char* after = scan::number(p, value);
    if (!after || !(scan::ends_word(*after) || *after == '\\')) fail("expected a number, found " + scan::quoted_word(p));
    return after;
}

const char* ObjReader::vertex(const char* p)
{
    double x[7];
    int n = 0;
    for (p = scan::skip_blanks(p, line_); *p != '\n' && *p != '#'; p = scan::skip_blanks(p, line_)) {
        if (n == 7) fail("a vertex with more than 7 numbers; expected x y z, an optional w, and an optional colour r g b");
        p = coordinate(p, x[n++]);
    }
    if (n != 3 && n != 4 && n != 6 && n != 7)
        fail(fmt::format("a vertex with {} numbers; expected x y z, an optional w, and an optional colour r g b", n));
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(x[i]) <= largest_coordinate))
            fail(fmt::format("coordinate {}: expected at most {} in size", x[i], largest_coordinate));
    builder_.add_vertex({x[0], x[1], x[2]});
    if (n >= 6)
        keep_vertex_colour(x + n - 3);
    else if (vertex_colours_.size() > 0)
        vertex_colours_.push_back(Vector(std::numeric_limits<double>::quiet_NaN()));
    return p;
}

void ObjReader::keep_vertex_colour(const double* rgb)
{
    if (vertex_colours_.size() == 0)
        std::fill_n(vertex_colours_.extend(builder_.vertex_count() - 1), builder_.vertex_count() - 1,
                    Vector(std::numeric_limits<double>::quiet_NaN()));
    for (int i = 0; i < 3; ++i) {
        if (!(rgb[i] >= 0 && rgb[i] <= 255)) fail(fmt::format("vertex colour {}: expected 0 to 1", rgb[i]));
        brightest_ = std::max(brightest_, rgb[i]);
    }
    vertex_colours_.push_back({rgb[0], rgb[1], rgb[2]});
}

/// A vertex, texture or normal number as faces write it: from 1 up, or from −1 down for the last ones so far.
const char* ObjReader::element(const char* p, std::int64_t count, Announced& announced, const char* what, std::uint32_t& index)
{
    std::int64_t number = 0;
    const char* after = scan::integer(p, number);
    if (!after || !(scan::ends_word(*after) || *after == '/' || *after == '\\'))
        fail(fmt::format("expected a {} number, found {}", what, scan::quoted_word(p)));
    if (number > 0) {
        if (number > count) announced.see({number, line_, named_by_});
        index = number <= Vertex::none ? static_cast<std::uint32_t>(number - 1) : Vertex::none; // which none will be
    } else if (number < 0 && number >= -count) {
        index = static_cast<std::uint32_t>(count + number);
    } else {
        fail(number == 0 ? fmt::format("{} names {} 0; they count from 1", named_by_, what)
                         : fmt::format("{} names {} {}, but only {} came before", named_by_, what, number, count));
    }
    return after;
}

/// One entry of a face: `v`, `v/t`, `v//n` or `v/t/n`.
inline const char* ObjReader::corner(const char* p, std::uint32_t& v)
{
    std::int64_t number = 0;
    const char* after = scan::integer(p, number);
    if (after && scan::ends_word(*after) && number > 0 && number <= builder_.vertex_count()) [[likely]] {
        v = static_cast<std::uint32_t>(number - 1);
        return after;
    }
    return corner_in_full(p, v);
}

const char* ObjReader::corner_in_full(const char* p, std::uint32_t& v)
{
    p = element(p, builder_.vertex_count(), announced_, "vertex", v);
    if (*p != '/') return p;
    std::uint32_t ignored = 0;
    ++p;
    if (*p != '/' && !scan::ends_word(*p)) p = element(p, texture_count_, announced_textures_, "texture coordinate", ignored);
    if (*p != '/') return p;
    ++p;
    if (!scan::ends_word(*p)) p = element(p, normal_count_, announced_normals_, "normal", ignored);
    if (*p == '/') fail("a corner with more than three parts; expected vertex/texture/normal");
    return p;
}

const char* ObjReader::face(const char* p)
{
    polygon_.clear();
    named_by_ = "face";
    std::uint32_t v = 0;
    for (p = scan::skip_blanks(p, line_); *p != '\n' && *p != '#'; p = scan::skip_blanks(p, line_)) {
        p = corner(p, v);
        polygon_.push_back(v);
    }
    if (polygon_.size() < 3)
        fail(fmt::format("a face with {} corner{}; expected at least 3", polygon_.size(), polygon_.size() == 1 ? "" : "s"));
    builder_.add_face(polygon_, paint_);
    return p;
}

const char* ObjReader::polyline(const char* p)
{
    int entries = 0;
    named_by_ = "line";
    std::uint32_t before = 0, v = 0;
    for (p = scan::skip_blanks(p, line_); *p != '\n' && *p != '#'; p = scan::skip_blanks(p, line_)) {
        p = corner(p, v);
        if (entries > 0 && v == before && v != Vertex::none) fail(fmt::format("a line from vertex {} to itself", std::int64_t(v) + 1));
        if (entries > 0) lines_.push_back({before, v});
        before = v;
        if (entries < 2) ++entries;
    }
    if (entries < 2) fail(fmt::format("a line with {} point{}; expected at least 2", entries, entries == 1 ? "" : "s"));
    return p;
}

const char* ObjReader::points(const char* p)
{
    named_by_ = "point";
    std::uint32_t v = 0;
    for (p = scan::skip_blanks(p, line_); *p != '\n' && *p != '#'; p = scan::skip_blanks(p, line_)) {
        p = corner(p, v);
        builder_.add_corner(v);
        builder_.end_face(paint_);
    }
    return p;
}

/// TopMod's colour of the faces that follow.
const char* ObjReader::colour(const char* p)
{
    double rgb[3] = {};
    for (double& channel : rgb) {
        p = coordinate(scan::skip_blanks(p, line_), channel);
        if (!(channel >= 0 && channel <= 1)) fail(fmt::format("colour {}: expected 0 to 1", channel));
    }
    paint_ = paints_.colour(colour_from_unit(rgb[0], rgb[1], rgb[2]));
    return p;
}

const char* ObjReader::other(const char* p)
{
    const char* const end = scan::end_of_word(p);
    const std::string_view word(p, static_cast<std::size_t>(end - p));
    if (word == "vt") {
        ++texture_count_;
    } else if (word == "vn") {
        ++normal_count_;
    } else if (word == "usemtl") {
        paint_ = paints_.material(rest_of_line(end));
    } else if (word == "mtllib") {
        if (const std::string_view names = rest_of_line(end); !names.empty() && libraries_met_.emplace(names).second)
            libraries_.emplace_back(names);
    } else if (word != "o" && word != "g" && word != "s" && word != "vp") {
        if (unknown_++ == 0) first_unknown_ = fmt::format("{} in line {}", scan::quoted_word(p), line_);
    }
    return end;
}

void ObjReader::read_block(const char* p, const char* const end)
{
    while (p < end) {
        ++line_;
        p = scan::skip_blanks(p, line_);
        const bool keyword_of_one = *p == '\n' || scan::ends_word(p[1]) || p[1] == '\\';
        switch (keyword_of_one ? *p : '?') {
        case 'v':
            p = vertex(p + 1);
            break;
        case 'f':
            p = face(p + 1);
            break;
        case 'l':
            p = polyline(p + 1);
            break;
        case 'p':
            p = points(p + 1);
            break;
        case 'c':
            p = colour(p + 1);
            break;
        case '\n':
            break;
        default:
            if (*p != '#') p = other(p);
        }
        if (*p != '\n') p = skip_rest(p, end);
        ++p;
    }
}

/// The end of the line. One that goes on after a backslash is followed, but not a comment: that may end in the name of a folder.
const char* ObjReader::skip_rest(const char* p, const char* const end)
{
    const bool comment = *p == '#';
    while (true) {
        p = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end + 1 - p)));
        const char* before = p[-1] == '\r' ? p - 2 : p - 1;
        if (comment || *before != '\\' || p == end) return p;
        ++line_;
        ++p;
    }
}

Model ObjReader::read()
{
    TextBlocks blocks(source_);
    const char *begin = nullptr, *end = nullptr;
    while (blocks.next(begin, end)) {
        if (static_cast<std::uint64_t>(end - begin) + builder_.corner_count() > most_elements)
            throw InputError(source_.name(), fmt::format("more than {} corners", most_elements));
        read_block(begin, end);
    }
    check_announced(announced_, builder_.vertex_count(), "vertex");
    check_announced(announced_textures_, texture_count_, "texture coordinate");
    check_announced(announced_normals_, normal_count_, "normal");
    if (builder_.face_count() == 0 && lines_.empty()) throw InputError(source_.name(), "holds no faces, lines or points");

    Model model;
    if (unknown_ > 0)
        model.notes.push_back(
            fmt::format("{} line{} passed over, first {}", unknown_, unknown_ == 1 ? " was" : "s were", first_unknown_));
    make_groups(model);
    if (!lines_.empty()) make_graph(model);

    build_mesh(builder_, source_, model, lines_.empty() ? 0 : count_on_lines_only());
    return model;
}

void ObjReader::check_announced(const Announced& announced, std::int64_t count, const char* what) const
{
    if (const auto* record = announced.first_beyond(count))
        throw InputError(source_.name(), record->line,
                         fmt::format("{} names {} {}, the file has {}", record->by, what, record->number, count));
}

void ObjReader::make_groups(Model& model)
{
    Materials materials;
    for (const std::string& names : libraries_) materials.read_library(source_, names);
    for (std::string& note : materials.notes()) model.notes.push_back(std::move(note));
    if (paints_.to_groups(builder_.groups(), materials, model.groups) || vertex_colours_.size() == 0) return;
    if (brightest_ > 1) {
        for (std::uint32_t v = 0; v < vertex_colours_.size(); ++v) vertex_colours_.set(v, vertex_colours_[v] / 255.0);
        model.notes.push_back("vertex colours go beyond 1: read as 0 to 255");
    }
    groups_from_vertex_colours(builder_.corners(), builder_.face_ends(), vertex_colours_.view(), builder_.groups(), model.groups);
}

void ObjReader::make_graph(Model& model)
{
    std::vector<std::uint32_t> number(builder_.vertex_count(), Vertex::none);
    for (const auto& line : lines_)
        for (const std::uint32_t v : line) number[v] = 0;
    model.graph.emplace();
    for (std::uint32_t v = 0; v < number.size(); ++v)
        if (number[v] == 0) {
            number[v] = static_cast<std::uint32_t>(model.graph->vertices.size());
            model.graph->vertices.push_back(builder_.position(v));
        }
    for (const auto& [a, b] : lines_) model.graph->edges.push_back({number[a], number[b]});
}

/// Vertices that the graph has and the mesh has not: they are not left out.
std::uint32_t ObjReader::count_on_lines_only() const
{
    std::vector<bool> counts(builder_.vertex_count(), false);
    for (const auto& [a, b] : lines_) counts[a] = counts[b] = true;
    for (const Vertex v : builder_.corners()) counts[v.index] = false;
    return static_cast<std::uint32_t>(std::count(counts.begin(), counts.end(), true));
}

} // namespace

Model read_obj(ByteSource& source)
{
    return ObjReader(source).read();
}

} // namespace druse
