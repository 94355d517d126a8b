#include "ui/palette.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/main_window.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <utility>

namespace druse::ui {

namespace {

std::vector<PaletteEntry> entries_of(MainWindow& window)
{
    std::vector<PaletteEntry> list;
    for (const Action& action : window.actions())
        list.push_back({label_of(action), action.path.substr(0, action.path.find('/')), action.run});
    for (const Operator& op : window.session().registry().operators())
        list.push_back({op.name, op.help, [&window, &op] { window.choose(op); }});
    return list;
}

class PaletteWindow : public Fl_Double_Window {
public:
    PaletteWindow(MainWindow& main, std::vector<PaletteEntry> entries, bool takes_commands)
        : Fl_Double_Window(layout().palette_width(), layout().px(300)), main_(main), entries_(std::move(entries)), takes_commands_(takes_commands),
          field_(layout().gap(), layout().gap(), w() - 2 * layout().gap(), layout().button_height()), list_(*this)
    {
        end();
        list_.resize(1, 2 * layout().gap() + layout().button_height(), w() - 2, layout().palette_lines() * layout().line_height());
        size(w(), list_.y() + list_.h() + 1);
        position(main.x_root() + (main.w() - w()) / 2, main.y_root() + layout().px(80));
        border(0);
        set_modal();
        box(FL_BORDER_BOX);
        color(theme().window);
        field_.textsize(layout().font());
        field_.when(FL_WHEN_CHANGED);
        field_.callback([](Fl_Widget*, void* p) { static_cast<PaletteWindow*>(p)->search(); }, this);
        search();
    }

    void show() override
    {
        Fl_Double_Window::show();
        field_.take_focus();
    }
    /// What was chosen, once the window is gone.
    std::function<void()> chosen;

    int handle(int event) override
    {
        if (event == FL_KEYBOARD || event == FL_SHORTCUT) switch (Fl::event_key()) {
            case FL_Escape: hide(); return 1;
            case FL_Enter:
            case FL_KP_Enter: take(std::max(list_.current(), 0)); return 1;
            case FL_Up:
            case FL_Down: list_.set_current(std::clamp(list_.current() + (Fl::event_key() == FL_Down ? 1 : -1), 0, int(found_.size()) - 1)); return 1;
            default: break;
            }
        if (event == FL_UNFOCUS) return 1;
        return Fl_Double_Window::handle(event);
    }

private:
    class List : public ListView {
    public:
        explicit List(PaletteWindow& palette) : ListView(0, 0, 1, 1), palette_(palette) {}

    private:
        int rows() const override { return int(palette_.found_.size()); }
        void draw_row(int row, int x, int y, int w, int h) override
        {
            const PaletteEntry& entry = *palette_.found_[std::size_t(row)];
            const bool here = is_selected(row);
            const int label = layout().px(200);
            fl_font(FL_HELVETICA, layout().font());
            draw_text(entry.label, x + layout().margin(), y, label, h, here ? theme().on_accent : theme().text);
            fl_font(FL_HELVETICA, layout().small_font());
            draw_text(entry.detail, x + label + 2 * layout().margin(), y, w - label - 3 * layout().margin(), h, here ? theme().on_accent : theme().faint_text);
        }
        void press_row(int row, int, int button, bool) override
        {
            if (button == 1) palette_.take(row);
        }
        PaletteWindow& palette_;
    };

    void search()
    {
        found_ = find_entries(entries_, field_.value());
        list_.refresh();
        list_.set_current(found_.empty() ? -1 : 0);
    }

    void take(int row)
    {
        const std::string text = field_.value();
        if (takes_commands_ && text.find('=') != std::string::npos) chosen = [this_main = &main_, text] { this_main->session().run_chosen(text); };
        else if (row >= 0 && row < int(found_.size())) chosen = found_[std::size_t(row)]->run;
        hide();
    }

    MainWindow& main_;
    std::vector<PaletteEntry> entries_;
    bool takes_commands_;
    std::vector<const PaletteEntry*> found_;
    Fl_Input field_;
    List list_;
};

} // namespace

std::vector<const PaletteEntry*> find_entries(const std::vector<PaletteEntry>& entries, const std::string& wanted)
{
    std::string text = lower_case(wanted);
    std::replace_if(text.begin(), text.end(), [](char c) { return c == '_' || c == '.' || c == '-'; }, ' ');
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (end > at) words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    std::vector<const PaletteEntry*> first, later;
    for (const PaletteEntry& entry : entries) {
        const std::string label = lower_case(entry.label), all = label + " " + lower_case(entry.detail);
        if (!std::all_of(words.begin(), words.end(), [&](const std::string& word) { return all.find(word) != std::string::npos; })) continue;
        const bool begins = !words.empty() && (label.starts_with(words[0]) || label.find("." + words[0]) != std::string::npos);
        (begins ? first : later).push_back(&entry);
    }
    first.insert(first.end(), later.begin(), later.end());
    return first;
}

namespace {

/// Lets a person choose, and does it when the list is gone.
void choose_from(MainWindow& window, std::vector<PaletteEntry> entries, bool takes_commands)
{
    std::function<void()> run;
    {
        Fl_Group::current(nullptr);
        PaletteWindow palette(window, std::move(entries), takes_commands);
        palette.show();
        while (palette.shown()) Fl::wait();
        run = palette.chosen;
    }
    if (run) run();
}

} // namespace

void show_palette(MainWindow& window) { choose_from(window, entries_of(window), true); }

void show_recent_files(MainWindow& window)
{
    std::vector<PaletteEntry> entries;
    for (const std::filesystem::path& file : window.preferences().recent) {
        std::error_code none;
        const bool there = std::filesystem::exists(file, none);
        entries.push_back({file.filename().string(), there ? file.parent_path().string() : "no longer there", [&window, file] { window.files().open(file); }});
    }
    if (entries.empty()) entries.push_back({"no files yet", "", {}});
    choose_from(window, std::move(entries), false);
}

} // namespace druse::ui
