#include "cell/cell_refusal.h"

#include <fmt/format.h>

#include <array>

namespace druse {

CellRefusal::CellRefusal(Reason reason, const std::string& what) : CommandError(fmt::format("{}: {}", name(reason), what)), reason_(reason) {}

const char* name(CellRefusal::Reason reason)
{
    constexpr std::array names{"phase", "flat-cell", "fixed", "no-such-pane", "no-such-point", "no-such-edge", "no-such-triangle", "duplicate", "vanishes", "pierced"};
    return names[std::size_t(reason)];
}

} // namespace druse
