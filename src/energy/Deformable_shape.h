// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ENERGY_DEFORMABLE_SHAPE_H
#define CGAL_SHAPE_CORRESPONDENCE_ENERGY_DEFORMABLE_SHAPE_H

#include "energy/Structural_rods.h"
#include "structure/align_shapes.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

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

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ENERGY_DEFORMABLE_SHAPE_H
