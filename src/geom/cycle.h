#pragma once

#include <cstddef>

namespace druse {

/// A view of n values in a circle: index −1 is the last one, index n the first. Indices from −n to 2n − 1 are allowed.
template <class T>
class Cycle {
public:
    Cycle() = default;
    Cycle(T* first, int n) : first_(first), n_(n) {}

    int size() const { return n_; }
    T& operator[](int i) const { return first_[i < 0 ? i + n_ : i >= n_ ? i - n_ : i]; }
    T* begin() const { return first_; }
    T* end() const { return first_ + n_; }

private:
    T* first_ = nullptr;
    int n_ = 0;
};

} // namespace druse
