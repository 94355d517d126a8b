#include "tile/plane_group.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace druse {

namespace {

// Of lengths, at the default corners, where edges are about 1 and all numbers are sums of a few square roots.
constexpr double least_step = 1e-9;
constexpr double same_length = 1e-7;

double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

/// A translation of the group and its value at the default corners, along which lattices are reduced.
struct Translation {
    CornerShift shift;
    Point2 value;

    double length() const { return glm::length(value); }
    void subtract(const Translation& other, double times)
    {
        shift = plus(shift, other.shift, -times);
        value -= times * other.value;
    }
};

/// Makes `a` and `b` the shortest they can be. Steps that gain nothing are not made: in square and hexagonal lattices lengths tie.
void reduce(Translation& a, Translation& b)
{
    while (true) {
        if (b.length() < a.length() - least_step) std::swap(a, b);
        const double times = std::round(glm::dot(a.value, b.value) / glm::dot(a.value, a.value));
        Translation shorter = b;
        shorter.subtract(a, times);
        if (shorter.length() > b.length() - least_step) return;
        b = shorter;
    }
}

/// A lattice that grows by one translation at a time.
class Lattice {
public:
    void add(Translation t)
    {
        if (t.length() < same_length) return;
        if (basis_.size() < 2) {
            if (basis_.empty() || std::abs(cross(basis_[0].value, t.value)) > same_length) {
                basis_.push_back(t);
                if (basis_.size() == 2) reduce(basis_[0], basis_[1]);
            } else {
                add_parallel(t);
            }
            return;
        }
        const double det = cross(basis_[0].value, basis_[1].value);
        t.subtract(basis_[0], std::round(cross(t.value, basis_[1].value) / det));
        t.subtract(basis_[1], std::round(cross(basis_[0].value, t.value) / det));
        if (t.length() < same_length) return;
        // What is left is a new, shorter vector: it takes the place of the second, which comes back as a combination.
        const Translation old = std::exchange(basis_[1], t);
        if (std::abs(cross(basis_[0].value, basis_[1].value)) < same_length) {
            basis_[1] = old;
            std::swap(basis_[0], t);
            reduce(basis_[0], basis_[1]);
            add(t);
            return;
        }
        reduce(basis_[0], basis_[1]);
        add(old);
    }
    const std::vector<Translation>& basis() const { return basis_; }

private:
    /// Along the only basis vector so far: Euclid's algorithm.
    void add_parallel(Translation t)
    {
        while (t.length() > same_length) {
            basis_[0].subtract(t, std::round(glm::dot(basis_[0].value, t.value) / glm::dot(t.value, t.value)));
            std::swap(basis_[0], t);
        }
    }
    std::vector<Translation> basis_;
};

/// The least positive number of the form i a + j b, of those with small i and j: all that the reduced lattices of tiles need.
double least_step_of(double a, double b)
{
    double least = std::abs(a) > same_length ? std::abs(a) : std::abs(b);
    for (int i = -6; i <= 6; ++i)
        for (int j = -6; j <= 6; ++j)
            if (const double x = std::abs(i * a + j * b); x > same_length && x < least) least = x;
    return least;
}

/// The axis of a reflection.
Point2 axis_of(const Turning& reflection)
{
    const Point2 sum = Point2(1.0, 0.0) + reflection.times({1.0, 0.0});
    if (glm::length(sum) > same_length) return glm::normalize(sum);
    return {0.0, 1.0};
}

struct Axes {
    int mirrors = 0, glides = 0; // axis directions in which there is a mirror, and in which there are only glides
    bool centred = false;        // rhombic: the shortest translations along and across are twice too long for a rectangular basis
    bool along_shortest = false; // the shortest translations lie along the axes
};

Axes axes_of(const PlaneGroup& group, const CornerVector& at)
{
    const Point2 a = group.lattice[0].at(at), b = group.lattice[1].at(at);
    const double shortest = glm::length(a);
    Axes axes;
    for (const CornerMotion& m : group.representatives) {
        if (!m.turning.reflects) continue;
        const Point2 along = axis_of(m.turning), across(-along.y, along.x);
        const double step = least_step_of(glm::dot(a, along), glm::dot(b, along));
        const double glide = glm::dot(m.shift.at(at), along) / step;
        ++(std::abs(glide - std::round(glide)) < same_length ? axes.mirrors : axes.glides);

        double least_along = 0, least_across = 0;
        for (const CornerShift& shift : translations(group, 4)) {
            const Point2 t = shift.at(at);
            const auto take = [](double& least, double length) { least = least == 0 ? length : std::min(least, length); };
            if (std::abs(glm::dot(t, across)) < same_length) take(least_along, glm::length(t));
            if (std::abs(glm::dot(t, along)) < same_length) take(least_across, glm::length(t));
        }
        axes.centred = std::abs(least_along * least_across - 2.0 * cross(a, b)) < same_length;
        axes.along_shortest = std::abs(least_along - shortest) < same_length;
    }
    return axes;
}

} // namespace

