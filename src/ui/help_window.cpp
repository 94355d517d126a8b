#include "ui/help_window.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Double_Window.H>
#include <FL/Fl_Help_View.H>

#include <fmt/format.h>

namespace druse::ui {

namespace {

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        if (c == '&') result += "&amp;";
        else if (c == '<') result += "&lt;";
        else if (c == '>') result += "&gt;";
        else result += c;
    }
    return result;
}

/// There is one such window; it is used again.
void show_page(const std::string& title, const std::string& html)
{
    static Fl_Double_Window* window = nullptr;
    static Fl_Help_View* view = nullptr;
    if (!window) {
        Fl_Group::current(nullptr);
        window = new Fl_Double_Window(layout().px(600), layout().px(440));
        view = new Fl_Help_View(0, 0, window->w(), window->h());
        window->end();
        window->resizable(view);
        view->box(FL_FLAT_BOX);
        view->color(theme().sunken);
        view->textcolor(theme().text);
        view->textfont(FL_HELVETICA);
        view->textsize(layout().font());
        view->scrollbar_size(layout().scrollbar());
    }
    window->copy_label(title.c_str());
    view->value(html.c_str());
    window->show();
}

} // namespace

std::string operator_page(const Operator& op)
{
    std::string html = fmt::format("<h3>{}</h3><p>{}</p>", escaped(op.name), escaped(op.help));
    if (!op.parameters.empty()) {
        html += "<table><tr><td><b>parameter</b></td><td><b>type</b></td><td><b>default</b></td><td><b>range</b></td></tr>";
        for (const Parameter& p : op.parameters) {
            std::string range = p.domain.range.is_everything() ? std::string() : p.domain.range.text();
            if (!p.domain.words.empty()) range += (range.empty() ? "" : "; ") + listing(p.domain.words);
            html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr><tr><td></td><td colspan=\"3\"><i>{}</i></td></tr>", escaped(p.name),
                                p.type_text(), p.required ? "required" : escaped(p.default_text), escaped(range), escaped(p.help));
        }
        html += "</table>";
    }
    if (!op.example.empty()) html += fmt::format("<p>Example: <tt>{}</tt></p>", escaped(op.example));
    if (!op.source.empty()) html += fmt::format("<p>Source: {}</p>", escaped(op.source));
    return html;
}

void show_operator_help(const Operator& op) { show_page(op.title() + " - Druse", operator_page(op)); }

void show_text(const std::string& title, const std::string& text)
{
    std::string html;
    for (const char c : escaped(text)) html += c == '\n' ? "<br>" : std::string(1, c);
    show_page(title + " - Druse", "<p>" + html + "</p>");
}

} // namespace druse::ui
