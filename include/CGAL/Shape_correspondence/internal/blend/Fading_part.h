// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_FADING_PART_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_FADING_PART_H

#include <CGAL/Shape_correspondence/internal/map/Charted_mesh.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A point that is to move, and where to.
struct Handle
{
  Point at, move;
};

/// Moves points along with handles: by the affine map nearest to all of them that changes shapes little where handles
/// do not ask for it.
inline void follow(const std::vector<Handle>& handles, Points& points)
{
  if (handles.empty()) return;
  constexpr double stiffness = 0.25; // over the squared size of what moves
  Point middle = Point::Zero(), move = Point::Zero();
  for (const Handle& handle : handles) {
    middle += handle.at / double(handles.size());
    move += handle.move / double(handles.size());
  }
  const Point size = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d spread = (stiffness * size.squaredNorm() + 1e-12) * Eigen::Matrix3d::Identity();
  for (const Handle& handle : handles) {
    across += (handle.move - move) * (handle.at - middle).transpose();
    spread += (handle.at - middle) * (handle.at - middle).transpose();
  }
  const Eigen::Matrix3d gradient = across * spread.inverse();
  points = (points + gradient * (points.colwise() - middle)).colwise() + move;
}

/// A part without counterpart. It shrinks to where it touches what stays; between contacts far from each other it
/// becomes a thread.
class Fading_part
{
public:
  /// \param anchors where it touches what it shrinks to; none: its own middle
  Fading_part(const Part_chart& chart, const Part_mesh& mesh, const std::vector<Point>& anchors)
      : chart_(chart), mesh_(charted_mesh(mesh, chart, std::numeric_limits<double>::infinity()))
  {
    constexpr double far_apart = 1; // in coordinates, of 2 from end to end
    std::vector<Point> ends = anchors;
    if (ends.empty()) ends.push_back(chart(Point::Zero()));
    Eigen::AlignedBox3d box;
    centre_ = Point::Zero();
    for (const Point& end : ends) {
      box.extend(chart.coordinates(end));
      centre_ += end / double(ends.size());
    }
    const double spread = box.sizes().maxCoeff(&kept_axis_);
    if (spread < far_apart) kept_axis_ = -1;
    thread_ = box.center().cwiseMax(-1).cwiseMin(1);
  }

  const Eigen::Matrix3Xi& triangles() const { return mesh_.triangles; }

  /// \param left how much of it is left, in [0, 1]
  Points points(double left) const
  {
    if (left >= 1) return mesh_.points;
    if (kept_axis_ < 0) return (left * (mesh_.points.colwise() - centre_)).colwise() + centre_;
    Points result(3, mesh_.points.cols());
    for (Eigen::Index i = 0; i < result.cols(); ++i) {
      Point k = left * mesh_.coordinates.col(i) + (1 - left) * thread_;
      k[kept_axis_] = mesh_.coordinates(kept_axis_, i);
      result.col(i) = chart_(k) + chart_.frame(k) * (left * mesh_.offsets.col(i));
    }
    return result;
  }

private:
  Part_chart chart_;
  Charted_mesh mesh_;
  Point centre_, thread_;
  Eigen::Index kept_axis_ = -1;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_FADING_PART_H
