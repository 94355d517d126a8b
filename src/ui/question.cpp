#include "ui/question.h"

#include "ui/theme.h"

#include <FL/Fl.H>

#include <algorithm>

namespace druse::ui {

Question::Question(int w, int rows, const char* title) : Fl_Double_Window(w, rows * row() + 2 * layout().margin(), title)
{
    color(theme().window);
    set_modal();
}

Fl_Box* Question::add_label(int line, int width, const char* text)
{
    auto* label = new Fl_Box(layout().margin(), top(line), width, layout().button_height(), text);
    label->align(FL_ALIGN_LEFT | FL_ALIGN_INSIDE | FL_ALIGN_CLIP);
    label->labelsize(layout().font());
    return label;
}

bool Question::ask(Fl_Button& yes, Fl_Button& no)
{
    yes.color(theme().accent);
    yes.labelcolor(theme().on_accent);
    no.color(theme().raised);
    yes.callback([](Fl_Widget* button, void* answer) {
        *static_cast<bool*>(answer) = true;
        button->window()->hide();
    }, &answer_);
    no.callback([](Fl_Widget* button, void*) { button->window()->hide(); });
    if (const Fl_Window* main = Fl::first_window())
        position(std::max(0, main->x_root() + (main->w() - w()) / 2), std::max(0, main->y_root() + (main->h() - h()) / 3));
    show();
    yes.take_focus();
    while (shown()) Fl::wait();
    Fl::flush();
    return answer_;
}

} // namespace druse::ui
