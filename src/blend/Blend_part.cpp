// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "base/for_each_index.h"
#include "base/quantized.h"
#include "blend/Blend_stage.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The task of `pair`, which is one of `all`. \param corresponds whether the parts correspond; otherwise they are
/// exchanged
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

/// The charts in which a pair may morph: along each axis of the boxes, along the curves of both parts, and along their
/// own axes.
std::vector<std::vector<Pair_charts>> likely_charts(const Blend_stage& stage, const Piece_pair& pair,
                                                    const Part_mesh& source, const Part_mesh& target)
{
  constexpr double any = 10; // ratio of volumes (`pair_boxes()`), so large that own axes are always taken
  const auto& [from, to] = stage.charted;
  const std::array<Eigen::Matrix3d, 2> own = {from.charts[pair.source].axes(), to.charts[pair.target].axes()};
  std::vector<std::vector<Pair_charts>> result;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(), next;
  next << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const auto add_axes = [&](const Pair_charts& boxes) {
    result.emplace_back();
    for (int axis = 0; axis < 3; ++axis, turn *= next)
      result.back().push_back({Part_chart::box(source.points, boxes.source.axes() * turn),
                               Part_chart::box(target.points, boxes.target.axes() * turn)});
  };
  const Pair_charts boxes = pair_boxes({&source.points, &target.points}, own),
                    own_boxes = pair_boxes({&source.points, &target.points}, own, any);
  add_axes(boxes);
  const bool are_curves = !from.charts[pair.source].is_sheet() && !to.charts[pair.target].is_sheet();
  if (are_curves && pair_kind(pair, from, to) == Pair_kind::SAME)
    result.push_back({pair_charts(pair, from, to, source.points, target.points)});
  const auto are_same = [](const Part_chart& a, const Part_chart& b) {
    return (a.axes().transpose() * b.axes()).cwiseAbs().isIdentity(1e-6);
  };
  if (!are_same(boxes.source, own_boxes.source) || !are_same(boxes.target, own_boxes.target)) add_axes(own_boxes);
  return result;
}

/// The part of the blend for a pair of parts or pieces; without a morph if none between them is faithful.
Blend_part matched_part(const Blend_stage& stage, const Piece_pair& pair)
{
  const auto& [from, to] = stage.charted;
  const Part_chart &source_chart = from.charts[pair.source], &target_chart = to.charts[pair.target];
  const Part_mesh source = piece_of(stage.meshes[0][pair.source], source_chart, pair.source_piece),
                  target = piece_of(stage.meshes[1][pair.target], target_chart, pair.target_piece);
  Blend_part result;
  result.name = from.parts[pair.source]->name + '~' + to.parts[pair.target]->name;
  result.morph = best_morph(likely_charts(stage, pair, source, target), source, target);
  const Difference difference(stage, piece_charts(pair, from, to), is_whole(pair));
  if (!difference.is_little()) result.change = difference.change + difference.way;
  if (result.morph) result.set_ends();
  return result;
}

/// The surface of a matched part at some time.
contacts::Triangle_tree tree_at(const Blend_part& part, double t)
{
  const int surface = part.morph->surface(t);
  const Points points = part.points(surface, t);
  contacts::Triangle_tree result = part.trees[std::size_t(surface)];
  result.move([&](std::size_t i) { return triangle_of(points, part.triangles(surface), Eigen::Index(i)); });
  return result;
}

/// The pairs of matched parts that touch at an end; in each pair, the part that changes more comes first.
std::set<std::array<std::size_t, 2>> contacts_at(int end, const Blend_stage& stage,
                                                 const std::vector<Blend_part>& parts)
{
  std::set<std::array<std::size_t, 2>> result;
  for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts)
    for (std::size_t i : parts_of(parts, end, contact.parts[0]))
      for (std::size_t j : parts_of(parts, end, contact.parts[1]))
        result.insert(quantized(parts[i].change) >= quantized(parts[j].change) ? std::array{i, j} : std::array{j, i});
  return result;
}

/// The pairs of source and target part whose morph changes more than little and, during the blend, comes off a part
/// that touches it at an end and changes less. Two parts may separate if they are apart at the other end, and if each
/// touches some other part at both ends.
Part_pairs detached(const Blend_stage& stage, const std::vector<Blend_part>& parts)
{
  constexpr double widest = 0.05; // widest gap of parts that count as in contact, over the height
  const auto come_off = [&](std::size_t a, std::size_t b) {
    for (double t : {0.25, 0.5, 0.75})
      if (!tree_at(parts[a], t).is_within(tree_at(parts[b], t), widest * widest)) return true;
    return false;
  };
  const std::array contacts = {contacts_at(0, stage, parts), contacts_at(1, stage, parts)};
  std::set<std::size_t> held; // parts in contact with the same matched part at both ends
  for (const auto& contact : contacts[0])
    if (contacts[1].count(contact) > 0) held.insert(contact.begin(), contact.end());
  Part_pairs result;
  for (std::size_t end : {0u, 1u})
    for (const auto& contact : contacts[end]) {
      const auto& [more, other] = contact;
      const bool may_part = contacts[1 - end].count(contact) == 0 && held.count(more) > 0 && held.count(other) > 0;
      if (parts[more].change > 0 && !may_part && come_off(more, other))
        result.emplace_back(parts[more].task.source, parts[more].task.target);
    }
  return result;
}

/// Adds the given pairs between the symmetry groups of each torn pair, since like parts change alike.
void add_symmetric(const Blend_stage& stage, const Part_pairs& given, Part_pairs& torn)
{
  const std::array groups = {group_of_parts(stage.graphs[0]), group_of_parts(stage.graphs[1])};
  const auto groups_of = [&](const auto& pair) { return std::pair(groups[0][pair.first], groups[1][pair.second]); };
  std::set<Part_pairs::value_type> torn_groups;
  for (const auto& pair : torn)
    torn_groups.insert(groups_of(pair));
  std::copy_if(given.begin(), given.end(), std::back_inserter(torn),
               [&](const auto& pair) { return torn_groups.count(groups_of(pair)) > 0; });
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
    const bool is_torn = !torn.empty();
    if (!is_torn) torn = detached(stage, result);
    if (torn.empty()) return result;
    stage.add_mirrored(torn);
    add_symmetric(stage, given, torn);
    if (!is_torn) unlike.detached.insert(torn.begin(), torn.end());
    unlike.torn.insert(torn.begin(), torn.end()); // like_pairs() then drops all other pairs of their parts
  }
}

Blend_obstacle obstacle_of(std::size_t end, std::size_t given, const Unlike_pairs& unlike)
{
  Blend_obstacle result = Blend_obstacle::NONE;
  for (const auto& pair : unlike.all) {
    if ((end == 0 ? pair.first : pair.second) != given) continue;
    if (unlike.torn.count(pair) > unlike.detached.count(pair)) return Blend_obstacle::TORN;
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
