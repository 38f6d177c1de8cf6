// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/part_mesh.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A part without counterpart, which draws back into what carries it, or grows out of it in reverse: a leg into the
/// seat along its length, a cushion across, a wheel into its hub as a whole. Its roots, where it is carried, stay. When
/// little remains, it shrinks in all directions but that of its roots. What joins parts that nothing else joins, or a
/// rod between two parts, thins to its curve or sheet where it is.
class Retreating_part
{
public:
  /// \param chart of the part
  /// \param axes of its box, a rotation
  /// \param roots where it is carried
  /// \param joints where it touches others, if it is of a chain that joins parts that nothing else joins
  Retreating_part(const Part_mesh& mesh, const Part_chart* chart, const Eigen::Matrix3d& axes,
                  const std::vector<Point>& roots, const std::vector<Point>& joints);

  const Eigen::Matrix3Xi& triangles() const { return mesh_.triangles; }
  /// The middle of those of its roots that it draws back to.
  const Point& root() const { return root_; }

  /// Where a point of the part is when a share of its extent remains, in [0, 1].
  Point place(const Point& p, double remaining) const;
  Points points(double remaining) const;

private:
  Eigen::Matrix3d scale(double remaining) const;
  Point end_of(const Point& p) const;

  Part_mesh mesh_;
  Point root_;
  Points ends_;                         ///< where the points go if it thins; else none
  std::optional<Part_chart> chart_;     ///< to whose curve or sheet it thins; else to the axes that stay
  Eigen::Matrix3d vanishing_, staying_; ///< the ways from the root that vanish first, and not: projections onto axes
};

} // namespace CGAL::Shape_correspondence::internal