int PlaneGroup::find(const Turning& turning) const
{
    const auto found = std::ranges::find(representatives, turning, &CornerMotion::turning);
    ASSERT(found != representatives.end(), "a motion of the group");
    return static_cast<int>(found - representatives.begin());
}

PlaneGroup generate(const std::vector<CornerMotion>& generators, const CornerVector& at)
{
    std::vector<CornerMotion> steps = generators;
    for (const CornerMotion& g : generators) steps.push_back(inverse(g));

    PlaneGroup group;
    auto& list = group.representatives;
    list.push_back({});
    for (std::size_t i = 0; i < list.size(); ++i)
        for (const CornerMotion& step : steps)
            if (const CornerMotion product = list[i] * step; std::ranges::find(list, product.turning, &CornerMotion::turning) == list.end()) {
                ASSERT(list.size() < 12, "a plane group has at most twelve linear parts");
                list.push_back(product);
            }

    Lattice lattice;
    for (const CornerMotion& p : list)
        for (const CornerMotion& step : steps) {
            const CornerMotion product = p * step;
            const CornerMotion left = product * inverse(list[group.find(product.turning)]);
            lattice.add({left.shift, left.shift.at(at)});
        }
    ASSERT(lattice.basis().size() == 2, "the motions of a tile make a lattice");
    group.lattice = {lattice.basis()[0].shift, lattice.basis()[1].shift};
    if (cross(group.lattice[0].at(at), group.lattice[1].at(at)) < 0) group.lattice[1] = plus(CornerShift{}, group.lattice[1], -1.0);
    return group;
}

LatticePlace lattice_place(const PlaneGroup& group, const CornerVector& at, const Point2& shift)
{
    const Point2 a = group.lattice[0].at(at), b = group.lattice[1].at(at);
    const double det = cross(a, b), i = cross(shift, b) / det, j = cross(a, shift) / det;
    ASSERT(std::abs(i - std::round(i)) < 1e-6 && std::abs(j - std::round(j)) < 1e-6, "a vector of the lattice");
    return {static_cast<int>(std::lround(i)), static_cast<int>(std::lround(j))};
}

std::vector<CornerShift> translations(const PlaneGroup& group, int reach)
{
    std::vector<CornerShift> list;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            if (i != 0 || j != 0) list.push_back(plus(plus(CornerShift{}, group.lattice[0], i), group.lattice[1], j));
    return list;
}

int rotation_order(const PlaneGroup& group)
{
    return static_cast<int>(std::ranges::count_if(group.representatives, [](const CornerMotion& m) { return !m.turning.reflects; }));
}

std::string name(const PlaneGroup& group, const CornerVector& at)
{
    const int order = rotation_order(group);
    if (static_cast<int>(group.representatives.size()) == order) return fmt::format("p{}", order);
    const Axes axes = axes_of(group, at);
    switch (order) {
    case 1: return axes.centred ? "cm" : axes.mirrors ? "pm" : "pg";
    case 2: return axes.centred ? "cmm" : axes.glides == 0 ? "pmm" : axes.mirrors == 0 ? "pgg" : "pmg";
    case 3: return axes.along_shortest ? "p31m" : "p3m1";
    case 4: return axes.glides == 0 ? "p4m" : "p4g";
    default: return "p6m";
    }
}

} // namespace druse
