// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "labelled_furniture.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/nearest_shapes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace CGAL::Shape_correspondence;

namespace {

// A graph whose parts are displaced at random, together with their contacts.
Structural_graph shaken(Structural_graph graph, double by, std::mt19937& random)
{
  const auto amount = [&] { return by * (double(random() % 1001) / 500 - 1); };
  for (Part_abstraction& part : structure(graph).parts) {
    const Point shift(amount(), amount(), amount());
    std::visit([&](auto& geometry) { geometry.points.colwise() += shift; }, part.geometry);
  }
  return graph;
}

std::vector<Structural_graph> many_shapes()
{
  std::mt19937 random(7);
  const std::vector<Structural_graph> models{hand_made::chair(), hand_made::slatted_chair(), hand_made::table(),
                                             hand_made::pedestal_table()};
  std::vector<Structural_graph> result;
  for (int i = 0; i < 32; ++i)
    result.push_back(shaken(models[std::size_t(i) % 4], .01 * i, random));
  return result;
}

// The sorted distances of all shapes, computed by matching all.
std::vector<std::pair<double, std::size_t>> all_distances(const Structural_graph& query,
                                                          const std::vector<Structural_graph>& shapes,
                                                          const Energy_matrix_options& options)
{
  std::vector<std::pair<double, std::size_t>> result;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Energy_matrix pair = energy_matrix({query, shapes[i]}, options);
    result.emplace_back((pair.energies(0, 1) + pair.energies(1, 0)) / 2, i);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST_CASE("The nearest shapes are those that matching all finds, by every method, from fewer matches")
{
  const std::vector<Structural_graph> shapes = many_shapes();
  for (Search_method method : {Search_method::PARTS, Search_method::BEAM, Search_method::EXACT})
    for (const Structural_graph& query :
         {hand_made::chair(), hand_made::pedestal_table(), hand_made::slatted_chair()}) {
      Energy_matrix_options options;
      options.search.method = method;
      const auto expected = all_distances(query, shapes, options);
      const Nearest_shapes found = nearest_shapes(query, shapes, 3, options);
      REQUIRE(found.shapes.size() == 3);
      for (std::size_t n = 0; n < 3; ++n) {
        CHECK(found.shapes[n].shape == expected[n].second);
        CHECK(found.shapes[n].distance == expected[n].first);
      }
      CHECK(found.shapes[0].map == energy_matrix({query, shapes[found.shapes[0].shape]}, options).map(0, 1));
      CHECK(found.evaluations < shapes.size());
    }
}

TEST_CASE("No distance is less than its bound, whatever the options")
{
  const std::vector<Structural_graph> shapes = many_shapes();
  std::vector<Search_options> all(6);
  all[1].min_confidence = .7;
  all[2].energy.norm = Energy_norm::POOLED;
  all[3].alignments = 0;
  all[4].method = Search_method::EXACT;
  all[4].energy.unmatched_cost = .2;
  all[5].method = Search_method::BEAM;
  all[5].both_directions = false;
  for (const Search_options& options : all)
    for (std::size_t i = 0; i < shapes.size(); i += 3)
      for (std::size_t j = 0; j < shapes.size(); j += 2) {
        const Correspondence_finder finder(shapes[i], options);
        const Prepared_shape target(shapes[j]);
        CHECK(finder.lower_bound(target, .5) <= distance_energy(finder(target), .5));
      }
}

TEST_CASE("Results are the same in parallel, for any number of neighbours")
{
  const std::vector<Structural_graph> shapes = many_shapes();
  for (std::size_t k : {0, 1, 40}) {
    const Nearest_shapes one = nearest_shapes(hand_made::table(), shapes, k);
    const Nearest_shapes many = nearest_shapes<CGAL::Parallel_if_available_tag>(hand_made::table(), shapes, k);
    REQUIRE(one.shapes.size() == std::min(k, shapes.size()));
    CHECK(one.evaluations == many.evaluations);
    REQUIRE(many.shapes.size() == one.shapes.size());
    for (std::size_t n = 0; n < one.shapes.size(); ++n) {
      CHECK(one.shapes[n].shape == many.shapes[n].shape);
      CHECK(one.shapes[n].distance == many.shapes[n].distance);
    }
  }
  CHECK(nearest_shapes(hand_made::table(), std::vector<Structural_graph>(), 3).shapes.empty());
}

TEST_CASE("Shapes of the query's category come first, then those of unknown category, in parallel, too")
{
  Energy_matrix_options options;
  options.search.roles = std::make_shared<const Role_model>(
      train_role_model(labelled_furniture::labelled(labelled_furniture::examples())));
  const std::vector<Structural_graph> shapes{labelled_furniture::shelf(.1, 4).graph, hand_made::pedestal_table(),
                                             labelled_furniture::chair(.3, 3).graph,
                                             labelled_furniture::chair(.1, 1.7).graph};
  const std::vector<std::string> categories{"shelf", "", "chair", "chair"};
  const Nearest_shapes found = nearest_shapes(shapes[3], shapes, 4, options);
  CHECK(found.category == "chair");
  std::vector<std::size_t> order;
  for (const Near_shape& near : found.shapes) {
    CHECK(near.category == categories[near.shape]);
    order.push_back(near.shape);
  }
  CHECK(order == std::vector<std::size_t>{2, 3, 1, 0}); // both chairs are equally near, since they have no contacts
  const Nearest_shapes two = nearest_shapes<CGAL::Parallel_if_available_tag>(shapes[3], shapes, 2, options);
  CHECK(two.shapes[0].shape == 2);
  CHECK(two.shapes[1].shape == 3);
  const Nearest_shapes unknown = nearest_shapes(hand_made::pedestal_table(), shapes, 1, options);
  CHECK(unknown.category.empty());
  CHECK(unknown.shapes[0].shape == 1);
  options.search.category = "shelf";
  CHECK(nearest_shapes(shapes[3], shapes, 1, options).category == "shelf");
}

TEST_CASE("Options out of their range are refused")
{
  Energy_matrix_options options;
  options.unmatched_energy = -1;
  CHECK_THROWS_AS(nearest_shapes(hand_made::table(), many_shapes(), 1, options), Invalid_input);
}
