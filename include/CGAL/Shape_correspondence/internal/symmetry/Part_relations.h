// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_SYMMETRY_PART_RELATIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_SYMMETRY_PART_RELATIONS_H

#include <CGAL/Shape_correspondence/internal/symmetry/Part_signature.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {
namespace symmetry {

constexpr double POSITION_TOLERANCE = 0.01;  ///< over the shape's height; for parts that are small
constexpr double PLANE_TOLERANCE = 0.02;     ///< how far from a mirror plane a pair may be centred, over the height
constexpr double FIRST_PLANE_SUPPORT = 0.4;  ///< share of the surface that must be mirrored, for the better plane
constexpr double SECOND_PLANE_SUPPORT = 0.7; ///< and for the other one

/// The motions whose linear part every pair is tested for.
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

/// Which parts are congruent under which motions, of parts in a canonical order. What is asked for all pairs is judged
/// by hulls; `confirm()` looks at the surfaces.
class Part_relations
{
public:
  Part_relations(std::vector<Part_signature> parts, const Shape_frame& frame, double tolerance)
      : parts_(std::move(parts)), tolerance_(tolerance)
  {
    const std::size_t n = parts_.size();
    for (Basic_map map : {TRANSLATED, MIRRORED_X, MIRRORED_Z}) {
      related_[map].assign(n * n, 0);
      compute(map);
    }
    find_planes(frame);
  }

  std::size_t size() const { return parts_.size(); }
  const Part_signature& operator[](std::size_t i) const { return parts_[i]; }
  double tolerance() const { return tolerance_; }

  /// How far a part may be from where it should be.
  double position_tolerance(std::size_t i) const
  {
    return std::max(POSITION_TOLERANCE, tolerance_ * parts_[i].diagonal);
  }

  bool related(std::size_t i, std::size_t j, Basic_map map) const { return related_[map][i * size() + j] != 0; }

  /// Root mean square deviation of the hull of the image of part i from that of part j, in heights; infinite if they
  /// are not congruent.
  double deviation(std::size_t i, std::size_t j, const Eigen::Matrix3d& map) const
  {
    const Part_signature &a = parts_[i], &b = parts_[j];
    if (!have_same_size(a, b, tolerance_)) return std::numeric_limits<double>::infinity();
    return support_deviation(moved_support(a, map), b.support, tolerance_ * std::max(a.diagonal, b.diagonal));
  }

  /// Compares surfaces; what fails is not related any more.
  bool confirm(std::size_t i, std::size_t j, const Eigen::Matrix3d& map)
  {
    if (surfaces_agree(parts_[i], parts_[j], map, tolerance_)) return true;
    for (Basic_map basic : {TRANSLATED, MIRRORED_X, MIRRORED_Z})
      if (matrix_of(basic).isApprox(map)) related_[basic][i * size() + j] = related_[basic][j * size() + i] = 0;
    return false;
  }

  /// Whether two parts are displaced from each other along one axis alone.
  bool displaced_along(std::size_t i, std::size_t j, int axis) const
  {
    Point d = parts_[i].centre - parts_[j].centre;
    const double along = std::abs(d[axis]);
    d[axis] = 0;
    return d.norm() <= position_tolerance(i) && along > position_tolerance(i);
  }

  /// The mirror plane x = offset or z = offset that explains most of the shape, if it explains enough.
  const std::optional<double>& plane(Basic_map map) const { return planes_[map]; }

private:
  void compute(Basic_map map)
  {
    std::vector<Eigen::Index> permutation;
    if (map != TRANSLATED) permutation = support_directions().mirrored(axis_of(map));
    for (std::size_t i = 0; i < size(); ++i) {
      Eigen::VectorXd image = parts_[i].support;
      for (std::size_t d = 0; d < permutation.size(); ++d)
        image[d] = parts_[i].support[permutation[d]];
      for (std::size_t j = i; j < size(); ++j) {
        const Part_signature& other = parts_[j];
        if (!have_same_size(parts_[i], other, tolerance_)) continue;
        const double limit = tolerance_ * std::max(parts_[i].diagonal, other.diagonal);
        const bool fits = std::isfinite(support_deviation(image, other.support, limit));
        related_[map][i * size() + j] = related_[map][j * size() + i] = fits;
      }
    }
  }

  double weight(std::size_t i) const
  {
    return parts_[i].area > 0 ? parts_[i].area : parts_[i].diagonal * parts_[i].diagonal;
  }

  /// The share of the surface mirrored by some plane of an axis, and the plane.
  struct Supported_plane
  {
    double support = 0;
    double offset = 0;
  };

  /// Every pair and every part of its own votes for a plane; the offset with most surface behind it wins.
  Supported_plane best_plane(Basic_map map, const std::optional<double>& wanted) const
  {
    const int axis = axis_of(map);
    std::vector<std::pair<double, std::size_t>> votes; // offset, part
    double total = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      total += weight(i);
      if (related(i, i, map)) votes.emplace_back(parts_[i].centre[axis], i);
      for (std::size_t j = 0; j < size(); ++j)
        if (j != i && related(i, j, map) && displaced_along(i, j, axis))
          votes.emplace_back((parts_[i].centre[axis] + parts_[j].centre[axis]) / 2, i);
    }
    if (wanted) {
      const auto is_far = [&](const auto& vote) { return std::abs(vote.first - *wanted) > PLANE_TOLERANCE; };
      votes.erase(std::remove_if(votes.begin(), votes.end(), is_far), votes.end());
    }
    std::sort(votes.begin(), votes.end());
    return best_window(votes, total);
  }

  /// The window of offsets, as wide as the plane's tolerance, whose parts have most surface.
  Supported_plane best_window(const std::vector<std::pair<double, std::size_t>>& votes, double total) const
  {
    Supported_plane best;
    std::vector<int> uses(size(), 0);
    double support = 0;
    std::size_t first = 0;
    for (std::size_t last = 0; last < votes.size(); ++last) {
      if (uses[votes[last].second]++ == 0) support += weight(votes[last].second);
      for (; votes[last].first - votes[first].first > PLANE_TOLERANCE; ++first)
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

  void find_planes(const Shape_frame& frame)
  {
    const std::optional<double> at_origin = 0.0, anywhere;
    std::array<Supported_plane, 3> found;
    found[MIRRORED_X] = best_plane(MIRRORED_X, frame.mirror_x ? at_origin : anywhere);
    found[MIRRORED_Z] = best_plane(MIRRORED_Z, frame.mirror_z ? at_origin : anywhere);
    const bool x_is_better = found[MIRRORED_X].support >= found[MIRRORED_Z].support;
    for (Basic_map map : {MIRRORED_X, MIRRORED_Z}) {
      const bool flagged = map == MIRRORED_X ? frame.mirror_x : frame.mirror_z;
      const bool better = (map == MIRRORED_X) == x_is_better;
      if (flagged || found[map].support >= (better ? FIRST_PLANE_SUPPORT : SECOND_PLANE_SUPPORT))
        planes_[map] = found[map].offset;
    }
  }

  std::vector<Part_signature> parts_;
  double tolerance_;
  std::array<std::vector<char>, 3> related_;
  std::array<std::optional<double>, 3> planes_;
};

} // namespace symmetry
} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_SYMMETRY_PART_RELATIONS_H
