// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target for matching random structural graphs, which the input seeds, with options from the input. The result is
// an error with a message, or consists of pairs of existing parts and finite numbers.

#include "random_graph.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>

using namespace CGAL::Shape_correspondence;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::seed_seq seed(data, data + size);
  std::mt19937 random(seed);
  try {
    const std::size_t most_parts = random() % 16 == 0 ? 60 : 8;
    const Structural_graph source = random_graph::graph(random, most_parts),
                           target = random_graph::graph(random, most_parts);
    Search_options options;
    options.method = random() % 3 == 0 && most_parts < 60 ? Search_method::BEAM : Search_method::PARTS;
    options.alignments = int(random() % 2);
    const Correspondence found = find_correspondence(source, target, options);
    for (const Part_correspondence& pair : found.pairs)
      if (pair.source >= structure(source).parts.size() || pair.target >= structure(target).parts.size()) std::abort();
    std::ostringstream text; // throws if a number is not finite
    IO::write_correspondence_json(text, found, source, target, "a", "b", {});
  } catch (const Invalid_input&) {
  }
  return 0;
}
