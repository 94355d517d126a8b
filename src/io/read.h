#pragma once

#include "io/byte_source.h"
#include "io/model.h"

#include <filesystem>
#include <string_view>

namespace druse {

/// Reads a model in the format of the file's extension, or in that called `format` if one is given.
/// @throws InputError that names the file, and the line where there is one, if it is not there or not what it should be
Model read_model(const std::filesystem::path& path, std::string_view format = {});

/// Reads a model from anywhere. A `format` must be given.
Model read_model(ByteSource& source, std::string_view format);

} // namespace druse
