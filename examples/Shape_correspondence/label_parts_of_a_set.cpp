// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Co-analysis: labels parts consistently over a set of shapes.
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

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
  const std::vector<std::string> names{"chair_four_legged", "chair_slatted", "chair_spindle", "stool"};
  const std::vector<SC::Structural_graph> shapes = read_shapes(names);
  const SC::Energy_matrix matrix = SC::energy_matrix<CGAL::Parallel_if_available_tag>(shapes);

  std::vector<std::size_t> part_counts;
  std::vector<SC::Shape_pair_map> maps;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    part_counts.push_back(SC::structure(shapes[i]).parts.size());
    for (std::size_t j = 0; j < shapes.size(); ++j)
      if (i != j) maps.push_back({i, j, matrix.map(i, j)});
  }
  SC::Co_analysis_options options;
  options.clustering.inflation = 1.5; // a low inflation gives few and large clusters
  const SC::Co_analysis labels = SC::co_analysis(part_counts, maps, options);

  for (int label = 0; label < labels.number_of_labels; ++label) {
    std::cout << "label " << label << ':';
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (std::size_t part = 0; part < part_counts[i]; ++part)
        if (labels.labels[i][part] == label)
          std::cout << ' ' << names[i] << '/' << SC::structure(shapes[i]).parts[part].name;
    std::cout << '\n';
  }
}
