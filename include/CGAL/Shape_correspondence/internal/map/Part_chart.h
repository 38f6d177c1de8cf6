// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CHART_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CHART_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/internal/planar_hull.h>

#include <Eigen/Eigenvalues>
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
  /// The chart between two of one kind: rotated by a part of the rotation between them, the rest linear.
  static Part_chart between(const Part_chart& a, const Part_chart& b, double t);

private:
  using Frames = std::vector<Eigen::Matrix3d>;

  static Part_chart along(const Points& spine, const Point& across, const Point& half);
  static Part_chart over(const Points& spine, const Point& half);
  static int stations(bool is_sheet) { return is_sheet ? sheet_stations : curve_stations; }

  std::pair<Point, Eigen::Matrix3d> locate(const Point& k) const;
  Eigen::Vector2d nearest_on_spine(const Point& p) const;
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

/// The angle by which a rectangle of least area around points in the plane is turned, between -45° and 45°; of nearly
/// as small ones the one turned least, so that a round cross-section has the axes that it is seen in.
inline double least_rectangle_angle(const Planar_points& points)
{
  constexpr double nearly = 1.02;
  const Planar_points hull = planar_hull(points);
  const auto area = [&](double angle) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-angle).toRotationMatrix();
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : hull)
      box.extend(turn * p);
    return box.sizes().prod();
  };
  const Eigen::Vector2d direction = least_rectangle_direction(hull);
  const double angle = std::remainder(std::atan2(direction.y(), direction.x()), EIGEN_PI / 2);
  return area(0) <= nearly * area(angle) ? 0 : angle;
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

inline Eigen::Vector2d Part_chart::nearest_on_spine(const Point& p) const
{
  const int n = stations(is_sheet_);
  if (!is_sheet_) {
    double best = std::numeric_limits<double>::infinity(), k = 0;
    for (int i = 0; i + 1 < n; ++i) {
      const Point side = spine_.col(i + 1) - spine_.col(i);
      const double squared = side.squaredNorm();
      double f = squared > 0 ? (p - spine_.col(i)).dot(side) / squared : 0;
      f = std::min(std::max(f, i == 0 ? -double(n) : 0.), i + 2 == n ? double(n) : 1.);
      const double distance = (spine_.col(i) + f * side - p).squaredNorm();
      if (distance < best) best = distance, k = 2 * (i + f) / (n - 1) - 1;
    }
    return {k, 0};
  }
  // From the nearest station by Gauss-Newton steps
  Eigen::Index nearest;
  (spine_.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
  Eigen::Vector2d k(2. * double(nearest / n) / (n - 1) - 1, 2. * double(nearest % n) / (n - 1) - 1);
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

inline Point Part_chart::coordinates(const Point& p) const
{
  const Eigen::Vector2d on_spine = nearest_on_spine(p);
  Point k(on_spine[0], on_spine[1], 0);
  if (!is_sheet_) k[1] = 0;
  const auto [place, frame] = locate(k);
  const Point across = frame.transpose() * (p - place);
  for (int axis = is_sheet_ ? 2 : 1; axis < 3; ++axis)
    k[axis] = across[axis] / half_[axis];
  return k;
}

inline Part_chart Part_chart::restricted(const Point& low, const Point& high) const
{
  const Point middle = (low + high) / 2, half = (high - low) / 2;
  const auto inside = [&](double x, double y) {
    Point k = middle + half.cwiseProduct(Point(x, y, 0));
    if (!is_sheet_) k[1] = middle[1];
    return k;
  };
  const Point extents = half_.cwiseProduct(half).cwiseMax(least_half_extent);
  const int n = stations(is_sheet_);
  Points spine(3, spine_.cols());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < (is_sheet_ ? n : 1); ++j)
      spine.col(is_sheet_ ? i * n + j : i) = (*this)(inside(2. * i / (n - 1) - 1, 2. * j / (n - 1) - 1));
  if (is_sheet_) return over(spine, extents);
  return along(spine, frame(inside(-1, 0)).col(1), extents);
}

inline Part_chart Part_chart::fitted(const Points& surface) const
{
  Part_chart result = *this;
  constexpr int rounds = 2; // moving the spine into the middle of a bent part moves the coordinates a little
  for (int round = 0; round < rounds; ++round) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index i = 0; i < surface.cols(); ++i)
      box.extend(result.coordinates(surface.col(i)));
    const Point least = Point::Constant(least_half_extent), middle = box.center();
    result = result.restricted(box.min().cwiseMin(middle - least), box.max().cwiseMax(middle + least));
  }
  return result;
}

