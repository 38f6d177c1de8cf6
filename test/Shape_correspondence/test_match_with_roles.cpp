// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Roles in the matching of parts, in the energy, and in the search for fronts.
#include "labelled_furniture.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace CGAL::Shape_correspondence::internal;
using Catch::Matchers::Contains;

TEST_CASE("Labels are transferred to the parts that correspond most probably")
{
  const Furniture a = shelf(0.06, 3), b = shelf(0.1, 5);
  Search_options options;
  for (const bool with_roles : {true, false}) {
    if (with_roles)
      options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
    else
      options.roles = nullptr;
    const std::vector<Transferred_label> labels =
        Correspondence_finder(a.graph, options).transfer_labels(a.labels, Prepared_shape(b.graph));
    REQUIRE(labels.size() == b.labels.size());
    const Correspondence match = find_correspondence(a.graph, b.graph, options);
    for (std::size_t part = 0; part < labels.size(); ++part) {
      CHECK(labels[part].label.coarse == b.labels[part].coarse);
      CHECK(labels[part].label.fine == b.labels[part].fine);
      double most = 0;
      for (const Part_correspondence& pair : match.pairs)
        if (pair.target == part) most = std::max(most, pair.confidence);
      if (most > 0) CHECK(labels[part].confidence == most);
    }
  }
  const Correspondence_finder finder(a.graph, options);
  CHECK_THROWS_WITH(finder.transfer_labels({}, Prepared_shape(b.graph)), Contains("0 labels of 5 parts"));
  options.method = Search_method::EXACT;
  CHECK_THROWS_WITH(Correspondence_finder(a.graph, options).transfer_labels(a.labels, Prepared_shape(b.graph)),
                    Contains("Search_method::PARTS"));
  options.method = Search_method::PARTS;
  options.target_parts = {0, 2};
  const auto some = Correspondence_finder(a.graph, options).transfer_labels(a.labels, Prepared_shape(b.graph));
  CHECK(some[0].label.coarse == "side");
  CHECK(some[1].label.coarse.empty());
}

TEST_CASE("A positive weight of roles adds their costs to the energy")
{
  const Furniture a = shelf(0.06, 3), b = shelf(0.1, 5);
  const auto model = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  for (const Search_method method : {Search_method::EXACT, Search_method::BEAM}) {
    Search_options options;
    options.method = method;
    const Correspondence without = find_correspondence(a.graph, b.graph, options);
    options.roles = model;
    const Correspondence off = find_correspondence(a.graph, b.graph, options); // the weight of roles is 0
    CHECK(off.pairs == without.pairs);
    CHECK(off.energy == without.energy);
    CHECK(off.category.empty());
    options.energy.weights.roles = 100; // so high that roles decide alone
    const Correspondence with = find_correspondence(a.graph, b.graph, options);
    CHECK(with.category == "shelf");
    CHECK(with.source_roles == roles(a.labels));
    for (const Part_correspondence& pair : with.pairs)
      CHECK(a.labels[pair.source].coarse == b.labels[pair.target].coarse);
    CHECK(with.terms.roles < 0.1);
    CHECK(with.energy == Approx(deformation_energy(with.terms, options.energy.weights)));
    // The energy is the same with the shapes swapped
    const Correspondence back = find_correspondence(b.graph, a.graph, options);
    CHECK(back.energy == Approx(with.energy));
    // Without a model, there is no cost of roles
    options.roles = nullptr;
    CHECK(find_correspondence(a.graph, b.graph, options).energy == without.energy);
    options.energy.role_costs = Eigen::MatrixXd::Zero(2, 2);
    CHECK_THROWS_WITH(find_correspondence(a.graph, b.graph, options), Contains("2 x 2"));
    options.energy.role_costs = Eigen::MatrixXd::Constant(5, 7, 1.5);
    CHECK_THROWS_WITH(find_correspondence(a.graph, b.graph, options), Contains("between 0 and 1"));
    options.energy.weights.roles = -1;
    CHECK_THROWS_WITH(find_correspondence(a.graph, b.graph, options), Contains("weight of roles"));
  }
}

