#include "pane/triangulation.h"

#include "dlfl/errors.h"

#include <cstring>

namespace druse {

using Index = Triangulation::Index;

Triangulation::Triangulation(const Point2& min, const Point2& max)
{
    const std::array<Point2, 4> places{min, Point2(max.x, min.y), max, Point2(min.x, max.y)};
    for (std::size_t i = 0; i < 4; ++i) state_.corners[i] = new_vertex(places[i]);
    const auto& c = state_.corners;
    const Index s = new_face(0), t = new_face(0);
    const auto fill = [&](Index face, Index u, Index v, Index w) {
        const std::array<Index, 3> around{u, v, w};
        for (Index k = 0; k < 3; ++k) {
            side(face + k) = {around[k], none};
            set_out(around[k], face + k);
        }
    };
    fill(s, c[0], c[1], c[2]);
    fill(t, c[0], c[2], c[3]);
    glue(s + 2, t, 0);
    for (const Index h : {s, s + 1, t + 1, t + 2}) put_bits(h, hull_bit);
    if (wants_flip(s + 2)) flip(s + 2);
}

bool Triangulation::in_box(const Point2& p) const
{
    const Point2 &min = position(state_.corners[0]), &max = position(state_.corners[2]);
    return p.x > min.x && p.x < max.x && p.y > min.y && p.y < max.y;
}

Index Triangulation::find_side(Index u, Index v) const
{
    const Index from_u = out(u), from_v = out(v);
    Index h = from_u, g = from_v;
    do { // about both ends at once: one of them may have very many sides
        if (target(h) == v) return h;
        if (target(g) == u) return twin(g);
        h = turn(h);
        g = turn(g);
    } while (h != from_u && g != from_v);
    return none;
}

// --- memory -----------------------------------------------------------------------------------------------------------------------

Index Triangulation::new_face(std::uint32_t flags)
{
    Index h = state_.free_faces;
    if (h != none) {
        touch(h);
        state_.free_faces = sides_[h | 3].twin;
    } else {
        h = sides_.add({none, none});
    }
    side(h | 3) = {flags, none};
    return h;
}

void Triangulation::free_face(Index h)
{
    touch(h);
    side(h | 3) = {dead_bit, state_.free_faces};
    state_.free_faces = face(h);
}

Index Triangulation::new_vertex(const Point2& p)
{
    ++state_.vertices;
    const Index v = state_.free_vertices;
    if (v == none)
        return vertices_.add({p, none});
    state_.free_vertices = out(v);
    vertices_.change(v).place = p;
    return v;
}

void Triangulation::free_vertex(Index v)
{
    --state_.vertices;
    set_out(v, state_.free_vertices);
    state_.free_vertices = v;
}

/// Makes g and h the two sides of one edge; h may be none, for an edge of the box.
void Triangulation::glue(Index g, Index h, std::uint32_t edge)
{
    side(g).twin = h;
    put_bits(g, edge);
    if (h == none) return;
    touch(h);
    side(h).twin = g;
    put_bits(h, edge);
}

/// h now belongs to an edge whose other side is g; what the edge carries has not changed.
inline void Triangulation::lead_back(Index h, Index g)
{
    if (h == none) return;
    touch(h);
    sides_.kept(h).twin = g;
}

inline void Triangulation::put_bits(Index h, std::uint32_t edge)
{
    Index& word = side(h | 3).origin;
    word = (word & ~(edge_bits << (h & 3))) | (edge << (h & 3));
}

void Triangulation::set_bits(Index h, std::uint32_t edge)
{
    for (const Index g : {h, twin(h)})
        if (g != none && (bits(g) & edge) != edge) {
            touch(g);
            put_bits(g, bits(g) | edge);
        }
}

void Triangulation::clear_bits(Index h, std::uint32_t edge)
{
    if ((bits(h) & edge) == 0) return;
    if ((bits(h) & edge & loop_bit) != 0 && sides_.is_recording()) sides_.watch();
    for (const Index g : {h, twin(h)}) {
        touch(g);
        put_bits(g, bits(g) & ~edge);
    }
    queue_.push_back(h);
}

void Triangulation::set_inside(Index h, bool inside)
{
    if (is_inside(h) == inside) return;
    touch(h);
    side(h | 3).origin ^= inside_bit;
}

// --- vertices ---------------------------------------------------------------------------------------------------------------------

void Triangulation::split_face(Index h, Index v)
{
    const Index t = face(h), word = flags(t), kind = word & inside_bit;
    const Index s = new_face(kind), r = new_face(kind);
    touch(t);
    Side* const sides = sides_.writable();
    const Index a = sides[t].origin, b = sides[t + 1].origin, c = sides[t + 2].origin;
    const Index twin1 = sides[t + 1].twin, twin2 = sides[t + 2].twin;
    // t: a b v, s: b c v, r: c a v
    sides[t + 1].twin = s + 2;
    sides[t + 2] = {v, r + 1};
    sides[s] = {b, twin1};
    sides[s + 1] = {c, r + 2};
    sides[s + 2] = {v, t + 1};
    sides[r] = {c, twin2};
    sides[r + 1] = {a, t + 2};
    sides[r + 2] = {v, s + 1};
    lead_back(twin1, s);
    lead_back(twin2, r);
    if ((word & any_bits) != 0) { // what lay on the second and third side lies on the first of the new faces
        sides[t | 3].origin = word & (inside_bit | edge_bits);
        sides[s | 3].origin |= (word >> 1) & edge_bits;
        sides[r | 3].origin |= (word >> 2) & edge_bits;
    }
    if (out(c) == t + 2) set_out(c, r);
    set_out(v, t + 2);
}

void Triangulation::split_side(Index h, Index v)
{
    const Index o = twin(h), hn = next(h), on = next(o);
    const std::uint32_t edge = bits(h), bits_n = bits(hn), bits_o = bits(on);
    const Index s = new_face((flags(h) & inside_bit) | edge | bits_n << 1), r = new_face((flags(o) & inside_bit) | edge | bits_o << 1);
    touch(h);
    touch(o);
    const Index a = origin(h), b = origin(o), c = apex(h), d = apex(o), twin_n = twin(hn), twin_o = twin(on);
    Side* const sides = sides_.writable();
    // h: a v c, s: v b c, o: b v d, r: v a d
    sides[h].twin = r;
    sides[o].twin = s;
    sides[hn] = {v, s + 2};
    sides[on] = {v, r + 2};
    sides[s] = {v, o};
    sides[s + 1] = {b, twin_n};
    sides[s + 2] = {c, hn};
    sides[r] = {v, h};
    sides[r + 1] = {a, twin_o};
    sides[r + 2] = {d, on};
    lead_back(twin_n, s + 1);
    lead_back(twin_o, r + 1);
    put_bits(hn, 0);
    put_bits(on, 0);
    if (out(b) == hn) set_out(b, s + 1);
    if (out(a) == on) set_out(a, r + 1);
    set_out(v, s);
}

/// Ties the vertex v, alone so far, to the face or side that it lies in.
void Triangulation::join(Index v, const Place& at)
{
    for (Index h = face(at.side); h < (at.side | 3); ++h) // in a large pane these are far apart in memory: fetched all at once
        if (twin(h) != none) __builtin_prefetch(&vertices_[apex(twin(h))]);
    if (at.kind == Place::Kind::face) split_face(at.side, v);
    else split_side(at.side, v);
    legalise_star(v);
}

Index Triangulation::insert(const Point2& p, const Place& at)
{
    ASSERT(at.kind != Place::Kind::vertex, "a new vertex is not where one is");
    const Index v = new_vertex(p);
    join(v, at);
    remember(p, out(v));
    return v;
}

bool Triangulation::move(Index v, const Point2& p)
{
    const Index first = out(v);
    Index h = first;
    do {
        if (orient(position(target(h)), position(apex(h)), p) <= 0) return false;
        h = turn(h);
    } while (h != first);
    vertices_.change(v).place = p;
    do {
        queue_.push_back(h);
        queue_.push_back(next(h));
        h = turn(h);
    } while (h != first);
    legalise();
    remember(p, out(v));
    return true;
}

// --- flips ------------------------------------------------------------------------------------------------------------------------

bool Triangulation::wants_flip(Index h) const
{
    return incircle_in_order(position(origin(h)), position(target(h)), position(apex(h)), position(apex(twin(h)))) > 0;
}

/// Turns the edge a b of the faces a b c and b a d into d c. Afterwards h runs from d to b and twin(h) of before from c to a.
inline void Triangulation::flip(Index h)
{
    const Index o = twin(h), hn = next(h), hp = previous(h), on = next(o), op = previous(o);
    touch(h);
    touch(o);
    Side* const sides = sides_.writable();
    const Index a = sides[h].origin, b = sides[o].origin, twin_h = sides[op].twin, twin_o = sides[hp].twin;
    if (((sides[h | 3].origin | sides[o | 3].origin) & any_bits) != 0) {
        const std::uint32_t bits_h = bits(op), bits_o = bits(hp);
        put_bits(h, bits_h);
        put_bits(o, bits_o);
        put_bits(hp, 0);
        put_bits(op, 0);
    }
    sides[h] = {sides[op].origin, twin_h};
    sides[o] = {sides[hp].origin, twin_o};
    sides[hp].twin = op;
    sides[op].twin = hp;
    lead_back(twin_h, h);
    lead_back(twin_o, o);
    if (out(a) == h) set_out(a, on);
    if (out(b) == o) set_out(b, hn);
}

/// The edges opposite v are the only ones that a new vertex v may have spoilt; a flip puts two others in the place of one. All is seen from v.
void Triangulation::legalise_star(Index v)
{
    const Point2 p = position(v);
    Index h = next(out(v));
    const Index stop = origin(h);
    filter::Seen a = filter::seen(position(stop), p), b = filter::seen(position(target(h)), p);
    while (true) {
        if (!is_fixed(h)) {
            const Index o = twin(h), d_vertex = apex(o);
            const filter::Seen d = filter::seen(position(d_vertex), p);
            // d is within the circle through a, b, v where v is without that through a, b, d, which turns the other way.
            const int sign = filter::incircle(a, b, d);
            if (sign < 0 || (sign == 0 && incircle_in_order(position(origin(h)), position(target(h)), p, position(d_vertex)) > 0)) {
                flip(h);
                h = next(o);
                b = d;
                continue;
            }
        }
        if (target(h) == stop) return;
        h = next(twin(next(h)));
        a = b;
        b = filter::seen(position(target(h)), p);
    }
}

/// Every edge that a flip may have spoilt is put in the queue by one of its sides; sides that have become part of another edge do no harm.
void Triangulation::legalise()
{
    while (!queue_.empty()) {
        const Index h = queue_.back();
        queue_.pop_back();
        if (!is_face(h) || is_fixed(h) || !wants_flip(h)) continue;
        const Index o = twin(h);
        flip(h);
        for (const Index g : {h, next(h), o, next(o)})
            if (!is_fixed(g)) queue_.push_back(g);
    }
}

// --- the box ----------------------------------------------------------------------------------------------------------------------

void Triangulation::grow_box(const Point2& p)
{
    const auto old = state_.corners;
    Point2 min = glm::min(position(old[0]), p), max = glm::max(position(old[2]), p);
    const Point2 room = max - min;
    min -= room;
    max += room;
    const std::array<Point2, 4> places{min, Point2(max.x, min.y), max, Point2(min.x, max.y)};
    for (std::size_t i = 0; i < 4; ++i) state_.corners[i] = new_vertex(places[i]);
    const auto now = state_.corners;

    // A ring of eight faces around the old box: below side i of it the faces old[i+1] old[i] now[i] and now[i] now[i+1] old[i+1].
    std::array<Index, 4> low, high;
    for (std::size_t i = 0; i < 4; ++i) {
        low[i] = new_face(0);
        high[i] = new_face(0);
        const std::size_t j = (i + 1) % 4;
        const std::array<Index, 3> a{old[j], old[i], now[i]}, b{now[i], now[j], old[j]};
        for (Index k = 0; k < 3; ++k) {
            side(low[i] + k) = {a[k], none};
            side(high[i] + k) = {b[k], none};
        }
        set_out(now[i], high[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        Index h = out(old[i]);
        while (twin(h) != none) h = next(twin(h)); // clockwise, as far as the side old[i] → old[j] of the old box
        touch(h);
        glue(low[i], h, 0);
        glue(low[i] + 2, high[i] + 2, 0);       // old[j] now[i]
        glue(high[i] + 1, low[j] + 1, 0);       // now[j] old[j]
        put_bits(high[i], hull_bit);
    }
    for (const Index h : low)
        for (Index k = 0; k < 3; ++k) queue_.push_back(h + k);
    legalise();
    for (const Index v : old) remove(v);
    grid_.clear();
}

// --- recording --------------------------------------------------------------------------------------------------------------------

void Triangulation::begin()
{
    before_ = state_;
    sides_.begin();
    vertices_.begin();
}

void Triangulation::end() noexcept
{
    sides_.end();
    vertices_.end();
}

Triangulation::Change Triangulation::take() { return {sides_.take(), vertices_.take(), before_}; }

void Triangulation::roll_back() noexcept
{
    queue_.clear();
    state_ = before_;
    sides_.roll_back();
    vertices_.roll_back();
    last_ = 0;
}

void Triangulation::prepare(Change& change, bool to_undo)
{
    sides_.prepare(change.sides, to_undo);
    vertices_.prepare(change.vertices, to_undo);
}

void Triangulation::undo(Change& change) noexcept
{
    sides_.undo(change.sides);
    vertices_.undo(change.vertices);
    std::swap(state_, change.state);
}

void Triangulation::redo(Change& change) noexcept
{
    sides_.redo(change.sides);
    vertices_.redo(change.vertices);
    std::swap(state_, change.state);
}

std::uint64_t Triangulation::fingerprint() const
{
    std::uint64_t hash = 14695981039346656037u;
    const auto mix = [&](std::uint64_t word) { hash = (hash ^ word) * 1099511628211u; };
    for (Index h = 0; h < sides_.size(); ++h) mix((std::uint64_t(sides_[h].origin) << 32) | sides_[h].twin);
    for (Index v = 0; v < vertices_.size(); ++v) {
        for (const double x : {position(v).x, position(v).y}) {
            std::uint64_t word;
            std::memcpy(&word, &x, sizeof word);
            mix(word);
        }
        mix(out(v));
    }
    for (const Index c : state_.corners) mix(c);
    mix(state_.free_faces);
    mix(state_.free_vertices);
    mix(state_.vertices);
    return hash;
}

} // namespace druse
