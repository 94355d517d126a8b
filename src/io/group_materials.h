#pragma once

#include "io/model.h"
#include "io/output_files.h"

#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// The ids that faces carry, in ascending order, each once, with 0 if some are not grouped. Empty if none is, and group 0 has no colour or name of its own.
std::vector<int> groups_in_use(const Mesh& mesh, const GroupTable& groups);

/// The name of a group as a file gives it: the first word, without bytes that a terminal would obey; may be empty.
std::string group_name_in(std::string_view text);

/// Writes the colours and names of these groups as materials into the .mtl file beside the output.
/// @return what to put after `mtllib`; empty if there are no groups or no place for a file (then with a note)
std::string write_group_materials(const GroupTable& groups, const std::vector<int>& used, OutputFiles& out);

} // namespace druse
