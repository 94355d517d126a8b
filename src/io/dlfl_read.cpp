#include "io/dlfl_file.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_assembler.h"
#include "geom/sort_unique.h"
#include "io/face_colours.h"
#include "io/limits.h"
#include "io/scan.h"
#include "io/text_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace druse {

namespace {

class DlflReader {
public:
    explicit DlflReader(ByteSource& source) : source_(source) {}
    Model read();

private:
    // The parts of TopMod's grammar, each ended by a line with `#`, and what comes after the last of them.
    enum class Part { title, materials, vertices, corners, edges, faces, extension };

    // Each takes the place of a line's first word; what follows the last thing it reads is passed over.
    void line(const char* p);
    void vertex(const char* p);
    void corner(const char* p);
    void edge(const char* p);
    void face(const char* p);
    void extension(const char* p);
    void end_part();

    bool take(const char*& p, std::string_view keyword) const;
    std::uint32_t index(const char*& p, const char* what);
    std::string_view rest_of_line(const char* p) const;
    void make_groups(Model& model);
    Rind make_rind(const Mesh& mesh, std::uint32_t faces_in_file);
    [[noreturn]] void fail(const std::string& what) const { fail(line_, what); }
    [[noreturn]] void fail(long line, const std::string& what) const { throw InputError(source_.name(), line, what); }

    ByteSource& source_;
    long line_ = 0;
    Part part_ = Part::title;
    MeshAssembler assembler_;

    std::string library_;
    FacePaints paints_;
    std::int32_t paint_ = 0;
    std::vector<std::int32_t> face_paints_, groups_;
    bool extended_ = false, has_groups_ = false;
    std::uint32_t unknown_ = 0;

