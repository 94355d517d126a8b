#pragma once

#include "ui/display.h"
#include "ui/list_view.h"

#include <string>
#include <vector>

namespace druse::ui {

/// What one wants to know of a model, as before it is printed.
struct Fact {
    std::string name, value;
    enum class Tone { plain, good, warning } tone = Tone::plain;
};
/// The facts of what is shown, in the order in which they are listed; `unit` names a length.
std::vector<Fact> print_facts(const Display& display, const std::string& unit);

class FactsPanel : public ListView {
public:
    FactsPanel(int x, int y, int w, int h) : ListView(x, y, w, h) {}
    void show_facts(std::vector<Fact> facts);

private:
    int rows() const override { return int(facts_.size()); }
    void draw_row(int row, int x, int y, int w, int h) override;
    void press_row(int, int, int, bool) override {}
    bool is_selected(int) const override { return false; }

    std::vector<Fact> facts_;
};

} // namespace druse::ui
