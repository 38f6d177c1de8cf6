// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Chart_outline.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Charted_mesh;

/// How the surface of a part becomes that of its counterpart. There is one surface at any time, first that of the
/// source, then that of the target: both ends are exact, and closed if the inputs are.
///
/// The source's surface, in coordinates of its chart relative to the part's outline there, moves to the nearest places
/// of the target's; then that takes over where the first has come to, and what the first could not reach grows out of
/// it, so nothing jumps.
class Part_morph
{
public:
  /// \param charts of both ends, between which the surfaces are on the way
  Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target);

  /// When the target's surface takes over from the source's.
  double change() const { return surfaces_[0].end; }
  /// The surface that there is at `t`: 0, the source's, or 1.
  int surface(double t) const { return t < change() ? 0 : 1; }
  const Eigen::Matrix3Xi& triangles(int surface) const { return surfaces_[std::size_t(surface)].triangles; }
  /// The points of a surface at `t`, also where it is not the one that there is.
  Points points(int surface, double t) const;
  /// The share of a surface that the other one turns by more than 60 degrees on the way: where a hull goes from one of
  /// its layers to the other.
  double turned_share(int surface) const;

  /// Coordinates of a point at an end, and where such coordinates are at `t`, before the surfaces fit in exactly.
  Point coordinates(int end, const Point& p) const;
  Point place(const Point& coordinates, double t) const;

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

  void lay();
  Part_chart chart_at(double t) const { return Part_chart::between(charts_.source, charts_.target, t); }
  Chart_outline outline_at(double t) const { return Chart_outline::between(outlines_[0], outlines_[1], t); }

  Pair_charts charts_;
  std::array<Chart_outline, 2> outlines_; ///< by end
  std::vector<Moving_surface> surfaces_;  ///< by end
};

} // namespace CGAL::Shape_correspondence::internal
