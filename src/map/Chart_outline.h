// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The convex outline of a part in the coordinates of its chart: of a curve's cross-sections, station by station, or of
/// a sheet as a whole. Coordinates relative to it make every cross-section, or sheet, a unit disc: what is at the rim
/// of one part is at the rim of every other, whatever the outlines are, round or with corners.
class Chart_outline
{
public:
  /// None: coordinates stay what they are.
  Chart_outline() = default;
  /// \param coordinates of points all over the surface
  Chart_outline(bool is_sheet, const Points& coordinates);

  /// Coordinates relative to the outline, and back: exact inverses.
  Point relative(const Point& k) const;
  Point absolute(const Point& q) const;

  /// \pre both are of sheets, or both of curves, or none
  static Chart_outline between(const Chart_outline& a, const Chart_outline& b, double t);

private:
  static constexpr int angles = 32;

  struct Section
  {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    Eigen::Matrix<double, angles, 1> radii = Eigen::Matrix<double, angles, 1>::Ones(); ///< by angle
  };

  static Section section_around(const std::vector<Eigen::Vector2d>& points);
  /// The section at a point's station.
  Section section(const Point& k) const;
  static double radius(const Section& section, const Eigen::Vector2d& direction);
  int first() const { return is_sheet_ ? 0 : 1; } ///< of the two coordinates that the outline is in

  bool is_sheet_ = false;
  std::vector<Section> sections_; ///< by station
};

} // namespace CGAL::Shape_correspondence::internal
