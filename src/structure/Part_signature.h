// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace symmetry {

/// Numbers of samples of an abstraction whose part has no surface.
constexpr int sheet_samples = 16; ///< number along each side of a sheet
constexpr int curve_samples = 64;
/// Limits for congruent parts.
constexpr double area_ratio = 1.35;    ///< largest ratio of areas
constexpr double volume_ratio = 1.5;   ///< largest ratio of volumes, which are uncertain for open meshes
constexpr double largest_factor = 2.5; ///< largest single deviation, over the allowed mean deviation

/// Directions of support functions: lattice points on a cube, which reflections in coordinate planes permute.
class Directions
{
public:
  explicit Directions(int half_size)
  {
    for (int x = -half_size; x <= half_size; ++x)
      for (int y = -half_size; y <= half_size; ++y)
        for (int z = -half_size; z <= half_size; ++z)
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == half_size) lattice_.emplace_back(x, y, z);
    vectors_.resize(lattice_.size(), 3);
    weights_.resize(lattice_.size());
    for (std::size_t i = 0; i < lattice_.size(); ++i) {
      const double length = lattice_[i].cast<double>().norm();
      vectors_.row(i) = lattice_[i].cast<double>() / length;
      weights_[i] = 1 / (length * length * length); // solid angle of a lattice cell, up to a factor
    }
    weights_ /= weights_.sum();
  }

  Eigen::Index size() const { return vectors_.rows(); }
  const Eigen::MatrixX3d& vectors() const { return vectors_; }
  const Eigen::VectorXd& weights() const { return weights_; }

  /// Index of the opposite direction. The lattice is symmetric, and its points are in lexicographic order.
  Eigen::Index opposite(Eigen::Index i) const { return size() - 1 - i; }

  /// The permutation of the directions by reflection along an axis.
  std::vector<Eigen::Index> mirrored(int axis) const
  {
    std::vector<Eigen::Index> result;
    for (Eigen::Vector3i v : lattice_) {
      v[axis] = -v[axis];
      result.push_back(std::find(lattice_.begin(), lattice_.end(), v) - lattice_.begin());
    }
    return result;
  }

private:
  std::vector<Eigen::Vector3i> lattice_;
  Eigen::MatrixX3d vectors_;
  Eigen::VectorXd weights_;
};

inline const Directions& support_directions()
{
  static const Directions directions(2);
  return directions;
}

/// Mean distance of a point of the set from its nearest neighbour.
inline double spacing(const Points& points)
{
  double sum = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    Eigen::ArrayXd squared = (points.colwise() - points.col(i)).colwise().squaredNorm().array();
    squared[i] = std::numeric_limits<double>::infinity();
    sum += std::sqrt(squared.minCoeff());
  }
  return points.cols() > 1 ? sum / double(points.cols()) : 0;
}

/// Support function of the points in the given directions.
inline Eigen::VectorXd support(const Eigen::MatrixX3d& directions, const Points& points)
{
  return (directions * points).rowwise().maxCoeff();
}

/// The measures of a part by which congruence is decided, in frame coordinates. Points are relative to `centre`, the
/// Steiner point of the convex hull, which moves with the part and does not depend on its mesh.
struct Part_signature
{
  Point centre = Point::Zero();
  Points extremes;         ///< vertices of the hull
  Points surface;          ///< points spread over the surface
  Eigen::VectorXd support; ///< support function of the hull in `support_directions()`
  double spacing = 0;      ///< mean distance of nearest neighbours in `surface`
  double width = 0;        ///< mean of `support`: half of the mean width
  double diagonal = 0;     ///< diagonal of the bounding box
  double volume = 0;
  double area = 0;
};

