#include "cli/console.h"

#include "dlfl/errors.h"
#include "geom/progress.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

namespace druse {

namespace {

/// File names may hold anything; a line of output holds no control characters.
void put_line(std::FILE* to, const char* before, std::string_view text)
{
    std::fputs(before, to);
    for (const char c : text) std::fputc(static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c, to);
    std::fputc('\n', to);
}

int say(const char* before, std::string_view text, int status)
{
    put_line(stderr, before, text);
    return status;
}

} // namespace

void print(std::string_view text)
{
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw InputError("standard output", std::string("cannot be written: ") + std::strerror(errno));
}

void print_notes(const std::vector<std::string>& notes)
{
    for (const std::string& note : notes) put_line(stderr, "note: ", note);
}

int report_exception() noexcept
{
    try {
        throw;
    } catch (const CommandError& e) {
        return say("druse: ", e.what(), 2);
    } catch (const InputError& e) {
        return say("druse: ", e.what(), 2);
    } catch (const SystemError& e) {
        return say("druse: ", e.what(), 3);
    } catch (const InternalError& e) {
        return say("druse: ", e.what(), 3);
    } catch (const Cancelled& e) {
        return say("druse: ", e.what(), 130);
    } catch (const std::bad_alloc&) {
        return say("druse: ", "not enough memory", 3);
    } catch (const std::exception& e) {
        return say("druse: internal error: ", e.what(), 3);
    } catch (...) {
        return say("druse: ", "internal error", 3);
    }
}

} // namespace druse
