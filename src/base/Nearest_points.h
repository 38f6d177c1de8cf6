// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <nanoflann.hpp>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Shape_correspondence::internal {

/// A static kd-tree of points. Not copyable.
class Nearest_points
{
public:
  explicit Nearest_points(const Points& points)
      : points_{points}, tree_(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(points_in_leaf))
  {}

  /// Distance of the nearest point other than `ignored`; infinite if there is none.
  double distance(const Point& query, Eigen::Index ignored = -1) const
  {
    return std::sqrt(nearest(query, std::numeric_limits<double>::infinity(), ignored).squared);
  }

  /// Index of the nearest point other than `ignored` within a radius; -1 if there is none.
  Eigen::Index nearest_within(const Point& query, double radius, Eigen::Index ignored = -1) const
  {
    return nearest(query, radius * radius, ignored).index;
  }

private:
  static constexpr std::size_t points_in_leaf = 8;
  static constexpr double rounding = 1e-12; // greater than the relative error of a squared distance

  // Types required by nanoflann: data, metric and result set

  struct Data
  {
    Points points;

    std::size_t kdtree_get_point_count() const { return std::size_t(points.cols()); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points(Eigen::Index(axis), Eigen::Index(i)); }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const
    {
      return false; // nanoflann computes it
    }
  };

  /// The Euclidean metric, bitwise equal to Eigen's norm; the metric of nanoflann adds squares in another order.
  struct Metric
  {
    using ElementType = double;
    using DistanceType = double;

    explicit Metric(const Data& of) : data(of) {}
    double evalMetric(const double* query, std::size_t i, std::size_t) const
    {
      return (data.points.col(Eigen::Index(i)) - Eigen::Map<const Point>(query)).squaredNorm();
    }
    double accum_dist(double a, double b, std::size_t) const { return (a - b) * (a - b); }

    const Data& data;
  };

  /// Result set for the nearest point; of equally near points, that of lowest index wins, for any order of the tree.
  struct Nearest
  {
    using DistanceType = double; // required by nanoflann 1.6
    using IndexType = std::size_t;

    double squared; ///< squared distance of the nearest point so far; at first, the limit of the search
    Eigen::Index ignored, index = -1;

    std::size_t size() const { return index >= 0; }
    bool full() const { return true; }
    /// A slightly greater distance, so that branches and points at equal distance are not skipped.
    double worstDist() const { return squared * (1 + rounding) + std::numeric_limits<double>::min(); }
    bool addPoint(double candidate, std::size_t place)
    {
      const auto i = Eigen::Index(place);
      const bool is_nearer = candidate < squared || (candidate == squared && i < index);
      if (is_nearer && i != ignored) squared = candidate, index = i;
      return true;
    }
    void sort() const {} // required by nanoflann 1.5
  };

  Nearest nearest(const Point& query, double squared, Eigen::Index ignored) const
  {
    Nearest result{squared, ignored};
    tree_.findNeighbors(result, query.data(), {});
    return result;
  }

  Data points_;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, Data, 3> tree_;
};

} // namespace CGAL::Shape_correspondence::internal
