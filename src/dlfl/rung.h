#pragma once

namespace druse {

/// An edge of a band between two faces: it joins corner `from` of the one and corner `to` of the other, each counted in face order.
struct Rung {
    int from = 0, to = 0;
    friend bool operator==(const Rung&, const Rung&) = default;
};

} // namespace druse
