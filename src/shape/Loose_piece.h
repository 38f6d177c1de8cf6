// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A piece of an object that hangs together.
struct Loose_piece
{
  std::size_t object;
  Part_mesh mesh;
  double area;
  double size;                  ///< about its diameter
  bool closed;                  ///< two triangles meet at every edge
  std::set<int> materials = {}; ///< empty: not known
};

/// The triangles that are connected through vertices at the same place, by their first triangles.
/// \param materials by triangle. Empty: they are not known
/// \param divide whether only triangles of one material are connected
std::vector<Loose_piece> loose_pieces(std::size_t object, const Part_mesh& mesh, const std::vector<int>& materials = {},
                                      bool divide = false);

/// Measures a piece.
Loose_piece loose_piece(std::size_t object, Part_mesh mesh);

/// Points on the edges of only one triangle, at most `spacing` apart.
Points border_points(const Part_mesh& mesh, double spacing);

/// About the diameter of points: the distance of the point farthest from the middle to the one farthest from that.
double size_of(const Points& points, const Point& middle);

} // namespace CGAL::Shape_correspondence::internal
