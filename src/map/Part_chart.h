// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A part's own coordinates: the cube [-1, 1]³ laid around its abstraction, so that the part's surface just fits in.
///
/// Along a curve the first coordinate runs with its length, the others across it in rotation-minimising frames (by
/// parallel transport); on a sheet the first two run with its parameters, the third along its normals. Past its ends
/// the abstraction goes on straight.
class Part_chart
{
public:
  static constexpr int curve_stations = 17, sheet_stations = 9;
  static constexpr double least_half_extent = 1e-4; ///< so that a flat part has coordinates across, too

  /// The chart of a part whose surface has these points. A closed curve has that of the box around it.
  static Part_chart around(const Part_abstraction& part, const Points& control_points, const Points& surface);

  /// A straight chart with the columns of `axes`, a rotation, as directions.
  static Part_chart box(const Points& surface, const Eigen::Matrix3d& axes);
  /// A flat one of a sheet, the last column its normal.
  static Part_chart plate(const Points& surface, const Eigen::Matrix3d& axes);

  bool is_sheet() const { return is_sheet_; }

  /// The point at coordinates `k`.
  Point operator()(const Point& k) const { return locate(k).first; }
  /// The directions of the coordinates at `k`, unit vectors in columns.
  Eigen::Matrix3d frame(const Point& k) const { return locate(k).second; }
  /// The coordinates of a point.
  Point coordinates(const Point& p) const;

  /// The directions at large, a rotation, and the half extents along them.
  Eigen::Matrix3d axes() const;
  Point half_extents() const;

  /// The same chart laid anew so that the points just fit in.
  Part_chart fitted(const Points& surface) const;
  /// The same chart with its spine in the middle of the surface everywhere, so that both sides of a thin and bent part
  /// are told apart; the same chart if that makes no narrower one. \param surface has points all over, as near to each
  /// other as the stations
  Part_chart centred(const Points& surface) const;
  /// The chart of the box from `low` to `high`, in coordinates.
  Part_chart restricted(const Point& low, const Point& high) const;
  /// The chart with other coordinates: those of the result times `turn` are those of this chart.
  /// \pre `turn` is a rotation of the cube that keeps the direction of a curve or the normal of a sheet, up to sign
  Part_chart turned(const Eigen::Matrix3d& turn) const;
  /// A rotation from the coordinates of `lengthwise()` to those of this chart.
  Eigen::Matrix3d lengthwise_turn() const;
  /// That of a curve along the middle of a sheet, the long way; itself for a curve.
  Part_chart lengthwise() const;
  /// The chart between two: rotated by a part of the rotation between them, the rest linear. \pre both of one kind
  static Part_chart between(const Part_chart& a, const Part_chart& b, double t);

private:
  using Frames = std::vector<Eigen::Matrix3d>;

  static Part_chart along(const Points& spine, const Point& across, const Point& half);
  static Part_chart over(const Points& spine, const Point& half);
  static int stations(bool is_sheet) { return is_sheet ? sheet_stations : curve_stations; }

  std::pair<Point, Eigen::Matrix3d> locate(const Point& k) const;
  double nearest_on_curve(const Point& p) const;
  Eigen::Vector2d nearest_on_sheet(const Point& p) const;
  Point coordinates_of_station(Eigen::Index station) const;
  Point station(int i, int j) const { return spine_.col(i * sheet_stations + j); }
  void transport_frames(const Point& across);
  void normal_frames();

  bool is_sheet_ = false;
  Points spine_;  ///< stations of a curve, or of a sheet row by row
  Frames frames_; ///< by station
  Point half_ = Point::Ones();
};

inline Point unit_or(const Point& v, const Point& otherwise)
{
  return v.squaredNorm() > 1e-24 ? v.normalized() : otherwise;
}

} // namespace CGAL::Shape_correspondence::internal