TEST_CASE("With roles, parts match parts of the same role; without a known category, geometry decides alone")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  const Furniture a = shelf(0.06, 3), b = shelf(0.1, 5);
  const Correspondence ab = find_correspondence(a.graph, b.graph, options),
                       ba = find_correspondence(b.graph, a.graph, options);
  CHECK(ab.category == "shelf");
  CHECK(ab.source_roles == roles(a.labels));
  CHECK(ab.target_roles == roles(b.labels));

  // Every board corresponds to every board, and sides only to sides
  std::size_t boards = 0;
  for (const Part_correspondence& pair : ab.pairs) {
    CHECK(a.labels[pair.source].coarse == b.labels[pair.target].coarse);
    CHECK(a.labels[pair.source].fine == b.labels[pair.target].fine);
    boards += a.labels[pair.source].coarse == "board";
  }
  CHECK(boards == 15);

  // Swapping the shapes gives the inverse pairs
  std::vector<Part_correspondence> inverted;
  for (const Part_correspondence& pair : ba.pairs)
    inverted.push_back(inverse(pair));
  std::sort(inverted.begin(), inverted.end(), is_before);
  CHECK(ab.pairs == inverted);

  // A shape of unknown category is matched by geometry alone, with a warning
  options.category = "";
  const Furniture rods =
      furniture("rods", {box("a", {-9, 0, 0}, {9, 0.1, 0.1}), box("b", {-9, 6, 0}, {-3, 6.1, 9})}, {});
  const Correspondence unknown = find_correspondence(rods.graph, rods.graph, options),
                       geometric = find_correspondence(rods.graph, rods.graph);
  CHECK(unknown.category.empty());
  CHECK(unknown.pairs == geometric.pairs);
  REQUIRE(!unknown.warnings.empty());
  CHECK_THAT(unknown.warnings.back(), Contains("geometry alone"));
  options.category = "boat";
  CHECK_THROWS_AS(find_correspondence(a.graph, b.graph, options), Invalid_input);
}

namespace {

/// Turns a piece of furniture by 90° about the up axis.
void turn_by_a_quarter(Furniture& furniture)
{
  const Eigen::Matrix3d quarter = Eigen::AngleAxisd(EIGEN_PI / 2, Point::UnitY()).toRotationMatrix();
  for (Part_abstraction& part : structure(furniture.graph).parts) {
    Points& line = std::get<Curve>(part.geometry).points;
    line = (quarter * line).eval();
    part.surface = (quarter * part.surface).eval();
  }
}

/// Whether all six parts of one chair are matched to the other's, with valid quarter turns.
bool is_right(const Furniture& source, const Furniture& target, const Correspondence& found)
{
  return found.target_quarter_turns >= 0 && found.target_quarter_turns < 4 && found.category == "chair" &&
         found.pairs.size() == 6 &&
         std::all_of(found.pairs.begin(), found.pairs.end(), [&](const Part_correspondence& pair) {
           return source.labels[pair.source].fine == target.labels[pair.target].fine;
         });
}

} // namespace

TEST_CASE("The fronts of shapes of a known category are found by the roles of their parts")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  options.alignments = 0;
  const Furniture source = chair(0.17, 1.9);
  Furniture target = chair(0.22, 2.1);
  for (int turn = 0; turn < 4; ++turn) {
    INFO(turn);
    CHECK(is_right(source, target, find_correspondence(source.graph, target.graph, options)));
    CHECK(is_right(target, source, find_correspondence(target.graph, source.graph, options)));
    turn_by_a_quarter(target);
  }
}

TEST_CASE("A shape that clearly faces another side is turned, unless its front is said to be right")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  options.category = "chair";
  const Furniture source = chair(0.17, 1.9);
  Furniture target = chair(0.22, 2.1);
  for (int turn = 0; turn < 4; ++turn) {
    INFO(turn);
    options.front_is_sure = false;
    const Correspondence found = find_correspondence(source.graph, target.graph, options);
    CHECK(is_right(source, target, found));
    CHECK(is_right(target, source, find_correspondence(target.graph, source.graph, options)));
    REQUIRE(found.warnings.size() == (turn == 0 ? 0 : 1));
    if (turn != 0) {
      const std::string angle = "turned by " + std::to_string(90 * (4 - turn)) + "°";
      CHECK_THAT(found.warnings[0], Contains("the target does not face +z") && Contains(angle));
    }
    options.front_is_sure = true;
    const Correspondence as_given = find_correspondence(source.graph, target.graph, options);
    CHECK(is_right(source, target, as_given) == (turn == 0));
    CHECK(as_given.warnings.empty());
    turn_by_a_quarter(target);
  }
}

