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

#include <nlohmann/json.hpp>

#include <algorithm>
#include <deque>
#include <sstream>
#include <string>
#include <vector>

using namespace hand_made;
using namespace model_files;
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
  std::vector<std::string> roles;
};

Furniture furniture(const std::string& category, std::vector<Part_abstraction> parts, std::vector<std::string> roles)
{
  Shape_structure shape;
  shape.name = category;
  shape.parts = std::move(parts);
  std::vector<Part_group> groups;
  for (std::size_t part = 0; part < shape.parts.size(); ++part)
    groups.push_back({{part}, {}, 0, 0});
  return {make_structural_graph(std::move(shape), std::move(groups)), category, std::move(roles)};
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
  return furniture("chair", std::move(parts), {"leg", "leg", "leg", "leg", "seat", "back"});
}

// A shelf: two sides and boards in between.
Furniture shelf(double thickness, int boards)
{
  std::vector<Part_abstraction> parts{box("left", {1 - thickness, 0, -0.5}, {1, 4, 0.5}),
                                      box("right", {-1, 0, -0.5}, {-1 + thickness, 4, 0.5})};
  std::vector<std::string> roles{"side", "side"};
  for (int i = 0; i < boards; ++i) {
    const double y = (4 - thickness) * (i + 0.5) / boards;
    parts.push_back(box("board" + std::to_string(i), {-1 + thickness, y, -0.5}, {1 - thickness, y + thickness, 0.5}));
    roles.push_back("board");
  }
  return furniture("shelf", std::move(parts), std::move(roles));
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
    result.push_back({&shape.graph, shape.category, shape.roles, 1});
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
  CHECK(model.trust("shelf") == Role_trust::FULL);
  for (const Furniture& shape : {chair(0.17, 1.9), shelf(0.08, 4)}) {
    const Part_roles roles = part_roles(shape.graph, model);
    CHECK(roles.category == shape.category);
    CHECK(likeliest(roles) == shape.roles);
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

TEST_CASE("What cannot be learned from")
{
  std::vector<Labelled_graph> shapes = labelled(examples());
  shapes[0].roles.pop_back();
  CHECK_THROWS_WITH(train_role_model(shapes), Contains("role for every part"));
  shapes = labelled(examples());
  shapes[0].roles[1] = "";
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
  CHECK(ab.source_roles == a.roles);
  CHECK(ab.target_roles == b.roles);

  // Every board with every board, and sides with sides only
  std::size_t boards = 0;
  for (const Part_correspondence& pair : ab.pairs) {
    CHECK(a.roles[pair.source] == b.roles[pair.target]);
    boards += a.roles[pair.source] == "board";
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

namespace {

using namespace CGAL::Shape_correspondence::internal;

std::vector<Validation_shape> validation_shapes(const std::deque<Furniture>& shapes)
{
  std::vector<Validation_shape> result;
  for (const Furniture& shape : shapes) {
    Validation_shape labelled{{&shape.graph, shape.category, shape.roles, 1}, shape.category + " maker", {}};
    for (const std::string& role : shape.roles)
      labelled.labels.push_back({role, ""});
    result.push_back(std::move(labelled));
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

TEST_CASE("How far roles are trusted follows from shapes that were left out")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> all = pairs_of_category(examples(), shapes.size());
  const Role_validation validation(shapes, all, Left_out::SHAPES, {});
  REQUIRE(validation.pairs().size() == all.size());
  for (const Validated_pair& pair : validation.pairs()) {
    const std::string& category = examples()[pair.shapes[0]].category;
    CHECK((pair.category.empty() || pair.category == category));
    CHECK(pair.joined.matched == pair.scores[std::size_t(pair.trust)].matched);
    // Roles of what the training has seen the like of are right
    CHECK(pair.scores[std::size_t(Role_trust::FULL)].precision() == 1);
  }
  for (const char* category : {"chair", "shelf"}) {
    double geometric = 0, full = 0;
    for (const Validated_pair& pair : validation.pairs())
      if (examples()[pair.shapes[0]].category == category) {
        geometric += pair.scores[std::size_t(Role_trust::NONE)].f1();
        full += pair.scores[std::size_t(Role_trust::FULL)].f1();
      }
    INFO(category << ' ' << geometric << ' ' << full);
    if (full <= geometric) CHECK(validation.trust(category) != Role_trust::FULL);
    if (full > geometric + 1) CHECK(validation.trust(category) != Role_trust::NONE);
    CHECK(validation.model().trust(category) == validation.trust(category));
  }

  // Confidences rise with the probability of the same role
  const Confidence_table& confidences = validation.model().data().confidences;
  CHECK(std::is_sorted(confidences.begin(), confidences.end()));
  CHECK(confidences.front() >= 0);
  CHECK(confidences.back() <= 1);
}

TEST_CASE("What was left out of the training is not known")
{
  const std::vector<Validation_shape> shapes = validation_shapes(examples());
  const std::vector<Validation_pair> pairs{{0, 2}, {1, 3}};
  for (const Left_out left_out : {Left_out::SOURCES, Left_out::CATEGORY}) { // each category is of one source
    const Role_validation validation(shapes, pairs, left_out, {});
    for (const Validated_pair& pair : validation.pairs()) {
      CHECK(pair.category != examples()[pair.shapes[0]].category);
      for (const Correspondence_score& score : pair.scores)
        CHECK(score.right == pair.scores[0].right);
    }
  }

  // Few shapes earn no trust
  const Role_validation few(shapes, pairs_of_category(examples(), 6), Left_out::SHAPES, {});
  CHECK(few.trust("chair") == Role_trust::NONE);
  CHECK(few.trust("shelf") == Role_trust::NONE);
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
  CHECK_THAT(paper.error, Contains("--category needs --search parts"));
  const Run missing = run("match " + shapes + "--roles /nowhere.roles");
  CHECK(missing.status == 1);
  CHECK_THAT(missing.error, Contains("/nowhere.roles"));
}
