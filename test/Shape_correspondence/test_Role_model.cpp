// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Roles of parts: learning, telling, keeping, and matching with them.
#include "hand_made_graphs.h"
#include "matching/cross_validate_roles.h"
#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace hand_made;
using namespace model_files;
using namespace CGAL::Shape_correspondence::internal;
using Catch::Matchers::Contains;

namespace {

// Points of a box's surface, the same for every box.
Points box_surface(const Point& low, const Point& high)
{
  Points result(3, 32);
  for (int i = 0; i < 32; ++i) {
    const Point t(((i * 7) % 8) / 7., ((i * 5) % 11) / 10., ((i * 3) % 5) / 4.);
    result.col(i) = low + (high - low).cwiseProduct(t);
  }
  result.col(0) = low;
  result.col(1) = high;
  return result;
}

Part_abstraction box(const std::string& name, const Point& low, const Point& high)
{
  const Point middle = (low + high) / 2;
  Part_abstraction part = curve(name, {middle.x(), low.y(), middle.z()}, {middle.x(), high.y(), middle.z()});
  part.surface = box_surface(low, high);
  const Point s = high - low;
  part.area = 2 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
  return part;
}

struct Furniture
{
  Structural_graph graph;
  std::string category;
  std::vector<Part_label> labels;
};

std::vector<std::string> roles(const std::vector<Part_label>& labels)
{
  std::vector<std::string> result;
  for (const Part_label& label : labels)
    result.push_back(label.coarse);
  return result;
}

Furniture furniture(const std::string& category, std::vector<Part_abstraction> parts, std::vector<Part_label> labels)
{
  Shape_structure shape;
  shape.name = category;
  shape.parts = std::move(parts);
  std::vector<Part_group> groups;
  for (std::size_t part = 0; part < shape.parts.size(); ++part)
    groups.push_back({{part}, {}, 0, 0});
  return {make_structural_graph(std::move(shape), std::move(groups)), category, std::move(labels)};
}

// A chair of width 2, the legs as thick and the seat as high as asked for.
Furniture chair(double thickness, double seat)
{
  std::vector<Part_abstraction> parts;
  for (const double x : {-1., 1. - thickness})
    for (const double z : {-1., 1. - thickness})
      parts.push_back(box("leg" + std::to_string(parts.size()), {x, 0, z}, {x + thickness, seat, z + thickness}));
  parts.push_back(box("seat", {-1, seat, -1}, {1, seat + 0.2, 1}));
  parts.push_back(box("back", {-1, seat + 0.2, -1}, {1, seat + 2, -0.8}));
  return furniture("chair", std::move(parts),
                   {{"leg", "leg_back_right"},
                    {"leg", "leg_front_right"},
                    {"leg", "leg_back_left"},
                    {"leg", "leg_front_left"},
                    {"seat", ""},
                    {"back", ""}});
}

// A shelf: two sides and boards in between.
Furniture shelf(double thickness, int boards)
{
  std::vector<Part_abstraction> parts{box("left", {1 - thickness, 0, -0.5}, {1, 4, 0.5}),
                                      box("right", {-1, 0, -0.5}, {-1 + thickness, 4, 0.5})};
  std::vector<Part_label> labels{{"side", "side_left"}, {"side", "side_right"}};
  for (int i = 0; i < boards; ++i) {
    const double y = (4 - thickness) * (i + 0.5) / boards;
    parts.push_back(box("board" + std::to_string(i), {-1 + thickness, y, -0.5}, {1 - thickness, y + thickness, 0.5}));
    labels.push_back({"board", ""});
  }
  return furniture("shelf", std::move(parts), std::move(labels));
}

const std::deque<Furniture>& examples()
{
  static const std::deque<Furniture> result = [] {
    std::deque<Furniture> shapes;
    for (double x : {0.1, 0.15, 0.2, 0.25, 0.3}) {
      shapes.push_back(chair(x, 1.5 + 2 * x));
      shapes.push_back(shelf(x / 2, 2 + int(10 * x)));
    }
    return shapes;
  }();
  return result;
}

std::vector<Labelled_graph> labelled(const std::deque<Furniture>& shapes)
{
  std::vector<Labelled_graph> result;
  for (const Furniture& shape : shapes)
    result.push_back({&shape.graph, shape.category, shape.labels, 1});
  return result;
}

std::string bytes(const Role_model& model)
{
  std::ostringstream out;
  model.write(out);
  return out.str();
}

std::vector<std::string> likeliest(const Part_roles& roles)
{
  std::vector<std::string> result;
  for (Eigen::Index part = 0; part < roles.probabilities.rows(); ++part) {
    Eigen::Index role = 0;
    roles.probabilities.row(part).maxCoeff(&role);
    result.push_back(roles.roles[std::size_t(role)]);
  }
  return result;
}

} // namespace