TEST_CASE("A shape is not turned to a side where trees are surer of roles, but parts are less like labelled ones")
{
  const Role_model model = train_role_model(labelled(examples()));
  const Role_model_data& data = Role_model_access::data(model);
  const Category_roles& chairs = data.categories[0];
  const auto of_role = [&](const char* role) {
    for (const Role_example& example : chairs.examples)
      if (chairs.roles[chairs.classes[example.role].role] == role) return example.features;
    return chairs.examples[0].features;
  };
  const auto leg = of_role("leg"), back = of_role("back");
  // Roles of a part with features between those of a leg (share 0) and those of a back (share 1), except that the last
  // `moved` of them are unlike those of any part
  const auto roles_of = [&](double share, int moved) {
    Role_evidence evidence{Role_features(1, ROLE_FEATURE_COUNT), {Side::NEITHER}};
    for (int k = 0; k < ROLE_FEATURE_COUNT; ++k)
      evidence.features(0, k) = std::uint8_t((1 - share) * leg[std::size_t(k)] + share * back[std::size_t(k)]);
    for (int k = ROLE_FEATURE_COUNT - moved; k < ROLE_FEATURE_COUNT; ++k)
      evidence.features(0, k) = std::uint8_t(evidence.features(0, k) < 127 ? 254 : 0);
    return std::make_shared<const Shape_roles>(std::move(evidence), model);
  };
  const auto given = roles_of(0.5, 0);
  int moved = 0;
  while (roles_of(0, moved)->distance(0) < 1.1 * given->distance(0))
    ++moved;
  const auto likeness = [&](const Shape_roles& shape) {
    return std::log(double(shape.votes(0).roles.maxCoeff()) / data.trees) - shape.distance(0);
  };
  const auto far = roles_of(0, moved), near = roles_of(0, 0);
  REQUIRE(likeness(*far) > likeness(*given) + 0.2);
  CHECK(likely_front({given, given, near, given}, 0, data.trees) == 2);
  CHECK(likely_front({given, given, far, given}, 0, data.trees) == 0);
}

TEST_CASE("A shape whose parts tell no front keeps the given one")
{
  const auto table = [](double width, double depth) {
    std::vector<Part_abstraction> parts{box("top", {-width, 1, -depth}, {width, 1.1, depth})};
    std::vector<Part_label> labels{{"tabletop", ""}};
    for (const double x : {-1., 1.})
      for (const double z : {-1., 1.}) {
        const Point middle(x * (width - 0.1), 0, z * (depth - 0.1)), half(0.1, 0, 0.1);
        parts.push_back(box("leg" + std::to_string(parts.size()), middle - half, middle + half + Point(0, 1, 0)));
        labels.push_back({"leg", std::string("leg_") + (z > 0 ? "front" : "back") + (x > 0 ? "_left" : "_right")});
      }
    return furniture("table", std::move(parts), std::move(labels));
  };
  std::deque<Furniture> tables;
  for (int i = 0; i < 8; ++i)
    tables.push_back(table(1.5 + 0.2 * i, 0.6 + 0.05 * i));
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(tables)));
  options.category = "table";
  const Furniture source = table(1.9, 0.7), target = table(0.7, 1.8); // looks the same from its left and its right
  const Correspondence found = find_correspondence(source.graph, target.graph, options);
  CHECK(found.warnings.empty());
  CHECK(found.target_quarter_turns == 0);
}

TEST_CASE("A shape that faces another side is recognised once it is turned, unless its front is said to be right")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  const Furniture source = chair(0.17, 1.9);
  Furniture target = chair(0.22, 2.1);
  for (int turn = 0; turn < 4; ++turn) {
    INFO(turn);
    CHECK(is_right(source, target, find_correspondence(source.graph, target.graph, options)));
    CHECK(is_right(target, source, find_correspondence(target.graph, source.graph, options)));
    turn_by_a_quarter(target);
  }
}

TEST_CASE("Shapes that each clearly are of another category are matched by geometry alone, however they are turned")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  const Furniture source = chair(0.17, 1.9);
  Furniture target = shelf(0.1, 4);
  for (int alignments : {1, 0}) {
    INFO(alignments);
    options.alignments = alignments;
    const Correspondence found = find_correspondence(source.graph, target.graph, options);
    CHECK(found.category.empty());
    REQUIRE(found.warnings.size() == 1);
    CHECK_THAT(found.warnings[0], Contains("category chair") && Contains("like shelf"));
  }
}

TEST_CASE("Identical shapes are not turned against each other, whichever side they face")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  Furniture shape = chair(0.22, 2.1);
  for (int turn = 0; turn < 4; ++turn) {
    INFO(turn);
    const Correspondence found = find_correspondence(shape.graph, shape.graph, options);
    CHECK(found.target_quarter_turns == 0);
    REQUIRE(found.pairs.size() == 6);
    for (const Part_correspondence& pair : found.pairs)
      CHECK(pair.source == pair.target);
    turn_by_a_quarter(shape);
  }
}

