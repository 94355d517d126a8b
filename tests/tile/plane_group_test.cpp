#include "tile/plane_group.h"

#include "tile/isohedral_type.h"
#include "tile/tile_facts.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace druse {
namespace {

TEST(PlaneGroup, IsTheOnePublishedForEachType)
{
    for (const auto& facts : test::tile_facts) {
        const IsohedralType& type = isohedral_type(facts.number);
        EXPECT_EQ(name(type.full, type.start), facts.full) << type.name();
        EXPECT_EQ(name(type.placed, type.start), facts.placed) << type.name();
    }
}

TEST(PlaneGroup, OccursAsOftenAsListedAmongTheTypes)
{
    std::map<std::string, int> full, placed;
    for (const IsohedralType& type : isohedral_types()) {
        ++full[name(type.full, type.start)];
        ++placed[name(type.placed, type.start)];
    }
    const std::map<std::string, int> all = {{"p1", 2},  {"pg", 4}, {"pm", 2},  {"cm", 6},  {"p2", 7}, {"pmg", 9},  {"pgg", 10}, {"pmm", 1},
                                            {"cmm", 7}, {"p4", 5}, {"p4m", 2}, {"p4g", 5}, {"p3", 3}, {"p31m", 5}, {"p6", 7},   {"p6m", 6}};
    const std::map<std::string, int> reached = {{"p1", 17}, {"pg", 6}, {"pm", 2},  {"cm", 3}, {"p2", 14},  {"pmg", 4}, {"pgg", 8},
                                                {"cmm", 2}, {"p4", 8}, {"p4g", 2}, {"p3", 6}, {"p31m", 2}, {"p6", 6},  {"p6m", 1}};
    EXPECT_EQ(full, all);
    EXPECT_EQ(placed, reached);
}

TEST(PlaneGroup, HasALatticeOfTheAreaOfItsAspects)
{
    // Bases of page-sized examples: a corner of each, with the area of one tile.
    for (const IsohedralType& type : isohedral_types()) {
        const Point2 a = type.placed.lattice[0].at(type.start), b = type.placed.lattice[1].at(type.start);
        double area = 0;
        for (int k = 0; k < type.corners; ++k) {
            const Point2 p = corner(type.start, k), q = corner(type.start, type.symbol.corner(k + 1));
            area += 0.5 * (p.x * q.y - p.y * q.x);
        }
        EXPECT_NEAR(a.x * b.y - a.y * b.x, type.aspects() * area, 1e-12) << type.name();
    }
}

} // namespace
} // namespace druse
