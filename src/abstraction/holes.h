// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/meshes.h"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/version.h>

#include <iterator>
#include <vector>

// Functions of CGAL whose names or parameters differ between its versions

namespace CGAL::Shape_correspondence::internal {

inline std::vector<Halfedge_mesh::Halfedge_index> borders_of(const Halfedge_mesh& mesh)
{
  std::vector<bool> is_known(mesh.num_halfedges());
  std::vector<Halfedge_mesh::Halfedge_index> result;
  for (auto h : mesh.halfedges()) {
    if (!mesh.is_border(h) || is_known[h.idx()]) continue;
    result.push_back(h);
    for (auto next : CGAL::halfedges_around_face(h, mesh))
      is_known[next.idx()] = true;
  }
  return result;
}

template <typename Parameters>
void fill_hole(Halfedge_mesh& mesh, Halfedge_mesh::Halfedge_index border, const Parameters& parameters)
{
#if CGAL_VERSION_NR < 1050600000
  std::vector<Halfedge_mesh::Face_index> patch; // output that CGAL requires
  CGAL::Polygon_mesh_processing::triangulate_hole(mesh, border, std::back_inserter(patch), parameters);
#else
  CGAL::Polygon_mesh_processing::triangulate_hole(mesh, border, parameters);
#endif
}

} // namespace CGAL::Shape_correspondence::internal
