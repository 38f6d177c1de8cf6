// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a shape of one mesh and a map from its faces to segment ids, as CGAL's surface mesh segmentation makes it; here
// the segments are the connected components.
#include <CGAL/Shape_correspondence.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace SC = CGAL::Shape_correspondence;

int main()
{
  // A stool in one mesh: a round seat and three legs
  Mesh mesh, part;
  CGAL::make_regular_prism(24, part, Kernel::Point_3(0, .45, 0), .05, .2);
  CGAL::copy_face_graph(part, mesh);
  for (int leg = 0; leg < 3; ++leg) {
    const double angle = leg * 2 * CGAL_PI / 3;
    part.clear();
    CGAL::make_regular_prism(12, part, Kernel::Point_3(.15 * std::cos(angle), 0, .15 * std::sin(angle)), .46, .015);
    CGAL::copy_face_graph(part, mesh);
  }

  const auto segment_ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  CGAL::Polygon_mesh_processing::connected_components(mesh, segment_ids);

  const SC::Structural_graph graph =
      SC::build_structural_graph(SC::Segmented_shape::from_segmentation(mesh, segment_ids, "stool"));
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    std::cout << "group " << v << ": " << graph[v].parts.size() << " part(s)\n";
}
