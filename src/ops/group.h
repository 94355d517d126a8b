#pragma once

#include "ops/parameter.h"
#include "ops/scene.h"

#include <vector>

namespace druse {

/// The ids that faces carry, ascending; 0 only if asked for.
std::vector<int> existing_groups(const Mesh& mesh, bool with_ungrouped = false);

/// Ids as a command names them, ascending and without repeats; `all` stands for every group there is, without 0.
/// @throws CommandError `no face has group 9`
std::vector<int> resolve_groups(const Mesh& mesh, const OrWord<std::vector<int>>& ids);

/// The first of `count` ids above all in use. @throws CommandError where they would pass the largest integer
int first_new_group(const Mesh& mesh, std::size_t count);

enum class SplitBy { components, sides, normal };
/// Splits groups into pieces: faces that hang together across edges inside the group, have as many sides, or look the same way
/// within `angle` degrees of a piece's first face. The first piece keeps the id; the others get new ones, group by group, pieces
/// by their lowest face.
void split_groups(Mesh& mesh, const std::vector<int>& ids, SplitBy by, double angle);

/// Groups all faces anew with ids start, start + 1, …
void group_by_sides(Mesh& mesh, int start);    // ascending numbers of sides
void group_by_area(Mesh& mesh, int start);     // ascending areas, equal within a millionth
void group_by_component(Mesh& mesh, int start);
void group_by_normal(Mesh& mesh, double angle, int start); // degrees from the first face of the group
/// By the colours that the faces show: a face joins the first group whose colour differs by at most `tolerance` in each channel.
/// The groups take their colours along.
void group_by_colour(Scene& scene, int tolerance, int start);

/// Ids 1 … K by lowest face; colours and names travel along. Ungrouped faces stay so.
void renumber_groups(Scene& scene);

} // namespace druse
