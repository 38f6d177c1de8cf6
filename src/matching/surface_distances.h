// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Normalized_shape.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Distances of the points of the parts of one shape from the parts of another, in one piece of memory.
class Point_distances
{
public:
  Point_distances(const Normalized_shape& from, const Normalized_shape& to);

  // Of the points of a part from a part of the other shape.
  Eigen::Map<const Eigen::ArrayXd> of(std::size_t part, std::size_t other) const
  {
    return {values_.data() + place(part, other), count(part)};
  }
  double sum(std::size_t part, std::size_t other) const { return sums_(Eigen::Index(part), Eigen::Index(other)); }
  double mean(std::size_t part, std::size_t other) const { return sum(part, other) / double(count(part)); }
  // Points of a part.
  Eigen::Index count(std::size_t part) const { return from_.surfaces[part].rows(); }

  void set_squared(std::size_t part, std::size_t other, const Eigen::ArrayXd& squared);

private:
  Eigen::Index place(std::size_t part, std::size_t other) const
  {
    return begin_[part] + Eigen::Index(other) * count(part);
  }

  const Normalized_shape& from_;
  std::vector<Eigen::Index> begin_; // of the values of a part
  Eigen::ArrayXd values_;
  Eigen::MatrixXd sums_; // part × other part
};

// The distances of the points of all parts of either shape from all parts of the other.
struct Surface_distances
{
  Point_distances a_from_b, b_from_a;

  Surface_distances(const Normalized_shape& a, const Normalized_shape& b);
};

// The chamfer distance of two parts: the mean distance of the points of either from the other.
double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t j);

// The chamfer distance of a part and the union of several.
double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i,
               const std::vector<std::size_t>& parts);

} // namespace CGAL::Shape_correspondence::internal
