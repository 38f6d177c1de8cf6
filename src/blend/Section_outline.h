// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The outline of a part in cross-sections of the chart of a curve: at each station, the radius by angle around the
/// middle of the section, over half its extents. Coordinates relative to it map every section to a unit disc.
///
/// Unlike a `Chart_outline`, it is not convex, and follows ends that are round: stations are dense there.
class Section_outline
{
public:
  static constexpr int stations = 33, angles = 32;

  /// \param coordinates points of a surface, in chart coordinates
  Section_outline(const Points& coordinates, const Eigen::Matrix3Xi& triangles);

  /// Coordinates relative to the outline, and the inverse.
  Point relative(const Point& k) const;
  Point absolute(const Point& q) const;

  static Section_outline between(const Section_outline& a, const Section_outline& b, double t);

  /// The first coordinate of a station.
  static double station(int i);
  /// The point of the outline at a station and an angle, in relative coordinates.
  static Point on_outline(int station, int angle);

private:
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
