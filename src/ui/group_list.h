#pragma once

#include "ui/list_view.h"
#include "ui/session.h"

#include <FL/Fl_Input.H>

#include <functional>
#include <optional>
#include <vector>

namespace druse::ui {

/// The face groups of the model: colour, id, name and number of faces.
///
/// A click selects a group's faces; while the brush is in hand it chooses the paint instead. A double click on the colour asks for
/// another one, one beside it takes another name. A row that is dragged onto another merges the two; onto a face, it takes that face in.
class GroupList : public ListView {
public:
    GroupList(Session& session, int x, int y, int w, int h);
    void update(); // shows what the session has now
    int handle(int event) override;
    void resize(int x, int y, int w, int h) override;
    bool asks() const override;

    /// The group that was chosen last; nothing if there is none, or it is gone.
    std::optional<int> group() const;
    void choose(int group);
    /// What comes of releasing the button while a group is dragged in the list; empty if nothing does.
    const std::string& hint() const { return hint_; }
    void rename();     // the chosen one
    void ask_colour(); // the same

    /// A group is dragged, and dropped, outside the list: at the place of the present event.
    enum class Carry { move, drop, cancel };
    std::function<void(Carry, int group)> on_carry;
    /// Another group was chosen by hand.
    std::function<void(int group)> on_choose;
    /// True if a click chooses only, and does not select faces.
    std::function<bool()> only_chooses;
    /// Asks the person for a colour.
    std::function<std::optional<Colour>(Colour before)> choose_colour;

protected:
    void draw() override;

private:
    /// Where a name is typed. Enter, or going elsewhere, takes it; Escape leaves the old one.
    class NameField : public Fl_Input {
    public:
        NameField() : Fl_Input(0, 0, 1, 1) {}
        std::function<void(bool take)> on_end;

    private:
        int handle(int event) override;
    };

    int rows() const override { return int(sizes_->size()); }
    void draw_row(int row, int x, int y, int w, int h) override;
    void press_row(int row, int x, int button, bool twice) override;
    void click_row(int row, int x) override;
    void enter_row(int row) override { click_row(row, 0); }
    void go_to_row(int row) override;
    bool drag_row(int from, int to) override;
    void drop_row(int from, int to) override;
    void cancel_drag() override;
    std::string tip(int row) const override;

    const GroupSize& size_of(int row) const { return (*sizes_)[std::size_t(row)]; }
    int row_of(int group) const; // −1: none
    int name_left() const;
    bool is_on_swatch(int x) const;
    void place_field();
    void end_rename(bool take);
    void open_menu(int group);
    void ask_colour_of(int group);

    Session& session_;
    Shared<std::vector<GroupSize>> sizes_;
    NameField field_;
    int renamed_ = -1; // the group whose name is being typed
    int carried_ = -1; // the group that is dragged
    std::string hint_;
};

} // namespace druse::ui
