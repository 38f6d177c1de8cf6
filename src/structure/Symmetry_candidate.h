// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Part_signature.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal::symmetry {

constexpr double least_position_tolerance = 0.01; ///< tolerance of positions of small parts, over the shape's height
constexpr double hull_noise = 0.003;              ///< mean deviation of hulls always allowed, over the shape's diagonal
constexpr double least_elongation = 1.5;          ///< least length over width of a shape with two different ends
constexpr double plane_tolerance = 0.02; ///< greatest offset of a pair's midpoint from a mirror plane, over the height
constexpr double main_plane_support = 0.4;  ///< least share of the surface that the main mirror plane mirrors
constexpr double other_plane_support = 0.7; ///< least share of the surface that the other mirror plane mirrors

/// The linear maps that every pair of parts is tested for.
enum Basic_map { TRANSLATED = 0, MIRRORED_X = 1, MIRRORED_Z = 2 };

inline int axis_of(Basic_map map) { return map == MIRRORED_X ? 0 : 2; }

inline Eigen::Matrix3d matrix_of(Basic_map map)
{
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  if (map != TRANSLATED) result(axis_of(map), axis_of(map)) = -1;
  return result;
}

inline Eigen::Matrix3d mirror_matrix(const Point& normal)
{
  return Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose();
}

/// Which parts, given in canonical order, are congruent: by their hulls, after `confirm()` also by their surfaces.
class Part_relations
{
public:
  Part_relations(std::vector<Part_signature> parts, const Shape_frame& frame, double tolerance)
      : parts_(std::move(parts)), frame_(frame), tolerance_(tolerance)
  {
    const std::size_t n = parts_.size();
    Eigen::AlignedBox3d box;
    for (const Part_signature& part : parts_) {
      boxes_.push_back(box_of(part));
      box.extend(boxes_.back());
    }
    noise_ = hull_noise * box.diagonal().norm();
    extent_ = box.sizes();
    for (Basic_map map : {TRANSLATED, MIRRORED_X, MIRRORED_Z}) {
      related_[map] = std::vector<char>(n * n);
      compute(map);
    }
    find_planes();
  }

  std::size_t size() const { return parts_.size(); }
  const Part_signature& operator[](std::size_t i) const { return parts_[i]; }

  /// Largest mean deviation between a part and the image of another for them to be congruent.
  double deviation_limit(std::size_t i, std::size_t j) const
  {
    return std::max(tolerance_ * std::max(parts_[i].diagonal, parts_[j].diagonal), noise_);
  }

  double noise() const { return noise_; }

  /// Largest distance of a part's centre from its ideal position in a symmetry group.
  double position_tolerance(std::size_t i) const
  {
    return std::max(least_position_tolerance, tolerance_ * parts_[i].diagonal);
  }

  bool related(std::size_t i, std::size_t j, Basic_map map) const { return related_[map][i * size() + j] != 0; }

  /// Root mean square deviation of the hull of part i after the map from that of part j, over the height; infinite if
  /// they are not congruent.
  double deviation(std::size_t i, std::size_t j, const Eigen::Matrix3d& map) const
  {
    if (!same_size(i, j)) return std::numeric_limits<double>::infinity();
    return support_deviation(moved_support(parts_[i], map), parts_[j].support, deviation_limit(i, j));
  }

  bool same_size(std::size_t i, std::size_t j) const { return have_same_size(parts_[i], parts_[j], tolerance_); }

  /// Compares the surfaces of two parts. If they do not agree, the parts are unrelated from now on.
  bool confirm(std::size_t i, std::size_t j, const Eigen::Matrix3d& map)
  {
    if (surfaces_agree(parts_[i], parts_[j], map, deviation_limit(i, j))) return true;
    for (Basic_map basic : {TRANSLATED, MIRRORED_X, MIRRORED_Z})
      if (matrix_of(basic).isApprox(map)) related_[basic][i * size() + j] = related_[basic][j * size() + i] = 0;
    return false;
  }

  /// Whether two parts are displaced along the normal of a mirror plane only. Parts that cross, with centres at
  /// one place, count, too, if they are not mirror images of themselves.
  bool displaced_along(std::size_t i, std::size_t j, Basic_map mirror) const
  {
    Point d = parts_[i].centre - parts_[j].centre;
    const double along = std::abs(d[axis_of(mirror)]);
    d[axis_of(mirror)] = 0;
    const double across = d.norm();
    if (across > position_tolerance(i)) return false;
    const bool cross = std::hypot(along, across) <= noise_ && !related(i, i, mirror);
    return along > std::max(least_position_tolerance, across) || cross;
  }

