#include "tile/tile_stack.h"

#include "geom/turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace druse {

namespace {

constexpr double near_whole = 1e-9; // of coordinates in a lattice that are whole but for rounding

double off_whole(double x) { return std::abs(x - std::round(x)); }
bool is_whole(const Point2& p) { return off_whole(p.x) < near_whole && off_whole(p.y) < near_whole; }
Point2 combine(const std::array<Point2, 2>& basis, const Point2& c) { return c.x * basis[0] + c.y * basis[1]; }

/// a · c ≡ b modulo 1, for the coordinates c of an offset.
struct Congruence {
    std::array<std::int64_t, 2> a{};
    double b = 0;
};

/// Congruences after whole changes of rows and columns, until only the diagonal is left: c = change · y, a[i][i] y[i] ≡ b[i].
struct SmithForm {
    std::vector<Congruence> rows;
    std::array<std::array<std::int64_t, 2>, 2> change{{{1, 0}, {0, 1}}}; // by column

    explicit SmithForm(std::vector<Congruence> given) : rows(std::move(given))
    {
        while (rows.size() < 2) rows.emplace_back();
        for (std::size_t k = 0; k < 2; ++k)
            while (take_least(k) && !clear(k)) {}
    }

private:
    /// Brings the least entry to the diagonal; false: all that is left is 0.
    bool take_least(std::size_t k)
    {
        std::size_t row = 0, column = 0;
        std::int64_t least = 0;
        for (std::size_t i = k; i < rows.size(); ++i)
            for (std::size_t j = k; j < 2; ++j) {
                const std::int64_t size = std::abs(rows[i].a[j]);
                if (size == 0 || (least != 0 && size >= least)) continue;
                least = size;
                row = i;
                column = j;
            }
        if (least == 0) return false;
        std::swap(rows[k], rows[row]);
        if (column != k) {
            for (Congruence& r : rows) std::swap(r.a[k], r.a[column]);
            std::swap(change[k], change[column]);
        }
        return true;
    }
    /// Subtracts the row and the column of the diagonal from the others; false: something is left of them.
    bool clear(std::size_t k)
    {
        bool clean = true;
        for (std::size_t i = k + 1; i < rows.size(); ++i) {
            const std::int64_t times = rows[i].a[k] / rows[k].a[k];
            for (std::size_t j = k; j < 2; ++j) rows[i].a[j] -= times * rows[k].a[j];
            rows[i].b -= double(times) * rows[k].b;
            clean = clean && rows[i].a[k] == 0;
        }
        for (std::size_t j = k + 1; j < 2; ++j) {
            const std::int64_t times = rows[k].a[j] / rows[k].a[k];
            for (Congruence& r : rows) r.a[j] -= times * r.a[k];
            for (std::size_t i = 0; i < 2; ++i) change[j][i] -= times * change[k][i];
            clean = clean && rows[k].a[j] == 0;
        }
        return clean;
    }
};

/// The offset nearest to one that is asked for; of several that are as near, that which goes farthest the same way, then to the right, then up.
class NearestOffset {
public:
    NearestOffset(const Point2& wanted, double tie) : wanted_(wanted), tie_(tie) {}

    void look_at(const Point2& p)
    {
        const double distance = glm::length(wanted_ - p);
        if (distance > least_ + tie_) return;
        if (distance > least_ - tie_ && !goes_farther(p)) return;
        least_ = distance;
        best_ = p;
    }
    const Point2& best() const { return best_; }

private:
    bool goes_farther(const Point2& p) const
    {
        const double along = glm::dot(p - best_, wanted_) / std::max(glm::length(wanted_), tie_);
        if (std::abs(along) > tie_) return along > 0;
        if (std::abs(p.x - best_.x) > tie_) return p.x > best_.x;
        return p.y > best_.y + tie_;
    }

    Point2 wanted_, best_{0.0};
    double tie_, least_ = std::numeric_limits<double>::infinity();
};

std::array<Point2, 2> shortest_basis(std::array<Point2, 2> basis)
{
    for (int round = 0; round < 64; ++round) {
        if (glm::dot(basis[1], basis[1]) < glm::dot(basis[0], basis[0])) std::swap(basis[0], basis[1]);
        const double times = std::round(glm::dot(basis[0], basis[1]) / glm::dot(basis[0], basis[0]));
        if (times == 0) break;
        basis[1] -= times * basis[0];
    }
    return basis;
}

} // namespace

Isometry stack_motion(const TileStack& stack)
{
    Isometry motion;
    if (stack.mode == TileStack::Mode::mirror) {
        const Point2 t = turn_by_degrees(2 * stack.axis);
        motion.x = t;
        motion.y = {t.y, -t.x};
    }
    if (stack.mode != TileStack::Mode::column) motion.shift = stack.offset;
    return motion;
}

Point2 lattice_coordinates(const std::array<Point2, 2>& lattice, const Point2& v)
{
    const auto cross = [](const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; };
    const double det = cross(lattice[0], lattice[1]);
    return {cross(v, lattice[1]) / det, cross(lattice[0], v) / det};
}

