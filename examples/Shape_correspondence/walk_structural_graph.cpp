// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Traverses a structural graph, which is a Boost graph, by breadth-first search: counts the contacts on the shortest
// path from every group to the lowest one.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <boost/graph/breadth_first_search.hpp>

#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : DATA_DIR "/table_trestle";
  const SC::Structural_graph graph = SC::build_structural_graph(SC::IO::read_segmented_shape(file));
  const SC::Shape_structure& shape = SC::structure(graph);

  // Start at the group whose lowest point is lowest
  std::size_t ground = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    for (std::size_t part : graph[v].parts) {
      const double y = shape.frame.to_frame(shape.parts[part].control_points()).row(1).minCoeff();
      if (y < lowest) lowest = y, ground = v;
    }

  std::vector<int> contacts_away(num_vertices(graph), 0);
  boost::breadth_first_search(
      graph, ground,
      boost::visitor(boost::make_bfs_visitor(boost::record_distances(contacts_away.data(), boost::on_tree_edge()))));

  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    std::cout << contacts_away[v] << " contact(s) away:";
    for (std::size_t part : graph[v].parts)
      std::cout << ' ' << shape.parts[part].name;
    std::cout << '\n';
  }
}
