// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_MORPHING_CAST_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_MORPHING_CAST_H

#include "blend/Blend_actor.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// The shapes of a blend in their common frame.
struct Blend_ends
{
  std::array<std::vector<Part_mesh>, 2> meshes;
  std::array<Charted_shape, 2> charted;
  std::array<Mirror_twins, 2> twins; ///< none if the blend is not to be symmetric
  std::array<double, 2> ground = {0, 0};
};

/// Makes the actors that become each other: one for every two parts that do and, if the blend is to be symmetric, for
/// their mirror images.
class Morphing_cast
{
public:
  Morphing_cast(const Blend_ends& ends, const Correspondence& correspondence) : ends_(ends)
  {
    Part_pairs paired = part_pairs(correspondence.pairs);
    add_mirrored(paired, ends.twins[0], ends.twins[1]);
    paired = matched_members(ends.charted[0], ends.charted[1], paired);
    add_mirrored(paired, ends.twins[0], ends.twins[1]);
    pairs_ = piece_pairs(ends.charted[0], ends.charted[1], paired);
    find_twins(paired);
    count_shares();
    turn_own_images();
  }

  std::vector<Blend_actor> actors() const
  {
    std::vector<Blend_actor> result;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      std::optional<bool> forward;
      if (twins_[i] < i) forward = result[twins_[i]].morph->is_forward();
      result.push_back(actor(i, forward));
    }
    return result;
  }

private:
  /// What the pairs that a part is in have in common.
  struct Shares
  {
    int count = 0;
    bool all_have_images = true;
  };

  void find_twins(const Part_pairs& paired)
  {
    for (const auto& [s, t] : paired) {
      const std::pair<std::size_t, std::size_t> image = {ends_.twins[0][s], ends_.twins[1][t]};
      const auto twin = std::lower_bound(paired.begin(), paired.end(), image);
      const bool known = twin != paired.end() && *twin == image;
      twins_.push_back(known ? std::size_t(twin - paired.begin()) : Mirror_twins::none);
    }
  }

  void count_shares()
  {
    for (std::size_t side : {0u, 1u})
      shares_[side].resize(ends_.meshes[side].size());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (Shares* shares : {&shares_[0][pairs_[i].source], &shares_[1][pairs_[i].target]}) {
        ++shares->count;
        shares->all_have_images = shares->all_have_images && twins_[i] != Mirror_twins::none;
      }
  }

  /// Turns pairs that are their own mirror images so that they stay that, or makes them upright.
  void turn_own_images()
  {
    is_upright_.resize(pairs_.size(), 0);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (twins_[i] != i) continue;
      const std::optional<Eigen::Matrix3d> turn = mirrored_turn(pairs_[i], ends_.charted[0], ends_.charted[1]);
      is_upright_[i] = !turn;
      if (turn) pairs_[i].turn = *turn;
    }
  }

  /// Images need pieces that are images, too: all pairs of a part in the mirror or none.
  bool has_images(const Part_pair& pair) const
  {
    return shares_[0][pair.source].all_have_images && shares_[1][pair.target].all_have_images;
  }

  Blend_task task_of(const Part_pair& pair) const
  {
    Blend_task task;
    task.source = pair.source;
    task.target = pair.target;
    task.type = shares_[1][pair.target].count > 1   ? Blend_task_type::MERGE
                : shares_[0][pair.source].count > 1 ? Blend_task_type::SPLIT
                                                    : Blend_task_type::MORPH;
    return task;
  }

  /// \param forward whether the source's surface moves first; if not said, what is better
  Blend_actor actor(std::size_t number, const std::optional<bool>& forward) const
  {
    constexpr double on_ground = 0.02;
    const Part_pair& pair = pairs_[number];
    Blend_actor result;
    result.name = ends_.charted[0].parts[pair.source]->name + '~' + ends_.charted[1].parts[pair.target]->name;
    result.task = task_of(pair);
    result.twin = twins_[number];
    result.is_image = result.twin < number && has_images(pair) && has_images(pairs_[result.twin]);
    const Part_pair& made_as = result.is_image ? pairs_[result.twin] : pair;
    const Part_mesh from = piece(0, pair.source, made_as.source, made_as.source_piece, result.is_image);
    const Part_mesh to = piece(1, pair.target, made_as.target, made_as.target_piece, result.is_image);
    const Pair_charts charts = is_upright_[number]
                                   ? upright_charts(from.points, to.points)
                                   : pair_charts(made_as, ends_.charted[0], ends_.charted[1], from.points, to.points);
    result.morph.emplace(charts, from, to, forward);
    result.height = (from.points.row(1).mean() + to.points.row(1).mean()) / 2;
    result.foot = {from.points.row(1).minCoeff() - ends_.ground[0], to.points.row(1).minCoeff() - ends_.ground[1]};
    result.stands = std::max(result.foot[0], result.foot[1]) <= on_ground;
    return result;
  }

  /// The piece of a part that a box of a chart cuts out.
  /// \param charted the part whose chart it is
  Part_mesh piece(std::size_t side, std::size_t part, std::size_t charted, const Chart_box& box, bool in_mirror) const
  {
    const Part_mesh& mesh = ends_.meshes[side][part];
    return piece_of(in_mirror ? mirrored(mesh.points) : mesh.points, mesh.triangles,
                    ends_.charted[side].charts[charted], box);
  }

  const Blend_ends& ends_;
  std::vector<Part_pair> pairs_;
  std::vector<std::size_t> twins_;            ///< by pair, its mirror image
  std::vector<char> is_upright_;              ///< by pair
  std::array<std::vector<Shares>, 2> shares_; ///< by side and part
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_MORPHING_CAST_H
