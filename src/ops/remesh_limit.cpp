#include "ops/remesh_limit.h"

#include "dlfl/errors.h"
#include "ops/remesh_catmull_clark.h"
#include "ops/remesh_loop.h"
#include "ops/remesh_old_mesh.h"

#include <fmt/format.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace druse {

namespace {

/// What OpenSubdiv's factory reads: the mesh with its own edges, which vertices alone do not tell if two join the same ones.
struct Base {
    const remesh::OldMesh& mesh;
    const std::vector<Edge>& creases;
    double sharpness;
};

} // namespace
} // namespace druse

namespace OpenSubdiv {
namespace OPENSUBDIV_VERSION {
namespace Far {

template <>
bool TopologyRefinerFactory<druse::Base>::resizeComponentTopology(TopologyRefiner& refiner, const druse::Base& base)
{
    const druse::remesh::OldMesh& old = base.mesh;
    setNumBaseFaces(refiner, int(old.faces()));
    setNumBaseEdges(refiner, int(old.edges()));
    setNumBaseVertices(refiner, int(old.vertices()));
    for (std::uint32_t f = 0; f < old.faces(); ++f) setNumBaseFaceVertices(refiner, int(f), int(old.end(f) - old.begin(f)));
    for (std::uint32_t e = 0; e < old.edges(); ++e) setNumBaseEdgeFaces(refiner, int(e), 2);
    for (std::uint32_t v = 0; v < old.vertices(); ++v) {
        setNumBaseVertexFaces(refiner, int(v), int(old.valence(v)));
        setNumBaseVertexEdges(refiner, int(v), int(old.valence(v)));
    }
    return true;
}

template <>
bool TopologyRefinerFactory<druse::Base>::assignComponentTopology(TopologyRefiner& refiner, const druse::Base& base)
{
    const druse::remesh::OldMesh& old = base.mesh;
    const auto place = [&](std::uint32_t c) { return static_cast<LocalIndex>(c - old.begin(old.face(c))); };
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        IndexArray vertices = getBaseFaceVertices(refiner, int(f)), edges = getBaseFaceEdges(refiner, int(f));
        for (std::uint32_t c = old.begin(f); c < old.end(f); ++c) {
            vertices[place(c)] = int(old.vertex(c));
            edges[place(c)] = int(old.edge(c));
        }
    }
    for (std::uint32_t e = 0; e < old.edges(); ++e)
        for (std::uint32_t k = 0; k < 2; ++k) {
            const std::uint32_t c = old.corner_of_side(2 * e + k);
            getBaseEdgeVertices(refiner, int(e))[int(k)] = int(old.vertex(c));
            getBaseEdgeFaces(refiner, int(e))[int(k)] = int(old.face(c));
            getBaseEdgeFaceLocalIndices(refiner, int(e))[int(k)] = place(c);
        }
    // Counter-clockwise, each edge before the face that follows it.
    for (std::uint32_t at = 0, v = 0; v < old.vertices(); ++v)
        for (int i = 0; i < int(old.valence(v)); ++i, ++at) {
            const std::uint32_t c = old.corner_around(at);
            getBaseVertexFaces(refiner, int(v))[i] = int(old.face(c));
            getBaseVertexFaceLocalIndices(refiner, int(v))[i] = place(c);
            getBaseVertexEdges(refiner, int(v))[i] = int(old.edge(c));
            getBaseVertexEdgeLocalIndices(refiner, int(v))[i] = static_cast<LocalIndex>(old.side(c) & 1);
        }
    return true;
}

template <>
bool TopologyRefinerFactory<druse::Base>::assignComponentTags(TopologyRefiner& refiner, const druse::Base& base)
{
    for (const druse::Edge e : base.creases) setBaseEdgeSharpness(refiner, int(e.index), float(base.sharpness));
    return true;
}

template <>
void TopologyRefinerFactory<druse::Base>::reportInvalidTopology(TopologyError, const char*, const druse::Base&)
{
}
template <>
bool TopologyRefinerFactory<druse::Base>::assignFaceVaryingTopology(TopologyRefiner&, const druse::Base&)
{
    return true;
}

} // namespace Far
} // namespace OPENSUBDIV_VERSION
} // namespace OpenSubdiv