inline Part_chart Part_chart::centred(const Points& surface) const
{
  const int n = stations(is_sheet_);
  const double reach = is_sheet_ ? 2. / (n - 1) : 4. / (n - 1); // of a station, in coordinates
  const Eigen::Index count = spine_.cols();
  Points low = Points::Constant(3, count, std::numeric_limits<double>::infinity()), high = -low;
  for (Eigen::Index i = 0; i < surface.cols(); ++i) {
    const Point k = coordinates(surface.col(i));
    for (Eigen::Index s = 0; s < count; ++s) {
      const double first = 2. * double(is_sheet_ ? s / n : s) / (n - 1) - 1, second = 2. * double(s % n) / (n - 1) - 1;
      if (std::abs(k[0] - first) > reach || (is_sheet_ && std::abs(k[1] - second) > reach)) continue;
      low.col(s) = low.col(s).cwiseMin(k);
      high.col(s) = high.col(s).cwiseMax(k);
    }
  }
  Points spine = spine_;
  for (Eigen::Index s = 0; s < count; ++s) {
    if (!(low(2, s) <= high(2, s))) continue;
    for (int axis = is_sheet_ ? 2 : 1; axis < 3; ++axis)
      spine.col(s) += (low(axis, s) + high(axis, s)) / 2 * half_[axis] * frames_[std::size_t(s)].col(axis);
  }
  const Part_chart moved = (is_sheet_ ? over(spine, half_) : along(spine, frames_[0].col(1), half_)).fitted(surface);
  const auto section = [](const Part_chart& chart) { return (chart.is_sheet_ ? 1 : chart.half_[1]) * chart.half_[2]; };
  return section(moved) < section(*this) ? moved : *this;
}

inline Part_chart Part_chart::box(const Points& surface, const Eigen::Matrix3d& axes)
{
  const Points local = axes.transpose() * surface;
  const Point low = local.rowwise().minCoeff(), high = local.rowwise().maxCoeff();
  const Point half = ((high - low) / 2).cwiseMax(least_half_extent), middle = (low + high) / 2;
  Points spine(3, curve_stations);
  for (int i = 0; i < curve_stations; ++i)
    spine.col(i) = axes * (middle + Point((2. * i / (curve_stations - 1) - 1) * half[0], 0, 0));
  return along(spine, axes.col(1), half);
}

inline Part_chart Part_chart::plate(const Points& surface, const Eigen::Matrix3d& axes)
{
  const Points local = axes.transpose() * surface;
  const Point low = local.rowwise().minCoeff(), high = local.rowwise().maxCoeff();
  const Point half = ((high - low) / 2).cwiseMax(least_half_extent), middle = (low + high) / 2;
  Points spine(3, sheet_stations * sheet_stations);
  const double step = 2. / (sheet_stations - 1);
  for (int i = 0; i < sheet_stations; ++i)
    for (int j = 0; j < sheet_stations; ++j)
      spine.col(i * sheet_stations + j) = axes * (middle + half.cwiseProduct(Point(i * step - 1, j * step - 1, 0)));
  return over(spine, half);
}

inline Part_chart Part_chart::symmetrised(const Eigen::Matrix3d& turn) const
{
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  const int n = stations(is_sheet_);
  Points spine(3, spine_.cols());
  for (Eigen::Index s = 0; s < spine.cols(); ++s) {
    const Point k(2. * double(is_sheet_ ? s / n : s) / (n - 1) - 1, is_sheet_ ? 2. * double(s % n) / (n - 1) - 1 : 0,
                  0);
    spine.col(s) = (spine_.col(s) + mirror * (*this)(turn * k)) / 2;
  }
  if (is_sheet_) return over(spine, half_);
  Point across = frames_[0].col(1);
  if (turn(0, 0) > 0)
    across = std::abs(across.x()) > std::sqrt(0.5) ? Point(across.x(), 0, 0) : Point(0, across.y(), across.z());
  return along(spine, across, half_);
}

inline Part_chart Part_chart::image() const
{
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  const Points spine = mirror * spine_;
  return is_sheet_ ? over(spine, half_) : along(spine, mirror * frames_[0].col(1), half_);
}

