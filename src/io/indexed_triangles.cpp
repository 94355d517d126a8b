#include "io/indexed_triangles.h"

#include "dlfl/errors.h"
#include "io/group_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace druse {

/// Each face gives two triangles less than it has corners, or more where edges upon each other are divided.
IndexedTriangles::IndexedTriangles(const ModelView& model, OutputFiles& out, std::string format)
    : mesh_(model.mesh), out_(out), format_(std::move(format)), groups_(groups_in_use(model.mesh, model.groups)), coincident_(model.mesh)
{
    coincident_.note(out);
    ends_.assign(std::max<std::size_t>(groups_.size(), 1), 0);
    std::uint32_t thin = 0;
    for (const Face f : mesh_.faces()) {
        const int n = mesh_.valence(f);
        thin += n < 3;
        if (n > 2) ends_[part_of(f)] += coincident_.concern(f) ? divide(f) : static_cast<std::uint64_t>(n - 2);
    }
    for (std::size_t i = 1; i < ends_.size(); ++i) ends_[i] += ends_[i - 1];
    if (count() == 0) throw InputError(out.name(), "the document holds no face with more than 2 corners");
    if (thin > 0) out.note(fmt::format("{} face{} fewer than 3 corners: not saved in {}", thin, thin == 1 ? " has" : "s have", format_));
}

std::size_t IndexedTriangles::part_of(Face f) const
{
    return groups_.empty() ? 0 : static_cast<std::size_t>(std::ranges::lower_bound(groups_, mesh_.group(f)) - groups_.begin());
}

/// Which point a corner of a divided face is.
std::uint32_t IndexedTriangles::number(Face f, const Point& p)
{
    for (const Corner c : mesh_.corners(f))
        if (mesh_.position(c) == p) return mesh_.vertex(c).index;
    const std::array at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; // of which no vertex is
    const auto [known, is_new] = number_.try_emplace(at, point_count());
    if (is_new) added_.push_back(p);
    return known->second;
}

/// @return how many triangles it has
std::uint64_t IndexedTriangles::divide(Face f)
{
    const auto& triangles = coincident_.triangles(triangulator_.triangles(mesh_, f));
    for (const auto& t : triangles) divided_.push_back({number(f, t[0]), number(f, t[1]), number(f, t[2])});
    divided_ends_.push_back(divided_.size());
    return triangles.size();
}

std::array<float, 3> IndexedTriangles::place(std::uint32_t p) const
{
    const Point& at = point(p);
    const std::array single{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
    for (const float x : single)
        if (!std::isfinite(x))
            throw InputError(out_.name(), fmt::format("vertex {} lies at {},{},{}: too far for the single precision of {}", p, at.x, at.y, at.z, format_));
    return single;
}

void IndexedTriangles::put(unsigned char* to)
{
    std::vector<unsigned char*> next(part_count());
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = to + sizeof(Triangle) * begin(i);
    const auto put_one = [](unsigned char*& at, const Triangle& t) {
        std::memcpy(at, t.data(), sizeof t);
        at += sizeof t;
    };
    auto divided = divided_.begin();
    auto end = divided_ends_.begin();
    for (const Face f : mesh_.faces()) {
        unsigned char*& at = next[part_of(f)];
        if (coincident_.concern(f) && mesh_.valence(f) > 2) {
            for (const auto last = divided_.begin() + static_cast<std::ptrdiff_t>(*end++); divided != last; ++divided) put_one(at, *divided);
            continue;
        }
        for (const auto& t : triangulator_.triangles(mesh_, f)) put_one(at, {mesh_.vertex(t[0]).index, mesh_.vertex(t[1]).index, mesh_.vertex(t[2]).index});
    }
}

} // namespace druse
