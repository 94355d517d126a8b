#pragma once

#include "io/byte_sink.h"
#include "io/model.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace druse {

struct WriteOptions {
    std::string format{}; // an extension without its dot; empty: that of the target
    bool ascii = false;   // the readable variant of a binary format
};

/// Files that appear together or not at all.
///
/// Everything is written to temporary files beside the targets at once, so that the model may change afterwards; commit() puts
/// them in place of the targets, and an OutputSet that ends without it takes them away again. A target that exists keeps its
/// permissions; a link stays a link and the file it leads to is replaced. Standard output and devices get their bytes at
/// commit().
class OutputSet {
public:
    OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;
    ~OutputSet();

    /// Writes a model; `-` is standard output and needs a format. On an error this target is dropped, and commit() must not
    /// follow.
    /// @throws InputError that names the target: an unknown format, no folder to write to, nothing to write, no space
    void write(const ModelView& model, const std::filesystem::path& target, const WriteOptions& options = {});

    /// A file for the caller to fill, until commit().
    ByteSink& open(const std::filesystem::path& target);

    /// Puts everything in place, streams first, each kind in the order written. Throws InputError, before the first file is touched
    /// if it can be known by then.
    void commit();

    /// What writers have to say, in order: `groups are not saved in STL`.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    class File;
    File& add(const std::filesystem::path& target);

    std::vector<std::unique_ptr<File>> files_;
    std::vector<std::string> notes_;
};

} // namespace druse
