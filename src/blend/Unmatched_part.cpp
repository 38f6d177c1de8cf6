// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_part.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

Unmatched_part::Unmatched_part(const Part_chart& chart, const Part_mesh& mesh, const std::vector<Point>& anchors)
    : chart_(chart), mesh_(mesh), vanished_(3, mesh.points.cols())
{
  fit_segment(anchors.empty() ? std::vector<Point>{chart(Point::Zero())} : anchors);
  for (Eigen::Index i = 0; i < vanished_.cols(); ++i)
    vanished_.col(i) = vanished(mesh.points.col(i));
}

/// The line nearest to anchors that are far from each other.
void Unmatched_part::fit_segment(const std::vector<Point>& anchors)
{
  constexpr double far_apart = 1; // in coordinates, of 2 from end to end
  Points coordinates(3, Eigen::Index(anchors.size()));
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    coordinates.col(Eigen::Index(i)) = chart_.coordinates(anchors[i]);
    middle_ += anchors[i] / double(anchors.size());
  }
  const Point low = coordinates.rowwise().minCoeff(), high = coordinates.rowwise().maxCoeff();
  if ((high - low).maxCoeff(&axis_) < far_apart) return;
  low_ = low[axis_];
  high_ = high[axis_];
  mean_ = coordinates.row(axis_).mean();
  const Eigen::RowVectorXd off = coordinates.row(axis_).array() - mean_;
  for (std::size_t i = 0; i < anchors.size(); ++i)
    slope_ += off[Eigen::Index(i)] / off.squaredNorm() * (anchors[i] - middle_);
}

/// Where a point is when nothing remains: on the segment.
Point Unmatched_part::vanished(const Point& p) const
{
  if (slope_.isZero(0)) return middle_;
  return middle_ + (std::clamp(chart_.coordinates(p)[axis_], low_, high_) - mean_) * slope_;
}

} // namespace CGAL::Shape_correspondence::internal
