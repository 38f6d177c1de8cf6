// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/Triangle_tree.h"
#include "shape/alpha_wrap.h"
#include "shape/meshes.h"

#include <CGAL/version.h>

// What alpha wrapping asks of an oracle is internal to CGAL, and another version may ask something else: this oracle is
// for CGAL 5.5. Others wrap with the one of CGAL.
#if CGAL_VERSION_NR < 1050600000
#define CGAL_SHAPE_CORRESPONDENCE_HAS_WRAP_ORACLE

#include <CGAL/Alpha_wrap_3/internal/Alpha_wrap_3.h>
#include <CGAL/Alpha_wrap_3/internal/Alpha_wrap_AABB_traits.h>
#include <CGAL/Alpha_wrap_3/internal/offset_intersection.h>
#include <CGAL/Bbox_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A closed tetrahedron as the intersection of half-spaces, larger by the rounding error.
class Solid_tetrahedron
{
public:
  /// \pre the corners are positively oriented
  explicit Solid_tetrahedron(const std::array<Point, 4>& corners)
  {
    const double rounding = 1e-12; // over the size; wraps keep a distance of 1/600 of it
    // The faces' corners, seen from outside
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    for (const Point& corner : corners)
      box_.extend(corner);
    const double tolerance = rounding * box_.diagonal().norm();
    for (int i = 0; i < 4; ++i) {
      const Point &a = corners[faces[i][0]], &b = corners[faces[i][1]], &c = corners[faces[i][2]];
      normals_[i] = (b - a).cross(c - a).normalized();
      ends_[i] = normals_[i].dot(a) + tolerance;
    }
  }

  /// Whether a box may meet the tetrahedron.
  bool may_meet(const contacts::Box& box) const
  {
    if (!box_.intersects(box)) return false;
    const Point centre = box.center(), half = 0.5 * box.sizes();
    for (int i = 0; i < 4; ++i)
      if (normals_[i].dot(centre) - normals_[i].cwiseAbs().dot(half) > ends_[i]) return false;
    return true;
  }

  /// Whether a triangle meets the tetrahedron, by clipping it at every half-space.
  bool meets(const contacts::Triangle& t) const
  {
    for (int i = 0; i < 4; ++i)
      if (outside(i, t[0]) > 0 && outside(i, t[1]) > 0 && outside(i, t[2]) > 0) return false;
    std::array<Point, 7> polygons[2]; // before and after a cut, which adds one corner at most
    std::copy(t.begin(), t.end(), polygons[0].begin());
    std::size_t n = 3;
    for (int i = 0; i < 4 && n > 0; ++i)
      n = cut(i, polygons[i % 2], n, polygons[(i + 1) % 2]);
    return n > 0;
  }

private:
  /// Signed distance of a point from a half-space, positive outside.
  double outside(int i, const Point& p) const { return normals_[i].dot(p) - ends_[i]; }

  /// Clips a convex polygon at a half-space. \return the number of corners that are left
  std::size_t cut(int i, const std::array<Point, 7>& polygon, std::size_t n, std::array<Point, 7>& result) const
  {
    std::size_t kept = 0;
    double before = outside(i, polygon[n - 1]);
    for (std::size_t k = 0; k < n; ++k) {
      const Point &p = polygon[k > 0 ? k - 1 : n - 1], &q = polygon[k];
      const double now = outside(i, q);
      if ((before <= 0) != (now <= 0)) result[kept++] = p + before / (before - now) * (q - p);
      if (now <= 0) result[kept++] = q;
      before = now;
    }
    return kept;
  }

  std::array<Point, 4> normals_; ///< outwards
  std::array<double, 4> ends_;   ///< of the half-spaces, along the normals
  contacts::Box box_;
};

/// An oracle for CGAL's alpha wrapping in floating point; with CGAL's own, which is exact, predicates take most of the
/// time of a wrap. The wrap still encloses the surface, since the offset is far larger than rounding errors, but
/// rounding may decide which tetrahedra are carved.
class Wrap_oracle
{
public:
  using Geom_traits = CGAL::Alpha_wraps_3::internal::Alpha_wrap_AABB_traits<Mesh_kernel>;

  /// \pre there are triangles
  explicit Wrap_oracle(std::vector<contacts::Triangle> triangles) : tree_(std::move(triangles)) {}

  const Geom_traits& geom_traits() const { return traits_; }

  CGAL::Bbox_3 bbox() const
  {
    const Point low = tree_.box().min(), high = tree_.box().max();
    return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  }

  bool do_intersect(const Geom_traits::Ball_3& ball) const
  {
    return tree_.is_near(to_point(ball.boundary().center()), ball.boundary().squared_radius());
  }

  template <typename Kernel>
  bool do_intersect(const CGAL::Alpha_wraps_3::internal::Tetrahedron_with_outside_info<Kernel>& cell) const
  {
    std::array<Point, 4> corners;
    for (int i = 0; i < 4; ++i)
      corners[i] = to_point(cell.m_tet.vertex(i));
    const Solid_tetrahedron tetrahedron(corners);
    return tree_.any_triangle_of([&](const contacts::Box& box) { return tetrahedron.may_meet(box); },
                                 [&](const contacts::Triangle& t) { return tetrahedron.meets(t); });
  }

  Mesh_point closest_point(const Mesh_point& p) const { return to_mesh_point(tree_.nearest(to_point(p), near_)); }

  double squared_distance(const Mesh_point& p) const
  {
    const Point q = to_point(p);
    return (tree_.nearest(q, near_) - q).squaredNorm();
  }

  bool first_intersection(const Mesh_point& from, const Mesh_point& to, Mesh_point& result, double offset) const
  {
    const double precision = 1e-2 * offset, lipschitz = 1; // as CGAL's oracle
    const Distance distance{this};
    CGAL::Alpha_wraps_3::internal::Offset_intersection<Geom_traits, Distance> search(distance, offset, precision,
                                                                                     lipschitz);
    return search.first_intersection(from, to, result);
  }

private:
  struct Distance
  {
    double operator()(const Mesh_point& p) const { return std::sqrt(oracle->squared_distance(p)); }

    const Wrap_oracle* oracle;
  };

  Geom_traits traits_;
  contacts::Triangle_tree tree_;
  mutable std::size_t near_ = 0; ///< triangle of the last answer, a good guess for the next query
};

} // namespace CGAL::Shape_correspondence::internal

#endif
