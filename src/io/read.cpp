#include "io/read.h"

#include "io/format.h"

namespace druse {

Model read_model(const std::filesystem::path& path, Progress& progress, std::string_view format)
{
    ByteSource source = ByteSource::file(path);
    const Format& its = format.empty() ? format_of(path) : format_named(format, path.string());
    source.report_to(progress);
    return its.read(source);
}

Model read_model(ByteSource& source, Progress& progress, std::string_view format)
{
    source.report_to(progress);
    return format_named(format, source.name()).read(source);
}

} // namespace druse
