#include "ui/event_log.h"

#include "dlfl/errors.h"

namespace druse::ui {

EventLog::EventLog(const std::string& file) : out_(file)
{
    if (!out_) throw InputError(file, "cannot be written");
}

void EventLog::write(const std::string& line)
{
    if (out_.is_open()) out_ << line << std::endl;
}

} // namespace druse::ui
