// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches with user-defined weights of the costs of pairs of parts.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main(int argc, char** argv)
{
  const std::string source_file = argc > 1 ? argv[1] : DATA_DIR "/table_pedestal";
  const std::string target_file = argc > 2 ? argv[2] : DATA_DIR "/table_trestle";
  try {
    const auto a = SC::build_structural_graph(SC::IO::read_segmented_shape(source_file));
    const auto b = SC::build_structural_graph(SC::IO::read_segmented_shape(target_file));
    SC::Search_options options;
    options.parts.weights.place = 0;  // horizontal distances do not count: shapes may face any side
    options.parts.weights.extent = 2; // weight of differences of extents
    const SC::Correspondence c = SC::find_correspondence(a, b, options);
    for (const SC::Part_correspondence& pair : c.pairs)
      std::cout << SC::structure(a).parts[pair.source].name << " -> " << SC::structure(b).parts[pair.target].name
                << " with confidence " << pair.confidence << '\n';
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
