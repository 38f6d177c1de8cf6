// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// How parts are found in models that have none: patches, a tree of their unions, its best cut, learned models.
#include "io/read/read_objects.h"
#include "part_meshes.h"
#include "roles/Boosted_trees.h"
#include "roles/Part_model.h"
#include "shape/Part_tree.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::internal;

namespace {

Part_mesh united(const std::vector<Part_mesh>& meshes)
{
  Part_mesh result;
  result.points.resize(3, 0);
  result.triangles.resize(3, 0);
  for (const Part_mesh& mesh : meshes) {
    const Eigen::Index points = result.points.cols(), triangles = result.triangles.cols();
    result.points.conservativeResize(Eigen::NoChange, points + mesh.points.cols());
    result.points.rightCols(mesh.points.cols()) = mesh.points;
    result.triangles.conservativeResize(Eigen::NoChange, triangles + mesh.triangles.cols());
    result.triangles.rightCols(mesh.triangles.cols()) = mesh.triangles.array() + int(points);
  }
  return result;
}

Segmented_shape one_object(const Part_mesh& mesh)
{
  Segmented_shape result("model");
  result.add_part("all", mesh);
  return result;
}

Surface_patches patches_of(const Part_mesh& mesh)
{
  return surface_patches(one_object(mesh), Eigen::Matrix3d::Identity());
}

/// The boxes of a table: the top, and four legs that end in its lower face. \param leg_z least z of two of the legs
std::vector<Part_mesh> table_boxes(double leg_z = 0.1)
{
  std::vector<Part_mesh> result{part_meshes::box({0, 1, 0}, {2, 1.1, 1})};
  for (double x : {0.1, 1.8})
    for (double z : {leg_z, 0.8})
      result.push_back(part_meshes::box({x, 0, z}, {x + 0.1, 1, z + 0.1}));
  return result;
}

std::vector<double> sorted_areas(const Surface_patches& surface)
{
  std::vector<double> result;
  for (const Surface_patch& patch : surface.patches)
    result.push_back(patch.moments.area);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST_CASE("A box has six patches, whose borders are its edges")
{
  const Surface_patches surface = patches_of(part_meshes::box({0, 0, 0}, {1, 2, 2}));
  REQUIRE(surface.patches.size() == 6);
  // The diagonal, 3, is the unit of length
  CHECK(surface.area == Approx(16. / 9));
  CHECK(surface.sides.isApprox(Point(1. / 3, 2. / 3, 2. / 3)));
  double border = 0;
  for (const Surface_patches::Contact& c : surface.contacts) {
    border += c.contact.border;
    CHECK(c.contact.flat_border == Approx(0).margin(1e-9)); // all angles are right angles
    CHECK(c.contact.concave_border == 0);
  }
  CHECK(border == Approx(4 * (1 + 2 + 2) / 3.));
  for (const Surface_patch& patch : surface.patches) {
    CHECK(patch.sheet == surface.patches[0].sheet);
    const Point centre = patch.moments.first / patch.moments.area;
    CHECK((centre - patch.box.center()).norm() == Approx(0).margin(1e-12));
  }
}

TEST_CASE("The second moments of a square are those of the integral")
{
  Part_mesh square;
  square.points.resize(3, 4);
  square.points << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  square.triangles.resize(3, 2);
  square.triangles << 0, 0, 1, 2, 2, 3;
  const Surface_patches surface = patches_of(square);
  REQUIRE(surface.patches.size() == 1);
  const double unit = std::sqrt(2.); // the diagonal is the unit of length
  const Surface_moments& m = surface.patches[0].moments;
  CHECK(m.area == Approx(1 / std::pow(unit, 2)));
  CHECK(m.second(0, 0) == Approx(1. / 3 / std::pow(unit, 4)));
  CHECK(m.second(0, 1) == Approx(1. / 4 / std::pow(unit, 4)));
}

TEST_CASE("Boxes with a common edge are two sheets")
{
  const Surface_patches surface =
      patches_of(united({part_meshes::box({0, 0, 0}, {1, 1, 1}), part_meshes::box({1, 1, 0}, {2, 2, 1})}));
  REQUIRE(surface.patches.size() == 12);
  std::set<std::size_t> sheets;
  for (const Surface_patch& patch : surface.patches) {
    sheets.insert(patch.sheet);
    CHECK(patch.component == 0);
  }
  CHECK(sheets.size() == 2);
}

TEST_CASE("Patches do not depend on diagonals and on the order of triangles")
{
  const Part_mesh table = united(table_boxes());
  const Surface_patches expected = patches_of(table);
  Part_mesh other = table;
  std::mt19937 random(1);
  std::vector<int> order(std::size_t(table.triangles.cols()));
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = int(i);
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t i = 0; i < order.size(); ++i)
    other.triangles.col(Eigen::Index(i)) = table.triangles.col(order[i]);
  const Surface_patches shuffled = patches_of(other);
  CHECK(sorted_areas(shuffled) == sorted_areas(expected));
  REQUIRE(shuffled.patches.size() == expected.patches.size());
  for (std::size_t i = 0; i < expected.patches.size(); ++i) // patches are numbered by position
    CHECK(shuffled.patches[i].moments.first.isApprox(expected.patches[i].moments.first));
  REQUIRE(shuffled.contacts.size() == expected.contacts.size());
  for (std::size_t i = 0; i < expected.contacts.size(); ++i) {
    CHECK(shuffled.contacts[i].first == expected.contacts[i].first);
    CHECK(shuffled.contacts[i].second == expected.contacts[i].second);
    CHECK(shuffled.contacts[i].contact.near == expected.contacts[i].contact.near);
  }
}

TEST_CASE("Congruent patches have the same shape number")
{
  const Surface_patches surface = patches_of(united(table_boxes()));
  std::map<std::size_t, int> count;
  for (const Surface_patch& patch : surface.patches)
    ++count[patch.shape];
  // Numbers of congruent patches: 2 faces of the top, its 2 long sides, its 2 short sides with 16 of legs, 8 ends of
  // legs
  std::multiset<int> sizes;
  for (const auto& [shape, n] : count)
    sizes.insert(n);
  CHECK(sizes == std::multiset<int>{2, 2, 8, 18});
}

TEST_CASE("Patches are merged in the order of their affinity")
{
  const Surface_patches surface = patches_of(united(table_boxes()));
  // An affinity that merges the patches of one sheet
  const std::vector<Part_node> nodes =
      part_tree(surface, [&](const Part_node& a, const Part_node& b, const Merge_features&) {
        return a.sheets == b.sheets ? 0.9 : -1;
      });
  CHECK(nodes.size() == 30 + 5 * 5); // five boxes of six faces
  std::size_t roots = 0;
  for (const Part_node& node : nodes) {
    if (node.parent == Part_node::none) ++roots;
    if (node.is_leaf()) continue;
    CHECK(node.affinity == Approx(0.9));
    double area = 0;
    for (std::size_t child : node.children) {
      area += nodes[child].moments.area;
      CHECK(nodes[nodes[child].parent].patches == node.patches);
    }
    CHECK(node.moments.area == Approx(area));
  }
  CHECK(roots == 5);
}

TEST_CASE("The best cut of a tree is worked out by hand")
{
  // Node 4 is the union of 0 and 1, 5 that of 2 and 3, 6 that of 4 and 5
  std::vector<Part_node> nodes(7);
  const auto merge = [&](std::size_t a, std::size_t b, std::size_t c) {
    nodes[c].children = {a, b};
    nodes[a].parent = nodes[b].parent = c;
  };
  merge(0, 1, 4);
  merge(2, 3, 5);
  merge(4, 5, 6);
  using Cut = std::vector<std::size_t>;
  CHECK(best_cut(nodes, {1, 1, -1, -1, 1, 1, 2}) == Cut{0, 1, 5}); // 1 + 1 + 1 is more than 1 + 1 and than 2
  CHECK(best_cut(nodes, {1, 1, -1, -1, 1, 1, 4}) == Cut{6});
  CHECK(best_cut(nodes, {0, 0, 0, 0, 0, 0, 0}) == Cut{6});            // among equal values, the largest part
  CHECK(best_cut(nodes, {-3, -3, -3, -3, -5, -5, -20}) == Cut{4, 5}); // the least negative value
}

TEST_CASE("Boosted trees learn combinations of features, and read back as they were written")
{
  std::mt19937_64 random(3);
  Byte_rows rows(400, 3);
  std::vector<double> targets, weights(400, 1);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index j = 0; j < rows.cols(); ++j)
      rows(i, j) = std::uint8_t(random() % 255);
    targets.push_back((rows(i, 0) < 128) != (rows(i, 1) < 128)); // the third feature is irrelevant
  }
  const Boosted_trees trees(rows, targets, weights, {60, 8, 0.2, 5, 1, 1});
  int right = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    right += (trees.probability(&rows(i, 0)) > 0.5) == (targets[std::size_t(i)] > 0.5);
  CHECK(right >= 390);

  std::ostringstream out;
  trees.write(out);
  const std::string bytes = out.str();
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  Boosted_trees read;
  Stored_bytes stored{begin, begin + bytes.size(), nullptr};
  REQUIRE(read.read(stored, 3));
  CHECK(stored.size() == 0);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    CHECK(read.logit(&rows(i, 0)) == trees.logit(&rows(i, 0)));
  for (std::size_t size = 0; size < bytes.size(); size += 7) { // truncated models
    Boosted_trees damaged;
    Stored_bytes part{begin, begin + size, nullptr};
    CHECK_FALSE(damaged.read(part, 3));
  }
  Boosted_trees other;
  Stored_bytes again{begin, begin + bytes.size(), nullptr};
  CHECK_FALSE(other.read(again, 1)); // it uses features that do not exist
}

