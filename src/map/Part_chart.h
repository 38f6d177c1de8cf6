// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MAP_PART_CHART_H
#define CGAL_SHAPE_CORRESPONDENCE_MAP_PART_CHART_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

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
  /// The mean with the chart's own mirror image in x = 0. \param turn from coordinates of a point to those of its image
  Part_chart symmetrised(const Eigen::Matrix3d& turn) const;
  /// The chart's mirror image in x = 0, but for the signs of coordinates.
  Part_chart image() const;
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

inline Point some_normal(const Point& direction)
{
  Eigen::Index axis;
  direction.cwiseAbs().minCoeff(&axis);
  return (Point::Unit(axis) - direction[axis] * direction).normalized();
}

inline Point unit_or(const Point& v, const Point& otherwise)
{
  return v.squaredNorm() > 1e-24 ? v.normalized() : otherwise;
}

/// The part of `v` across the unit vector `direction`, of length 1.
inline Point across_to(const Point& v, const Point& direction)
{
  return unit_or(v - direction.dot(v) * direction, some_normal(direction));
}

inline Eigen::Matrix3d Part_chart::axes() const
{
  Eigen::Matrix3d result;
  if (is_sheet_) {
    const int last = sheet_stations - 1, middle = last / 2;
    const Point u = station(last, middle) - station(0, middle), v = station(middle, last) - station(middle, 0);
    result.col(0) = unit_or(u, Point::UnitX());
    result.col(1) = across_to(v, result.col(0));
  } else {
    const Eigen::Matrix3d& middle = frames_[curve_stations / 2];
    result.col(0) = unit_or(spine_.rightCols<1>() - spine_.leftCols<1>(), middle.col(0));
    result.col(1) = across_to(middle.col(1), result.col(0));
  }
  result.col(2) = Point(result.col(0)).cross(Point(result.col(1)));
  return result;
}

inline Point Part_chart::half_extents() const
{
  const Eigen::Matrix3d directions = axes();
  Point result = half_;
  for (int axis = 0; axis < (is_sheet_ ? 2 : 1); ++axis) {
    const Eigen::RowVectorXd along = directions.col(axis).transpose() * spine_;
    result[axis] = (along.maxCoeff() - along.minCoeff()) / 2;
  }
  return result;
}

inline void Part_chart::transport_frames(const Point& across)
{
  frames_.resize(curve_stations);
  Point tangent, normal = across;
  for (int i = 0; i < curve_stations; ++i) {
    const Point ahead = spine_.col(std::min(i + 1, curve_stations - 1)) - spine_.col(std::max(i - 1, 0));
    const Point next = unit_or(ahead, i == 0 ? Point(some_normal(unit_or(across, Point::UnitX()))) : tangent);
    if (i > 0) normal = Eigen::Quaterniond::FromTwoVectors(tangent, next) * normal;
    tangent = next;
    normal = across_to(normal, tangent);
    frames_[std::size_t(i)] << tangent, normal, tangent.cross(normal);
  }
}

inline void Part_chart::normal_frames()
{
  frames_.resize(sheet_stations * sheet_stations);
  const int last = sheet_stations - 1;
  for (int i = 0; i <= last; ++i)
    for (int j = 0; j <= last; ++j) {
      const Point u = station(std::min(i + 1, last), j) - station(std::max(i - 1, 0), j);
      const Point v = station(i, std::min(j + 1, last)) - station(i, std::max(j - 1, 0));
      const Point along = unit_or(u, Point::UnitX()), normal = unit_or(along.cross(v), some_normal(along));
      frames_[std::size_t(i * sheet_stations + j)] << along, normal.cross(along), normal;
    }
}

inline Part_chart Part_chart::along(const Points& spine, const Point& across, const Point& half)
{
  Part_chart result;
  result.spine_ = spine;
  result.half_ = half;
  result.transport_frames(across);
  return result;
}

inline Part_chart Part_chart::over(const Points& spine, const Point& half)
{
  Part_chart result;
  result.is_sheet_ = true;
  result.spine_ = spine;
  result.half_ = half;
  result.normal_frames();
  return result;
}

/// The coordinate of the i-th of some stations in a row.
inline double station_coordinate(Eigen::Index i, int stations) { return 2. * double(i) / (stations - 1) - 1; }

/// A cell of a row of stations and the position in it, beyond [0, 1] past the ends.
inline std::pair<int, double> station_cell(double k, int stations)
{
  const double x = (k + 1) / 2 * (stations - 1);
  const int cell = std::clamp(int(std::floor(x)), 0, stations - 2);
  return {cell, x - cell};
}

