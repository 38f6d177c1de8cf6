// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches shapes made of CGAL meshes: a table with a top and four legs, and one that stands on two panels.
#include <CGAL/Shape_correspondence.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace SC = CGAL::Shape_correspondence;

Mesh box(double x, double y, double z, double width, double height, double depth)
{
  const auto corner = [&](int i, int j, int k) {
    return Kernel::Point_3(x + i * width, y + j * height, z + k * depth);
  };
  Mesh mesh;
  CGAL::make_hexahedron(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1),
                        corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), mesh);
  return mesh;
}

int main()
{
  const std::vector<std::pair<std::string, Mesh>> legged = {{"top", box(0, .7, 0, 1.6, .05, .8)},
                                                            {"leg front left", box(1.5, 0, .7, .06, .7, .06)},
                                                            {"leg front right", box(.04, 0, .7, .06, .7, .06)},
                                                            {"leg hind left", box(1.5, 0, .04, .06, .7, .06)},
                                                            {"leg hind right", box(.04, 0, .04, .06, .7, .06)}};
  const std::vector<std::pair<std::string, Mesh>> panelled = {{"plate", box(0, .7, 0, 1.6, .05, .8)},
                                                              {"panel left", box(1.5, 0, 0, .04, .7, .8)},
                                                              {"panel right", box(.06, 0, 0, .04, .7, .8)}};

  const auto source = SC::build_structural_graph(SC::Segmented_shape::from_meshes(legged, "legged"));
  const auto target = SC::build_structural_graph(SC::Segmented_shape::from_meshes(panelled, "panelled"));
  const SC::Correspondence correspondence = SC::find_correspondence(source, target);
  for (const SC::Part_correspondence& pair : correspondence.pairs)
    std::cout << legged[pair.source].first << " -> " << panelled[pair.target].first << '\n';
}
