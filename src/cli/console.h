#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// Writes to standard output. @throws InputError if it does not take it
void print(std::string_view text);

/// `note: …` on standard error, once a run has succeeded.
void print_notes(const std::vector<std::string>& notes);

/// The exception being handled as one line `druse: …` on standard error. @return the exit status it calls for: 2 for the caller's
/// mistakes, 3 for ours and for what the system lacks, 130 after a cancelled run. Precondition: called in a catch block
int report_exception() noexcept;

} // namespace druse