    struct RindLine {
        Rind::Pair pair; // faces as the file counts them
        long line;
    };
    std::vector<RindLine> rind_;
    std::vector<std::uint32_t> open_; // faces that stand for an open boundary
};

bool DlflReader::take(const char*& p, std::string_view keyword) const
{
    const char* const end = scan::end_of_word(p);
    if (std::string_view(p, static_cast<std::size_t>(end - p)) != keyword) return false;
    p = end;
    while (scan::is_blank(*p)) ++p;
    return true;
}

std::string_view DlflReader::rest_of_line(const char* p) const
{
    const char* end = p;
    while (*end != '\n') ++end;
    while (end != p && scan::is_blank(end[-1])) --end;
    return {p, static_cast<std::size_t>(end - p)};
}

std::uint32_t DlflReader::index(const char*& p, const char* what)
{
    std::int64_t value = 0;
    const char* const after = scan::integer(p, value);
    if (!after || !scan::ends_word(*after))
        fail(fmt::format("expected the number of a {}, found {}", what, scan::quoted_word(p)));
    if (value < 0 || value > std::numeric_limits<std::int32_t>::max()) fail(fmt::format("there is no {} {}", what, value));
    p = after;
    while (scan::is_blank(*p)) ++p;
    return static_cast<std::uint32_t>(value);
}

void DlflReader::vertex(const char* p)
{
    if (!take(p, "v")) fail("expected 'v x y z', found " + scan::quoted_word(p));
    Point at;
    for (int i = 0; i < 3; ++i) {
        const char* const after = scan::number(p, at[i]);
        if (!after || !scan::ends_word(*after)) fail("expected a number, found " + scan::quoted_word(p));
        if (!(std::abs(at[i]) <= largest_coordinate))
            fail(fmt::format("coordinate {}: expected at most {} in size", at[i], largest_coordinate));
        p = after;
        while (scan::is_blank(*p)) ++p;
    }
    assembler_.add_vertex(at);
}

void DlflReader::corner(const char* p)
{
    if (!take(p, "fv")) fail("expected 'fv vertex', found " + scan::quoted_word(p));
    assembler_.add_corner(index(p, "vertex")); // normal and texture coordinates are passed over
}

void DlflReader::edge(const char* p)
{
    if (!take(p, "e")) fail("expected 'e corner corner', found " + scan::quoted_word(p));
    const std::uint32_t first = index(p, "corner"), second = index(p, "corner");
    assembler_.add_edge(first, second);
}

void DlflReader::face(const char* p)
{
    if (take(p, "usemtl")) {
        paint_ = paints_.material(rest_of_line(p));
        return;
    }
    if (!take(p, "f")) fail("expected 'f corner corner …', found " + scan::quoted_word(p));
    while (*p != '\n') assembler_.add_to_face(index(p, "corner"));
    assembler_.end_face();
    face_paints_.push_back(paint_);
}

/// What Druse adds where TopMod has stopped to read.
void DlflReader::extension(const char* p)
{
    if (!extended_) {
        if (!take(p, "druse")) return; // something of others
        if (const std::uint32_t version = index(p, "version"); version != 1) fail(fmt::format("druse {}: expected 1", version));
        extended_ = true;
    } else if (take(p, "g")) {
        has_groups_ = true;
        while (*p != '\n') groups_.push_back(static_cast<std::int32_t>(index(p, "group")));
        if (groups_.size() > assembler_.face_count())
            fail(fmt::format("more groups than faces; the file has {}", assembler_.face_count()));
    } else if (take(p, "open")) {
        while (*p != '\n') assembler_.mark_open(open_.emplace_back(index(p, "face")));
    } else if (take(p, "rind")) {
        const std::uint32_t first = index(p, "face"), second = index(p, "face");
        const std::uint32_t first_corner = index(p, "corner"), second_corner = index(p, "corner");
        rind_.push_back({{Face(first), Face(second), first_corner, second_corner}, line_});
    } else if (*p != '#') {
        ++unknown_;
    }
}

void DlflReader::end_part()
{
    if (part_ != Part::extension) part_ = static_cast<Part>(static_cast<int>(part_) + 1);
}

void DlflReader::line(const char* p)
{
    while (scan::is_blank(*p)) ++p;
    if (*p == '\n') return;
    if (*p == '#' && part_ != Part::title && part_ != Part::extension) {
        end_part();
        return;
    }
    switch (part_) {
    case Part::title:
        if (!take(p, "DLFL")) fail("expected 'DLFL', found " + scan::quoted_word(p));
        end_part();
        break;
    case Part::materials:
        if (!take(p, "mtllib")) fail("expected 'mtllib' or '#', found " + scan::quoted_word(p));
        library_ = rest_of_line(p);
        break;
    case Part::vertices:
        vertex(p);
        break;
    case Part::corners:
        corner(p);
        break;
    case Part::edges:
        edge(p);
        break;
    case Part::faces:
        face(p);
        break;
    case Part::extension:
        extension(p);
        break;
    }
}

Model DlflReader::read()
{
    TextBlocks blocks(source_);
    const char *p = nullptr, *end = nullptr;
    try {
        while (blocks.next(p, end))
            while (p < end) {
                ++line_;
                line(p);
                while (*p != '\n') ++p;
                ++p;
            }
    } catch (const CommandError& error) {
        fail(error.what()); // what the assembler found, in this line
    }
    constexpr const char* names[] = {"title", "materials", "vertices", "corners", "edges", "faces"};
    if (part_ != Part::extension) fail(fmt::format("the file ends among its {}", names[static_cast<int>(part_)]));
    if (assembler_.face_count() == 0) throw InputError(source_.name(), "holds no faces");
    if (has_groups_ && groups_.size() != assembler_.face_count())
        throw InputError(source_.name(), fmt::format("{} groups for {} faces", groups_.size(), assembler_.face_count()));

    Model model;
    if (unknown_ > 0) model.notes.push_back(fmt::format("{} line{} passed over", unknown_, unknown_ == 1 ? " was" : "s were"));
    make_groups(model);
    const std::uint32_t faces = assembler_.face_count(); // in the file
    Repairs repairs;
    try {
        model.mesh = assembler_.assemble(groups_, repairs);
    } catch (const CommandError& error) {
        throw InputError(source_.name(), error.what());
    }
    for (std::string& note : repairs.notes()) model.notes.push_back(std::move(note));
    model.rind = make_rind(model.mesh, faces);
    return model;
}

/// The pairs by the ids that faces have in the mesh: those that stand for an open boundary have none.
Rind DlflReader::make_rind(const Mesh& mesh, std::uint32_t faces_in_file)
{
    sort_unique(open_);
    std::vector<bool> paired(mesh.face_limit(), false);
    std::vector<Rind::Pair> pairs;
    for (auto [pair, line] : rind_) {
        for (auto [face, corner] : {std::pair(&pair.first, pair.first_corner), std::pair(&pair.second, pair.second_corner)}) {
            const auto before = std::ranges::lower_bound(open_, face->index);
            if (face->index >= faces_in_file || (before != open_.end() && *before == face->index))
                fail(line, fmt::format("a rind of face {}, which is not there", face->index));
            const std::uint32_t in_file = face->index;
            *face = Face(in_file - static_cast<std::uint32_t>(before - open_.begin()));
            if (const int n = mesh.valence(*face); corner >= static_cast<std::uint32_t>(n))
                fail(line, fmt::format("face {} has corners 0 to {}, not {}", in_file, n - 1, corner));
            if (paired[face->index]) fail(line, fmt::format("face {} is in the rind twice", in_file));
            paired[face->index] = true;
        }
        if (mesh.valence(pair.first) != mesh.valence(pair.second))
            fail(line, fmt::format("faces of a rind with {} and {} sides", mesh.valence(pair.first), mesh.valence(pair.second)));
        pairs.push_back(pair);
    }
    return Rind(mesh, pairs);
}

void DlflReader::make_groups(Model& model)
{
    Materials materials;
    if (!library_.empty()) materials.read_library(source_, library_);
    for (std::string& note : materials.notes()) model.notes.push_back(std::move(note));
    if (has_groups_) {
        paints_.colour_groups(face_paints_, groups_, materials, model.groups);
    } else {
        groups_ = face_paints_;
        paints_.to_groups(groups_, materials, model.groups);
    }
}

} // namespace

Model read_dlfl(ByteSource& source)
{
    return DlflReader(source).read();
}

} // namespace druse
