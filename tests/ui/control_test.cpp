#include "ui/control.h"

#include "app/registry.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace druse::ui {
namespace {

Control control(const char* op, const char* parameter, int place = -1)
{
    for (const Control& c : controls_of(all_operators().get(op)))
        if (c.parameter == parameter && (place < 0 || c.place == place)) return c;
    ADD_FAILURE() << op << " has no " << parameter;
    return {};
}

TEST(Controls, EveryParameterOfEveryOperatorHasOne)
{
    for (const Operator& op : all_operators().operators()) {
        const auto controls = controls_of(op);
        for (const Parameter& p : op.parameters) {
            const auto count = std::count_if(controls.begin(), controls.end(), [&](const Control& c) { return c.parameter == p.name; });
            EXPECT_GE(count, 1) << op.name << " " << p.name;
        }
        for (const Control& c : controls) {
            EXPECT_FALSE(c.label.empty());
            EXPECT_NE(c.help.find(op.find(c.parameter)->help), std::string::npos);
            if (c.slider) {
                EXPECT_LT(c.low, c.high) << op.name << " " << c.label;
                EXPECT_GT(c.step, 0) << op.name << " " << c.label;
            }
        }
    }
}

TEST(Controls, EverySliderEndGivesAValueThatTheOperatorTakes)
{
    for (const Operator& op : all_operators().operators())
        for (const Control& c : controls_of(op)) {
            if (!c.slider) continue;
            for (const double x : {c.low, c.high, 0.5 * (c.low + c.high), 0.0, c.low - 1, c.high + 1})
                EXPECT_TRUE(c.range.contains(c.snap(x))) << op.name << " " << c.label << " at " << x << " gives " << c.snap(x);
        }
}

TEST(Controls, AListOfTierHeightsIsASliderForEachTier)
{
    const auto controls = controls_of(all_operators().get("extrude.dodecahedral"));
    EXPECT_EQ(std::count_if(controls.begin(), controls.end(), [](const Control& c) { return c.parameter == "heights" && c.slider; }), 3);
    EXPECT_EQ(control("extrude.dodecahedral", "heights", 1).label, "height 2");
    EXPECT_EQ(control("extrude.dodecahedral", "heights", 1).initial, "1.538841768587627");
    EXPECT_EQ(control("extrude.cubical", "heights").label, "heights"); // only one: no number
}

TEST(Controls, AnAngleSlidesOverItsWholeRangeAndAHeightNeverStopsAtZero)
{
    const Control angle = control("extrude.cubical", "angle");
    EXPECT_EQ(angle.low, 1);
    EXPECT_EQ(angle.high, 179);
    const Control height = control("extrude.cubical", "heights");
    EXPECT_LT(height.low, 0);
    EXPECT_NE(height.snap(0), 0);
    EXPECT_NE(height.snap(-1e-9), 0);
}

TEST(Controls, ASliderGivesShortDecimals)
{
    const Control angle = control("extrude.cubical", "angle");
    EXPECT_EQ(angle.snap(100.3 + 1e-7), 100.5);
    const Control height = control("extrude.cubical", "heights");
    EXPECT_EQ(height.snap(1.2400001), 1.24);
}

TEST(Controls, KindsFollowTheTypesOfParameters)
{
    EXPECT_EQ(control("extrude.cubical", "faces").kind, Control::Kind::selector);
    EXPECT_EQ(control("extrude.cubical", "grouped").kind, Control::Kind::toggle);
    EXPECT_EQ(control("extrude.cubical", "groups").kind, Control::Kind::choice);
    EXPECT_TRUE(control("extrude.cubical", "iterations").integer);
    EXPECT_EQ(control("document.open", "file").kind, Control::Kind::file);
    EXPECT_EQ(control("extrude.solid", "solid").kind, Control::Kind::solid);
    EXPECT_TRUE(control("document.open", "file").required);
}

TEST(Controls, WhatASolidImpliesCanSlide)
{
    const Operator& op = all_operators().get("extrude.solid");
    Arguments arguments(op);
    arguments.set("solid", "snub_cube"); // on its square: 5 tiers, 142.98 degrees
    const auto controls = controls_of(op, implied_values(arguments));
    EXPECT_EQ(std::count_if(controls.begin(), controls.end(), [](const Control& c) { return c.parameter == "heights" && c.slider; }), 5);
    const auto angle = std::find_if(controls.begin(), controls.end(), [](const Control& c) { return c.parameter == "angle"; });
    EXPECT_TRUE(angle->slider);
    EXPECT_EQ(angle->initial, ""); // unset, whatever the solid
    EXPECT_EQ(implied_values(arguments).at("angle").text, "142.98343");
    arguments.set("base", "3"); // 7 tiers over a triangle
    EXPECT_EQ(split(implied_values(arguments).at("heights").text, ',').size(), 7u);
    arguments.set("solid", "./no_such.obj");
    EXPECT_TRUE(implied_values(arguments).empty());
    arguments.set("base", "");
    arguments.set("solid", "dodecahedron.obj");
    EXPECT_EQ(implied_values(arguments, DRUSE_MODELS).at("heights").text, "1,1,1");
    EXPECT_EQ(control("extrude.solid", "heights").kind, Control::Kind::field);
}

TEST(Controls, WhatAutoStandsForCanSlide)
{
    const Operator& op = all_operators().get("graph.map");
    Arguments arguments(op);
    const auto row = [&](const char* name) {
        const auto controls = controls_of(op, implied_values(arguments));
        return *std::find_if(controls.begin(), controls.end(), [name](const Control& c) { return c.parameter == name; });
    };
    EXPECT_FALSE(row("major").slider); // until it is known what is made
    arguments.set("to", "torus");
    EXPECT_EQ(implied_values(arguments).at("major").text, "1.6");
    const Control major = row("major"), cycles = row("cycles");
    EXPECT_TRUE(major.slider);
    EXPECT_EQ(major.high, 4 * 1.6);
    EXPECT_TRUE(cycles.integer);
    EXPECT_EQ(cycles.high, 20);
    arguments.set("major", "2.5"); // a slider that is dragged stays where it is
    EXPECT_TRUE(row("major").is_like(major));
    EXPECT_EQ(implied_values(arguments).at("major").text, "2.5");
    arguments.set("to", "knot");
    EXPECT_EQ(implied_values(arguments).at("rho").text, "0.6");

    Arguments lattice(all_operators().get("graph.lattice"));
    lattice.set("trim", "ball");
    lattice.set("cells", "3,2,4");
    EXPECT_EQ(implied_values(lattice).at("size").text, "1");
}

TEST(Controls, PiecesOfAListAreReplacedOneByOne)
{
    EXPECT_EQ(piece_of("1,2.5,3", 1), "2.5");
    EXPECT_EQ(piece_of("1,2.5,3", 7), "");
    EXPECT_EQ(with_piece("1,2.5,3", 1, "-4"), "1,-4,3");
    EXPECT_EQ(with_piece("1,2.5,3", -1, "all"), "all");
}

} // namespace
} // namespace druse::ui
