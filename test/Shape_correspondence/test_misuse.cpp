// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls of the library with invalid arguments: each is refused, and none has undefined behaviour.

#include "box_shapes.h"
#include "boxed_graphs.h"
#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence.h>
#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>
#include <CGAL/Shape_correspondence/exact_search.h>
#include <CGAL/Shape_correspondence/train_role_model.h>

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t largest = std::numeric_limits<std::size_t>::max();

template <typename Change>
void check_refused(const Change& change)
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  change(options);
  CHECK_THROWS_AS(build_structural_graph(box_shapes::table(), options), Invalid_input);
}

template <typename Change>
void check_search_refused(const Change& change)
{
  Search_options options;
  change(options);
  CHECK_THROWS_AS(find_correspondence(hand_made::chair(), hand_made::table(), options), Invalid_input);
}

Pairwise_energy two_variables()
{
  Pairwise_energy energy;
  energy.unary = {Eigen::VectorXd::Ones(2), Eigen::VectorXd::Ones(3)};
  energy.edges.push_back({0, 1, Eigen::MatrixXd::Ones(2, 3)});
  return energy;
}

} // namespace

TEST_CASE("Options that are out of range or not a number are refused where graphs are built")
{
  for (double x : {not_a_number, -1.}) {
    check_refused([&](auto& options) { options.abstraction.edge_length = x; });
    check_refused([&](auto& options) { options.abstraction.stop_volume = x; });
    check_refused([&](auto& options) { options.abstraction.time_limit = x; });
    check_refused([&](auto& options) { options.symmetry.tolerance = x; });
    check_refused([&](auto& options) { options.contacts.tolerance = x; });
  }
  for (int x : {-1, 0, 1, std::numeric_limits<int>::max()}) {
    check_refused([&](auto& options) { options.abstraction.curve_points = x; });
    check_refused([&](auto& options) { options.abstraction.sheet_points = x; });
  }
  check_refused([](auto& options) { options.abstraction.abstractor = nullptr; });
  check_refused([](auto& options) { options.abstraction.triangles = 0; });
}

TEST_CASE("Pinned and forbidden parts that do not exist are refused before they are used")
{
  for (std::size_t part : {std::size_t(6), largest}) {
    check_search_refused([&](auto& options) { options.energy.pinned = {{part, 0}}; });
    check_search_refused([&](auto& options) { options.energy.pinned = {{0, part}}; });
    check_search_refused([&](auto& options) { options.energy.forbidden = {{part, part}}; });
  }
  for (double limit : {not_a_number, -1.})
    check_search_refused([&](auto& options) { options.time_limit = limit; });
}

TEST_CASE("Graphs without parts, which are valid, have no pairs")
{
  const Structural_graph none, chair = hand_made::chair();
  REQUIRE(is_valid_structural_graph(none));
  for (Search_method method : {Search_method::PARTS, Search_method::BEAM, Search_method::EXACT}) {
    Search_options options;
    options.method = method;
    const Correspondence to_none = find_correspondence(chair, none, options);
    CHECK(to_none.pairs.empty());
    CHECK(to_none.complete);
    CHECK(to_none.unmatched_source.size() == 6);
    CHECK(find_correspondence(none, chair, options).unmatched_target.size() == 6);
    CHECK(find_correspondence(none, none, options).pairs.empty());
    CHECK(Correspondence_finder(none, options).lower_bound(Prepared_shape(chair), 0) == 0);
  }
  CHECK(Correspondence_finder(none).both_orders(Prepared_shape(chair))[1].unmatched_source.size() == 6);
  CHECK(Correspondence_finder(none).transfer_labels({}, Prepared_shape(chair)).size() == 6);
}

TEST_CASE("Meshes with indices of no vertex, or coordinates that are no numbers, are refused")
{
  Part_mesh bad_index = box_shapes::box(Point::Zero(), Point::Ones()), bad_point = bad_index;
  bad_index.triangles(0, 0) = 999;
  bad_point.points(0, 0) = not_a_number;
  for (const Part_mesh& mesh : {bad_index, bad_point}) {
    CHECK_THROWS_AS(segment_mesh(mesh), Invalid_input);
    CHECK_THROWS_AS(abstract_part({"part", mesh}), Invalid_input);
    CHECK_THROWS_AS(sample_surface(mesh, 10), Invalid_input);
  }
  CHECK_THROWS_AS(abstract_part({"part", {}}), Invalid_input);
  CHECK_THROWS_AS(sample_surface({}, 10), Invalid_input);
  CHECK_THROWS_AS(convex_hull_volume(bad_point.points), Invalid_input);
  CHECK(segment_mesh({}).shape.parts().empty());
  Segmentation_options most;
  most.patches = largest; // clamped to the number of triangles
  CHECK(segment_mesh(box_shapes::box(Point::Zero(), Point::Ones()), most).shape.parts().size() == 1);
}