  /// The mirror plane that mirrors the larger share of the surface; it separates left and right.
  Basic_map main_mirror() const { return main_mirror_; }
  Basic_map other_mirror() const { return main_mirror_ == MIRRORED_X ? MIRRORED_Z : MIRRORED_X; }

  /// The offset d of the plane x = d or z = d that mirrors the largest share of the surface; none if that is too small.
  const std::optional<double>& plane(Basic_map map) const { return planes_[map]; }

  /// Whether two parts are at different ends of an elongated shape, such as a bed's head and foot or a bicycle's front
  /// and rear. The ends do not differ if one part covers both, as a tabletop does, nor if the only mirror plane is
  /// across the length, as in an aeroplane of wide span.
  bool are_at_different_ends(std::size_t i, std::size_t j) const
  {
    const int length = extent_.x() > extent_.z() ? 0 : 2, width = 2 - length;
    if (extent_[length] < least_elongation * extent_[width]) return false;
    const Basic_map across = length == 0 ? MIRRORED_X : MIRRORED_Z, along = length == 0 ? MIRRORED_Z : MIRRORED_X;
    if (is_whole_mirrored(across) && !plane(along)) return false;
    if (std::abs(parts_[i].centre[length] - parts_[j].centre[length]) < extent_[length] / 2) return false;
    return !are_covered(i, j) && !is_wheel(i);
  }

  /// Whether a part is an upright disc or ring, maybe with axle or hub: nearly round about a horizontal axis.
  bool is_wheel(std::size_t i) const
  {
    const Point size = boxes_[i].sizes();
    const int axis = size.x() < size.z() ? 0 : 2;
    if (2 * size[axis] > size.y()) return false;
    const double eighth = std::atan(1.0);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(eighth, Point::Unit(axis)).toRotationMatrix();
    return std::isfinite(deviation(i, i, turn)) && std::isfinite(deviation(i, i, turn * turn));
  }

private:
  bool is_whole_mirrored(Basic_map map) const { return map == MIRRORED_X ? frame_.mirror_x : frame_.mirror_z; }

  static Eigen::AlignedBox3d box_of(const Part_signature& part)
  {
    return Eigen::AlignedBox3d(part.centre + part.extremes.rowwise().minCoeff(),
                               part.centre + part.extremes.rowwise().maxCoeff());
  }

  /// Whether a third part covers the centres of both from above.
  bool are_covered(std::size_t i, std::size_t j) const
  {
    const double top = std::max(boxes_[i].max().y(), boxes_[j].max().y());
    for (std::size_t k = 0; k < size(); ++k) {
      const Eigen::AlignedBox3d& box = boxes_[k];
      const auto covers = [&](const Point& p) {
        return box.min().x() <= p.x() && p.x() <= box.max().x() && box.min().z() <= p.z() && p.z() <= box.max().z();
      };
      if (k != i && k != j && box.max().y() >= top && covers(parts_[i].centre) && covers(parts_[j].centre)) return true;
    }
    return false;
  }

  void compute(Basic_map map)
  {
    std::vector<Eigen::Index> permutation;
    if (map != TRANSLATED) permutation = support_directions().mirrored(axis_of(map));
    for (std::size_t i = 0; i < size(); ++i) {
      Eigen::VectorXd image = parts_[i].support;
      for (std::size_t d = 0; d < permutation.size(); ++d)
        image[d] = parts_[i].support[permutation[d]];
      for (std::size_t j = i; j < size(); ++j) {
        if (!same_size(i, j)) continue;
        const bool fits = std::isfinite(support_deviation(image, parts_[j].support, deviation_limit(i, j)));
        related_[map][i * size() + j] = related_[map][j * size() + i] = fits;
      }
    }
  }

  double weight(std::size_t i) const
  {
    return parts_[i].area > 0 ? parts_[i].area : parts_[i].diagonal * parts_[i].diagonal;
  }

  /// A plane normal to an axis, and the share of the surface that it mirrors.
  struct Supported_plane
  {
    double support = 0;
    double offset = 0;
  };

