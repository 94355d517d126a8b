#pragma once

#include "ops/registry.h"

#include <string>

namespace druse {

// What `druse ops` prints, all of it taken from the registry.

/// Every operator on a line, by family.
std::string reference_text(const Registry& registry);
/// One operator with its parameters.
std::string reference_text(const Operator& op);

/// An array of operators with everything that is known of them; or one of them.
std::string reference_json(const Registry& registry);
std::string reference_json(const Operator& op);

/// The reference page; or the section of one operator.
std::string reference_markdown(const Registry& registry);
std::string reference_markdown(const Operator& op);

/// What a parameter takes, in words: `number, 1 to 179 degrees`, `faces`, `set, add or remove`.
std::string takes_text(const Parameter& p);

} // namespace druse
