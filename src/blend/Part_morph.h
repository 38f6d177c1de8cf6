// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Chart_outline.h"
#include "map/Part_chart.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Charted_mesh;

/// A surface that becomes another.
///
/// First the one surface, in coordinates of its chart relative to the part's outline there, moves to the nearest places
/// of the other that do not tear it; then the other takes over where the first has come to and what the first could not
/// reach grows out of it. So both ends are exact, nothing jumps, and the surface is that of one input or the other at
/// any time: closed if both are.
///
/// Where that fails, the surfaces are *exchanged*: both go the way of the pair's boxes as they are. Before the change
/// the target's thickens in the middle of the source's; then the source's thins to there.
class Part_morph
{
public:
  /// \param forward whether the source's surface moves first; if not said, it is that of which less is left to grow
  Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target,
             const std::optional<bool>& forward = {});

  bool is_forward() const { return forward_; }
  bool is_exchange() const { return is_exchange_; }
  /// An exchange in straight charts.
  static Part_morph exchange(const Pair_charts& boxes, const Part_mesh& source, const Part_mesh& target);

  /// The surfaces, the one at the source's end first.
  const Eigen::Matrix3Xi& triangles(int surface) const { return moving(surface).triangles; }

  /// Which of the surfaces there is at `t`; in an exchange, which is there as a whole.
  int surface(double t) const { return t < switch_time() ? 0 : 1; }
  double switch_time() const { return forward_ ? surfaces_.change : 1 - surfaces_.change; }

  /// The points of a surface at `t`, also where it is not the one that there is.
  /// \param remaining how much there is of it, in [0, 1]
  Points points(int surface, double t, double remaining = 1) const;
  /// The share of a surface that the other one turns by more than 60 degrees on the way: where a hull goes from one of
  /// its layers to the other.
  double turned_share(int surface) const;

  /// Coordinates of a point at an end, and where such coordinates are at `t`, before the surfaces fit in exactly.
  Point coordinates(int end, const Point& p) const;
  Point place(const Point& coordinates, double t) const;

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

  explicit Part_morph(const Pair_charts& charts) : source_(charts.source), target_(charts.target) {}

  bool is_block() const;
  Point narrowing(double t) const;
  Point thinning(double remaining) const;
  static Moving_surface at_rest(const Charted_mesh& mesh);
  static Surface_pair surface_pair(const Charted_mesh& a, const Charted_mesh& b);
  const Moving_surface& moving(int surface) const
  {
    return (surface == 0) == forward_ ? surfaces_.first : surfaces_.second;
  }

  Part_chart source_, target_;
  std::vector<Chart_outline> outlines_; ///< by end
  bool forward_ = true, is_exchange_ = false;
  Surface_pair surfaces_;
};

} // namespace CGAL::Shape_correspondence::internal
