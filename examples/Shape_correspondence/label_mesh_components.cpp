// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Transfers labels between two surface meshes of several closed components, as a CGAL pipeline has them: from the
// components of the first to the faces of the second, which is written to labelled.ply.
#include <CGAL/Shape_correspondence.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SC = CGAL::Shape_correspondence;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Component_map = Mesh::Property_map<Mesh::Face_index, std::size_t>;

void add_box(Mesh& mesh, double x, double y, double z, double width, double height, double depth)
{
  const auto corner = [&](int i, int j, int k) {
    return Kernel::Point_3(x + i * width, y + j * height, z + k * depth);
  };
  Mesh box;
  CGAL::make_hexahedron(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1),
                        corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), box);
  CGAL::copy_face_graph(box, mesh);
}

// A table with four legs
Mesh legged_table()
{
  Mesh mesh;
  add_box(mesh, 0, .7, 0, 1.6, .05, .8);
  for (double x : {.04, 1.5})
    for (double z : {.04, .7})
      add_box(mesh, x, 0, z, .06, .7, .06);
  return mesh;
}

Mesh panelled_table()
{
  Mesh mesh;
  add_box(mesh, 0, .7, 0, 1.6, .05, .8);
  for (double x : {.06, 1.5})
    add_box(mesh, x, 0, 0, .04, .7, .8);
  return mesh;
}

int main()
{
  Mesh source = legged_table(), target = panelled_table();
  const std::vector<std::string> labels{"top", "leg", "leg", "leg", "leg"}; // label of each component of the source

  // The parts are the connected components; any other map from faces to segment ids will do
  Component_map source_parts = source.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  Component_map target_parts = target.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  PMP::connected_components(source, source_parts);
  PMP::connected_components(target, target_parts);

  // Part indices are segment ids, since parts are added in ascending order of their ids
  const auto a = SC::build_structural_graph(SC::Segmented_shape::from_segmentation(source, source_parts, "source"));
  const auto b = SC::build_structural_graph(SC::Segmented_shape::from_segmentation(target, target_parts, "target"));
  const SC::Correspondence correspondence = SC::find_correspondence(a, b);

  // A target part takes the label of a source part that corresponds to it
  std::vector<std::string> target_labels(SC::structure(b).parts.size(), "unmatched");
  for (const SC::Part_correspondence& pair : correspondence.pairs)
    target_labels[pair.target] = labels[pair.source];
  for (std::size_t part = 0; part < target_labels.size(); ++part)
    std::cout << "part " << part << " of the target: " << target_labels[part] << '\n';

  // The pipeline continues with the mesh, where a property says whether a face is of a leg
  auto is_leg = target.add_property_map<Mesh::Face_index, int>("f:is_leg").first;
  for (const Mesh::Face_index face : target.faces())
    is_leg[face] = target_labels[target_parts[face]] == "leg";
  std::ofstream out("labelled.ply");
  return CGAL::IO::write_PLY(out, target) ? 0 : 1;
}
