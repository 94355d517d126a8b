#pragma once

#include "dlfl/self_intersections.h"
#include "geom/infinity.h"
#include "ops/operator.h"
#include "ops/pipe.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace druse {

// --- crust ------------------------------------------------------------------------------------------------------------------------

enum class CrustBy { thickness, scale };
enum class Guard { warn, limit, error, off };

/// How the second surface of a crust is placed.
struct CrustShape {
    CrustBy by = CrustBy::thickness;
    OrWord<double> thickness = 0.1; // above 0 the copy goes inward, below 0 the given surface goes outward
    bool uniform = false;
    double limit = 4;               // most a vertex may move with `uniform`, in thicknesses
    double scale = 0.9;             // below 1 the copy is scaled, above 1 the given surface
    OrWord<Point> center = "vertices";
    Guard guard = Guard::warn;
};

/// Where the vertices of a surface go for each unit of thickness.
struct CrustOffsets {
    std::vector<Vector> outward; // by vertex
    std::uint32_t folded = 0;    // vertices whose normals add up to nothing, moved along that of their largest face
    std::uint32_t still = 0;     // vertices of faces without area only, which have no direction to move in
    std::uint32_t limited = 0;   // vertices that would move farther than the limit
};

/// Offsets along the mean of the unit normals at a vertex, as published; or, `uniform`, such that every face moves by the thickness: n · d = 1
/// for the normals at the vertex in the sense of least squares, and of these the shortest. Cost: O(corners).
CrustOffsets crust_offsets(const Mesh& mesh, bool uniform, double limit);

/// Up to which thickness a crust is expected to be well, and where it would be well no longer.
struct ThicknessLimit {
    enum class By {
        nothing,
        turn,   // `face` turns over at `vertex`
        vertex, // `vertex` comes up against a wall
        face,   // the centre of `face` does
        stuck   // `vertex` leads out of a face of its own, so that the crust meets itself there however thin
    };
    double safe = infinity;
    By by = By::nothing;
    Vertex vertex;
    Face face;
    std::string text() const; // `face 3 turns over at vertex 5`
};

/// 0.95 of the least thickness at which a corner of a face turns over or opposite walls meet; infinite where nothing ever does, or not up to
/// `enough`, so that no more is found out than who asks wants to know. At a rim so sharp that the mean normal looks past one of its faces the
/// offset of a vertex leads out of that face, or along it. That may be well all the same, as where other faces stand between, and well outward
/// but not inward; so where there is such a vertex a very thin crust is made and tried, and if it meets itself at one of them, nothing is safe.
/// Cost: a ray for each vertex and each face, 1 to 3 µs; a fraction of it for an `enough` that is thin. Where there is such a vertex, that of
/// a crust and of self_intersections() besides. @throws Cancelled
ThicknessLimit thickness_limit(const Mesh& mesh, const CrustOffsets& offsets, bool outward, Progress& progress, double enough = infinity);

/// The number alone: the mark on the slider of a thickness.
inline double safe_thickness(const Mesh& mesh, const CrustOffsets& offsets, bool outward, Progress& progress, double enough = infinity)
{
    return thickness_limit(mesh, offsets, outward, progress, enough).safe;
}

/// What crosses in a crust of that thickness, which is made for this and given up again; below 0 the surface moves outward.
/// @throws Cancelled
SelfIntersections crust_crossings(const Mesh& mesh, const CrustOffsets& offsets, double thickness, Progress& progress);

/// What is wrong with a crust that has been made.
struct CrustFaults {
    static constexpr std::uint64_t most = 10'000; // pairs of triangles to look for
    SelfIntersections met;         // triangles that meet, within the two surfaces and between them
    std::uint32_t turned_over = 0; // closed components whose copy encloses its volume the other way round
    bool any() const { return met.pairs > 0 || turned_over > 0; }
    std::string text() const; // `24 pairs of triangles cross, 1 surface is turned inside out`
};

/// The centre of a shape by one of its names, or the point given. @throws CommandError for the volume of a shape that has none
Point shape_center(const Mesh& mesh, const OrWord<Point>& center);

/// Adds a copy of everything, turned inside out: vertex v becomes V + v, face f becomes F + f, from the same start corner. V, E, F, the
/// components and the genus are doubled. Its edges follow as its faces, from F on, first use them. An open boundary is doubled with the rest and
/// joined to its copy by walls, so that a sheet becomes a plate; faces and vertices keep their ids, edges are numbered anew as faces use them.
/// Cost: linear. @return the walls over open boundaries
std::vector<Face> add_reversed_copy(Scene& scene);

// --- openings ---------------------------------------------------------------------------------------------------------------------

/// Opens pairs of a rind, given by corresponding corners. Keeps scratch memory from call to call.
class Opener {
public:
    explicit Opener(Mesh& mesh) : mesh_(mesh), maker_(mesh) {}

    /// A pipe between the two faces. Adds the walls. Cost: O(sides). @throws CommandError where topology.pipe would
    void punch(const std::array<Corner, 2>& pair, std::vector<Face>& walls);

    /// The same, and takes away the infinitely thin walls that stand between the new hole and its neighbours: walls that reach both from the one
    /// face and from the other. Where all faces around a vertex are open, it goes. Cost: O(sides) for neighbours of
    /// moderate size.
    void peel(const std::array<Corner, 2>& pair, std::vector<Face>& walls);

private:
    /// A side of the first face, and the corner where it starts.
    struct Side {
        Vertex vertex, below; // the corner, and the one that belongs to it
        Edge outer, inner;
        bool thin = false;    // the wall over the side reaches both faces
        Edge rung;            // where that wall ends
    };
    const Side& at(std::size_t i) const { return sides_[i % sides_.size()]; }
    void require_openable(const std::array<Corner, 2>& pair) const;
    bool find_thin_walls(const std::array<Corner, 2>& pair);
    void remove(Edge e);
    void merge_rungs(Edge rung, const Side& corner);
    void build_walls(std::size_t first, std::vector<Face>& walls);

    Mesh& mesh_;
    PipeMaker maker_;
    std::vector<Side> sides_;
};

/// The edges that join two vertices, in their rotation around the first one.
std::vector<Corner> columns_between(const Mesh& mesh, Vertex v, Vertex w);
/// True if faces remain in two or more wedges around v, which only touch along the edges from v to w.
bool is_pinched(const Mesh& mesh, Vertex v, Vertex w);

/// Gives each wedge its own ends of its own edge, at every pair of vertices. Faces keep ids, edges do not. Cost: O(mesh).
void cut_columns(Scene& scene, const std::vector<std::array<Vertex, 2>>& columns);

// --- registration -----------------------------------------------------------------------------------------------------------------

Operator rind_crust_operator();
Operator rind_punch_operator();
Operator rind_peel_operator();
Operator rind_nest_operator();

} // namespace druse
