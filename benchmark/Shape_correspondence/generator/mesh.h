// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MESH_H

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

using Point = Eigen::Vector3d;
using Point_2 = Eigen::Vector2d;
/// A polyline, or a ring of points (not repeated at its end).
using Path = std::vector<Point>;

constexpr double pi = 3.14159265358979323846;

/// The coordinates of all models are multiples of this length, in metres; it is what five decimals can hold.
constexpr double grid_step = 1e-5;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<int, 3>> faces;
};

/// What a part is by construction, whatever its mesh looks like.
enum class Kind { curve, closed_curve, sheet };

/// Rows and columns of the mid-surface grid of a sheet.
constexpr int sheet_grid_size = 5;

/// A closed mesh and what it was made around: the points of a mid-line, or the grid of a mid-surface row by row.
struct Solid
{
  Mesh mesh;
  Kind kind = Kind::curve;
  Path mid;
};

/// Six times the signed volume over six: positive when the faces look outwards.
inline double volume(const Mesh& mesh)
{
  double sum = 0;
  for (const auto& f : mesh.faces)
    sum += mesh.points[f[0]].dot(mesh.points[f[1]].cross(mesh.points[f[2]]));
  return sum / 6;
}

inline void flip_faces(Mesh& mesh)
{
  for (auto& f : mesh.faces)
    std::swap(f[1], f[2]);
}

/// Turns a consistently oriented mesh so that its faces look outwards.
inline Mesh outward(Mesh mesh)
{
  if (volume(mesh) < 0) flip_faces(mesh);
  return mesh;
}

/// Appends `other` as further components.
inline void append(Mesh& mesh, const Mesh& other)
{
  const int shift = int(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& f : other.faces)
    mesh.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
}

/// The nearest multiple of `grid_step`. Ties are broken away from zero by a margin far above rounding errors, so that
/// the last printed decimal is the same on every machine and mirrored numbers stay mirrored.
inline double snapped(double x)
{
  constexpr double tie_margin = 1e-4;
  const double steps = std::floor(std::abs(x) / grid_step + 0.5 + tie_margin);
  return steps == 0 ? 0. : std::copysign(steps * grid_step, x);
}

inline Point snapped(const Point& p) { return {snapped(p.x()), snapped(p.y()), snapped(p.z())}; }

/// Applies `map` to every point, of the mesh and of the mid-line or mid-surface.
template <class Map>
Solid mapped(Solid solid, const Map& map)
{
  for (Point& p : solid.mesh.points)
    p = map(p);
  for (Point& p : solid.mid)
    p = map(p);
  return solid;
}

inline Solid snapped(const Solid& solid)
{
  return mapped(solid, [](const Point& p) { return snapped(p); });
}

/// The mirror image in the plane where a coordinate is 0, outward again, points and faces in the same order.
inline Solid mirrored(const Solid& solid, int axis = 0)
{
  Solid result = mapped(solid, [axis](Point p) {
    p[axis] = p[axis] == 0 ? 0. : -p[axis];
    return p;
  });
  flip_faces(result.mesh);
  return result;
}

inline Solid transformed(const Solid& solid, const Eigen::Isometry3d& motion)
{
  return mapped(solid, [&](const Point& p) -> Point { return motion * p; });
}

inline Solid translated(const Solid& solid, const Point& by)
{
  return mapped(solid, [&](const Point& p) -> Point { return p + by; });
}

/// The rotation by `angle` about the line through `point` along `axis`.
inline Eigen::Isometry3d rotation_about(const Point& point, const Point& axis, double angle)
{
  return Eigen::Translation3d(point) * Eigen::AngleAxisd(angle, axis.normalized()) * Eigen::Translation3d(-point);
}

/// The motion that takes the y axis to the line from `from` to `to`, the origin to `from`, by the smallest turn.
inline Eigen::Isometry3d stand_on(const Point& from, const Point& to)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::Quaterniond::FromTwoVectors(Point::UnitY(), to - from).toRotationMatrix();
  motion.translation() = from;
  return motion;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MESH_H