/// The points that are extreme in one of the directions of a fine lattice.
inline Points extreme_points(const Points& points)
{
  static const Directions directions(4);
  if (points.cols() <= directions.size()) return points;
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index d = 0; d < directions.size(); ++d) {
    Eigen::Index best;
    (directions.vectors().row(d) * points).maxCoeff(&best);
    chosen.push_back(best);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Points result(3, chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    result.col(i) = points.col(chosen[i]);
  return result;
}

inline Part_signature make_signature(const Part_abstraction& part, const Shape_frame& frame)
{
  const Directions& directions = support_directions();
  Part_signature result;
  const bool has_surface = part.surface.cols() > 0;
  const Points samples = has_surface ? part.surface : sample(part, part.is_sheet() ? sheet_samples : curve_samples);
  result.surface = frame.to_frame(samples);
  result.extremes = extreme_points(part.hull.cols() > 0 ? frame.to_frame(part.hull) : result.surface);
  result.support = support(directions.vectors(), result.extremes);
  result.centre = 3 * directions.vectors().transpose() * directions.weights().cwiseProduct(result.support);
  result.support -= directions.vectors() * result.centre;
  result.surface.colwise() -= result.centre;
  result.extremes.colwise() -= result.centre;
  result.spacing = spacing(result.surface);
  result.width = directions.weights().dot(result.support);
  result.diagonal = (result.extremes.rowwise().maxCoeff() - result.extremes.rowwise().minCoeff()).norm();
  const double scale = frame.height;
  result.volume = part.volume / (scale * scale * scale);
  result.area = part.area / (scale * scale);
  return result;
}

inline bool ratio_within(double a, double b, double limit)
{
  if (!(a > 0) || !(b > 0)) return true; // unknown
  return std::max(a, b) <= limit * std::min(a, b);
}

/// Whether width, area and volume of two parts agree.
inline bool have_same_size(const Part_signature& a, const Part_signature& b, double tolerance)
{
  return std::abs(a.width - b.width) <= tolerance * std::max(a.width, b.width) * 2 &&
         ratio_within(a.area, b.area, area_ratio) && ratio_within(a.volume, b.volume, volume_ratio);
}

/// Ratios, at least 1, of the widths of two bodies in all directions, ascending; `noise` is added to every width.
inline std::vector<double> width_ratios(const Eigen::VectorXd& support_a, const Eigen::VectorXd& support_b,
                                        double noise)
{
  const Directions& directions = support_directions();
  std::vector<double> result;
  for (Eigen::Index i = 0; i < directions.size(); ++i) {
    const double a = support_a[i] + support_a[directions.opposite(i)] + noise;
    const double b = support_b[i] + support_b[directions.opposite(i)] + noise;
    result.push_back(std::max(a, b) / std::min(a, b));
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Root mean square difference of two support functions; infinite if it is above the tolerance, or the largest
/// difference above the tolerance times `maximum_factor`.
inline double support_deviation(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double tolerance,
                                double maximum_factor = largest_factor)
{
  const Eigen::VectorXd difference = (a - b).cwiseAbs();
  const double mean = std::sqrt(support_directions().weights().dot(difference.cwiseAbs2()));
  const bool fits = mean <= tolerance && difference.maxCoeff() <= maximum_factor * tolerance;
  return fits ? mean : std::numeric_limits<double>::infinity();
}

inline Eigen::VectorXd moved_support(const Part_signature& part, const Eigen::Matrix3d& map)
{
  return support(support_directions().vectors() * map, part.extremes);
}

/// Whether the distances of points from others are at most tolerance + spacing on average, and 95 % of them at most
/// `largest_factor` times that.
inline bool lie_on(const Points& points, const Points& others, double tolerance, double spacing)
{
  Eigen::ArrayXd distances(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    distances[i] = std::sqrt((others.colwise() - points.col(i)).colwise().squaredNorm().minCoeff());
  const double mean = distances.mean();
  auto* const percentile = distances.data() + distances.size() * 95 / 100;
  std::nth_element(distances.data(), percentile, distances.data() + distances.size());
  return mean <= tolerance + spacing && *percentile <= largest_factor * (tolerance + spacing);
}

/// Whether the surface of `a` after the map agrees with that of `b`. \param limit largest mean distance
inline bool surfaces_agree(const Part_signature& a, const Part_signature& b, const Eigen::Matrix3d& map, double limit)
{
  const double spacing = std::max(a.spacing, b.spacing);
  const Points image = map * a.surface;
  return lie_on(image, b.surface, limit, spacing) && lie_on(b.surface, image, limit, spacing);
}

} // namespace symmetry
} // namespace CGAL::Shape_correspondence::internal