  /// The plane that mirrors the most surface. Mirrored pairs, and parts that mirror themselves, vote for offsets.
  /// \param wanted the offset, if it is known
  Supported_plane best_plane(Basic_map map, const std::optional<double>& wanted) const
  {
    const int axis = axis_of(map);
    std::vector<std::pair<double, std::size_t>> votes; // (offset, part)
    double total = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      total += weight(i);
      if (related(i, i, map)) votes.emplace_back(parts_[i].centre[axis], i);
      for (std::size_t j = 0; j < size(); ++j)
        if (j != i && related(i, j, map) && displaced_along(i, j, map))
          votes.emplace_back((parts_[i].centre[axis] + parts_[j].centre[axis]) / 2, i);
    }
    if (wanted) {
      const auto is_far = [&](const auto& vote) { return std::abs(vote.first - *wanted) > plane_tolerance; };
      votes.erase(std::remove_if(votes.begin(), votes.end(), is_far), votes.end());
    }
    std::sort(votes.begin(), votes.end());
    return best_window(votes, total);
  }

  /// The interval of offsets, as wide as the plane's tolerance, whose parts have the largest total surface.
  Supported_plane best_window(const std::vector<std::pair<double, std::size_t>>& votes, double total) const
  {
    Supported_plane best;
    std::vector<int> uses(size(), 0);
    double support = 0;
    std::size_t first = 0;
    for (std::size_t last = 0; last < votes.size(); ++last) {
      if (uses[votes[last].second]++ == 0) support += weight(votes[last].second);
      for (; votes[last].first - votes[first].first > plane_tolerance; ++first)
        if (--uses[votes[first].second] == 0) support -= weight(votes[first].second);
      if (support > best.support * total * (1 + 1e-9)) {
        double sum = 0, weights = 0;
        for (std::size_t v = first; v <= last; ++v) {
          sum += weight(votes[v].second) * votes[v].first;
          weights += weight(votes[v].second);
        }
        best = {support / total, sum / weights};
      }
    }
    return best;
  }

  /// Finds the mirror planes. Of two planes with equal support, the one across the length is the main one.
  void find_planes()
  {
    constexpr double clearly = 0.01; // least difference of supports, or of relative extents, that decides
    const std::optional<double> at_origin = 0.0, anywhere;
    std::array<Supported_plane, 3> found;
    for (Basic_map map : {MIRRORED_X, MIRRORED_Z})
      found[map] = best_plane(map, is_whole_mirrored(map) ? at_origin : anywhere);
    const double advantage = found[MIRRORED_X].support - found[MIRRORED_Z].support;
    const bool x_is_main = std::abs(advantage) > clearly ? advantage > 0 : extent_.x() >= extent_.z() * (1 - clearly);
    main_mirror_ = x_is_main ? MIRRORED_X : MIRRORED_Z;
    for (Basic_map map : {MIRRORED_X, MIRRORED_Z}) {
      const bool is_main = map == main_mirror_;
      if ((is_whole_mirrored(map) && is_main) ||
          found[map].support >= (is_main ? main_plane_support : other_plane_support))
        planes_[map] = found[map].offset;
    }
  }

  std::vector<Part_signature> parts_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  const Shape_frame& frame_;
  double tolerance_;
  double noise_;
  Point extent_; ///< extent of the shape
  std::array<std::vector<char>, 3> related_;
  std::array<std::optional<double>, 3> planes_;
  Basic_map main_mirror_ = MIRRORED_X;
};

/// Limits for copies, which are stricter than for congruent parts.
constexpr double copy_tolerance = 0.4;    ///< largest mean deviation, over that of congruent parts
constexpr double copy_maximum = 1.75;     ///< largest deviation of supports in any direction, over the mean one allowed
constexpr double copy_area_ratio = 1.25;  ///< largest ratio of areas
constexpr double copy_width_ratio = 1.27; ///< largest ratio of widths, in any direction
constexpr double copy_most_widths = 1.14; ///< largest ratio of widths in 90 % of the directions, since noise is uneven

/// Kinds of symmetry, in the order of preference among candidates with equally many members.
enum class Preference {
  STAR,          ///< a ring whose members start at the axis
  FOUR_MIRRORED, ///< four parts mirrored in two orthogonal planes
  RING,
  ROW,               ///< three or more parts along a vector
  MIRRORED_IN_SHAPE, ///< a pair mirrored in a mirror plane of the shape
  TURNED,            ///< a pair related by half a turn about an axis in a mirror plane of the shape
  TRANSLATED,        ///< a pair along a vector
  MIRRORED_ANYHOW    ///< a pair mirrored in the vertical plane midway between them
};

/// A possible symmetry group: parts and the symmetry that maps each to the next, in frame coordinates.
struct Symmetry_candidate
{
  /// A linear map that must map the surface of one member to that of another, up to translation.
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

/// Keeps those of the added candidates that have most members. Candidates that were rejected are not added again.
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

  /// Returns the candidates, the best first, and leaves the set empty.
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
/// pairs must be copies, or similar rails and shelves would be grouped; mirrored parts may be bent differently.
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

} // namespace CGAL::Shape_correspondence::internal::symmetry
