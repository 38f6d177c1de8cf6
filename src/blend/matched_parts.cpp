// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/Map_morph.h"
#include "blend/leftover_pairs.h"
#include "blend/pair_boxes.h"
#include "blend/part_sets.h"
#include "blend/unlike_pairs.h"
#include "map/piece_of.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr std::size_t none = Blend_task::no_part;

/// Whether, and why, a map does not do: the surface is torn, turned over or far thinner on the way, or another one
/// where the one takes over from the other.
Blend_obstacle fault_of(const Map_morph& morph)
{
  constexpr double most_torn = 2 * Shape_blend::torn_tolerance; // of a part by itself
  constexpr double most_area = 1.3;    // of either surface over the other, where both are to be the same
  constexpr double most_turned = 0.12; // of either surface
  std::vector<Rest_surface> rests;
  for (int end : {0, 1})
    rests.emplace_back(morph.points(end, end), morph.triangles(end));
  const double change = morph.changes()[0];
  std::vector<std::pair<int, double>> samples = {{0, change}, {1, change}};
  for (double t : {0.25, 0.5, 0.75})
    if (t != change) samples.emplace_back(morph.surface(t), t);
  double torn = 0, thinning = 0;
  for (const auto& [surface, t] : samples) {
    const Rest_surface& rest = rests[std::size_t(surface)];
    const Points points = morph.points(surface, t);
    const Surface_extent extent = rest.extent(points);
    if (extent.area > 0) torn = std::max(torn, rest.torn_area(points, extent) / extent.area);
    thinning = std::max(thinning, thinning_of(rests[0], rests[1], extent));
  }
  const double before = rests[0].extent(morph.points(0, change)).area;
  const double after = rests[1].extent(morph.points(1, change)).area;
  if (torn > most_torn || std::max(before, after) > most_area * std::min(before, after) ||
      std::max(morph.turned_share(0), morph.turned_share(1)) > most_turned)
    return Blend_obstacle::TORN;
  return thinning > Shape_blend::thinning_tolerance ? Blend_obstacle::THIN : Blend_obstacle::NONE;
}

/// Makes the parts of a blend from pairs of pieces.
class Matched_part_maker
{
public:
  /// \param paired parts, those of mirror images, too
  Matched_part_maker(const Blend_stage& stage, const Part_pairs& paired)
      : stage_(stage), pairs_(piece_pairs(stage.charted[0], stage.charted[1], paired))
  {
    find_images(paired);
    find_uses();
    turn_own_images();
  }

  /// \param torn gets the pairs that have no map; their parts have no morph
  std::vector<Blend_part> parts(Torn_pairs& torn) const
  {
    std::vector<Making> makings;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      makings.push_back(making(i, images_[i] < i ? &makings[images_[i]] : nullptr));
    std::vector<Blend_part> result;
    for (Making& making : makings) {
      const Blend_task& task = making.part.task;
      if (task.obstacle != Blend_obstacle::NONE) torn.emplace(std::pair(task.source, task.target), task.obstacle);
      result.push_back(std::move(making.part));
    }
    return result;
  }

private:
  /// What the pairs that a part is in have in common.
  struct Use
  {
    int count = 0;
    bool all_have_images = true;
  };

  void find_images(const Part_pairs& paired)
  {
    for (const auto& [s, t] : paired) {
      const std::pair<std::size_t, std::size_t> image = {stage_.images[0][s], stage_.images[1][t]};
      const auto found = std::lower_bound(paired.begin(), paired.end(), image);
      const bool is_paired = found != paired.end() && *found == image;
      images_.push_back(is_paired ? std::size_t(found - paired.begin()) : none);
    }
  }

  void find_uses()
  {
    for (std::size_t end : {0u, 1u})
      uses_[end].resize(stage_.meshes[end].size());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (Use* use : {&uses_[0][pairs_[i].source], &uses_[1][pairs_[i].target]}) {
        ++use->count;
        use->all_have_images = use->all_have_images && images_[i] != none;
      }
  }

