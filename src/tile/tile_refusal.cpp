#include "tile/tile_refusal.h"

#include <fmt/format.h>

#include <array>

namespace druse {

TileRefusal::TileRefusal(Reason reason, const std::string& what) : CommandError(fmt::format("{}: {}", name(reason), what)), reason_(reason) {}

const char* name(TileRefusal::Reason reason)
{
    constexpr std::array names{"boundary-crosses", "swallows-point", "flat-corner", "fixed", "no-such-point", "no-such-path", "half-path", "phase",
                               "offset-not-isohedral", "top-under-bottom", "vanishes"};
    return names[std::size_t(reason)];
}

} // namespace druse
