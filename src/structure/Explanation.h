// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Part_relations.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace symmetry {

constexpr double copy_tolerance = 0.4;    ///< over the tolerance
constexpr double copy_maximum = 1.75;     ///< the largest deviation of copies, over the mean one allowed
constexpr double copy_area_ratio = 1.25;  ///< how much the areas of copies may differ
constexpr double copy_width_ratio = 1.27; ///< and their widths in any direction
constexpr double copy_most_widths = 1.14; ///< and in nine directions of ten, since noise is not the same everywhere

/// Which kind of explanation is preferred where several cover as many parts.
enum class Preference {
  STAR,              ///< a ring whose members come from the axis
  FOUR_MIRRORED,     ///< two orthogonal mirror planes
  RING,              ///< any other ring
  ROW,               ///< three or more along a vector
  MIRRORED_IN_SHAPE, ///< a pair, in a mirror plane of the shape
  TURNED,            ///< a pair, by half a turn about an axis in a mirror plane of the shape
  TRANSLATED,        ///< a pair along a vector
  MIRRORED_ANYHOW    ///< a pair, in the vertical plane half-way
};

/// A set of parts and the symmetry that carries each into the next, in frame coordinates.
struct Explanation
{
  /// A map that must carry a member's surface into another's.
  struct Link
  {
    std::size_t from, to; ///< indices into `members`
    Eigen::Matrix3d map;
    bool copy; ///< whether they must be copies
  };

  std::vector<std::size_t> members; ///< in the order along the generator
  Symmetry symmetry;
  Preference preference = Preference::MIRRORED_ANYHOW;
  double cost = 0; ///< of explanations that are alike otherwise, the least is taken
  std::vector<Link> links;

  /// The better one is smaller; the order of parts, which is canonical, settles the rest.
  auto rank() const { return std::make_tuple(-static_cast<long>(members.size()), preference, cost, members); }
};

inline bool operator<(const Explanation& a, const Explanation& b) { return a.rank() < b.rank(); }

/// Costs are rounded so that noise in the last digits does not decide.
inline double rounded(double cost) { return std::round(cost * 1e4) / 1e4; }

/// The deviation of the members from their images by all links.
inline double link_residual(const Part_relations& parts, const Explanation& explanation)
{
  double sum = 0;
  for (const Explanation::Link& link : explanation.links)
    sum += parts.deviation(explanation.members[link.from], explanation.members[link.to], link.map);
  return explanation.links.empty() ? 0 : sum / double(explanation.links.size());
}

/// Whether two bodies are as wide as one another.
inline bool are_equally_wide(const Eigen::VectorXd& support_a, const Eigen::VectorXd& support_b, double noise)
{
  const std::vector<double> ratios = width_ratios(support_a, support_b, noise);
  return ratios.back() <= copy_width_ratio && ratios[ratios.size() * 9 / 10] <= copy_most_widths;
}

/// Whether a part is a copy of another, not just like it. Members of rings, rows and translated pairs are held to this,
/// or rails, shelves and cushions that are just alike would be gathered; mirrored parts may be bent differently.
inline bool is_copy(const Part_relations& parts, std::size_t i, std::size_t j, const Eigen::Matrix3d& map)
{
  const double limit = copy_tolerance * parts.deviation_limit(i, j);
  const Eigen::VectorXd image = moved_support(parts[i], map);
  const bool agrees = limit > parts.noise()
                          ? std::isfinite(support_deviation(image, parts[j].support, limit, copy_maximum))
                          : std::isfinite(support_deviation(image, parts[j].support, parts.noise()));
  return agrees && ratio_within(parts[i].area, parts[j].area, copy_area_ratio) &&
         are_equally_wide(image, parts[j].support, parts.noise());
}

/// Whether the explanation stands a closer look.
inline bool confirm(Part_relations& parts, const Explanation& explanation)
{
  for (const Explanation::Link& link : explanation.links) {
    const std::size_t from = explanation.members[link.from], to = explanation.members[link.to];
    if (link.copy && !is_copy(parts, from, to, link.map)) return false;
    if (!parts.confirm(from, to, link.map)) return false;
  }
  return true;
}

} // namespace symmetry
} // namespace CGAL::Shape_correspondence::internal
