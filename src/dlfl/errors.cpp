#include "dlfl/errors.h"

#include <fmt/format.h>

#include <string_view>

namespace druse {

void assertion_failed(const char* must_hold, const std::source_location& where)
{
    std::string_view file = where.file_name();
    if (const auto slash = file.find_last_of('/'); slash != std::string_view::npos) file.remove_prefix(slash + 1);
    throw InternalError(fmt::format("internal error at {}:{}: expected: {}", file, where.line(), must_hold));
}

} // namespace druse
