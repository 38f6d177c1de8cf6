// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::generator {

using Point = Eigen::Vector3d;
using Point_2 = Eigen::Vector2d;
/// A polyline, or a ring of points (not repeated at its end).
using Path = std::vector<Point>;

constexpr double pi = 3.14159265358979323846;

/// The coordinates of all models are multiples of this length, in metres; files have five decimals.
constexpr double grid_step = 1e-5;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<int, 3>> faces;
};

/// Whether a solid is constructed around an open mid-line, a closed one, or a mid-surface.
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

/// The signed volume of a closed mesh: positive if its faces are oriented outwards.
double volume(const Mesh& mesh);

void flip_faces(Mesh& mesh);

/// Orients the faces of a consistently oriented closed mesh outwards.
Mesh outward(Mesh mesh);

/// Appends `other` as further components.
void append(Mesh& mesh, const Mesh& other);

/// The nearest multiple of `grid_step`. Ties are broken away from zero by a margin far above rounding errors, so that
/// the last printed decimal is the same on every machine and mirrored numbers stay mirrored.
double snapped(double x);

Point snapped(const Point& p);

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

Solid snapped(const Solid& solid);

/// The mirror image in the plane where coordinate `axis` is 0, oriented outwards, points and faces in the same order.
Solid mirrored(const Solid& solid, int axis = 0);

Solid transformed(const Solid& solid, const Eigen::Isometry3d& motion);

Solid translated(const Solid& solid, const Point& by);

/// The rotation by `angle` about the line through `point` along `axis`.
Eigen::Isometry3d rotation_about(const Point& point, const Point& axis, double angle);

/// The motion that takes the y axis to the line from `from` to `to`, the origin to `from`, by the smallest turn.
Eigen::Isometry3d stand_on(const Point& from, const Point& to);

} // namespace CGAL::Shape_correspondence::generator