TEST_CASE("Roles of shapes that the training did not see")
{
  const Role_model model = train_role_model(labelled(examples()));
  CHECK(model.categories() == std::vector<std::string>{"chair", "shelf"});
  CHECK(model.roles("chair") == std::vector<std::string>{"back", "leg", "seat"});
  for (const Furniture& shape : {chair(0.17, 1.9), shelf(0.08, 4)}) {
    const Part_roles roles = part_roles(shape.graph, model);
    CHECK(roles.category == shape.category);
    CHECK(likeliest(roles) == ::roles(shape.labels));
    REQUIRE(roles.labels.size() == shape.labels.size());
    for (std::size_t part = 0; part < shape.labels.size(); ++part) {
      CHECK(roles.labels[part].coarse == shape.labels[part].coarse);
      CHECK(roles.labels[part].fine == shape.labels[part].fine);
    }
    for (Eigen::Index part = 0; part < roles.probabilities.rows(); ++part)
      CHECK(roles.probabilities.row(part).sum() == Approx(1));
  }
  const Furniture unknown = chair(0.2, 1.8);
  CHECK(part_roles(unknown.graph, model, "shelf").category == "shelf");
  CHECK(part_roles(unknown.graph, model, "shelf").distance > part_roles(unknown.graph, model, "chair").distance);
  CHECK(part_roles(unknown.graph, Role_model()).category.empty());
  CHECK_THROWS_WITH(part_roles(unknown.graph, model, "boat"), Contains("'boat'") && Contains("chair, shelf"));
}

TEST_CASE("Roles heed neither the order of parts nor a motion of the shape")
{
  const Role_model model = train_role_model(labelled(examples()));
  const Furniture shape = chair(0.22, 2.1);
  const Part_roles roles = part_roles(shape.graph, model);
  Shape_structure moved = structure(shape.graph);
  moved.frame.origin = Point(3, 4, 5);
  moved.frame.height *= 2.5;
  for (Part_abstraction& part : moved.parts) {
    Points& line = std::get<Curve>(part.geometry).points;
    line = ((2.5 * line).colwise() + moved.frame.origin).eval();
    part.surface = ((2.5 * part.surface).colwise() + moved.frame.origin).eval();
    part.area *= 2.5 * 2.5;
    part.name = "x";
  }
  std::reverse(moved.parts.begin(), moved.parts.end());
  std::vector<Part_group> groups;
  for (std::size_t part = 0; part < moved.parts.size(); ++part)
    groups.push_back({{part}, {}, 0, 0});
  const Part_roles again = part_roles(make_structural_graph(std::move(moved), std::move(groups)), model);
  CHECK(again.probabilities == roles.probabilities.colwise().reverse().eval());
  CHECK(again.distance == Approx(roles.distance).epsilon(1e-12));
}

TEST_CASE("A role model is the same for any order of the shapes, and after it was kept in a file")
{
  std::vector<Labelled_graph> shapes = labelled(examples());
  const Role_model model = train_role_model(shapes);
  std::reverse(shapes.begin(), shapes.end());
  CHECK(bytes(train_role_model(shapes)) == bytes(model));
  Role_training_options other_seed;
  other_seed.seed = 1;
  CHECK(bytes(train_role_model(shapes, other_seed)) != bytes(model));

  const Temporary_folder folder;
  IO::write_role_model(folder.path("a.roles"), model);
  CHECK(bytes(IO::read_role_model(folder.path("a.roles"))) == bytes(model));
  const std::string text = text_of(folder.path("a.roles"));
  for (std::size_t at : {std::size_t(0), text.size() / 2, text.size() - 1}) {
    std::string damaged = text;
    damaged[at] = char(damaged[at] ^ 1);
    folder.write("damaged.roles", damaged);
    CHECK_THROWS_WITH(IO::read_role_model(folder.path("damaged.roles")), Contains("damaged.roles"));
  }
  CHECK_THROWS_WITH(IO::read_role_model(folder.path("none.roles")), Contains("no such file"));

  // What no digest guards
  const std::string whole = bytes(model);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 50) {
    std::istringstream in(whole.substr(0, size));
    CHECK_THROWS_AS(Role_model::read(in, "cut"), Invalid_input);
  }
}

