#include "dlfl/triangulate.h"
#include "ops/remesh.h"
#include "ops/remesh_divide.h"
#include "ops/remesh_points.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace druse {

namespace {

using namespace remesh;

enum class TriangulationMethod { ear, center, fan };

struct TriangulateFaces {
    FaceSelector faces = FaceSelector::all();
    TriangulationMethod method = TriangulationMethod::ear;
    RemeshGroups groups = RemeshGroups::keep;
};

/// Cuts a face into triangles: again and again the first corner, counted from the start corner, that is an ear.
///
/// An ear is a convex corner whose triangle holds no other corner, as seen along the face's normal. Only corners that are not convex can
/// lie in it. Source: Meisters, *Polygons have ears* (1975).
class FirstEars {
public:
    explicit FirstEars(const OldMesh& old) : old_(old) {}

    /// False if there is a moment without an ear, as in faces that cross or touch themselves.
    bool cut(std::uint32_t f, std::vector<FaceDivider::Triangle>& triangles, Progress& progress)
    {
        begin_ = old_.begin(f);
        const std::uint32_t n = old_.end(f) - begin_;
        normal_ = normal(old_, f);
        next_.resize(n);
        previous_.resize(n);
        blunt_.clear();
        is_blunt_.assign(n, false);
        is_ear_.assign(n, false);
        ears_ = {};
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = i + 1 < n ? i + 1 : 0;
            previous_[i] = i > 0 ? i - 1 : n - 1;
        }
        for (std::uint32_t i = 0; i < n; ++i)
            if (!is_convex(i)) {
                is_blunt_[i] = true;
                blunt_.push_back(i);
            }
        for (std::uint32_t i = 0; i < n; ++i) look_at(i);
        triangles.clear();
        for (std::uint32_t left = n; left > 3; --left) {
            if (left % 1024 == 0) progress.step(progress.fraction());
            while (!ears_.empty() && !is_ear_[ears_.top()]) ears_.pop();
            if (ears_.empty()) return false;
            const std::uint32_t i = ears_.top(), before = previous_[i], after = next_[i];
            ears_.pop();
            is_ear_[i] = false;
            triangles.push_back({i, after, before});
            next_[before] = after;
            previous_[after] = before;
            for (const std::uint32_t j : {before, after})
                if (is_blunt_[j] && is_convex(j)) {
                    is_blunt_[j] = false;
                    std::erase(blunt_, j);
                }
            look_at(before);
            look_at(after);
            last_ = before;
        }
        const std::uint32_t first = std::min({last_, next_[last_], previous_[last_]});
        triangles.push_back({first, next_[first], previous_[first]});
        return true;
    }

private:
    const Point& at(std::uint32_t i) const { return old_.position(begin_ + i); }

    /// How far a triangle turns to the left, as a sine.
    double turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
    {
        const Vector a = at(j) - at(i), b = at(k) - at(j);
        const double lengths = glm::length(a) * glm::length(b);
        return lengths > 0.0 ? glm::dot(glm::cross(a / glm::length(a), b / glm::length(b)), normal_) : 0.0;
    }
    bool is_convex(std::uint32_t i) const { return turn(previous_[i], i, next_[i]) > least; }
    bool is_ear(std::uint32_t i) const
    {
        if (is_blunt_[i] || !is_convex(i)) return false;
        const std::uint32_t corners[] = {previous_[i], i, next_[i]};
        Vector inward[3];
        double size = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector side = at(corners[(k + 1) % 3]) - at(corners[k]);
            size = std::max(size, glm::length(side));
            inward[k] = glm::cross(normal_, unit(side));
        }
        for (const std::uint32_t j : blunt_) {
            if (j == corners[0] || j == corners[2]) continue;
            bool inside = true;
            for (std::size_t k = 0; k < 3 && inside; ++k) inside = glm::dot(at(j) - at(corners[k]), inward[k]) >= -least * size;
            if (inside) return false;
        }
        return true;
    }
    void look_at(std::uint32_t i)
    {
        is_ear_[i] = is_ear(i);
        if (is_ear_[i]) ears_.push(i);
    }

    static constexpr double least = 1e-12; // a straight corner is one, whatever its last digits say

    const OldMesh& old_;
    std::uint32_t begin_ = 0, last_ = 0;
    Vector normal_{0.0};
    std::vector<std::uint32_t> next_, previous_, blunt_;
    std::vector<bool> is_blunt_, is_ear_;
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ears_;
};

/// A face's triangles by number of corner, from what draws it: for any face at all.
void cut_as_drawn(const Mesh& mesh, Face f, Triangulator& triangulator, std::vector<FaceDivider::Triangle>& triangles)
{
    std::vector<std::pair<Corner, std::uint32_t>> numbers;
    for (const Corner c : mesh.corners(f)) numbers.emplace_back(c, static_cast<std::uint32_t>(numbers.size()));
    std::ranges::sort(numbers, {}, [](const auto& x) { return x.first.index; });
    const auto number = [&](Corner c) { return std::ranges::lower_bound(numbers, c.index, {}, [](const auto& x) { return x.first.index; })->second; };
    triangles.clear();
    for (const auto& [a, b, c] : triangulator.triangles(mesh, f)) triangles.push_back({number(a), number(b), number(c)});
}

void triangulate(Scene& scene, const TriangulateFaces& p, Context& context)
{
    const Mesh& mesh = scene.mesh;
    const OldMesh old(mesh, 2);
    std::vector<bool> chosen(old.faces());
    std::uint64_t edges = old.edges();
    for (const Face f : p.faces.resolve(scene)) {
        const std::uint32_t n = old.end(f.index) - old.begin(f.index);
        chosen[f.index] = n > 3;
        if (n > 3) edges += p.method == TriangulationMethod::center ? n : n - 3;
    }
    refuse_too_large(edges, 1, 1);

    FaceDivider divider(old, p.groups);
    FirstEars ears(old);
    Triangulator triangulator;
    std::vector<FaceDivider::Triangle> triangles;
    for_each_face(old, context.progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
        const std::uint32_t n = end - begin;
        if (!chosen[f]) {
            divider.keep(f, n == 3 ? 1 : 2);
        } else if (p.method == TriangulationMethod::center) {
            const Point center = mean(old, f);
            triangles.clear();
            for (std::uint32_t i = 0; i < n; ++i) triangles.push_back({i, i + 1 < n ? i + 1 : 0, n});
            divider.divide(f, 1, triangles, &center);
        } else if (p.method == TriangulationMethod::fan) {
            triangles.clear();
            for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
            divider.divide(f, 1, triangles);
        } else {
            if (!ears.cut(f, triangles, context.progress)) cut_as_drawn(mesh, Face(f), triangulator, triangles);
            divider.divide(f, 1, triangles);
        }
    });
    scene.mesh.replace_with(divider.build());
    scene.selection.edit() = Selection();
}

} // namespace

void add_remesh_triangulate(Registry& registry)
{
    auto definition = define<TriangulateFaces>("remesh.triangulate", "Cut faces into triangles");
    definition.param(&TriangulateFaces::faces, "faces", "faces to cut")
        .param(&TriangulateFaces::method, "method", words({"ear", "center", "fan"}), "right for concave faces too, around a new vertex, or from the start corner")
        .param(&TriangulateFaces::groups, "groups", words({"absolute", "keep", "none"}), "group ids: 1 for triangles, of the old faces, or none")
        .keeps_euler()
        .example("remesh.triangulate method=center")
        .cites("Meisters 1975")
        .run(triangulate);
    registry.add(definition);
}

} // namespace druse
