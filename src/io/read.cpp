#include "io/read.h"

#include "io/format.h"

namespace druse {

Model read_model(const std::filesystem::path& path, std::string_view format)
{
    ByteSource source = ByteSource::file(path);
    const Format& its = format.empty() ? format_of(path) : format_named(format, path.string());
    return its.read(source);
}

Model read_model(ByteSource& source, std::string_view format)
{
    return format_named(format, source.name()).read(source);
}

} // namespace druse
