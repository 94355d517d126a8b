#include "cli/program.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace druse::test {

namespace {

/// A file without a name for one of the streams of a program, so that nothing has to be read while it runs.
class Stream {
public:
    explicit Stream(const std::string& content = {})
    {
        std::string path = (std::filesystem::temp_directory_path() / "druse-stream-XXXXXX").string();
        descriptor_ = mkstemp(path.data());
        if (descriptor_ < 0) throw std::runtime_error("no file for a stream");
        unlink(path.c_str());
        for (std::size_t done = 0; done < content.size();) {
            const ssize_t count = write(descriptor_, content.data() + done, content.size() - done);
            if (count <= 0) throw std::runtime_error("cannot write a stream");
            done += static_cast<std::size_t>(count);
        }
        lseek(descriptor_, 0, SEEK_SET);
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { close(descriptor_); }

    int descriptor() const { return descriptor_; }
    off_t size() const
    {
        struct stat status {};
        return fstat(descriptor_, &status) == 0 ? status.st_size : 0;
    }
    std::string content() const
    {
        std::string text;
        char buffer[65536];
        lseek(descriptor_, 0, SEEK_SET);
        for (ssize_t count; (count = ::read(descriptor_, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(count));
        return text;
    }

private:
    int descriptor_;
};

} // namespace

Ended run_program(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder, const std::string& input, Interrupt interrupt)
{
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    const Stream in(input), out, err;

    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start a program");
    if (child == 0) {
        dup2(in.descriptor(), STDIN_FILENO);
        dup2(out.descriptor(), STDOUT_FILENO);
        dup2(err.descriptor(), STDERR_FILENO);
        if (chdir(folder.c_str()) == 0) execvp(argv[0], argv.data());
        _exit(127);
    }
    int status = 0;
    bool ended = false;
    if (interrupt == Interrupt::when_it_speaks) {
        while (!ended && out.size() == 0) {
            ended = waitpid(child, &status, WNOHANG) == child;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (!ended) kill(child, SIGINT);
    }
    if (!ended) waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out.content(), err.content()};
}

Ended druse(const std::vector<std::string>& arguments, const std::string& folder, const std::string& input, Interrupt interrupt)
{
    return run_program(DRUSE_PROGRAM, arguments, folder, input, interrupt);
}

bool is_installed(const std::string& program)
{
    std::istringstream path(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(path, folder, ':');)
        if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

} // namespace druse::test