TEST_CASE("Parts are learned from examples and found in others")
{
  std::vector<Part_example> examples;
  for (int i = 0; i < 12; ++i) {
    const std::vector<Part_mesh> boxes = table_boxes(0.1 + 0.02 * i);
    std::vector<std::size_t> parts;
    for (std::size_t part = 0; part < boxes.size(); ++part)
      parts.insert(parts.end(), 12, part);
    examples.push_back(
        part_example(one_object(united(boxes)), {parts}, i % 2 == 0 ? "table" : "desk", "source " + std::to_string(i)));
  }
  const Part_model model = train_part_model(examples);
  REQUIRE(model.categories.size() == 2);
  CHECK(model.categories[0].name == "desk");
  const Surface_patches surface = patches_of(united(table_boxes(0.23)));
  const std::vector<Part_node> nodes = part_candidates(surface, model);
  for (const Part_model::Category* category :
       {static_cast<const Part_model::Category*>(nullptr), &model.categories[1]}) {
    const std::vector<std::size_t> cut = likeliest_parts(surface, nodes, model, category);
    CHECK(cut.size() == 5);
    for (std::size_t i : cut)
      CHECK(nodes[i].sheets.size() == 1);
  }

  std::ostringstream first, second;
  model.write(first);
  train_part_model(examples).write(second);
  CHECK(first.str() == second.str());

  Part_model changed = model;
  const auto number_of_parts = [&](double worth) {
    changed.categories[1].worth = worth;
    return likeliest_parts(surface, nodes, changed, &changed.categories[1]).size();
  };
  CHECK(number_of_parts(2) < 5); // no part has the probability 2, from which it is worth taking
  CHECK(number_of_parts(0) >= 5);
  std::ostringstream out;
  changed.categories[0].worth = 0.3;
  changed.write(out);
  const std::string bytes = out.str();
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes.data());
  Stored_bytes stored{begin, begin + bytes.size(), nullptr};
  Part_model read;
  REQUIRE(read.read(stored));
  CHECK(stored.size() == 0);
  CHECK(read.categories[0].worth == Approx(0.3));
  CHECK(read.categories[1].worth == 0);
}

