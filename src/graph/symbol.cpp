#include "graph/symbol.h"

#include <algorithm>
#include <cstddef>

namespace druse {

namespace {

/// An edge as a vertex sees it: its slot, and whether slots are numbered clockwise there. Packed, so that tables can be indexed by it.
struct SlotState {
    int slot;
    bool mirrored;
};

int wrapped_slot(int i, int k) { return ((i % k) + k) % k; }

int slot_image(const SlotSymmetry& s, int slot, int k) { return wrapped_slot(s.mirrored ? s.shift - slot : s.shift + slot, k); }
/// Corner i lies between the slots i and i + 1.
int corner_image(const SlotSymmetry& s, int corner, int k) { return wrapped_slot(s.mirrored ? s.shift - 1 - corner : s.shift + corner, k); }

/// All rotations and reflections that leave the polygons as they are: groups of them, the largest first.
std::vector<std::vector<SlotSymmetry>> groups_of(std::span<const int> polygons)
{
    const int k = static_cast<int>(polygons.size());
    const auto keeps = [&](const SlotSymmetry& s) {
        for (int i = 0; i < k; ++i)
            if (polygons[std::size_t(corner_image(s, i, k))] != polygons[std::size_t(i)]) return false;
        return true;
    };
    int rotations = 0;
    std::vector<int> reflections;
    for (int shift = 0; shift < k; ++shift) {
        rotations += keeps({shift, false});
        if (keeps({shift, true})) reflections.push_back(shift);
    }
    std::vector<std::vector<SlotSymmetry>> groups;
    for (int order = 1; order <= rotations; ++order) {
        if (rotations % order != 0) continue;
        const int spacing = k / order;
        std::vector<SlotSymmetry> cyclic;
        for (int j = 0; j < order; ++j) cyclic.push_back({j * spacing, false});
        groups.push_back(cyclic);
        // Reflections whose shifts differ by a spacing are in the same group.
        for (const int shift : reflections) {
            if (shift >= spacing) continue;
            groups.push_back(cyclic);
            for (int j = 0; j < order; ++j) groups.back().push_back({shift + j * spacing, true});
        }
    }
    std::ranges::stable_sort(groups, std::ranges::greater(), [](const auto& g) { return g.size(); });
    return groups;
}

/// The search for one group. What the group takes to each other is one class; a symbol pairs classes, some with themselves.
class SymbolSearch {
public:
    SymbolSearch(std::span<const int> polygons, const std::vector<SlotSymmetry>& group)
        : polygons_(polygons), group_(group), k_(static_cast<int>(polygons.size())), class_(std::size_t(2 * k_), none)
    {
        for (int x = 0; x < 2 * k_; ++x) {
            if (class_[std::size_t(x)] != none) continue;
            for (const SlotSymmetry& s : group_) {
                const SlotState state = unpacked(x);
                class_[std::size_t(packed({slot_image(s, state.slot, k_), state.mirrored != s.mirrored}))] = classes_;
            }
            first_.push_back(unpacked(x)); // not mirrored where any state of the class is not
            ++classes_;
        }
        partner_.assign(std::size_t(classes_), none);
    }

    std::optional<AdjacencySymbol> find()
    {
        for (const bool may_mirror : {false, true}) {
            std::ranges::fill(partner_, none);
            if (!pair_from(0, may_mirror)) continue;
            AdjacencySymbol symbol;
            symbol.stabiliser = group_;
            for (int slot = 0; slot < k_; ++slot) symbol.partners.push_back(first_partner(slot));
            return symbol;
        }
        return std::nullopt;
    }

private:
    static constexpr int none = -1;

    int packed(const SlotState& s) const { return s.slot + (s.mirrored ? k_ : 0); }
    SlotState unpacked(int x) const { return {x % k_, x >= k_}; }
    int class_of(const SlotState& s) const { return class_[std::size_t(packed(s))]; }
    int polygon(int i) const { return polygons_[std::size_t(wrapped_slot(i, k_))]; }

    AdjacencySymbol::Partner first_partner(int slot) const
    {
        const SlotState& s = first_[std::size_t(partner_[std::size_t(class_of({slot, false}))])];
        return {s.slot, s.mirrored};
    }

    /// Seen from its other end an edge has left and right exchanged.
    bool fits(int slot, const SlotState& other) const
    {
        const int right = polygon(other.mirrored ? other.slot : other.slot - 1), left = polygon(other.mirrored ? other.slot - 1 : other.slot);
        return left == polygon(slot - 1) && right == polygon(slot);
    }

