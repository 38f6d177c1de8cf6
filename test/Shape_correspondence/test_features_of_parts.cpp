// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "part_meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/features_of_parts.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <utility>

// Features of parts, and how matching by parts compares them.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using part_meshes::box;

namespace {

/// Boxes in one object: a large one of 1 x 1 x 1, and a small one of 0.5 x 0.5 x 0.5 apart from it.
Segmented_shape two_boxes()
{
  const Part_mesh large = box({0, 0, 0}, {1, 1, 1}), small = box({2, 0, 0}, {2.5, 0.5, 0.5});
  Part_mesh both;
  both.points.resize(3, 16);
  both.points << large.points, small.points;
  both.triangles.resize(3, 24);
  both.triangles << large.triangles, small.triangles.array() + 8;
  Segmented_shape result("boxes");
  result.add_part("both", both);
  return result;
}

Structural_graph with_features(Structural_graph graph, const Eigen::MatrixXd& features)
{
  structure(graph).features = features;
  return graph;
}

/// A feature for each kind of part of `hand_made::chair()`: seat, back, four legs.
Eigen::MatrixXd features_of_chair()
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3, 6);
  result.row(0)[0] = result.row(1)[1] = 1;
  result.row(2).tail(4).setOnes();
  return result;
}

/// The same features for `hand_made::slatted_chair()`, whose back is three slats.
Eigen::MatrixXd features_of_slatted_chair()
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3, 8);
  result.row(0)[0] = 1;
  result.row(1).segment(1, 3).setOnes();
  result.row(2).tail(4).setOnes();
  return result;
}

bool are_equal(const Correspondence& a, const Correspondence& b)
{
  return a.energy == b.energy && a.pairs.size() == b.pairs.size() &&
         std::equal(a.pairs.begin(), a.pairs.end(), b.pairs.begin(), [](const auto& p, const auto& q) {
           return p.source == q.source && p.target == q.target && p.confidence == q.confidence;
         });
}

} // namespace

TEST_CASE("Features of triangles are integrated over each part, and divided by the area of the shape")
{
  Segmented_shape shape("box and half of it");
  shape.add_part("large", box({0, 0, 0}, {1, 1, 1}));
  shape.add_part("small", box({2, 0, 0}, {2.5, 0.5, 0.5}));
  Eigen::MatrixXf features = Eigen::MatrixXf::Zero(2, 24);
  features.row(0).head(12).setConstant(5);
  features(1, 12) = 6; // a triangle of area 1/8, in a part of area 1.5
  const Eigen::MatrixXd parts = features_of_parts(features, shape);
  CHECK(parts(0, 0) == Approx(5 * 6 / 7.5));
  CHECK(parts(1, 0) == 0);
  CHECK(parts(0, 1) == 0);
  CHECK(parts(1, 1) == Approx(6 * 0.125 / 7.5));
}

TEST_CASE("Features of vertices are interpolated")
{
  Segmented_shape shape("box");
  shape.add_part("box", box({0, 0, 0}, {2, 2, 2}));
  const Eigen::MatrixXf heights = shape.parts()[0].mesh.points.row(1).cast<float>();
  CHECK(features_of_parts(heights, shape)(0, 0) == Approx(1));
}

TEST_CASE("Features follow the triangles of an object into the parts that are made of it")
{
  const Segmented_shape objects = two_boxes();
  Part_splitting_options options;
  options.mode = Part_splitting::COMPONENTS;
  const Part_split pieces = split_parts(objects, options);
  REQUIRE(pieces.shape.parts().size() == 2);
  Eigen::MatrixXf features = Eigen::MatrixXf::Zero(2, 24);
  features.row(0).head(12).setOnes();
  features.row(1).tail(12).setOnes();
  const Eigen::MatrixXd parts = features_of_parts(features, objects, pieces);
  const Eigen::Index large = parts(0, 0) > 0 ? 0 : 1;
  CHECK(parts(0, large) == Approx(6 / 7.5));
  CHECK(parts(1, large) == 0);
  CHECK(parts(0, 1 - large) == 0);
  CHECK(parts(1, 1 - large) == Approx(1.5 / 7.5));

  // Two pieces merged to one part, and a part that is a piece of a triangle of the object
  const Part_split merged = split_parts(objects, {{pieces.pieces[0].name, "all"}, {pieces.pieces[1].name, "all"}});
  CHECK(features_of_parts(features, objects, merged).isApprox(Eigen::Vector2d(6 / 7.5, 1.5 / 7.5)));
  Part_mesh quarter;
  quarter.points.resize(3, 3);
  quarter.points << 0.2, 0.4, 0.2, 0.1, 0.1, 0.3, 0, 0, 0; // on a side of the large box
  quarter.triangles = Eigen::Vector3i(0, 1, 2);
  Segmented_shape cut("cut");
  cut.add_part("quarter", quarter);
  CHECK(features_of_parts(features, objects, Part_split{cut, {}, {}}).isApprox(Eigen::Vector2d(1, 0)));
}

