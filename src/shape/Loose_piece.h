// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A connected component of an object, by places of vertices.
struct Loose_piece
{
  std::size_t object;
  Part_mesh mesh;
  double area;
  double size;                  ///< approximate diameter, see `size_of()`
  bool closed;                  ///< an even number of triangles meets at every edge
  std::set<int> materials = {}; ///< empty: not known
};

/// The connected components of a mesh, connected through vertices at the same place, in the order of first triangles.
/// \param materials by triangle. Empty: they are not known
/// \param divide only triangles of one material are connected
std::vector<Loose_piece> loose_pieces(std::size_t object, const Part_mesh& mesh, const std::vector<int>& materials = {},
                                      bool divide = false);

/// Measures a piece.
Loose_piece loose_piece(std::size_t object, Part_mesh mesh);

/// Points on the edges of only one triangle, at most `spacing` apart.
Points border_points(const Part_mesh& mesh, double spacing);

/// Approximate diameter: the distance between the point farthest from the middle and the one farthest from that.
double size_of(const Points& points, const Point& middle);

} // namespace CGAL::Shape_correspondence::internal
