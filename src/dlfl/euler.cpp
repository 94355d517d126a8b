// The four minimal operators. Each gathers what it touches, links the corners, then settles vertices and faces.
#include "dlfl/errors.h"
#include "dlfl/mesh.h"


namespace druse {

Vertex Mesh::create_vertex(const Point& p)
{
    ASSERT(is_in_reach(p), "coordinates within reach");
    const Vertex v = new_vertex(p);
    const Corner c = new_corner(v);
    link(c, c);
    vertex_corner_.set(v.index, c);
    corner_face_.set(c.index, new_face(c, 0));
    return v;
}

void Mesh::delete_vertex(Vertex v)
{
    const Corner c = corner(v);
    ASSERT(is_point_sphere(v), "a point sphere");
    free_face(face(c));
    free_corner(c);
    free_vertex(v);
}

/// Gives the cycle of `from` the face `f`, and says whether the start corner of `f` lies in it.
bool Mesh::relabel(Corner from, Face f)
{
    const Corner start = corner(f);
    bool has_start = false;
    Corner c = from;
    do {
        if (face(c) != f) corner_face_.set(c.index, f);
        has_start = has_start || c == start;
        c = next(c);
    } while (c != from);
    return has_start;
}

Edge Mesh::insert_edge(Corner c1, Corner c2)
{
    ASSERT(c1 != c2, "two different corners");
    const Face f1 = face(c1), f2 = face(c2);
    ASSERT(!f1.is_boundary() && !f2.is_boundary(), "corners of faces, not of an open boundary");

    const bool alone1 = !edge(c1).valid(), alone2 = !edge(c2).valid();
    const Corner after1 = next(c1), after2 = next(c2);
    const Edge out1 = edge(c1), out2 = edge(c2);

    // The new corners take over the edges that went out at c1 and c2.
    const Corner n1 = alone1 ? c1 : new_corner(vertex(c1));
    const Corner n2 = alone2 ? c2 : new_corner(vertex(c2));
    if (!alone1) {
        corner_edge_.set(n1.index, out1);
        replace_edge_corner(out1, c1, n1);
        corner_face_.set(n1.index, f1);
    }
    if (!alone2) {
        corner_edge_.set(n2.index, out2);
        replace_edge_corner(out2, c2, n2);
        corner_face_.set(n2.index, f2);
    }
    link(c1, n2);
    link(c2, n1);
    if (!alone1) link(n1, after1);
    if (!alone2) link(n2, after2);
    const Edge e = new_edge(c1, c2);

    if (f1 == f2) {
        // Two cycles now: the one with the start corner keeps the face.
        const Corner other = relabel(c1, f1) ? c2 : c1;
        const Face made = new_face(other, group(f1));
        relabel(other, made);
    } else {
        const Face stays = f1 < f2 ? f1 : f2, goes = f1 < f2 ? f2 : f1;
        relabel(c1, stays);
        free_face(goes);
    }
    return e;
}

void Mesh::delete_edge(Edge e, bool cleanup)
{
    const auto [a, b] = edge_corners_[e.index];
    const Face fa = face(a), fb = face(b);
    ASSERT(!fa.is_boundary() && !fb.is_boundary(), "an edge that is not on an open boundary");
    const Corner na = next(a), nb = next(b);

    // At each end of the edge the two corners beside it become one. `keep` takes over the side that starts at `gone`.
    const auto merge = [this](Corner keep, Corner gone) {
        const Edge out = edge(gone);
        corner_edge_.set(keep.index, out);
        replace_edge_corner(out, gone, keep);
        link(keep, next(gone));
    };
    const auto retire = [this](Corner gone, Corner keep) {
        if (corner(vertex(gone)) == gone) vertex_corner_.set(vertex(gone).index, keep);
        if (const Face f = face(gone); corner(f) == gone) set_face_corner(f, keep);
        free_corner(gone);
    };
    const auto isolate = [this](Corner c) {
        corner_edge_.set(c.index, Edge());
        link(c, c);
    };
    free_edge(e);

    if (na == a || nb == b) {
        // A loop around a one-sided face: the three corners of its vertex beside it become one.
        const Corner lone = nb == b ? b : a, keep = nb == b ? a : b, gone = next(keep);
        if (gone == keep) isolate(keep);
        else merge(keep, gone);
        const Face stays = fa < fb ? fa : fb, goes = fa < fb ? fb : fa;
        retire(lone, keep);
        if (gone != keep) retire(gone, keep);
        relabel(keep, stays);
        free_face(goes);
        if (cleanup && is_point_sphere(vertex(keep))) delete_vertex(vertex(keep));
        return;
    }

    const bool alone_a = nb == a, alone_b = na == b;
    if (alone_a) isolate(a);
    else merge(a, nb);
    if (alone_b) isolate(b);
    else merge(b, na);
    if (!alone_a) retire(nb, a);
    if (!alone_b) retire(na, b);

    if (fa == fb) {
        // The face falls apart. The part with its start corner keeps it, unless that part is a bare vertex and the other is not.
        const bool a_has_start = relabel(a, fa);
        const bool a_keeps = alone_a != alone_b ? alone_b : a_has_start;
        const Corner keeps = a_keeps ? a : b, leaves = a_keeps ? b : a;
        if (a_keeps != a_has_start) set_face_corner(fa, keeps);
        const Face made = new_face(leaves, group(fa));
        relabel(leaves, made);
    } else {
        const Face stays = fa < fb ? fa : fb, goes = fa < fb ? fb : fa;
        relabel(a, stays);
        free_face(goes);
    }
    if (cleanup) {
        const Vertex va = vertex(a), vb = vertex(b);
        if (alone_a) delete_vertex(va);
        if (alone_b) delete_vertex(vb);
    }
}

} // namespace druse
