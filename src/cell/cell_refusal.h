#pragma once

#include "dlfl/errors.h"

#include <cstdint>
#include <string>

namespace druse {

/// Why an edit of a cell did not take place, or no solid can be made of it; the cell is as it was. What is wrong in the triangulation of a pane comes
/// as PaneRefusal.
class CellRefusal : public CommandError {
public:
    enum class Reason : std::uint8_t { phase, flat_cell, fixed, no_such_pane, no_such_point, no_such_edge, no_such_triangle, duplicate, vanishes, pierced };
    CellRefusal(Reason reason, const std::string& what);
    Reason reason() const { return reason_; }

private:
    Reason reason_;
};

/// The word for a reason in messages, as `flat-cell`.
const char* name(CellRefusal::Reason reason);

} // namespace druse
