// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A connected component of an object; triangles are connected through vertices at the same place.
struct Loose_piece
{
  std::size_t object = 0;
  Part_mesh mesh;    ///< its triangles as they are in the model
  Part_mesh surface; ///< the same surface in canonical triangles, of which the members below are measured
  double area = 0;
  Point middle = Point::Zero();            ///< centre of the surface
  double size = 0;                         ///< approximate diameter, see `size_of()`
  bool closed = false;                     ///< an even number of triangles meets at every edge
  std::vector<std::size_t> triangles = {}; ///< indices of triangles of the object; empty for a segment
};

/// The connected components of a mesh, in the order of their first triangles.
/// \param tolerance greatest distance from a flat face that counts as rounding noise, see `canonical_surface()`
/// \param materials indexed by triangle; triangles of different materials are not connected; if empty, all have one
std::vector<Loose_piece> loose_pieces(std::size_t object, const Part_mesh& mesh, double tolerance,
                                      const std::vector<int>& materials);

/// The mesh of some triangles, with only the vertices that they use.
/// \param number scratch memory, indexed by vertex of `mesh`: -1 before and after the call
Part_mesh extracted(const Part_mesh& mesh, const std::vector<std::size_t>& triangles, std::vector<int>& number);

/// A piece with its measures. \param tolerance as for `loose_pieces()`
Loose_piece loose_piece(std::size_t object, Part_mesh mesh, double tolerance);

/// Approximate diameter of a set: the greatest distance of a point from the point that is farthest from the middle.
double size_of(const Points& points, const Point& middle);

} // namespace CGAL::Shape_correspondence::internal