TEST_CASE("The report says in words what was found: the parts of each role, and their pieces")
{
  const Segmented_shape table = one_object(united(table_boxes()));
  const std::shared_ptr<const Role_model> roles = IO::shipped_role_model();
  const Part_split split = IO::split_parts_by_roles(table, {}, roles.get());
  REQUIRE(split.is_found);
  CHECK(split.shape.parts().size() == 5);
  CHECK(split.decisions == std::vector<std::string>{"5 pieces, split into 5 parts"});
  CHECK(split.found_roles == "table, with 4 × leg from 4 pieces, 1 × tabletop from 1 piece");
}

TEST_CASE("Parts that are found are unions of pieces; unions join pieces or earlier unions, the last one all pieces")
{
  std::vector<Part_mesh> meshes = table_boxes();
  for (double x : {0.09, 1.79}) // a foot under two of the legs
    meshes.push_back(part_meshes::box({x, -0.05, 0.09}, {x + 0.12, 0, 0.21}));
  const std::shared_ptr<const Role_model> roles = IO::shipped_role_model();
  const Part_split split = IO::split_parts_by_roles(one_object(united(meshes)), {}, roles.get());
  REQUIRE(split.is_found);
  std::vector<std::set<std::size_t>> sets;
  for (std::size_t i = 0; i < split.pieces.size(); ++i)
    sets.push_back({i});
  for (const auto& [a, b] : split.unions) {
    REQUIRE(std::max(a, b) < sets.size());
    std::set<std::size_t> both = sets[a];
    both.insert(sets[b].begin(), sets[b].end());
    CHECK(both.size() == sets[a].size() + sets[b].size());
    sets.push_back(both);
  }
  CHECK(sets.back().size() == split.pieces.size());
  for (std::size_t part = 0; part < split.shape.parts().size(); ++part) {
    std::set<std::size_t> pieces;
    for (std::size_t i = 0; i < split.pieces.size(); ++i)
      if (split.pieces[i].part == part) pieces.insert(i);
    CHECK(std::find(sets.begin(), sets.end(), pieces) != sets.end());
  }
}