inline Part_chart Part_chart::turned(const Eigen::Matrix3d& turn) const
{
  const Point half = (turn.transpose() * half_).cwiseAbs();
  Points spine(3, spine_.cols());
  if (!is_sheet_) {
    const bool ahead = turn(0, 0) > 0;
    spine = ahead ? spine_ : Points(spine_.rowwise().reverse());
    const Eigen::Matrix3d start = frames_[ahead ? 0 : curve_stations - 1] * turn;
    return along(spine, start.col(1), half);
  }
  const double step = 2. / (sheet_stations - 1);
  for (int i = 0; i < sheet_stations; ++i)
    for (int j = 0; j < sheet_stations; ++j) {
      const Point k = turn * Point(i * step - 1, j * step - 1, 0);
      const int row = int(std::lround((k[0] + 1) / step)), col = int(std::lround((k[1] + 1) / step));
      spine.col(i * sheet_stations + j) = station(row, col);
    }
  return over(spine, half);
}

inline Eigen::Matrix3d Part_chart::lengthwise_turn() const
{
  const Point half = half_extents();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (is_sheet_ && half[1] > half[0]) turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return turn;
}

inline Part_chart Part_chart::lengthwise() const
{
  if (!is_sheet_) return *this;
  const Eigen::Matrix3d turn = lengthwise_turn();
  Points spine(3, curve_stations);
  for (int i = 0; i < curve_stations; ++i)
    spine.col(i) = (*this)(turn * Point(2. * i / (curve_stations - 1) - 1, 0, 0));
  const Point half = (turn.transpose() * half_extents()).cwiseAbs();
  return along(spine, (frame(turn * Point(-1, 0, 0)) * turn).col(1), half);
}

inline Part_chart Part_chart::between(const Part_chart& a, const Part_chart& b, double t)
{
  const Point centre_a = a.spine_.rowwise().mean(), centre_b = b.spine_.rowwise().mean();
  const Eigen::Matrix3d rotation = b.axes() * a.axes().transpose();
  const Eigen::Quaterniond whole(rotation), part = Eigen::Quaterniond::Identity().slerp(t, whole);
  const Points shape =
      (1 - t) * (a.spine_.colwise() - centre_a) + t * (rotation.transpose() * (b.spine_.colwise() - centre_b));
  const Points spine = (part.toRotationMatrix() * shape).colwise() + ((1 - t) * centre_a + t * centre_b);
  const Point half = (1 - t) * a.half_ + t * b.half_;
  if (a.is_sheet_) return over(spine, half);
  const Point from = a.frames_[0].col(1), to = rotation.transpose() * b.frames_[0].col(1);
  const Point across = part * unit_or((1 - t) * from + t * to, from);
  return along(spine, across, half);
}

inline Part_chart Part_chart::around(const Part_abstraction& part, const Points& control_points, const Points& surface)
{
  if (const Sheet* given = std::get_if<Sheet>(&part.geometry)) {
    const Sheet sheet{control_points, given->rows, given->cols};
    Points spine(3, sheet_stations * sheet_stations);
    for (int i = 0; i < sheet_stations; ++i)
      for (int j = 0; j < sheet_stations; ++j)
        spine.col(i * sheet_stations + j) = sheet(double(i) / (sheet_stations - 1), double(j) / (sheet_stations - 1));
    return over(spine, Point::Ones()).fitted(surface);
  }
  const Curve curve{control_points, std::get<Curve>(part.geometry).closed};
  Points spine(3, curve_stations);
  for (int i = 0; i < curve_stations; ++i)
    spine.col(i) = curve(double(i) / (curve_stations - 1));
  Eigen::Matrix3d axes;
  if (curve.closed) {
    const Points centred = spine.colwise() - spine.rowwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred * centred.transpose());
    const Point normal = solver.eigenvectors().col(0);
    axes << some_normal(normal), normal.cross(some_normal(normal)), normal;
  } else {
    const Point direction = unit_or(spine.col(1) - spine.col(0), Point::UnitY());
    axes << direction, some_normal(direction), direction.cross(some_normal(direction));
  }
  // Coordinates across are turned to the least rectangle
  const int first = curve.closed ? 0 : 1;
  const Part_chart chart = curve.closed ? box(surface, axes) : along(spine, axes.col(1), Point::Ones());
  Planar_points section;
  for (Eigen::Index i = 0; i < surface.cols(); ++i) {
    const Point k = chart.coordinates(surface.col(i)).cwiseProduct(curve.closed ? chart.half_extents() : chart.half_);
    section.emplace_back(k[first], k[first + 1]);
  }
  const Eigen::AngleAxisd turn(least_rectangle_angle(section), Point(axes.col(curve.closed ? 2 : 0)));
  if (curve.closed) return box(surface, turn * axes);
  return along(spine, turn * axes.col(1), Point::Ones()).fitted(surface);
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CHART_H
