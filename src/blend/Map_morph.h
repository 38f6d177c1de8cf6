// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "map/Chart_outline.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Charted_mesh;

/// A surface that becomes another by a map between the two.
///
/// First the source's surface, in coordinates of its chart relative to the part's outline there, moves to the nearest
/// places of the target's; then that takes over where the first has come to, and what the first could not reach grows
/// out of it. So both ends are exact, nothing jumps, and the surface is that of one input or the other at any time:
/// closed if both are.
class Map_morph : public Part_morph
{
public:
  Map_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target);

  const std::vector<double>& changes() const override { return changes_; }
  const Eigen::Matrix3Xi& triangles(int surface) const override { return surfaces_[std::size_t(surface)].triangles; }
  Points points(int surface, double t) const override;
  /// The share of a surface that the other one turns by more than 60 degrees on the way: where a hull goes from one of
  /// its layers to the other.
  double turned_share(int surface) const;

  Point coordinates(int end, const Point& p) const override;
  Point place(const Point& coordinates, double t) const override;

private:
  struct Moving_surface
  {
    explicit Moving_surface(const Charted_mesh& mesh);
    /// Lays the surface, from where or to where it moves, on another one that is there.
    void lay(std::size_t when, const Points& onto, const Points& onto_offsets, const Eigen::Matrix3Xi& onto_triangles);

    Eigen::Matrix3Xi triangles;
    std::array<Points, 2> coordinates, offsets; ///< relative to outlines in charts; from, to
    double begin = 0, end = 1;                  ///< when it moves from the one to the other

    /// How far a point has to move, at most, in coordinates.
    double reach() const;
  };

  std::vector<Chart_outline> outlines_;  ///< by end
  std::vector<Moving_surface> surfaces_; ///< by end
  std::vector<double> changes_;          ///< one
};

} // namespace CGAL::Shape_correspondence::internal
