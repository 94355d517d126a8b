#pragma once

#include "dlfl/check.h"
#include "dlfl/measures.h"
#include "dlfl/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <vector>

namespace druse {

inline void PrintTo(const Counts& c, std::ostream* out) { *out << "V " << c.vertices << ", E " << c.edges << ", F " << c.faces; }
template <class Tag>
void PrintTo(Handle<Tag> h, std::ostream* out)
{
    *out << h.index;
}
inline void PrintTo(Face f, std::ostream* out) { *out << (f.is_boundary() ? "boundary " : "") << (f.is_boundary() ? f.boundary_index() : f.index); }

namespace test {

/// Every rule of the doubly linked face list holds; otherwise the failure names the first broken one.
#define EXPECT_SOUND(mesh) EXPECT_EQ(::druse::check(mesh), "")
#define ASSERT_SOUND(mesh) ASSERT_EQ(::druse::check(mesh), "")

inline Counts counts(const Mesh& mesh) { return mesh.counts(); }
inline int valence(const Mesh& mesh, Face f) { return mesh.valence(f); }
inline int valence(const Mesh& mesh, Vertex v) { return mesh.valence(v); }
inline Face first_face(const Mesh& mesh) { return *mesh.faces().begin(); }

/// The vertices of a face by id, from its start corner.
inline std::vector<std::uint32_t> ring(const Mesh& mesh, Face f)
{
    std::vector<std::uint32_t> ids;
    for (const Corner c : mesh.corners(f)) ids.push_back(mesh.vertex(c).index);
    return ids;
}

/// ring() of every face, by id: what an index file would hold.
inline std::vector<std::vector<std::uint32_t>> rings(const Mesh& mesh)
{
    std::vector<std::vector<std::uint32_t>> all;
    for (const Face f : mesh.faces()) all.push_back(ring(mesh, f));
    return all;
}

struct EdgeLengths {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0, mean = 0;
    /// (longest − shortest) / mean
    double relative_spread() const { return mean > 0 ? (longest - shortest) / mean : 0; }
};

inline EdgeLengths edge_lengths(const Mesh& mesh)
{
    EdgeLengths r;
    for (const Edge e : mesh.edges()) {
        const double l = length(mesh, e);
        r.shortest = std::min(r.shortest, l);
        r.longest = std::max(r.longest, l);
        r.mean += l / mesh.edge_count();
    }
    return r;
}

/// The largest distance of a corner from the plane of its face, in mean edge lengths: 0 where every face is flat.
inline double flatness(const Mesh& mesh)
{
    double most = 0;
    for (const Face f : mesh.faces()) most = std::max(most, nonplanarity(mesh, f));
    const double mean = edge_lengths(mesh).mean;
    return mean > 0 ? most / mean : most;
}

} // namespace test
} // namespace druse
