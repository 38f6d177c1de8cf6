// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Structural_rods.h"
#include "structure/align_shapes.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence {

/// A shape that is deformed, or that another one is deformed into, with what the energy measures of it. This is found
/// when it is first asked for and shared by copies, so that a shape that is matched many times is measured once, and
/// one that nothing is deformed from has no rods. Threads may share it.
class Deformable_shape : public Aligned_shape
{
public:
  /// The structural rods of a contact, with the samples of its parts, or those of a curve lifted to a sheet's number,
  /// at 2 (first is lifted) + (second is lifted); empty where a sheet would be lifted.
  using Contact_rods = std::array<Structural_rods, 4>;

  explicit Deformable_shape(Aligned_shape shape);

  /// By contact.
  const std::vector<Contact_rods>& rods() const;
  /// The least distance between the samples of two parts.
  const Eigen::MatrixXd& part_distances() const;

  /// The same with a group for every part.
  Deformable_shape ungrouped() const;

private:
  struct Measures;

  std::shared_ptr<Measures> measures_;
};

} // namespace CGAL::Shape_correspondence
