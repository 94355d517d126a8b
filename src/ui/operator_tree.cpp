#include "ui/operator_tree.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"
#include "ui/tool.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

namespace {

/// As operators are searched for: in small letters, words apart.
std::string searchable(std::string text)
{
    text = lower_case(std::move(text));
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

bool matches(const Operator& op, const std::string& wanted)
{
    if (searchable(op.name).find(wanted) != std::string::npos || searchable(op.help).find(wanted) != std::string::npos) return true;
    return std::any_of(op.aliases.begin(), op.aliases.end(), [&](const std::string& a) { return searchable(a).find(wanted) != std::string::npos; });
}

} // namespace

std::string family_title(const std::string& family)
{
    std::string title = family;
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

OperatorTree::OperatorTree(Session& session, Pictures& pictures, int x, int y, int w, int h)
    : Panel(x, y, w, h), session_(session), pictures_(pictures), list_(*this)
{
    end();
    box(FL_FLAT_BOX);
    color(theme().window);
    search_.textsize(layout().font());
    search_.tooltip("Search operators by name or by what they do");
    search_.when(FL_WHEN_CHANGED | FL_WHEN_ENTER_KEY_ALWAYS);
    search_.callback([](Fl_Widget*, void* p) {
        auto* tree = static_cast<OperatorTree*>(p);
        const bool enter = Fl::event() == FL_KEYBOARD && (Fl::event_key() == FL_Enter || Fl::event_key() == FL_KP_Enter);
        tree->looked_for_ = searchable(tree->search_.value());
        tree->fill();
        if (enter) tree->list_.choose_first();
    }, this);
    open_ = {"extrude"};
    fill();
    arrange();
}

void OperatorTree::arrange()
{
    const Layout& l = layout();
    search_.resize(x() + l.margin(), y() + l.gap(), w() - 2 * l.margin(), l.control_height() + l.px(2));
    const int top = y() + 2 * l.gap() + l.control_height() + l.px(2);
    list_.resize(x(), top, w(), std::max(0, y() + h() - top));
}

void OperatorTree::fill()
{
    rows_.clear();
    std::vector<std::string> families;
    for (const Operator& op : session_.registry().operators())
        if (std::find(families.begin(), families.end(), op.family()) == families.end()) families.push_back(op.family());
    for (const std::string& family : families) {
        std::vector<Row> found;
        for (const Operator& op : session_.registry().operators())
            if (op.family() == family && (looked_for_.empty() || matches(op, looked_for_))) found.push_back({{}, &op});
        if (found.empty()) continue;
        rows_.push_back({family, nullptr});
        if (!looked_for_.empty() || open_.contains(family)) rows_.insert(rows_.end(), found.begin(), found.end());
    }
    list_.refresh();
}

void OperatorTree::refresh()
{
    if (session_.chosen() == shown_) return;
    shown_ = session_.chosen();
    list_.redraw();
}

void OperatorTree::reveal(const Operator& op)
{
    search_.value("");
    looked_for_.clear();
    open_.insert(op.family());
    fill();
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].op == &op) list_.scroll_to(int(i));
}

void OperatorTree::focus_search()
{
    search_.take_focus();
    search_.position(0, search_.size());
}

int OperatorTree::handle(int event)
{
    // From the field straight into the list, and Escape empties the field.
    if (event == FL_KEYBOARD && Fl::focus() == &search_) {
        if (Fl::event_key() == FL_Down) {
            list_.take_focus();
            list_.set_current(0);
            return 1;
        }
        if (Fl::event_key() == FL_Escape && search_.size() > 0) {
            search_.value("");
            looked_for_.clear();
            fill();
            return 1;
        }
    }
    return Panel::handle(event);
}

void OperatorTree::SearchField::draw()
{
    Fl_Input::draw();
    if (size() > 0 || Fl::focus() == this) return;
    fl_font(FL_HELVETICA, layout().font());
    draw_text("search operators", x() + layout().gap(), y(), w() - 2 * layout().gap(), h(), theme().faint_text);
}

// --- the list -----------------------------------------------------------------------------------------------------------------

void OperatorTree::List::draw_row(int row, int x, int y, int w, int h)
{
    const Layout& l = layout();
    const Row& r = tree_.rows_[std::size_t(row)];
    const bool selected = is_selected(row);
    if (!r.op) {
        const bool open = !tree_.looked_for_.empty() || tree_.open_.contains(r.family);
        draw_chevron(x + l.gap(), y + (h - l.px(12)) / 2, l.px(12), open, theme().faint_text);
        fl_font(FL_HELVETICA_BOLD, l.font());
        draw_text(family_title(r.family), x + l.gap() + l.px(16), y, w - l.px(24), h, theme().text);
    } else {
        fl_font(FL_HELVETICA, l.font());
        int left = x + l.gap() + l.px(16);
        if (r.op->family() == "extrude") { // what it makes
            if (Fl_RGB_Image* picture = tree_.pictures_.find(*r.op, {}, l.small_picture())) picture->draw(left, y + (h - picture->h()) / 2);
            left += l.small_picture() + l.gap();
        }
        draw_text(r.op->title(), left, y, x + w - l.px(24) - left, h, selected ? theme().on_accent : theme().text);
        if (acts_on_click(*r.op)) { // a dot: it acts on what is clicked
            fl_color(selected ? theme().on_accent : theme().faint_text);
            const int size = l.px(5);
            fl_pie(x + w - l.margin() - size, y + (h - size) / 2, size, size, 0, 360);
        }
    }
    if (row == current() && Fl::focus() == this && !selected) {
        fl_color(theme().border);
        fl_rect(x, y, w, h);
    }
}

bool OperatorTree::List::is_selected(int row) const
{
    const Operator* op = tree_.rows_[std::size_t(row)].op;
    return op && op == tree_.session_.chosen();
}

void OperatorTree::List::press_row(int row, int, int button, bool)
{
    if (button != 1) return;
    set_current(row);
    const Row r = tree_.rows_[std::size_t(row)];
    if (r.op) {
        // A second click on the armed operator puts it down again.
        tree_.session_.choose(r.op == tree_.session_.chosen() && acts_on_click(*r.op) ? nullptr : r.op);
    } else {
        if (!tree_.open_.erase(r.family)) tree_.open_.insert(r.family);
        tree_.fill();
    }
}

/// The first one that has the words in its name, before those that only speak of them.
void OperatorTree::List::choose_first()
{
    const Operator* first = nullptr;
    for (const Row& r : tree_.rows_) {
        if (!r.op) continue;
        if (!first) first = r.op;
        if (searchable(r.op->name).find(tree_.looked_for_) == std::string::npos) continue;
        first = r.op;
        break;
    }
    if (first) tree_.session_.choose(first);
}

std::string OperatorTree::List::tip(int row) const
{
    const Operator* op = tree_.rows_[std::size_t(row)].op;
    if (!op) return {};
    return op->help + "\n" + op->name + (acts_on_click(*op) ? "\nacts on what is clicked" : "");
}

} // namespace druse::ui
