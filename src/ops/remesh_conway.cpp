// remesh.conway: the other operators by one letter each, applied from right to left.
#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "ops/remesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

namespace druse {

namespace {

struct Letter {
    char letter;
    int growth; // of the number of edges
    const char* command;
};
constexpr std::array letters{
    Letter{'d', 1, "remesh.dual"},        Letter{'a', 2, "remesh.ambo"},       Letter{'j', 2, "remesh.join"},
    Letter{'k', 3, "remesh.stellate"},    Letter{'z', 3, "remesh.honeycomb"},  Letter{'t', 3, "remesh.truncate"},
    Letter{'n', 3, "remesh.needle"},      Letter{'e', 4, "remesh.expand"},     Letter{'o', 4, "remesh.linear"},
    Letter{'g', 5, "remesh.pentagonal"},  Letter{'s', 5, "remesh.snub"},       Letter{'m', 6, "remesh.meta"},
    Letter{'b', 6, "remesh.bevel"},       Letter{'c', 4, "remesh.chamfer"},    Letter{'p', 5, "remesh.propeller"},
    Letter{'w', 7, "remesh.whirl"},       Letter{'l', 5, "remesh.loft"},       Letter{'q', 6, "remesh.pentagon_preserving"},
    Letter{'L', 7, "remesh.lace"},        Letter{'K', 7, "remesh.stake"},      Letter{'u', 4, "remesh.subdivide"},
    Letter{'C', 9, "remesh.checkerboard"},
};

/// One letter of a recipe with what goes with it.
struct Move {
    const Letter* letter = nullptr;
    bool mirror = false;
    int only = 0; // 0: all
};

/// The moves as they are written, from left to right.
/// @throws CommandError that names the position, from 1, of what it cannot read
std::vector<Move> read_recipe(const std::string& recipe)
{
    const auto fail = [&](std::size_t at, const std::string& what) { throw CommandError(fmt::format("recipe={}: {} at position {}", recipe, what, at + 1)); };
    constexpr std::size_t most = 20;
    std::vector<Move> moves;
    for (std::size_t i = 0; i < recipe.size();) {
        Move move;
        if (recipe[i] == 'r') {
            move.mirror = true;
            if (++i == recipe.size()) fail(i, "expected a letter after 'r'");
        }
        const char wanted = recipe[i];
        const auto found = std::ranges::find(letters, wanted, &Letter::letter);
        if (found == letters.end()) fail(i, wanted > ' ' && wanted <= '~' ? fmt::format("unknown letter '{}'", wanted) : "unknown letter");
        move.letter = &*found;
        const std::size_t digits = ++i;
        while (i < recipe.size() && recipe[i] >= '0' && recipe[i] <= '9') move.only = std::min(1000, 10 * move.only + (recipe[i++] - '0'));
        if (i > digits && wanted != 'k' && wanted != 't') fail(digits, fmt::format("a number, which '{}' does not take,", wanted));
        if (i > digits && (move.only < 3 || move.only > 100)) fail(digits, "expected 3 to 100");
        moves.push_back(move);
    }
    if (moves.empty() || moves.size() > most) throw CommandError(fmt::format("recipe={}: expected 1 to {} letters", recipe, most));
    return moves;
}

struct ConwayRecipe {
    std::string recipe;
    int planarize = 0;
    int iterations = 1;
    RemeshGroups groups = RemeshGroups::absolute;
};

/// Makes faces flatter: every face projects its corners on its plane, every vertex moves to the mean of its projections; until no corner is
/// out of plane by more than 1e-9 mean edge lengths, or the sweeps are used up. The mean of all vertices stays.
void planarize(Mesh& mesh, int sweeps, Progress& progress)
{
    if (mesh.vertex_count() == 0 || sweeps == 0) return;
    double edge = 0.0;
    for (const Edge e : mesh.edges()) edge += length(mesh, e) / mesh.edge_count();
    const auto middle = [&mesh] {
        Vector sum(0.0);
        for (const Point& p : mesh.positions()) sum += p;
        return sum / double(mesh.vertex_count());
    };
    const Point center = middle();
    std::vector<Vector> sums(mesh.vertex_limit());
    std::vector<int> counts(mesh.vertex_limit());
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        progress.step(double(sweep) / sweeps);
        std::ranges::fill(sums, Vector(0.0));
        std::ranges::fill(counts, 0);
        double farthest = 0.0;
        for (const Face f : mesh.faces()) {
            if (mesh.valence(f) < 4) continue;
            const Point on = vertex_mean(mesh, f);
            const Vector normal = unit_normal(mesh, f);
            for (const Corner c : mesh.corners(f)) {
                const double off = glm::dot(mesh.position(c) - on, normal);
                farthest = std::max(farthest, std::abs(off));
                sums[mesh.vertex(c).index] += mesh.position(c) - off * normal;
                ++counts[mesh.vertex(c).index];
            }
        }
        if (!(farthest > 1e-9 * edge)) break;
        const auto positions = mesh.write_positions();
        for (std::size_t v = 0; v < positions.size(); ++v)
            if (counts[v] > 0) positions[v] = sums[v] / double(counts[v]);
    }
    const Vector back = center - middle();
    for (Point& p : mesh.write_positions()) p += back;
}

using LetterOperators = std::map<char, Operator>;

void apply(const LetterOperators& operators, const Move& move, RemeshGroups groups, Scene& scene, Context& context)
{
    const Operator& op = operators.at(move.letter->letter);
    const auto parameters = op.make();
    const auto set = [&](const char* name, std::string_view value) { op.find(name)->set(parameters.get(), value); };
    set("groups", groups == RemeshGroups::absolute ? "absolute" : groups == RemeshGroups::keep ? "keep" : "none");
    if (move.letter->letter == 't') set("t", "0.333333333333333");
    if (move.only > 0) set("only", std::to_string(move.only));
    if (move.mirror && op.find("mirror")) set("mirror", "true"); // the others are their own mirror images
    op.run(scene, parameters.get(), context);
}

void run_recipe(const LetterOperators& operators, Scene& scene, const ConwayRecipe& p, Context& context)
{
    std::vector<Move> moves = read_recipe(p.recipe);
    std::ranges::reverse(moves);
    std::uint64_t growth = 1; // what depends on the model is refused when it comes to that
    for (int i = 0; i < p.iterations; ++i)
        for (const Move& move : moves)
            if (move.only == 0) remesh::refuse_too_large(scene.mesh.edge_count(), growth *= std::uint64_t(move.letter->growth), 1);
    for (int i = 0; i < p.iterations; ++i)
        for (const Move& move : moves) apply(operators, move, p.groups, scene, context);
    planarize(scene.mesh, p.planarize, context.progress);
}

} // namespace

void add_remesh_conway(Registry& registry)
{
    auto operators = std::make_shared<LetterOperators>();
    for (const Letter& l : letters) operators->emplace(l.letter, registry.get(l.command));

    using P = ConwayRecipe;
    auto definition = define<P>("remesh.conway", "Apply the operators of Conway's notation, a letter each, from right to left");
    definition.param(&P::recipe, "recipe", "letters adjkztneogsmbcpwlqLKuC; k5 and t4 for some faces, vertices; r mirrors the next").required()
        .param(&P::planarize, "planarize", Unit::count, {0, 1000}, "sweeps that make the faces flatter afterwards");
    add_shared_parameters(definition);
    registry.add(definition.keeps_euler()
                     .example("remesh.conway recipe=tkt planarize=100")
                     .cites("Conway, Burgiel & Goodman-Strauss 2008, ch. 21; Hart 1998")
                     .run([operators](Scene& scene, const P& p, Context& context) { run_recipe(*operators, scene, p, context); }));
}

} // namespace druse