  /// Turns pairs that are their own mirror images so that they stay that, or makes them upright.
  void turn_own_images()
  {
    is_upright_.resize(pairs_.size(), 0);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (images_[i] != i) continue;
      const std::optional<Eigen::Matrix3d> turn = mirrored_turn(pairs_[i], stage_.charted[0], stage_.charted[1]);
      is_upright_[i] = !turn;
      if (turn) pairs_[i].turn = *turn;
    }
  }

  /// Images need pieces that are images, too: all pairs of a part in the mirror or none.
  bool has_images(const Piece_pair& pair) const
  {
    return uses_[0][pair.source].all_have_images && uses_[1][pair.target].all_have_images;
  }

  Blend_task task_of(const Piece_pair& pair) const
  {
    Blend_task task;
    task.source = pair.source;
    task.target = pair.target;
    task.type = uses_[1][pair.target].count > 1   ? Blend_task_type::MERGE
                : uses_[0][pair.source].count > 1 ? Blend_task_type::SPLIT
                                                  : Blend_task_type::MORPH;
    return task;
  }

  /// A part while it is not decided how it becomes its counterpart.
  struct Making
  {
    Blend_part part;
    std::array<Part_mesh, 2> pieces;
    Pair_charts boxes;
    std::vector<Pair_charts> charts; ///< by which it may morph, the better ones first
    std::optional<bool> forward;
    std::shared_ptr<Map_morph> morph;
  };

  /// \param image its mirror image, if it is there, which becomes its counterpart in the same way
  Making making(std::size_t number, const Making* image) const
  {
    const Piece_pair& pair = pairs_[number];
    Making result;
    Blend_part& part = result.part;
    part.name = stage_.charted[0].parts[pair.source]->name + '~' + stage_.charted[1].parts[pair.target]->name;
    part.task = task_of(pair);
    part.image = images_[number];
    part.is_reflected = part.image < number && has_images(pair) && has_images(pairs_[part.image]);
    const std::size_t charted_as = part.is_reflected ? part.image : number;
    const Piece_pair& charted = pairs_[charted_as];
    result.pieces = {piece(0, pair.source, charted.source, charted.source_piece, part.is_reflected),
                     piece(1, pair.target, charted.target, charted.target_piece, part.is_reflected)};
    if (image && image->morph) result.forward = image->morph->is_forward();
    result.boxes = boxes(result, charted_as);
    set_charts(result, charted_as);
    choose_charts(result, image ? image->part.task.obstacle : Blend_obstacle::NONE);
    return result;
  }

  /// Those of the boxes and, unless they turn the part more than boxes do to make up for what boxes stretch more, those
  /// of the parts, along which they may bend.
  void set_charts(Making& making, std::size_t number) const
  {
    constexpr double bending = 0.35; // that own charts may turn more
    making.charts = {making.boxes};
    if (is_upright_[number]) return;
    if (pair_kind(pairs_[number], stage_.charted[0], stage_.charted[1]) == Pair_kind::BOXES) return;
    const Pair_charts own = pair_charts(pairs_[number], stage_.charted[0], stage_.charted[1], making.pieces[0].points,
                                        making.pieces[1].points);
    making.charts.insert(change(own) <= change(making.boxes) + bending ? making.charts.begin() : making.charts.end(),
                         own);
    making.part.needless_turn = std::max(0., turn(making.charts[0]) - turn(making.boxes));
  }

  Pair_charts boxes(const Making& making, std::size_t number) const
  {
    const std::array<const Points*, 2> surfaces = {&making.pieces[0].points, &making.pieces[1].points};
    if (images_[number] == number) return upright_boxes(surfaces);
    const auto [from, to] = piece_charts(pairs_[number], stage_.charted[0], stage_.charted[1]);
    return pair_boxes(surfaces, {from.axes(), to.axes()});
  }

  /// The first charts by which the surface becomes that of the counterpart, if there are any.
  /// \param known why there are none for the mirror image
  static void choose_charts(Making& making, Blend_obstacle known)
  {
    Blend_obstacle& reason = making.part.task.obstacle = known;
    for (std::size_t i = 0; i < making.charts.size() && known == Blend_obstacle::NONE; ++i) {
      making.morph = std::make_shared<Map_morph>(making.charts[i], making.pieces[0], making.pieces[1], making.forward);
      const Blend_obstacle fault = fault_of(*making.morph);
      if (fault == Blend_obstacle::NONE) {
        reason = fault;
        making.part.morph = making.morph;
        making.part.set_ends();
        return;
      }
      if (i == 0) reason = fault;
    }
  }

  /// The piece of a part that a box of a chart cuts out.
  /// \param charted the part whose chart it is
  Part_mesh piece(std::size_t end, std::size_t part, std::size_t charted, const Chart_box& box, bool in_mirror) const
  {
    const Part_mesh& mesh = stage_.meshes[end][part];
    return piece_of(in_mirror ? mirrored(mesh.points) : mesh.points, mesh.triangles,
                    stage_.charted[end].charts[charted], box);
  }

  const Blend_stage& stage_;
  std::vector<Piece_pair> pairs_;
  std::vector<std::size_t> images_;      ///< by pair, its mirror image
  std::vector<char> is_upright_;         ///< by pair
  std::array<std::vector<Use>, 2> uses_; ///< by end and part
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

