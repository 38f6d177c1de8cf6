// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/mirror_images.h"
#include "blend/pair_boxes.h"
#include "blend/unlike_pairs.h"
#include "map/piece_of.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether a map does not do: the surfaces are not alike, or one is torn or turned over on the way.
bool is_torn(const Part_morph& morph)
{
  constexpr double most_torn = 2 * Shape_blend::torn_tolerance; // of a part by itself
  constexpr double most_turned = 0.12;                          // of either surface
  constexpr double most_jump = 0.08;                            // where the second surface takes over
  constexpr double most_misfit_of_open = 0.1;                   // as both sides and the rims of these are seen
  if (std::max(morph.turned_share(0), morph.turned_share(1)) > most_turned) return true;
  bool are_closed = true;
  for (int surface : {0, 1}) {
    const Rest_surface rest(morph.points(surface, surface), morph.triangles(surface));
    are_closed = are_closed && rest.is_closed();
    for (double t : {0.25, 0.5, 0.75, Part_morph::change}) {
      if (t != Part_morph::change && morph.surface(t) != surface) continue;
      const Points points = morph.points(surface, t);
      const Surface_extent extent = rest.extent(points);
      if (rest.torn_area(points, extent) > most_torn * extent.area) return true;
    }
  }
  return (!are_closed && morph.misfit(false) > most_misfit_of_open) || morph.misfit(true) > most_jump;
}

/// Makes the parts of a blend from pairs of parts.
class Matched_part_maker
{
public:
  /// \param paired parts, those of mirror images, too
  /// \param given those that correspond
  Matched_part_maker(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& given)
      : stage_(stage), given_(given), pairs_(piece_pairs(stage.charted[0], stage.charted[1], paired))
  {
    for (std::size_t end : {0u, 1u})
      uses_[end].resize(stage.meshes[end].size(), 0);
    for (const auto& [s, t] : paired) {
      ++uses_[0][s];
      ++uses_[1][t];
    }
  }

  /// \param torn gets the pairs that have no map, with their mirror images, which become no parts
  std::vector<Blend_part> parts(Pair_set& torn) const
  {
    std::vector<Blend_part> result;
    for (const Piece_pair& pair : pairs_) {
      result.push_back(part(pair));
      if (result.back().morph) continue;
      Part_pairs both = {{pair.source, pair.target}};
      add_mirrored(both, stage_.images[0], stage_.images[1]);
      torn.insert(both.begin(), both.end());
    }
    return result;
  }

private:
  Blend_task task_of(const Piece_pair& pair) const
  {
    Blend_task task;
    task.source = pair.source;
    task.target = pair.target;
    const bool corresponds = std::binary_search(given_.begin(), given_.end(), std::pair(pair.source, pair.target));
    task.type = !corresponds                ? Blend_task_type::EXCHANGE
                : uses_[1][pair.target] > 1 ? Blend_task_type::MERGE
                : uses_[0][pair.source] > 1 ? Blend_task_type::SPLIT
                                            : Blend_task_type::MORPH;
    return task;
  }

  Blend_part part(const Piece_pair& pair) const
  {
    Blend_part result;
    result.name = stage_.charted[0].parts[pair.source]->name + '~' + stage_.charted[1].parts[pair.target]->name;
    result.task = task_of(pair);
    const Part_chart &from = stage_.charted[0].charts[pair.source], &to = stage_.charted[1].charts[pair.target];
    const Part_mesh &source = stage_.meshes[0][pair.source], &target = stage_.meshes[1][pair.target];
    const Part_mesh first = piece_of(source.points, source.triangles, from, pair.source_piece);
    const Part_mesh second = piece_of(target.points, target.triangles, to, pair.target_piece);
    const Pair_charts boxes = pair_boxes({&first.points, &second.points}, {from.axes(), to.axes()});
    const auto morph = std::make_shared<const Part_morph>(boxes, first, second);
    if (is_torn(*morph)) return result;
    result.morph = morph;
    result.needless_turn = needless_turn(boxes);
    result.set_ends();
    return result;
  }

  const Blend_stage& stage_;
  const Part_pairs& given_;
  std::vector<Piece_pair> pairs_;
  std::array<std::vector<int>, 2> uses_; ///< by end and part, the number of its pairs
};

/// All pairs of parts, with those of mirror images.
Part_pairs paired_parts(const Blend_stage& stage, const Correspondence& correspondence)
{
  Part_pairs result = part_pairs(correspondence.pairs);
  add_mirrored(result, stage.images[0], stage.images[1]);
  result = matched_members(stage.charted[0], stage.charted[1], result);
  add_mirrored(result, stage.images[0], stage.images[1]);
  return result;
}

Blend_obstacle obstacle_of(int end, std::size_t given, const Unlike_pairs& unlike)
{
  Blend_obstacle result = Blend_obstacle::NONE;
  for (const auto& pair : unlike.all) {
    if ((end == 0 ? pair.first : pair.second) != given) continue;
    if (unlike.torn.count(pair) > 0) return Blend_obstacle::TORN;
    result = Blend_obstacle::UNLIKE;
  }
  return result;
}

Blend_part unmatched_part(const Blend_stage& stage, int end, std::size_t given, const Unlike_pairs& unlike)
{
  const auto e = std::size_t(end);
  Blend_part result;
  const std::string& name = structure(stage.graphs[e]).parts[given].name;
  result.name = end == 0 ? name + '~' : '~' + name;
  result.task.type = end == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
  result.task.obstacle = obstacle_of(end, given, unlike);
  (end == 0 ? result.task.source : result.task.target) = given;
  result.mesh = stage.meshes[e][given];
  result.set_ends();
  return result;
}

} // namespace

std::vector<Blend_part> unmatched_parts(const Blend_stage& stage, const Unlike_pairs& unlike,
                                        const std::vector<Blend_part>& matched)
{
  std::vector<Blend_part> result;
  for (int end : {0, 1})
    for (std::size_t part = 0; part < stage.meshes[std::size_t(end)].size(); ++part)
      if (parts_of(matched, end, part).empty()) result.push_back(unmatched_part(stage, end, part, unlike));
  return result;
}

std::vector<Blend_part> matched_parts(const Blend_stage& stage, const Correspondence& correspondence,
                                      Unlike_pairs& unlike)
{
  const Part_pairs given = paired_parts(stage, correspondence);
  std::vector<Blend_part> result;
  std::size_t known;
  do { // with a pair that is torn go all others of its parts
    known = unlike.torn.size();
    Part_pairs like = given;
    take_unlike_pairs(stage, unlike, like);
    result = Matched_part_maker(stage, with_leftovers(stage, unlike, like), given).parts(unlike.torn);
  } while (unlike.torn.size() > known);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
