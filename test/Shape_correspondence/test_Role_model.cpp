// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Roles of parts: training, prediction, writing and reading.
#include "labelled_furniture.h"
#include "model_files.h"
#include "roles/Role_model_data.h"
#include "roles/pair_model.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace CGAL::Shape_correspondence::internal;
using namespace model_files;
using Catch::Matchers::Contains;

TEST_CASE("Roles are predicted for shapes that the training did not see")
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

TEST_CASE("Large parts tell the category more than small ones")
{
  const Role_model model = train_role_model(labelled(examples()));
  const Category_roles& chairs = Role_model_access::data(model).categories[0];
  Role_features parts(2, ROLE_FEATURE_COUNT);
  std::copy_n(chairs.examples[0].features.begin(), std::size_t(ROLE_FEATURE_COUNT), &parts(0, 0));
  for (int k = 0; k < ROLE_FEATURE_COUNT; ++k)
    parts(1, k) = parts(0, k) < 127 ? 254 : 0; // as different from part 0 as a byte allows
  const auto distance = [&](int area) {
    parts(1, AREA) = std::uint8_t(area);
    return Role_model_access::distances(model).mean_distance(parts, 0);
  };
  CHECK(3 * distance(0) < distance(254));
}

TEST_CASE("What stands on the ground is no seat, such as a star base in one piece")
{
  std::deque<Furniture> chairs;
  for (int i = 0; i < 24; ++i)
    chairs.push_back(chair(0.1 + 0.01 * i, 1.4 + 0.02 * i));
  const Role_model model = train_role_model(labelled(chairs));
  const Furniture swivel =
      furniture("chair",
                {box("star", {-0.9, 0, -0.9}, {0.9, 0.2, 0.9}), box("column", {-0.1, 0.2, -0.1}, {0.1, 1.6, 0.1}),
                 box("seat", {-1, 1.6, -1}, {1, 1.8, 1}), box("back", {-1, 1.8, -1}, {1, 3.6, -0.8})},
                {});
  const Part_roles roles = part_roles(swivel.graph, model, "chair");
  CHECK(likeliest(roles)[0] == "leg");
  CHECK(roles.labels[0].coarse == "leg");
  CHECK(likeliest(roles)[2] == "seat");
  for (Eigen::Index part = 0; part < roles.probabilities.rows(); ++part)
    CHECK(roles.probabilities.row(part).sum() == Approx(1));
}

TEST_CASE(
    "Every tree is trained on a sample of the generated shapes; distances to a category are measured to the others")
{
  std::deque<Furniture> drawn;
  for (int i = 0; i < 30; ++i)
    drawn.push_back(chair(0.1 + 0.01 * i, 1 + 0.07 * i));
  std::vector<Labelled_graph> shapes = labelled(examples());
  for (const Labelled_graph& shape : labelled(drawn)) {
    shapes.push_back(shape);
    shapes.back().is_generated = true;
  }
  const auto chairs_of = [](const Role_model& model) { return Role_model_access::data(model).categories[0]; };
  Role_training_options options;
  options.generated_per_tree = 3;
  const Role_model model = train_role_model(shapes, options);
  CHECK(chairs_of(model).examples.size() == chairs_of(train_role_model(labelled(examples()))).examples.size());
  CHECK(bytes(model) != bytes(train_role_model(labelled(examples()))));
  std::reverse(shapes.begin(), shapes.end());
  CHECK(bytes(train_role_model(shapes, options)) == bytes(model));

  const Role_model of_generated = train_role_model({shapes.begin(), shapes.begin() + 30});
  CHECK(chairs_of(of_generated).examples.size() == 6 * 30); // they are kept, since there are no others
  options.generated_per_tree = -1;
  CHECK_THROWS_WITH(train_role_model(shapes, options), Contains("generated shapes of a tree"));
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
  std::filesystem::resize_file(folder.path("damaged.roles"), (std::uintmax_t(256) << 20) + 1);
  CHECK_THROWS_WITH(IO::read_role_model(folder.path("damaged.roles")),
                    Contains("damaged.roles") && Contains("longer than 256 MB"));

  // Truncated models are also detected without the digest of the file
  const std::string whole = bytes(model);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 50) {
    std::istringstream in(whole.substr(0, size));
    CHECK_THROWS_AS(Role_model::read(in, "cut"), Invalid_input);
  }
}

