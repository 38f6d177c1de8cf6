// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_models.h"

#include <CGAL/Shape_correspondence/match_as_in_paper.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace CGAL::Shape_correspondence;

TEST_CASE("The paper's method from surfaces on: graphs by the flow, then the paper's search")
{
  const Segmented_shape stand = box_models::model_of(box_models::stand()).shape;
  const Paper_match match = match_as_in_paper(stand, stand);
  const Structure_options options = paper_structure_options();
  CHECK(are_same_structural_graphs(match.source, build_structural_graph(stand, options)));
  const std::vector<Part_abstraction>& parts = structure(match.target).parts;
  CHECK(std::any_of(parts.begin(), parts.end(), [](const Part_abstraction& part) {
    return part.report.method == Abstraction_report::Method::MESO_SKELETON;
  }));
  const Correspondence expected = find_correspondence(match.source, match.target, paper_options());
  CHECK(match.correspondence.energy == expected.energy);
  CHECK(match.correspondence.pairs.size() == 3);
}