TEST_CASE("The upright axis of an empty shape, or with invalid odds, is refused")
{
  const Segmented_shape table = box_shapes::table();
  CHECK_THROWS_AS(estimate_up(Segmented_shape()), Invalid_input);
  CHECK_THROWS_AS(estimate_up_of_pair(table, Segmented_shape(), {false, false}), Invalid_input);
  for (double odds : {not_a_number, 0., -1., std::numeric_limits<double>::infinity()})
    CHECK_THROWS_AS(estimate_up(table, odds), Invalid_input);
}

TEST_CASE("Correspondences of other shapes are refused")
{
  const Segmented_shape chair = box_shapes::chair(), table = box_shapes::table();
  const Structural_graph of_chair = boxed_graphs::graph_of(chair), of_table = boxed_graphs::graph_of(table);
  Correspondence other = boxed_graphs::identity(table);
  other.pairs[0].source = 99;
  CHECK_THROWS_AS(Shape_blend(of_table, table, of_table, table, other), Invalid_input);
  CHECK_THROWS_AS(Surface_map(of_table, table, of_table, table, other), Invalid_input);
  std::ostringstream text;
  CHECK_THROWS_AS(IO::write_correspondence_json(text, other, of_table, of_table, "a", "b", {}), Invalid_input);
  other.pairs[0].source = largest;
  CHECK_THROWS_AS(correspondence_blocks(other), Invalid_input);

  const Shape_blend blend(of_table, table, of_table, table, boxed_graphs::identity(table));
  CHECK_THROWS_AS(blend(not_a_number), Invalid_input);
  CHECK_THROWS_AS(blend.quality(not_a_number), Invalid_input);
  CHECK_THROWS_AS(blend.points(not_a_number), Invalid_input);
  const Surface_map map(of_table, table, of_table, table, boxed_graphs::identity(table));
  CHECK_THROWS_AS(map.source_of(99, 0), Invalid_input);
  CHECK_THROWS_AS(map.target_of(0, 1'000'000), Invalid_input);
  CHECK_THROWS_AS(map.target_of(0, -1), Invalid_input);
  Part_parameter place;
  place.part = 77;
  CHECK_THROWS_AS(Correspondence_map(of_table, of_table, boxed_graphs::identity(table))(place), Invalid_input);
}

TEST_CASE("Inconsistent energies are refused")
{
  for (const auto& change : std::vector<std::function<void(Pairwise_energy&)>>{
           [](auto& energy) { energy.edges[0].second = 7; },
           [](auto& energy) { std::swap(energy.unary[0], energy.unary[1]); },
           [](auto& energy) { energy.unary[0].resize(0); },
           [](auto& energy) {
             energy.root_terms.push_back({1, 1, {Eigen::VectorXd::Ones(2)}, {}});
           }}) {
    Pairwise_energy energy = two_variables();
    change(energy);
    CHECK_THROWS_AS(exact_search(energy), Invalid_input);
  }
  const Pairwise_energy energy = two_variables();
  Exact_search search(energy);
  CHECK_THROWS_AS(search.min_marginals(Search_result()), Invalid_input);
}

TEST_CASE("Indices of shapes, parts and groups that do not exist are refused")
{
  const Structural_graph chair = hand_made::chair();
  const Shape_structure shape = structure(chair);
  CHECK_THROWS_AS(complete_structural_graph(shape, {hand_made::group({0, 77})}), Invalid_input);
  CHECK_THROWS_AS(complete_structural_graph(shape, {hand_made::group({0}), hand_made::group({0})}), Invalid_input);
  CHECK_THROWS_AS(match_pairs(std::vector<Structural_graph>{chair, chair}, {{0, 7}}), Invalid_input);
  CHECK_THROWS_AS(best_chains(Eigen::MatrixXd::Ones(6, 6), {{0, 1}}, 0), Invalid_input);
  CHECK_THROWS_AS(co_analysis({std::size_t(1) << 60, 4}, {}), Invalid_input);
  CHECK_THROWS_AS(train_role_model({{nullptr, "chair", {}, 1}}), Invalid_input);
}
