#include "ui/draw.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

namespace druse::ui {

namespace {

/// Takes the last character, of however many bytes, off a text in UTF-8.
void drop_last(std::string& text)
{
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    if (!text.empty()) text.pop_back();
}

} // namespace

void draw_text(const std::string& text, int x, int y, int w, int h, Fl_Color colour, Fl_Align align)
{
    if (w <= 0) return;
    fl_color(colour);
    std::string shown = text;
    if (fl_width(shown.c_str()) > w) {
        const char* dots = "…";
        const double room = w - fl_width(dots);
        while (!shown.empty() && fl_width(shown.c_str()) > room) drop_last(shown);
        shown += dots;
    }
    const int width = static_cast<int>(fl_width(shown.c_str()) + 0.5);
    const int left = (align & FL_ALIGN_RIGHT) ? x + w - width : (align & FL_ALIGN_LEFT) ? x : x + (w - width) / 2;
    fl_draw(shown.c_str(), left, y + (h + fl_height()) / 2 - fl_descent());
}

void draw_chevron(int x, int y, int size, bool open, Fl_Color colour)
{
    // Row by row: a small triangle of FLTK comes out lopsided.
    fl_color(colour);
    const int half = size / 3, cx = x + size / 2, cy = y + size / 2;
    for (int i = 0; i <= half; ++i) {
        if (open) fl_xyline(cx - half + i, cy - half / 2 + i, cx + half - i);
        else fl_yxline(cx - half / 2 + i, cy - half + i, cy + half - i);
    }
}

void draw_swatch(int x, int y, int size, Colour colour)
{
    fl_color(fl_colour(colour));
    fl_rectf(x, y, size, size);
    fl_color(theme().border);
    fl_rect(x, y, size, size);
}

Fl_Color fl_colour(Colour c) { return c.red + c.green + c.blue == 0 ? FL_BLACK : fl_rgb_color(c.red, c.green, c.blue); }

} // namespace druse::ui
