#pragma once

#include <cmath>
#include <complex>
#include <span>

namespace druse {

/// An orientation-preserving motion of the hyperbolic plane (curvature −1) in the Poincaré disk: z → (a z + b) / (b* z + a*), with
/// |a|² − |b|² = 1, an element of SU(1,1).
///
/// Its precision ends near |z| = 1 − 1e-12. Source: Anderson 1999, chapter 4.
class Motion {
public:
    using Complex = std::complex<double>;

    Motion() = default;
    /// Counter-clockwise about the centre, in radians.
    static Motion rotation(double angle) { return {std::polar(1.0, 0.5 * angle), 0.0}; }
    /// Along the x axis by a hyperbolic distance, towards +x.
    static Motion translation(double distance) { return {std::cosh(0.5 * distance), std::sinh(0.5 * distance)}; }
    /// The translation that takes the centre to a point of the open disk.
    static Motion to(const Complex& point)
    {
        const double a = 1.0 / std::sqrt(1.0 - std::norm(point));
        return {a, a * point};
    }

    /// First `second`, then `first`. Brought back to determinant 1, so that long products stay motions.
    friend Motion operator*(const Motion& first, const Motion& second)
    {
        const Complex a = product(first.a_, second.a_) + product(first.b_, std::conj(second.b_));
        const Complex b = product(first.a_, second.b_) + product(first.b_, std::conj(second.a_));
        const double scale = 1.0 / std::sqrt(std::norm(a) - std::norm(b));
        return {scale * a, scale * b};
    }

    /// Grows with the distance by which it moves the centre: sinh² of half of it.
    double reach() const { return std::norm(b_); }
    /// Where it takes the centre.
    Complex origin() const { return product(b_, a_) / std::norm(a_); }
    /// Where it takes a point of the disk.
    Complex operator()(const Complex& z) const
    {
        const Complex below = product(std::conj(b_), z) + std::conj(a_);
        return product(product(a_, z) + b_, std::conj(below)) / std::norm(below);
    }

private:
    Motion(const Complex& a, const Complex& b) : a_(a), b_(b) {}
    /// Without the care for infinities that std::complex takes.
    static Complex product(const Complex& x, const Complex& y)
    {
        return {x.real() * y.real() - x.imag() * y.imag(), x.real() * y.imag() + x.imag() * y.real()};
    }

    Complex a_ = 1.0, b_ = 0.0;
};

enum class Geometry { spherical, euclidean, hyperbolic };

/// What regular polygons make that meet in one point: decided exactly, in integers, by the sum of 1 − 2/p against 2. Precondition: 3 to 12 polygons
/// of 3 to 40 sides.
Geometry geometry_of(std::span<const int> polygons);

/// The interior angle in radians of a regular polygon with edges of hyperbolic length l: 2 asin(cos(π/p) / cosh(l/2)).
double interior_angle(int sides, double length);

/// The length of edges with which the interior angles of these polygons add up to a full turn. Precondition: they are hyperbolic.
double edge_length(std::span<const int> polygons);

/// The hyperbolic radius of the circle through the corners of a regular polygon: sinh R = sinh(l/2) / sin(π/p).
double circumradius(int sides, double length);

} // namespace druse