TEST_CASE("A model that is extended knows what all shapes teach together")
{
  const std::vector<Labelled_graph> all = labelled(examples());
  std::vector<Labelled_graph> chairs, shelves, first_half, second_half;
  for (const Labelled_graph& shape : all) {
    (shape.category == "chair" ? chairs : shelves).push_back(shape);
    (first_half.size() < all.size() / 2 ? first_half : second_half).push_back(shape);
  }
  const Role_model together = train_role_model(all);
  CHECK(bytes(extend_role_model(train_role_model(chairs), shelves)) == bytes(together));
  CHECK(bytes(extend_role_model(Role_model(), all)) == bytes(together));

  // Shapes of a category that is known: its roles are learned from the old and the new ones
  const Role_model extended = extend_role_model(train_role_model(first_half), second_half);
  for (const Furniture& shape : {chair(0.17, 1.9), shelf(0.08, 4)}) {
    const Part_roles a = part_roles(shape.graph, extended), b = part_roles(shape.graph, together);
    CHECK(a.probabilities == b.probabilities);
    CHECK(a.distance == b.distance);
  }
  // Also after it was kept in a file
  const Temporary_folder folder;
  IO::write_role_model(folder.path("half.roles"), train_role_model(first_half));
  CHECK(bytes(extend_role_model(IO::read_role_model(folder.path("half.roles")), second_half)) == bytes(extended));

  // The forests have as many trees as those of the model
  Role_training_options few;
  few.trees = 7;
  CHECK(extend_role_model(train_role_model(chairs, few), shelves).data().trees == 7);
  std::vector<Labelled_graph> bad = shelves;
  bad[0].labels.pop_back();
  CHECK_THROWS_WITH(extend_role_model(train_role_model(chairs), bad), Contains("role for every part"));
}

TEST_CASE("The fewer shapes are labelled, the less their labels count")
{
  double before = 0;
  for (const std::size_t count : {1, 3, 10, 100}) {
    const Pair_weights weights = usual_pair_weights(count);
    CHECK(weights[SAME_LABEL] > before);
    CHECK(weights[GEOMETRIC_PAIR] > usual_pair_weights()[GEOMETRIC_PAIR]);
    before = weights[SAME_LABEL];
  }
  CHECK(before < usual_pair_weights()[SAME_LABEL]);
  const std::vector<Labelled_graph> shapes = labelled(examples());
  CHECK(train_role_model({shapes[0], shapes[2]}).data().categories[0].weights == usual_pair_weights(2));
}

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

TEST_CASE("Roles joined to the energy")
{
  const Furniture a = shelf(0.06, 3), b = shelf(0.1, 5);
  const auto model = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  for (const Search_method method : {Search_method::EXACT, Search_method::BEAM}) {
    Search_options options;
    options.method = method;
    const Correspondence without = find_correspondence(a.graph, b.graph, options);
    options.roles = model;
    const Correspondence off = find_correspondence(a.graph, b.graph, options); // the weight is 0
    CHECK(off.pairs == without.pairs);
    CHECK(off.energy == without.energy);
    CHECK(off.category.empty());
    options.matching.weights.roles = 100; // decides alone
    const Correspondence with = find_correspondence(a.graph, b.graph, options);
    CHECK(with.category == "shelf");
    CHECK(with.source_roles == roles(a.labels));
    for (const Part_correspondence& pair : with.pairs)
      CHECK(a.labels[pair.source].coarse == b.labels[pair.target].coarse);
    CHECK(with.terms.roles < 0.1);
    CHECK(with.energy == Approx(deformation_energy(with.terms, options.matching.weights)));
    // From either shape
    const Correspondence back = find_correspondence(b.graph, a.graph, options);
    CHECK(back.energy == Approx(with.energy));
    // No model, nothing to charge
    options.roles = nullptr;
    CHECK(find_correspondence(a.graph, b.graph, options).energy == without.energy);
    options.matching.role_costs = Eigen::MatrixXd::Zero(2, 2);
    CHECK_THROWS_WITH(find_correspondence(a.graph, b.graph, options), Contains("2 x 2"));
    options.matching.role_costs = Eigen::MatrixXd::Constant(5, 7, 1.5);
    CHECK_THROWS_WITH(find_correspondence(a.graph, b.graph, options), Contains("between 0 and 1"));
    options.matching.weights.roles = -1;
    CHECK_THROWS_WITH(find_correspondence(a.graph, b.graph, options), Contains("weight of roles"));
  }
}