TEST_CASE("Features that do not fit the shape, or are not finite, are refused")
{
  const Segmented_shape shape = two_boxes();
  CHECK_THROWS_WITH(features_of_parts(Eigen::MatrixXf::Ones(3, 23), shape),
                    Contains("23 rows") && Contains("24 faces and 16 vertices"));
  CHECK_THROWS_AS(features_of_parts(Eigen::MatrixXf(3, 0), shape), Invalid_input);
  CHECK_THROWS_AS(features_of_parts(Eigen::MatrixXf(0, 24), shape), Invalid_input);
  Eigen::MatrixXf features = Eigen::MatrixXf::Ones(3, 16);
  features(1, 7) = std::numeric_limits<float>::quiet_NaN();
  CHECK_THROWS_WITH(features_of_parts(features, shape), Contains("row 7") && Contains("not finite"));
}

TEST_CASE("Without weight, and with features of one shape only, a match is as without features")
{
  const Structural_graph source = hand_made::chair(), target = hand_made::slatted_chair();
  const Correspondence without = find_correspondence(source, target);
  CHECK(without.feature_dimension == 0);
  const Structural_graph a = with_features(source, features_of_chair()),
                         b = with_features(target, features_of_slatted_chair());
  Search_options options;
  options.parts.weights.features = 0;
  const Correspondence no_weight = find_correspondence(a, b, options);
  CHECK(are_equal(no_weight, without));
  CHECK(no_weight.warnings == without.warnings);

  const Correspondence one = find_correspondence(a, target);
  CHECK(are_equal(one, without));
  REQUIRE(!one.warnings.empty());
  CHECK_THAT(one.warnings.back(), Contains("not compared"));
  CHECK(one.feature_dimension == 0);
  const Structural_graph nothing = with_features(target, Eigen::MatrixXd::Zero(3, 8));
  CHECK(are_equal(find_correspondence(a, nothing), without));

  const Correspondence with = find_correspondence(a, b);
  CHECK(!are_equal(with, without));
  CHECK(with.feature_dimension == 3);
  CHECK(with.feature_weight == Part_cost_weights().features);
  CHECK_THAT(with.warnings.back(), Contains("not calibrated"));
  CHECK_THROWS_WITH(find_correspondence(a, with_features(target, Eigen::MatrixXd::Ones(4, 8))),
                    Contains("3 dimensions") && Contains("4"));
}

TEST_CASE("Features outweigh places if they have the weight, and only their direction counts")
{
  // The seats and backs of two chairs, with features swapped
  const Structural_graph source = with_features(hand_made::chair(), features_of_chair());
  Eigen::MatrixXd swapped = features_of_chair();
  swapped.col(0).swap(swapped.col(1));
  const auto partner = [&](double weight, const Eigen::MatrixXd& features) {
    Search_options options;
    options.parts.weights.features = weight;
    const Correspondence found = find_correspondence(source, with_features(hand_made::chair(), features), options);
    return std::find_if(found.pairs.begin(), found.pairs.end(), [](const auto& pair) { return pair.source == 0; })
        ->target;
  };
  CHECK(partner(0.1, swapped) == 0);
  CHECK(partner(20, swapped) == 1);
  CHECK(partner(20, 1e-30 * swapped) == 1);
  CHECK(partner(20, 1e30 * swapped) == 1);
  CHECK(partner(20, features_of_chair()) == 0);
}

TEST_CASE("Swapping the shapes swaps the pairs, to the last bit of the confidences")
{
  Eigen::MatrixXd one = features_of_chair(), other = features_of_slatted_chair();
  one += 0.1 * Eigen::MatrixXd::Random(3, 6);
  other += 0.1 * Eigen::MatrixXd::Random(3, 8);
  one.col(3).setZero(); // a part without features
  const Structural_graph a = with_features(hand_made::chair(), one),
                         b = with_features(hand_made::slatted_chair(), other);
  Correspondence there = find_correspondence(a, b), back = find_correspondence(b, a);
  for (Part_correspondence& pair : back.pairs)
    std::swap(pair.source, pair.target);
  std::sort(back.pairs.begin(), back.pairs.end(), is_before);
  back.energy = there.energy; // `back` has the energy of deforming the other shape
  CHECK(are_equal(there, back));
}

TEST_CASE("A part without features is matched by the rest of its cost")
{
  Eigen::MatrixXd features = features_of_chair();
  features.col(1).setZero();
  const Correspondence found = find_correspondence(with_features(hand_made::chair(), features),
                                                   with_features(hand_made::chair(), features_of_chair()));
  CHECK(part_pairs(found.pairs) == part_pairs(find_correspondence(hand_made::chair(), hand_made::chair()).pairs));
}
