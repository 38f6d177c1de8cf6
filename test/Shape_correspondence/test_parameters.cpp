// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/parameters.h>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Named parameters set the fields of the option structures, in any order")
{
  const auto np = parameters::expansions(7).beam_width(3).solutions(4);
  const auto options = parameters::options_from<Search_options>(np);
  CHECK(options.beam.expansions == 7);
  CHECK(options.beam.beam_width == 3);
  CHECK(options.solutions == 4);
  CHECK(options.energy.weights.connectedness == 0.6); // the default, since it is not given

  const auto structure = parameters::options_from<Structure_options>(parameters::contact_tolerance(0.1));
  CHECK(structure.contacts.tolerance == 0.1);
  CHECK(structure.symmetry.enabled);
}

TEST_CASE("Functions take named parameters where they take options")
{
  const Structural_graph chair = hand_made::chair();
  CHECK(find_correspondence(chair, chair, parameters::maximum_parts(2)).pairs.size() == 2);
  CHECK(find_correspondence(chair, chair, CGAL::parameters::default_values()).pairs.size() == 6);
}
