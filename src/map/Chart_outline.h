// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The outline of a part in cross-sections of the chart of a curve: at each station, the radius by angle around the
/// middle of the section, over half its extents. Coordinates relative to it map every section to a unit disc.
///
/// It need not be convex, and follows ends that are round: stations are dense there.
class Chart_outline
{
public:
  /// The unit circle in every section: coordinates relative to it are the coordinates in the chart.
  Chart_outline();
  /// The outline of a surface. \param coordinates its points, in chart coordinates
  Chart_outline(const Points& coordinates, const Eigen::Matrix3Xi& triangles);

  /// Converts chart coordinates to coordinates relative to the outline; `absolute()` is the inverse.
  Point relative(const Point& k) const;
  Point absolute(const Point& q) const;

  /// The outline without details: averaged along the part and around it.
  Chart_outline smoothed() const;
  static Chart_outline between(const Chart_outline& a, const Chart_outline& b, double t);

private:
  static constexpr int angles = 32;

  using Radii = Eigen::Matrix<double, angles, 1>;

  struct Section
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(), half = Eigen::Vector2d::Ones();
    Radii radii = Radii::Zero();
  };

  static bool set_outline(Section& section, const std::vector<Eigen::Vector2d>& segments);
  static double radius(const Section& section, const Eigen::Vector2d& direction);
  Section section(double k) const;

  std::vector<Section> sections_; ///< indexed by station
};

} // namespace CGAL::Shape_correspondence::internal