TEST_CASE("What cannot be learned from")
{
  std::vector<Labelled_graph> shapes = labelled(examples());
  shapes[0].labels.pop_back();
  CHECK_THROWS_WITH(train_role_model(shapes), Contains("role for every part"));
  shapes = labelled(examples());
  shapes[0].labels[1].coarse = "";
  CHECK_THROWS_WITH(train_role_model(shapes), Contains("without a role"));
  shapes = labelled(examples());
  shapes[1].category = "";
  CHECK_THROWS_WITH(train_role_model(shapes), Contains("no category"));
  shapes = labelled(examples());
  shapes[1].weight = 0;
  CHECK_THROWS_WITH(train_role_model(shapes), Contains("weight"));
  Role_training_options options;
  options.trees = 0;
  CHECK_THROWS_WITH(train_role_model(labelled(examples()), options), Contains("trees"));
}

TEST_CASE("Matching with roles")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  const Furniture a = shelf(0.06, 3), b = shelf(0.1, 5);
  const Correspondence ab = find_correspondence(a.graph, b.graph, options),
                       ba = find_correspondence(b.graph, a.graph, options);
  CHECK(ab.category == "shelf");
  CHECK(ab.source_roles == roles(a.labels));
  CHECK(ab.target_roles == roles(b.labels));

  // Every board with every board, and sides with sides only
  std::size_t boards = 0;
  for (const Part_correspondence& pair : ab.pairs) {
    CHECK(a.labels[pair.source].coarse == b.labels[pair.target].coarse);
    CHECK(a.labels[pair.source].fine == b.labels[pair.target].fine);
    boards += a.labels[pair.source].coarse == "board";
  }
  CHECK(boards == 15);

  // Neither shape comes first
  std::vector<Part_correspondence> inverted;
  for (const Part_correspondence& pair : ba.pairs)
    inverted.push_back(inverse(pair));
  std::sort(inverted.begin(), inverted.end(), is_before);
  CHECK(ab.pairs == inverted);

  // A shape of no known category is matched by geometry alone, and says so
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

TEST_CASE("The fronts of shapes of a known category are found by the roles of their parts")
{
  Search_options options;
  options.roles = std::make_shared<const Role_model>(train_role_model(labelled(examples())));
  options.alignments = 0;
  const Furniture source = chair(0.17, 1.9);
  Furniture target = chair(0.22, 2.1);
  const Eigen::Matrix3d quarter = Eigen::AngleAxisd(EIGEN_PI / 2, Point::UnitY()).toRotationMatrix();
  for (int turn = 0; turn < 4; ++turn) {
    INFO(turn);
    for (const bool swap : {false, true}) {
      const Furniture &a = swap ? target : source, &b = swap ? source : target;
      const Correspondence found = find_correspondence(a.graph, b.graph, options);
      CHECK(found.category == "chair");
      CHECK(found.pairs.size() == 6);
      for (const Part_correspondence& pair : found.pairs)
        CHECK(a.labels[pair.source].fine == b.labels[pair.target].fine);
    }
    for (Part_abstraction& part : structure(target.graph).parts) {
      Points& line = std::get<Curve>(part.geometry).points;
      line = (quarter * line).eval();
      part.surface = (quarter * part.surface).eval();
    }
  }
}

