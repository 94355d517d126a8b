#include "ui/autosave.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <unistd.h>
#include <variant>

namespace druse::ui {

namespace {

constexpr const char* model_extension = ".dlfl"; // it keeps groups, start corners and open boundaries
constexpr const char* tile_extension = ".tile";
constexpr double when_busy = 2;                  // seconds until the next try

std::string host()
{
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    return name;
}

/// Does another process that wrote a lock file still run? One on another host may.
bool is_held(const std::filesystem::path& lock)
{
    std::ifstream in(lock);
    std::string where;
    long process = 0;
    if (!(in >> where >> process)) return false;
    if (where == host() && process == getpid()) return false; // of an earlier process that had the same number
    return where != host() || kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

void remove(std::filesystem::path file, const char* extension)
{
    std::error_code none;
    std::filesystem::remove(file.replace_extension(extension), none);
}

/// A file in the folder named after this process, other than what an earlier one with the same number may have left.
std::filesystem::path own_name(const std::filesystem::path& folder, Autosave::Kind kind)
{
    // Names differ before the extension: each has its history and its lock beside it.
    const std::string name = host() + "-" + std::to_string(getpid()) + (kind == Autosave::Kind::tile ? "-tile" : kind == Autosave::Kind::cell ? "-cell" : "");
    const char* extension = kind == Autosave::Kind::model ? model_extension : tile_extension;
    std::filesystem::path file = folder / (name + extension);
    std::error_code none;
    for (int i = 2; std::filesystem::exists(file, none); ++i) file = folder / (name + "-" + std::to_string(i) + extension);
    return file;
}

/// What lies beside a model.
constexpr std::array beside_a_model{".mtl", ".druse"};

} // namespace

std::filesystem::path Autosave::default_folder()
{
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state) return std::filesystem::path(state) / "druse";
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home && *home ? home : "/tmp") / ".local/state/druse";
}

Autosave::Autosave(Session& session, std::filesystem::path folder, Kind kind)
    : session_(session), kind_(kind), folder_(std::move(folder)), model_(own_name(folder_, kind)),
      saved_version_(session.document_version()), saved_at_(std::chrono::steady_clock::now()), timer_([this] { save(); })
{
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    std::ofstream lock(std::filesystem::path(model_).replace_extension(".lock"));
    lock << host() << " " << getpid() << "\n";
    if (!lock.flush()) session_.say(Message::Kind::error, "no autosave: cannot write to " + folder_.string());
}

Autosave::~Autosave()
{
    timer_.stop();
    if (!keep_) discard(model_);
    else remove(model_, ".lock");
}

void Autosave::discard(const std::filesystem::path& model)
{
    std::error_code none;
    std::filesystem::remove(model, none);
    for (const char* extension : beside_a_model) remove(model, extension);
    remove(model, ".lock");
}

void Autosave::take_away()
{
    std::error_code none;
    std::filesystem::remove(model_, none);
    for (const char* extension : beside_a_model) remove(model_, extension);
    written_ = false;
}

std::filesystem::path Autosave::set_aside(const std::filesystem::path& model)
{
    const std::filesystem::path folder = model.parent_path() / "recovered", target = folder / model.filename();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::filesystem::rename(model, target, error);
    if (error) return model;
    for (const char* extension : beside_a_model)
        std::filesystem::rename(std::filesystem::path(model).replace_extension(extension), std::filesystem::path(target).replace_extension(extension), error);
    remove(model, ".lock");
    return target;
}

void Autosave::follow()
{
    if (session_.busy()) return;
    if (written_ && !session_.is_changed()) take_away();
    if (session_.document_version() == saved_version_) return;
    // Every change puts it off, but not for ever.
    const double waited = std::chrono::duration<double>(std::chrono::steady_clock::now() - saved_at_).count();
    if (waited + after_change < at_least_every || !timer_.is_running()) timer_.start(after_change);
}

void Autosave::save()
{
    if (session_.busy()) {
        timer_.start(when_busy);
        return;
    }
    saved_version_ = session_.document_version();
    saved_at_ = std::chrono::steady_clock::now();
    if (!session_.is_changed() || !has_something()) return;
    written_ = true;
    session_.keep_copy(model_);
}

/// Something that the file can hold: a source alone is in no .dlfl file.
bool Autosave::has_something() const
{
    const Scene* scene = session_.scene();
    if (kind_ == Kind::model) return session_.display().counts.faces > 0;
    return scene && (std::holds_alternative<LayeredTile>(*scene->source) || std::holds_alternative<CellTile>(*scene->source));
}

void Autosave::save_now()
{
    session_.wait();
    save();
    session_.wait();
}

std::vector<std::filesystem::path> Autosave::leftovers() const
{
    std::vector<std::filesystem::path> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
        const std::filesystem::path& file = entry.path();
        if ((file.extension() != model_extension && file.extension() != tile_extension) || file == model_) continue;
        if (!is_held(std::filesystem::path(file).replace_extension(".lock"))) found.push_back(file);
    }
    return found;
}

} // namespace druse::ui
