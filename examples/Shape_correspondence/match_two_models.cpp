// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads two model files and prints their part correspondence.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main(int argc, char** argv)
{
  const std::string source_file = argc > 1 ? argv[1] : DATA_DIR "/chair_four_legged";
  const std::string target_file = argc > 2 ? argv[2] : DATA_DIR "/chair_slatted";
  try {
    // Every part becomes a curve or a sheet, parts become symmetry groups, groups and contacts a graph
    const SC::Structural_graph source =
        SC::build_structural_graph<CGAL::Parallel_if_available_tag>(SC::IO::read_segmented_shape(source_file));
    const SC::Structural_graph target =
        SC::build_structural_graph<CGAL::Parallel_if_available_tag>(SC::IO::read_segmented_shape(target_file));

    const SC::Correspondence correspondence =
        SC::find_correspondence(source, target, SC::parameters::min_confidence(0.3));

    std::cout << "energy " << correspondence.energy << '\n';
    for (const SC::Part_correspondence& pair : correspondence.pairs)
      std::cout << SC::structure(source).parts[pair.source].name << " -> "
                << SC::structure(target).parts[pair.target].name << '\n';
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
