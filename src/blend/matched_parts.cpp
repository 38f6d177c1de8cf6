// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_ends.h"
#include "blend/Blend_part.h"
#include "blend/exchange_reason.h"
#include "map/piece_of.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr std::size_t none = Blend_task::no_part;

/// Makes the parts of a blend from pairs of pieces.
class Matched_part_maker
{
public:
  Matched_part_maker(const Blend_ends& ends, const Correspondence& correspondence) : ends_(ends)
  {
    Part_pairs paired = part_pairs(correspondence.pairs);
    add_mirrored(paired, ends.images[0], ends.images[1]);
    paired = matched_members(ends.charted[0], ends.charted[1], paired);
    add_mirrored(paired, ends.images[0], ends.images[1]);
    leave_rings_out(paired);
    pairs_ = piece_pairs(ends.charted[0], ends.charted[1], paired);
    find_images(paired);
    find_uses();
    turn_own_images();
  }

  std::vector<Blend_part> parts() const
  {
    std::vector<Blend_part> result;
    std::vector<std::shared_ptr<Part_morph>> morphs;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      result.push_back(part(i, images_[i] < i ? &result[images_[i]] : nullptr, morphs));
    const std::vector<Blend_exchange> reasons = exchanges(result);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i].task.exchange = reasons[i];
      if (reasons[i] == Blend_exchange::NONE) continue;
      morphs[i]->exchange();
      if (surface_fault(result[i]).torn_share > Shape_blend::torn_tolerance) morphs[i]->exchange_in_boxes();
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

  /// Takes out pairs of a closed curve and what is none, if either becomes something of its own kind as well: the hole
  /// would be torn open. The ring shrinks or grows instead.
  void leave_rings_out(Part_pairs& paired) const
  {
    const auto is_torn = [&](const std::pair<std::size_t, std::size_t>& pair) {
      return ends_.charted[0].parts[pair.first]->is_closed_curve() !=
             ends_.charted[1].parts[pair.second]->is_closed_curve();
    };
    const auto has_other = [&](const std::pair<std::size_t, std::size_t>& pair) {
      return std::any_of(paired.begin(), paired.end(), [&](const auto& other) {
        return (other.first == pair.first || other.second == pair.second) && !is_torn(other);
      });
    };
    Part_pairs kept;
    for (const auto& pair : paired)
      if (!is_torn(pair) || !has_other(pair)) kept.push_back(pair);
    paired = std::move(kept);
  }

  void find_images(const Part_pairs& paired)
  {
    for (const auto& [s, t] : paired) {
      const std::pair<std::size_t, std::size_t> image = {ends_.images[0][s], ends_.images[1][t]};
      const auto found = std::lower_bound(paired.begin(), paired.end(), image);
      const bool is_paired = found != paired.end() && *found == image;
      images_.push_back(is_paired ? std::size_t(found - paired.begin()) : none);
    }
  }

  void find_uses()
  {
    for (std::size_t end : {0u, 1u})
      uses_[end].resize(ends_.meshes[end].size());
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
      const std::optional<Eigen::Matrix3d> turn = mirrored_turn(pairs_[i], ends_.charted[0], ends_.charted[1]);
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

  /// \param image its mirror image, if it is there, which becomes its counterpart in the same way
  Blend_part part(std::size_t number, const Blend_part* image, std::vector<std::shared_ptr<Part_morph>>& morphs) const
  {
    const Piece_pair& pair = pairs_[number];
    Blend_part result;
    result.name = ends_.charted[0].parts[pair.source]->name + '~' + ends_.charted[1].parts[pair.target]->name;
    result.task = task_of(pair);
    result.image = images_[number];
    result.is_reflected = result.image < number && has_images(pair) && has_images(pairs_[result.image]);
    const Piece_pair& charted_as = result.is_reflected ? pairs_[result.image] : pair;
    const std::array<Part_mesh, 2> pieces = {
        piece(0, pair.source, charted_as.source, charted_as.source_piece, result.is_reflected),
        piece(1, pair.target, charted_as.target, charted_as.target_piece, result.is_reflected)};
    morphs.push_back(std::make_shared<Part_morph>(charts(charted_as, is_upright_[number], pieces), pieces[0], pieces[1],
                                                  image ? std::optional(image->morph->is_forward()) : std::nullopt));
    result.morph = morphs.back();
    set_foot(result, pieces);
    result.add_trees();
    return result;
  }

  Pair_charts charts(const Piece_pair& pair, bool is_upright, const std::array<Part_mesh, 2>& pieces) const
  {
    return is_upright ? upright_charts(pieces[0].points, pieces[1].points)
                      : pair_charts(pair, ends_.charted[0], ends_.charted[1], pieces[0].points, pieces[1].points);
  }

  void set_foot(Blend_part& part, const std::array<Part_mesh, 2>& pieces) const
  {
    constexpr double on_ground = 0.02; // of the height: what is no higher stands on the ground
    part.height = (pieces[0].points.row(1).mean() + pieces[1].points.row(1).mean()) / 2;
    for (std::size_t end : {0u, 1u})
      part.foot[end] = pieces[end].points.row(1).minCoeff() - ends_.ground[end];
    part.stands = std::max(part.foot[0], part.foot[1]) <= on_ground;
  }

  /// The piece of a part that a box of a chart cuts out.
  /// \param charted the part whose chart it is
  Part_mesh piece(std::size_t end, std::size_t part, std::size_t charted, const Chart_box& box, bool in_mirror) const
  {
    const Part_mesh& mesh = ends_.meshes[end][part];
    return piece_of(in_mirror ? mirrored(mesh.points) : mesh.points, mesh.triangles, ends_.charted[end].charts[charted],
                    box);
  }

  const Blend_ends& ends_;
  std::vector<Piece_pair> pairs_;
  std::vector<std::size_t> images_;      ///< by pair, its mirror image
  std::vector<char> is_upright_;         ///< by pair
  std::array<std::vector<Use>, 2> uses_; ///< by end and part
};

} // namespace

std::vector<Blend_part> matched_parts(const Blend_ends& ends, const Correspondence& correspondence)
{
  return Matched_part_maker(ends, correspondence).parts();
}

} // namespace CGAL::Shape_correspondence::internal
