#pragma once

#include "dlfl/column.h"
#include "dlfl/mesh.h"
#include "dlfl/triangulate.h"
#include "geom/colour.h"
#include "graph/graph.h"
#include "render/mesh_delta.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace druse {

/// The colour in which the faces of a group are drawn; asked once per group and call.
using GroupColours = std::function<Colour(int group)>;

/// A vertex as the graphics card gets it. Besides its place it carries the look of one triangle: that which ends in it.
struct DrawVertex {
    float x = 0, y = 0, z = 0; // relative to DrawLists::origin()
    std::uint32_t normal = 0;  // of the whole polygon, three signed 10-bit fields
    std::uint32_t look = 0;    // red, green, blue and, in the top byte, flags

    static constexpr std::uint32_t side_flag = 1u << 24; // << 0, 1, 2: triangle sides 2→0, 0→1, 1→2 are sides of the polygon
    static constexpr std::uint32_t selected_flag = 1u << 27;
    static constexpr std::uint32_t claimed_flag = 1u << 28; // a triangle ends here
};

class Palette;

/// Where the faces of a mesh come from that was made of another by dividing its faces, to show that one smooth.
struct Division {
    Division(const Mesh& old, std::vector<std::uint32_t> faces, std::span<const Vector> normals = {});

    std::vector<std::uint32_t> old_face; // by face
    std::span<const Vector> normals;     // by vertex, of length 1, for smooth shading; borrowed. None: they come from the triangles
    Box old_bounds;                      // the outlines of old faces may go over the picture
    double old_mean_edge = 0;            // their mean length, by which edges fade
};

/// What the renderer and picking need of a mesh, in a copy of its own, so that the picture stays while the mesh changes.
///
/// **Triangles.** A polygon has one normal and one colour, but shares its vertices with others. The picture of a large mesh is
/// made of its vertices in software as on a card, so they are not multiplied: the last vertex of a triangle (the one that OpenGL
/// calls *provoking*) gives the whole triangle its look, and only such a vertex is private to a triangle. The others are shared,
/// so a mesh of T triangles takes max(V, T) vertices or little more. Vertices are numbered in the order in which the triangles
/// use them, and a new copy of one is made where the old one is out of reach of a vertex cache.
///
/// **Changes.** Each block of 256 elements remembers when it last changed, so that any number of renderers can keep up by copying
/// the blocks that are newer than their own state. After a local edit, update() touches only the faces that are not as they were:
/// their old triangles become degenerate or are used again, further ones are appended.
class DrawLists {
public:
    static constexpr std::uint32_t none = 0xffffffffu;
    static constexpr std::uint32_t block_bits = 8; // elements per block of change: 256
    static constexpr std::uint32_t pick_bits = 6;  // triangles per box: 64

    using Triangle = std::array<std::uint32_t, 3>; // draw vertices, counter-clockwise; all equal: no triangle
    /// Everything once more: `scale` times as large, then elsewhere. Faces are in one colour and have no edges drawn; lines are drawn where there are no faces.
    struct Copy {
        double scale = 1; // above 0
        Vector shift{0.0};
        Colour colour;
        Point at(const Point& p) const { return scale * p + shift; }
        friend bool operator==(const Copy&, const Copy&) = default;
    };
    struct Range {
        std::uint32_t first = 0, count = 0;
    };

    DrawLists() = default;
    DrawLists(const Mesh& mesh, const GroupColours& colours) { build(mesh, colours); }
    explicit DrawLists(const Graph& graph) { build(graph); }

    // --- filling --------------------------------------------------------------------------------------------------------

    /// Takes everything anew; the selection is dropped. Cost: linear; 1 M triangles take about as long as one frame in software.
    void build(const Mesh& mesh, const GroupColours& colours);
    /// The same of a divided mesh: shading is always smooth, by the normals of the division if it has any, and sides and edges() are only those between parts of different old
    /// faces. Such lists cannot be updated.
    void build(const Mesh& mesh, const GroupColours& colours, const Division& division);
    /// Lines only, for a graph without faces.
    void build(const Graph& graph);

