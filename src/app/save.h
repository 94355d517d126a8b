#pragma once

#include "app/document.h"
#include "io/output.h"

#include <filesystem>

namespace druse {

/// Adds a document to the files of `output`: `.druse` (the extension of the target, or the format of the options) is the history, every
/// other the mesh or the source. The target appears when output.commit() is called.
/// @throws InputError that names the target; CommandError if there is no history that a script could tell
void write_document(const Document& document, OutputSet& output, const std::filesystem::path& target, const WriteOptions& options = {});

} // namespace druse
