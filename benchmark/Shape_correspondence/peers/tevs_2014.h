// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assignment.h"

#include <cmath>

namespace CGAL::Shape_correspondence::peers {

/// A pair of symmetry groups that may correspond.
struct Group_pair
{
  std::size_t source, target;
  double affinity;
};

inline Eigen::AlignedBox3d box_of_group(const Boxed_shape& shape, std::size_t group)
{
  Eigen::AlignedBox3d box;
  for (std::size_t part : shape.groups[group])
    box.extend(shape.boxes[part]);
  return box;
}

/// Similarity of two symmetry groups in [0, 1], by types, directions and extents.
inline double group_affinity(const Boxed_shape& a, std::size_t g, const Boxed_shape& b, std::size_t h)
{
  constexpr double other_type = 0.3, extent_width = 0.3; // factor for other types; width of the Gaussian of extents
  const Symmetry &s = a.symmetries[g], &t = b.symmetries[h];
  const bool single = a.groups[g].size() == 1, other_single = b.groups[h].size() == 1;
  const double direction = single ? 1 : std::abs(s.direction.dot(t.direction));
  const double kind = (single && other_single) || (!single && s.type == t.type) ? .5 + .5 * direction : other_type;
  const Point difference = box_of_group(a, g).diagonal() - box_of_group(b, h).diagonal();
  return kind * std::exp(-difference.squaredNorm() / (extent_width * extent_width));
}

/// Compatibility of the pairs (g, h) and (g2, h2) of groups, in [0, 1]: by the difference of the offsets from g to g2
/// and from h to h2, halved if groups touch in only one of the two shapes.
inline double arrangement_affinity(const Boxed_shape& a, std::size_t g, std::size_t g2, const Boxed_shape& b,
                                   std::size_t h, std::size_t h2)
{
  constexpr double width = 0.25, one_touches = 0.5; // `width`: of the Gaussian of differences, in unit boxes
  const auto offset = [](const Boxed_shape& shape, std::size_t from, std::size_t to) {
    return Point(box_of_group(shape, to).center() - box_of_group(shape, from).center());
  };
  const auto touch = [](const Boxed_shape& shape, std::size_t from, std::size_t to) {
    for (std::size_t part : shape.groups[from])
      for (std::size_t other : shape.neighbours[part])
        if (shape.group_of[other] == to) return true;
    return false;
  };
  const double agreement = std::exp(-(offset(a, g, g2) - offset(b, h, h2)).squaredNorm() / (width * width));
  return touch(a, g, g2) == touch(b, h, h2) ? agreement : one_touches * agreement;
}

/// A. Tevs et al., *Relating shapes via geometric symmetries and regularities*, 2014: graphs of symmetry groups are
/// matched by the groups' types and their arrangement. Simplified: arrangements are offsets and contacts in unit boxes,
/// and the matching is spectral (Leordeanu and Hebert, 2005) instead of a search over subgraphs.
inline Part_pairs match_tevs_2014(const Boxed_shape& source, const Boxed_shape& target)
{
  constexpr double least_affinity = 0.1;
  constexpr int power_steps = 100;
  std::vector<Group_pair> candidates;
  for (std::size_t g = 0; g < source.groups.size(); ++g)
    for (std::size_t h = 0; h < target.groups.size(); ++h) {
      const double affinity = group_affinity(source, g, target, h);
      if (affinity >= least_affinity) candidates.push_back({g, h, affinity});
    }
  const auto n = Eigen::Index(candidates.size());
  Eigen::MatrixXd affinity = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Group_pair& p = candidates[std::size_t(i)];
    affinity(i, i) = p.affinity;
    for (Eigen::Index j = 0; j < i; ++j) {
      const Group_pair& q = candidates[std::size_t(j)];
      if (p.source == q.source || p.target == q.target) continue;
      affinity(i, j) = affinity(j, i) =
          p.affinity * q.affinity * arrangement_affinity(source, p.source, q.source, target, p.target, q.target);
    }
  }
  Eigen::VectorXd principal = Eigen::VectorXd::Ones(n);
  for (int i = 0; i < power_steps && n > 0; ++i)
    principal = (affinity * principal).normalized();

  const Eigen::MatrixXd cost = part_distances(source, target, chamfer);
  Part_pairs pairs;
  Eigen::Index best;
  while (n > 0 && principal.maxCoeff(&best) > 0) {
    const Group_pair& p = candidates[std::size_t(best)];
    add_set_pairs(cost, source.groups[p.source], target.groups[p.target], pairs);
    for (Eigen::Index i = 0; i < n; ++i)
      if (candidates[std::size_t(i)].source == p.source || candidates[std::size_t(i)].target == p.target)
        principal[i] = 0;
  }
  return pairs;
}

} // namespace CGAL::Shape_correspondence::peers
