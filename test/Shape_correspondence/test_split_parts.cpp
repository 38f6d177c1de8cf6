// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "part_meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Shape_correspondence;
using box_shapes::box;
using Catch::Matchers::Contains;

namespace {

Part_mesh joined(const std::vector<Part_mesh>& meshes)
{
  Part_mesh result = meshes[0];
  for (std::size_t i = 1; i < meshes.size(); ++i)
    result = part_meshes::joined(result, meshes[i]);
  return result;
}

/// A sheet in the plane of x and y, with one layer of triangles.
Part_mesh sheet(const Point& middle, double width, double height)
{
  Part_mesh mesh;
  mesh.points.resize(3, 4);
  mesh.points << -width, width, width, -width, -height, -height, height, height, 0, 0, 0, 0;
  mesh.points = ((mesh.points / 2).colwise() + middle).eval();
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 0, 1, 2, 2, 3;
  return mesh;
}

std::vector<Part_mesh> legs()
{
  std::vector<Part_mesh> result;
  for (const double x : {-0.45, 0.45})
    for (const double z : {-0.45, 0.45})
      result.push_back(box({x, 0.35, z}, {0.06, 0.7, 0.06}));
  return result;
}

Part_mesh top() { return box({0, 0.725, 0}, {1, 0.05, 1}); }

/// A rim, a hub and eight spokes in the plane of x and y, not in contact.
std::vector<Part_mesh> wheel(const Point& middle)
{
  const Eigen::Matrix3d upright = Eigen::AngleAxisd(EIGEN_PI / 2, Point::UnitX()).toRotationMatrix();
  std::vector<Part_mesh> result{part_meshes::moved(part_meshes::torus(0.3, 0.02), upright, Point::Zero()),
                                box({0, 0, 0}, {0.05, 0.05, 0.05})};
  for (int k = 0; k < 8; ++k) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(k * EIGEN_PI / 4, Point::UnitZ()).toRotationMatrix();
    result.push_back(part_meshes::moved(box({0.15, 0, 0}, {0.2, 0.008, 0.008}), turn, Point::Zero()));
  }
  for (Part_mesh& mesh : result)
    mesh.points.colwise() += middle;
  return result;
}

Segmented_shape model(const std::vector<std::pair<std::string, Part_mesh>>& objects)
{
  Segmented_shape result("model");
  for (const auto& [name, mesh] : objects)
    result.add_part(name, mesh);
  return result;
}

std::vector<std::string> names(const Part_split& split)
{
  std::vector<std::string> result;
  for (const Shape_part& part : split.shape.parts())
    result.push_back(part.name);
  return result;
}

/// The names of the pieces in each part.
std::set<std::set<std::string>> partition(const Part_split& split)
{
  std::vector<std::set<std::string>> parts(split.shape.parts().size());
  for (const Model_piece& piece : split.pieces)
    parts[piece.part].insert(piece.name);
  return {parts.begin(), parts.end()};
}

/// The sizes of the pieces in each part, in millionths of the size of the model.
std::multiset<std::multiset<long>> sizes(const Part_split& split)
{
  std::vector<std::multiset<long>> parts(split.shape.parts().size());
  for (const Model_piece& piece : split.pieces)
    parts[piece.part].insert(std::lround(1e6 * piece.size));
  return {parts.begin(), parts.end()};
}

Part_split split_by(const Segmented_shape& objects, Part_splitting mode)
{
  Part_splitting_options options;
  options.mode = mode;
  return split_parts(objects, options);
}

Segmented_shape table_of_materials() { return model({{"wood", joined(legs())}, {"glass", top()}}); }

} // namespace

TEST_CASE("Four legs that share an object become four parts, with its name")
{
  const Part_split split = split_parts(table_of_materials());
  CHECK(names(split) == std::vector<std::string>{"wood", "wood#2", "wood#3", "wood#4", "glass"});
  CHECK(split.pieces.size() == 5);
  CHECK(split.pieces[0].name == "wood#1");
  CHECK(split.pieces[4].name == "glass");
  CHECK(split.is_split(0));
  CHECK_FALSE(split.is_split(1));
  CHECK(split.changes_objects());
  CHECK(split.decisions[0] == "4 pieces, split into 4 parts");
  CHECK(split.decisions[1] == "one piece");
  CHECK(split.shape.parts()[4].mesh.points == top().points);
}

