#include "dlfl/check.h"

#include "dlfl/changed_elements.h"

#include <fmt/format.h>

#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

namespace druse {

/// Holds the columns of a mesh against the rules; each function returns the broken one or an empty string.
class MeshChecker {
public:
    explicit MeshChecker(const Mesh& mesh) : mesh_(mesh) {}

    std::string corner(Corner c) const
    {
        const auto say = [c](const char* what) { return fmt::format("corner {}: {}", c.index, what); };
        const Corner next = mesh_.next(c), previous = mesh_.previous(c);
        if (!mesh_.is_alive(next) || !mesh_.is_alive(previous)) return say("its neighbour in the face is not alive");
        if (mesh_.previous(next) != c || mesh_.next(previous) != c) return say("next and previous are not each other's inverse");
        if (!mesh_.is_alive(mesh_.vertex(c))) return say("its vertex is not alive");
        const Face f = mesh_.face(c);
        if (!f.valid() || (f.is_boundary() ? f.boundary_index() >= mesh_.boundary_count() : !mesh_.is_alive(f)))
            return say("its face is not alive");
        if (mesh_.face(next) != f) return say("the next corner lies in another face");
        const Edge e = mesh_.edge(c);
        if (!e.valid()) {
            if (next != c) return say("it has no edge but is not a point sphere");
            return {};
        }
        if (!mesh_.is_alive(e)) return say("its edge is not alive");
        const Corner a = mesh_.corner(e, 0), b = mesh_.corner(e, 1);
        if (a == b || (a != c && b != c)) return say("its edge does not name it as one of two corners");
        const Corner across = mesh_.opposite(c);
        if (!mesh_.is_alive(across) || mesh_.edge(across) != e) return say("the corner across its edge does not have that edge");
        if (mesh_.vertex(across) != mesh_.vertex(next) || mesh_.vertex(mesh_.next(across)) != mesh_.vertex(c))
            return say("the side across its edge does not run against it");
        return {};
    }

    std::string edge(Edge e) const
    {
        if (mesh_.corner(e, 0) == mesh_.corner(e, 1)) return fmt::format("edge {}: both of its corners are the same", e.index);
        for (int side = 0; side < 2; ++side)
            if (const Corner c = mesh_.corner(e, side); !mesh_.is_alive(c) || mesh_.edge(c) != e)
                return fmt::format("edge {}: corner {} is not one of its own", e.index, c.index);
        return {};
    }

    std::string face(Face f) const
    {
        const Corner start = mesh_.corner(f);
        if (!mesh_.is_alive(start) || mesh_.face(start) != f)
            return fmt::format("{} {}: its start corner is not one of its own", f.is_boundary() ? "boundary face" : "face",
                               f.is_boundary() ? f.boundary_index() : f.index);
        if (!f.is_boundary() && mesh_.group(f) < 0) return fmt::format("face {}: its group {} is negative", f.index, mesh_.group(f));
        return {};
    }

    /// Walks the rotation; `visited` grows by the number of corners met.
    std::string vertex(Vertex v, std::uint64_t& visited) const
    {
        if (!is_in_reach(mesh_.position(v))) return fmt::format("vertex {}: its position lies beyond {}", v.index, largest_coordinate);
        const Corner first = mesh_.corner(v);
        if (!mesh_.is_alive(first) || mesh_.vertex(first) != v) return fmt::format("vertex {}: its corner is not one of its own", v.index);
        if (!mesh_.edge(first).valid()) {
            ++visited;
            return {};
        }
        std::uint32_t steps = 0;
        Corner c = first;
        do {
            if (mesh_.vertex(c) != v) return fmt::format("vertex {}: its rotation passes through corner {} of vertex {}", v.index, c.index, mesh_.vertex(c).index);
            // Corners elsewhere may not have been checked, so nothing is followed blindly.
            const Corner into = mesh_.previous(c);
            if (!mesh_.is_alive(into) || !mesh_.is_alive(mesh_.edge(into)) || ++steps > mesh_.corner_limit())
                return fmt::format("vertex {}: its rotation does not close", v.index);
            c = mesh_.opposite(into);
            if (!mesh_.is_alive(c)) return fmt::format("vertex {}: its rotation does not close", v.index);
        } while (c != first);
        visited += steps;
        return {};
    }

    /// What is not alive is listed to be used again, so that counts are right.
    std::string holes() const
    {
        const auto compare = [](const char* kind, const auto& column, const auto& alive, std::size_t listed) -> std::string {
            std::size_t dead = 0;
            for (std::uint32_t i = 0; i < column.size(); ++i) dead += alive(column[i]) ? 0 : 1;
            return dead == listed ? std::string() : fmt::format("{}: {} not alive, but {} holes", kind, dead, listed);
        };
        const auto valid = [](auto h) { return h.valid(); };
        if (std::string broken = compare("vertices", mesh_.vertex_corner_, valid, mesh_.free_vertices_.size()); !broken.empty()) return broken;
        const auto has_corner = [](const auto& pair) { return pair[0].valid(); };
        if (std::string broken = compare("edges", mesh_.edge_corners_, has_corner, mesh_.free_edges_.size()); !broken.empty()) return broken;
        if (std::string broken = compare("faces", mesh_.face_corner_, valid, mesh_.free_faces_.size()); !broken.empty()) return broken;
        return compare("corners", mesh_.corner_vertex_, valid, mesh_.free_corners_.size());
    }

