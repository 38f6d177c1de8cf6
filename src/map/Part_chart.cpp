// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Part_chart.h"

#include "base/clamped.h"
#include "base/directions.h"
#include "base/eigen_system.h"
#include "base/planar_hull.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Unit vector of the component of `v` perpendicular to the unit vector `direction`.
Point across_to(const Point& v, const Point& direction)
{
  return unit_or(v - direction.dot(v) * direction, some_normal(direction));
}

/// The coordinate, in [-1, 1], of the i-th station in a row.
double station_coordinate(Eigen::Index i, int stations) { return 2. * double(i) / (stations - 1) - 1; }

/// The cell between stations that contains coordinate k, and the position in it, outside of [0, 1] beyond the ends.
std::pair<int, double> station_cell(double k, int stations)
{
  const double x = (k + 1) / 2 * (stations - 1);
  const int cell = clamped_cell(x, stations - 2);
  return {cell, x - cell};
}

/// The rotation angle of a bounding rectangle of least area around points in the plane, between -45° and 45°; 0 if that
/// is nearly as good, so that a round cross-section keeps its axes.
double least_rectangle_angle(const Planar_points& points)
{
  constexpr double nearly = 1.02; // ratio to the least area, up to which a rectangle is nearly as good
  const Planar_points hull = planar_hull(points);
  const auto area = [&](double angle) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-angle).toRotationMatrix();
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : hull)
      box.extend(turn * p);
    return box.sizes().prod();
  };
  const Eigen::Vector2d direction = least_rectangle_direction(hull);
  const auto angle = double(std::remainder(std::atan2(direction.y(), direction.x()), EIGEN_PI / 2));
  return area(0) <= nearly * area(angle) ? 0 : angle;
}

/// The stations along a sheet, row by row, or along a curve.
Points spine_of(const Sheet& sheet)
{
  constexpr int n = Part_chart::sheet_stations;
  Points spine(3, n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      spine.col(i * n + j) = sheet(double(i) / (n - 1), double(j) / (n - 1));
  return spine;
}

Points spine_of(const Curve& curve)
{
  constexpr int n = Part_chart::curve_stations;
  Points spine(3, n);
  for (int i = 0; i < n; ++i)
    spine.col(i) = curve(double(i) / (n - 1));
  return spine;
}

/// Axes, the last of which is the normal of the plane nearest to a closed curve.
Eigen::Matrix3d axes_of_ring(const Points& spine)
{
  const Points centred = spine.colwise() - spine.rowwise().mean();
  const Point normal = eigen_system(scatter_matrix(centred)).vectors.col(0), side = some_normal(normal);
  Eigen::Matrix3d axes;
  axes << side, normal.cross(side), normal;
  return axes;
}

/// The rotation angle of the least rectangle around the surface, projected along the first coordinate of a curve's
/// chart, or along the last one of a box. \param first the first of the two coordinates of the projection
double section_angle(const Part_chart& chart, const Points& surface, const Point& half, int first)
{
  Planar_points section;
  for (Eigen::Index i = 0; i < surface.cols(); ++i) {
    const Point k = chart.coordinates(surface.col(i)).cwiseProduct(half);
    section.emplace_back(k[first], k[first + 1]);
  }
  return least_rectangle_angle(section);
}

} // namespace

Eigen::Matrix3d Part_chart::axes() const
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

Point Part_chart::half_extents() const
{
  const Eigen::Matrix3d directions = axes();
  Point result = half_;
  for (int axis = 0; axis < (is_sheet_ ? 2 : 1); ++axis) {
    const Eigen::RowVectorXd along = directions.col(axis).transpose() * spine_;
    result[axis] = (along.maxCoeff() - along.minCoeff()) / 2;
  }
  return result;
}

void Part_chart::transport_frames(const Point& across)
{
  frames_.resize(curve_stations);
  Point tangent, normal = across;
  for (int i = 0; i < curve_stations; ++i) {
    const Point ahead = spine_.col(std::min(i + 1, curve_stations - 1)) - spine_.col(std::max(i - 1, 0));
    const Point next = unit_or(ahead, i == 0 ? Point(some_normal(unit_or(across, Point::UnitX()))) : tangent);
    if (i > 0) normal = least_rotation(tangent, next) * normal;
    tangent = next;
    normal = across_to(normal, tangent);
    frames_[std::size_t(i)] << tangent, normal, tangent.cross(normal);
  }
}

