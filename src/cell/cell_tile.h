#pragma once

#include "cell/cell_design.h"
#include "cell/cell_refusal.h"
#include "cell/pane_mesh.h"
#include "cell/parallelohedron.h"
#include "pane/pane.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace druse {

/// A tile of space whose translates fill it: a parallelohedron with points and lines on its faces, which are moved in space by all that the lattice makes of
/// them at once. A value; a CellDesign tells all of it.
///
/// Points are numbered by orbits under the lattice: corners, then points of edges, then those inside panes, then those that splits made. Only the first of an
/// orbit has a place of its own, the others are steps of the lattice away, so tiles fit whatever is moved. Places are in the frame of the
/// cell, before the matrix, which acts on everything.
///
/// Phase I, flat: points and lines of each pane, and points on its sides; triangles are those of a Pane. Phase II, after shape(): points move, and the triangles
/// stay but for splits and flips. A pane may go back to phase I alone: roll_back(), then shape().
///
/// An edit happens whole or throws (CellRefusal, PaneRefusal or another CommandError) and changes nothing; notes() then tells of the last one.
/// Copies share what is alike. Cost: of an edit in a pane, to triangulate that pane; of a move, the moved points of its panes. Reading is safe in several threads.
/// Source: Howison & Séquin 2009, section 3.
class CellTile {
public:
    using Index = PaneMesh::Index;
    using Reason = CellRefusal::Reason;

    /// @throws CommandError where the design is none of a cell
    explicit CellTile(CellDesign design);
    static CellTile of_kind(CellKind kind, double size = 1.0, std::optional<double> height = {});

    // --- reading ---------------------------------------------------------------------------------------------------------------------------
    CellDesign design() const;
    const Parallelohedron& cell() const { return *cell_; }
    double size() const { return size_; }
    double weld() const { return 1e-9 * size_; } // points nearer than this are one
    double snap() const { return size_ / 500; }  // new places this near to something mean it
    int phase() const { return phase_; }
    bool is_flat(int pane) const { return phase_ == 1 || flat_.contains(pane); }
    const CellMatrix& matrix() const { return matrix_; }
    double determinant() const;
    /// Where a place of the frame lies in the world; directions go the same way.
    Vector world(const Vector& v) const;
    /// det M · det L: what a tile takes of space.
    double volume() const { return determinant() * cell_->volume(); }

    // --- points by orbit ---------------------------------------------------------------------------------------------------------------------
    int point_count() const { return first_split_ + static_cast<int>(splits_.size()); }
    CellPointName name(int point) const;
    /// @throws CellRefusal no_such_point, also for a point of a pane that is not named
    int find(const CellPointName& name) const;
    /// Where a name says which of an orbit it means, as p0:v2 does, that one; else the first.
    OrbitMember find_member(const CellPointName& name) const;
    Point base(int point) const;    // as it was flat
    Vector moved(int point) const;
    Point position(int point) const { return base(point) + moved(point); }
    /// The steps to all points of the tile in this orbit, from the first one, which is {}.
    std::span<const LatticeStep> members(int point) const;
    /// The pane that has the point inside, or −1.
    int pane_of(int point) const;

    // --- panes -----------------------------------------------------------------------------------------------------------------------------------
    int pane_count() const { return static_cast<int>(panes_.size()); }
    const PaneMesh& mesh(int pane) const { return at(pane).mesh; }
    /// Which point one of a pane's mesh is, and where of its orbit.
    OrbitMember pane_point(int pane, Index point) const;
    CellPointName pane_name(int pane, Index point) const; // without the pane in it
    /// @throws CellRefusal no_such_point
    Index find_in_pane(int pane, const CellPointName& name) const;
    Point2 flat_place(int pane, Index point) const;
    const std::vector<Point2>& interior(int pane) const { return at(pane).interior; }
    const std::vector<double>& edge_points(int edge) const { return edges_[static_cast<std::size_t>(edge)]; }
    std::vector<std::array<Index, 2>> constrained_edges(int pane) const;
    /// The triangulation, to try an edit on: ids are numbers of the mesh.
    Pane make_pane(int pane) const;

    // --- phase I -----------------------------------------------------------------------------------------------------------------------------------
    /// The point made, or the one that is there within snap(); beside a side, a point of its edge orbit.
    CellPointName add_point(int pane, const Point2& at);
    void move_point(const CellPointName& point, const Point2& to);
    /// Points inside panes, and of edges, in one step. Where lines cross there is a point however often it is removed; a note says so.
    /// Cost: each pane and edge orbit once, however many of its points go.
    void remove_points(std::span<const CellPointName> points);
    CellPointName add_edge_point(int edge, double t);
    void remove_edge_points(std::span<const CellPointName> points); // as remove_points, of edges only
    void constrain(int pane, std::span<const CellPointName> path);
    void unconstrain(int pane, std::span<const CellPointName> path);
    Pane::Refined refine(int pane, const Pane::Refinement& refinement, Progress* progress = nullptr);

