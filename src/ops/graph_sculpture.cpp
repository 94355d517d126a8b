// graph.sculpture: figures of Hart 2009, each in one step.
#include "ops/graph.h"
#include "ops/struts.h"
#include "ops/text.h"

#include <array>
#include <string_view>

namespace druse {

namespace {

/// What an operator is called with: its arguments as in a command, none of which holds a blank.
struct RecipeStep {
    Operator (*op)();
    const char* arguments;
};
constexpr RecipeStep no_step{nullptr, ""};
constexpr RecipeStep thin{graph_struts_operator, "radius=0.08"}, thick{graph_struts_operator, "radius=0.1"};

struct Recipe {
    const char* name;
    std::array<RecipeStep, 3> steps;
};

constexpr std::array<Recipe, 18> sculptures{{
    {"sand-dollar", {{{graph_tess_operator, "config=7,7,7 layers=3"}, {graph_map_operator, "to=disk"}, thin}}},
    {"sand-dollar-3", {{{graph_tess_operator, "config=3,3,3,3,3,3,3 center=vertex layers=3"}, {graph_map_operator, "to=disk"}, thin}}},
    {"sand-dollar-thin", {{{graph_tess_operator, "config=5,4,5,4 center=face:5 layers=2"}, {graph_map_operator, "to=disk"}, {graph_struts_operator, "radius=0.05"}}}},
    {"sand-dollar-thick", {{{graph_tess_operator, "config=5,4,5,4 center=face:5 layers=2"}, {graph_map_operator, "to=disk"}, {graph_struts_operator, "radius=0.15"}}}},
    {"polyp", {{{graph_tess_operator, "config=7,7,7 center=vertex layers=3"}, {graph_map_operator, "to=polyp"}, {graph_struts_operator, "radius=0.08 sides=3"}}}},
    {"helix", {{{graph_tess_operator, "config=5,3,4,3,3 center=face:5 layers=3"}, {graph_map_operator, "to=helix turns=2"}, thin}}},
    {"helix-7", {{{graph_tess_operator, "config=7,6,6 center=face:7 layers=3"}, {graph_map_operator, "to=helix turns=2"}, thin}}},
    {"spring", {{{graph_tess_operator, "config=3,3,3,3,3,3,3 layers=2"}, {graph_map_operator, "to=helix turns=2 shape=cylinder"}, thin}}},
    {"swirl-5", {{{graph_tess_operator, "config=5,4,5,4 center=face:5 layers=2"}, {graph_map_operator, "to=torus cycles=5"}, thin}}},
    {"swirl-7", {{{graph_tess_operator, "config=7,6,6 center=face:7 layers=3"}, {graph_map_operator, "to=torus cycles=7"}, thin}}},
    {"knotted-kelp", {{{graph_tess_operator, "config=7,6,6 center=face:7 layers=2"}, {graph_map_operator, "to=knot cycles=9"}, thin}}},
    {"icosa-lace", {{{graph_tess_operator, "config=5,4,5,4 center=face:5 layers=2"}, {graph_map_operator, "to=polyhedron solid=icosahedron"}, thin}}},
    {"dodeca-lace", {{{graph_tess_operator, "config=5,4,5,4 center=face:5 layers=2"}, {graph_map_operator, "to=polyhedron solid=dodecahedron"}, thin}}},
    {"diamond", {{{graph_lattice_operator, "kind=diamond"}, thick, no_step}}},
    {"double-diamond", {{{graph_lattice_operator, "kind=diamond double=true"}, thick, no_step}}},
    {"triamond", {{{graph_lattice_operator, "kind=srs"}, thick, no_step}}},
    {"double-triamond", {{{graph_lattice_operator, "kind=srs double=true"}, thick, no_step}}},
    {"bunny-struts", {{{graph_wireframe_operator, ""}, thin, no_step}}},
}};

enum class SculptureName : std::size_t {}; // a place in the table

Words sculpture_names()
{
    Words names;
    for (const Recipe& recipe : sculptures) names.list.emplace_back(recipe.name);
    return names;
}

struct SculptureParameters {
    SculptureName name{};
};

void run_recipe_step(Scene& scene, const RecipeStep& step, Context& context)
{
    const Operator op = step.op();
    const auto parameters = op.make();
    for (const std::string_view argument : split(step.arguments, ' ')) {
        const auto sign = argument.find('=');
        const Parameter* p = op.find(argument.substr(0, sign));
        ASSERT(p, "a parameter of the operator");
        p->set(parameters.get(), argument.substr(sign + 1));
    }
    op.run(scene, parameters.get(), context);
}

void run_sculpture(Scene& scene, const SculptureParameters& p, Context& context)
{
    for (const RecipeStep& step : sculptures[static_cast<std::size_t>(p.name)].steps)
        if (step.op) run_recipe_step(scene, step, context);
}

} // namespace

Operator graph_sculpture_operator()
{
    using P = SculptureParameters;
    return define<P>("graph.sculpture", "Make a sculpture of struts, graph and solid")
        .param(&P::name, "name", sculpture_names(), "which one; bunny-struts are those of the edges of the mesh, the others need no mesh")
        .required()
        .example("graph.sculpture name=diamond")
        .cites("Hart 2009")
        .run(run_sculpture);
}

} // namespace druse
