#pragma once

#include "app/command.h"
#include "app/history.h"
#include "io/model.h"

#include <cstddef>
#include <filesystem>

namespace druse {

/// Puts a model in place of a scene's mesh, groups and source; nothing is selected afterwards.
void fill(Scene& scene, Model&& model);

/// The command that opens a file, as a history begins with.
ScriptCommand opening_command(const std::filesystem::path& file);

/// The file that a `document.open` names; null for every other command.
const FilePath* opened_file(const Invocation& call);

/// The state of the history to which document.undo, redo or goto leads. @throws CommandError if there is none such
std::size_t travel_destination(const Invocation& call, const History& history);

} // namespace druse
