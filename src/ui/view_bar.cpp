#include "ui/view_bar.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

#include <utility>

namespace druse::ui {

namespace {

constexpr std::size_t elements = 3; // the first switches choose one of these

} // namespace

ViewBar::ViewBar(Session& session, View& view, int x, int y, int w, int h) : Panel(x, y, w, h), session_(session), view_(view)
{
    end();
    add_element("Face", "Clicks select faces (F2)", Element::face);
    add_element("Edge", "Clicks select edges (F3)", Element::edge);
    add_element("Vertex", "Clicks select vertices (F4)", Element::vertex);
    const auto style_switch = [this](const char* label, const char* tip, auto get, auto set) {
        add_switch(label, tip,
                   [this, get, set] {
                       Style style = view_.style();
                       set(style, !get(style));
                       view_.set_style(style);
                   },
                   [this, get] { return get(view_.style()); });
    };
    style_switch("Soft", "Smooth shading: the faces as they are, in the light of a round surface", [](const Style& s) { return s.shading == Style::Shading::smooth; },
                 [](Style& s, bool on) { s.shading = on ? Style::Shading::smooth : Style::Shading::flat; });
    style_switch("Edges", "Show the edges of faces (E)", [](const Style& s) { return s.edges; }, [](Style& s, bool on) { s.edges = on; });
    style_switch("Wire", "Edges only (W)", [](const Style& s) { return s.wireframe; }, [](Style& s, bool on) { s.wireframe = on; });
    SmoothPreview& smooth = view_.smooth();
    add_switch("Smooth", "Smooth preview: the surface that subdividing goes to; clicks act on the faces around it (S)",
               [&smooth] { smooth.set_on(!smooth.is_on()); }, [&smooth] { return smooth.is_on(); })
        .trouble = [&smooth] { return smooth.reason(); };
    refresh();
}

void ViewBar::add_element(const char* label, const char* tip, Element element)
{
    add_switch(label, tip, [this, element] { view_.set_element(element); }, [this, element] { return view_.element() == element; });
}

ViewBar::Switch& ViewBar::add_switch(const char* label, const char* tip, std::function<void()> press, std::function<bool()> is_on)
{
    Fl_Group::current(nullptr);
    switches_.push_back({std::make_unique<Fl_Button>(0, 0, 1, 1, label), std::move(press), std::move(is_on), {}});
    Fl_Button& button = *switches_.back().button;
    button.tooltip(tip);
    button.labelsize(layout().small_font());
    button.clear_visible_focus();
    button.callback([](Fl_Widget* widget, void* p) {
        auto* bar = static_cast<ViewBar*>(p);
        for (const Switch& s : bar->switches_)
            if (s.button.get() == widget) s.press();
        bar->refresh();
    }, this);
    add(button);
    return switches_.back();
}

void ViewBar::refresh()
{
    for (const Switch& s : switches_) {
        const bool on = s.is_on(), idle = on && s.trouble && !s.trouble().empty();
        s.button->color(idle ? theme().amber : on ? theme().accent : theme().raised);
        s.button->labelcolor(idle ? theme().sunken : on ? theme().on_accent : theme().text);
        s.button->redraw();
    }
    title_ = session_.title();
    redraw();
}

void ViewBar::arrange()
{
    const Layout& l = layout();
    fl_font(FL_HELVETICA, l.small_font());
    const int height = l.control_height(), top = y() + (h() - height) / 2;
    int right = x() + w() - l.margin();
    for (std::size_t i = switches_.size(); i-- > 0;) {
        Fl_Button& button = *switches_[i].button;
        const int width = static_cast<int>(fl_width(button.label())) + 2 * (w() < l.px(560) ? l.gap() : l.margin());
        right -= width;
        button.resize(right, top, width, height);
        if (i == elements) right -= l.margin() + l.gap();
        else right += 1; // neighbours share a border
    }
}

void ViewBar::draw()
{
    fl_color(theme().window);
    fl_rectf(x(), y(), w(), h());
    fl_font(FL_HELVETICA_BOLD, layout().font());
    const int left = x() + layout().margin();
    draw_text(title_, left, y(), switches_.front().button->x() - layout().margin() - left, h(), theme().text);
    draw_children();
}

} // namespace druse::ui