void Part_chart::normal_frames()
{
  frames_.resize(std::size_t{sheet_stations} * sheet_stations);
  const int last = sheet_stations - 1;
  for (int i = 0; i <= last; ++i)
    for (int j = 0; j <= last; ++j) {
      const Point u = station(std::min(i + 1, last), j) - station(std::max(i - 1, 0), j);
      const Point v = station(i, std::min(j + 1, last)) - station(i, std::max(j - 1, 0));
      const Point along = unit_or(u, Point::UnitX()), normal = unit_or(along.cross(v), some_normal(along));
      frames_[std::size_t(i * sheet_stations + j)] << along, normal.cross(along), normal;
    }
}

Part_chart Part_chart::along(const Points& spine, const Point& across, const Point& half)
{
  Part_chart result;
  result.spine_ = spine;
  result.half_ = half;
  result.transport_frames(across);
  return result;
}

Part_chart Part_chart::over(const Points& spine, const Point& half)
{
  Part_chart result;
  result.is_sheet_ = true;
  result.spine_ = spine;
  result.half_ = half;
  result.normal_frames();
  return result;
}

std::pair<Point, Eigen::Matrix3d> Part_chart::locate(const Point& k) const
{
  Point place;
  Eigen::Matrix3d frame;
  const auto [i, f] = station_cell(k[0], stations(is_sheet_));
  const double inside = clamped_to_unit(f);
  if (is_sheet_) {
    const auto [j, g] = station_cell(k[1], sheet_stations);
    const double inside_g = clamped_to_unit(g);
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

double Part_chart::nearest_on_curve(const Point& p) const
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

/// The parameters of the nearest point, by Gauss-Newton steps from the nearest station.
Eigen::Vector2d Part_chart::nearest_on_sheet(const Point& p) const
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

Point Part_chart::coordinates_of_station(Eigen::Index station, bool is_sheet)
{
  if (!is_sheet) return {station_coordinate(station, curve_stations), 0, 0};
  const int n = sheet_stations;
  return {station_coordinate(station / n, n), station_coordinate(station % n, n), 0};
}

Point Part_chart::coordinates(const Point& p) const
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

Part_chart Part_chart::straight(const Points& surface, const Eigen::Matrix3d& axes, bool is_sheet)
{
  const Points local = axes.transpose() * surface;
  const Point low = local.rowwise().minCoeff(), high = local.rowwise().maxCoeff();
  const Point half = ((high - low) / 2).cwiseMax(least_half_extent), middle = (low + high) / 2;
  Points spine(3, is_sheet ? sheet_stations * sheet_stations : curve_stations);
  for (Eigen::Index s = 0; s < spine.cols(); ++s)
    spine.col(s) = axes * (middle + half.cwiseProduct(coordinates_of_station(s, is_sheet)));
  return is_sheet ? over(spine, half) : along(spine, axes.col(1), half);
}

Part_chart Part_chart::around(const Part_abstraction& part, const Points& control_points, const Points& surface)
{
  const bool is_point = (control_points.rowwise().maxCoeff() - control_points.rowwise().minCoeff()).maxCoeff() <
                        2 * least_half_extent; // smaller extents would be rounding noise
  if (is_point) return straight(surface, Eigen::Matrix3d::Identity(), part.is_sheet());
  if (const Sheet* given = std::get_if<Sheet>(&part.geometry))
    return over(spine_of(Sheet{control_points, given->rows, given->cols}), Point::Ones()).fitted(surface);
  const Curve curve{control_points, std::get<Curve>(part.geometry).closed};
  const Points spine = spine_of(curve);
  if (curve.closed) {
    const Eigen::Matrix3d axes = axes_of_ring(spine);
    const Part_chart straight = box(surface, axes);
    const double angle = section_angle(straight, surface, straight.half_extents(), 0);
    return box(surface, Eigen::AngleAxisd(angle, Point(axes.col(2))) * axes);
  }
  const Point direction = unit_or(spine.col(1) - spine.col(0), Point::UnitY()), across = some_normal(direction);
  const Part_chart chart = along(spine, across, Point::Ones());
  const Eigen::AngleAxisd turn(section_angle(chart, surface, chart.half_, 1), direction);
  return along(spine, turn * across, Point::Ones()).fitted(surface);
}

Part_chart Part_chart::restricted(const Point& low, const Point& high) const
{
  const Point middle = (low + high) / 2, half = (high - low) / 2;
  const auto inside = [&](double x, double y) {
    Point k = middle + half.cwiseProduct(Point(x, y, 0));
    if (!is_sheet_) k[1] = middle[1];
    return k;
  };
  const Point extents = half_.cwiseProduct(half).cwiseMax(least_half_extent);
  Points spine(3, spine_.cols());
  for (Eigen::Index s = 0; s < spine.cols(); ++s) {
    const Point k = coordinates_of_station(s, is_sheet_);
    spine.col(s) = (*this)(inside(k[0], k[1]));
  }
  if (is_sheet_) return over(spine, extents);
  return along(spine, frame(inside(-1, 0)).col(1), extents);
}

Part_chart Part_chart::fitted(const Points& surface) const
{
  Part_chart result = *this;
  constexpr int rounds = 2; // centring the spine of a bent part changes the coordinates slightly
  for (int round = 0; round < rounds; ++round) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index i = 0; i < surface.cols(); ++i)
      box.extend(result.coordinates(surface.col(i)));
    const Point middle = box.center();
    const Point least =
        (least_half_extent * result.half_extents().cwiseInverse()).cwiseMax(least_half_extent).cwiseMin(1);
    result = result.restricted(box.min().cwiseMin(middle - least), box.max().cwiseMax(middle + least));
  }
  return result;
}

