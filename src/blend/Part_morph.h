// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_PART_MORPH_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_PART_MORPH_H

#include "map/Charted_mesh.h"

#include <optional>
#include <utility>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A surface that becomes another.
///
/// First the one surface, in the coordinates of its chart, moves to the nearest places of the other; then the other
/// takes over where the first has come to and what the first could not reach grows out of it. So both ends are exact,
/// nothing jumps, and the surface is that of one input or the other at any time: closed if both are.
class Part_morph
{
public:
  static constexpr double longest_edge = 0.3; ///< in chart coordinates

  /// \param forward whether the source's surface moves first; if not said, it is that of which less is left to grow
  Part_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target,
             const std::optional<bool>& forward = {})
  {
    source_ = charts.source;
    target_ = charts.target;
    const Charted_mesh a = finely_charted(source, source_, longest_edge);
    const Charted_mesh b = finely_charted(target, target_, longest_edge);
    if (forward) {
      forward_ = *forward;
      carriers_ = forward_ ? Carriers(a, b) : Carriers(b, a);
      return;
    }
    Carriers ahead(a, b), back(b, a);
    forward_ = ahead.second_reach <= back.second_reach;
    carriers_ = forward_ ? std::move(ahead) : std::move(back);
  }

  bool is_forward() const { return forward_; }

  /// The surfaces, the one at the source's end first.
  const Eigen::Matrix3Xi& triangles(int carrier) const { return moving(carrier).triangles; }

  /// Which of the surfaces there is at `t`.
  int carrier(double t) const { return t < switch_time() ? 0 : 1; }
  double switch_time() const { return forward_ ? carriers_.change : 1 - carriers_.change; }

  /// The points of a surface at `t`, also where it is not the one that there is.
  Points points(int carrier, double t) const
  {
    const Part_chart chart = Part_chart::between(source_, target_, t);
    const Moving& mesh = moving(carrier);
    const double own_time = forward_ ? t : 1 - t;
    const double moved = std::clamp((own_time - mesh.begin) / std::max(mesh.end - mesh.begin, 1e-12), 0., 1.);
    Points result(3, mesh.coordinates[0].cols());
    for (Eigen::Index i = 0; i < result.cols(); ++i) {
      const Point k = (1 - moved) * mesh.coordinates[0].col(i) + moved * mesh.coordinates[1].col(i);
      const Point off = (1 - own_time) * mesh.offsets[0].col(i) + own_time * mesh.offsets[1].col(i);
      result.col(i) = chart(k) + chart.frame(k) * off;
    }
    return result;
  }

private:
  struct Moving
  {
    Eigen::Matrix3Xi triangles;
    std::array<Points, 2> coordinates, offsets; ///< from, to
    double begin = 0, end = 1;                  ///< when it moves from the one to the other
  };

  struct Carriers
  {
    Moving first, second;
    double change = 1;       ///< when the second takes over
    double second_reach = 0; ///< how far the second still has to move, in coordinates

    Carriers() = default;
    Carriers(const Charted_mesh& a, const Charted_mesh& b)
    {
      const Points normals_a = chart_normals(a), normals_b = chart_normals(b);
      const Place_finder target(b.coordinates, b.triangles, normals_b);
      first = second = Moving();
      first.triangles = a.triangles;
      first.coordinates = {a.coordinates, a.coordinates};
      first.offsets = {a.offsets, a.offsets};
      for (Eigen::Index i = 0; i < a.points.cols(); ++i) {
        const Mesh_place place = target(a.coordinates.col(i), normals_a.col(i));
        first.coordinates[1].col(i) = place.of(b.coordinates, b.triangles);
        first.offsets[1].col(i) = place.of(b.offsets, b.triangles);
      }
      const Place_finder reached(first.coordinates[1], a.triangles, normals_a);
      second.triangles = b.triangles;
      second.coordinates = {b.coordinates, b.coordinates};
      second.offsets = {b.offsets, b.offsets};
      for (Eigen::Index i = 0; i < b.points.cols(); ++i) {
        const Mesh_place place = reached(b.coordinates.col(i), normals_b.col(i));
        second.coordinates[0].col(i) = place.of(first.coordinates[1], a.triangles);
        second.offsets[0].col(i) = place.of(a.offsets, a.triangles);
      }
      const double first_reach = reach(first);
      second_reach = reach(second);
      constexpr double shortest = 0.1; // so that what has a short way does not take it in an instant
      const double both = first_reach + second_reach;
      change = both > 0 ? std::clamp(first_reach / both, shortest, 1 - shortest) : 1;
      first.end = second.begin = change;
    }

    static double reach(const Moving& mesh)
    {
      return std::sqrt((mesh.coordinates[1] - mesh.coordinates[0]).colwise().squaredNorm().maxCoeff());
    }
  };

  const Moving& moving(int carrier) const { return (carrier == 0) == forward_ ? carriers_.first : carriers_.second; }

  Part_chart source_, target_;
  bool forward_ = true;
  Carriers carriers_;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_PART_MORPH_H
