// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/part_sets.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"
#include "blend/pair_boxes.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr std::size_t none = Blend_task::no_part;

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

} // namespace

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
    const auto found = torn.find(pair);
    if (set.reason == Blend_obstacle::NONE) set.reason = found == torn.end() ? Blend_obstacle::UNLIKE : found->second;
  }
  std::vector<Part_set> result;
  for (auto& [number, set] : by_number)
    result.push_back(std::move(set));
  return result;
}

/// The set of the mirror images of all parts, if there is one.
std::size_t Part_set_maker::image_of(const std::vector<Part_set>& sets, std::size_t number) const
{
  std::array<std::vector<std::size_t>, 2> images;
  for (std::size_t end : {0u, 1u})
    for (std::size_t part : sets[number].parts[end]) {
      const std::size_t image = stage_.images[end][part];
      if (image == Mirror_images::none) return none;
      insert(images[end], image);
    }
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Part_set& set) { return set.parts == images; });
  return found == sets.end() ? none : std::size_t(found - sets.begin());
}

Part_mesh Part_set_maker::mesh_of(const Part_set& set, std::size_t end, bool in_mirror) const
{
  Part_mesh result;
  for (std::size_t part : set.parts[end]) {
    const Part_mesh& mesh = stage_.meshes[end][part];
    const Eigen::Index points = result.points.cols(), triangles = result.triangles.cols();
    result.points.conservativeResize(3, points + mesh.points.cols());
    result.points.rightCols(mesh.points.cols()) = mesh.points;
    result.triangles.conservativeResize(3, triangles + mesh.triangles.cols());
    result.triangles.rightCols(mesh.triangles.cols()) = mesh.triangles.array() + int(points);
  }
  if (in_mirror) result.points = mirrored(std::move(result.points));
  return result;
}

/// In upright boxes; of two parts whose surfaces would be torn, in boxes that turn with them.
std::shared_ptr<const Field_morph> Part_set_maker::make_morph(const Part_set& set, bool in_mirror) const
{
  const Part_mesh source = mesh_of(set, 0, in_mirror), target = mesh_of(set, 1, in_mirror);
  const std::array<const Points*, 2> surfaces = {&source.points, &target.points};
  const bool turns = set.reason != Blend_obstacle::UNLIKE && set.parts[0].size() == 1 && set.parts[1].size() == 1 &&
                     stage_.images[0][set.parts[0][0]] != set.parts[0][0];
  const auto axes = [&](std::size_t end) -> Eigen::Matrix3d {
    const Eigen::Matrix3d own = stage_.charted[end].charts[set.parts[end][0]].axes();
    if (!in_mirror) return own;
    const Point flip(-1, 1, 1);
    Eigen::Matrix3d result = flip.asDiagonal() * own;
    result.col(2) *= -1;
    return result;
  };
  const Pair_charts boxes = turns ? pair_boxes(surfaces, {axes(0), axes(1)}) : upright_boxes(surfaces);
  if (are_unlike(stage_, boxes)) return nullptr;
  auto result = std::make_shared<const Field_morph>(boxes, source, target);
  const bool swaps = set.reason != Blend_obstacle::UNLIKE && set.parts[0].size() == 1 && set.parts[1].size() == 1;
  return result->holds_together() || swaps ? result : nullptr;
}

std::shared_ptr<const Field_morph> Part_set_maker::morph_of(const Part_set& set, bool in_mirror)
{
  const Key key(set.parts, in_mirror);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  return known_[key] = make_morph(set, in_mirror);
}

std::vector<Part_set> Part_set_maker::take_broken(std::vector<Part_set>& sets)
{
  const auto holds = [&](std::size_t i) { return bool(morph_of(sets[i], image_of(sets, i) < i)); };
  std::vector<Part_set> holding, broken;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::size_t image = image_of(sets, i);
    (holds(i) && (image == none || holds(image)) ? holding : broken).push_back(sets[i]);
  }
  sets = std::move(holding);
  return broken;
}

void Part_set_maker::add(const std::vector<Part_set>& sets, std::vector<Blend_part>& parts)
{
  const std::size_t first = parts.size();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::size_t image = image_of(sets, i);
    Blend_part part;
    part.task = task_of(sets[i]);
    part.name = stage_.charted[0].parts[part.task.source]->name + '~' + stage_.charted[1].parts[part.task.target]->name;
    part.is_reflected = image < i;
    part.image = image == none ? none : first + image;
    part.morph = morph_of(sets[i], part.is_reflected);
    part.set_ends();
    parts.push_back(std::move(part));
  }
}

} // namespace CGAL::Shape_correspondence::internal
