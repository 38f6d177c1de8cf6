// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/fit_curve.h"
#include "abstraction/inside_test.h"
#include "base/Nearest_points.h"
#include "base/eigen_system.h"

#include <cmath>
#include <optional>

namespace CGAL::Shape_correspondence::internal {

struct Line
{
  Point centre;
  Point direction;

  Points offsets(const Points& points) const
  {
    const Points relative = points.colwise() - centre;
    return relative - direction * (direction.transpose() * relative);
  }
};

inline Line principal_line(const Points& points)
{
  const Point centre = points.rowwise().mean();
  return {centre, eigen_system(scatter_matrix(points.colwise() - centre)).vectors.col(2)};
}

constexpr int sections_of_a_rod = 12;

/// The medial axis of a rod, divided into sections along a line.
struct Rod_sections
{
  Points centres = Points::Zero(3, sections_of_a_rod);
  Eigen::ArrayXd radii = Eigen::ArrayXd::Zero(sections_of_a_rod); ///< mean distances of the surface from the axis
  /// Root mean square distances of the axis from the sections' centres.
  Eigen::ArrayXd spreads = Eigen::ArrayXd::Zero(sections_of_a_rod);
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(sections_of_a_rod);
};

inline Rod_sections rod_sections(const Points& axis, const Points& surface, const Line& line)
{
  const Eigen::RowVectorXd heights = line.direction.transpose() * (axis.colwise() - line.centre);
  const double low = heights.minCoeff(), height = heights.maxCoeff() - low;
  const auto section = [&](Eigen::Index v) {
    return clamped_cell((heights[v] - low) / height * sections_of_a_rod, sections_of_a_rod - 1);
  };
  Rod_sections result;
  for (Eigen::Index v = 0; v < axis.cols(); ++v) {
    result.centres.col(section(v)) += axis.col(v);
    result.radii[section(v)] += (axis.col(v) - surface.col(v)).norm();
    ++result.counts[section(v)];
  }
  const Eigen::ArrayXd counts = result.counts.max(1);
  result.centres.array().rowwise() /= counts.transpose();
  result.radii /= counts;
  for (Eigen::Index v = 0; v < axis.cols(); ++v) {
    const Point offset = axis.col(v) - result.centres.col(section(v));
    result.spreads[section(v)] += (offset - line.direction.dot(offset) * line.direction).squaredNorm();
  }
  result.spreads = (result.spreads / counts).sqrt();
  return result;
}

/// The curve of a straight rod of any profile: the line through the centres of its medial axis, extended to the
/// surface. None if the part is bent, branches, or is too wide for its thickness.
/// \param axis the medial poles of the vertices of `solid`
/// \param is_convex whether the solid is convex: it then has no branches, and may be wide for its thickness
inline std::optional<Fitted_curve> straight_curve(const Points& axis, const Part_mesh& solid, int control_points,
                                                  bool is_convex)
{
  // Relative to the distance of the surface from the axis there, for a convex part plus the spread
  const double most_offset = 0.1; // distance of the centre of a section from the line
  const double most_spread = 1;   // spread of the medial axis about it
  const double fewest = 3;        // number of points in a section
  const Rod_sections sections = rod_sections(axis, solid.points, principal_line(axis));
  if (sections.counts.minCoeff() < fewest || !(is_convex || (sections.spreads <= most_spread * sections.radii).all()))
    return std::nullopt;
  const Line line = principal_line(sections.centres);
  const Eigen::ArrayXd offsets = line.offsets(sections.centres).colwise().norm().transpose();
  // Centres of wide sections are uncertain, since samples are uneven
  const Eigen::ArrayXd sizes = is_convex ? Eigen::ArrayXd(sections.radii + sections.spreads) : sections.radii;
  if (!(offsets <= most_offset * sizes).all()) return std::nullopt;
  const Eigen::RowVectorXd heights = line.direction.transpose() * (sections.centres.colwise() - line.centre);
  Fitted_curve result;
  result.curve.points.resize(3, 2);
  result.curve.points.col(0) = line.centre + heights.minCoeff() * line.direction;
  result.curve.points.col(1) = line.centre + heights.maxCoeff() * line.direction;
  const Nearest_points surface(solid.points);
  const Inside_test is_inside(solid);
  extend_end(result.curve, false, surface, is_inside);
  extend_end(result.curve, true, surface, is_inside);
  result.curve.points = sample(result.curve, control_points);
  result.residual = std::sqrt(offsets.square().mean());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