namespace {

using namespace CGAL::Shape_correspondence::internal;

std::vector<Validation_shape> validation_shapes(const std::deque<Furniture>& shapes)
{
  std::vector<Validation_shape> result;
  for (const Furniture& shape : shapes) {
    result.push_back({{&shape.graph, shape.category, shape.labels, 1}, shape.category + " maker"});
  }
  return result;
}

// All pairs of shapes of a category among the first ones.
std::vector<Validation_pair> pairs_of_category(const std::deque<Furniture>& shapes, std::size_t count)
{
  std::vector<Validation_pair> result;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (shapes[i].category == shapes[j].category) result.push_back({i, j});
  return result;
}

} // namespace

TEST_CASE("Pairs of shapes that the training did not see")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> all = pairs_of_category(examples(), shapes.size());
  const Role_validation validation(shapes, all, {}, {});
  REQUIRE(validation.pairs().size() == all.size());
  for (const Validated_pair& pair : validation.pairs()) {
    const std::string& category = examples()[pair.shapes[0]].category;
    CHECK((pair.category.empty() || pair.category == category));
    // Labels of what the training has seen the like of are right
    if (!pair.category.empty()) CHECK(pair.joined.f1() == 1);
    CHECK(pair.judged.size() == pair.joined.matched);
    const auto count = [&](bool Judged_pair::*what) {
      return std::size_t(std::count_if(pair.judged.begin(), pair.judged.end(),
                                       [&](const Judged_pair& judged) { return judged.*what; }));
    };
    CHECK(count(&Judged_pair::is_right) == pair.joined.right);
    CHECK(count(&Judged_pair::has_one_role) == pair.joined.right_coarse);
  }
  // Nothing speaks against the labels, so they count for no less than usual
  for (const Category_roles& category : validation.model().data().categories)
    CHECK(category.weights[SAME_LABEL] >= usual_pair_weights()[SAME_LABEL]);
}

TEST_CASE("Shapes that are turned by any angle are matched as those that face the front")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  std::vector<Validation_pair> chairs;
  for (const Validation_pair& pair : pairs_of_category(examples(), shapes.size()))
    if (shapes[pair[0]].labelled.category == "chair") chairs.push_back(pair);
  Validation_options options;
  options.is_turned = true;
  const Role_validation validation(shapes, chairs, options, {});
  for (const Validated_pair& pair : validation.pairs())
    if (!pair.category.empty()) {
      CHECK(pair.category == "chair");
      CHECK(pair.joined.f1() == 1);
    }
}

TEST_CASE("What was left out of the training is not known")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> pairs{{0, 2}, {1, 3}};
  for (const Left_out left_out : {Left_out::SOURCES, Left_out::CATEGORY}) { // each category is of one source
    Validation_options options;
    options.left_out = left_out;
    const Role_validation validation(shapes, pairs, options, {});
    for (const Validated_pair& pair : validation.pairs()) {
      CHECK(pair.category.empty());
      CHECK(pair.joined.right == pair.geometric.right);
      CHECK(pair.joined.matched == pair.geometric.matched);
    }
  }
}

TEST_CASE("Few examples: the training sees so many shapes of the category, and neither of the pair")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> pairs{{0, 2}, {1, 3}};
  Validation_options options;
  options.left_out = Left_out::CATEGORY;
  options.category_is_told = true;
  for (const std::size_t count : {1u, 3u, 100u}) {
    options.examples = count;
    const Role_validation validation(shapes, pairs, options, {});
    for (const Validated_pair& pair : validation.pairs()) {
      CHECK(pair.category == shapes[pair.shapes[0]].labelled.category);
      CHECK(pair.labels_joined == 1);
    }
  }
  options.examples.reset();
  const Role_validation unseen(shapes, pairs, options, {});
  for (const Validated_pair& pair : unseen.pairs())
    CHECK(pair.category.empty());
  // As many as there are: the same as with the shapes left out alone
  options.left_out = Left_out::SHAPES;
  options.examples = 3;
  const Role_validation few(shapes, pairs, options, {});
  options.examples.reset();
  const Role_validation all(shapes, pairs, options, {});
  for (std::size_t i = 0; i < pairs.size(); ++i)
    CHECK(few.pairs()[i].joined.right == all.pairs()[i].joined.right);
}

