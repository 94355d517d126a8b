#pragma once

#include "app/document.h"
#include "cli/command_line.h"
#include "geom/progress.h"

#include <string>

namespace druse {

// What the program does, one function for each kind of request. All of them throw what report_exception() knows.

/// Edits without a window. Files appear at the end, all together or not at all.
void apply(const ApplyRequest& request, Progress& progress);
/// Prints the facts of a file.
void info(const InfoRequest& request, Progress& progress);
/// Draws a picture of a file.
void render(const RenderRequest& request, Progress& progress);
/// Prints the operators there are.
void ops(const OpsRequest& request);
/// Opens the window. @return the exit status
int window(const WindowRequest& request);

/// Opens a file, or standard input for `-`, as the beginning of a document.
Document::Outcome open_input(Document& document, const std::string& input, const std::string& format, Progress& progress);

} // namespace druse
