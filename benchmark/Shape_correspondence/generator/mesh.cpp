// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh.h"

namespace CGAL::Shape_correspondence::generator {

double volume(const Mesh& mesh)
{
  double sum = 0;
  for (const auto& f : mesh.faces)
    sum += mesh.points[f[0]].dot(mesh.points[f[1]].cross(mesh.points[f[2]]));
  return sum / 6;
}

void flip_faces(Mesh& mesh)
{
  for (auto& f : mesh.faces)
    std::swap(f[1], f[2]);
}

Mesh outward(Mesh mesh)
{
  if (volume(mesh) < 0) flip_faces(mesh);
  return mesh;
}

void append(Mesh& mesh, const Mesh& other)
{
  const int shift = int(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& f : other.faces)
    mesh.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
}

double snapped(double x)
{
  constexpr double tie_margin = 1e-4;
  const double steps = std::floor(std::abs(x) / grid_step + 0.5 + tie_margin);
  return steps == 0 ? 0. : std::copysign(steps * grid_step, x);
}

Point snapped(const Point& p) { return {snapped(p.x()), snapped(p.y()), snapped(p.z())}; }

Solid snapped(const Solid& solid)
{
  return mapped(solid, [](const Point& p) { return snapped(p); });
}

Solid mirrored(const Solid& solid, int axis)
{
  Solid result = mapped(solid, [axis](Point p) {
    p[axis] = p[axis] == 0 ? 0. : -p[axis];
    return p;
  });
  flip_faces(result.mesh);
  return result;
}

Solid transformed(const Solid& solid, const Eigen::Isometry3d& motion)
{
  return mapped(solid, [&](const Point& p) -> Point { return motion * p; });
}

Solid translated(const Solid& solid, const Point& by)
{
  return mapped(solid, [&](const Point& p) -> Point { return p + by; });
}

Eigen::Isometry3d rotation_about(const Point& point, const Point& axis, double angle)
{
  return Eigen::Translation3d(point) * Eigen::AngleAxisd(angle, axis.normalized()) * Eigen::Translation3d(-point);
}

Eigen::Isometry3d stand_on(const Point& from, const Point& to)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::Quaterniond::FromTwoVectors(Point::UnitY(), to - from).toRotationMatrix();
  motion.translation() = from;
  return motion;
}

} // namespace CGAL::Shape_correspondence::generator
