// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of single parts, given by formulas.
#ifndef SHAPE_CORRESPONDENCE_TEST_PART_MESHES_H
#define SHAPE_CORRESPONDENCE_TEST_PART_MESHES_H

#include <CGAL/Shape_correspondence/abstract_part.h>

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

namespace part_meshes {

using namespace CGAL::Shape_correspondence;

inline Part_mesh box(const Point& low, const Point& high)
{
  Part_mesh result;
  result.points.resize(3, 8);
  for (int v = 0; v < 8; ++v) {
    result.points.col(v) << (v & 1 ? high : low).x(), (v & 2 ? high : low).y(), (v & 4 ? high : low).z();
  }
  result.triangles.resize(3, 12);
  result.triangles << 0, 3, 4, 7, 0, 5, 2, 7, 0, 6, 1, 7, //
      2, 1, 5, 6, 1, 4, 6, 3, 4, 2, 3, 5,                 //
      3, 0, 7, 4, 5, 0, 7, 2, 6, 0, 7, 1;
  return result;
}

inline Part_mesh bipyramid(int sides)
{
  Part_mesh result;
  result.points.resize(3, sides + 2);
  result.triangles.resize(3, 2 * sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * EIGEN_PI * i / sides;
    result.points.col(i) << std::cos(angle), std::sin(angle), 0;
    result.triangles.col(2 * i) << i, (i + 1) % sides, sides;
    result.triangles.col(2 * i + 1) << (i + 1) % sides, i, sides + 1;
  }
  result.points.rightCols(2) << 0, 0, 0, 0, 1, -1;
  return result;
}

/// A closed surface over a grid that is periodic in both directions; `f` is a function of two angles.
template <typename Function>
inline Part_mesh torus_like(int n, int m, const Function& f)
{
  Part_mesh result;
  result.points.resize(3, n * m);
  result.triangles.resize(3, 2 * n * m);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const int a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
      result.points.col(a) = f(2 * EIGEN_PI * i / n, 2 * EIGEN_PI * j / m);
      result.triangles.col(2 * a) << a, b, c;
      result.triangles.col(2 * a + 1) << a, c, d;
    }
  }
  return result;
}

inline Part_mesh torus(double radius, double thickness)
{
  return torus_like(40, 12, [=](double u, double v) {
    const double r = radius + thickness * std::cos(v);
    return Point(r * std::cos(u), thickness * std::sin(v), r * std::sin(u));
  });
}

/// A closed surface of revolution about y with a profile of points (radius, height), which starts and ends on the axis.
inline Part_mesh turned(const std::vector<Eigen::Vector2d>& profile, int n = 24)
{
  const int rings = int(profile.size());
  Part_mesh result;
  result.points.resize(3, rings * n);
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < n; ++j) {
      const double angle = 2 * EIGEN_PI * j / n, radius = profile[std::size_t(i)].x();
      result.points.col(i * n + j) << radius * std::cos(angle), profile[std::size_t(i)].y(), radius * std::sin(angle);
      if (i + 1 < rings) {
        const int a = i * n + j, b = i * n + (j + 1) % n;
        triangles.emplace_back(a, a + n, b + n);
        triangles.emplace_back(a, b + n, b);
      }
    }
  }
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.triangles.col(Eigen::Index(t)) = triangles[t];
  }
  return result;
}

/// A cushion in the plane y = 0 with a superellipse as outline: an ellipse for exponent 2, nearly a rectangle for
/// a large one.
inline Part_mesh cushion(const Point& size, double exponent)
{
  const int rings = 16;
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = EIGEN_PI * (double(i) / rings - 0.5);
    profile.emplace_back(std::cos(angle), std::sin(angle));
  }
  Part_mesh result = turned(profile, 48);
  for (Eigen::Index v = 0; v < result.points.cols(); ++v) {
    const Eigen::Vector2d across(result.points(0, v), result.points(2, v));
    const double norm = std::pow(across.array().abs().pow(exponent).sum(), 1 / exponent);
    const double stretched = norm > 0 ? across.norm() / norm : 1;
    result.points.col(v).array() *= 0.5 * size.array() * Eigen::Array3d(stretched, 1, stretched);
  }
  return result;
}

/// A plate of given thickness along half a cylinder of radius 1, with `width` along the axis y.
inline Part_mesh half_pipe(double width, double thickness)
{
  const int n = 24;
  Part_mesh result;
  result.points.resize(3, 4 * (n + 1));
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i <= n; ++i) {
    const double angle = EIGEN_PI * i / n;
    for (int k = 0; k < 4; ++k) {
      const double r = 1 + (k == 1 || k == 2 ? 0.5 : -0.5) * thickness;
      result.points.col(4 * i + k) << r * std::cos(angle), k < 2 ? 0 : width, r * std::sin(angle);
      const int a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      if (i < n) {
        triangles.emplace_back(a, b, b + 4);
        triangles.emplace_back(a, b + 4, a + 4);
      }
    }
  }
  triangles.insert(triangles.end(),
                   {{0, 2, 1}, {0, 3, 2}, {4 * n, 4 * n + 1, 4 * n + 2}, {4 * n, 4 * n + 2, 4 * n + 3}});
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.triangles.col(Eigen::Index(t)) = triangles[t];
  }
  return result;
}

inline Part_mesh joined(const Part_mesh& a, const Part_mesh& b)
{
  Part_mesh result;
  result.points.resize(3, a.points.cols() + b.points.cols());
  result.points.leftCols(a.points.cols()) = a.points;
  result.points.rightCols(b.points.cols()) = b.points;
  result.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  result.triangles.leftCols(a.triangles.cols()) = a.triangles;
  result.triangles.rightCols(b.triangles.cols()) = (b.triangles.array() + int(a.points.cols())).matrix();
  return result;
}

inline Part_mesh without_triangles(const Part_mesh& mesh, Eigen::Index count)
{
  return {mesh.points, mesh.triangles.rightCols(mesh.triangles.cols() - count)};
}

inline Part_mesh moved(const Part_mesh& mesh, const Eigen::Matrix3d& linear, const Point& offset)
{
  return {(linear * mesh.points).colwise() + offset, mesh.triangles};
}

inline Part_abstraction abstraction_of(const Part_mesh& mesh) { return abstract_part({"part", mesh}); }

const Part_mesh leg = box({0, 0, 0}, {0.1, 1, 0.1});
const Part_mesh plate = box({0, 0, 0}, {1, 0.06, 0.8});

} // namespace part_meshes

#endif // SHAPE_CORRESPONDENCE_TEST_PART_MESHES_H