    std::string everything() const
    {
        if (std::string broken = holes(); !broken.empty()) return broken;
        std::uint64_t corners = 0, in_faces = 0, in_vertices = 0;
        for (std::uint32_t i = 0; i < mesh_.corner_limit(); ++i)
            if (mesh_.is_alive(Corner(i))) {
                ++corners;
                if (std::string broken = corner(Corner(i)); !broken.empty()) return broken;
            }
        for (const Edge e : mesh_.edges())
            if (std::string broken = edge(e); !broken.empty()) return broken;
        const auto walk = [&](Face f) -> std::string {
            if (std::string broken = face(f); !broken.empty()) return broken;
            in_faces += static_cast<std::uint64_t>(mesh_.valence(f));
            return {};
        };
        for (const Face f : mesh_.faces())
            if (std::string broken = walk(f); !broken.empty()) return broken;
        for (const Face f : mesh_.boundary_faces())
            if (std::string broken = walk(f); !broken.empty()) return broken;
        if (in_faces != corners) return fmt::format("{} corners, but the faces pass through {}", corners, in_faces);
        for (const Vertex v : mesh_.vertices())
            if (std::string broken = vertex(v, in_vertices); !broken.empty()) return broken;
        if (in_vertices != corners) return fmt::format("{} corners, but the rotations of the vertices pass through {}", corners, in_vertices);
        const LargestGroup::State kept = mesh_.largest_group_.state(), found = mesh_.find_largest_group();
        if (mesh_.largest_group_.is_known() && (kept.group != found.group || (found.group > 0 && kept.faces != found.faces)))
            return fmt::format("group {} of {} faces is the largest, but is known as group {} of {}", found.group, found.faces, kept.group, kept.faces);
        return {};
    }

    std::string change(const MeshChange& before) const
    {
        const Mesh& m = mesh_;
        std::string broken;
        Marks corners_done(m.corner_limit()), vertices_done(m.vertex_limit());
        std::uint64_t visited = 0;
        const auto look = [&broken](auto&& rule) {
            if (broken.empty()) broken = rule();
        };
        const auto look_at_vertex = [&](Vertex v) {
            if (m.is_alive(v) && vertices_done.add(v.index)) look([&] { return vertex(v, visited); });
        };
        const auto look_at_face = [&](Face f) {
            if (f.valid() && (f.is_boundary() ? f.boundary_index() < m.boundary_count() : m.is_alive(f))) look([&] { return face(f); });
        };
        const auto look_at_corner = [&](std::uint32_t i) {
            const Corner c(i);
            if (!m.is_alive(c) || !corners_done.add(i)) return;
            look([&] { return corner(c); });
            if (broken.empty()) look_at_vertex(m.vertex(c));
        };
        const auto from_corner = [&](std::uint32_t i, auto) { look_at_corner(i); };
        each_changed(before.corner_vertex, m.corner_vertex_, from_corner);
        each_changed(before.corner_next, m.corner_next_, from_corner);
        each_changed(before.corner_previous, m.corner_previous_, from_corner);
        each_changed(before.corner_edge, m.corner_edge_, from_corner);
        each_changed(before.corner_face, m.corner_face_, [&](std::uint32_t i, Face old) {
            look_at_corner(i);
            look_at_face(old); // it may still begin there
        });
        each_changed(before.edge_corners, m.edge_corners_, [&](std::uint32_t i, const auto&) {
            if (m.is_alive(Edge(i))) look([&] { return edge(Edge(i)); });
        });
        each_changed(before.face_corner, m.face_corner_, [&](std::uint32_t i, Corner) { look_at_face(Face(i)); });
        each_changed(before.face_group, m.face_group_, [&](std::uint32_t i, std::int32_t) { look_at_face(Face(i)); });
        each_changed(before.boundary_corner, m.boundary_corner_, [&](std::uint32_t i, Corner) { look_at_face(Face::boundary(i)); });
        each_changed(before.vertex_corner, m.vertex_corner_, [&](std::uint32_t i, Corner) { look_at_vertex(Vertex(i)); });
        each_changed(before.vertex_position, m.vertex_position_, [&](std::uint32_t i, const Point&) { look_at_vertex(Vertex(i)); });
        return broken;
    }

    Vertex out_of_reach(const MeshChange& before) const
    {
        Vertex found;
        each_changed(before.vertex_position, mesh_.vertex_position_, [&](std::uint32_t i, const Point&) {
            if (Vertex(i) < found && !is_in_reach(mesh_.position(Vertex(i)))) found = Vertex(i);
        });
        return found;
    }

private:
    /// A set of indices with room for those near it only, so that marking a few of many costs little.
    class Marks {
    public:
        explicit Marks(std::uint32_t limit) : pages_(limit / page_size + 1) {}

        /// False if it is there already.
        bool add(std::uint32_t i)
        {
            auto& page = pages_[i / page_size];
            if (!page) page = std::make_unique<std::bitset<page_size>>();
            if (page->test(i % page_size)) return false;
            page->set(i % page_size);
            return true;
        }

    private:
        static constexpr std::uint32_t page_size = 4096;
        std::vector<std::unique_ptr<std::bitset<page_size>>> pages_;
    };

    /// Calls f(i, old) for what is another one now, and for what is new.
    template <class T, class F>
    static void each_changed(const ColumnChange<T>& before, const Column<T>& column, F&& f)
    {
        if (!before.whole) for_each_changed(before, [&](std::uint32_t i) { return column[i]; }, f);
        for (std::uint32_t i = before.whole ? 0 : before.common; i < column.size(); ++i) f(i, T());
    }

    const Mesh& mesh_;
};

std::string check(const Mesh& mesh) { return MeshChecker(mesh).everything(); }

std::string check_change(const Mesh& mesh, const MeshChange& before)
{
    const MeshChecker checker(mesh);
    return before.corner_vertex.whole ? checker.everything() : checker.change(before);
}

Vertex changed_out_of_reach(const Mesh& mesh, const MeshChange& before) { return MeshChecker(mesh).out_of_reach(before); }

} // namespace druse
