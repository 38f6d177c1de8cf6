// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/part_sets.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"
#include "blend/Field_morph.h"
#include "blend/pair_boxes.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

struct Part_set
{
  std::array<std::vector<std::size_t>, 2> parts; ///< by end, in order
  Blend_obstacle reason = Blend_obstacle::NONE;  ///< why there is no map
  std::shared_ptr<const Field_morph> morph;      ///< once it is made, if it holds together
};

void insert(std::vector<std::size_t>& numbers, std::size_t number)
{
  const auto at = std::lower_bound(numbers.begin(), numbers.end(), number);
  if (at == numbers.end() || *at != number) numbers.insert(at, number);
}

Blend_task task_of(const Part_set& set)
{
  Blend_task result;
  const auto& [sources, targets] = set.parts;
  result.source = sources[0];
  result.target = targets[0];
  result.other_sources.assign(sources.begin() + 1, sources.end());
  result.other_targets.assign(targets.begin() + 1, targets.end());
  result.obstacle = set.reason;
  result.type = sources.size() == targets.size()  ? Blend_task_type::MORPH
                : sources.size() < targets.size() ? Blend_task_type::SPLIT
                                                  : Blend_task_type::MERGE;
  return result;
}

/// The set of the mirror images of all parts, if there is one.
std::size_t image_of(const Blend_stage& stage, const std::vector<Part_set>& sets, std::size_t number)
{
  std::array<std::vector<std::size_t>, 2> images;
  for (std::size_t end : {0u, 1u})
    for (std::size_t part : sets[number].parts[end]) {
      const std::size_t image = stage.images[end][part];
      if (image == Mirror_images::none) return Blend_task::no_part;
      insert(images[end], image);
    }
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Part_set& set) { return set.parts == images; });
  return found == sets.end() ? Blend_task::no_part : std::size_t(found - sets.begin());
}

Part_mesh mesh_of(const Blend_stage& stage, const Part_set& set, std::size_t end, bool in_mirror)
{
  Part_mesh result;
  for (std::size_t part : set.parts[end])
    append(result, stage.meshes[end][part]);
  if (in_mirror) result.points = mirrored(std::move(result.points));
  return result;
}

/// None if it does not hold together. In upright boxes; of two parts whose surfaces would be torn, in boxes that turn
/// with them.
std::shared_ptr<const Field_morph> morph_of(const Blend_stage& stage, const Part_set& set, bool in_mirror)
{
  const Part_mesh source = mesh_of(stage, set, 0, in_mirror), target = mesh_of(stage, set, 1, in_mirror);
  const std::array<const Points*, 2> surfaces = {&source.points, &target.points};
  const bool swaps = set.reason == Blend_obstacle::TORN && set.parts[0].size() == 1 && set.parts[1].size() == 1;
  const bool turns = swaps && stage.images[0][set.parts[0][0]] != set.parts[0][0];
  const auto axes = [&](std::size_t end) -> Eigen::Matrix3d {
    const Eigen::Matrix3d own = stage.charted[end].charts[set.parts[end][0]].axes();
    if (!in_mirror) return own;
    const Point flip(-1, 1, 1);
    Eigen::Matrix3d result = flip.asDiagonal() * own;
    result.col(2) *= -1;
    return result;
  };
  const Pair_charts boxes = turns ? pair_boxes(surfaces, {axes(0), axes(1)}) : upright_boxes(surfaces);
  if (are_unlike(stage, boxes)) return nullptr;
  auto result = std::make_shared<const Field_morph>(boxes, source, target);
  return result->holds_together() || swaps ? result : nullptr;
}

std::vector<Part_set> connected_sets(const Blend_stage& stage, const Part_pairs& pairs, const Torn_pairs& torn)
{
  const std::size_t sources = stage.meshes[0].size();
  Disjoint_sets sets(sources + stage.meshes[1].size());
  for (const auto& [s, t] : pairs)
    sets.unite(s, sources + t);
  std::map<std::size_t, Part_set> by_number;
  for (const auto& pair : pairs) {
    Part_set& set = by_number[sets[pair.first]];
    insert(set.parts[0], pair.first);
    insert(set.parts[1], pair.second);
    if (set.reason == Blend_obstacle::NONE)
      set.reason = torn.count(pair) == 0 ? Blend_obstacle::UNLIKE : Blend_obstacle::TORN;
  }
  std::vector<Part_set> result;
  for (auto& [number, set] : by_number)
    result.push_back(std::move(set));
  return result;
}

/// Makes the morphs of sets, and takes out those that do not hold together, mirror images together.
void make_morphs(const Blend_stage& stage, std::vector<Part_set>& sets)
{
  std::vector<std::size_t> images;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    images.push_back(image_of(stage, sets, i));
    sets[i].morph = morph_of(stage, sets[i], images[i] < i);
  }
  std::vector<Part_set> holding;
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (sets[i].morph && (images[i] == Blend_task::no_part || sets[images[i]].morph)) holding.push_back(sets[i]);
  sets = std::move(holding);
}

} // namespace

std::vector<Blend_part> part_sets(const Blend_stage& stage, const Part_pairs& pairs, const Torn_pairs& torn)
{
  std::vector<Part_set> sets = connected_sets(stage, pairs, torn);
  make_morphs(stage, sets);
  std::vector<Blend_part> result;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    Blend_part part;
    part.task = task_of(sets[i]);
    part.name = stage.charted[0].parts[part.task.source]->name + '~' + stage.charted[1].parts[part.task.target]->name;
    part.image = image_of(stage, sets, i);
    part.is_reflected = part.image < i;
    part.morph = sets[i].morph;
    part.set_ends();
    result.push_back(std::move(part));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