TEST_CASE("Fine labels are learned where all parts of a role have one, and the side is told from the place")
{
  std::vector<Labelled_graph> shapes = labelled(examples());
  const Furniture shape = chair(0.17, 1.9);
  const auto fine_of_legs = [&] {
    const Part_roles roles = part_roles(shape.graph, train_role_model(shapes), "chair");
    return std::vector<std::string>{roles.labels[0].fine, roles.labels[1].fine, roles.labels[2].fine,
                                    roles.labels[3].fine};
  };
  CHECK(fine_of_legs() ==
        std::vector<std::string>{"leg_back_right", "leg_front_right", "leg_back_left", "leg_front_left"});
  for (Labelled_graph& example : shapes)
    example.labels[0].fine = "";
  CHECK(fine_of_legs() == std::vector<std::string>(4, ""));
  // All legs are taken to be alike, which does not tell them apart
  for (Labelled_graph& example : shapes)
    for (Part_label& label : example.labels)
      if (label.coarse == "leg") label.fine = "leg_front";
  CHECK(fine_of_legs() == std::vector<std::string>(4, ""));
}

TEST_CASE("The set of pairs of greatest expected F1")
{
  const auto taken = [](const std::vector<double>& p) {
    return pairs_of_greatest_expected_f1(Eigen::Map<const Eigen::ArrayXd>(p.data(), Eigen::Index(p.size())));
  };
  // Expected right: 1.7. One pair: 2 (0.9) / (1 + 1.7) = 0.667; two: 3 / 3.7 = 0.811; three: 3.4 / 4.7 = 0.723
  CHECK(taken({0.6, 0.2, 0.9}) == std::vector<char>{1, 0, 1});
  // Expected right: 0.9. One: 0.6 / 1.9; two: 1.2 / 2.9; three: 1.8 / 3.9 is the most: equals are taken together
  CHECK(taken({0.3, 0.3, 0.3}) == std::vector<char>{1, 1, 1});
  // No set is better than that of the first pair: 2 / 2.02
  CHECK(taken({0.01, 1, 0.01}) == std::vector<char>{0, 1, 0});
  CHECK(taken({}).empty());
}

TEST_CASE("Weights of the terms are those that the examples are likeliest with")
{
  // Right in 3 of 4 pairs that have the term, in 1 of 4 that have not: logits log 3 and -log 3, so the weight is 2 log
  // 3
  Judged_terms example;
  example.terms = Pair_terms::Zero(8, PAIR_TERM_COUNT);
  example.terms.col(CONSTANT).setOnes();
  example.terms.col(SAME_LABEL).head(4).setOnes();
  example.is_right.resize(8);
  example.is_right << 1, 1, 1, 0, 1, 0, 0, 0;
  const Pair_weights none = Pair_weights::Zero(),
                     weights = fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, none, 1e-4);
  CHECK(weights[SAME_LABEL] == Approx(2 * std::log(3)).epsilon(0.01));
  CHECK(weights[CONSTANT] == Approx(-std::log(3)).epsilon(0.01));
  CHECK(weights[VOTES_AGREE] == 0);
  CHECK(probabilities(example.terms, weights)[0] == Approx(0.75).epsilon(0.01));
  // Examples that a term tells apart without fault have finite weights
  example.is_right << 1, 1, 1, 1, 0, 0, 0, 0;
  CHECK(fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, none, 1e-4).allFinite());
  // A charge that outweighs the examples leaves what was expected
  const Pair_weights expected = usual_pair_weights();
  CHECK((fitted_weights<PAIR_TERM_COUNT>({{&example, 8}}, expected, 1e6) - expected).norm() < 1e-4);
  CHECK((fitted_weights<PAIR_TERM_COUNT>({}, expected, 1) - expected).norm() < pair_weight_unit);
}