    /// Gives partners to the slots from this one on.
    bool pair_from(int slot, bool may_mirror)
    {
        while (slot < k_ && partner_[std::size_t(class_of({slot, false}))] != none) ++slot;
        if (slot == k_) return true;
        const int ours = class_of({slot, false}), ours_mirrored = class_of({slot, true});
        int tried[24], count = 0;
        for (int x = 0; x < (may_mirror ? 2 * k_ : k_); ++x) {
            // In the order of slots, each first as it is and then mirrored.
            const SlotState other = may_mirror ? SlotState{x / 2, x % 2 == 1} : SlotState{x, false};
            if (!fits(slot, other)) continue;
            const int theirs = class_of(other), theirs_mirrored = class_of({other.slot, !other.mirrored});
            if (std::find(tried, tried + count, theirs) != tried + count) continue;
            tried[count++] = theirs;
            if (partner_[std::size_t(theirs)] != none || partner_[std::size_t(theirs_mirrored)] != none) continue;
            // Where the class of a slot is its own mirror image, that of its partner must be so too.
            if ((ours == ours_mirrored) != (theirs == theirs_mirrored)) continue;
            const auto join = [this](int a, int b, int value_a, int value_b) {
                partner_[std::size_t(a)] = value_a;
                partner_[std::size_t(b)] = value_b;
            };
            join(ours, ours_mirrored, theirs, theirs_mirrored);
            join(theirs, theirs_mirrored, ours, ours_mirrored);
            if (partner_[std::size_t(ours)] == theirs && walks_close() && pair_from(slot + 1, may_mirror)) return true;
            join(ours, ours_mirrored, none, none);
            join(theirs, theirs_mirrored, none, none);
        }
        return false;
    }

    /// A walk round the polygon at each corner that comes back does so after a number of steps that divides its sides.
    bool walks_close() const
    {
        for (int corner = 0; corner < k_; ++corner) {
            const int sides = polygons_[std::size_t(corner)];
            int steps = 0;
            SlotState at{corner, false}; // the slot along which the walk leaves, the polygon on its left
            const int start = class_of(at);
            do {
                const int next = partner_[std::size_t(class_of(at))];
                if (next == none || steps > sides) break;
                at = first_[std::size_t(next)];
                // Seen from there the polygon is on the right, and the walk goes on along its other side.
                if (at.mirrored) at.slot = at.slot + 1 < k_ ? at.slot + 1 : 0;
                else at.slot = at.slot > 0 ? at.slot - 1 : k_ - 1;
                ++steps;
                if (class_of(at) == start) break;
            } while (true);
            const bool closed = steps > 0 && class_of(at) == start;
            if (closed ? sides % steps != 0 : steps > sides) return false;
        }
        return true;
    }

    std::span<const int> polygons_;
    const std::vector<SlotSymmetry>& group_;
    int k_, classes_ = 0;
    std::vector<int> class_;   // of each packed state
    std::vector<SlotState> first_; // of each class
    std::vector<int> partner_;     // of each class
};

} // namespace

int AdjacencySymbol::period(int corner) const
{
    const int k = static_cast<int>(partners.size());
    const auto is_start = [&](int at, bool mirrored) {
        return std::ranges::any_of(stabiliser, [&](const SlotSymmetry& s) { return s.mirrored == mirrored && corner_image(s, at, k) == corner; });
    };
    int at = corner, steps = 0;
    bool mirrored = false;
    do {
        const Partner& p = partners[std::size_t(mirrored ? wrapped_slot(at + 1, k) : at)];
        mirrored = mirrored != p.mirrored;
        at = mirrored ? p.slot : wrapped_slot(p.slot - 1, k);
        ++steps;
    } while (!is_start(at, mirrored));
    return steps;
}

bool AdjacencySymbol::is_mirrored_at(int corner) const
{
    const int k = static_cast<int>(partners.size());
    return std::ranges::any_of(stabiliser, [&](const SlotSymmetry& s) { return s.mirrored && corner_image(s, corner, k) == corner; });
}

std::optional<AdjacencySymbol> find_symbol(std::span<const int> polygons)
{
    for (const std::vector<SlotSymmetry>& group : groups_of(polygons))
        if (auto symbol = SymbolSearch(polygons, group).find()) return symbol;
    return std::nullopt;
}

} // namespace druse
