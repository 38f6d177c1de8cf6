// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_FADING_PART_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_FADING_PART_H

#include <CGAL/Shape_correspondence/internal/blend/Affine_moves.h>
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
    Points result(3, mesh_.points.cols());
    for (Eigen::Index i = 0; i < result.cols(); ++i)
      result.col(i) = place(mesh_.points.col(i), mesh_.coordinates.col(i), mesh_.offsets.col(i), left);
    return result;
  }

  /// Where a point of the part is then.
  Point place(const Point& p, double left) const
  {
    if (left >= 1) return p;
    const Point k = chart_.coordinates(p);
    return place(p, k, chart_.frame(k).inverse() * (p - chart_(k)), left);
  }

private:
  Point place(const Point& p, const Point& coordinates, const Point& offset, double left) const
  {
    if (kept_axis_ < 0) return left * p + (1 - left) * centre_;
    Point k = left * coordinates + (1 - left) * thread_;
    k[kept_axis_] = coordinates[kept_axis_];
    return chart_(k) + chart_.frame(k) * (left * offset);
  }

  Part_chart chart_;
  Charted_mesh mesh_;
  Point centre_, thread_;
  Eigen::Index kept_axis_ = -1;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_FADING_PART_H