    /// Follows a mesh to its new state. Faces stay selected by their id. Gives the same picture as build(), for the cost of the
    /// change (plus at most one pass over blocks of 64 triangles); where much has changed, or much was left behind by earlier
    /// calls, it builds anew by itself. Where vertices of triangles have moved, many of them or all, and nothing else is new, it
    /// puts places and normals again, which takes a third of that.
    /// Precondition: `delta` lists at least all that changed since the last build() or update().
    void update(const Mesh& mesh, const MeshDelta& delta, const GroupColours& colours);

    /// The same of lines: only what is elsewhere is put again. What shows faces, or lies far away from where it was, is built anew.
    /// Cost: one look at each vertex and line.
    void update(const Graph& graph);

    /// Groups and colours of all faces again; nothing else may have changed. Cost: one look at each triangle.
    void recolour(const Mesh& mesh, const GroupColours& colours);
    void recolour(const std::function<int(Face)>& group_of, const GroupColours& colours);

    /// Shows these beside it, from now on and after each build(): copies follow whatever becomes of what they are of, at no cost. They have no outlines and no selection.
    void set_copies(std::vector<Copy> copies);

    /// Makes these the selected faces, and no others. Cost: that of the faces listed now and before.
    void select(std::span<const Face> faces);

    // --- what is in them ------------------------------------------------------------------------------------------------

    const Point& origin() const { return origin_; } // what places of draw vertices are relative to
    const Box& bounds() const { return bounds_; }   // in model coordinates; empty if nothing is drawn
    const Box& reach() const { return reach_; }     // bounds(), and what may be outlined beyond them
    std::span<const Copy> copies() const { return copies_; }
    Box with_copies(const Box& box) const; // and all that it becomes in them
    bool is_divided() const { return is_divided_; }
    double mean_edge_length() const { return mean_edge_; }
    bool has_faces() const { return live_triangles_ > 0; }
    bool is_closed() const { return boundary_sides_.empty(); } // no open boundary
    std::uint32_t triangle_count() const { return live_triangles_; }
    std::uint32_t face_limit() const { return face_triangles_.size(); }
    std::uint32_t vertex_limit() const { return positions_.size(); }
    std::uint32_t edge_limit() const { return edge_ends_.size(); }

    std::span<const DrawVertex> draw_vertices() const { return draw_vertices_.view(); }
    std::span<const Triangle> triangles() const { return triangles_.view(); }
    std::span<const std::array<std::uint32_t, 2>> edges() const
    {
        return edge_ends_.view();
    } // mesh vertices; `none` twice if gone
    std::span<const std::array<std::uint32_t, 2>> boundary_sides() const { return boundary_sides_; } // mesh vertices
    std::span<const Face> selected() const { return selected_; }

    Range triangles(Face f) const { return f.index < face_limit() ? face_triangles_[f.index] : Range{}; }
    Face face(std::uint32_t triangle) const { return Face(triangle_face_[triangle]); } // invalid: no triangle
    int group(Face f) const { return face_group_[f.index]; }
    bool is_selected(Face f) const { return f.index < face_selected_.size() && face_selected_[f.index] != 0; }
    std::span<const Point> positions() const { return positions_.view(); }
    const Point& position(std::uint32_t vertex) const { return positions_[vertex]; }
    std::uint32_t vertex_of(std::uint32_t draw_vertex) const { return vertex_of_[draw_vertex]; }
    std::uint32_t draw_vertex_of(std::uint32_t vertex) const { return newest_[vertex]; } // any one of its copies
    const Point& corner(std::uint32_t triangle, std::size_t k) const { return positions_[vertex_of_[triangles_[triangle][k]]]; }
    /// The sides of the polygon among the sides of its triangles, as pairs of mesh vertices.
    std::vector<std::array<std::uint32_t, 2>> sides(Face f) const;
    /// One box per block of 64 triangles; picking passes over blocks whose box the ray misses.
    std::span<const Box> pick_boxes() const { return pick_boxes_; }

