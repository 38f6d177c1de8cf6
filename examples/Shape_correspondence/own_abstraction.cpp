// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// A user-defined abstraction: a straight line for chosen parts, the package's default abstraction for all others.

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <iostream>

namespace SC = CGAL::Shape_correspondence;

/// A model of `PartAbstractor`: a straight line for parts whose names begin with "leg".
struct Straight_legs
{
  SC::Part_abstraction operator()(const SC::Shape_part& part, const SC::Abstraction_options& options) const
  {
    if (part.name.rfind("leg", 0) != 0) return SC::Fitted_abstraction()(part, options);
    const SC::Point low = part.mesh.points.rowwise().minCoeff(), high = part.mesh.points.rowwise().maxCoeff();
    int axis = 0;
    (high - low).maxCoeff(&axis);
    SC::Curve curve;
    curve.points = (0.5 * (low + high)).replicate(1, 2);
    curve.points.row(axis) << low[axis], high[axis];
    SC::Part_abstraction result;
    result.geometry = curve;
    return result;
  }
};

int main(int argc, char* argv[])
{
  SC::Structure_options options;
  options.abstraction.abstractor = Straight_legs();
  options.abstraction.part_kinds["seat"] = SC::Abstraction_kind::SHEET;
  try {
    const SC::Segmented_shape shape =
        SC::IO::read_segmented_shape(argc > 1 ? argv[1] : DATA_DIR "/chair_slatted/parts");
    const SC::Structural_graph graph = SC::build_structural_graph<CGAL::Parallel_if_available_tag>(shape, options);
    for (const SC::Part_abstraction& part : structure(graph).parts)
      std::cout << part.name << ": " << (part.is_sheet() ? "sheet" : "curve") << " of " << part.control_points().cols()
                << " points\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
