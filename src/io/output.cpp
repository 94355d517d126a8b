#include "io/output.h"

#include "dlfl/errors.h"
#include "io/format.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace druse {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& name, const char* what)
{
    throw InputError(name, fmt::format("{}: {}", what, std::strerror(errno)));
}

/// Where a chain of links leads, also if there is nothing there yet.
fs::path follow_links(fs::path path)
{
    std::error_code error;
    for (int i = 0; i < 40 && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
        const fs::path to = fs::read_symlink(path, error);
        if (error) break;
        path = to.is_absolute() ? to : path.parent_path() / to;
    }
    return path;
}

fs::path folder_of(const fs::path& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void copy_all(int from, int to, const std::string& name)
{
    std::vector<char> buffer(std::size_t(1) << 20);
    if (lseek(from, 0, SEEK_SET) != 0) fail(name, "cannot be read back");
    while (true) {
        const ssize_t count = read(from, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(name, "cannot be read back");
        if (count == 0) return;
        for (ssize_t done = 0; done < count;) {
            const ssize_t written = write(to, buffer.data() + done, static_cast<std::size_t>(count - done));
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail(name, "cannot be written");
            done += written;
        }
    }
}

} // namespace

/// One target and what stands ready for it.
class OutputSet::File {
public:
    explicit File(const fs::path& target);
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File();

    ByteSink& sink() { return *sink_; }
    bool is_stream() const { return stream_; }
    const fs::path& place() const { return place_; }
    void finish(); // everything is in the temporary file
    void put_in_place();

private:
    void make_beside(mode_t permissions, bool exists);
    void make_anywhere();

    std::string name_;           // what errors call it
    fs::path place_, temporary_; // the place is the target with links followed
    int descriptor_ = -1;
    bool stream_ = false; // the bytes are copied, not renamed
    std::optional<ByteSink> sink_;
};

OutputSet::File::File(const fs::path& target) : name_(target == "-" ? "standard output" : target.string())
{
    if (target.empty()) throw InputError("output", "a file without a name");
    struct stat status {};
    bool exists = false;
    if (target == "-") {
        stream_ = true;
    } else {
        place_ = follow_links(target);
        exists = stat(place_.c_str(), &status) == 0;
        if (exists && S_ISDIR(status.st_mode)) throw InputError(name_, "is a folder, not a file");
        if (!exists && !target.has_filename()) throw InputError(name_, "is no name of a file");
        stream_ = exists && !S_ISREG(status.st_mode);
        if (exists && access(place_.c_str(), W_OK) != 0) fail(name_, "cannot be written");
    }
    if (stream_)
        make_anywhere();
    else
        make_beside(status.st_mode & 07777, exists);
    sink_.emplace(descriptor_, name_);
}

void OutputSet::File::make_beside(mode_t permissions, bool exists)
{
    static std::atomic<unsigned> count{0};
    const fs::path folder = folder_of(place_);
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw InputError(name_, fmt::format("there is no folder '{}'", folder.string()));
    for (int attempt = 0; attempt < 1000 && descriptor_ < 0; ++attempt) {
        temporary_ = folder / fmt::format(".druse-{}-{}.tmp", getpid(), count++);
        descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) {
        temporary_.clear();
        fail(name_, "cannot be written");
    }
    if (exists && fchmod(descriptor_, permissions) != 0) {
        close(descriptor_);
        unlink(temporary_.c_str());
        fail(name_, "cannot be written");
    }
}

void OutputSet::File::make_anywhere()
{
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (error) folder = ".";
    std::string path = (folder / "druse-XXXXXX").string();
    descriptor_ = mkostemp(path.data(), O_CLOEXEC);
    if (descriptor_ < 0) fail(path, "cannot be written");
    unlink(path.c_str());
}

OutputSet::File::~File()
{
    if (descriptor_ >= 0) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputSet::File::finish()
{
    if (!sink_) return;
    sink_->flush();
    sink_.reset();
    if (stream_) return;
    if (close(std::exchange(descriptor_, -1)) != 0) fail(name_, "cannot be written"); // a full disk may tell only now
}

void OutputSet::File::put_in_place()
{
    if (!stream_) {
        if (rename(temporary_.c_str(), place_.c_str()) != 0) fail(name_, "cannot be replaced");
        temporary_.clear();
        return;
    }
    const int to = place_.empty() ? dup(STDOUT_FILENO) : ::open(place_.c_str(), O_WRONLY | O_CLOEXEC);
    if (to < 0) fail(name_, "cannot be written");
    try {
        copy_all(descriptor_, to, name_);
    } catch (...) {
        close(to);
        throw;
    }
    close(to);
}

OutputSet::OutputSet() = default;
OutputSet::~OutputSet() = default;

OutputSet::File& OutputSet::add(const fs::path& target)
{
    files_.push_back(std::make_unique<File>(target));
    return *files_.back();
}

void OutputSet::write(const ModelView& model, const fs::path& target, const WriteOptions& options)
{
    const bool to_standard_output = target == "-";
    if (to_standard_output && options.format.empty()) throw InputError("standard output", "needs --format");
    const Format& format = options.format.empty()
                               ? format_of(target)
                               : format_named(options.format, to_standard_output ? "standard output" : target.string());
    const std::size_t before = files_.size();
    try {
        File& file = add(target);
        const auto side_file = [&](std::string_view extension) -> ByteSink* {
            if (file.is_stream()) return nullptr;
            return &add(fs::path(file.place()).replace_extension(extension)).sink();
        };
        OutputFiles out(file.sink(), fs::path(file.place()).stem().string(), options.ascii, side_file, notes_);
        format.write(model, out);
        for (std::size_t i = before; i < files_.size(); ++i) files_[i]->finish();
    } catch (...) {
        files_.resize(before);
        throw;
    }
}

ByteSink& OutputSet::open(const fs::path& target)
{
    return add(target).sink();
}

void OutputSet::commit()
{
    for (auto& file : files_) file->finish();
    // A pipe can fail half-way; a rename hardly ever does, once the file stands ready beside its target.
    for (auto& file : files_)
        if (file->is_stream()) file->put_in_place();
    for (auto& file : files_)
        if (!file->is_stream()) file->put_in_place();
    files_.clear();
}

} // namespace druse
