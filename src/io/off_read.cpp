#include "io/off.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "io/build_mesh.h"
#include "io/face_colours.h"
#include "io/limits.h"
#include "io/text_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

namespace druse {

namespace {

class OffReader {
public:
    explicit OffReader(ByteSource& source) : source_(source), lines_(source, true) {}
    Model read();

private:
    void keyword();
    std::uint64_t count(const char* what);
    void counts();
    void vertex();
    void face();
    std::optional<Vector> colour(int passed_over_behind);
    [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

    ByteSource& source_;
    TextLines lines_;
    MeshBuilder builder_;
    bool has_normals_ = false, has_texture_ = false;
    std::uint64_t vertex_count_ = 0, face_count_ = 0;
    ColourNumbers colours_;         // of faces
    Column<Vector> vertex_colours_; // as long as there are vertices, or empty; no number where a vertex has none
};

/// The first word, which may be missing: letters for what vertices have besides a place, and OFF.
void OffReader::keyword()
{
    if (!lines_.next_line_of_words()) throw InputError(source_.name(), "holds nothing");
    std::string_view word = lines_.word();
    const char* const begin = word.data();
    if (scan::is_digit(*begin) && !word.ends_with("OFF")) return;
    const auto take = [&](std::string_view prefix) {
        if (!word.starts_with(prefix)) return false;
        word.remove_prefix(prefix.size());
        return true;
    };
    has_texture_ = take("ST");
    take("C"); // colours show themselves
    has_normals_ = take("N");
    if (take("4") || take("n")) fail(fmt::format("{}: expected vertices in three dimensions", scan::quoted_word(begin)));
    if (word != "OFF") fail(fmt::format("expected OFF, found {}", scan::quoted_word(begin)));
    lines_.pass_over();
    if (lines_.word() == "BINARY") fail("a binary file; expected one in text");
    if (lines_.at_end() && !lines_.next_line_of_words()) throw InputError(source_.name(), "ends before its counts");
}

std::uint64_t OffReader::count(const char* what)
{
    const double value = lines_.number();
    if (!(value >= 0 && value <= double(most_elements) && value == std::trunc(value)))
        fail(fmt::format("{} {}; expected 0 to {}", value, what, most_elements));
    return static_cast<std::uint64_t>(value);
}

void OffReader::counts()
{
    vertex_count_ = count("vertices");
    face_count_ = count("faces"); // that of edges says nothing new
    if (face_count_ == 0) throw InputError(source_.name(), "holds no faces");
}

/// The colour in the rest of a line, 0 to 1 a channel, if there is one.
std::optional<Vector> OffReader::colour(int passed_over_behind)
{
    double value[6];
    int n = 0;
    bool whole = true;
    for (; !lines_.at_end(); ++n) {
        if (n == 6) fail("a colour with more than 4 numbers");
        whole = whole && lines_.word().find_first_of(".eE") == std::string_view::npos;
        value[n] = lines_.number();
    }
    n -= passed_over_behind;
    if (n <= 1) return std::nullopt;
    if (n != 3 && n != 4) fail(fmt::format("a colour with {} numbers; expected 3 or 4", n));
    // Geomview writes full channels as 1: then so is the opacity, which is hardly ever meant to be 1 of 255.
    double largest = 0;
    for (int i = 0; i < n; ++i) largest = std::max(largest, value[i]);
    const double most = whole && !(n == 4 && largest <= 1) ? 255 : 1;
    for (int i = 0; i < n; ++i)
        if (!(value[i] >= 0 && value[i] <= most)) fail(fmt::format("colour {}: expected 0 to {}", value[i], most));
    return Vector(value[0], value[1], value[2]) / most;
}

void OffReader::vertex()
{
    Point p;
    for (int i = 0; i < 3; ++i) {
        p[i] = lines_.number();
        if (!(std::abs(p[i]) <= largest_coordinate))
            fail(fmt::format("coordinate {}: expected at most {} in size", p[i], largest_coordinate));
    }
    builder_.add_vertex(p);
    if (has_normals_)
        for (int i = 0; i < 3; ++i) lines_.number();
    const std::optional<Vector> its = colour(has_texture_ ? 2 : 0);
    const Vector none(std::numeric_limits<double>::quiet_NaN());
    if (its && vertex_colours_.size() == 0)
        for (std::uint32_t v = 1; v < builder_.vertex_count(); ++v) vertex_colours_.push_back(none);
    if (its || vertex_colours_.size() > 0) vertex_colours_.push_back(its.value_or(none));
}

void OffReader::face()
{
    const std::uint64_t valence = count("corners");
    if (valence == 0 || valence == 2) fail(fmt::format("a face with {} corners; expected at least 3", valence));
    if (builder_.corner_count() + valence > most_elements) fail(fmt::format("more than {} corners", most_elements));
    for (std::uint64_t i = 0; i < valence; ++i) {
        const double v = lines_.number();
        if (!(v >= 0 && v < double(vertex_count_) && v == std::trunc(v)))
            fail(fmt::format("face names vertex {}, the file has {}", v, vertex_count_));
        builder_.add_corner(static_cast<std::uint32_t>(v));
    }
    const std::optional<Vector> its = colour(0);
    builder_.end_face(its ? colours_.number(colour_from_unit(its->x, its->y, its->z)) : 0);
}

Model OffReader::read()
{
    keyword();
    counts();
    const auto line = [&](const char* what, std::uint64_t i, std::uint64_t count) {
        if (!lines_.next_line_of_words())
            throw InputError(source_.name(), fmt::format("ends in {} {} of {}", what, i + 1, count));
    };
    for (std::uint64_t i = 0; i < vertex_count_; ++i) {
        line("vertex", i, vertex_count_);
        vertex();
    }
    for (std::uint64_t i = 0; i < face_count_; ++i) {
        line("face", i, face_count_);
        face();
    }
    Model model;
    if (lines_.next_line_of_words()) model.notes.push_back("there is more after the last face: passed over");
    if (!colours_.colours().empty()) {
        int id = 0;
        for (const Colour c : colours_.colours()) model.groups.set_colour(++id, c);
    } else if (vertex_colours_.size() > 0) {
        groups_from_vertex_colours(builder_.corners(), builder_.face_ends(), vertex_colours_.view(), builder_.groups(),
                                   model.groups);
    }
    build_mesh(builder_, source_, model);
    return model;
}

} // namespace

Model read_off(ByteSource& source)
{
    return OffReader(source).read();
}

} // namespace druse
