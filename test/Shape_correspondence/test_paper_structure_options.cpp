// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_models.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/paper_structure_options.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace CGAL::Shape_correspondence;

TEST_CASE("The paper's method from surfaces on: graphs by the flow, then the paper's search")
{
  const Segmented_shape stand = box_models::model_of(box_models::stand()).shape;
  const Structural_graph graph = build_structural_graph(stand, paper_structure_options());
  const std::vector<Part_abstraction>& parts = structure(graph).parts;
  CHECK(std::any_of(parts.begin(), parts.end(), [](const Part_abstraction& part) {
    return part.report.method == Abstraction_report::Method::MESO_SKELETON;
  }));
  CHECK(find_correspondence(graph, graph, paper_options()).pairs.size() == 3);
}