TEST_CASE("Confidences are fitted to how often pairs of a probability are right")
{
  // Of pairs of a probability of .9, three quarters are right; of those of .5, a quarter
  Judged_confidences judged;
  judged.terms.resize(8, CONFIDENCE_TERM_COUNT);
  for (int k = 0; k < 8; ++k)
    judged.terms.row(k) = confidence_terms(k < 4 ? 0.9 : 0.5);
  judged.is_right.resize(8);
  judged.is_right << 1, 1, 1, 0, 1, 0, 0, 0;
  const Confidence_weights none = Confidence_weights::Zero(),
                           weights = fitted_weights<CONFIDENCE_TERM_COUNT>({{&judged, 8}}, none, 1e-4);
  CHECK(confidence(0.9, weights) == Approx(0.75).epsilon(0.01));
  CHECK(confidence(0.5, weights) == Approx(0.25).epsilon(0.01));
  // What is certain or impossible stays so, and the usual weights change nothing
  CHECK(confidence(0, weights) == 0);
  CHECK(confidence(1, weights) == 1);
  CHECK(confidence(0.3, usual_confidence_weights()) == Approx(0.3));
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
  CHECK(part_roles(usual.graph, model).category == "chair"); // the first of equals, since it is near
  CHECK(part_roles(odd.graph, model).category.empty());      // it is as far from chairs as from seats
}

TEST_CASE("The command label writes what the command roles predicts")
{
  const Temporary_folder folder;
  const std::string shape = std::string(SHAPE_CORRESPONDENCE_DATA_DIR) + "/chair_four_legged/parts";
  const std::string file = folder.path("labels.json");
  const Run labelled = run("label " + shape + " --output " + file);
  REQUIRE(labelled.status == 0);
  CHECK_THAT(labelled.out, Contains("seat"));
  const auto labels = nlohmann::json::parse(text_of(file));
  CHECK(labels["category"] == "chair");
  CHECK(labels["parts"].size() == 12);
  CHECK(labels == nlohmann::json::parse(run("roles predict " + shape + " --json - --quiet").out));
  CHECK(labels == nlohmann::json::parse(run("label " + shape + " -o - ").out));
  const auto as_table = nlohmann::json::parse(run("label " + shape + " -o - --category table").out);
  CHECK(as_table["category"] == "table");
  CHECK_THAT(run("label " + shape + " --category boat").error, Contains("does not have the category"));
  CHECK(run("label " + shape + " " + shape).status == 2);
  CHECK(run("label " + shape + " --output " + shape).status == 2);
}

TEST_CASE("The command roles")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR, quick = " --abstraction boxes --trees 5 --quiet ";
  const std::string train = "roles train " + data + quick + "--output " + folder.path("a.roles");
  const Run trained = run(train + " --threads 1 --manifest - --date 2026-01-31");
  REQUIRE(trained.status == 0);
  const auto manifest = nlohmann::json::parse(trained.out);
  CHECK(manifest["date"] == "2026-01-31");
  CHECK(manifest["shapes"].size() == 14);
  CHECK(manifest["categories"].size() == 6);
  CHECK(manifest["shapes"][0]["license"] == "GPL-3.0-or-later");
  const std::string bytes = text_of(folder.path("a.roles"));
  REQUIRE(run(train + " --threads 2").status == 0);
  CHECK(text_of(folder.path("a.roles")) == bytes);
  CHECK(run("roles predict " + data + "/stool/parts --abstraction boxes --quiet --roles " + folder.path("a.roles"))
            .status == 0);

  const Run evaluated = run("roles evaluate " + data + quick + "--leave-out category --json -");
  REQUIRE(evaluated.status == 0);
  const auto evaluation = nlohmann::json::parse(evaluated.out);
  CHECK(evaluation["left_out"] == "category");
  CHECK(evaluation["categories"].size() ==
        5); // of two and more shapes: chair, table, airplane, velocipede; and the mean
  for (const auto& category : evaluation["categories"])
    CHECK(category["with_roles"]["f1"]["mean"].get<double>() >= category["geometry"]["f1"]["mean"].get<double>() - 0.2);

  const Run few = run("roles evaluate " + data + quick + "--leave-out category --number-of-examples 1 --told --json -");
  REQUIRE(few.status == 0);
  CHECK(nlohmann::json::parse(few.out)["weights"].contains("same_label"));
  CHECK_THAT(run("roles evaluate " + data + " --number-of-examples 0").error, Contains("at least 1"));

  CHECK_THAT(run("roles train " + data).error, Contains("needs --output"));
  CHECK_THAT(run("roles learn " + data).error, Contains("train, evaluate, predict"));
  CHECK_THAT(run("roles evaluate " + data + " --leave-out luck").error, Contains("shapes, sources, category"));
  CHECK_THAT(run("roles evaluate " + folder.path("")).error, Contains("labels.json"));
  CHECK(run("roles --help").out.find("roles train FOLDER") != std::string::npos);
}

