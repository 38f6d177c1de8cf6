// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The convex outline of a part in the coordinates of its chart: cross-sections of a curve at several stations, or one
/// outline of a sheet. Coordinates relative to it map every cross-section, or the sheet, to a unit disc, so that the
/// rim of one part corresponds to the rim of any other, round or with corners.
class Chart_outline
{
public:
  /// No outline: relative coordinates equal chart coordinates.
  Chart_outline() = default;
  /// \param coordinates points that cover the surface
  Chart_outline(bool is_sheet, const Points& coordinates);

  /// Coordinates relative to the outline, and the exact inverse.
  Point relative(const Point& k) const;
  Point absolute(const Point& q) const;

  /// Interpolates two outlines. \pre both are of sheets, or both of curves, or none
  static Chart_outline between(const Chart_outline& a, const Chart_outline& b, double t);

private:
  static constexpr int angles = 32;

  struct Section
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    Eigen::Matrix<double, angles, 1> radii = Eigen::Matrix<double, angles, 1>::Ones();
  };

  static Section section_around(const std::vector<Eigen::Vector2d>& points);
  Section section(const Point& k) const;
  static double radius(const Section& section, const Eigen::Vector2d& direction);
  int first() const { return is_sheet_ ? 0 : 1; } ///< first of the two coordinates of the outline's plane

  bool is_sheet_ = false;
  std::vector<Section> sections_; ///< indexed by station
};

} // namespace CGAL::Shape_correspondence::internal