TEST_CASE("A shape between two categories is of neither, a shape like one of them is of that one")
{
  std::deque<Furniture> shapes = examples();
  std::vector<Labelled_graph> twice = labelled(shapes);
  const std::size_t count = twice.size();
  for (std::size_t i = 0; i < count; ++i)
    if (twice[i].category == "chair") {
      twice.push_back(twice[i]);
      twice.back().category = "seat";
    }
  const Role_model model = train_role_model(twice);
  const Furniture usual = chair(0.17, 1.9),
                  odd = furniture("odd", {box("a", {-9, 0, 0}, {9, 0.1, 0.1}), box("b", {-9, 6, 0}, {-3, 6.1, 9})}, {});
  CHECK(part_roles(usual.graph, model).category.empty()); // as near to chairs as to seats
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(shapes)));
  for (const int alignments : {1, 0}) {
    INFO(alignments);
    options.alignments = alignments;
    const auto found = [&](const Furniture& shape, double ratio, double distance) {
      options.parts.category_ratio = ratio;
      options.parts.category_distance = distance;
      return find_correspondence(shape.graph, shape.graph, options);
    };
    CHECK(found(usual, 0.85, 0.35).category == "chair");
    const Correspondence refused = found(usual, 0.85, 0);
    CHECK(refused.category.empty());
    REQUIRE(refused.warnings.size() == 1);
    CHECK_THAT(refused.warnings[0], Contains("the nearest is chair"));
    CHECK(found(odd, 1, 0.35).category.empty()); // farther than the greatest distance, whatever the ratio
    CHECK(found(usual, 0, 10).category.empty()); // no category is nearer than another by such a ratio
  }
}

TEST_CASE("A prepared shape is matched with two models by several threads at once")
{
  const std::deque<Furniture> shapes = examples();
  std::vector<Search_options> options(2);
  std::vector<Correspondence> expected;
  for (std::size_t k = 0; k < 2; ++k) {
    Role_training_options training;
    training.seed = k;
    options[k].roles = std::make_shared<const Role_model>(train_role_model(labelled(shapes), training));
    expected.push_back(find_correspondence(shapes[0].graph, shapes[2].graph, options[k]));
  }
  for (int repetition = 0; repetition < 5; ++repetition) {
    const Prepared_shape source(shapes[0].graph), target(shapes[2].graph);
    std::vector<Correspondence> found(4);
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < found.size(); ++k)
      threads.emplace_back([&, k] { found[k] = Correspondence_finder(source, options[k % 2])(target); });
    for (std::thread& thread : threads)
      thread.join();
    for (std::size_t k = 0; k < found.size(); ++k)
      CHECK(found[k].pairs == expected[k % 2].pairs);
  }
}

TEST_CASE("Pairs matched by geometry alone have the confidence of such pairs in the nearest category")
{
  Role_model_data data = Role_model_access::data(train_role_model(labelled(examples())));
  const std::size_t shelf = data.index("shelf");
  REQUIRE(shelf < data.categories.size());
  const Confidence_weights seldom_right{1, -2};
  data.categories[shelf].geometric_confidence = seldom_right;
  Search_options options;
  const Furniture odd = furniture("odd", {box("a", {-9, 0, 0}, {9, 0.1, 0.1}), box("b", {-9, 6, 0}, {-3, 6.1, 9})}, {});
  const Correspondence geometric = find_correspondence(odd.graph, odd.graph, options);
  for (const std::size_t category : {shelf, std::size_t(1 - shelf)}) {
    Role_model_data one = data; // knows only this category
    one.categories = {data.categories[category]};
    std::stringstream file;
    Role_model_access::model(std::move(one)).write(file);
    options.roles = std::make_shared<const Role_model>(Role_model::read(file, "file"));
    const Correspondence found = find_correspondence(odd.graph, odd.graph, options);
    REQUIRE(found.category.empty());
    REQUIRE(found.pairs.size() == geometric.pairs.size());
    for (std::size_t k = 0; k < found.pairs.size(); ++k) {
      const double without = geometric.pairs[k].confidence;
      CHECK(found.pairs[k].confidence ==
            Approx(category == shelf ? confidence(without, seldom_right) : without).epsilon(1e-9));
    }
  }
}
