#include "tile/incidence_symbol.h"

#include "dlfl/errors.h"

#include <algorithm>

namespace druse {

namespace {

/// A letter and the sign that may follow it.
struct Signed {
    int letter = 0, sign = 0;
};

std::vector<Signed> signed_letters(std::string_view text)
{
    std::vector<Signed> list;
    for (const char c : text) {
        if (c == '+') list.back().sign = 1;
        else if (c == '-') list.back().sign = -1;
        else list.push_back({c - 'a', 0});
    }
    return list;
}

bool keeps(const IncidenceSymbol& symbol, const OwnSymmetry& way)
{
    for (int k = 0; k < symbol.corners; ++k) {
        const int corner = symbol.corner(way.corner(k)), edge = symbol.corner(way.edge(k));
        if (symbol.valence[corner] != symbol.valence[k] || symbol.letter[edge] != symbol.letter[k] ||
            symbol.arrow[edge] != (way.reflects ? -symbol.arrow[k] : symbol.arrow[k]))
            return false;
    }
    return true;
}

/// A walker at a corner, about to cross the edge that starts there, or the one that ends there.
struct Walker {
    int corner = 0;
    bool forward = true;
};

} // namespace

IncidenceSymbol IncidenceSymbol::parse(std::string_view valences, std::string_view tile, std::string_view adjacency)
{
    IncidenceSymbol symbol;
    int k = 0;
    for (const auto [letter, sign] : signed_letters(tile)) {
        symbol.letter[k] = letter;
        symbol.arrow[k++] = sign;
    }
    symbol.corners = k;
    k = 0;
    for (const auto [letter, sign] : signed_letters(adjacency)) symbol.answer[k++] = {letter, sign};
    k = 0;
    for (const char c : valences) {
        if (c == ' ') ++k;
        else symbol.valence[k] = 10 * symbol.valence[k] + (c - '0');
    }
    return symbol;
}

std::vector<OwnSymmetry> own_symmetries(const IncidenceSymbol& symbol)
{
    std::vector<OwnSymmetry> list;
    for (const bool reflects : {false, true})
        for (int shift = 0; shift < symbol.corners; ++shift)
            if (keeps(symbol, {shift, reflects})) list.push_back({shift, reflects});
    return list;
}

std::vector<TileCrossing> crossings(const IncidenceSymbol& symbol)
{
    std::vector<TileCrossing> list;
    for (int k = 0; k < symbol.corners; ++k)
        for (int j = 0; j < symbol.corners; ++j) {
            const auto& [letter, sign] = symbol.answer[symbol.letter[k]];
            if (symbol.letter[j] != letter) continue;
            const int product = symbol.arrow[k] * sign * symbol.arrow[j]; // 0: edges without arrows meet both ways
            if (product >= 0) list.push_back({k, j, true});
            if (product <= 0) list.push_back({k, j, false});
        }
    return list;
}

std::vector<TileCrossing> parse_placed(const IncidenceSymbol& symbol, std::string_view text)
{
    if (text == "=") return crossings(symbol);
    std::vector<TileCrossing> list;
    for (const auto [letter, sign] : signed_letters(text)) list.push_back({static_cast<int>(list.size()), letter, sign > 0});
    return list;
}

bool closes(const IncidenceSymbol& symbol)
{
    const auto own = own_symmetries(symbol);
    const auto all = crossings(symbol);
    const auto partner = [&](int edge) { return *std::ranges::find(all, edge, &TileCrossing::edge); };
    for (int start = 0; start < symbol.corners; ++start) {
        const auto is_back = [&](const Walker& at) {
            return std::ranges::any_of(own, [&](const OwnSymmetry& s) { return symbol.corner(s.corner(start)) == at.corner && at.forward != s.reflects; });
        };
        Walker at{start, true};
        int steps = 0;
        do {
            const auto [edge, j, direct] = partner(symbol.corner(at.forward ? at.corner : at.corner - 1));
            // The neighbour is entered by its edge j; its next edge round the corner is the one on the other side of that corner.
            at = at.forward == direct ? Walker{symbol.corner(j + 1), true} : Walker{j, false};
            ++steps;
            if (symbol.valence[at.corner] != symbol.valence[start] || steps > symbol.valence[start]) return false;
        } while (!is_back(at));
        if (symbol.valence[start] % steps != 0) return false;
    }
    return true;
}

} // namespace druse