Part_chart Part_chart::centred(const Points& surface) const
{
  const int n = stations(is_sheet_);
  const double reach = is_sheet_ ? 2. / (n - 1) : 4. / (n - 1); // radius of a station's neighbourhood, in coordinates
  const Eigen::Index count = spine_.cols();
  Points low = Points::Constant(3, count, std::numeric_limits<double>::infinity()), high = -low;
  for (Eigen::Index i = 0; i < surface.cols(); ++i) {
    const Point k = coordinates(surface.col(i));
    for (Eigen::Index s = 0; s < count; ++s) {
      const Point centre = coordinates_of_station(s, is_sheet_);
      if (std::abs(k[0] - centre[0]) > reach || (is_sheet_ && std::abs(k[1] - centre[1]) > reach)) continue;
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

Part_chart Part_chart::turned(const Eigen::Matrix3d& turn) const
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
  for (Eigen::Index s = 0; s < spine.cols(); ++s) {
    const Point k = turn * coordinates_of_station(s, true);
    spine.col(s) = station(int(std::lround((k[0] + 1) / step)), int(std::lround((k[1] + 1) / step)));
  }
  return over(spine, half);
}

Eigen::Matrix3d Part_chart::lengthwise_turn() const
{
  const Point half = half_extents();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (is_sheet_ && half[1] > half[0]) turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return turn;
}

Part_chart Part_chart::lengthwise() const
{
  if (!is_sheet_) return *this;
  const Eigen::Matrix3d turn = lengthwise_turn();
  Points spine(3, curve_stations);
  for (int i = 0; i < curve_stations; ++i)
    spine.col(i) = (*this)(turn * Point(station_coordinate(i, curve_stations), 0, 0));
  const Point half = (turn.transpose() * half_extents()).cwiseAbs();
  return along(spine, (frame(turn * Point(-1, 0, 0)) * turn).col(1), half);
}

Part_chart Part_chart::between(const Part_chart& a, const Part_chart& b, double t)
{
  CGAL_precondition(a.is_sheet_ == b.is_sheet_);
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

} // namespace CGAL::Shape_correspondence::internal
