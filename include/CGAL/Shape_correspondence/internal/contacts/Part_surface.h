// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACTS_PART_SURFACE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACTS_PART_SURFACE_H

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/contacts/sample_triangles.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {
namespace contacts {

using Box = Eigen::AlignedBox3d;

inline Box widened(const Box& box, double by)
{
  return Box(box.min() - Point::Constant(by), box.max() + Point::Constant(by));
}

/// A convex polygon, as clipping a triangle makes them.
using Polygon = std::vector<Point>;

/// The part of the polygon on the side of `bound` where `sign` * coordinate is smaller.
inline Polygon clipped(const Polygon& polygon, int axis, double bound, double sign)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = sign * (bound - p[axis]), b = sign * (bound - q[axis]);
    if (a >= 0) result.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) result.push_back(p + (a / (a - b)) * (q - p));
  }
  return result;
}

inline Polygon clipped(Polygon polygon, const Box& box)
{
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clipped(polygon, axis, box.max()[axis], 1);
    polygon = clipped(polygon, axis, box.min()[axis], -1);
  }
  return polygon;
}

inline void add_fan(const Polygon& polygon, std::vector<Sampled_triangle>& triangles)
{
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    const double area = u.cross(v).norm() / 2;
    if (area > 0) triangles.push_back({polygon[0], u, v, area});
  }
}

/// Triangles of a kernel in a tree.
template <typename Kernel>
class Triangle_tree
{
  using Triangle = typename Kernel::Triangle_3;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, typename std::vector<Triangle>::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

public:
  static typename Kernel::Point_3 to_cgal(const Point& p) { return {p.x(), p.y(), p.z()}; }
  static Triangle to_cgal(const std::array<Point, 3>& t) { return {to_cgal(t[0]), to_cgal(t[1]), to_cgal(t[2])}; }

  explicit Triangle_tree(const std::vector<std::array<Point, 3>>& triangles)
  {
    for (const std::array<Point, 3>& triangle : triangles)
      triangles_.push_back(to_cgal(triangle));
    tree_.rebuild(triangles_.begin(), triangles_.end());
  }
  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  const Tree& tree() const { return tree_; }

private:
  std::vector<Triangle> triangles_;
  Tree tree_;
};

/// The surface of a part, ready for distance and intersection queries.
class Part_surface
{
  using Fast = CGAL::Simple_cartesian<double>;                       // for distances
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel; // for intersections, which are seldom asked for

public:
  /// \param points of the mesh, in the coordinates that queries come in
  Part_surface(const Points& points, const Eigen::Matrix3Xi& triangles)
      : corners_(proper_triangles(points, triangles)), distances_(corners_)
  {
    for (const std::array<Point, 3>& triangle : corners_)
      for (const Point& corner : triangle)
        box_.extend(corner);
  }

  const Box& box() const { return box_; }
  const Point& any_point() const { return corners_.front()[0]; }

  Point nearest(const Point& p) const
  {
    const Fast::Point_3 q = distances_.tree().closest_point(Triangle_tree<Fast>::to_cgal(p));
    return Point(q.x(), q.y(), q.z());
  }

  bool intersects(const Part_surface& other) const
  {
    if (!box_.intersects(other.box_)) return false;
    const Triangle_tree<Exact> others(other.corners_);
    for (std::size_t t = 0; t < corners_.size(); ++t)
      if (triangle_box(t).intersects(other.box_) &&
          others.tree().do_intersect(Triangle_tree<Exact>::to_cgal(corners_[t])))
        return true;
    return false;
  }

  /// Whether `p` is inside, by the majority of three rays, so that a small hole does no harm.
  bool encloses(const Point& p) const
  {
    const std::array<Point, 3> directions = {Point(1, 0.1234, 0.0567), Point(-0.0891, 1, 0.1417),
                                             Point(0.1031, -0.0713, 1)};
    int odd = 0;
    for (const Point& d : directions) {
      const Fast::Ray_3 ray(Triangle_tree<Fast>::to_cgal(p), Fast::Vector_3(d.x(), d.y(), d.z()));
      odd += distances_.tree().number_of_intersected_primitives(ray) % 2;
    }
    return odd >= 2;
  }

  /// About `n` points on the surface inside `region`; where it has few corners, those, too, at no area.
  Surface_samples sample(const Box& region, int n) const
  {
    std::vector<Sampled_triangle> pieces;
    std::vector<Point> vertices;
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      if (!triangle_box(t).intersects(region)) continue;
      const Polygon polygon = clipped(Polygon(corners_[t].begin(), corners_[t].end()), region);
      add_fan(polygon, pieces);
      vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
    Surface_samples samples = sample_triangles(pieces, n);
    if (vertices.size() <= static_cast<std::size_t>(n)) {
      samples.points.insert(samples.points.end(), vertices.begin(), vertices.end());
      samples.areas.resize(samples.points.size(), 0.0);
    }
    return samples;
  }

private:
  /// The triangles that are not degenerate.
  static std::vector<std::array<Point, 3>> proper_triangles(const Points& points, const Eigen::Matrix3Xi& triangles)
  {
    std::vector<std::array<Point, 3>> result;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      std::array<Point, 3> corners;
      for (int i = 0; i < 3; ++i)
        corners[i] = points.col(triangles(i, t));
      if (!Triangle_tree<Exact>::to_cgal(corners).is_degenerate()) result.push_back(corners);
    }
    return result;
  }

  Box triangle_box(std::size_t t) const
  {
    return Box(corners_[t][0].cwiseMin(corners_[t][1]).cwiseMin(corners_[t][2]),
               corners_[t][0].cwiseMax(corners_[t][1]).cwiseMax(corners_[t][2]));
  }

  std::vector<std::array<Point, 3>> corners_;
  Triangle_tree<Fast> distances_;
  Box box_;
};

} // namespace contacts
} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACTS_PART_SURFACE_H