TEST_CASE("Mode FILE keeps objects, COMPONENTS takes loose pieces as parts, and SEGMENTS also divides these")
{
  const Segmented_shape table = table_of_materials();
  const Part_split file = split_by(table, Part_splitting::FILE);
  CHECK(names(file) == std::vector<std::string>{"wood", "glass"});
  CHECK_FALSE(file.changes_objects());
  CHECK(file.shape.parts()[0].mesh.points == table.parts()[0].mesh.points);
  CHECK(split_by(table, Part_splitting::COMPONENTS).shape.parts().size() == 5);
  const Part_split segments = split_by(table, Part_splitting::SEGMENTS);
  CHECK(segments.by_segments);
  CHECK(segments.shape.parts().size() >= 5);
}

TEST_CASE("A spoked wheel is one part, also where it is one of two in an object of its own")
{
  const Part_split split = split_parts(model({{"frame", box({0.5, 0.5, 0}, {1.2, 0.05, 0.05})},
                                              {"front", joined(wheel({0, 0.3, 0}))},
                                              {"rear", joined(wheel({1, 0.3, 0}))}}));
  CHECK(names(split) == std::vector<std::string>{"frame", "front", "rear"});
  CHECK_FALSE(split.changes_objects());
  CHECK_THAT(split.decisions[1], Contains("kept whole: its largest piece holds the others"));
}

TEST_CASE("A cushion with its piping and buttons is one part")
{
  const Part_mesh cushion = box({0, 0.85, 0}, {0.9, 0.15, 0.9}, 0, 4);
  std::vector<Part_mesh> pieces{cushion};
  for (const double x : {-0.45, 0.45})
    pieces.push_back(box({x, 0.92, 0}, {0.012, 0.012, 0.9}));
  pieces.push_back(box({0.1, 0.925, 0.1}, {0.03, 0.01, 0.03}));
  const Part_split split = split_parts(model({{"wood", joined(legs())}, {"top", top()}, {"fabric", joined(pieces)}}));
  CHECK(names(split) == std::vector<std::string>{"wood", "wood#2", "wood#3", "wood#4", "top", "fabric"});
}

TEST_CASE("A lining joins the board that it lies on")
{
  const auto parts = [](double height) {
    const Part_mesh boards = joined({box({0, 0, 0}, {1, 0.02, 1}), box({0, 1, 0}, {1, 0.02, 1})});
    const Part_mesh lining = box({0, height, 0}, {0.5, 0.004, 0.5});
    return partition(
        split_parts(model({{"wood", joined({boards, lining})}, {"side", box({0.6, 0.5, 0}, {0.1, 1, 1})}})));
  };
  CHECK(parts(0.017) == std::set<std::set<std::string>>{{"wood#1", "wood#2"}, {"wood#3"}, {"side"}});
  CHECK(parts(0.2).size() == 4);
}

TEST_CASE("Screws join what they touch")
{
  std::vector<Part_mesh> pieces = legs();
  for (const Part_mesh& leg : legs()) {
    const Point middle = leg.points.rowwise().mean();
    pieces.push_back(box(middle + Point(0.035, 0.3, 0), {0.01, 0.015, 0.015}));
  }
  CHECK(partition(split_parts(model({{"wood", joined(pieces)}, {"top", top()}}))) ==
        std::set<std::set<std::string>>{
            {"wood#1", "wood#2"}, {"wood#3", "wood#5"}, {"wood#4", "wood#6"}, {"wood#7", "wood#8"}, {"top"}});
}

TEST_CASE("Pieces that are deep in each other stay together, those that only touch do not")
{
  const Part_mesh bar = box({0, 0, 0}, {1, 0.1, 0.1});
  const auto parts = [&](const Part_mesh& other) {
    return split_parts(model({{"bars", joined({bar, other})}, {"far", box({0, 2, 0}, {1, 0.1, 0.1})}}))
        .shape.parts()
        .size();
  };
  CHECK(parts(box({0.2, 0.01, 0.01}, {1, 0.1, 0.1})) == 2);
  CHECK(parts(box({1.001, 0, 0}, {1, 0.1, 0.1})) == 3);
}

