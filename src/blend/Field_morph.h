// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Distance_grid.h"
#include "blend/Part_morph.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A surface that becomes another of any topology, in the box of the pair: near the ends it is that of the input, and
/// on the way a level set of the mean of both signed distances (Payne and Toga 1992, "Distance field manipulation of
/// surface models"), where the volume is between those at the ends. Where level sets fall apart, the one surface takes
/// over from the other half-way.
class Field_morph : public Part_morph
{
public:
  /// \param boxes straight charts
  Field_morph(const Pair_charts& boxes, const Part_mesh& source, const Part_mesh& target);

  /// Whether there are level sets: all fill their box, and have no more pieces and holes than the surfaces at the ends.
  bool holds_together() const { return surfaces_.size() > 2; }

  const std::vector<double>& changes() const override { return changes_; }
  const Eigen::Matrix3Xi& triangles(int surface) const override { return surfaces_[std::size_t(surface)].triangles; }
  Points points(int surface, double t) const override;

private:
  struct Fields;

  bool add_level_set(const Fields& fields, double share);

  std::vector<double> changes_;
  std::vector<Part_mesh> surfaces_; ///< in coordinates of the box
};

} // namespace CGAL::Shape_correspondence::internal
