// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches a shape with a piece of it, at least deformation energy, where parts may be left unmatched.
#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>

#include <iostream>

namespace SC = CGAL::Shape_correspondence;

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : DATA_DIR "/chair_four_legged";
  try {
    const SC::Structural_graph chair =
        SC::build_structural_graph<CGAL::Parallel_if_available_tag>(SC::IO::read_segmented_shape(file));
    const auto& parts = SC::structure(chair).parts;

    // The piece: the first group of parts and all that it touches
    std::vector<std::size_t> piece = chair[0].parts;
    for (const SC::Contact& contact : SC::structure(chair).contacts)
      for (std::size_t part : chair[0].parts)
        for (int side : {0, 1})
          if (contact.parts[side] == part) piece.push_back(contact.parts[1 - side]);

    SC::Search_options options;
    options.method = SC::Search_method::EXACT;
    options.both_directions = false;
    options.target_parts = piece;
    options.energy.unmatched_cost = 0.1; // energy of an unmatched group, for each of its contacts
    const SC::Correspondence found = SC::find_correspondence(chair, chair, options);

    for (const SC::Part_correspondence& pair : found.pairs)
      std::cout << parts[pair.source].name << " -> " << parts[pair.target].name << '\n';
    for (std::size_t part : found.unmatched_source)
      std::cout << parts[part].name << " is not in the piece\n";
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
