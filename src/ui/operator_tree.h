#pragma once

#include "ui/list_view.h"
#include "ui/panel.h"
#include "ui/pictures.h"
#include "ui/session.h"

#include <FL/Fl_Input.H>

#include <set>
#include <string>
#include <vector>

namespace druse::ui {

/// `Extrude` for extrude.
std::string family_title(const std::string& family);

/// Every operator under its family, and a field that searches them by name and help.
class OperatorTree : public Panel {
public:
    OperatorTree(Session& session, Pictures& pictures, int x, int y, int w, int h);

    /// Shows which operator is chosen.
    void refresh();
    void focus_search();
    /// Unfolds the operator's family and scrolls to it.
    void reveal(const Operator& op);

    int handle(int event) override;

protected:
    void arrange() override;

private:
    struct Row {
        std::string family; // of a heading
        const Operator* op = nullptr;
    };

    class List : public ListView {
    public:
        explicit List(OperatorTree& tree) : ListView(0, 0, 1, 1), tree_(tree) {}
        void choose_first();

    private:
        int rows() const override { return int(tree_.rows_.size()); }
        void draw_row(int row, int x, int y, int w, int h) override;
        void press_row(int row, int x, int button, bool twice) override;
        bool is_selected(int row) const override;
        std::string tip(int row) const override;
        OperatorTree& tree_;
    };

    void fill();

    Session& session_;
    Pictures& pictures_;
    const Operator* shown_ = nullptr;
    std::vector<Row> rows_;
    std::set<std::string> open_;
    std::string looked_for_;
    /// A field that says what it is for while it is empty.
    class SearchField : public Fl_Input {
    public:
        SearchField() : Fl_Input(0, 0, 1, 1) {}

    private:
        void draw() override;
    };
    SearchField search_;
    List list_;
};

} // namespace druse::ui
