// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A connected component of an object, by places of vertices.
struct Loose_piece
{
  std::size_t object = 0;
  Part_mesh mesh;    ///< its triangles as they are in the model
  Part_mesh surface; ///< the same in canonical triangles, which is what is measured
  double area = 0;
  Point middle = Point::Zero();            ///< centre of the surface
  double size = 0;                         ///< approximate diameter, see `size_of()`
  bool closed = false;                     ///< an even number of triangles meets at every edge
  std::vector<std::size_t> triangles = {}; ///< indices of triangles of the object; empty for a segment
};

/// The connected components of a mesh, connected through vertices at the same place, in the order of first triangles.
/// \param tolerance of `canonical_surface()`
/// \param materials by triangle: only those of one material are connected. Empty: there is one
std::vector<Loose_piece> loose_pieces(std::size_t object, const Part_mesh& mesh, double tolerance,
                                      const std::vector<int>& materials);

/// The mesh of some triangles, with only the vertices that they use.
/// \param number by vertex, -1, before and after
Part_mesh extracted(const Part_mesh& mesh, const std::vector<std::size_t>& triangles, std::vector<int>& number);

/// Measures a piece.
Loose_piece loose_piece(std::size_t object, Part_mesh mesh, double tolerance);

/// Approximate diameter: the distance between the point farthest from the middle and the one farthest from that.
double size_of(const Points& points, const Point& middle);

} // namespace CGAL::Shape_correspondence::internal