namespace {

std::vector<Role_example> random_examples(std::size_t count)
{
  std::mt19937 random(7);
  std::vector<Role_example> result(count);
  for (Role_example& example : result) {
    for (std::uint8_t& feature : example.features)
      feature = std::uint8_t(random() % 20);
    example.role = std::uint8_t(random() % 3);
    example.weight = 1;
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::string bytes_of(const Role_forest& forest)
{
  std::ostringstream out;
  forest.write(out);
  return out.str();
}

/// Reads a forest into `forest`. \return whether the entire text is a valid one
bool is_read(const std::string& text, int trees, int roles, Role_forest& forest)
{
  const auto owner = std::make_shared<const std::string>(text);
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(owner->data());
  Stored_bytes stored{begin, begin + owner->size(), owner};
  return forest.read(stored, trees, roles) && stored.size() == 0;
}

} // namespace

TEST_CASE("A forest that was read has the same votes as the trained one, whichever thread asks first")
{
  constexpr int trees = 9, roles = 3;
  const Role_forest grown(random_examples(60), trees, 5);
  Role_forest read;
  REQUIRE(is_read(bytes_of(grown), trees, roles, read));
  Role_forest unasked;
  REQUIRE(is_read(bytes_of(grown), trees, roles, unasked));
  Role_features parts(40, ROLE_FEATURE_COUNT);
  std::mt19937 random(11);
  std::generate(parts.data(), parts.data() + parts.size(), [&] { return std::uint8_t(random() % 20); });
  const Eigen::MatrixXi expected = grown.votes(parts, roles);
  CHECK(expected.rowwise().sum() == Eigen::VectorXi::Constant(parts.rows(), trees));
  std::vector<Eigen::MatrixXi> votes(4);
  std::vector<std::thread> threads;
  for (Eigen::MatrixXi& found : votes)
    threads.emplace_back([&found, &parts, copy = read] { found = copy.votes(parts, roles); });
  for (std::thread& thread : threads)
    thread.join();
  for (const Eigen::MatrixXi& found : votes)
    CHECK(found == expected);
  CHECK(bytes_of(unasked) == bytes_of(grown));
}

TEST_CASE("Invalid forests are refused when they are read, not only when they vote")
{
  constexpr int trees = 9, roles = 3;
  const std::string whole = bytes_of(Role_forest(random_examples(60), trees, 5));
  Role_forest read;
  CHECK(is_read(whole, trees, roles, read));
  CHECK_FALSE(is_read(whole, trees + 1, roles, read));
  CHECK_FALSE(is_read(whole, trees - 1, roles, read));
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_FALSE(is_read(whole.substr(0, size), trees, roles, read));
  const char no_role = char(ROLE_FEATURE_COUNT + roles);
  for (std::size_t node = 0; node < whole.size();) {
    std::string damaged = whole;
    damaged[node] = no_role;
    CHECK_FALSE(is_read(damaged, trees, roles, read));
    const bool is_leaf = std::uint8_t(whole[node]) >= ROLE_FEATURE_COUNT;
    node += is_leaf ? 1 : 2;
  }
}

TEST_CASE("A forest with so many roles that they take two bytes reads back as it was written")
{
  constexpr int trees = 5;
  for (int most : {3, 255 - ROLE_FEATURE_COUNT, 256 - ROLE_FEATURE_COUNT, 255}) {
    INFO(most);
    std::vector<Role_example> examples = random_examples(60);
    for (Role_example& example : examples)
      example.role = std::uint8_t(most - 1 - example.role);
    std::sort(examples.begin(), examples.end());
    const Role_forest grown(examples, trees, 5);
    Role_forest read;
    REQUIRE(is_read(bytes_of(grown), trees, most, read));
    CHECK_FALSE(is_read(bytes_of(grown), trees, most - 1, read));
    REQUIRE(is_read(bytes_of(grown), trees, most, read));
    Role_features parts = Role_features::Constant(1, ROLE_FEATURE_COUNT, 7);
    CHECK(read.votes(parts, most) == grown.votes(parts, most));
    CHECK(bytes_of(read) == bytes_of(grown));
  }
}

TEST_CASE("A model that is extended equals one that is trained with all shapes at once")
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

  // Shapes of a known category: its roles are learned from the old and the new shapes
  const Role_model extended = extend_role_model(train_role_model(first_half), second_half);
  for (const Furniture& shape : {chair(0.17, 1.9), shelf(0.08, 4)}) {
    const Part_roles a = part_roles(shape.graph, extended), b = part_roles(shape.graph, together);
    CHECK(a.probabilities == b.probabilities);
    CHECK(a.distance == b.distance);
  }
  // The extended model is the same if the first one was stored in a file
  const Temporary_folder folder;
  IO::write_role_model(folder.path("half.roles"), train_role_model(first_half));
  CHECK(bytes(extend_role_model(IO::read_role_model(folder.path("half.roles")), second_half)) == bytes(extended));

  // The new forests have as many trees as the model's
  Role_training_options few;
  few.trees = 7;
  CHECK(Role_model_access::data(extend_role_model(train_role_model(chairs, few), shelves)).trees == 7);
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
  CHECK(Role_model_access::data(train_role_model({shapes[0], shapes[2]})).categories[0].weights ==
        usual_pair_weights(2));
}

TEST_CASE("Examples that cannot be learned from are refused")
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

TEST_CASE("Fine labels are learned where all parts of a role have one; the side follows from the position")
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
  // All legs get the same label, so that they are not told apart
  for (Labelled_graph& example : shapes)
    for (Part_label& label : example.labels)
      if (label.coarse == "leg") label.fine = "leg_front";
  CHECK(fine_of_legs() == std::vector<std::string>(4, ""));
}
