#pragma once

#include <source_location>
#include <stdexcept>
#include <string>

namespace druse {

/// A file says something it must not: the reader's complaint, with the file and, where there is one, the line.
/// In a terminal: `druse: FILE:LINE: what is wrong`, exit status 2.
class InputError : public std::runtime_error {
public:
    InputError(const std::string& file, long line, const std::string& what)
        : std::runtime_error(file + (line > 0 ? std::string(":").append(std::to_string(line)) : "") + ": " + what)
    {
    }
    InputError(const std::string& file, const std::string& what) : InputError(file, 0, what) {}
};

/// A command asks for something that cannot be: `druse: OPERATOR: what is wrong`, exit status 2. The text starts with the
/// operator's name once the command has one; Document::apply adds it.
class CommandError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A part of the system that Druse needs is not there (a display, OSMesa): exit status 3.
class SystemError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Something that must hold does not: our mistake, never the caller's. Exit status 3.
class InternalError : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

[[noreturn]] void assertion_failed(const char* must_hold, const std::source_location& where);

} // namespace druse

/// States what must hold at this place; on in every build. A failure throws InternalError, so that the document is put back.
#define ASSERT(condition, must_hold)                                                                                             \
    do {                                                                                                                         \
        if (!(condition)) [[unlikely]] ::druse::assertion_failed(must_hold, std::source_location::current());                    \
    } while (false)
