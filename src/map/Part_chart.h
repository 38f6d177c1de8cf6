// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Points.h>

#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Coordinates of a part: the cube [-1, 1]³ fitted around its abstraction so that it just contains the part's surface.
///
/// For a curve, the first coordinate follows its length, and the others span its cross-sections in rotation-minimizing
/// frames (by parallel transport). For a sheet, the first two follow its parameters, and the third its normals. Beyond
/// its ends the abstraction is extended linearly.
class Part_chart
{
public:
  static constexpr int curve_stations = 17, sheet_stations = 9; ///< numbers along a curve, and each side of a sheet
  static constexpr double least_half_extent = 1e-4; ///< lower bound of half extents, over the height, for flat parts

  /// The chart of a part, fitted to points of its surface. A closed curve gets the chart of its bounding box.
  static Part_chart around(const Part_abstraction& part, const Points& control_points, const Points& surface);

  /// A straight chart whose directions are the columns of the rotation `axes`.
  static Part_chart box(const Points& surface, const Eigen::Matrix3d& axes) { return straight(surface, axes, false); }

  bool is_sheet() const { return is_sheet_; }

  Point operator()(const Point& k) const { return locate(k).first; }
  /// Unit vectors of the coordinate directions at `k`, as columns.
  Eigen::Matrix3d frame(const Point& k) const { return locate(k).second; }
  Point coordinates(const Point& p) const;

  /// The overall directions (a rotation), and the half extents along them.
  Eigen::Matrix3d axes() const;
  Point half_extents() const;

  /// The chart refitted so that it just contains the points.
  Part_chart fitted(const Points& surface) const;
  /// The chart with its spine in the middle of the surface everywhere, which separates the two sides of a thin and bent
  /// part; unchanged if not narrower then. \param surface points that cover the surface as densely as the stations
  Part_chart centred(const Points& surface) const;
  /// The chart of the box from `low` to `high`, which are given in coordinates of this chart.
  Part_chart restricted(const Point& low, const Point& high) const;
  /// The chart in rotated coordinates k: those of this chart are `turn` * k.
  /// \pre `turn` is a rotation of the cube that keeps the direction of a curve or the normal of a sheet, up to sign
  Part_chart turned(const Eigen::Matrix3d& turn) const;
  /// A rotation from the coordinates of `lengthwise()` to those of this chart.
  Eigen::Matrix3d lengthwise_turn() const;
  /// For a sheet, the chart of the curve along its middle in the longer direction; for a curve, the chart itself.
  Part_chart lengthwise() const;
  /// The chart between two: the rotation between them is interpolated, the rest linearly.
  /// \pre both are curves or both are sheets
  static Part_chart between(const Part_chart& a, const Part_chart& b, double t);

private:
  using Frames = std::vector<Eigen::Matrix3d>;

  static Part_chart along(const Points& spine, const Point& across, const Point& half);
  static Part_chart over(const Points& spine, const Point& half);
  /// A straight chart of a curve, or a flat one of a sheet, whose normal is the last column of `axes`.
  static Part_chart straight(const Points& surface, const Eigen::Matrix3d& axes, bool is_sheet);
  static int stations(bool is_sheet) { return is_sheet ? sheet_stations : curve_stations; }

  std::pair<Point, Eigen::Matrix3d> locate(const Point& k) const;
  double nearest_on_curve(const Point& p) const;
  Eigen::Vector2d nearest_on_sheet(const Point& p) const;
  static Point coordinates_of_station(Eigen::Index station, bool is_sheet);
  Point station(int i, int j) const { return spine_.col(i * sheet_stations + j); }
  void transport_frames(const Point& across);
  void normal_frames();

  bool is_sheet_ = false;
  Points spine_;  ///< stations of a curve, or of a sheet row by row
  Frames frames_; ///< indexed by station
  Point half_ = Point::Ones();
};

inline Point unit_or(const Point& v, const Point& otherwise)
{
  return v.squaredNorm() > 1e-24 ? v.normalized() : otherwise;
}

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
  static constexpr int angles = 32; ///< number of radii of a section

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