TEST_CASE("The shipped model knows the models of the package, and the program matches with it")
{
  const auto model = IO::shipped_role_model();
  CHECK(model->categories() ==
        std::vector<std::string>{"airplane", "bed", "car", "chair", "lamp", "shelf", "sofa", "table", "velocipede"});
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Run predicted = run("roles predict " + data + "/chair_four_legged/parts --json - --quiet");
  REQUIRE(predicted.status == 0);
  const auto labels = nlohmann::json::parse(predicted.out);
  CHECK(labels["category"] == "chair");
  const std::string shapes = data + "/chair_four_legged/parts " + data + "/stool/parts --quiet --json - ";
  CHECK(nlohmann::json::parse(run("match " + shapes).out)["category"] == "chair");
  CHECK(!nlohmann::json::parse(run("match " + shapes + "--roles none").out).contains("category"));
  CHECK(!nlohmann::json::parse(run("match " + shapes + "--search exact").out).contains("category"));
  const Run paper = run("match " + shapes + "--paper --category chair");
  CHECK(paper.status == 2);
  CHECK_THAT(paper.error, Contains("--category has no effect on --search beam"));
  const Run missing = run("match " + shapes + "--roles /nowhere.roles");
  CHECK(missing.status == 1);
  CHECK_THAT(missing.error, Contains("/nowhere.roles"));
}

TEST_CASE("The program matches with the user's own examples, and transfers labels")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Temporary_folder folder;
  std::filesystem::create_directory(folder.path("examples"));
  for (const std::string name : {"chair_four_legged", "stool"}) // as a category of one's own
    std::filesystem::copy(data + "/" + name, folder.path("examples/" + name), std::filesystem::copy_options::recursive);
  const std::string shapes = data + "/chair_four_legged/parts " + data + "/stool/parts --quiet --json - ";
  const auto matched =
      nlohmann::json::parse(run("match " + shapes + "--roles none --examples " + folder.path("examples")).out);
  CHECK(matched["category"] == "chair");
  const Run predicted =
      run("roles predict " + data + "/stool/parts --json - --quiet --examples " + folder.path("examples"));
  CHECK(nlohmann::json::parse(predicted.out)["category"] == "chair");
  CHECK_THAT(run("match " + shapes + "--examples " + folder.path("none")).error, Contains("no such file"));
  CHECK_THAT(run("match " + shapes + "--paper --examples " + folder.path("examples")).error,
             Contains("--examples has no effect on --search beam"));
  CHECK_THAT(run("match " + shapes + "--role-weight 1 --roles none").error, Contains("--role-weight has no effect"));
  const auto exact = nlohmann::json::parse(run("match " + shapes + "--role-weight 0.5").out);
  CHECK(exact["search"]["method"] == "exact");
  CHECK(exact["category"] == "chair");

  const std::string set =
      "collection " + folder.path("examples") + " --quiet --labels-from " + data + "/chair_four_legged ";
  const Run transferred = run(set + "--labels-to " + folder.path("labels") + " --json -");
  REQUIRE(transferred.status == 0);
  const auto result = nlohmann::json::parse(transferred.out);
  CHECK(result["category"] == "chair");
  CHECK(result["shapes"].size() == 2);
  const auto own = nlohmann::json::parse(text_of(folder.path("labels/chair_four_legged/labels.json")));
  const auto truth = nlohmann::json::parse(text_of(data + "/chair_four_legged/labels.json"));
  REQUIRE(own["parts"].size() == truth["parts"].size());
  for (const auto& part : own["parts"])
    for (const auto& known : truth["parts"])
      if (part["name"] == known["name"]) CHECK(part["coarse"] == known["coarse"]);
  CHECK(nlohmann::json::parse(text_of(folder.path("labels/stool/labels.json")))["parts"].size() > 3);

  CHECK_THAT(run("collection " + data + " --labels-to x").error, Contains("without --labels-from"));
  CHECK_THAT(run(set + "--csv x.csv").error, Contains("--labels-from goes with"));
  CHECK_THAT(run("collection " + folder.path("examples") + " --labels-from " + folder.path("examples")).error,
             Contains("2 labelled shapes"));
}
