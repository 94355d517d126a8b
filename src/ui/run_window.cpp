#include "ui/run_window.h"

#include "ui/autosave.h"
#include "ui/dialogs.h"
#include "ui/event_log.h"
#include "ui/geometry.h"
#include "ui/layout.h"
#include "ui/main_window.h"
#include "ui/preferences.h"
#include "ui/recorder.h"
#include "ui/replay.h"
#include "ui/signals.h"
#include "ui/source_window.h"
#include "ui/theme.h"

#include "app/registry.h"
#include "dlfl/errors.h"

#include <FL/Fl.H>
#include <FL/Fl_Tooltip.H>
#include <FL/x.H>

#include <cstdlib>
#include <map>
#include <optional>

namespace druse {

namespace {

using namespace ui;

/// FLTK ends the process where there is no display, so that one looks first.
void require_display()
{
    ::Display* display = XOpenDisplay(nullptr);
    if (!display) {
        const char* name = std::getenv("DISPLAY");
        throw SystemError(name && *name ? std::string("cannot open the display ") + name : "there is no display: DISPLAY is not set");
    }
    XCloseDisplay(display);
}

double scale_of(const WindowOptions& options, const Preferences& preferences)
{
    const double scale = options.ui_scale != 0 ? options.ui_scale : preferences.ui_scale;
    if (scale == 1 || scale == 1.25 || scale == 1.5 || scale == 2) return scale;
    throw CommandError("--ui-scale: expected 1, 1.25, 1.5 or 2");
}

/// What an earlier run could not save.
void offer_leftovers(const Autosave& autosave, MainWindow& window)
{
    for (const std::filesystem::path& model : autosave.leftovers()) {
        const Leftover answer = ask_about_leftover(model);
        if (answer == Leftover::discard) Autosave::discard(model);
        if (answer != Leftover::recover) continue;
        const std::filesystem::path here = Autosave::set_aside(model);
        Session& session = here.extension() == ".tile" ? window.editor_for(here).session() : window.session();
        session.open(here);
        session.wait();
        if (session.file() == here) session.detach();
        return; // the next one at the next start
    }
}

} // namespace

int run_window(const WindowOptions& options)
{
    const Geometry asked = Geometry::parse(options.geometry);
    EventLog log = options.event_log.empty() ? EventLog() : EventLog(options.event_log);
    require_display();

    Preferences preferences = options.test ? Preferences() : Preferences::load();
    set_layout(Layout(scale_of(options, preferences)));
    use_theme(preferences.dark);
    if (options.test) {
        Fl_Tooltip::disable();
        Fl::option(Fl::OPTION_FNFC_USES_GTK, false);
    }
    Fl::lock();

    Session session(all_operators());
    session.presets() = PresetFile(PresetFile::default_path());
    const Layout& l = layout();
    const int w = asked.width ? *asked.width : preferences.width > 0 ? preferences.width : std::min(l.window_width(), Fl::w());
    const int h = asked.height ? *asked.height : preferences.height > 0 ? preferences.height : std::min(l.window_height(), Fl::h());
    MainWindow window(session, preferences, {.test = options.test}, w, h);
    std::optional<Recorder> recorder;
    if (!options.record.empty()) recorder.emplace(window, options.record);
    std::optional<Replay> replay;
    if (!options.replay.empty()) replay.emplace(window, options.replay);
    std::optional<Autosave> autosave;
    std::map<SourceWindow*, Autosave> editor_autosaves;
    window.on_editor = [&](SourceWindow& editor) {
        if (recorder) recorder->watch(editor);
        if (options.test) return;
        const auto kind = editor.word() == "cell" ? Autosave::Kind::cell : Autosave::Kind::tile;
        Autosave& copy = editor_autosaves.try_emplace(&editor, editor.session(), Autosave::default_folder(), kind).first->second;
        editor.on_change = [&copy] { copy.follow(); };
    };
    window.on_event = [&](const std::string& line) {
        log.write(line);
        if (recorder) recorder->follow(line);
        if (replay) replay->follow(line);
    };
    if (asked.x) window.position(*asked.x, *asked.y);
    else if (preferences.x >= 0 && preferences.x < Fl::w() && preferences.y >= 0 && preferences.y < Fl::h())
        window.position(preferences.x, preferences.y);

    window.show();
    window.viewport().show();
    window.viewport().take_focus();
    if (!options.file.empty()) window.open(options.file);
    Fl::check();
    log.write("ready");
    const auto close_all = [] {
        while (Fl_Window* open = Fl::first_window()) open->hide(); // questions too: none of them is answered any more
    };
    if (replay) {
        replay->follow("ready");
        replay->on_end = [&] {
            if (!replay->failure().empty()) close_all();
        };
        replay->start();
    }

    if (!options.test) {
        autosave.emplace(session, Autosave::default_folder());
        offer_leftovers(*autosave, window);
        window.on_change = [&] { autosave->follow(); };
    }
    const EndSignals signals([&] {
        const auto keep = [](Session& work, Autosave& copy) {
            work.cancel(); // what is not done yet is not part of the work
            copy.save_now();
            copy.keep();
        };
        if (autosave) keep(session, *autosave);
        for (auto& [editor, copy] : editor_autosaves) keep(editor->session(), copy);
        close_all();
    });
    Fl::run();
    window.on_change = nullptr;
    window.on_editor = nullptr;
    session.cancel(), session.wait();
    for (SourceWindow* editor : window.editors()) {
        editor->session().cancel(), editor->session().wait();
        editor->on_change = nullptr;
    }
    if (!options.test) preferences.store();
    if (replay && !replay->failure().empty()) throw CommandError(replay->failure());
    return 0;
}

} // namespace druse