namespace druse {

namespace {

using namespace OpenSubdiv;
using namespace remesh;

std::unique_ptr<Far::TopologyRefiner> refiner_of(OldMesh& old, const LimitSurface& surface)
{
    constexpr std::uint32_t most = 65535; // OpenSubdiv counts with 16 bits around a face and a vertex
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        const std::uint32_t n = old.end(f) - old.begin(f);
        if (n > most) throw CommandError(fmt::format("face {} has {} sides, more than {}", f, n, most));
        if (n > 3 && surface.scheme == LimitScheme::loop) throw CommandError(fmt::format("face {} has {} sides; scheme=loop wants triangles", f, n));
    }
    for (std::uint32_t v = 0; v < old.vertices(); ++v)
        if (old.valence(v) > most) throw CommandError(fmt::format("vertex {} has valence {}, more than {}", v, old.valence(v), most));
    old.order_around();
    using Factory = Far::TopologyRefinerFactory<Base>;
    const Factory::Options options(surface.scheme == LimitScheme::loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK);
    std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(Base{old, surface.creases, surface.sharpness}, options));
    ASSERT(refiner != nullptr, "a sound mesh is one that OpenSubdiv takes");
    Far::TopologyRefiner::UniformOptions uniform(surface.level);
    uniform.fullTopologyInLastLevel = surface.to_limit;
    refiner->RefineUniform(uniform);
    return refiner;
}

/// Where OpenSubdiv has the elements of one of our levels: of each vertex, face and the first corner in it.
struct Correspondence {
    std::vector<int> vertex, face, turn;

    explicit Correspondence(const Mesh& base) : vertex(base.vertex_limit()), face(base.face_limit()), turn(base.face_limit(), 0)
    {
        for (std::size_t i = 0; i < vertex.size(); ++i) vertex[i] = int(i);
        for (std::size_t i = 0; i < face.size(); ++i) face[i] = int(i);
    }

    /// Goes one level on: from `level`, which holds `mesh`, to `finer`, which holds `divided`.
    void descend(const Far::TopologyLevel& level, const Mesh& mesh, const Far::TopologyLevel& finer, const Mesh& divided, LimitScheme scheme)
    {
        std::vector<int> to_vertex(divided.vertex_limit()), to_face;
        to_face.reserve(divided.face_limit());
        const std::size_t V = mesh.vertex_limit(), E = mesh.edge_limit();
        for (std::size_t v = 0; v < V; ++v) to_vertex[v] = level.GetVertexChildVertex(vertex[v]);
        for (const Face f : mesh.faces()) {
            const int there = face[f.index];
            const auto edges = level.GetFaceEdges(there), children = level.GetFaceChildFaces(there);
            if (scheme == LimitScheme::catmull_clark) to_vertex[V + E + f.index] = level.GetFaceChildVertex(there);
            else to_face.push_back(children[3]); // the inner triangle, which we number first
            int place = turn[f.index];
            for (const Corner c : mesh.corners(f)) {
                to_vertex[V + mesh.edge(c).index] = level.GetEdgeChildVertex(edges[place]);
                to_face.push_back(children[place]);
                if (++place == edges.size()) place = 0;
            }
        }
        vertex = std::move(to_vertex);
        face = std::move(to_face);
        turn.resize(face.size());
        for (const Face f : divided.faces()) {
            const auto ring = finer.GetFaceVertices(face[f.index]);
            turn[f.index] = ring.FindIndex(vertex[divided.vertex(divided.corner(f)).index]);
        }
    }
};

Mesh divided_once(const Mesh& mesh, const LimitSurface& surface, Progress& progress)
{
    return surface.scheme == LimitScheme::loop ? remeshed(mesh, Loop{false}, 1, surface.groups, progress)
                                               : remeshed(mesh, CatmullClark{false}, 1, surface.groups, progress);
}

/// The mean of the normals of the faces around a vertex, weighted by their angles there.
Vector mean_normal(const Mesh& mesh, Vertex v)
{
    Vector sum(0.0);
    for (const Corner c : mesh.around(v)) {
        const Vector out = direction(mesh.position(mesh.next(c)) - mesh.position(c)), in = direction(mesh.position(mesh.previous(c)) - mesh.position(c));
        sum += std::acos(std::clamp(glm::dot(out, in), -1.0, 1.0)) * unit(glm::cross(out, in));
    }
    return unit(sum);
}

} // namespace

struct LimitRefinement::Refined {
    /// A point as OpenSubdiv adds points up.
    struct Sum {
        Point point{0.0};
        void Clear(void* = nullptr) { point = Point(0.0); }
        void AddWithWeight(const Sum& other, double weight) { point += weight * other.point; }
    };
    std::unique_ptr<Far::TopologyRefiner> refiner;
    bool to_limit;
    std::vector<int> vertex; // of the finest level, as OpenSubdiv numbers it, by ours
    std::vector<Sum> points, finer, tangents[2];
};

LimitRefinement::LimitRefinement(LimitRefinement&&) noexcept = default;
LimitRefinement& LimitRefinement::operator=(LimitRefinement&&) noexcept = default;
LimitRefinement::~LimitRefinement() = default;

