#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace druse {

/// One file format: the only place that knows its extension, reader and writer together.
struct Format {
    std::string_view extension; // in lower case, without the dot; also its name after --format
    std::string_view title;     // for file dialogs
    Model (*read)(ByteSource& source);
    void (*write)(const ModelView& model, OutputFiles& out);
};

std::span<const Format> formats();

/// The format of that name or extension, in either case; `where` is what the error names.
/// @throws InputError that lists the formats there are
const Format& format_named(std::string_view name, const std::string& where);

/// The format that the extension of a path says.
/// @throws InputError
const Format& format_of(const std::filesystem::path& path);

} // namespace druse
