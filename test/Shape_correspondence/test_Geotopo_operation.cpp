// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Geotopo_operation.h>
#include <CGAL/Shape_correspondence/Search_summary.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <string>
#include <utility>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Every operation has the name that results give it")
{
  for (const auto& [operation, name] :
       {std::pair(Operation::MATCH, "match"), std::pair(Operation::SPLIT, "split"),
        std::pair(Operation::DUPLICATE, "duplicate"), std::pair(Operation::MERGE, "merge"),
        std::pair(Operation::CUT, "cut"), std::pair(Operation::JOIN, "join"), std::pair(Operation::NONE, "none")})
    CHECK(name_of(operation) == std::string(name));
}

TEST_CASE("The summary of a search names its method, and no result costs less than its lower bound")
{
  Search_options options;
  for (const auto& [method, name] : {std::pair(Search_method::PARTS, "parts"), std::pair(Search_method::BEAM, "beam"),
                                     std::pair(Search_method::EXACT, "exact")}) {
    options.method = method;
    const Correspondence found = find_correspondence(hand_made::table(), hand_made::pedestal_table(), options);
    const Search_summary& summary = found.search;
    CHECK(summary.method == name);
    CHECK(summary.lower_bound <= found.energy + 1e-9);
  }
}
