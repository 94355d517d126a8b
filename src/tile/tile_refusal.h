#pragma once

#include "dlfl/errors.h"

#include <cstdint>
#include <string>

namespace druse {

/// Why an edit of a tile did not take place, or no solid can be made of it; the tile is as it was. What is wrong in a plane triangulation comes as
/// PaneRefusal.
class TileRefusal : public CommandError {
public:
    enum class Reason : std::uint8_t {
        boundary_crosses, swallows_point, flat_corner, fixed, no_such_point, no_such_path, half_path, phase, offset_not_isohedral, top_under_bottom,
        vanishes
    };
    TileRefusal(Reason reason, const std::string& what);
    Reason reason() const { return reason_; }

private:
    Reason reason_;
};

/// The word for a reason in messages, as `offset-not-isohedral`.
const char* name(TileRefusal::Reason reason);

} // namespace druse
