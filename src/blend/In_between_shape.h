// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Affine_motion.h"
#include "blend/Blend_structure.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// When each part's task begins and ends.
using Task_times = std::vector<std::array<double, 2>>;

/// The surfaces of the parts of a blend at a time strictly between its ends. Parts and surfaces are named by index.
/// Every task starts and stops gently, and so does what both shapes have at large.
class In_between_shape
{
public:
  using Tree = contacts::Triangle_tree;
  using Trees = std::vector<std::optional<Tree>>; ///< by part, of the surface that there is

  // Over the height
  static constexpr double closed_gap = 1e-4;            ///< a gap that is none
  static constexpr double widest_connected_gap = 0.005; ///< between components, over what the ends have
  /// Of a part's full size: what is smaller is moved as it is, not stretched, which would tear what it becomes apart.
  static constexpr double least_stretched = 0.1;

  /// Matched parts morph, each for itself; the others are not there yet.
  In_between_shape(const Blend_structure& blend, const Task_times& times, double t);

  const Blend_structure& blend() const { return blend_; }
  const Blend_part& part(std::size_t part) const { return blend_.parts[part]; }
  std::size_t number_of_parts() const { return points_.size(); }
  /// How far the whole shape is on its way: the time, eased.
  double time() const { return t_; }
  static constexpr double nothing = 1e-6; ///< of a surface: less has no area in floating-point numbers

  /// The one of a part's surfaces that there is, or -1; in an exchange, the one that is there as a whole.
  int surface(std::size_t part) const { return surface_[part]; }
  bool is_there(std::size_t part) const { return surface_[part] >= 0; }
  const Points& points(std::size_t part, int surface) const { return points_[part][std::size_t(surface)]; }
  /// Of the surface that there is.
  const Points& points(std::size_t part) const { return points(part, surface_[part]); }
  /// The same, to be changed.
  Points& moving_points(std::size_t part);
  /// In an exchange, whether there is something of the other surface, and its points.
  bool has_other(std::size_t part) const { return has_other_[part]; }
  const Points& other_points(std::size_t part) const { return others_[part]; }
  /// How much there is of an unmatched part, in [0, 1].
  double remaining(std::size_t part) const { return remaining_[part]; }
  /// An unmatched part is there as far as something of it remains.
  void set_unmatched(std::size_t part, Points points);

  /// The tree of a part's surface, and of those of all parts that are there, where they are now. The same object until
  /// the shape ends; asking for it again moves it to where the surface has gone since.
  const Tree& tree(std::size_t part);
  const Trees& trees();
  /// Frees the memory of the trees.
  void drop_trees();
  /// Moves all surfaces of a part.
  void apply(const Affine_motion& motion, std::size_t part);
  /// The same to close gaps, as far as the part may be stretched for that.
  void stretch(const Affine_motion& motion, std::size_t part) { apply(stretches_[part].bounded(motion), part); }
  /// Whether a part is stretched as much as it may be.
  bool is_at_bound(std::size_t part) const { return stretches_[part].is_at_bound(); }

  /// The height of the ground.
  double ground() const { return (1 - t_) * blend_.ground[0] + t_ * blend_.ground[1]; }
  double lowest(std::size_t part) const { return points(part).row(1).minCoeff(); }
  /// How far a part is to rise to be as high above the ground as it is, in between, at the ends, if it stands there, or
  /// else to be above the ground.
  double needed_rise(std::size_t part) const;

  /// How far components were from each other, at most, before they were reconnected.
  double widest_disconnection() const { return widest_disconnection_; }
  void add_disconnection(double gap);

private:
  const Blend_structure& blend_;
  double t_;
  std::vector<std::array<Points, 2>> points_; ///< by part and surface
  std::vector<int> surface_;
  std::vector<Points> others_; ///< by part, of an exchange, the points of the other surface
  std::vector<char> has_other_;
  std::vector<double> remaining_;
  Trees trees_;
  std::vector<char> has_moved_;    ///< by part, since its tree was
  std::vector<Stretch> stretches_; ///< by part, since it has been placed
  double widest_disconnection_ = 0;
};

} // namespace CGAL::Shape_correspondence::internal
