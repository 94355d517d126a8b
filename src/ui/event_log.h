#pragma once

#include <fstream>
#include <string>

namespace druse::ui {

/// A file to which a line is added for everything that happens, at once, so that a test can wait for it.
class EventLog {
public:
    EventLog() = default;
    /// @throws InputError if it cannot be written
    explicit EventLog(const std::string& file);
    void write(const std::string& line);

private:
    std::ofstream out_;
};

} // namespace druse::ui
