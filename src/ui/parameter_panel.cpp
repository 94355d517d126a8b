#include "ui/parameter_panel.h"

#include "ui/dialogs.h"
#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/pattern.h"
#include "ui/popup.h"
#include "ui/solid_gallery.h"
#include "ui/theme.h"
#include "ui/tool.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <utility>

namespace druse::ui {

ParameterPanel::ParameterPanel(Session& session, Pictures& pictures, int x, int y, int w, int h)
    : Panel(x, y, w, h), session_(session), pictures_(pictures), picture_("Choose a solid…"), live_(0, 0, 1, 1, "live"), presets_(0, 0, 1, 1, "presets…"), apply_(0, 0, 1, 1, "Apply"),
      reset_(0, 0, 1, 1, "Reset"), help_(0, 0, 1, 1, "?")
{
    end();
    box(FL_FLAT_BOX);
    color(theme().window);
    live_.down_box(FL_DOWN_BOX);
    live_.color(theme().sunken);
    live_.selection_color(theme().accent);
    live_.labelsize(layout().font());
    live_.tooltip("Run the last step again while a slider moves");
    apply_.color(theme().accent);
    apply_.labelcolor(theme().on_accent);
    reset_.color(theme().raised);
    reset_.tooltip("Go back to the defaults");
    picture_.labeltype(FL_NO_LABEL);
    picture_.find = [this]() -> Fl_RGB_Image* {
        if (!shown_) return nullptr;
        const Parameter* solid = solid_parameter(*shown_);
        return pictures_.find(*shown_, solid ? session_.arguments().text(solid->name) : std::string(), layout().header_picture());
    };
    picture_.callback([](Fl_Widget*, void* p) { static_cast<ParameterPanel*>(p)->choose_solid_for_shown(); }, this);
    presets_.box(FL_FLAT_BOX);
    presets_.color(theme().header);
    presets_.labelcolor(theme().faint_text);
    presets_.labelsize(layout().small_font());
    presets_.tooltip("Values that have a name: take some, or keep these");
    presets_.callback([](Fl_Widget*, void* p) { static_cast<ParameterPanel*>(p)->choose_preset(); }, this);
    help_.color(theme().raised);
    help_.tooltip("What this operator does (F1)");

    live_.callback([](Fl_Widget*, void* p) {
        auto* self = static_cast<ParameterPanel*>(p);
        self->session_.set_live(self->live_.value() != 0);
    }, this);
    apply_.callback([](Fl_Widget*, void* p) { static_cast<ParameterPanel*>(p)->session_.apply_chosen(); }, this);
    reset_.callback([](Fl_Widget*, void* p) { static_cast<ParameterPanel*>(p)->session_.reset_arguments(); }, this);
    help_.callback([](Fl_Widget*, void* p) {
        if (const auto& ask = static_cast<ParameterPanel*>(p)->on_help) ask();
    }, this);
    refresh();
}

int ParameterPanel::header_height() const { return layout().header_height() + 2 * layout().line_height(); }

void ParameterPanel::arrange()
{
    const Layout& l = layout();
    const int footer = l.button_height() + 2 * l.gap(), inner = w() - 2 * l.margin();
    scroll_.resize(x() + l.margin(), y() + header_height(), inner, std::max(0, h() - header_height() - footer));
    const int bottom = y() + h() - l.gap() - l.button_height(), left = x() + l.margin();
    const int help = l.button_height(), live = l.px(58), width = (inner - live - help - 2 * l.gap()) / 2;
    live_.resize(left, bottom, live, l.button_height());
    apply_.resize(left + live, bottom, width, l.button_height());
    reset_.resize(apply_.x() + width + l.gap(), bottom, width, l.button_height());
    help_.resize(left + inner - help, bottom, help, l.button_height());
    picture_.resize(x() + w() - l.gap() - l.header_picture(), y() + l.header_height() + l.px(1), l.header_picture(), l.header_picture());
    presets_.resize(x() + w() - l.margin() - l.px(64), y() + l.px(2), l.px(64), l.header_height() - l.px(4));
}

void ParameterPanel::draw()
{
    Panel::draw();
    const Layout& l = layout();
    const int left = x() + l.margin(), inner = w() - 2 * l.margin();
    fl_push_clip(x(), y(), w(), header_height());
    fl_color(theme().header);
    fl_rectf(x(), y(), w(), l.header_height());
    fl_font(FL_HELVETICA_BOLD, l.font());
    const int title = presets_.visible() ? presets_.x() - l.gap() - left : inner;
    draw_text(shown_ ? shown_->title() : "No operator", left, y(), title, l.header_height(), theme().text);
    draw_child(presets_);
    fl_font(FL_HELVETICA, l.small_font());
    const int room = inner - (picture_.visible() ? picture_.w() : 0);
    const std::string text = shown_ ? shown_->help : "Choose one in the list above.";
    fl_color(theme().faint_text);
    fl_draw(text.c_str(), left, y() + l.header_height() + l.gap() / 2, room, 2 * l.line_height() - l.gap(),
            static_cast<Fl_Align>(FL_ALIGN_LEFT | FL_ALIGN_TOP | FL_ALIGN_WRAP | FL_ALIGN_INSIDE | FL_ALIGN_CLIP), nullptr, 0);
    fl_pop_clip();
}

void ParameterPanel::refresh()
{
    const Operator* chosen = session_.chosen();
    std::vector<Control> controls = chosen ? controls_of(*chosen, session_.implied()) : std::vector<Control>();
    std::erase_if(controls, [this](const Control& c) { return !session_.arguments().counts(c.parameter); });
    if (fit) std::ranges::for_each(controls, fit);
    const bool is_same = chosen == shown_;
    if (!is_same || !std::ranges::equal(controls, controls_, [](const Control& a, const Control& b) { return a.is_like(b); })) {
        if (!is_same) scroll_.scroll_to_top();
        shown_ = chosen;
        controls_ = std::move(controls);
        make_rows(is_same);
        redraw();
        controls = controls_;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->follow(controls[i]);
    if (shown_) {
        show_values();
        apply_.tooltip(acts_on_click(*shown_) ? "Run it on what its fields say, the selection as a rule (Enter)" : "Run it (Enter)");
    }
    live_.value(session_.live() ? 1 : 0);
    for (Fl_Widget* button : std::initializer_list<Fl_Widget*>{&live_, &presets_, &apply_, &reset_, &help_}) shown_ ? button->show() : button->hide();
    shown_ && shown_->family() == "extrude" ? picture_.show() : picture_.hide();
    picture_.tooltip(shown_ && solid_parameter(*shown_) ? "Choose another solid" : nullptr);
    picture_.redraw();
}

/// Rows that can stay do so: one of them may be where the change comes from, and hold the keyboard.
void ParameterPanel::make_rows(bool keep)
{
    auto old = std::exchange(rows_, {});
    for (const auto& row : old) scroll_.remove_row(*row);
    if (!keep) old.clear();
    Fl_Group::current(nullptr);
    for (const Control& control : controls_) {
        const auto like = std::ranges::find_if(old, [&](const auto& row) { return row && row->control().is_like(control); });
        if (like != old.end()) {
            rows_.push_back(std::move(*like));
            scroll_.add_row(*rows_.back());
            continue;
        }
        rows_.push_back(make_row(control, scroll_.x(), scroll_.y(), scroll_.w()));
        ParameterRow& row = *rows_.back();
        row.on_set = [this, &row](const std::string& text) { set(row.control(), text, false); };
        row.on_pick = [this, &row](const std::string& text) { set(row.control(), text, true); };
        row.on_enter = [this](bool changed) {
            const bool adjusted = changed && session_.is_bound() && session_.live();
            if (!adjusted) session_.apply_chosen();
        };
        row.on_copy = [this] {
            const std::string text = session_.arguments().command();
            Fl::copy(text.c_str(), int(text.size()), 1);
        };
        row.on_choose = [this](const std::string& current) { return choose_solid(pictures_, current); };
        scroll_.add_row(row);
    }
    arrange();
}

void ParameterPanel::set(const Control& control, const std::string& text, bool picked)
{
    // By value: the row may be another when the session has followed.
    const std::string parameter = control.parameter, piece = text.empty() ? control.initial : text;
    const std::string whole = control.place < 0 ? piece : with_piece(session_.shown_text(parameter), control.place, piece);
    picked ? session_.choose_value(parameter, whole) : session_.set(parameter, whole);
    show_values(); // a value that was refused gives way to the one that stands
}

void ParameterPanel::show_values()
{
    const Arguments& arguments = session_.arguments();
    for (const auto& row : rows_) {
        const Control& c = row->control();
        const std::string text = piece_of(session_.shown_text(c.parameter), c.place);
        row->show_value(text, text == c.initial || arguments.is_default(c.parameter));
    }
}

ParameterRow* ParameterPanel::row(std::string_view parameter, int place)
{
    for (const auto& row : rows_)
        if (row->control().parameter == parameter && (place < 0 || row->control().place == place)) return row.get();
    return nullptr;
}

void ParameterPanel::choose_preset()
{
    if (!shown_) return;
    std::vector<PopupEntry> entries;
    entries.push_back({"Keep these values as…", [this] {
        const auto name = ask_for_text("Keep these values as", "");
        if (!name || name->empty()) return;
        try {
            session_.store_preset(*name);
        } catch (const std::exception& e) {
            show_failure(e.what());
        }
    }});
    const std::vector<Preset> own = session_.presets().of(*shown_);
    for (const auto* list : {&own, &shown_->presets}) {
        entries.back().divider = true;
        for (const Preset& preset : *list) entries.push_back({preset.name, [this, preset] { session_.take_preset(preset); }});
    }
    entries.back().divider = true;
    for (const Preset& preset : own)
        entries.push_back({"Forget " + preset.name, [this, preset] {
            try {
                session_.forget_preset(preset.name);
            } catch (const std::exception& e) {
                show_failure(e.what());
            }
        }});
    show_popup(entries, presets_.x(), presets_.y() + presets_.h());
}

void ParameterPanel::choose_solid_for_shown()
{
    const Parameter* solid = shown_ ? solid_parameter(*shown_) : nullptr;
    if (!solid) return;
    if (const auto chosen = choose_solid(pictures_, session_.arguments().text(solid->name))) session_.choose_value(solid->name, *chosen);
}

void ParameterPanel::Picture::draw()
{
    fl_color(theme().window);
    fl_rectf(x(), y(), w(), h());
    if (Fl_RGB_Image* picture = find()) picture->draw(x(), y());
}

int ParameterPanel::handle(int event)
{
    if (Panel::handle(event)) return 1;
    const bool enter = event == FL_KEYBOARD && (Fl::event_key() == FL_Enter || Fl::event_key() == FL_KP_Enter);
    if (!enter || !shown_) return 0;
    session_.apply_chosen();
    return 1;
}

} // namespace druse::ui
