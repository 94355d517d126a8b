#pragma once

#include "io/byte_sink.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace druse {

/// What a writer of one format gets: the file to fill, a way to files beside it, and a place for notes.
class OutputFiles {
public:
    /// Makes `STEM.extension` beside the file; null where there is no place for one, as on standard output.
    using SideFile = std::function<ByteSink*(std::string_view extension)>;

    OutputFiles(ByteSink& main, std::string stem, bool ascii, SideFile side_file, std::vector<std::string>& notes)
        : main_(main), stem_(std::move(stem)), ascii_(ascii), side_file_(std::move(side_file)), notes_(notes)
    {
    }

    ByteSink& main() { return main_; }
    const std::string& name() const { return main_.name(); }
    /// The name of the file without folder and extension.
    const std::string& stem() const { return stem_; }
    /// True if the readable variant of a binary format is wanted.
    bool ascii() const { return ascii_; }
    ByteSink* side_file(std::string_view extension) { return side_file_(extension); }
    void note(std::string text) { notes_.push_back(std::move(text)); }

private:
    ByteSink& main_;
    std::string stem_;
    bool ascii_;
    SideFile side_file_;
    std::vector<std::string>& notes_;
};

} // namespace druse
