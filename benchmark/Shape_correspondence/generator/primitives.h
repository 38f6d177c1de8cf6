// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "paths.h"

#include <cmath>

namespace CGAL::Shape_correspondence::generator {

/// Joins rings of equally many points by quadrilaterals cut in two; the first and the last ring are closed by fans
/// about `first_tip` and `last_tip`, or joined to each other when `closed`.
Mesh loft(const std::vector<Path>& rings, bool closed, const Point& first_tip, const Point& last_tip);

Point centroid(const Path& ring);

Mesh loft(const std::vector<Path>& rings);

/// The direction of a path at its point `i`.
Point tangent(const Path& path, bool closed, int i);

/// Rotation-minimising normals along a path (double reflection), the first one nearest to `hint`.
Path normals(const Path& path, bool closed, const Point& hint);

/// Whether a solid of these extents is a plate, not a bar: flat and not much longer than wide, or a thin blade.
bool is_plate(double length, double width, double thickness);

/// The point at `t` in [0, 1] of a polyline whose points have evenly spaced parameters.
Point point_at(const Path& path, double t);

/// The sheet grid of a surface given by its points at (u, v) in [0, 1]^2.
template <class Surface>
Path sheet_grid(const Surface& surface)
{
  Path grid;
  for (int i = 0; i < sheet_grid_size; ++i)
    for (int j = 0; j < sheet_grid_size; ++j)
      grid.push_back(surface(double(i) / (sheet_grid_size - 1), double(j) / (sheet_grid_size - 1)));
  return grid;
}

/// States that a flat tube is of kind sheet. \param across the wider half axis of the section at each point of the path
void state_flat_tube(Solid& solid, const Path& path, const Path& across);

/// A section swept along a path; its kind is curve, or sheet if it is a plate. The section's first axis starts nearest
/// to `hint`, or to y if the path starts along `hint`. A closed path must lie in a plane.
Solid tube(Path path, const Section& section, Point hint = Point::UnitX(), bool closed = false);

/// A straight tube. The section's first axis is y for a tube along x, and x for a tube along y or z.
Solid beam(const Point& from, const Point& to, const Section& section, int pieces = 5);

Solid torus(const Point& centre, const Point& axis, double radius, const Section& section, int n = 32);

/// The profile of a surface of revolution: (radius, height), from the axis to the axis.
using Profile = std::vector<Point_2>;

Path circle_about_y(double radius, double height, int n);

Mesh revolved(const Profile& profile, int n);

/// A solid of revolution about the y axis, of kind curve.
Solid post(const Profile& profile, int n = 12);

/// Maps the square [-1, 1]^2 to the unit disc.
Point_2 square_to_disc(const Point_2& p);

/// Length and width of a surface: those of a parallelogram with middle lines and diagonals of the same lengths.
template <class Surface>
Point_2 length_and_width(const Surface& surface)
{
  constexpr int pieces = 8;
  auto squared_length = [&](auto point) {
    Path path;
    for (int i = 0; i <= pieces; ++i)
      path.push_back(point(double(i) / pieces));
    return length(path) * length(path);
  };
  const double uu = squared_length([&](double t) { return Point(surface(t, 0.5)); });
  const double vv = squared_length([&](double t) { return Point(surface(0.5, t)); });
  const double uv = (squared_length([&](double t) { return Point(surface(t, t)); }) -
                     squared_length([&](double t) { return Point(surface(t, 1 - t)); })) /
                    4;
  const double mean = (uu + vv) / 2, spread = std::hypot((uu - vv) / 2, uv);
  return {std::sqrt(mean + spread), std::sqrt(std::max(mean - spread, 0.))};
}

/// The solid of a mesh about a mid-surface: of kind sheet, or curve with the longer middle line if it is a bar.
template <class Surface>
Solid plate_or_bar(const Mesh& mesh, const Surface& surface)
{
  const Point_2 size = length_and_width(surface);
  if (is_plate(size.x(), size.y(), volume(mesh) / size.prod())) return {mesh, Kind::sheet, sheet_grid(surface)};
  Path along_u, along_v;
  for (double t : {0., .125, .25, .375, .5, .625, .75, .875, 1.}) {
    along_u.push_back(surface(t, 0.5));
    along_v.push_back(surface(0.5, t));
  }
  return {mesh, Kind::curve, length(along_u) > length(along_v) ? along_u : along_v};
}

/// A plate of revolution about the y axis, of kind sheet; its mid-surface is the disc of `radius` at `height`.
Solid disc(const Profile& profile, double radius, double height, int n = 32);

/// The profile of a flat disc between two heights with bevelled edges.
Profile disc_profile(double radius, double low, double high, double bevel);

/// A surface patch: points at (u, v) in [0, 1]^2.
using Surface = std::function<Point(double, double)>;

struct Slab_options
{
  int rows = 6, columns = 6;
  /// Share of the half size by which the corners are moved inwards, below 0.2, from which on the surface folds.
  double corner = 0;
  /// Width of the bevel of the edges over the thickness, below one half.
  double bevel = 0.2;
};

/// The patch with its corners moved inwards, see `Slab_options::corner`.
Surface with_round_corners(const Surface& patch, double corner);

/// The unit normal of a surface, by differences that stay inside the patch.
Point normal_of(const Surface& surface, double u, double v);

/// Row and column of the points around the border of a grid of rows x columns cells, in order.
std::vector<std::array<int, 2>> grid_border(int rows, int columns);

void add_quad(Mesh& mesh, int a, int b, int c, int d);

/// The points of a slab: the grid of its top, that of its bottom, and around it an upper and a lower edge.
std::vector<Point> slab_points(const Surface& surface, double thickness, const Slab_options& options);

/// A plate of constant thickness about a patch, with bevelled edges; its kind is that of `plate_or_bar()`.
Solid slab(const Surface& patch, double thickness, const Slab_options& options = {});

/// The flat patch with corner `origin` and edges `u_edge` and `v_edge`.
Surface flat(const Point& origin, const Point& u_edge, const Point& v_edge);

/// A horizontal plate: its middle, its width (x), depth (z) and thickness (y).
Solid board(const Point& middle, double width, double depth, double thickness, const Slab_options& options = {});

/// One cross-section of a wing: its leading edge, chord (to the back, -z) and thickness.
struct Wing_station
{
  Point leading_edge;
  double chord, thickness;
};

/// Half thickness of a wing of thickness 1 at `c` of its chord; 0: leading edge, 1: trailing edge, which is blunt.
double wing_half_thickness(double c);

Path wing_ring(const Wing_station& station, const Point& upwards);

/// A wing through its stations from root to tip; its kind is that of `plate_or_bar()`; `upwards` is across the wing.
Solid wing(const std::vector<Wing_station>& stations, const Point& upwards, int pieces = 4);

/// One cross-section of a hull along z: its middle and half axes.
struct Hull_station
{
  double z, y, half_width, half_height;
};

/// A body through its oval stations from nose to tail, of kind curve.
Solid hull(const std::vector<Hull_station>& stations, int n = 16, int pieces = 2);

} // namespace CGAL::Shape_correspondence::generator
