// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/Map_morph.h"
#include "blend/mirror_images.h"
#include "blend/pair_boxes.h"
#include "blend/part_sets.h"
#include "blend/unlike_pairs.h"
#include "map/piece_of.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether a map does not do: the surface is torn or turned over on the way.
bool is_torn(const Map_morph& morph)
{
  constexpr double most_torn = 2 * Shape_blend::torn_tolerance; // of a part by itself
  constexpr double most_turned = 0.12;                          // of either surface
  if (std::max(morph.turned_share(0), morph.turned_share(1)) > most_turned) return true;
  const double change = morph.changes()[0];
  for (int surface : {0, 1}) {
    const Rest_surface rest(morph.points(surface, surface), morph.triangles(surface));
    for (double t : {0.25, 0.5, 0.75, change}) {
      if (t != change && morph.surface(t) != surface) continue;
      const Points points = morph.points(surface, t);
      const Surface_extent extent = rest.extent(points);
      if (rest.torn_area(points, extent) > most_torn * extent.area) return true;
    }
  }
  return false;
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
  }

  /// \param torn gets the pairs that have no map; their parts have no morph
  std::vector<Blend_part> parts(Torn_pairs& torn) const
  {
    std::vector<Blend_part> result;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      Blend_part made = part(i, images_[i] < i ? &result[images_[i]] : nullptr);
      if (!made.morph) torn.emplace(made.task.source, made.task.target);
      result.push_back(std::move(made));
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
      images_.push_back(is_paired ? std::size_t(found - paired.begin()) : Blend_task::no_part);
    }
  }

  void find_uses()
  {
    for (std::size_t end : {0u, 1u})
      uses_[end].resize(stage_.meshes[end].size());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (Use* use : {&uses_[0][pairs_[i].source], &uses_[1][pairs_[i].target]}) {
        ++use->count;
        use->all_have_images = use->all_have_images && images_[i] != Blend_task::no_part;
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

  /// \param image its mirror image, if that is there: what has no map has none for its image either
  Blend_part part(std::size_t number, const Blend_part* image) const
  {
    const Piece_pair& pair = pairs_[number];
    Blend_part result;
    result.name = stage_.charted[0].parts[pair.source]->name + '~' + stage_.charted[1].parts[pair.target]->name;
    result.task = task_of(pair);
    result.image = images_[number];
    result.is_reflected = result.image < number && has_images(pair) && has_images(pairs_[result.image]);
    if (image && !image->morph) return result;
    const std::size_t charted_as = result.is_reflected ? result.image : number;
    const Piece_pair& charted = pairs_[charted_as];
    const Part_mesh source = piece(0, pair.source, charted.source, charted.source_piece, result.is_reflected);
    const Part_mesh target = piece(1, pair.target, charted.target, charted.target_piece, result.is_reflected);
    const std::vector<Pair_charts> all = charts(charted_as, source.points, target.points);
    for (const Pair_charts& charts : all) {
      const auto morph = std::make_shared<const Map_morph>(charts, source, target);
      if (is_torn(*morph)) continue;
      result.morph = morph;
      result.needless_turn = turn(charts) - std::min(turn(all.front()), turn(all.back()));
      result.set_ends();
      break;
    }
    return result;
  }

  /// Charts by which a pair may morph, the better ones first: those of the boxes and those of the parts, along which
  /// they may bend: first, unless they turn the part more than boxes do to make up for what boxes stretch more. What is
  /// its own mirror image stays that by boxes.
  std::vector<Pair_charts> charts(std::size_t number, const Points& source, const Points& target) const
  {
    constexpr double bending = 0.35; // that own charts may turn more
    const std::array<const Points*, 2> surfaces = {&source, &target};
    const Piece_pair& pair = pairs_[number];
    const auto [from, to] = piece_charts(pair, stage_.charted[0], stage_.charted[1]);
    const Pair_charts boxes = pair_boxes(surfaces, {from.axes(), to.axes()});
    if (images_[number] == number) return {boxes};
    const Pair_charts own = pair_charts(pair, stage_.charted[0], stage_.charted[1], source, target);
    if (change(own) <= change(boxes) + bending) return {own, boxes};
    return {boxes, own};
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

/// The parts that pairs become by maps, but for those of which there is none.
std::vector<Blend_part> mapped_parts(const Blend_stage& stage, Part_pairs pairs)
{
  for (;;) {
    Torn_pairs torn;
    std::vector<Blend_part> result = Matched_part_maker(stage, pairs).parts(torn);
    if (torn.empty()) return result;
    const auto is_torn = [&](const auto& pair) { return torn.count(pair) > 0; };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_torn), pairs.end());
  }
}

/// Adds parts with their images.
void add_parts(std::vector<Blend_part> more, std::vector<Blend_part>& parts)
{
  const std::size_t first = parts.size();
  for (Blend_part& part : more) {
    if (part.has_image()) part.image += first;
    parts.push_back(std::move(part));
  }
}

} // namespace

std::vector<Blend_part> matched_parts(const Blend_stage& stage, const Correspondence& correspondence,
                                      Part_pairs& unlike)
{
  const Part_pairs given = paired_parts(stage, correspondence);
  Torn_pairs torn;
  std::size_t known;
  std::vector<Blend_part> result;
  do { // with a pair that is torn go all others of its parts
    known = torn.size();
    Part_pairs mapped = given;
    unlike = take_unlike_pairs(stage, torn, mapped);
    result = Matched_part_maker(stage, mapped).parts(torn);
  } while (torn.size() > known);
  add_parts(part_sets(stage, unlike, torn), result);
  std::vector<Blend_part> exchanged = mapped_parts(stage, leftover_pairs(stage, result));
  for (Blend_part& part : exchanged)
    part.task.type = Blend_task_type::EXCHANGE;
  add_parts(std::move(exchanged), result);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
