// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Structural_rods.h"
#include "structure/align_shapes.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence {

/// A source or target shape with the quantities that the energy needs of it alone: structural rods and distances of
/// parts, computed on demand and shared by copies, so that repeated matches compute them once. Thread-safe.
class Deformable_shape : public Aligned_shape
{
public:
  explicit Deformable_shape(Aligned_shape shape);

  /// The structural rods of a contact. Each sample of a part is used as often as its `repeats` say: `samples_per_side`
  /// times if a curve becomes a sheet, else once.
  const Structural_rods& rods(std::size_t contact, int first_repeats, int second_repeats) const;
  /// The matrix of the least distances between the samples of every two parts.
  const Eigen::MatrixXd& part_distances() const;

  /// A copy in which every part is a group.
  Deformable_shape ungrouped() const;
  /// A copy in which each of the sets of parts is a group.
  Deformable_shape regrouped(const std::vector<std::vector<std::size_t>>& sets) const;

private:
  struct Measures;

  std::shared_ptr<Measures> measures_;
};

} // namespace CGAL::Shape_correspondence
