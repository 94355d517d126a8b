#include "app/script.h"
#include "cli/commands.h"
#include "dlfl/errors.h"
#include "io/byte_source.h"
#include "io/read.h"

namespace druse {

Document::Outcome open_input(Document& document, const std::string& input, const std::string& format, Progress& progress)
{
    if (input != "-") return document.open(input, progress);
    if (format.empty()) throw InputError("standard input", "needs --format");
    if (is_script_format(format)) return document.run(Script::read_standard_input(), progress);
    ByteSource source = ByteSource::standard_input();
    return document.open(read_model(source, progress, format));
}

} // namespace druse
