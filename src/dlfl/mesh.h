#pragma once

#include "dlfl/column.h"
#include "dlfl/handle.h"
#include "dlfl/largest_group.h"
#include "geom/point.h"

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace druse {

class Patch;

/// Counts that come up everywhere. Boundary faces are in none of them.
struct Counts {
    std::uint32_t vertices = 0, edges = 0, faces = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
};

/// Old ids to new ids after Mesh::compact(); an element that went has the value `Handle::none`. An empty list: nothing moved.
struct Renumbering {
    std::vector<std::uint32_t> vertices, edges, faces;
    bool empty() const { return vertices.empty() && edges.empty() && faces.empty(); }
};

/// What one command changed in a mesh; see Column::exchange.
struct MeshChange {
    LargestGroup::State largest_group;
    ColumnChange<Vertex> corner_vertex;
    ColumnChange<Corner> corner_next, corner_previous;
    ColumnChange<Face> corner_face;
    ColumnChange<Edge> corner_edge;
    ColumnChange<std::array<Corner, 2>> edge_corners;
    ColumnChange<Corner> face_corner;
    ColumnChange<std::int32_t> face_group;
    ColumnChange<Corner> boundary_corner;
    ColumnChange<Point> vertex_position;
    ColumnChange<Corner> vertex_corner;

    std::size_t bytes() const;
};

/// The doubly linked face list: an orientable closed 2-manifold of any genus, in any number of components.
///
/// A face is a cyclic list of corners, counter-clockwise seen from outside. A corner names one vertex and the side of the face
/// that starts there; an edge is the pair of corners whose sides run against each other along it. The rotation of edges around a
/// vertex follows from the two. A face may visit a vertex twice, an edge may have one face on both sides, two edges may join
/// the same vertices, and a *point sphere* is one vertex in one face with a single corner and no edge.
///
/// Where a loaded surface is open, a marked *boundary face* closes it: faces() and the counts leave it out, and operators leave
/// it alone, but next(), opposite() and around() pass through it, so that no code needs a special case for a missing neighbour.
///
/// Handles are indices into columns. They stay valid while an operator runs, whatever it makes or deletes; deleted elements
/// leave holes, which later ones fill from the lowest index up, and compact() closes.
///
/// Sources: Akleman & Chen, *Guaranteeing the 2-manifold property for meshes with doubly linked face list* (1999); Akleman,
/// Chen & Srinivasan, *A minimal and complete set of operators for the development of robust manifold mesh modelers* (2003).
class Mesh {
public:
    // --- counts and ranges (holes and boundary faces are passed over) ---------------------------------------------------

    std::uint32_t vertex_count() const { return vertex_corner_.size() - holes(free_vertices_); }
    std::uint32_t edge_count() const { return edge_corners_.size() - holes(free_edges_); }
    std::uint32_t face_count() const { return face_corner_.size() - holes(free_faces_); }
    std::uint32_t boundary_count() const { return boundary_corner_.size(); }
    Counts counts() const { return {vertex_count(), edge_count(), face_count()}; }

    /// One past the largest index in use: the size for scratch values beside the mesh.
    std::uint32_t vertex_limit() const { return vertex_corner_.size(); }
    std::uint32_t edge_limit() const { return edge_corners_.size(); }
    std::uint32_t face_limit() const { return face_corner_.size(); }
    std::uint32_t corner_limit() const { return corner_vertex_.size(); }
    bool has_holes() const { return !(free_vertices_.empty() && free_edges_.empty() && free_faces_.empty() && free_corners_.empty()); }

    bool is_alive(Vertex v) const { return v.index < vertex_corner_.size() && vertex_corner_[v.index].valid(); }
    bool is_alive(Edge e) const { return e.index < edge_corners_.size() && edge_corners_[e.index][0].valid(); }
    bool is_alive(Face f) const { return f.index < face_corner_.size() && face_corner_[f.index].valid(); } // false for a boundary face
    bool is_alive(Corner c) const { return c.index < corner_vertex_.size() && corner_vertex_[c.index].valid(); }

    template <class H>
    class Range; // forward range over live elements
    Range<Vertex> vertices() const;
    Range<Edge> edges() const;
    Range<Face> faces() const;

    class BoundaryRange; // of Face
    BoundaryRange boundary_faces() const;

    class CornerRange; // the corners of a face in order, from its start corner
    CornerRange corners(Face f) const;

    class VertexRange; // the corners of a vertex, counter-clockwise: one for each edge that leaves it
    VertexRange around(Vertex v) const;

    // --- navigation -----------------------------------------------------------------------------------------------------

    Vertex vertex(Corner c) const { return corner_vertex_[c.index]; }
    Corner next(Corner c) const { return corner_next_[c.index]; }
    Corner previous(Corner c) const { return corner_previous_[c.index]; }
    Face face(Corner c) const { return corner_face_[c.index]; }
    Edge edge(Corner c) const { return corner_edge_[c.index]; } // invalid on a point sphere

    /// The corner whose side runs the other way along the same edge. Precondition: not a point sphere.
    Corner opposite(Corner c) const
    {
        const auto& pair = edge_corners_[corner_edge_[c.index].index];
        return pair[0] == c ? pair[1] : pair[0];
    }
    /// The vertex where the side of `c` ends.
    Vertex target(Corner c) const { return vertex(next(c)); }
    /// The next corner of the same vertex, counter-clockwise.
    Corner rotate(Corner c) const { return opposite(previous(c)); }

    Corner corner(Face f) const { return f.is_boundary() ? boundary_corner_[f.boundary_index()] : face_corner_[f.index]; } // the start corner
    Corner corner(Vertex v) const { return vertex_corner_[v.index]; }
    /// The two corners of an edge; the first is the one that used it first.
    Corner corner(Edge e, int side) const { return edge_corners_[e.index][static_cast<std::size_t>(side)]; }
    /// The two ends of an edge, in the direction of its first corner.
    std::array<Vertex, 2> ends(Edge e) const { return {vertex(corner(e, 0)), target(corner(e, 0))}; }
    std::array<Face, 2> faces(Edge e) const { return {face(corner(e, 0)), face(corner(e, 1))}; }

    /// Sides of a face (1 for a point sphere); walks the face.
    int valence(Face f) const;
    /// Edges of a vertex (0 for a point sphere); walks its rotation.
    int valence(Vertex v) const;
    bool is_point_sphere(Vertex v) const { return !edge(corner(v)).valid(); }
    bool is_on_boundary(Edge e) const { return face(corner(e, 0)).is_boundary() || face(corner(e, 1)).is_boundary(); }
    /// The K-th corner of a face, from 0 at its start corner. Precondition: 0 ≤ k < valence(f).
    Corner corner(Face f, int k) const;

    // --- values ---------------------------------------------------------------------------------------------------------

    const Point& position(Vertex v) const { return vertex_position_[v.index]; }
    const Point& position(Corner c) const { return position(vertex(c)); }
    int group(Face f) const { return face_group_[f.index]; } // 0 = ungrouped. Precondition: not a boundary face

    void set_position(Vertex v, const Point& p) { vertex_position_.set(v.index, p); }
    void set_group(Face f, int group)
    {
        largest_group_.replace(face_group_[f.index], group);
        face_group_.set(f.index, group);
    }
    /// Makes `c` the start corner of its face.
    void set_start(Corner c);

    /// All values of a kind for reading or writing in bulk, indexed by handle; holes included. A writable span is valid until
    /// elements are added.
    std::span<const Point> positions() const { return vertex_position_.view(); }
    std::span<const std::int32_t> groups() const { return face_group_.view(); }
    std::span<Point> write_positions() { return {vertex_position_.write(0, vertex_position_.size()), vertex_position_.size()}; }
    std::span<std::int32_t> write_groups() { return {write_groups(0, face_limit()), face_limit()}; }
    /// The groups of faces first … first + count − 1.
    std::int32_t* write_groups(std::uint32_t first, std::uint32_t count)
    {
        largest_group_.forget();
        return face_group_.write(first, count);
    }
    /// 0 if no face is grouped. Cost: O(1), or O(F) after groups were written in bulk until a change is begun.
    int largest_group() const;

    // --- the four minimal operators (Akleman, Chen & Srinivasan 2003) ---------------------------------------------------

    /// A point sphere at `p`: V + 1, F + 1, χ + 2. Precondition: finite.
    Vertex create_vertex(const Point& p);

    /// Takes a point sphere away: V − 1, F − 1, χ − 2. Precondition: is_point_sphere(v).
    void delete_vertex(Vertex v);

    /// Puts an edge into two corners, each time between the edge that comes in there and the one that goes out.
    ///
    /// Corners of one face split it (F + 1, χ + 0): the part with its start corner keeps the id, the other one gets the same
    /// group and starts at the new edge. Corners of two faces merge them (F − 1, χ − 2; the lower id, its start corner and
    /// group stay): within a component this adds a handle, between two it joins them.
    /// c1 keeps the edge coming in and becomes the tail of the new edge; a new corner of its vertex takes the one going out, and
    /// likewise at c2. The only corner of a point sphere is used again, not doubled.
    /// Preconditions: c1 ≠ c2, neither in a boundary face. Cost: O(valence of the faces).
    /// @return the new edge; its first corner is c1
    Edge insert_edge(Corner c1, Corner c2);

    /// Takes an edge away. Two faces are merged (F − 1, χ + 0; the lower id, its group and, if it is not the one that goes, its
    /// start corner stay); one face on both sides falls apart (F + 1, χ + 2). A vertex that loses its last edge becomes a point
    /// sphere, or goes too with `cleanup`. Precondition: no boundary face beside it. Cost: O(valence of the faces).
    void delete_edge(Edge e, bool cleanup = false);

    // --- bulk -----------------------------------------------------------------------------------------------------------

    /// Puts a disc of polygons in place of each face: see Patch.
    ///
    /// The first polygon of a patch keeps the id of its face; vertices, edges and the other faces are appended, face after face,
    /// in the patch's order. New faces have the group of the old one, new vertices the positions written to vertex_room().
    /// `patch_of` gives the connected patch for a face; all are borrowed until the call returns.
    /// Preconditions: the faces are alive and differ from each other, and the mesh has no holes.
    /// Cost: linear in what is made; nothing is searched.
    /// @return the index of the first new vertex; the others follow it
    std::uint32_t replace_faces(std::span<const Face> faces, std::span<const Patch* const> patch_of);

    /// Memory for the positions of the next `count` vertices, which replace_faces() is going to make: written first, so that a
    /// kernel can fail before anything has changed. Valid until the mesh changes.
    std::span<Point> vertex_room(std::size_t count);

    /// replace_faces for a single face.
    std::uint32_t replace_face(Face f, const Patch& patch);

    /// Closes the holes that deleted elements left; vertices, edges and faces stay in order. Cost: for each of the three that has holes,
    /// a walk through what comes after the first one.
    Renumbering compact();

    /// Takes all elements of `other`, as a moving assignment does; both are part of a change being recorded.
    void replace_with(Mesh&& other);

    /// Adds the elements of `other` after the own ones, as further components. Precondition: neither has holes.
    void append(const Mesh& other);

    void clear() { replace_with(Mesh()); }

    /// Turns the components that hold these faces inside out: every face of theirs runs the other way from the same start vertex.
    /// All ids stay. Precondition: no holes. Cost: O(mesh).
    void reverse_components(std::span<const Face> faces);

    // --- going back -----------------------------------------------------------------------------------------------------

    /// Starts to record what changes. The cost of recording, and of exchange(), follows the change, not the mesh.
    void begin_change();
    /// Ends the recording. Precondition: no holes.
    MeshChange end_change();
    /// Changes places with the state at begin_change(); `change` then leads back to this one.
    void exchange(MeshChange& change);
    /// Ends the recording and puts everything back, holes or not. Never fails. Precondition: a change is being recorded.
    void roll_back();
    /// A copy of a mesh records nothing, whatever the mesh does.
    bool is_recording() const { return corner_vertex_.is_recording(); }

    /// True if every column holds the same values, index by index.
    friend bool operator==(const Mesh& a, const Mesh& b);

    /// Memory held by the columns, in bytes.
    std::size_t bytes() const;

private:
    friend class MeshAssembler;
    friend class MeshBuilder;
    friend class MeshTables;
    friend class MeshChecker;
    friend struct MeshTestAccess; // tests break a mesh through it, to see that check() notices

    using Holes = std::vector<std::uint32_t>; // a heap, least first
    static std::uint32_t holes(const Holes& h) { return static_cast<std::uint32_t>(h.size()); }
    static std::uint32_t take(Holes& h);
    static void give(Holes& h, std::uint32_t index);

    Vertex new_vertex(const Point& p);
    Edge new_edge(Corner a, Corner b);
    Face new_face(Corner start, int group);
    LargestGroup::State find_largest_group() const;
    Corner new_corner(Vertex v);
    void free_vertex(Vertex v);
    void free_edge(Edge e);
    void free_face(Face f);
    void free_corner(Corner c);

    void link(Corner a, Corner b)
    {
        corner_next_.set(a.index, b);
        corner_previous_.set(b.index, a);
    }
    void set_face_corner(Face f, Corner c)
    {
        if (f.is_boundary()) boundary_corner_.set(f.boundary_index(), c);
        else face_corner_.set(f.index, c);
    }
    void replace_edge_corner(Edge e, Corner from, Corner to);
    void close_corner_holes();
    void move_corner(Corner from, Corner to);
    bool relabel(Corner from, Face f);
    void replace_in_order(std::span<const Face> faces, std::span<const Patch* const> patch_of, std::uint32_t first_vertex,
                          std::uint32_t first_edge, std::uint32_t first_face, std::uint32_t first_corner);

    template <class F>
    void for_each_column(F&& f)
    {
        f(corner_vertex_, &MeshChange::corner_vertex);
        f(corner_next_, &MeshChange::corner_next);
        f(corner_previous_, &MeshChange::corner_previous);
        f(corner_face_, &MeshChange::corner_face);
        f(corner_edge_, &MeshChange::corner_edge);
        f(edge_corners_, &MeshChange::edge_corners);
        f(face_corner_, &MeshChange::face_corner);
        f(face_group_, &MeshChange::face_group);
        f(boundary_corner_, &MeshChange::boundary_corner);
        f(vertex_position_, &MeshChange::vertex_position);
        f(vertex_corner_, &MeshChange::vertex_corner);
    }

    Column<Vertex> corner_vertex_;
    Column<Corner> corner_next_, corner_previous_;
    Column<Face> corner_face_;
    Column<Edge> corner_edge_;
    Column<std::array<Corner, 2>> edge_corners_;
    Column<Corner> face_corner_;       // start corner
    Column<std::int32_t> face_group_;
    Column<Corner> boundary_corner_;
    Column<Point> vertex_position_;
    Column<Corner> vertex_corner_;

    LargestGroup largest_group_;
    Holes free_vertices_, free_edges_, free_faces_, free_corners_;
};

// --- ranges ---------------------------------------------------------------------------------------------------------------

template <class H>
class Mesh::Range {
public:
    class iterator {
    public:
        using value_type = H;
        using difference_type = std::ptrdiff_t;
        iterator() = default;
        iterator(const Mesh* mesh, std::uint32_t i, std::uint32_t limit) : mesh_(mesh), i_(i), limit_(limit) { pass_holes(); }
        H operator*() const { return H(i_); }
        iterator& operator++()
        {
            ++i_;
            pass_holes();
            return *this;
        }
        iterator operator++(int)
        {
            iterator old = *this;
            ++*this;
            return old;
        }
        friend bool operator==(const iterator& a, const iterator& b) { return a.i_ == b.i_; }

    private:
        void pass_holes()
        {
            while (i_ < limit_ && !mesh_->is_alive(H(i_))) ++i_;
        }
        const Mesh* mesh_ = nullptr;
        std::uint32_t i_ = 0, limit_ = 0;
    };
    Range(const Mesh* mesh, std::uint32_t limit) : mesh_(mesh), limit_(limit) {}
    iterator begin() const { return {mesh_, 0, limit_}; }
    iterator end() const { return {mesh_, limit_, limit_}; }

private:
    const Mesh* mesh_;
    std::uint32_t limit_;
};

inline Mesh::Range<Vertex> Mesh::vertices() const { return {this, vertex_limit()}; }
inline Mesh::Range<Edge> Mesh::edges() const { return {this, edge_limit()}; }
inline Mesh::Range<Face> Mesh::faces() const { return {this, face_limit()}; }

class Mesh::BoundaryRange {
public:
    class iterator {
    public:
        using value_type = Face;
        using difference_type = std::ptrdiff_t;
        explicit iterator(std::uint32_t i = 0) : i_(i) {}
        Face operator*() const { return Face::boundary(i_); }
        iterator& operator++()
        {
            ++i_;
            return *this;
        }
        iterator operator++(int) { return iterator(i_++); }
        friend bool operator==(const iterator&, const iterator&) = default;

    private:
        std::uint32_t i_;
    };
    explicit BoundaryRange(std::uint32_t count) : count_(count) {}
    iterator begin() const { return iterator(0); }
    iterator end() const { return iterator(count_); }

private:
    std::uint32_t count_;
};

inline Mesh::BoundaryRange Mesh::boundary_faces() const { return BoundaryRange(boundary_count()); }

/// Walks a closed cycle of corners once; `Step` gives the following one.
template <class Step>
class CornerCycle {
public:
    class iterator {
    public:
        using value_type = Corner;
        using difference_type = std::ptrdiff_t;
        iterator() = default;
        iterator(const Mesh* mesh, Corner at, bool done) : mesh_(mesh), at_(at), first_(at), done_(done) {}
        Corner operator*() const { return at_; }
        iterator& operator++()
        {
            at_ = Step()(*mesh_, at_);
            done_ = at_ == first_;
            return *this;
        }
        iterator operator++(int)
        {
            iterator old = *this;
            ++*this;
            return old;
        }
        friend bool operator==(const iterator& a, const iterator& b) { return a.done_ == b.done_ && (a.done_ || a.at_ == b.at_); }

    private:
        const Mesh* mesh_ = nullptr;
        Corner at_, first_;
        bool done_ = true;
    };
    CornerCycle(const Mesh* mesh, Corner first) : mesh_(mesh), first_(first) {}
    iterator begin() const { return {mesh_, first_, false}; }
    iterator end() const { return {mesh_, first_, true}; }

private:
    const Mesh* mesh_;
    Corner first_;
};

struct NextInFace {
    Corner operator()(const Mesh& m, Corner c) const { return m.next(c); }
};
struct NextAroundVertex {
    Corner operator()(const Mesh& m, Corner c) const { return m.edge(c).valid() ? m.rotate(c) : c; }
};
class Mesh::CornerRange : public CornerCycle<NextInFace> {
    using CornerCycle::CornerCycle;
};
class Mesh::VertexRange : public CornerCycle<NextAroundVertex> {
    using CornerCycle::CornerCycle;
};

inline Mesh::CornerRange Mesh::corners(Face f) const { return {this, corner(f)}; }
inline Mesh::VertexRange Mesh::around(Vertex v) const { return {this, corner(v)}; }

/// Scratch values beside a mesh, indexed by handle.
template <class H, class T>
class ElementData {
public:
    explicit ElementData(std::size_t limit, const T& value = T()) : values_(limit, value) {}
    decltype(auto) operator[](H h) { return values_[h.index]; }
    decltype(auto) operator[](H h) const { return values_[h.index]; }
    std::size_t size() const { return values_.size(); }

private:
    std::vector<T> values_;
};
template <class T>
struct VertexData : ElementData<Vertex, T> {
    explicit VertexData(const Mesh& m, const T& value = T()) : ElementData<Vertex, T>(m.vertex_limit(), value) {}
};
template <class T>
struct EdgeData : ElementData<Edge, T> {
    explicit EdgeData(const Mesh& m, const T& value = T()) : ElementData<Edge, T>(m.edge_limit(), value) {}
};
template <class T>
struct FaceData : ElementData<Face, T> {
    explicit FaceData(const Mesh& m, const T& value = T()) : ElementData<Face, T>(m.face_limit(), value) {}
};
template <class T>
struct CornerData : ElementData<Corner, T> {
    explicit CornerData(const Mesh& m, const T& value = T()) : ElementData<Corner, T>(m.corner_limit(), value) {}
};

} // namespace druse
