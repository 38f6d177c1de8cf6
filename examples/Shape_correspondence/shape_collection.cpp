// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the shapes of a set: all pairwise energies, the medoid, a minimum spanning tree, and nearest shapes.
#include <CGAL/Shape_correspondence/IO/matrix_files.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>
#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#include <iostream>

namespace SC = CGAL::Shape_correspondence;

// Bounding boxes are rough abstractions, but computed fast
std::vector<SC::Structural_graph> read_shapes(const std::vector<std::string>& names)
{
  SC::Structure_options options;
  options.abstraction.abstractor = SC::Bounding_box_abstraction();
  std::vector<SC::Structural_graph> shapes;
  for (const std::string& name : names)
    shapes.push_back(SC::build_structural_graph(SC::IO::read_segmented_shape(DATA_DIR "/" + name), options));
  return shapes;
}

int main()
{
  const std::vector<std::string> names{"chair_four_legged", "chair_slatted", "chair_spindle", "stool",
                                       "table_four_legged"};
  const std::vector<SC::Structural_graph> shapes = read_shapes(names);

  const SC::Energy_matrix matrix = SC::energy_matrix<CGAL::Parallel_if_available_tag>(shapes);
  SC::IO::write_csv(std::cout, matrix.energies, names);

  const Eigen::MatrixXd distances = SC::symmetric_distances(matrix.energies);
  std::cout << "medoid: " << names[SC::topological_medoid(distances)] << "\nspanning tree:\n";
  for (const auto& [a, b] : SC::minimum_spanning_tree(distances))
    std::cout << "  " << names[a] << " - " << names[b] << '\n';

  // The shapes nearest to a query, without matching it with all shapes
  const SC::Structural_graph query = read_shapes({"table_trestle"}).front();
  const SC::Nearest_shapes nearest = SC::nearest_shapes(query, shapes, 2);
  std::cout << "nearest to the trestle table, matched with " << nearest.evaluations << " shapes:\n";
  for (const SC::Near_shape& near : nearest.shapes)
    std::cout << "  " << names[near.shape] << " at " << near.distance << '\n';
}
