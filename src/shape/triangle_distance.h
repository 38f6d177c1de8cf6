// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/clamped.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace contacts {

using Triangle = std::array<Point, 3>;

/// The normal of the triangle, of length twice its area.
inline Point area_vector(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

inline Point centre(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3; }

} // namespace contacts

inline contacts::Triangle triangle_of(const Points& points, const Eigen::Matrix3Xi& triangles, Eigen::Index t)
{
  return {points.col(triangles(0, t)), points.col(triangles(1, t)), points.col(triangles(2, t))};
}

inline contacts::Triangle triangle_of(const Part_mesh& mesh, Eigen::Index t)
{
  return triangle_of(mesh.points, mesh.triangles, t);
}

inline std::vector<contacts::Triangle> triangles_of(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  std::vector<contacts::Triangle> result;
  result.reserve(std::size_t(triangles.cols()));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    result.push_back(triangle_of(points, triangles, t));
  return result;
}

inline std::vector<contacts::Triangle> triangles_of(const Part_mesh& mesh)
{
  return triangles_of(mesh.points, mesh.triangles);
}

namespace contacts {

/// A point of each of two sets, and the squared distance of these points.
struct Closest_pair
{
  double squared = std::numeric_limits<double>::infinity();
  Point first = Point::Zero(), second = Point::Zero();

  void improve(const Point& p, const Point& q)
  {
    const double candidate = (p - q).squaredNorm();
    if (candidate < squared) *this = {candidate, p, q};
  }
};

/// The point of the segment from `a` to `b` nearest to `p`.
inline Point nearest_on_segment(const Point& p, const Point& a, const Point& b)
{
  const double length = (b - a).squaredNorm();
  return length > 0 ? Point(a + clamped_to_unit((p - a).dot(b - a) / length) * (b - a)) : a;
}

constexpr double parallel_squared_sine = 1e-24; // squared sine below which segments count as parallel

/// The point of the sides of the triangle nearest to `p`.
inline Point nearest_on_sides(const Point& p, const Triangle& t)
{
  Point best = nearest_on_segment(p, t[0], t[1]);
  for (int i = 1; i < 3; ++i) {
    const Point candidate = nearest_on_segment(p, t[i], t[(i + 1) % 3]);
    if ((candidate - p).squaredNorm() < (best - p).squaredNorm()) best = candidate;
  }
  return best;
}

/// The point of the triangle nearest to `p`. Signs of dot products tell whether it is a corner, on a side or inside
/// (Ericson, Real-Time Collision Detection, 2005, section 5.1.5), unless the triangle is a needle.
inline Point nearest_on_triangle(const Point& p, const Triangle& t)
{
  constexpr double needle_squared_sine = 1e-8; // at smaller angles, dot products lose half of their digits
  const Point u = t[1] - t[0], v = t[2] - t[0], from_first = p - t[0], normal = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const auto projected = [&] { return Point(p - normal.dot(from_first) / normal.squaredNorm() * normal); };
  if (normal.squaredNorm() <= needle_squared_sine * uu * vv) {
    bool inside = normal.squaredNorm() > parallel_squared_sine * uu * vv;
    for (int i = 0; i < 3 && inside; ++i)
      inside = normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) >= 0;
    return inside ? projected() : nearest_on_sides(p, t);
  }
  const double u0 = u.dot(from_first), v0 = v.dot(from_first); // dot products from the first corner, with two sides
  if (u0 <= 0 && v0 <= 0) return t[0];
  const double u1 = u0 - uu, v1 = v0 - uv; // dot products from the second corner
  if (u1 >= 0 && v1 <= u1) return t[1];
  const double u2 = u0 - uv, v2 = v0 - vv; // dot products from the third corner
  if (v2 >= 0 && u2 <= v2) return t[2];
  if (u0 * v1 <= u1 * v0 && u0 >= 0 && u1 <= 0) return nearest_on_segment(p, t[0], t[1]);
  if (u2 * v0 <= u0 * v2 && v0 >= 0 && v2 <= 0) return nearest_on_segment(p, t[2], t[0]);
  if (u1 * v2 <= u2 * v1 && v1 >= u1 && u2 >= v2) return nearest_on_segment(p, t[1], t[2]);
  return projected();
}

