// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_FADING_PART_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_FADING_PART_H

#include "blend/Affine_moves.h"
#include "map/Charted_mesh.h"

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A point that is to move, and where to.
struct Handle
{
  Point at, move;
};

/// The affine move nearest to what handles ask for that changes shapes little where they do not ask for it.
/// \param size of what is to move
inline Affine_move following(const std::vector<Handle>& handles, double size)
{
  Affine_move result;
  if (handles.empty()) return result;
  constexpr double stiffness = 0.1; // over the squared size
  for (const Handle& handle : handles) {
    result.middle += handle.at / double(handles.size());
    result.shift += handle.move / double(handles.size());
  }
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d spread = (stiffness * size * size + 1e-12) * Eigen::Matrix3d::Identity();
  for (const Handle& handle : handles) {
    across += (handle.move - result.shift) * (handle.at - result.middle).transpose();
    spread += (handle.at - result.middle) * (handle.at - result.middle).transpose();
  }
  result.gradient = across * spread.inverse();
  return result;
}

/// A part without counterpart. It shrinks to where it touches what stays: to a point or, between contacts far from each
/// other, to a straight thread.
class Fading_part
{
public:
  /// \param anchors where it touches what it shrinks to; none: its own middle
  Fading_part(const Part_chart& chart, const Part_mesh& mesh, const std::vector<Point>& anchors)
      : chart_(chart), mesh_(mesh), vanished_(3, mesh.points.cols())
  {
    constexpr double far_apart = 1; // in coordinates, of 2 from end to end
    std::vector<Point> ends = anchors;
    if (ends.empty()) ends.push_back(chart(Point::Zero()));
    Points coordinates(3, Eigen::Index(ends.size()));
    for (std::size_t i = 0; i < ends.size(); ++i) {
      coordinates.col(Eigen::Index(i)) = chart.coordinates(ends[i]);
      middle_ += ends[i] / double(ends.size());
    }
    const Point low = coordinates.rowwise().minCoeff(), high = coordinates.rowwise().maxCoeff();
    if ((high - low).maxCoeff(&axis_) >= far_apart) {
      low_ = low[axis_];
      high_ = high[axis_];
      mean_ = coordinates.row(axis_).mean();
      const Eigen::RowVectorXd off = coordinates.row(axis_).array() - mean_;
      for (std::size_t i = 0; i < ends.size(); ++i)
        slope_ += off[Eigen::Index(i)] / off.squaredNorm() * (ends[i] - middle_);
    }
    for (Eigen::Index i = 0; i < vanished_.cols(); ++i)
      vanished_.col(i) = vanished(mesh.points.col(i));
  }

  const Eigen::Matrix3Xi& triangles() const { return mesh_.triangles; }

  /// \param left how much of it is left, in [0, 1]
  Points points(double left) const { return left * mesh_.points + (1 - left) * vanished_; }

  /// Where a point of the part is then.
  Point place(const Point& p, double left) const { return left * p + (1 - left) * vanished(p); }

private:
  /// Where nothing is left: on the line nearest to the anchors, between them.
  Point vanished(const Point& p) const
  {
    if (slope_.isZero(0)) return middle_;
    return middle_ + (std::clamp(chart_.coordinates(p)[axis_], low_, high_) - mean_) * slope_;
  }

  Part_chart chart_;
  Part_mesh mesh_;
  Points vanished_;                                      ///< of the mesh's points
  Point middle_ = Point::Zero(), slope_ = Point::Zero(); ///< of the anchors, along a coordinate
  Eigen::Index axis_ = 0;                                ///< that coordinate
  double low_ = 0, high_ = 0, mean_ = 0;                 ///< of the anchors' ones
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_FADING_PART_H
