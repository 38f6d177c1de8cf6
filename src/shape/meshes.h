// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Mesh_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh_point = Mesh_kernel::Point_3;
using Halfedge_mesh = CGAL::Surface_mesh<Mesh_point>;

inline Point to_point(const Mesh_point& p) { return {p.x(), p.y(), p.z()}; }
inline Mesh_point to_mesh_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// Triangles as ranges of indices, the input of CGAL's functions for polygon soups.
struct Triangle_soup
{
  std::vector<Mesh_point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

Triangle_soup to_soup(const Part_mesh& mesh);

/// The triangles of all meshes, one mesh after the other.
Part_mesh joined(const std::vector<const Part_mesh*>& meshes);

/// The triangles as a manifold, consistently oriented.
/// \param changed if not null, set to whether points were merged, triangles left out or vertices doubled
Halfedge_mesh manifold_surface(const Part_mesh& mesh, bool* changed = nullptr);

/// The triangles of a mesh. \pre `mesh` has no garbage, that is no elements marked as removed
Part_mesh to_part_mesh(const Halfedge_mesh& mesh);

/// The mesh of triangles. \pre they make a manifold, consistently oriented
Halfedge_mesh to_halfedge_mesh(const Part_mesh& mesh);

} // namespace CGAL::Shape_correspondence::internal