/// Replaces `best` by the closest points of the segments ab and cd if these are closer.
inline void improve_by_segments(const Point& a, const Point& b, const Point& c, const Point& d, Closest_pair& best)
{
  const Point u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  const double s = determinant > 0 ? clamped_to_unit((uv * vw - vv * uw) / determinant) : 0;
  const Point q = nearest_on_segment(a + s * u, c, d);
  best.improve(nearest_on_segment(q, a, b), q);
}

/// Where the line from `from` along `direction` goes through the triangle, as a multiple of `direction`; nowhere if it
/// runs in the triangle's plane, or if the triangle is a needle.
inline std::optional<double> crossing(const Point& from, const Point& direction, const Triangle& t)
{
  const Point u = t[1] - t[0], v = t[2] - t[0], across = direction.cross(v);
  const double determinant = u.dot(across);
  if (determinant * determinant <= parallel_squared_sine * u.squaredNorm() * v.squaredNorm() * direction.squaredNorm())
    return std::nullopt;
  const Point to = from - t[0], turned = to.cross(u);
  const double x = to.dot(across) / determinant, y = direction.dot(turned) / determinant;
  if (x < 0 || y < 0 || x + y > 1) return std::nullopt;
  return v.dot(turned) / determinant;
}

/// Whether an edge of `a` goes through `b`; `best` then becomes the crossing point.
inline bool improve_by_crossing(const Triangle& a, const Triangle& b, Closest_pair& best)
{
  for (int i = 0; i < 3; ++i) {
    const Point side = a[(i + 1) % 3] - a[i];
    const std::optional<double> at = crossing(a[i], side, b);
    if (!at || *at < 0 || *at > 1) continue;
    const Point p = a[i] + *at * side;
    best = {0, p, p};
    return true;
  }
  return false;
}

/// Whether a triangle is on one side of another one's plane, farther from it than the root of `squared`: a test that
/// is much cheaper than the distance of the triangles.
inline bool is_off_plane(const Triangle& plane, const Triangle& t, double squared)
{
  constexpr double rounding = 1 + 1e-9;
  const Point normal = area_vector(plane);
  const double a = normal.dot(t[0] - plane[0]), b = normal.dot(t[1] - plane[0]), c = normal.dot(t[2] - plane[0]);
  const double least = std::max(std::min({a, b, c}), -std::max({a, b, c}));
  return least > 0 && least * least > rounding * squared * normal.squaredNorm();
}

/// Replaces `best` by the closest points of two triangles if these are closer.
/// \param limit squared distance: closest points farther apart than this may be missed
inline void improve_by_triangles(const Triangle& a, const Triangle& b, Closest_pair& best, double limit)
{
  if (is_off_plane(a, b, limit) || is_off_plane(b, a, limit)) return;
  if (improve_by_crossing(a, b, best) || improve_by_crossing(b, a, best)) return;
  for (int i = 0; i < 3; ++i) {
    best.improve(a[i], nearest_on_triangle(a[i], b));
    best.improve(nearest_on_triangle(b[i], a), b[i]);
    for (int j = 0; j < 3; ++j)
      improve_by_segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], best);
  }
}

/// Whether two triangles are within the root of `squared` of each other.
inline bool are_within(const Triangle& a, const Triangle& b, double squared)
{
  if (is_off_plane(a, b, squared) || is_off_plane(b, a, squared)) return false;
  Closest_pair best;
  for (int i = 0; i < 3; ++i) {
    best.improve(a[i], nearest_on_triangle(a[i], b));
    best.improve(nearest_on_triangle(b[i], a), b[i]);
    if (best.squared <= squared) return true;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      improve_by_segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], best);
      if (best.squared <= squared) return true;
    }
  return improve_by_crossing(a, b, best) || improve_by_crossing(b, a, best);
}

} // namespace contacts
} // namespace CGAL::Shape_correspondence::internal
