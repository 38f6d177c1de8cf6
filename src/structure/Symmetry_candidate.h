// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Part_relations.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace symmetry {

/// Limits for copies, which are stricter than for congruent parts.
constexpr double copy_tolerance = 0.4; ///< mean deviation, over the tolerance
constexpr double copy_maximum = 1.75;  ///< largest deviation, over the allowed mean deviation
constexpr double copy_area_ratio = 1.25;
constexpr double copy_width_ratio = 1.27; ///< ratio of widths, in any direction
constexpr double copy_most_widths = 1.14; ///< ratio of widths in nine directions of ten, since noise is uneven

/// Kinds of symmetry, in the order of preference among candidates with equally many members.
enum class Preference {
  STAR,          ///< a ring whose members start at the axis
  FOUR_MIRRORED, ///< two orthogonal mirror planes
  RING,
  ROW,               ///< three or more parts along a vector
  MIRRORED_IN_SHAPE, ///< a pair mirrored in a mirror plane of the shape
  TURNED,            ///< a pair related by half a turn about an axis in a mirror plane of the shape
  TRANSLATED,        ///< a pair along a vector
  MIRRORED_ANYHOW    ///< a pair mirrored in the vertical plane midway between them
};

/// A possible symmetry group: parts and the symmetry that carries each into the next, in frame coordinates.
struct Symmetry_candidate
{
  /// A linear map that must carry the surface of one member into that of another.
  struct Link
  {
    std::size_t from, to; ///< indices into `members`
    Eigen::Matrix3d map;
    bool copy; ///< whether the two parts must be copies, see `is_copy()`
  };

  std::vector<std::size_t> members; ///< ordered along the generator
  Symmetry symmetry;
  Preference preference = Preference::MIRRORED_ANYHOW;
  double cost = 0; ///< decides among candidates of one kind and size, the least first
  std::vector<Link> links;

  /// Sort key: better candidates are smaller; ties are broken by the canonical order of parts.
  auto rank() const { return std::make_tuple(-static_cast<long>(members.size()), preference, cost, members); }
};

inline bool operator<(const Symmetry_candidate& a, const Symmetry_candidate& b) { return a.rank() < b.rank(); }

/// The candidates that have most members of all that were added, but for those that were rejected.
class Largest_candidates
{
public:
  /// Whether a candidate of so many members would be kept.
  bool takes(std::size_t members) const { return found_.empty() || members >= found_.front().members.size(); }

  void add(Symmetry_candidate candidate)
  {
    if (!takes(candidate.members.size()) || rejected_.count(key(candidate))) return;
    if (!found_.empty() && candidate.members.size() > found_.front().members.size()) found_.clear();
    found_.push_back(std::move(candidate));
  }

  /// What was added, the best first, and nothing any more.
  std::vector<Symmetry_candidate> take_out()
  {
    std::sort(found_.begin(), found_.end());
    return std::exchange(found_, {});
  }

  void reject(const Symmetry_candidate& candidate) { rejected_.insert(key(candidate)); }

private:
  using Key = std::pair<Preference, std::vector<std::size_t>>;
  static Key key(const Symmetry_candidate& candidate) { return {candidate.preference, candidate.members}; }

  std::vector<Symmetry_candidate> found_;
  std::set<Key> rejected_;
};

/// Of two opposite horizontal normals, the one that points to the right, or else to the front.
inline Point rightward(const Point& normal)
{
  const bool is_left = normal.x() < -1e-9 || (std::abs(normal.x()) <= 1e-9 && normal.z() < 0);
  return is_left ? Point(-normal) : normal;
}

/// Whether the component of largest magnitude is negative.
inline bool is_backward(const Point& vector)
{
  Eigen::Index largest;
  vector.cwiseAbs().maxCoeff(&largest);
  return vector[largest] < 0;
}

/// A cost rounded to 1e-4, so that rounding errors do not decide between candidates.
inline double rounded(double cost) { return std::round(cost * 1e4) / 1e4; }

/// Mean deviation of the members from their images over all links.
inline double link_residual(const Part_relations& parts, const Symmetry_candidate& candidate)
{
  double sum = 0;
  for (const Symmetry_candidate::Link& link : candidate.links)
    sum += parts.deviation(candidate.members[link.from], candidate.members[link.to], link.map);
  return candidate.links.empty() ? 0 : sum / double(candidate.links.size());
}

inline bool are_equally_wide(const Eigen::VectorXd& support_a, const Eigen::VectorXd& support_b, double noise)
{
  const std::vector<double> ratios = width_ratios(support_a, support_b, noise);
  return ratios.back() <= copy_width_ratio && ratios[ratios.size() * 9 / 10] <= copy_most_widths;
}

/// Whether a part is a copy of another, not just congruent within the tolerance. Members of rings, rows and translated
/// pairs must be, or similar rails and shelves would be grouped; mirrored parts may be bent differently.
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

/// Whether the surfaces of the members agree with the links of the candidate.
inline bool confirm(Part_relations& parts, const Symmetry_candidate& candidate)
{
  for (const Symmetry_candidate::Link& link : candidate.links) {
    const std::size_t from = candidate.members[link.from], to = candidate.members[link.to];
    if (link.copy && !is_copy(parts, from, to, link.map)) return false;
    if (!parts.confirm(from, to, link.map)) return false;
  }
  return true;
}

} // namespace symmetry
} // namespace CGAL::Shape_correspondence::internal