LimitRefinement::LimitRefinement(const Mesh& mesh, const LimitSurface& surface, Progress& progress) : mesh_(mesh)
{
    refuse_too_large(mesh.edge_count(), 4, surface.level);
    OldMesh old(mesh, 2);
    if (old.vertices() == 0) return; // OpenSubdiv refines no such thing
    refined_ = std::make_unique<Refined>();
    refined_->refiner = refiner_of(old, surface);
    refined_->to_limit = surface.to_limit;
    Correspondence correspondence(mesh);
    for (int i = 0; i < surface.level; ++i) {
        Mesh divided = divided_once(mesh_, surface, progress);
        correspondence.descend(refined_->refiner->GetLevel(i), mesh_, refined_->refiner->GetLevel(i + 1), divided, surface.scheme);
        mesh_ = std::move(divided);
    }
    refined_->vertex = std::move(correspondence.vertex);
}

void LimitRefinement::place(std::span<const Point> old) { find_places(old, false); }
void LimitRefinement::place_with_normals(std::span<const Point> old) { find_places(old, true); }

void LimitRefinement::find_places(std::span<const Point> old, bool with_normals)
{
    if (!refined_) return;
    auto& [refiner, to_limit, vertex, points, finer, tangents] = *refined_;
    ASSERT(old.size() == std::size_t(refiner->GetLevel(0).GetNumVertices()), "the vertices of the mesh that was refined");
    ASSERT(to_limit || !with_normals, "normals of the limit surface only");
    const Far::PrimvarRefinerReal<double> interpolation(*refiner);
    points.clear();
    for (const Point& p : old) points.push_back({p});
    for (int i = 1; i < refiner->GetNumLevels(); ++i) {
        finer.resize(std::size_t(refiner->GetLevel(i).GetNumVertices())); // every one is cleared before it is added to
        interpolation.Interpolate(i, points, finer);
        std::swap(points, finer);
    }
    if (with_normals) {
        for (std::vector<Refined::Sum>* sums : {&finer, &tangents[0], &tangents[1]}) sums->resize(points.size());
        interpolation.Limit(points, finer, tangents[0], tangents[1]);
        std::swap(points, finer);
    } else if (to_limit) {
        finer.resize(points.size());
        interpolation.Limit(points, finer);
        std::swap(points, finer);
    }
    const std::span<Point> to = mesh_.write_positions();
    for (std::size_t v = 0; v < to.size(); ++v) to[v] = points[std::size_t(vertex[v])].point;
    if (!with_normals) return;

    const Far::TopologyLevel& finest = refiner->GetLevel(refiner->GetMaxLevel());
    normals_.resize(to.size());
    for (std::size_t v = 0; v < to.size(); ++v) {
        const auto there = std::size_t(vertex[v]);
        const Sdc::Crease::Rule rule = finest.GetVertexRule(vertex[v]);
        const bool smooth = rule == Sdc::Crease::RULE_SMOOTH || rule == Sdc::Crease::RULE_DART;
        const Vector normal = glm::cross(direction(tangents[0][there].point), direction(tangents[1][there].point));
        constexpr double parallel = 1e-9;
        normals_[v] = smooth && glm::dot(normal, normal) > parallel * parallel ? unit(normal) : mean_normal(mesh_, Vertex(std::uint32_t(v)));
    }
}

Mesh limit_surface(const Mesh& mesh, const LimitSurface& surface, Progress& progress)
{
    LimitRefinement refinement(mesh, surface, progress);
    refinement.place(mesh.positions());
    return std::move(refinement).take();
}

namespace {

struct SubdivideLimit {
    LimitScheme scheme = LimitScheme::catmull_clark;
    int level = 2;
    EdgeSelector crease = EdgeSelector::none();
    double sharpness = 10;
    RemeshGroups groups = RemeshGroups::keep;
};

} // namespace

void add_remesh_limit(Registry& registry)
{
    using P = SubdivideLimit;
    auto definition = define<P>("remesh.subdivide_limit", "Subdivide, and move the points to the surface that this goes to without end");
    definition.param(&P::scheme, "scheme", words({"catmull_clark", "loop"}), "loop is for triangles")
        .param(&P::level, "level", Unit::count, {1, 8}, "how often")
        .param(&P::crease, "crease", "edges that stay sharp")
        .param(&P::sharpness, "sharpness", Unit::count, {0, 10}, "of the creases: 10 for good, less for as many levels")
        .param(&P::groups, "groups", words({"absolute", "keep", "none"}), "group ids: by where a new face comes from, of the old faces, or none")
        .keeps_euler()
        .example("remesh.subdivide_limit level=3 crease=all sharpness=1.5")
        .cites("Catmull & Clark 1978; Loop 1987; DeRose, Kass & Truong 1998")
        .run([](Scene& scene, const P& p, Context& context) {
            const LimitSurface surface{p.scheme, p.level, p.crease.resolve(scene), p.sharpness, true, p.groups};
            scene.mesh.replace_with(limit_surface(scene.mesh, surface, context.progress));
            scene.selection.edit() = Selection();
        });
    registry.add(definition);
}

} // namespace druse
