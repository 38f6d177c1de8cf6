// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "hand_made_graphs.h"
#include "matching/coarse_to_fine.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

// Boxes in a row, each touching the next: large ones at both ends, and others whose heights differ by multiples of
// `step`, in increasing order, or scattered if `scatter` is above 1.
Structural_graph row(int parts, double step, int scatter = 1)
{
  Segmented_shape shape;
  for (int i = 0; i < parts; ++i) {
    const double height = i == 0 || i == parts - 1 ? 3 + step : 1 + step * (i * scatter % parts);
    shape.add_part("box " + std::to_string(i), box_shapes::box(Point(i, height / 2, 0), Point(1, height, 1)));
  }
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  options.symmetry.enabled = false;
  return build_structural_graph(shape, options);
}

Search_options search(Search_method method, int coarse_to_fine)
{
  Search_options options;
  options.method = method;
  options.coarse_to_fine = coarse_to_fine;
  return options;
}

bool tells(const Correspondence& found)
{
  return std::any_of(found.warnings.begin(), found.warnings.end(),
                     [](const std::string& line) { return line.find("matched first") != std::string::npos; });
}

} // namespace

TEST_CASE("Coarse to fine: candidates for a group are near the images of the large parts near the group")
{
  const auto shape = std::make_shared<Deformable_shape>(align_shape(row(7, 0.01)));
  const Group_candidates allowed = internal::coarse_candidates(shape, shape, search(Search_method::EXACT, 2));
  REQUIRE(allowed.size() == 7);
  // Boxes from left to right: A b c d e f G; A and G are large. b and c are nearest to A, d to both, e and f to G. e
  // touches d, so that it is near A, too
  const auto at = [&](std::size_t original) {
    const auto found = std::find(shape->original.begin(), shape->original.end(), original);
    return shape->group_of[std::size_t(found - shape->original.begin())];
  };
  const auto places_of = [&](std::size_t original) {
    std::vector<std::size_t> result;
    for (std::size_t other = 0; other < 7; ++other) {
      const auto& groups = allowed[at(original)];
      if (std::find(groups.begin(), groups.end(), at(other)) != groups.end()) result.push_back(other);
    }
    return result;
  };
  using Places = std::vector<std::size_t>;
  CHECK(places_of(0) == Places{0, 1, 2, 3, 4});
  CHECK(places_of(1) == Places{0, 1, 2, 3, 4});
  CHECK(places_of(3) == Places{0, 1, 2, 3, 4, 5, 6});
  CHECK(places_of(5) == Places{2, 3, 4, 5, 6});
  CHECK(internal::coarse_candidates(shape, shape, search(Search_method::EXACT, 7)).empty());
}

TEST_CASE("Coarse to fine: a shape matches itself; no energy is below the minimum; the summary says what was done")
{
  for (const Search_method method : {Search_method::BEAM, Search_method::EXACT}) {
    const Structural_graph one = row(9, 0.01), other = row(9, 0.1);
    const Correspondence self = find_correspondence(one, one, search(method, 3));
    CHECK(self.energy == 0);
    CHECK(tells(self));

    const Correspondence direct = find_correspondence(one, other, search(Search_method::EXACT, 0)),
                         coarse = find_correspondence(one, other, search(method, 3)),
                         all = find_correspondence(one, other, search(Search_method::EXACT, 9));
    CHECK(direct.optimal);
    CHECK(!coarse.optimal);
    CHECK(coarse.energy >= direct.energy - 1e-9);
    CHECK(coarse.complete);
    CHECK(all.energy == direct.energy);
    CHECK(all.optimal);
    CHECK(!tells(all));
  }
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), search(Search_method::BEAM, -1)), Invalid_input);
}

TEST_CASE("Coarse to fine: symmetry groups, directions, pinned pairs and unmatched parts as in a search at once")
{
  Search_options options = search(Search_method::EXACT, 2);
  const Correspondence there = find_correspondence(chair(), slatted_chair(), options),
                       back = find_correspondence(slatted_chair(), chair(), options);
  CHECK(there.energy == Approx(back.energy));
  CHECK(there.pairs.size() == back.pairs.size());
  options.energy.pinned = {{2, 5}}; // legs, which are too small for the coarse search
  const Correspondence pinned = find_correspondence(chair(), slatted_chair(), options);
  CHECK(std::count_if(pinned.pairs.begin(), pinned.pairs.end(),
                      [](const Part_correspondence& pair) { return pair.source == 2 && pair.target == 5; }) == 1);
  options.energy.pinned.clear();
  options.energy.unmatched_cost = 0;
  CHECK(find_correspondence(chair(), slatted_chair(), options).energy == 0); // nothing is matched
}

TEST_CASE("Coarse to fine: shapes of more groups than a search takes at once")
{
  const Structural_graph one = row(151, 0.005, 60), other = row(151, 0.005, 70);
  Search_options options = search(Search_method::BEAM, 0);
  options.both_directions = false;
  const Correspondence by_itself = find_correspondence(one, other, options);
  CHECK(by_itself.complete);
  REQUIRE(!by_itself.warnings.empty());
  CHECK_THAT(by_itself.warnings.front(), Catch::Matchers::Contains("50 largest parts were matched first"));
  options.coarse_to_fine = 40;
  const Correspondence found = find_correspondence(one, other, options);
  CHECK(found.complete);
  CHECK(found.unmatched_source.empty());
}
