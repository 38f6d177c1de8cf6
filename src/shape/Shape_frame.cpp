// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Nearest_points.h"
#include "base/directions.h"
#include "base/eigen_system.h"
#include "base/planar_hull.h"
#include "shape/Shape_in_frame.h"
#include "shape/oriented_box.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

/// A candidate of a vertical mirror plane: the points with normal · (x, z) = offset.
struct Mirror_plane
{
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset = 0;
  double residual = std::numeric_limits<double>::infinity(); ///< mean distance of mirror images from the points
};

/// Finds the vertical mirror planes of points of which y is up.
class Mirror_plane_finder
{
public:
  /// \param points samples of the surface \param corners points that include its outermost ones, such as vertices
  Mirror_plane_finder(const Points& points, const Points& corners)
      : points_(points),
        nearest_(points),
        queries_(thinned(points)),
        footprint_(seen_from_above(points)),
        hull_(planar_hull(seen_from_above(corners))),
        extent_(diagonal(corners))
  {
    for (const Eigen::Vector2d& p : footprint_)
      centroid_ += p / double(footprint_.size());
    for (Eigen::Index i = 0; i < queries_.size(); ++i)
      spacing_ += nearest_.distance(points.col(queries_[i]), queries_[i]) / double(queries_.size());
  }

  Eigen::Vector2d rectangle_direction() const
  {
    return hull_.size() < 2 ? Eigen::Vector2d(1, 0) : least_rectangle_direction(hull_);
  }

  /// The candidate of least residual; of about equal ones, the first.
  Mirror_plane best() const
  {
    const double clearly = 0.9; // ratio of residuals below which a later candidate is better
    Mirror_plane result;
    for (const Eigen::Vector2d& direction : candidate_normals()) {
      const Mirror_plane plane = score(direction, clearly * result.residual);
      if (plane.residual < clearly * result.residual) result = plane;
    }
    return refined(tightest_alternative(result));
  }

  /// The best plane at right angles to a plane; `is_mirror()` tells whether it is a mirror plane.
  Mirror_plane crossing(const Mirror_plane& plane) const
  {
    return score(quarter_turn(plane.normal), largest_residual_of_mirrors());
  }

  /// Whether the residual is below the spacing of the samples: mirror images of the samples of a symmetric surface,
  /// which are not samples themselves, are about one spacing away from the nearest sample.
  bool is_mirror(const Mirror_plane& plane) const { return plane.residual < largest_residual_of_mirrors(); }

private:
  double largest_residual_of_mirrors() const { return spacing_ + 0.01 * extent_; }

