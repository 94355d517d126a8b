#include "io/stl.h"

#include "dlfl/errors.h"
#include "dlfl/triangulate.h"
#include "io/coincident_edges.h"
#include "io/require_faces.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace druse {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is written as it lies in memory");

/// Twelve numbers: the normal and three corners.
using Facet = std::array<float, 12>;

class StlWriter {
public:
    StlWriter(const Mesh& mesh, OutputFiles& out) : mesh_(mesh), out_(out), coincident_(mesh) {}
    void write();

private:
    template <class Put> void for_each_triangle(Put&& put_facet);
    Facet facet(Corner a, Corner b, Corner c) const;
    static Facet facet(const std::array<Point, 3>& corners);
    void put_binary(const Facet& facet);
    void put_ascii(const Facet& facet);
    [[noreturn]] void fail_too_far(Corner c) const;

    const Mesh& mesh_;
    OutputFiles& out_;
    CoincidentEdges coincident_;
    std::uint32_t thin_faces_ = 0, flat_facets_ = 0;
};

/// Whether two corners are at one place; what lies along its sides is then joined without it.
bool is_flat(const Facet& f)
{
    const auto same = [&f](std::size_t a, std::size_t b) { return f[a] == f[b] && f[a + 1] == f[b + 1] && f[a + 2] == f[b + 2]; };
    return same(3, 6) || same(6, 9) || same(9, 3);
}

Facet StlWriter::facet(const std::array<Point, 3>& corners)
{
    Facet facet;
    std::size_t at = 3;
    for (const Point& p : corners) {
        facet[at++] = static_cast<float>(p.x);
        facet[at++] = static_cast<float>(p.y);
        facet[at++] = static_cast<float>(p.z);
    }
    // The normal is that of the rounded places: it is those that the file holds.
    const Point p(facet[3], facet[4], facet[5]), q(facet[6], facet[7], facet[8]), r(facet[9], facet[10], facet[11]);
    const Vector normal = unit(glm::cross(q - p, r - p));
    facet[0] = static_cast<float>(normal.x);
    facet[1] = static_cast<float>(normal.y);
    facet[2] = static_cast<float>(normal.z);
    return facet;
}

Facet StlWriter::facet(Corner a, Corner b, Corner c) const
{
    const Facet result = facet({mesh_.position(a), mesh_.position(b), mesh_.position(c)});
    for (std::size_t at = 3; at < 12; ++at)
        if (!std::isfinite(result[at])) [[unlikely]]
            fail_too_far(std::array{a, b, c}[at / 3 - 1]);
    return result;
}

void StlWriter::fail_too_far(Corner c) const
{
    const Point& p = mesh_.position(c);
    throw InputError(out_.name(), fmt::format("vertex {} lies at {},{},{}: too far for the single precision of STL",
                                              mesh_.vertex(c).index, p.x, p.y, p.z));
}

inline void StlWriter::put_binary(const Facet& facet)
{
    static_assert(sizeof facet + 2 == stl_record_size);
    char* const record = out_.main().room(stl_record_size);
    std::memcpy(record, facet.data(), sizeof facet);
    record[48] = record[49] = 0;
    out_.main().use(stl_record_size);
}

void StlWriter::put_ascii(const Facet& facet)
{
    ByteSink& sink = out_.main();
    const auto put_three = [&](std::size_t at) {
        for (std::size_t i = at; i < at + 3; ++i) {
            sink.put(' ');
            sink.put(facet[i]);
        }
        sink.put('\n');
    };
    sink.put(" facet normal");
    put_three(0);
    sink.put("  outer loop\n");
    for (std::size_t at = 3; at < 12; at += 3) {
        sink.put("   vertex");
        put_three(at);
    }
    sink.put("  endloop\n endfacet\n");
}

template <class Put> void StlWriter::for_each_triangle(Put&& put_facet)
{
    Triangulator triangulator;
    bool has_area = false;
    const auto put = [&](const Facet& f) {
        if (is_flat(f)) [[unlikely]] {
            ++flat_facets_;
            return;
        }
        has_area = has_area || f[0] != 0 || f[1] != 0 || f[2] != 0;
        put_facet(f);
    };
    for (const Face f : mesh_.faces()) {
        const Corner a = mesh_.corner(f), b = mesh_.next(a), c = mesh_.next(b);
        if (mesh_.next(c) == a && c != a && coincident_.empty()) {
            put(facet(a, b, c));
            continue;
        }
        const auto& triangles = triangulator.triangles(mesh_, f);
        if (triangles.empty()) ++thin_faces_;
        const bool divided = coincident_.concern(f);
        for (const auto& t : triangles)
            if (const Facet whole = facet(t[0], t[1], t[2]); !divided) put(whole);
        if (divided)
            for (const auto& t : coincident_.triangles(triangles)) put(facet(t));
    }
    if (thin_faces_ == mesh_.face_count()) throw InputError(out_.name(), "the document holds no face with more than 2 corners");
    if (!has_area) throw InputError(out_.name(), "no facet has an area in the single precision of STL");
    if (flat_facets_ > 0)
        out_.note(flat_facets_ == 1 ? "1 facet has corners at one place: not saved in STL" : fmt::format("{} facets have corners at one place: not saved in STL", flat_facets_));
    if (thin_faces_ > 0)
        out_.note(
            fmt::format("{} face{} fewer than 3 corners: not saved in STL", thin_faces_, thin_faces_ == 1 ? " has" : "s have"));
}

void StlWriter::write()
{
    coincident_.note(out_);
    ByteSink& sink = out_.main();
    if (out_.ascii()) {
        sink.put("solid druse\n");
        for_each_triangle([&](const Facet& facet) { put_ascii(facet); });
        sink.put("endsolid druse\n");
        return;
    }
    std::array<char, stl_header_size> header{};
    constexpr std::string_view title = "Druse, binary STL"; // `solid` here would make it ASCII to some readers
    std::memcpy(header.data(), title.data(), title.size());
    sink.put(std::string_view(header.data(), header.size()));
    std::uint32_t count = 0;
    for_each_triangle([&](const Facet& facet) {
        put_binary(facet);
        ++count;
    });
    std::array<char, sizeof count> bytes{};
    std::memcpy(bytes.data(), &count, sizeof count);
    sink.overwrite(80, std::string_view(bytes.data(), bytes.size()));
}

} // namespace

void write_stl(const ModelView& model, OutputFiles& out)
{
    const Mesh& mesh = model.mesh;
    require_faces(model, out, "STL");
    StlWriter(mesh, out).write();
    if (mesh.largest_group() > 0) out.note("groups are not saved in STL");
}

} // namespace druse
