#include "ui/parameter_panel.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include "ui/tool.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

namespace druse::ui {

ParameterPanel::ParameterPanel(Session& session, int x, int y, int w, int h)
    : Panel(x, y, w, h), session_(session), live_(0, 0, 1, 1, "live"), apply_(0, 0, 1, 1, "Apply"),
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
    draw_text(shown_ ? shown_->title() : "No operator", left, y(), inner, l.header_height(), theme().text);
    fl_font(FL_HELVETICA, l.small_font());
    const std::string text = shown_ ? shown_->help : "Choose one in the list above.";
    fl_color(theme().faint_text);
    fl_draw(text.c_str(), left, y() + l.header_height() + l.gap() / 2, inner, 2 * l.line_height() - l.gap(),
            static_cast<Fl_Align>(FL_ALIGN_LEFT | FL_ALIGN_TOP | FL_ALIGN_WRAP | FL_ALIGN_INSIDE | FL_ALIGN_CLIP), nullptr, 0);
    fl_pop_clip();
}

void ParameterPanel::refresh()
{
    const Operator* chosen = session_.chosen();
    if (chosen != shown_ || (chosen && rows_.empty() && !chosen->parameters.empty())) {
        shown_ = chosen;
        make_rows();
        redraw();
    }
    if (shown_) {
        show_values();
        apply_.tooltip(acts_on_click(*shown_) ? "Run it on what its fields say, the selection as a rule (Enter)" : "Run it (Enter)");
    }
    live_.value(session_.live() ? 1 : 0);
    for (Fl_Widget* button : std::initializer_list<Fl_Widget*>{&live_, &apply_, &reset_, &help_}) shown_ ? button->show() : button->hide();
}

void ParameterPanel::make_rows()
{
    for (const auto& row : rows_) scroll_.remove_row(*row);
    rows_.clear();
    scroll_.scroll_to_top();
    if (shown_) {
        Fl_Group::current(nullptr);
        for (const Control& control : controls_of(*shown_)) {
            rows_.push_back(make_row(control, scroll_.x(), scroll_.y(), scroll_.w()));
            ParameterRow& row = *rows_.back();
            row.on_set = [this, &row](const std::string& text) { set(row.control(), text); };
            row.on_enter = [this](bool changed) {
                const bool adjusted = changed && session_.is_bound() && session_.live();
                if (!adjusted) session_.apply_chosen();
            };
            row.on_copy = [this] {
                const std::string text = session_.arguments().command();
                Fl::copy(text.c_str(), int(text.size()), 1);
            };
            scroll_.add_row(row);
        }
    }
    arrange();
}

void ParameterPanel::set(const Control& control, const std::string& text)
{
    const Arguments& arguments = session_.arguments();
    const std::string& piece = text.empty() ? control.initial : text;
    const std::string whole = control.place < 0 ? piece : with_piece(arguments.text(control.parameter), control.place, piece);
    session_.set(control.parameter, whole);
    show_values(); // a value that was refused gives way to the one that stands
}

void ParameterPanel::show_values()
{
    const Arguments& arguments = session_.arguments();
    for (const auto& row : rows_) {
        const Control& c = row->control();
        const std::string text = piece_of(arguments.text(c.parameter), c.place);
        row->show_value(text, text == c.initial);
    }
}

ParameterRow* ParameterPanel::row(std::string_view parameter, int place)
{
    for (const auto& row : rows_)
        if (row->control().parameter == parameter && (place < 0 || row->control().place == place)) return row.get();
    return nullptr;
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
