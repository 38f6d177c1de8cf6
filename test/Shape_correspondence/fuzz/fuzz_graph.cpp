// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target for readers of structural graphs: an input is refused, or gives a graph that can be written and read.

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>

using namespace CGAL::Shape_correspondence;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  Structural_graph graph;
  try {
    graph = IO::READER(in, "input");
  } catch (const Invalid_input&) {
    return 0;
  }
  std::stringstream again;
  IO::write_structural_graph_json(again, graph);
  IO::read_structural_graph_json(again, "again"); // throws if the program refuses its own output
  return 0;
}
