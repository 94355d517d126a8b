#include "ui/theme.h"

#include "ui/layout.h"

#include <FL/Fl.H>
#include <FL/Fl_Tooltip.H>
#include <FL/fl_draw.H>
#include <FL/fl_ask.H>

#include <algorithm>

namespace druse::ui {

namespace {

Theme current;
bool dark_now = true;

Fl_Color rgb(unsigned hex) { return static_cast<Fl_Color>(hex << 8); }

/// A filled rectangle with round corners and a border of one pixel. FLTK draws without antialiasing, so that small corners are
/// best cut off by hand.
void rounded(int x, int y, int w, int h, Fl_Color fill, Fl_Color border)
{
    if (w < 4 || h < 4) {
        fl_color(fill);
        fl_rectf(x, y, w, h);
        return;
    }
    fl_color(fill);
    fl_rectf(x + 1, y + 1, w - 2, h - 2);
    fl_color(border);
    fl_xyline(x + 2, y, x + w - 3);
    fl_xyline(x + 2, y + h - 1, x + w - 3);
    fl_yxline(x, y + 2, y + h - 3);
    fl_yxline(x + w - 1, y + 2, y + h - 3);
    fl_point(x + 1, y + 1);
    fl_point(x + w - 2, y + 1);
    fl_point(x + 1, y + h - 2);
    fl_point(x + w - 2, y + h - 2);
}

// FLTK hands a box the colour of its widget, darker or lighter where it is inactive.
void draw_up(int x, int y, int w, int h, Fl_Color c) { rounded(x, y, w, h, c, current.border); }
void draw_down(int x, int y, int w, int h, Fl_Color c) { rounded(x, y, w, h, c, current.border); }
void draw_menu(int x, int y, int w, int h, Fl_Color c)
{
    fl_color(c);
    fl_rectf(x, y, w, h);
    fl_color(current.border);
    fl_rect(x, y, w, h);
}

Theme dark()
{
    return {.window = rgb(0x2d2f33), .sunken = rgb(0x202124), .raised = rgb(0x3a3d42), .border = rgb(0x4a4d53), .header = rgb(0x34363b),
            .text = rgb(0xdcdee1), .faint_text = rgb(0x9da1a8), .accent = rgb(0x3d78d8), .on_accent = rgb(0xffffff), .hover = rgb(0x42464c),
            .error = rgb(0xf2777b), .amber = rgb(0xe8a33d), .good = rgb(0x74c08a)};
}

Theme light()
{
    return {.window = rgb(0xeceef0), .sunken = rgb(0xffffff), .raised = rgb(0xf8f9fa), .border = rgb(0xb9bdc4), .header = rgb(0xe0e3e7),
            .text = rgb(0x1f2225), .faint_text = rgb(0x5c6168), .accent = rgb(0x2a66c8), .on_accent = rgb(0xffffff), .hover = rgb(0xdde3ec),
            .error = rgb(0xb3262b), .amber = rgb(0x8a5a00), .good = rgb(0x1f7a3d)};
}

void set_background(Fl_Color c, void (*set)(uchar, uchar, uchar))
{
    set(static_cast<uchar>(c >> 24), static_cast<uchar>(c >> 16), static_cast<uchar>(c >> 8));
}

} // namespace

const Theme& theme() { return current; }
bool theme_is_dark() { return dark_now; }

Fl_Boxtype field_box() { return FL_DOWN_BOX; }
Fl_Boxtype button_box() { return FL_UP_BOX; }

void use_theme(bool dark_theme)
{
    dark_now = dark_theme;
    current = dark_theme ? dark() : light();
    Fl::scheme("none");
    Fl::set_boxtype(FL_UP_BOX, draw_up, 2, 2, 4, 4);
    Fl::set_boxtype(FL_DOWN_BOX, draw_down, 2, 2, 4, 4);
    Fl::set_boxtype(FL_THIN_UP_BOX, draw_up, 1, 1, 2, 2);
    Fl::set_boxtype(FL_THIN_DOWN_BOX, draw_down, 1, 1, 2, 2);
    Fl::set_boxtype(FL_BORDER_BOX, draw_menu, 1, 1, 2, 2);
    set_background(current.window, Fl::background);
    set_background(current.sunken, Fl::background2);
    set_background(current.text, Fl::foreground);
    Fl::set_color(FL_SELECTION_COLOR, static_cast<unsigned>(current.accent));
    Fl::set_color(FL_INACTIVE_COLOR, static_cast<unsigned>(current.faint_text));
    Fl::set_font(FL_HELVETICA, " DejaVu Sans");
    Fl::set_font(FL_HELVETICA_BOLD, "BDejaVu Sans");
    Fl::set_font(FL_COURIER, " DejaVu Sans Mono");
    FL_NORMAL_SIZE = layout().font();
    Fl::visible_focus(1);
    Fl::scrollbar_size(layout().scrollbar());
    Fl_Tooltip::delay(0.6f);
    Fl_Tooltip::hoverdelay(0.2f);
    Fl_Tooltip::color(current.header);
    Fl_Tooltip::textcolor(current.text);
    Fl_Tooltip::size(layout().small_font());
    fl_message_hotspot(0);
    fl_message_font(FL_HELVETICA, layout().font());
}

} // namespace druse::ui
