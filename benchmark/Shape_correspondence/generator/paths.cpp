// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "paths.h"

namespace CGAL::Shape_correspondence::generator {

Point between(const Point& a, const Point& b, double t) { return a + t * (b - a); }

Path line(const Point& a, const Point& b, int pieces)
{
  Path path;
  for (int i = 0; i <= pieces; ++i)
    path.push_back(between(a, b, double(i) / pieces));
  return path;
}

double length(const Path& path)
{
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += (path[i] - path[i - 1]).norm();
  return sum;
}

Path spline(const Path& knots, int pieces)
{
  const int n = int(knots.size());
  Path path;
  for (int k = 0; k + 1 < n; ++k) {
    const Point &b = knots[k], &c = knots[k + 1];
    const Point a = k > 0 ? knots[k - 1] : Point(2 * b - c);
    const Point d = k + 2 < n ? knots[k + 2] : Point(2 * c - b);
    for (int i = 0; i < pieces; ++i) {
      const double t = double(i) / pieces;
      path.push_back(0.5 *
                     (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) + t * t * t * (3 * b - 3 * c + d - a)));
    }
  }
  path.push_back(knots.back());
  return path;
}

Path with_mirror_image(const Path& left_half)
{
  Path path;
  for (std::size_t i = left_half.size() - 1; i > 0; --i)
    path.push_back({-left_half[i].x(), left_half[i].y(), left_half[i].z()});
  path.insert(path.end(), left_half.begin(), left_half.end());
  return path;
}

Path bent(const Path& corners, double radius, int pieces)
{
  constexpr int bend_pieces = 4;
  Path path{corners.front()};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Point &corner = corners[k], before = (corners[k - 1] - corner).normalized(),
                after = (corners[k + 1] - corner).normalized();
    const Point start = corner + radius * before, end = corner + radius * after, last = path.back();
    for (int i = 1; i < pieces; ++i)
      path.push_back(between(last, start, double(i) / pieces));
    for (int i = 0; i <= bend_pieces; ++i) {
      const double t = double(i) / bend_pieces;
      path.push_back(between(between(start, corner, t), between(corner, end, t), t));
    }
  }
  const Point last = path.back();
  for (int i = 1; i <= pieces; ++i)
    path.push_back(between(last, corners.back(), double(i) / pieces));
  return path;
}

Path circle(const Point& centre, const Point& axis, double radius, int n)
{
  const Point w = axis.normalized();
  const Point u = (std::abs(w.y()) > 0.9 ? Point::UnitZ() : Point::UnitY()).cross(w).normalized(), v = w.cross(u);
  Path path;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * (i + 0.5) / n;
    path.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return path;
}

Section oval(const Point_2& start, const Point_2& end, int n)
{
  auto ring = [=](double t, double inset) {
    const Point_2 half = start + t * (end - start) - Point_2(inset, inset);
    Ring_2 points;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * pi * (i + 0.5) / n;
      points.push_back({half.x() * std::cos(angle), half.y() * std::sin(angle)});
    }
    return points;
  };
  return {ring, chamfer_ratio * std::min(start.minCoeff(), end.minCoeff())};
}

Section round_section(double start, double end, int n) { return oval({start, start}, {end, end}, n); }

Section round_section(double radius, int n) { return round_section(radius, radius, n); }

Section bar(const Point_2& start, const Point_2& end)
{
  auto ring = [=](double t, double inset) {
    const Point_2 full = (start + t * (end - start)) / 2, half = full - Point_2(inset, inset);
    const double bevel = chamfer_ratio * full.minCoeff();
    const double x = half.x(), y = half.y(), u = x - bevel, v = y - bevel;
    return Ring_2{{x, -v}, {x, 0},  {x, v},   {u, y},   {0, y},  {-u, y},
                  {-x, v}, {-x, 0}, {-x, -v}, {-u, -y}, {0, -y}, {u, -y}};
  };
  return {ring, chamfer_ratio * std::min(start.minCoeff(), end.minCoeff()) / 2};
}

Section bar(double width, double height) { return bar({width, height}, {width, height}); }

} // namespace CGAL::Shape_correspondence::generator