/// Those of the pairs whose parts are in sets.
Part_pairs pairs_in(const std::vector<Part_set>& sets, const Part_pairs& pairs)
{
  Part_pairs result;
  for (const auto& pair : pairs)
    if (std::any_of(sets.begin(), sets.end(), [&](const Part_set& set) {
          return std::binary_search(set.parts[0].begin(), set.parts[0].end(), pair.first) &&
                 std::binary_search(set.parts[1].begin(), set.parts[1].end(), pair.second);
        }))
      result.push_back(pair);
  return result;
}

} // namespace

std::vector<Blend_part> blend_parts(const Blend_stage& stage, const Correspondence& correspondence)
{
  const Part_pairs all = paired_parts(stage, correspondence);
  Part_set_maker maker(stage);
  Torn_pairs torn;
  for (;;) {
    Part_pairs mapped = all;
    const Part_pairs unlike = take_unlike_pairs(stage, torn, mapped);
    std::vector<Part_set> sets = connected_sets(stage, unlike, torn);
    const std::vector<Part_set> broken = maker.take_broken(sets);
    Part_pairs used = mapped;
    used.insert(used.end(), unlike.begin(), unlike.end());
    const Part_pairs leftover = leftover_pairs(stage, used);
    used.insert(used.end(), leftover.begin(), leftover.end());
    Part_pairs others = most_alike(stage, pairs_in(broken, unlike));
    others.insert(others.end(), leftover.begin(), leftover.end());
    std::vector<Part_set> single;
    for (const auto& pair : others) {
      const auto found = torn.find(pair);
      if (found == torn.end())
        mapped.push_back(pair);
      else
        single.push_back({{{{pair.first}, {pair.second}}}, found->second});
    }
    std::sort(mapped.begin(), mapped.end());
    const std::size_t known = torn.size();
    std::vector<Blend_part> result = Matched_part_maker(stage, mapped).parts(torn);
    if (torn.size() > known) continue;
    maker.take_broken(single);
    sets.insert(sets.end(), single.begin(), single.end());
    maker.add(sets, result);
    const std::size_t matched = result.size();
    std::vector<Part_set> exchanged = connected_sets(stage, leftover_links(stage, used), {});
    maker.take_broken(exchanged);
    maker.add(exchanged, result);
    for (std::size_t i = 0; i < result.size(); ++i) {
      Blend_task& task = result[i].task;
      if (i >= matched || std::binary_search(leftover.begin(), leftover.end(), std::pair(task.source, task.target)))
        task.type = Blend_task_type::EXCHANGE;
      if (i >= matched) task.obstacle = Blend_obstacle::NONE; // there was nothing that they should become
    }
    add_unmatched_parts(stage, unlike, result);
    return result;
  }
}

} // namespace CGAL::Shape_correspondence::internal