    /// Normals for smooth shading, packed like DrawVertex::normal, one per draw vertex: those of a division, or else the mean of the
    /// triangles around a vertex, weighted by their angle there. Cost: linear, the first time since the shape changed; not from two threads at once.
    const std::vector<std::uint32_t>& smooth_normals() const;

    // --- following them ---------------------------------------------------------------------------------------------------

    /// Another number after each build (`id`) and after each change of any kind (`version`); no two lists share a number.
    std::uint64_t id() const { return id_; }
    std::uint64_t version() const { return version_; }
    /// The version in which anything but colours, groups and the selection last changed.
    std::uint64_t shape_version() const { return shape_version_; }
    /// When each block of 256 draw vertices, triangles and edges last changed.
    std::span<const std::uint64_t> vertex_versions() const { return vertex_versions_; }
    std::span<const std::uint64_t> triangle_versions() const { return triangle_versions_; }
    std::span<const std::uint64_t> edge_versions() const { return edge_versions_; }

private:
    static Point origin_for(const Box& box);
    void clear(const Box& box);
    void build(const Mesh& mesh, const GroupColours& colours, const Division* division);
    void new_version();
    std::uint32_t copy_vertex(std::uint32_t v);
    std::uint32_t unclaimed_copy(std::uint32_t v) const;
    void put_triangles(const Mesh& mesh, Face f, Palette& palette, std::vector<std::uint32_t>* last_use, const Division* division = nullptr);
    void put_edges(const Mesh& mesh, const Division* division);
    std::size_t choose_last(const std::array<std::uint32_t, 3>& v, std::vector<std::uint32_t>* last_use);
    void release(Face f);
    bool is_only_moved(const Mesh& mesh, const MeshDelta& delta) const;
    void put_places(const Mesh& mesh);
    bool is_far_from_origin() const { return !bounds_.empty() && glm::distance(origin_, bounds_.center()) > 16 * bounds_.diagonal(); }
    std::uint32_t find_room(std::uint32_t count);
    void resize(const Mesh& mesh);
    void take_boundary(const Mesh& mesh);
    double length(Edge e) const; // 0 if it is gone
    void take_normals(std::span<const Vector> normals) const; // by mesh vertex, of length 1
    void paint(Face f, Palette& palette);
    void renew_box(std::uint32_t block);
    void renew_bounds();

    void touch(std::vector<std::uint64_t>& versions, std::uint32_t i)
    {
        const std::size_t block = i >> block_bits;
        if (block >= versions.size()) versions.resize(block + 1);
        versions[block] = version_;
    }

    Point origin_{0.0};
    Box bounds_, reach_;
    bool is_divided_ = false;
    double edge_sum_ = 0, mean_edge_ = 0;
    std::uint32_t live_triangles_ = 0;

    Column<DrawVertex> draw_vertices_;
    Column<std::uint32_t> vertex_of_, next_copy_; // per draw vertex: its mesh vertex, and another copy of that, or `none`
    Column<Triangle> triangles_;
    Column<std::uint32_t> triangle_face_;
    Column<Point> positions_;
    Column<std::uint32_t> newest_; // per mesh vertex: its newest copy
    Column<Range> face_triangles_;
    Column<std::int32_t> face_group_;
    Column<std::uint8_t> face_selected_;
    Column<std::array<std::uint32_t, 2>> edge_ends_;
    std::vector<std::array<std::uint32_t, 2>> boundary_sides_;
    std::vector<Face> selected_;
    std::vector<Copy> copies_;
    std::vector<Box> pick_boxes_;

    std::vector<std::vector<std::uint32_t>> room_; // by number of triangles: where so many in a row are free
    Triangulator triangulator_;

    std::uint64_t id_ = 0, version_ = 0, shape_version_ = 0;
    mutable std::vector<std::uint32_t> smooth_normals_;
    mutable std::uint64_t smooth_version_ = 0; // the shape_version() they are of
    std::vector<std::uint64_t> vertex_versions_, triangle_versions_, edge_versions_;
};

/// A direction as three signed 10-bit fields.
std::uint32_t pack_normal(const Vector& n);

} // namespace druse