TEST_CASE("A small object of pieces that touch stays whole")
{
  const Part_mesh handle = joined({box({0, 0.4, 0.51}, {0.02, 0.02, 0.02}), box({0.1, 0.4, 0.51}, {0.02, 0.02, 0.02}),
                                   box({0.05, 0.4, 0.53}, {0.14, 0.02, 0.02})});
  const Part_split split = split_parts(model({{"door", box({0, 0.5, 0}, {1, 1, 1})}, {"handle", handle}}));
  CHECK(names(split) == std::vector<std::string>{"door", "handle"});
  CHECK_THAT(split.decisions[1], Contains("its pieces touch"));
}

TEST_CASE("An object that would become too many parts stays as it is")
{
  std::vector<Part_mesh> leaves;
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 10; ++k)
      leaves.push_back(box({0.3 * i, 0.3 * k, 0}, {0.2, 0.2, 0.01}, 0, 1));
  const Part_split split = split_parts(model({{"leaves", joined(leaves)}, {"pot", box({1, -1, 0}, {1, 1, 1})}}));
  CHECK(names(split) == std::vector<std::string>{"leaves", "pot"});
  CHECK_THAT(split.decisions[0], Contains("it would be 120 parts"));

  // Small pieces of such an object do not join other objects either
  std::vector<Part_mesh> dust;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 30; ++k)
      dust.push_back(box({-0.4 + 0.02 * i, -0.4 + 0.02 * k, 0.5}, {0.002, 0.002, 0.002}, 0, 1));
  const Part_split dusty = split_parts(model({{"pot", box({0, 0, 0}, {1, 1, 1})}, {"dust", joined(dust)}}));
  CHECK(names(dusty) == std::vector<std::string>{"pot", "dust"});
}

TEST_CASE("Materials must be those of all triangles of all objects")
{
  const auto parts = [](std::vector<std::vector<int>> materials) {
    Part_splitting_options options;
    options.materials = std::move(materials);
    return split_parts(model({{"leg", legs()[0]}, {"top", top()}}), options);
  };
  const std::vector<int> of_leg(std::size_t(legs()[0].triangles.cols()), 0);
  CHECK_THROWS_WITH(parts({of_leg}), Contains("materials of 1 objects for 2"));
  CHECK_THROWS_WITH(parts({of_leg, {0, 1}}), Contains("'top' has ") && Contains("but materials of 2"));
}

TEST_CASE("Pieces that the frame of a model holds, such as drawers, are parts")
{
  const auto parts = [](double size) { // size of the cabinet, divided by that of the model
    const Part_mesh drawers = joined({box({0, 0.3, 0}, {0.8, 0.3, 0.8}), box({0, -0.3, 0}, {0.8, 0.3, 0.8})});
    return split_parts(model({{"wood", joined({box({0, 0, 0}, {1, 1, 1}), drawers})},
                              {"far", box({0, 0, 1 / size}, {1, 1, 0.1})}}))
        .shape.parts()
        .size();
  };
  CHECK(parts(0.9) == 4);
  CHECK(parts(0.2) == 2);
}

TEST_CASE("A model of one object becomes its pieces, one of one piece its segments")
{
  const Part_split pieces = split_parts(model({{"table", joined({top(), legs()[0], legs()[1]})}}));
  CHECK(names(pieces) == std::vector<std::string>{"table", "table#2", "table#3"});
  CHECK_FALSE(pieces.by_segments);
  // A drawer in its cabinet: the cabinet contains it, but joining them would leave a single part
  CHECK(split_parts(model({{"all", joined({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {0.5, 0.5, 0.5})})}}))
            .shape.parts()
            .size() == 2);

  const std::vector<Eigen::Vector2d> dumb_bell{{0, 0},   {1, 0},    {1, 1}, {0.1, 1.05},
                                               {0.1, 4}, {1, 4.05}, {1, 5}, {0, 5}};
  const Part_split segments = split_parts(model({{"bell", part_meshes::turned(dumb_bell)}}));
  CHECK(segments.by_segments);
  const Part_split block = split_parts(model({{"block", box({0, 0, 0}, {1, 1, 1})}}));
  CHECK(names(block) == std::vector<std::string>{"block"});

  const auto ring = part_meshes::torus_like(320, 320, [](double u, double v) {
    return Point((3 + std::cos(v)) * std::cos(u), std::sin(v), (3 + std::cos(v)) * std::sin(u));
  }); // more triangles than a mesh may have to be segmented by default
  const Part_split large = split_parts(model({{"ring", ring}}));
  CHECK(names(large) == std::vector<std::string>{"ring"});
  CHECK_FALSE(large.by_segments);
}

