#include "ui/replay.h"

#include "ui/cell_window.h"
#include "ui/key_names.h"
#include "ui/main_window.h"
#include "ui/tile_window.h"
#include "ui/window_picture.h"

#include "dlfl/errors.h"
#include "render/png.h"

#include <FL/Fl.H>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace druse::ui {

namespace {

constexpr int longest_wait = 1000; // ticks

/// Puts an event of the mouse in, as if it had come from the display.
void send_mouse(EditorWindow& window, int event, std::istream& words)
{
    int x = 0, y = 0, number = 0;
    words >> x >> y;
    if (event == FL_PUSH || event == FL_MOUSEWHEEL) words >> number;
    if (!words) throw CommandError("expected X Y and, for push and wheel, a number");
    static int button = 1;
    int state = 0;
    bool twice = false;
    for (std::string word; words >> word;) {
        if (word == "shift") state |= FL_SHIFT;
        else if (word == "ctrl") state |= FL_CTRL;
        else if (word == "alt") state |= FL_ALT;
        else if (word == "twice") twice = true;
        else throw CommandError("unknown word '" + word + "'");
    }
    if (event == FL_PUSH) button = std::clamp(number, 1, 3);
    Fl::e_x = x;
    Fl::e_y = y;
    Fl::e_x_root = window.x_root() + x;
    Fl::e_y_root = window.y_root() + y;
    Fl::e_keysym = FL_Button + button;
    Fl::e_state = state | (event == FL_PUSH || event == FL_DRAG ? FL_BUTTON1 << (button - 1) : 0);
    if (event == FL_PUSH) Fl::e_clicks = twice ? 1 : 0;
    Fl::e_is_click = event == FL_PUSH;
    Fl::e_dx = 0;
    Fl::e_dy = event == FL_MOUSEWHEEL ? number : 0;
    Fl::handle(event, &window);
}

void send_key(EditorWindow& window, const std::string& name)
{
    const auto key = key_from_text(name);
    if (!key) throw CommandError("unknown key '" + name + "'");
    static std::array<char, 2> text{};
    text[0] = key->key > 0 && key->key < 127 && !(key->state & FL_CTRL) ? static_cast<char>(key->key) : '\0';
    Fl::e_keysym = Fl::e_original_keysym = key->key;
    Fl::e_state = key->state;
    Fl::e_text = text.data();
    Fl::e_length = text[0] ? 1 : 0;
    Fl::handle(FL_KEYBOARD, &window);
}

} // namespace

Replay::Replay(MainWindow& window, const std::string& file) : window_(window), file_(file), timer_([this] { next(); })
{
    std::ifstream in(file);
    if (!in) throw InputError(file, "cannot be read");
    for (std::string line; std::getline(in, line);) lines_.push_back(line);
}

void Replay::next()
{
    if (at_ == lines_.size() || !failure_.empty()) {
        if (on_end) on_end();
        return;
    }
    // The next line comes when the one before has had its effect.
    if (!is_busy()) {
        const std::size_t number = at_ + 1;
        const std::string line = lines_[at_];
        try {
            if (line.starts_with("wait ")) {
                if (awaited(line.substr(5))) ++at_;
                else if (++ticks_waited_ > longest_wait) throw CommandError("nothing of the kind happened in 10 seconds");
            } else {
                ++at_;
                play(line);
            }
        } catch (const std::exception& e) {
            failure_ = file_ + ":" + std::to_string(number) + ": " + e.what();
        }
    }
    start();
}

bool Replay::is_busy() const
{
    const std::vector<SourceWindow*> editors = window_.editors();
    return window_.session().busy() || std::ranges::any_of(editors, [](SourceWindow* editor) { return editor->session().busy(); });
}

bool Replay::awaited(const std::string& event)
{
    if (std::none_of(events_.begin(), events_.end(), [&](const std::string& line) { return line.starts_with(event); })) return false;
    events_.clear();
    ticks_waited_ = 0;
    return true;
}

void Replay::play(std::string line)
{
    SourceWindow* editor = line.starts_with("tile: ") ? static_cast<SourceWindow*>(&window_.tile_editor()) : line.starts_with("cell: ") ? &window_.cell_editor() : nullptr;
    if (editor) line.erase(0, editor->mark().size());
    EditorWindow& window = editor ? static_cast<EditorWindow&>(*editor) : window_;
    std::istringstream words(line);
    std::string verb, rest;
    words >> verb;
    if (verb.empty() || verb[0] == '#') return;
    if (verb == "push") return send_mouse(window, FL_PUSH, words);
    if (verb == "drag") return send_mouse(window, FL_DRAG, words);
    if (verb == "move") return send_mouse(window, FL_MOVE, words);
    if (verb == "wheel") return send_mouse(window, FL_MOUSEWHEEL, words);
    if (verb == "release") {
        send_mouse(window, FL_RELEASE, words);
        return;
    }
    std::getline(words >> std::ws, rest);
    Session& session = window.session();
    if (verb == "key") return send_key(window, rest);
    if (verb == "menu") {
        if (!window.menu().pick(rest)) throw CommandError("no menu entry '" + rest + "'");
    } else if (verb == "choose") {
        window.choose(session.registry().get(rest));
    } else if (verb == "run") {
        session.run(rest);
    } else if (verb == "set") {
        const std::size_t blank = rest.find(' ');
        if (!session.chosen() || blank == std::string::npos) throw CommandError("expected PARAMETER VALUE, with an operator chosen");
        session.set(rest.substr(0, blank), rest.substr(blank + 1));
    } else if (verb == "preset") {
        session.take_preset(rest);
    } else if (verb == "open") {
        session.open(rest);
    } else if (verb == "save") {
        session.save(rest);
    } else if (verb == "export") {
        session.export_to(rest);
    } else if (verb == "shot") {
        write_png(rest, picture_of(window));
    } else if (verb == "hand" && editor) {
        editor->hand_over();
    } else if (verb == "quit") {
        window.hide();
    } else {
        throw CommandError("unknown word '" + verb + "'");
    }
}

} // namespace druse::ui
