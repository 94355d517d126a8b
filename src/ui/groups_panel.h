#pragma once

#include "ui/list_view.h"
#include "ui/session.h"

#include <functional>
#include <vector>

namespace druse::ui {

/// The face groups of the model: colour, id, name and number of faces. A click selects a group's faces, a double click on the swatch
/// asks for another colour, and a swatch dragged onto another one merges the two.
class GroupsPanel : public ListView {
public:
    GroupsPanel(Session& session, int x, int y, int w, int h) : ListView(x, y, w, h), session_(session) {}
    void update(); // shows what the session has now

private:
    struct Row {
        int id;
        std::uint32_t faces;
    };
    int rows() const override { return int(rows_.size()); }
    void draw_row(int row, int x, int y, int w, int h) override;
    void press_row(int row, int x, int button, bool twice) override;
    void drop_row(int from, int to) override;
    bool is_selected(int) const override { return false; }
    std::string tip(int row) const override;
    void open_menu(const Row& row);
    void ask_colour(int id);

    Session& session_;
    std::vector<Row> rows_;
};

} // namespace druse::ui