IsohedralOffsets::IsohedralOffsets(std::span<const Isometry> aspects, const std::array<Point2, 2>& lattice, const Isometry& linear)
{
    Isometry s = linear;
    s.shift = Point2(0.0);
    for (const Point2& t : lattice) any_ = any_ && is_whole(lattice_coordinates(lattice, turned(s, t)));
    if (!any_) return;

    std::vector<Congruence> rows;
    for (const Isometry& g : aspects) {
        const Isometry there = s * g * inverse(s);
        const auto same = std::ranges::find_if(aspects, [&](const Isometry& other) {
            return glm::length(other.x - there.x) < near_whole && glm::length(other.y - there.y) < near_whole;
        });
        if (same == aspects.end()) {
            any_ = false;
            return;
        }
        Congruence first, second;
        for (std::size_t j = 0; j < 2; ++j) {
            const Point2 column = lattice_coordinates(lattice, lattice[j] - turned(there, lattice[j]));
            first.a[j] = std::llround(column.x);
            second.a[j] = std::llround(column.y);
        }
        const Point2 b = lattice_coordinates(lattice, same->shift - turned(s, g.shift));
        first.b = b.x;
        second.b = b.y;
        rows.push_back(first);
        rows.push_back(second);
    }

    const SmithForm form(std::move(rows));
    std::array<std::int64_t, 2> d{};
    for (std::size_t i = 0; i < form.rows.size(); ++i) {
        if (i < 2) d[i] = std::abs(form.rows[i].a[i]);
        if ((i >= 2 || d[i] == 0) && off_whole(form.rows[i].b) > 1e3 * near_whole) any_ = false;
    }
    if (!any_) return;
    freedom_ = static_cast<int>(std::ranges::count(d, 0));
    std::array<Point2, 2> changed;
    for (std::size_t j = 0; j < 2; ++j) changed[j] = combine(lattice, Point2(form.change[j][0], form.change[j][1]));
    basis_ = freedom_ == 1 ? changed : shortest_basis(lattice);
    const auto solutions = [&](std::size_t i) {
        std::vector<double> list;
        const std::int64_t divisor = form.rows[i].a[i];
        for (std::int64_t n = 0; n < std::max<std::int64_t>(d[i], 1); ++n) list.push_back(divisor == 0 ? 0.0 : (form.rows[i].b + double(n)) / double(divisor));
        return list;
    };
    for (const double x : solutions(0))
        for (const double y : solutions(1)) starts_.push_back(combine(changed, {x, y}));
}

Point2 IsohedralOffsets::nearest(const Point2& offset) const
{
    if (freedom_ == 2) return offset;
    NearestOffset nearest(offset, near_whole * glm::length(basis_[1]));
    for (const Point2& start : starts_) {
        if (freedom_ == 0) {
            // One of the points of the lattice around, as its basis is reduced.
            const Point2 c = lattice_coordinates(basis_, offset - start), about(std::round(c.x), std::round(c.y));
            for (int i = -1; i <= 1; ++i)
                for (int j = -1; j <= 1; ++j) nearest.look_at(start + combine(basis_, about + Point2(i, j)));
        } else {
            // On one of the lines that the lattice makes of this one.
            const Point2 along = glm::normalize(basis_[1]), across(-along.y, along.x);
            const double period = glm::dot(basis_[0], across), times = glm::dot(offset - start, across) / period;
            for (const double line : {std::floor(times), std::ceil(times)})
                nearest.look_at(start + line * period * across + glm::dot(offset - start, along) * along);
        }
    }
    return nearest.best();
}

std::string not_isohedral_text(const std::string& type, std::span<const Isometry> aspects, const std::array<Point2, 2>& lattice, const TileStack& stack)
{
    const auto number = [&](double x) { return std::abs(x) < 1e-12 * glm::length(lattice[0]) ? std::string("0") : fmt::format("{:.9g}", x); };
    const IsohedralOffsets offsets(aspects, lattice, stack_motion(stack));
    if (offsets.any()) {
        const Point2 nearest = offsets.nearest(stack.offset);
        return fmt::format("offset {},{} of {}: the nearest that is isohedral is {},{}", number(stack.offset.x), number(stack.offset.y), type, number(nearest.x),
                           number(nearest.y));
    }
    std::string axes;
    for (int axis = 0; axis < 180; axis += 15) {
        TileStack other = stack;
        other.axis = axis;
        if (IsohedralOffsets(aspects, lattice, stack_motion(other)).any()) axes += fmt::format("{}{}", axes.empty() ? "" : ", ", axis);
    }
    return axes.empty() ? fmt::format("no mirror image of {} with these parameters has its symmetry", type)
                        : fmt::format("axis {} of {}: expected {}", number(stack.axis), type, axes);
}

std::vector<int> stack_members(std::span<const Isometry> aspects, const std::array<Point2, 2>& lattice, const TileStack& stack)
{
    std::vector<int> member(aspects.size(), 0);
    if (stack.mode != TileStack::Mode::free) return member;
    // Tiles g and g′ have the same bottom where the shift carries g g′⁻¹ into the group.
    std::vector<std::size_t> first;
    for (std::size_t a = 0; a < aspects.size(); ++a) {
        const auto same = std::ranges::find_if(first, [&](std::size_t b) {
            const Point2 moved = stack.offset - turned(aspects[a] * inverse(aspects[b]), stack.offset);
            return is_whole(lattice_coordinates(lattice, moved));
        });
        member[a] = static_cast<int>(same - first.begin());
        if (same == first.end()) first.push_back(a);
    }
    return member;
}

} // namespace druse
