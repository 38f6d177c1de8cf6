// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/optimal_assignment.h"
#include "unit_box.h"

namespace CGAL::Shape_correspondence::peers {

/// Assigns each part of the shape with fewer parts to a different part of the other shape, such that the sum of chamfer
/// distances in unit boxes is least.
inline Part_pairs match_by_assignment(const Boxed_shape& source, const Boxed_shape& target)
{
  const Eigen::MatrixXd cost = part_distances(source, target, chamfer);
  const bool turned = cost.rows() > cost.cols();
  const std::vector<std::size_t> column_of =
      internal::optimal_assignment(turned ? Eigen::MatrixXd(cost.transpose()) : cost);
  Part_pairs pairs;
  for (std::size_t i = 0; i < column_of.size(); ++i)
    pairs.emplace_back(turned ? column_of[i] : i, turned ? i : column_of[i]);
  return pairs;
}

/// Adds pairs of members of two corresponding sets of parts: one to one if the sets have equal sizes, else all to all.
inline void add_set_pairs(const Eigen::MatrixXd& cost, const std::vector<std::size_t>& a,
                          const std::vector<std::size_t>& b, Part_pairs& pairs)
{
  if (a.size() != b.size()) {
    for (std::size_t i : a)
      for (std::size_t j : b)
        pairs.emplace_back(i, j);
    return;
  }
  Eigen::MatrixXd inner(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      inner(Eigen::Index(i), Eigen::Index(j)) = cost(Eigen::Index(a[i]), Eigen::Index(b[j]));
  const std::vector<std::size_t> column_of = internal::optimal_assignment(inner);
  for (std::size_t i = 0; i < a.size(); ++i)
    pairs.emplace_back(a[i], b[column_of[i]]);
}

} // namespace CGAL::Shape_correspondence::peers
