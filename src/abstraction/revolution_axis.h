// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Nearest_points.h"
#include "base/eigen_system.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Revolution_axis
{
  Point centre;
  Point direction;
  double height = 0;      ///< height of most of the surface, without thin axles
  double slenderness = 0; ///< height over the diameter of most of the surface
  double deviation = 0;   ///< distance by which rotation moves the surface off itself, over the largest radius

  /// The part of the axis within the extent of the points.
  Curve curve(const Points& points, int control_points) const
  {
    const Eigen::RowVectorXd heights = direction.transpose() * (points.colwise() - centre);
    Curve result;
    result.points.resize(3, control_points);
    for (int i = 0; i < control_points; ++i) {
      const double t = i / (control_points - 1.);
      result.points.col(i) = centre + ((1 - t) * heights.minCoeff() + t * heights.maxCoeff()) * direction;
    }
    return result;
  }
};

inline double quantile(Eigen::RowVectorXd values, double fraction)
{
  std::sort(values.data(), values.data() + values.size());
  return values[Eigen::Index(fraction * double(values.size() - 1))];
}

/// Candidate directions of an axis of revolution: the coordinate axes, the principal axes and, since principal axes of
/// a compact body may be arbitrary, the direction of its skewness.
inline std::vector<Point> axis_candidates(const Points& centred)
{
  std::vector<Point> result{Point::UnitY(), Point::UnitX(), Point::UnitZ()};
  const Eigen::Matrix3d principal_axes = eigen_system(scatter_matrix(centred)).vectors;
  for (int k = 0; k < 3; ++k)
    result.push_back(principal_axes.col(k));
  const Point skewness = centred * centred.colwise().squaredNorm().transpose();
  if (skewness.norm() > 0) result.push_back(skewness.normalized());
  return result;
}

/// The axis about which rotation hardly changes the surface; none if there is no such axis. A hexagonal prism passes, a
/// square one does not. \param surface evenly spread points \param spacing their distance
inline std::optional<Revolution_axis> revolution_axis(const Points& surface, double spacing)
{
  // Largest distance by which rotation moves points off the surface, over the largest radius
  const double tolerance = 0.16;
  const double clearly = 0.02; // least difference of that by which a later axis is better
  const double gap = 0.6;      // distance between two samplings of the same surface, over their spacing
  const double turns[] = {double(2 * EIGEN_PI / 5), double(2 * EIGEN_PI / 4)};
  const Point centre = surface.rowwise().mean();
  const Points centred = surface.colwise() - centre;
  const Nearest_points points(centred);
  std::optional<Revolution_axis> result;
  double least = tolerance;
  for (const Point& direction : axis_candidates(centred)) {
    const Eigen::RowVectorXd heights = direction.transpose() * centred;
    const Eigen::RowVectorXd radii = (centred - direction * heights).colwise().norm();
    const double most = (least - clearly) * radii.maxCoeff() + gap * spacing;
    double deviation = 0;
    for (double turn : turns) {
      const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn, direction).toRotationMatrix();
      // Strides make successive angles differ much, so that parts that are not round are rejected early
      const Eigen::Index strides = 16;
      for (Eigen::Index first = 0; first < strides; ++first) {
        for (Eigen::Index i = first; i < centred.cols() && deviation <= most; i += strides)
          deviation = std::max(deviation, points.distance(rotation * centred.col(i)));
      }
    }
    if (deviation <= most) {
      least = std::max(0., deviation - gap * spacing) / radii.maxCoeff();
      const double few = 0.1; // share of the points left out at either end
      const double height = quantile(heights, 1 - few) - quantile(heights, few);
      result = {centre, direction, height, height / (2 * quantile(radii, 1 - few)), least};
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
