#pragma once

#include "ui/list_view.h"
#include "ui/session.h"

#include <functional>

namespace druse::ui {

/// The history, one line a command as a script writes it. A click goes there; the state on disk has a dot.
class HistoryPanel : public ListView {
public:
    HistoryPanel(Session& session, int x, int y, int w, int h) : ListView(x, y, w, h), session_(session) {}
    void update(); // shows what the session has now

private:
    int rows() const override { return int(session_.display().steps.size()) + 1; }
    void draw_row(int row, int x, int y, int w, int h) override;
    void press_row(int row, int x, int button, bool twice) override;
    bool is_selected(int row) const override { return row == int(session_.display().done); }
    std::string tip(int row) const override { return text(row); }
    std::string label(int row) const;
    void drop_row(int from, int to) override;
    std::string text(int row) const;
    void open_menu(int row);

    Session& session_;
    std::size_t done_ = 0;
};

} // namespace druse::ui
