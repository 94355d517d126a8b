#include "ops/solid_symmetry.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

StandingSolid::StandingSolid(const Mesh& solid, Face base, double same_place, bool mirror) : solid_(solid), base_(base), same_place_(same_place)
{
    for (const Corner c : solid_.corners(base)) {
        foot_.push_back(solid_.vertex(c).index);
        wall_.push_back(solid_.face(solid_.opposite(c)));
    }
    const Point origin = vertex_mean(solid_, base);
    double edge = 0.0;
    for (const Corner c : solid_.corners(base)) edge += length(solid_, solid_.edge(c)) / sides();
    if (sides() < 3 || !(edge > 0.0) || !(area(solid_, base) > 0.0)) throw CommandError(fmt::format("face {} of the solid has no area", base.index));
    const Vector up = -unit_normal(solid_, base);
    const Vector start = solid_.position(Vertex(foot_[0])) - origin;
    const Vector x = unit(start - glm::dot(start, up) * up, 0.0, glm::cross(up, std::abs(up.x) < 0.7 ? Vector(1, 0, 0) : Vector(0, 1, 0)));
    const Vector y = (mirror ? -1.0 : 1.0) * glm::cross(up, x);
    for (const Vertex v : solid_.vertices()) {
        const Vector d = (solid_.position(v) - origin) / edge;
        place_.emplace_back(glm::dot(d, x), glm::dot(d, y), glm::dot(d, up));
        if (const Point& p = place_.back(); !std::isfinite(p.x + p.y + p.z)) throw CommandError("the solid is too large for its base face");
    }
    // From above the base runs clockwise, unless the mirror has turned it round already.
    if (mirror) return;
    std::reverse(foot_.begin() + 1, foot_.end());
    std::ranges::reverse(wall_);
}

Point StandingSolid::turned(const Point& p, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

std::vector<std::uint32_t> StandingSolid::turned_vertices(int k)
{
    std::vector<std::uint32_t> image(place_.size());
    if (k == 1) {
        for (std::uint32_t v = 0; v < image.size(); ++v) image[v] = v;
        return image;
    }
    if (!finder_) finder_.emplace(place_, same_place_);
    std::vector<bool> taken(place_.size(), false);
    for (std::uint32_t v = 0; v < image.size(); ++v) {
        image[v] = finder_->find(turned(place_[v], full / k), same_place_);
        if (image[v] == Vertex::none || taken[image[v]]) return {};
        taken[image[v]] = true;
    }
    // Faces go to faces if sides go to sides, and what follows a side in its face follows its image.
    for (const Face f : solid_.faces())
        for (const Corner c : solid_.corners(f)) {
            const Corner there = side(image[solid_.vertex(c).index], image[solid_.target(c).index]);
            if (!there.valid() || solid_.target(solid_.next(there)).index != image[solid_.target(solid_.next(c)).index]) return {};
        }
    return image;
}

Corner StandingSolid::side(std::uint32_t from, std::uint32_t to)
{
    if (sides_.empty()) {
        for (const Face f : solid_.faces())
            for (const Corner c : solid_.corners(f)) sides_.push_back({solid_.vertex(c).index, solid_.target(c).index, c});
        std::ranges::sort(sides_, {}, &Side::ends);
    }
    const auto found = std::ranges::lower_bound(sides_, std::pair(from, to), {}, &Side::ends);
    return found != sides_.end() && found->ends() == std::pair(from, to) ? found->corner : Corner();
}

void StandingSolid::average_turns(const std::vector<std::uint32_t>& image, int k)
{
    std::vector<bool> done(place_.size(), false);
    for (std::uint32_t v = 0; v < place_.size(); ++v) {
        if (done[v]) continue;
        Point mean(0.0);
        std::uint32_t w = v;
        for (int j = 0; j < k; ++j, w = image[w]) mean += turned(place_[w], -j * (full / k)) / double(k);
        for (int j = 0; j < k; ++j, w = image[w]) {
            place_[w] = turned(mean, j * (full / k));
            done[w] = true;
        }
    }
    finder_.reset();
}

// --- which turns there are ------------------------------------------------------------------------------------------------------

TurnFinder::TurnFinder(const Mesh& solid, double same_place, bool mirror) : solid_(solid), same_place_(same_place), mirror_(mirror)
{
    for (const Vertex v : solid.vertices()) points_.push_back(solid.position(v));
    for (const Point& p : points_) mean_ += p / double(points_.size());
    double longest = 0.0;
    for (const Edge e : solid.edges()) longest = std::max(longest, length(solid, e));
    finder_.emplace(points_, slack * same_place * longest);
}

int TurnFinder::largest(Face f, int least) const
{
    const int n = solid_.valence(f);
    const Axis axis = axis_of(f);
    std::optional<StandingSolid> standing;
    for (int k = n; k >= std::max(least, 2); --k) {
        if (n % k != 0 || !may_turn(axis, k)) continue;
        if (!standing) standing.emplace(solid_, f, same_place_, mirror_);
        if (standing->turns(k)) return k;
    }
    return 1;
}

TurnFinder::Axis TurnFinder::axis_of(Face f) const
{
    double around = 0.0;
    for (const Corner c : solid_.corners(f)) around += length(solid_, solid_.edge(c));
    return {vertex_mean(solid_, f), unit_normal(solid_, f), slack * same_place_ * around / solid_.valence(f)};
}

bool TurnFinder::may_turn(const Axis& axis, int k) const
{
    const double angle = 2.0 * pi / k;
    // The mean is carried as far as its distance from the axis says, and each vertex may miss its place by the reach.
    const Vector offset = mean_ - axis.on;
    const double from_axis = glm::length(offset - glm::dot(offset, axis.along) * axis.along);
    if (from_axis * 2.0 * std::sin(0.5 * angle) > axis.reach + 1e-12 * glm::length(offset)) return false;
    const std::size_t step = points_.size() / 7 + 1;
    for (std::size_t v = 0; v < points_.size(); v += step) {
        const Vector d = points_[v] - axis.on, up = glm::dot(d, axis.along) * axis.along, out = d - up;
        const Point there = axis.on + up + std::cos(angle) * out + std::sin(angle) * glm::cross(axis.along, out);
        if (finder_->find(there, axis.reach + 1e-12 * glm::length(d)) == Vertex::none) return false;
    }
    return true;
}

} // namespace druse
