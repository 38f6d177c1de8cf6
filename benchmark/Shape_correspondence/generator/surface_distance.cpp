// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface_distance.h"

namespace CGAL::Shape_correspondence::generator {

Box box_of(const std::vector<Point>& points)
{
  Box box;
  for (const Point& p : points)
    box.extend(p);
  return box;
}

double squared_distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - std::min(1., std::max(0., t)) * (b - a)).squaredNorm();
}

double squared_distance(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const Point normal = (b - a).cross(c - a);
  auto inside = [&](const Point& from, const Point& to) { return normal.dot((to - from).cross(p - from)) >= 0; };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::pow(normal.dot(p - a), 2) / normal.squaredNorm();
  return std::min({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                   squared_distance_to_segment(p, c, a)});
}

bool crosses(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c)
{
  auto side = [](const Point& u, const Point& v, const Point& w, const Point& x) {
    return (v - u).cross(w - u).dot(x - u) > 0;
  };
  return side(a, b, c, p) != side(a, b, c, q) && side(p, q, a, b) == side(p, q, b, c) &&
         side(p, q, b, c) == side(p, q, c, a);
}

double squared_distance_of_segments(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Point u = b - a, v = d - c, normal = u.cross(v);
  if (normal.squaredNorm() > 1e-12 * u.squaredNorm() * v.squaredNorm()) {
    const double s = (c - a).cross(v).dot(normal) / normal.squaredNorm();
    const double t = (c - a).cross(u).dot(normal) / normal.squaredNorm();
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return std::pow((c - a).dot(normal), 2) / normal.squaredNorm();
  }
  return std::min({squared_distance_to_segment(a, c, d), squared_distance_to_segment(b, c, d),
                   squared_distance_to_segment(c, a, b), squared_distance_to_segment(d, a, b)});
}

double squared_distance_of_triangles(const std::array<Point, 3>& a, const std::array<Point, 3>& b)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Point &p = a[i], &q = a[(i + 1) % 3], &r = b[i], &s = b[(i + 1) % 3];
    if (crosses(p, q, b[0], b[1], b[2]) || crosses(r, s, a[0], a[1], a[2])) return 0;
    least = std::min({least, squared_distance(p, b[0], b[1], b[2]), squared_distance(r, a[0], a[1], a[2])});
    for (int j = 0; j < 3; ++j)
      least = std::min(least, squared_distance_of_segments(p, q, b[j], b[(j + 1) % 3]));
  }
  return least;
}

std::array<Point, 3> corners(const Mesh& mesh, const std::array<int, 3>& face)
{
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]};
}

double surface_distance(const Mesh& one, const Mesh& other, double limit)
{
  double least = limit * limit;
  const Box all = box_of(other.points);
  for (const auto& f : one.faces) {
    const std::array<Point, 3> a = corners(one, f);
    const Box box_a = box_of({a.begin(), a.end()});
    if (box_a.squaredExteriorDistance(all) >= least) continue;
    for (const auto& g : other.faces) {
      const std::array<Point, 3> b = corners(other, g);
      const Box box_b(b[0].cwiseMin(b[1]).cwiseMin(b[2]), b[0].cwiseMax(b[1]).cwiseMax(b[2]));
      if (box_a.squaredExteriorDistance(box_b) < least) least = std::min(least, squared_distance_of_triangles(a, b));
    }
    if (least == 0) break;
  }
  return std::sqrt(least);
}

} // namespace CGAL::Shape_correspondence::generator