inline std::pair<Point, Eigen::Matrix3d> Part_chart::locate(const Point& k) const
{
  Point place;
  Eigen::Matrix3d frame;
  const auto [i, f] = station_cell(k[0], stations(is_sheet_));
  const double inside = std::clamp(f, 0., 1.);
  if (is_sheet_) {
    const auto [j, g] = station_cell(k[1], sheet_stations);
    const double inside_g = std::clamp(g, 0., 1.);
    const auto at = [&, i = i, j = j](int a, int b) { return std::size_t((i + a) * sheet_stations + j + b); };
    place = (1 - f) * ((1 - g) * station(i, j) + g * station(i, j + 1)) +
            f * ((1 - g) * station(i + 1, j) + g * station(i + 1, j + 1));
    frame = (1 - inside) * ((1 - inside_g) * frames_[at(0, 0)] + inside_g * frames_[at(0, 1)]) +
            inside * ((1 - inside_g) * frames_[at(1, 0)] + inside_g * frames_[at(1, 1)]);
    place += half_[2] * k[2] * frame.col(2);
  } else {
    place = (1 - f) * spine_.col(i) + f * spine_.col(i + 1);
    frame = (1 - inside) * frames_[std::size_t(i)] + inside * frames_[std::size_t(i + 1)];
    place += half_[1] * k[1] * frame.col(1) + half_[2] * k[2] * frame.col(2);
  }
  return {place, frame};
}

inline double Part_chart::nearest_on_curve(const Point& p) const
{
  const int n = curve_stations;
  double best = std::numeric_limits<double>::infinity(), k = 0;
  for (int i = 0; i + 1 < n; ++i) {
    const Point side = spine_.col(i + 1) - spine_.col(i);
    const double squared = side.squaredNorm();
    double f = squared > 0 ? (p - spine_.col(i)).dot(side) / squared : 0;
    f = std::min(std::max(f, i == 0 ? -double(n) : 0.), i + 2 == n ? double(n) : 1.);
    const double distance = (spine_.col(i) + f * side - p).squaredNorm();
    if (distance < best) best = distance, k = 2 * (i + f) / (n - 1) - 1;
  }
  return k;
}

/// From the nearest station by Gauss-Newton steps.
inline Eigen::Vector2d Part_chart::nearest_on_sheet(const Point& p) const
{
  const int n = sheet_stations;
  Eigen::Index nearest;
  (spine_.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
  Eigen::Vector2d k(station_coordinate(nearest / n, n), station_coordinate(nearest % n, n));
  constexpr int steps = 4;
  for (int step = 0; step < steps; ++step) {
    const auto [i, f] = station_cell(k[0], n);
    const auto [j, g] = station_cell(k[1], n);
    const Point u = ((1 - g) * (station(i + 1, j) - station(i, j)) + g * (station(i + 1, j + 1) - station(i, j + 1)));
    const Point v = ((1 - f) * (station(i, j + 1) - station(i, j)) + f * (station(i + 1, j + 1) - station(i + 1, j)));
    Eigen::Matrix<double, 3, 2> derivative;
    derivative << u * (n - 1) / 2., v * (n - 1) / 2.;
    const Eigen::Matrix2d gram = derivative.transpose() * derivative;
    if (!(gram.determinant() > 1e-14 * gram.trace() * gram.trace())) break;
    const Point offset = p - locate({k[0], k[1], 0}).first;
    const Eigen::Vector2d change = gram.inverse() * (derivative.transpose() * offset);
    k += change.cwiseMax(-0.5).cwiseMin(0.5);
  }
  return k.cwiseMax(-2.).cwiseMin(2.);
}

inline Point Part_chart::coordinates_of_station(Eigen::Index station) const
{
  if (!is_sheet_) return {station_coordinate(station, curve_stations), 0, 0};
  const int n = sheet_stations;
  return {station_coordinate(station / n, n), station_coordinate(station % n, n), 0};
}

inline Point Part_chart::coordinates(const Point& p) const
{
  Point k = Point::Zero();
  if (is_sheet_)
    k.head<2>() = nearest_on_sheet(p);
  else
    k[0] = nearest_on_curve(p);
  const auto [place, frame] = locate(k);
  const Point across = frame.transpose() * (p - place);
  for (int axis = is_sheet_ ? 2 : 1; axis < 3; ++axis)
    k[axis] = across[axis] / half_[axis];
  return k;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#include "map/Part_chart_making.h"

#endif // CGAL_SHAPE_CORRESPONDENCE_MAP_PART_CHART_H