  /// The better of two planes with a given normal: through the middle of the extent along it, or the centroid. A
  /// residual that is not below the limit may be replaced by infinity, which saves time.
  Mirror_plane score(const Eigen::Vector2d& normal, double limit = std::numeric_limits<double>::infinity()) const
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Eigen::Vector2d& p : hull_) {
      const double x = normal.dot(p);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    Mirror_plane middle = scored({normal, 0.5 * (low + high)}, limit);
    const Mirror_plane centroid = scored({normal, normal.dot(centroid_)}, limit);
    if (std::isinf(middle.residual) && std::isfinite(centroid.residual)) middle = scored(middle);
    return centroid.residual < 0.8 * middle.residual ? centroid : middle;
  }

  static Planar_points seen_from_above(const Points& points)
  {
    Planar_points result;
    for (const auto& p : points.colwise())
      result.emplace_back(p.x(), p.z());
    return result;
  }

  static std::vector<Eigen::Index> sorted_indices(Eigen::Index n, Eigen::Index limit)
  {
    std::vector<Eigen::Index> result;
    for (Eigen::Index i = 0; i < std::min(n, limit); ++i)
      result.push_back(n <= limit ? i : i * n / limit);
    return result;
  }

  static Eigen::Array<Eigen::Index, Eigen::Dynamic, 1> thinned(const Points& points)
  {
    const Eigen::Index most_queries = 600;
    const auto indices = sorted_indices(points.cols(), most_queries);
    return Eigen::Map<const Eigen::Array<Eigen::Index, Eigen::Dynamic, 1>>(indices.data(),
                                                                           Eigen::Index(indices.size()));
  }

  Mirror_plane scored(Mirror_plane plane, double limit = std::numeric_limits<double>::infinity()) const
  {
    constexpr Eigen::Index few = 50; // number of queries of a first test
    constexpr double hopeless = 1.5; // mean distance of these, over the limit, from which on a plane is rejected
    const Eigen::Index n = queries_.size() / few;
    plane.residual = std::numeric_limits<double>::infinity();
    if (n > 1 && mean_distance(plane, n, hopeless * limit) >= hopeless * limit) return plane;
    const double residual = mean_distance(plane, 1, limit);
    if (residual >= limit) return plane;
    // Rounding noise must not decide between planes that are exact symmetries
    const double noise = 0.02; // least residual, over the spacing
    plane.residual = std::max(residual, noise * spacing_);
    return plane;
  }

  /// Mean distance of the mirror images of every n-th query from the points. Summation stops once it reaches the limit.
  double mean_distance(const Mirror_plane& plane, Eigen::Index n, double limit) const
  {
    const Point normal(plane.normal.x(), 0, plane.normal.y());
    const double count = double((queries_.size() + n - 1) / n);
    double sum = 0;
    for (Eigen::Index i = 0; i < queries_.size() && sum / count < limit; i += n) {
      const Point p = points_.col(queries_[i]);
      sum += nearest_.distance(p - 2 * (normal.dot(p) - plane.offset) * normal);
    }
    return sum / count;
  }

  /// Directions found from the points alone, so that they rotate with the shape: the least rectangle around the
  /// footprint, its principal axes, and those of long chords of its hull, which a mirror plane may bisect.
  std::vector<Eigen::Vector2d> candidate_normals() const
  {
    std::vector<Eigen::Vector2d> result{rectangle_direction(), quarter_turn(rectangle_direction())};
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& p : footprint_)
      moments += (p - centroid_) * (p - centroid_).transpose();
    const Eigen::Matrix2d axes = eigenvectors(moments);
    result.push_back(axes.col(1));
    result.push_back(axes.col(0));
    add_chords(result);
    return result;
  }

  void add_chords(std::vector<Eigen::Vector2d>& directions) const
  {
    const std::size_t most_chords = 24;
    std::vector<Eigen::Vector2d> chords;
    for (std::size_t i = 0; i < hull_.size(); ++i) {
      for (std::size_t j = i + 1; j < hull_.size(); ++j)
        chords.push_back(hull_[j] - hull_[i]);
    }
    std::stable_sort(chords.begin(), chords.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return a.squaredNorm() > b.squaredNorm() * (1 + 1e-9);
    });
    std::size_t count = 0;
    for (const Eigen::Vector2d& chord : chords) {
      const double smallest_sine = 0.01; // of the angle to directions that are candidates already
      const auto known = [&](const Eigen::Vector2d& d) {
        return std::abs(cross(d, chord)) < smallest_sine * chord.norm();
      };
      if (count < most_chords && chord.norm() > 0 && std::none_of(directions.begin(), directions.end(), known)) {
        directions.push_back(chord.normalized());
        ++count;
      }
    }
  }

  double rectangle_area(const Eigen::Vector2d& side) const
  {
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Eigen::Vector2d& p : hull_) {
      const Eigen::Array2d x(side.dot(p), quarter_turn(side).dot(p));
      low = low.min(x);
      high = high.max(x);
    }
    return (high - low).prod();
  }

  /// Sum of |x z| over the points, with their distances x from the plane and z from the best plane at right angles to
  /// it: large if the points reach into the corners of a box along these planes.
  double cornering(const Mirror_plane& plane) const
  {
    const Mirror_plane crossing = score(quarter_turn(plane.normal));
    double sum = 0;
    for (const Eigen::Vector2d& p : footprint_)
      sum += std::abs((plane.normal.dot(p) - plane.offset) * (crossing.normal.dot(p) - crossing.offset));
    return sum;
  }

  /// The plane, or the one turned by 45 degrees if that is as good a mirror plane and better aligned: along the sides
  /// of a square table, not its diagonals; for a disc on four legs, with the legs in the corners of the box.
  Mirror_plane tightest_alternative(const Mirror_plane& plane) const
  {
    const double as_good = 1.3, tighter = 0.99, clearly = 0.8; // ratios of residuals, areas and `cornering()`
    if (!is_mirror(plane)) return plane;
    const double limit = as_good * plane.residual;
    const Mirror_plane diagonal = score(Eigen::Rotation2Dd(double(0.25 * EIGEN_PI)) * plane.normal, limit);
    if (!(diagonal.residual < limit)) return plane;
    const double area = rectangle_area(plane.normal), diagonal_area = rectangle_area(diagonal.normal);
    const bool is_round = diagonal_area > tighter * area && area > tighter * diagonal_area;
    const bool better = is_round ? cornering(plane) < clearly * cornering(diagonal) : diagonal_area < tighter * area;
    return better ? diagonal : plane;
  }

  /// Searches directions near a plane for a smaller residual, unless that of the plane is below half of the spacing.
  Mirror_plane refined(Mirror_plane plane) const
  {
    const double clearly = 0.95; // samples alone change a residual by a few hundredths
    if (plane.residual < 0.5 * spacing_) return plane;
    for (double step = 0.08; step > 0.002; step *= 0.5) {
      const Mirror_plane start = plane;
      for (const double angle : {-step, step}) {
        const double limit = clearly * plane.residual;
        const Mirror_plane turned = score(Eigen::Rotation2Dd(angle) * start.normal, limit);
        if (turned.residual < limit) plane = turned;
      }
    }
    return plane;
  }

  Points points_;
  Nearest_points nearest_;
  Eigen::Array<Eigen::Index, Eigen::Dynamic, 1> queries_;
  Planar_points footprint_;
  Planar_points hull_; ///< convex hull of the corners
  Eigen::Vector2d centroid_ = Eigen::Vector2d::Zero();
  double extent_ = 0;
  double spacing_ = 0;
};

