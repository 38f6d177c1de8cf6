// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_structure.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The surfaces of the parts of a blend at a time strictly between its ends. Parts and surfaces are named by index.
///
/// *Layout*: matched parts go straight and evenly from where they are at the one end to where they are at the other.
/// Unmatched ones ride on the warps of the ends. Then the whole is stretched so that it stands and is as high as is
/// due.
class In_between_shape
{
public:
  using Tree = contacts::Triangle_tree;
  using Trees = std::vector<std::optional<Tree>>; ///< by part, of the surface that there is

  static constexpr double nothing = 1e-6; ///< of a surface: less has no area in floating-point numbers

  In_between_shape(const Blend_structure& blend, const std::vector<Blend_task>& tasks, double t);

  const Blend_structure& blend() const { return blend_; }
  const Blend_part& part(std::size_t part) const { return blend_.parts[part]; }
  std::size_t number_of_parts() const { return points_.size(); }
  double time() const { return t_; }
  /// The box that the whole is to fill.
  contacts::Box due_box() const;

  /// The one of a part's surfaces that there is, or -1.
  int surface(std::size_t part) const { return surface_[part]; }
  bool is_there(std::size_t part) const { return surface_[part] >= 0; }
  /// Of the surface that there is.
  const Points& points(std::size_t part) const { return points_[part]; }
  /// The same, to be changed.
  Points& moving_points(std::size_t part) { return points_[part]; }
  /// Of any; for one that there is not, its motion is continued.
  Points points(std::size_t part, int surface) const;

  /// The trees of the parts that are there.
  Trees trees() const;

private:
  void place_chains(const std::vector<Blend_task>& tasks);
  void fill_the_height();

  const Blend_structure& blend_;
  double t_;
  std::vector<Points> points_; ///< by part
  std::vector<int> surface_;
  Eigen::Affine3d stretch_ = Eigen::Affine3d::Identity(); ///< of the whole
};

} // namespace CGAL::Shape_correspondence::internal
