#pragma once

#include "geom/progress.h"
#include "io/byte_source.h"
#include "io/model.h"

#include <filesystem>
#include <string_view>

namespace druse {

/// Reads a model in the format of the file's extension, or in that called `format` if one is given. May be cancelled while it reads.
/// @throws InputError that names the file, and the line where there is one, if it is not there or not what it should be
Model read_model(const std::filesystem::path& path, Progress& progress, std::string_view format = {});

/// Reads a model from anywhere. A `format` must be given.
Model read_model(ByteSource& source, Progress& progress, std::string_view format);

/// For callers that wait until it is done.
inline Model read_model(const std::filesystem::path& path, std::string_view format = {})
{
    Progress progress;
    return read_model(path, progress, format);
}
inline Model read_model(ByteSource& source, std::string_view format)
{
    Progress progress;
    return read_model(source, progress, format);
}

} // namespace druse