/// The rotation of least angle that maps `up` to y.
Eigen::Matrix3d upright_rotation(const Point& up) { return least_rotation(up, Point::UnitY()).toRotationMatrix(); }

/// The rotation about y that maps the x axis to a horizontal direction (x, z).
Eigen::Matrix3d axes_of_side(const Eigen::Vector2d& side)
{
  Eigen::Matrix3d result;
  result.col(0) = Point(side.x(), 0, side.y()).normalized();
  result.col(1) = Point::UnitY();
  result.col(2) = result.col(0).cross(result.col(1));
  return result;
}

/// Of a direction and its quarter turns, the one nearest to the x axis.
Eigen::Vector2d side_nearest_to_x(const Eigen::Vector2d& direction)
{
  const double clearly = 1e-6;
  Eigen::Vector2d result = direction, candidate = direction;
  for (int turn = 1; turn < 4; ++turn) {
    candidate = quarter_turn(candidate);
    if (candidate.x() > result.x() + clearly) result = candidate;
  }
  return result;
}

/// Of a direction and its opposite, the x axis for which the front (z axis) points to +z or, if neither does, to +x.
Eigen::Vector2d side_with_front(const Eigen::Vector2d& direction)
{
  const double clearly = 0.01; // least component that decides: more than the error of a mirror plane's normal
  const Point front = axes_of_side(direction).col(2);
  const bool keep = std::abs(front.z()) > clearly ? front.z() > 0 : front.x() > 0;
  return keep ? direction : Eigen::Vector2d(-direction);
}

/// Sets the axes and mirror flags; y is up. \param offset_along_mirror set to the offsets of the mirror planes across x
/// and z; NaN where there is none
void orient(Shape_frame& frame, const Points& points, const Points& corners, Eigen::Vector2d& offset_along_mirror)
{
  const Mirror_plane_finder finder(points, corners);
  const Mirror_plane best = finder.best();
  const Mirror_plane crossing = finder.crossing(best);
  Eigen::Vector2d side;
  if (!finder.is_mirror(best)) {
    side = side_nearest_to_x(finder.rectangle_direction());
  } else if (finder.is_mirror(crossing)) {
    side = side_nearest_to_x(best.normal);
    frame.mirror_x = frame.mirror_z = true;
  } else {
    side = side_with_front(best.normal);
    frame.mirror_x = true;
  }
  frame.axes = axes_of_side(side);
  const auto along = [&](const Mirror_plane& plane, int axis) {
    const Eigen::Vector2d direction(frame.axes(0, axis), frame.axes(2, axis));
    return plane.offset * plane.normal.dot(direction);
  };
  const bool x_is_best = std::abs(side.dot(best.normal)) > 0.5;
  const double none = std::numeric_limits<double>::quiet_NaN();
  offset_along_mirror = Eigen::Vector2d(frame.mirror_x ? along(x_is_best ? best : crossing, 0) : none,
                                        frame.mirror_z ? along(x_is_best ? crossing : best, 2) : none);
}

/// Sets the height, and the origin: on the ground, on the mirror planes, else in the middle of the extent.
void place(Shape_frame& frame, const Points& corners, const Eigen::Vector2d& offset_along_mirror)
{
  const double flattest = 1e-3; // ratio to the largest extent, up to which the extent along y is not the height
  const Points turned = frame.axes.transpose() * corners;
  const Point low = turned.rowwise().minCoeff(), high = turned.rowwise().maxCoeff();
  Point origin(0.5 * (low.x() + high.x()), low.y(), 0.5 * (low.z() + high.z()));
  for (Eigen::Index k = 0; k < 2; ++k)
    if (std::isfinite(offset_along_mirror[k])) origin[2 * k] = offset_along_mirror[k];
  const double largest = (high - low).maxCoeff();
  frame.origin = frame.axes * origin;
  frame.height = high.y() - low.y() > flattest * largest ? high.y() - low.y() : largest;
  if (!(frame.height > 0)) frame.height = 1;
}

} // namespace

Points Shape_frame::to_frame(const Points& world) const
{
  return (axes.transpose() * (world.colwise() - origin)) / height;
}

Points Shape_frame::to_world(const Points& local) const { return (axes * local * height).colwise() + origin; }

Shape_frame compute_shape_frame(const Points& surface, const Point& up)
{
  CGAL_precondition(surface.cols() > 0);
  return internal::frame_of_samples(surface, surface, up);
}

Shape_frame internal::frame_of_samples(const Points& surface, const Points& vertices, const Point& up)
{
  const Eigen::Matrix3d upright = upright_rotation(up);
  // Relative to the middle, so that a shape far from the origin loses no digits.
  const Point middle = 0.5 * (vertices.rowwise().minCoeff() + vertices.rowwise().maxCoeff());
  const Points points = upright * (surface.colwise() - middle), corners = upright * (vertices.colwise() - middle);
  Shape_frame result;
  Eigen::Vector2d offset_along_mirror;
  orient(result, points, corners, offset_along_mirror);
  place(result, corners, offset_along_mirror);
  result.axes = upright.transpose() * result.axes;
  result.origin = upright.transpose() * result.origin + middle;
  return result;
}

} // namespace CGAL::Shape_correspondence
