// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "map/Chart_outline.h"
#include "map/Part_chart.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Charted_mesh;

/// A surface that becomes another by a map between the two.
///
/// First the one surface, in coordinates of its chart relative to the part's outline there, moves to the nearest places
/// of the other that do not tear it; then the other takes over where the first has come to and what the first could not
/// reach grows out of it. So both ends are exact, nothing jumps, and the surface is that of one input or the other at
/// any time: closed if both are.
class Map_morph : public Part_morph
{
public:
  /// \param forward whether the source's surface moves first; if not said, it is that of which less is left to grow
  Map_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target,
            const std::optional<bool>& forward = {});

  bool is_forward() const { return forward_; }
  const std::vector<double>& changes() const override { return changes_; }
  const Eigen::Matrix3Xi& triangles(int surface) const override { return moving(surface).triangles; }
  Points points(int surface, double t) const override;
  /// The share of a surface that the other one turns by more than 60 degrees on the way: where a hull goes from one of
  /// its layers to the other.
  double turned_share(int surface) const;

  Point coordinates(int end, const Point& p) const override;
  Point place(const Point& coordinates, double t) const override;

private:
  struct Moving_surface
  {
    Eigen::Matrix3Xi triangles;
    std::array<Points, 2> coordinates, offsets; ///< relative to outlines in charts; from, to
    double begin = 0, end = 1;                  ///< when it moves from the one to the other

    /// How far a point has to move, at most, in coordinates.
    double reach() const;
  };

  struct Surface_pair
  {
    Moving_surface first, second;
    double change = 1; ///< when the second takes over
  };

  static Moving_surface at_rest(const Charted_mesh& mesh);
  static Surface_pair surface_pair(const Charted_mesh& a, const Charted_mesh& b);
  const Moving_surface& moving(int surface) const
  {
    return (surface == 0) == forward_ ? surfaces_.first : surfaces_.second;
  }

  Part_chart source_, target_;
  std::vector<Chart_outline> outlines_; ///< by end
  bool forward_ = true;
  Surface_pair surfaces_;
  std::vector<double> changes_; ///< one
};

} // namespace CGAL::Shape_correspondence::internal