TEST_CASE("Position, size, rotation and order do not matter")
{
  std::vector<Part_mesh> pieces = legs();
  pieces.push_back(box({0.485, 0.3, 0.45}, {0.01, 0.015, 0.015})); // a screw
  const auto objects = [&](const Eigen::Matrix3d& linear, const Point& by, bool reversed) {
    std::vector<Part_mesh> moved;
    for (const Part_mesh& piece : pieces)
      moved.push_back(part_meshes::moved(piece, linear, by));
    if (reversed) std::reverse(moved.begin(), moved.end());
    return model({{"wood", joined(moved)}, {"top", part_meshes::moved(top(), linear, by)}});
  };
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();
  const Part_split split = split_parts(objects(Eigen::Matrix3d::Identity(), Point::Zero(), false));
  CHECK(partition(split).count({"wood#4", "wood#5"}) == 1);
  CHECK(partition(split_parts(objects(Eigen::Matrix3d::Identity(), Point::Zero(), true))) == partition(split));
  CHECK(sizes(split_parts(objects(1e-3 * turn, {5, 6, 7}, false))) == sizes(split));
  CHECK(sizes(split_parts(objects(1e6 * turn, {0, 0, 0}, false))) == sizes(split));
  CHECK(sizes(split_parts(objects(turn, {0, 0, 0}, true))) == sizes(split));
}

TEST_CASE("Vertices at the same place connect pieces, pieces without area are left out")
{
  Part_mesh flat = sheet({2, 0, 0}, 1, 0);
  const Part_split split = split_parts(
      model({{"a", joined({sheet({0, 0, 0}, 1, 1), sheet({1, 0, 0}, 1, 1), flat})}, {"b", sheet({0, 0, 3}, 1, 1)}}));
  CHECK(split.pieces.size() == 2);
  CHECK(split.pieces_left_out == 1);
}

TEST_CASE("New names of parts differ from the names of objects")
{
  const Part_split split = split_parts(model({{"wood", joined(legs())}, {"wood#2", top()}}));
  const std::vector<std::string> found = names(split);
  CHECK(std::set<std::string>(found.begin(), found.end()).size() == 5);
  CHECK(found.back() == "wood#2");
}

TEST_CASE("Parts follow an edited list of pieces")
{
  const Segmented_shape table = table_of_materials();
  std::map<std::string, std::string> parts{
      {"wood#1", "left"}, {"wood#2", "left"}, {"wood#3", "right"}, {"wood#4", ""}, {"glass", "top"}};
  const Part_split split = split_parts(table, parts);
  CHECK(names(split) == std::vector<std::string>{"left", "right", "top"});
  CHECK(split.pieces[3].part == no_part);
  CHECK(split.shape.parts()[0].mesh.points.cols() == 2 * legs()[0].points.cols());
  parts["wood#5"] = "none";
  CHECK_THROWS_AS(split_parts(table, parts), Invalid_input);
  parts.erase("wood#5");
  parts.erase("glass");
  CHECK_THROWS_AS(split_parts(table, parts), Invalid_input);
  CHECK_THROWS_AS(split_parts(Segmented_shape("empty")), Invalid_input);
}

TEST_CASE("A hundred thousand loose pieces are all parts, or are refused with what to do")
{
  constexpr int side = 317; // more than 100 000 pieces
  Part_mesh dust;
  dust.points.resize(3, 3 * side * side);
  dust.triangles.resize(3, side * side);
  for (int i = 0; i < side * side; ++i) {
    const Point at(i % side, i / side, 0);
    dust.points.col(3 * i) = at;
    dust.points.col(3 * i + 1) = at + Point(0.1, 0, 0);
    dust.points.col(3 * i + 2) = at + Point(0, 0.1, 0);
    dust.triangles.col(i) << 3 * i, 3 * i + 1, 3 * i + 2;
  }
  const Segmented_shape one_object = model({{"dust", dust}});
  try {
    split_parts(one_object);
    FAIL("they were grouped");
  } catch (const Invalid_input& error) {
    CHECK_THAT(error.what(), Contains("100489") && Contains("10000") && Contains("take the objects as parts"));
  }
  Part_splitting_options options;
  options.mode = Part_splitting::COMPONENTS;
  CHECK(split_parts(one_object, options).shape.parts().size() == std::size_t(side * side));
  CHECK(split_parts(model({{"dust", dust}, {"top", top()}})).decisions[0].find("kept whole") != std::string::npos);
}
