// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "base/for_each_index.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether a map is unusable: the surfaces do not coincide closely enough, or one is torn on the way.
bool is_torn(const Part_morph& morph)
{
  constexpr double most_torn = 0.04;          // share of the surface's area
  constexpr double most_jump = 0.08;          // misfit at the change from one surface to the other
  constexpr double most_misfit_of_open = 0.1; // misfit of surfaces with borders, where gaps are visible
  bool are_closed = true;
  for (int surface : {0, 1}) {
    const Rest_surface rest(morph.points(surface, surface), morph.triangles(surface));
    // At the change the surface differs most from its rest shape
    const Points points = morph.points(surface, Part_morph::change);
    if (rest.torn_area(points) > most_torn * rest.area(points)) return true;
    are_closed = are_closed && rest.is_closed();
  }
  return (!are_closed && morph.misfit(false) > most_misfit_of_open) || morph.misfit(true) > most_jump;
}

/// The task of one of the pairs. \param corresponds whether the parts correspond; otherwise they are exchanged
Blend_task task_of(const Piece_pair& pair, const std::vector<Piece_pair>& all, bool corresponds)
{
  const auto uses = [&](std::size_t Piece_pair::*part) {
    return std::count_if(all.begin(), all.end(), [&](const Piece_pair& other) { return other.*part == pair.*part; });
  };
  const Blend_task_type type = !corresponds                    ? Blend_task_type::EXCHANGE
                               : uses(&Piece_pair::target) > 1 ? Blend_task_type::MERGE
                               : uses(&Piece_pair::source) > 1 ? Blend_task_type::SPLIT
                                                               : Blend_task_type::MORPH;
  return {type, pair.source, pair.target};
}

/// The part for a pair; without a morph if there is no map between its surfaces or pieces of them.
Blend_part matched_part(const Blend_stage& stage, const Piece_pair& pair)
{
  Blend_part result;
  result.name = stage.charted[0].parts[pair.source]->name + '~' + stage.charted[1].parts[pair.target]->name;
  const Part_chart &from = stage.charted[0].charts[pair.source], &to = stage.charted[1].charts[pair.target];
  const Part_mesh source = piece_of(stage.meshes[0][pair.source], from, pair.source_piece);
  const Part_mesh target = piece_of(stage.meshes[1][pair.target], to, pair.target_piece);
  const Pair_charts boxes = pair_boxes({&source.points, &target.points}, {from.axes(), to.axes()});
  const auto morph = std::make_shared<const Part_morph>(boxes, source, target);
  if (is_torn(*morph)) return result;
  result.morph = morph;
  result.set_ends();
  return result;
}

std::vector<Blend_part> matched_parts(const Blend_stage& stage, const Correspondence& correspondence,
                                      Unlike_pairs& unlike)
{
  const auto& [source, target] = stage.charted;
  Part_pairs given = part_pairs(correspondence.pairs);
  stage.add_mirrored(given);
  given = matched_members(source, target, given);
  stage.add_mirrored(given);
  while (true) {
    const std::vector<Piece_pair> pairs = piece_pairs(source, target, like_pairs(stage, given, unlike));
    Part_pairs torn;
    std::vector<Blend_part> result(pairs.size());
    for_each_index<CGAL::Parallel_if_available_tag>(pairs.size(),
                                                    [&](std::size_t i) { result[i] = matched_part(stage, pairs[i]); });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::pair parts(pairs[i].source, pairs[i].target);
      result[i].task = task_of(pairs[i], pairs, std::binary_search(given.begin(), given.end(), parts));
      if (!result[i].is_matched()) torn.push_back(parts);
    }
    if (torn.empty()) return result;
    stage.add_mirrored(torn);
    unlike.torn.insert(torn.begin(), torn.end()); // like_pairs() then drops all other pairs of their parts
  }
}

Blend_obstacle obstacle_of(std::size_t end, std::size_t given, const Unlike_pairs& unlike)
{
  Blend_obstacle result = Blend_obstacle::NONE;
  for (const auto& pair : unlike.all) {
    if ((end == 0 ? pair.first : pair.second) != given) continue;
    if (unlike.torn.count(pair) > 0) return Blend_obstacle::TORN;
    result = Blend_obstacle::UNLIKE;
  }
  return result;
}

Blend_part unmatched_part(const Blend_stage& stage, std::size_t end, std::size_t given, const Unlike_pairs& unlike)
{
  Blend_part result;
  const std::string& name = stage.charted[end].parts[given]->name;
  result.name = end == 0 ? name + '~' : '~' + name;
  result.task.type = end == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
  result.task.obstacle = obstacle_of(end, given, unlike);
  (end == 0 ? result.task.source : result.task.target) = given;
  result.mesh = stage.meshes[end][given];
  result.set_ends();
  return result;
}

} // namespace

void Blend_part::set_ends()
{
  for (int surface = 0; surface < number_of_surfaces(); ++surface) {
    const Points at_end = points(surface, surface);
    trees.push_back(tree_of(at_end, triangles(surface)));
    rests.emplace_back(at_end, triangles(surface));
    size = std::max(size, trees.back().box().diagonal().norm());
  }
}

std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].given(end) == given) result.push_back(i);
  return result;
}

std::vector<Blend_part> blend_parts(const Blend_stage& stage, const Correspondence& correspondence, Part_pairs& unlike)
{
  Unlike_pairs found;
  std::vector<Blend_part> result = matched_parts(stage, correspondence, found);
  for (std::size_t end : {0u, 1u})
    for (std::size_t part = 0; part < stage.meshes[end].size(); ++part)
      if (parts_of(result, int(end), part).empty()) result.push_back(unmatched_part(stage, end, part, found));
  unlike = std::move(found.all);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