    // --- phase II ------------------------------------------------------------------------------------------------------------------------------------
    /// Enters phase II; or takes panes that were rolled back into it again.
    void shape();
    /// @throws CommandError where a point is moved farther than coordinates reach
    static void check_moved(const CellPointName& point, const Vector& by);
    /// Moves points with their orbits, each once however often it is given.
    void move(std::span<const int> points, const Vector& by);
    /// The direction from the centre through a point, or that of a pane's normal; of length 1.
    Vector radial(const OrbitMember& point) const;
    Vector normal(int pane) const { return at_pane(pane).normal; }
    Vector in_plane(int pane, const Point2& by) const { return by.x * at_pane(pane).right + by.y * at_pane(pane).up; }
    CellPointName split_triangle(int pane, int triangle, const std::array<double, 3>& at);
    /// An edge is told by its ends. Where one is a split that lies on two sides of the pane, the one that has the edge is meant. @throws CellRefusal no_such_edge, also
    /// where both have
    std::array<Index, 2> edge_between(int pane, const std::array<CellPointName, 2>& ends) const;
    /// Splits an edge of a pane with all triangles that it is a side of; one of a side of the pane, with its orbit.
    CellPointName split_edge(int pane, const CellPointName& from, const CellPointName& to, double t);
    void flip(int pane, const CellPointName& from, const CellPointName& to);
    /// Takes one pane back to phase I: its splits and flips go. With `keep`, its points keep how they were moved, and new ones take what their neighbours
    /// have when shape() follows; else they are all flat.
    void roll_back(int pane, bool keep = true);

    // --- both ------------------------------------------------------------------------------------------------------------------------------------------
    void set_matrix(const CellMatrix& matrix);

    std::size_t bytes() const; // of memory, beside the tile itself, that no copy shares
    friend bool operator==(const CellTile& a, const CellTile& b) { return a.design() == b.design(); }
    /// What there is to say about the last edit, one line each.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    using Chains = std::vector<std::vector<CellPointName>>;
    struct PanePart {
        std::vector<Point2> interior;
        Chains segments;
        PaneMesh mesh;
    };
    struct Split { // a point that one made
        int pane = -1, edge = -1; // inside that pane, or on that edge orbit
        Point base{0.0};
        Vector moved{0.0};
        std::array<CellPointName, 2> ends{}; // of an edge orbit: between which points it came, as the orbit runs
    };
    struct Flat {
        bool keep = true;
        std::vector<bool> fresh; // by point inside
        std::string kept;        // of its file
    };
    template <class T>
    using Kept = std::shared_ptr<T>; // written to only by who has it alone
    template <class T>
    static T& own(Kept<T>& kept)
    {
        if (kept.use_count() > 1) kept = std::make_shared<T>(*kept);
        return *kept;
    }
    template <class F>
    CellPointName change_pane(int pane, F&& change);
    void remove_inside(int pane, const std::set<Index>& numbers);

    const PanePart& at(int pane) const { return *panes_[static_cast<std::size_t>(pane)]; }
    const CellPane& at_pane(int pane) const { return cell_->panes[static_cast<std::size_t>(pane)]; }
    const std::vector<Vector>& moved_in(int pane) const { return *moved_[static_cast<std::size_t>(pane)]; }
    void require_pane(int pane) const;
    void require_flat(int pane, const char* what) const;
    void require_shaped(const char* what) const;
    void require_not_flat(int pane) const;
    void number_points();
    Index rim_count(int pane) const; // points along its outline, without splits
    Index corner_number(int pane, int corner) const;
    Index side_number(int pane, int side, int index) const;
    int side_of(int pane, Index a, Index b) const; // on which both lie, or −1
    Index interior_number(const CellPointName& point) const;
    void take_pane(int pane, const Pane& made);
    void require_no_slivers(int pane, const PaneMesh& mesh) const;
    void fill_fresh(int pane);
    void set_moved(int point, const Vector& to);
    void set_edge_points(int edge, std::vector<double> t);
    Chains chains_after(const CellTile& before, int pane) const;
    void apply(const CellDetail& detail, std::optional<Vector> moved);
    void split_inside(const CellDetail& detail, std::optional<Vector> moved);
    void split_at(const CellDetail& detail, std::optional<Vector> moved);
    CellPointName add_detail(const CellDetail& detail);
    void split_side(int split, std::optional<int> only = {});
    void flip(const CellDetail& detail);
    bool is_side(const CellDetail& detail) const;
    bool has_edge(const OrbitMember& a, const OrbitMember& b) const;
    std::array<CellPointName, 2> ends_in_pane(int pane, const CellPointName& from, const CellPointName& to) const;
    std::vector<Index> places_in_pane(int pane, const CellPointName& name) const;
    std::vector<PointId> line_points(int pane, std::span<const CellPointName> path) const;
    PaneMesh& edit_mesh(int pane) { return own(panes_[static_cast<std::size_t>(pane)]).mesh; }
    std::string named(int pane, const std::string& text) const;

    std::shared_ptr<const Parallelohedron> cell_;
    double size_ = 1;
    std::optional<double> height_;
    CellMatrix matrix_{1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::vector<Kept<PanePart>> panes_;
    std::vector<std::vector<double>> edges_;
    int phase_ = 1;
    std::map<int, Flat> flat_;
    std::vector<Vector> corner_moved_;
    std::vector<std::vector<Vector>> edge_moved_;
    std::vector<Kept<std::vector<Vector>>> moved_; // of points inside panes
    std::vector<CellDetail> details_;
    std::vector<Split> splits_;
    std::string kept_;
    std::vector<std::string> notes_;

    std::vector<int> first_edge_, first_inner_; // numbers of the first points of each edge orbit and pane, and one past the last
    int first_split_ = 0;
};

} // namespace druse
