#pragma once

#include "pane/pane.h"
#include "pane/pane_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace druse {

using Reason = PaneRefusal::Reason;
using IdTriangle = std::array<std::uint32_t, 3>;

/// The triangles by ids, the smallest id first in each, sorted.
inline std::vector<IdTriangle> triangles(const Pane& pane)
{
    std::vector<IdTriangle> found;
    pane.for_triangles([&](PointId a, PointId b, PointId c) {
        IdTriangle t{std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        found.push_back(t);
    });
    std::sort(found.begin(), found.end());
    return found;
}

inline bool has_edge(const Pane& pane, std::uint32_t a, std::uint32_t b)
{
    return pane.triangulation().find_side(pane.vertex(PointId(a)), pane.vertex(PointId(b))) != Pane::none;
}

/// Twice the area of the triangles, and of the loops, without rounding.
inline std::pair<mpq_class, mpq_class> double_areas(const Pane& pane)
{
    const auto cross = [&](PointId a, PointId b) -> mpq_class {
        const Point2 &p = pane.position(a), &q = pane.position(b);
        return mpq_class(p.x) * mpq_class(q.y) - mpq_class(p.y) * mpq_class(q.x);
    };
    std::pair<mpq_class, mpq_class> area;
    pane.for_triangles([&](PointId a, PointId b, PointId c) { area.first += cross(a, b) + cross(b, c) + cross(c, a); });
    for (std::size_t i = 0; i <= pane.hole_count(); ++i) {
        const auto loop = pane.loop(i);
        for (std::size_t k = 0; k < loop.size(); ++k) area.second += cross(loop[k], loop[(k + 1) % loop.size()]);
    }
    return area;
}

/// The triangles of a pane built anew from the points, loops and pieces of this one, in another order; by this one's ids.
inline std::vector<IdTriangle> triangles_built_anew(const Pane& pane, std::mt19937& random)
{
    std::vector<std::uint32_t> ids; // by id of the new pane
    std::vector<std::vector<Point2>> loops;
    for (std::size_t i = 0; i <= pane.hole_count(); ++i) {
        loops.emplace_back();
        for (const PointId p : pane.loop(i)) {
            loops.back().push_back(pane.position(p));
            ids.push_back(std::uint32_t(p));
        }
    }
    Pane fresh(loops[0], std::span(loops).subspan(1), {0.0, pane.weld()});
    std::vector<PointId> inner;
    for (const PointId p : pane.points())
        if (pane.kind(p) != PointKind::boundary) inner.push_back(p);
    std::shuffle(inner.begin(), inner.end(), random);
    for (const PointId p : inner) {
        fresh.add(pane.position(p), {}, true);
        ids.push_back(std::uint32_t(p));
    }
    std::vector<std::uint32_t> here(std::size_t(pane.next_point()));
    for (std::uint32_t i = 0; i < ids.size(); ++i) here[ids[i]] = i;
    std::vector<std::array<PointId, 2>> pieces;
    for (const SegmentId s : pane.segments()) {
        const auto chain = pane.chain(s);
        for (std::size_t i = 1; i < chain.size(); ++i) pieces.push_back({PointId(here[std::uint32_t(chain[i - 1])]), PointId(here[std::uint32_t(chain[i])])});
    }
    std::shuffle(pieces.begin(), pieces.end(), random);
    for (const auto& piece : pieces) fresh.constrain(piece);
    EXPECT_EQ(fresh.point_count(), pane.point_count());
    auto found = triangles(fresh);
    for (IdTriangle& t : found) {
        for (std::uint32_t& i : t) i = ids[i];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// All invariants of a pane that one state shows.
inline void expect_sound(const Pane& pane)
{
    EXPECT_EQ(check(pane).faults, std::vector<std::string>());
    const auto [area, of_loops] = double_areas(pane);
    EXPECT_EQ(area, of_loops);
}

/// The edit is refused for this reason, and every byte stays.
template <class Edit>
void expect_refused(Pane& pane, Reason reason, Edit&& edit)
{
    const auto before = pane.fingerprint();
    try {
        edit();
        ADD_FAILURE() << "not refused: " << name(reason);
    } catch (const PaneRefusal& refusal) {
        EXPECT_STREQ(name(refusal.reason()), name(reason)) << refusal.what();
        EXPECT_EQ(std::string(refusal.what()).find('\n'), std::string::npos);
    }
    EXPECT_EQ(pane.fingerprint(), before);
}

inline std::vector<Point2> rectangle(double width, double height) { return {{0, 0}, {width, 0}, {width, height}, {0, height}}; }

} // namespace druse
