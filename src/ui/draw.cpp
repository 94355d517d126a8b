#include "ui/draw.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

namespace {

/// The end of the last whole character, of however many bytes, before `end` in a text in UTF-8.
std::size_t character_end(const std::string& text, std::size_t end)
{
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    return end;
}

} // namespace

void draw_text(const std::string& text, int x, int y, int w, int h, Fl_Color colour, Fl_Align align)
{
    if (w <= 0) return;
    fl_color(colour);
    // A command may name a million faces: no more of it is looked at than could be seen, were every character a pixel wide.
    std::string shown = text.substr(0, character_end(text, std::min(text.size(), 4 * std::size_t(w))));
    if (shown.size() < text.size() || fl_width(shown.c_str()) > w) {
        const char* dots = "…";
        const double room = w - fl_width(dots);
        std::size_t fits = 0, beyond = shown.size() + 1;
        while (beyond - fits > 1) {
            const std::size_t middle = fits + (beyond - fits) / 2;
            (fl_width(shown.c_str(), int(character_end(shown, middle))) <= room ? fits : beyond) = middle;
        }
        shown.resize(character_end(shown, fits));
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
