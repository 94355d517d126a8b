#pragma once

#include <cmath>

namespace druse {

/// The largest factor, at most 1, for which `holds(factor)` is true, to nine digits; 0 if it is for none. What holds for a factor must hold for all
/// smaller ones. Bisects exponents, so no factor is too small to be found. Cost: some 45 calls.
template <class F>
double largest_factor(F&& holds)
{
    if (holds(1.0)) return 1;
    double good = -1, bad = 0; // powers of two
    for (; !holds(std::exp2(good)); good *= 2) {
        if (good < -512) return 0;
        bad = good;
    }
    while (bad - good > 1e-9) {
        const double middle = 0.5 * (good + bad);
        (holds(std::exp2(middle)) ? good : bad) = middle;
    }
    return std::exp2(good);
}

} // namespace druse
