#include "tile/isohedral_table.h"

namespace druse {

namespace {

constexpr double root3 = 1.7320508075688772;

constexpr double hexagon[] = {0, 0, 1 / root3, 0, root3 / 2, 0.5, 1 / root3, 1, 0, 1, -1 / (2 * root3), 0.5};
constexpr double floret[] = {1, 0, 1.25, root3 / 4, 1, root3 / 2, 0.5, root3 / 2, 0, 0};
constexpr double house[] = {1, 0.5 + 1 / (2 * root3), 0.5, 0.5 + 1 / root3, 0, 0.5 + 1 / (2 * root3), 0, 0, 1, 0};
constexpr double cairo[] = {0, 0, 1, 0, 1 + (1 + root3) / 4, (3 + root3) / 4, 0.5, 1 + root3 / 2, -(1 + root3) / 4, (3 + root3) / 4};
constexpr double kite[] = {1, 0, 0.75, root3 / 4, 0, 0, 0.75, -root3 / 4};
constexpr double rhombus[] = {0.5, 1 / (2 * root3), 0, 0, 0.5, -1 / (2 * root3), 1, 0};
constexpr double flat_triangle[] = {0.5, 1 / (2 * root3), 0, 0, 1, 0};
constexpr double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
constexpr double drafter[] = {root3 / 2, 0, root3 / 2, 0.5, 0, 0};
constexpr double half_square[] = {0.5, 0.5, 0, 0, 1, 0};
constexpr double triangle[] = {0, 0, 1, 0, 0.5, root3 / 2};

constexpr TileNet nets[] = {
    {"3^6", "3 3 3 3 3 3", hexagon, 0},
    {"3^4.6", "3 3 3 3 6", floret, 4},
    {"3^3.4^2", "3 3 3 4 4", house, 3},
    {"3^2.4.3.4", "3 3 4 3 4", cairo, 0},
    {"3.4.6.4", "3 4 6 4", kite, 2},
    {"3.6.3.6", "3 6 3 6", rhombus, 1},
    {"3.12^2", "3 12 12", flat_triangle, 1},
    {"4^4", "4 4 4 4", square, 0},
    {"4.6.12", "4 6 12", drafter, 2},
    {"4.8^2", "4 8 8", half_square, 1},
    {"6^3", "6 6 6", triangle, 0},
};

constexpr TileLine lines[] = {
    {1, 0, "a+b+c+d+e+f+", "d+e+f+a+b+c+", "="},
    {2, 0, "a+b+c+d+e+f+", "d+c-b-a+f-e-", "="},
    {3, 0, "a+b+c+d+e+f+", "d+f-e-a+c-b-", "="},
    {4, 0, "a+b+c+d+e+f+", "a+b+f+d+e+c+", "="},
    {5, 0, "a+b+c+d+e+f+", "d+b+c+a+f-e-", "="},
    {6, 0, "a+b+c+d+e+f+", "d-b+e-a-c-f+", "="},
    {7, 0, "a+b+c+d+e+f+", "b+a+d+c+f+e+", "="},
    {8, 0, "a+b+c+a+b+c+", "a+b+c+", "d+e+f+a+b+c+"},
    {9, 0, "a+b+c+a+b+c+", "a+c-b-", "d+c-b-a+f-e-"},
    {10, 0, "a+b+a+b+a+b+", "b+a+", "d+e+f+a+b+c+"},
    {11, 0, "a+a+a+a+a+a+", "a+", "d+e+f+a+b+c+"},
    {12, 0, "ab+c+dc-b-", "dc-b-a", "d+e+f+a+b+c+"},
    {13, 0, "ab+c+dc-b-", "db+c+a", "d+b+c+a+e+f+"},
    {14, 0, "a+b+b-a-c+c-", "a-c+b+", "d+e+f+a+b+c+"},
    {15, 0, "a+b+b-a-c+c-", "a-b+c+", "d+b+c+a+e+f+"},
    {16, 0, "a+a-b+c+c-b-", "a-c+b+", "b+a+d+c+f+e+"},
    {17, 0, "ab+b-ab+b-", "ab+", "d+e+f+a+b+c+"},
    {18, 0, "ababab", "ba", "d+e+f+a+b+c+"},
    {20, 0, "aaaaaa", "a", "d+e+f+a+b+c+"},
    {21, 1, "a+b+c+d+e+", "a+c+b+e+d+", "="},
    {22, 2, "a+b+c+d+e+", "b-a-e+d-c+", "="},
    {23, 2, "a+b+c+d+e+", "a+b+e+d+c+", "="},
    {24, 2, "a+b+c+d+e+", "a+b+e+d-c+", "="},
    {25, 2, "a+b+c+d+e+", "b-a-e+d+c+", "="},
    {26, 2, "a+a-b+cb-", "a+b-c", "a+b+e+d+c+"},
    {27, 3, "a+b+c+d+e+", "a+d-e-b-c-", "="},
    {28, 3, "a+b+c+d+e+", "a+c+b+e+d+", "="},
    {29, 3, "ab+c+c-b-", "ac+b+", "a+c+b+e+d+"},
    {30, 4, "a+b+c+d+", "d+b-c-a+", "="},
    {31, 4, "a+b+c+d+", "d+c+b+a+", "="},
    {32, 4, "a+b+b-a-", "a-b-", "d+c+b+a+"},
    {33, 5, "a+b+c+d+", "d+c+b+a+", "="},
    {34, 5, "a+b+a+b+", "b+a+", "d+c+b+a+"},
    {36, 5, "a+a-b+b-", "b-a-", "d+c+b+a+"},
    {37, 5, "a+a-a+a-", "a-", "d+c+b+a+"},
    {38, 6, "a+b+c+", "c+b-a+", "="},
    {39, 6, "a+b+c+", "c+b+a+", "="},
    {40, 6, "a+ba-", "a-b", "c+b+a+"},
    {41, 7, "a+b+c+d+", "c+d+a+b+", "="},
    {42, 7, "a+b+c+d+", "a-d+c-b+", "="},
    {43, 7, "a+b+c+d+", "c+d-a+b-", "="},
    {44, 7, "a+b+c+d+", "b-a-d-c-", "="},
    {45, 7, "a+b+c+d+", "a-d-c-b-", "="},
    {46, 7, "a+b+c+d+", "a+b+c+d+", "="},
    {47, 7, "a+b+c+d+", "a+d+c+b+", "="},
    {49, 7, "a+b+c+d+", "a+b-c+d-", "="},
    {50, 7, "a+b+c+d+", "a+d+c-b+", "="},
    {51, 7, "a+b+c+d+", "a+d-c+b-", "="},
    {52, 7, "a+b+c+d+", "c-d-a-b-", "="},
    {53, 7, "a+b+c+d+", "a+b+d-c-", "="},
    {54, 7, "a+b+c+d+", "a+b-c-d-", "="},
    {55, 7, "a+b+c+d+", "b+a+d+c+", "="},
    {56, 7, "a+b+c+d+", "a-b-d+c+", "="},
    {57, 7, "a+b+a+b+", "a+b+", "c+d+a+b+"},
    {58, 7, "a+b+a+b+", "a+b-", "c+b-a+d-"},
    {59, 7, "a+b+a+b+", "b-a-", "b-a-d-c-"},
    {61, 7, "a+b+a+b+", "b+a+", "b+a+d+c+"},
    {62, 7, "a+a+a+a+", "a+", "c+d+a+b+"},
    {64, 7, "ab+cb-", "cb-a", "c+d+a+b+"},
    {66, 7, "ab+cb-", "cb+a", "c+b+a+d+"},
    {67, 7, "ab+cb-", "ab+c", "a+b+c+d+"},
    {68, 7, "a+a-b+b-", "b+a+", "c+d+a+b+"},
    {69, 7, "a+a-b+b-", "a+b+", "a+b+c+d+"},
    {71, 7, "a+a-b+b-", "b-a-", "d+c+b+a+"},
    {72, 7, "abab", "ab", "c+d+a+b+"},
    {73, 7, "abab", "ba", "b+a+d+c+"},
    {74, 7, "a+a-a+a-", "a+", "c+d+a+b+"},
    {76, 7, "aaaa", "a", "c+d+a+b+"},
    {77, 8, "a+b+c+", "a-b-c-", "="},
    {78, 9, "a+b+c+", "a-b+c-", "="},
    {79, 9, "a+b+c+", "c+b+a+", "="},
    {81, 9, "a+b+c+", "c+b-a+", "="},
    {82, 9, "a+ba-", "a-b", "c+b+a+"},
    {83, 10, "a+b+c+", "a-c-b-", "="},
    {84, 10, "a+b+c+", "a+b+c+", "="},
    {85, 10, "a+b+c+", "a-b+c+", "="},
    {86, 10, "a+b+c+", "a+c-b-", "="},
    {88, 10, "a+b+c+", "a+c+b+", "="},
    {90, 10, "a+a+a+", "a+", "a+b+c+"},
    {91, 10, "ab+b-", "ab+", "a+b+c+"},
    {93, 10, "aaa", "a", "a+b+c+"},
};

} // namespace

std::span<const TileNet> tile_nets() { return nets; }
std::span<const TileLine> tile_lines() { return lines; }

} // namespace druse
