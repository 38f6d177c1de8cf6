// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/quantized.h"
#include "matching/nearest_points_kernel.h"
#include "matching/part_assemblies.h"
#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Part_matching_options.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Axes = Eigen::Array3d;
using Surface = Eigen::ArrayX3d; // one point per row

// The bounding boxes of all parts, one per row.
struct Boxes
{
  Eigen::ArrayX3d low, high;
};

// Boxes with values derived from them, by which the costs of pairs are computed.
struct Measured_boxes : Boxes
{
  Eigen::ArrayXd volumes;
  Eigen::ArrayX3d logs; // logarithms of the extents

  Measured_boxes() = default;
  Measured_boxes(const Boxes& boxes, double tolerance);
};

// The influence of the ends of boxes on each other in a warp, along each axis: exp(-(d / width)² / 2) at distance d.
// The low end of part i has index 2 i, its high end 2 i + 1.
class Closeness
{
public:
  Closeness() = default;
  Closeness(const Boxes& boxes, double width);

  // The closeness of an end to both ends of each of the parts: cached, or computed with the same bits.
  void of_end(int axis, Eigen::Index end, const std::vector<Eigen::Index>& parts, Eigen::ArrayXd& result) const;

private:
  double width_ = 1;
  std::array<Eigen::ArrayXd, 3> ends_;
  std::array<Eigen::MatrixXd, 3> kept_; // one column for each end, symmetric; empty for shapes of many parts
};

// What is compared of a part, or of a union of parts, besides its box and the points of its surface.
struct Part_extent
{
  Eigen::Matrix3d orientation; // root of the covariance matrix of the surface, of Frobenius norm 1
  bool on_ground = false;
  bool is_board = false;    // upright, and as high and as wide as a wall
  bool is_in_chain = false; // one of the rings of a chain
};

// Sort key of shapes, invariant to turns about the up axis. It breaks ties alike, whichever shape is the source.
using Shape_rank = std::tuple<std::size_t, Steps, Steps>;

Shape_rank rank_of(const Aligned_shape& shape);

// The features of a shape that `match_parts()` compares, in the shape's unit box. Thread-safe.
struct Shape_features
{
  const Aligned_shape& shape;
  Part_matching_options options;
  Part_assemblies assemblies; // the assemblies found with the options

  std::vector<Surface> surfaces;  // points spread over the surface of each part
  std::vector<Point_lanes> lanes; // points of the surfaces, by part
  std::vector<Part_extent> parts;
  Measured_boxes boxes;
  Closeness closeness; // of the ends of the parts' boxes

  std::vector<std::vector<std::size_t>> unions; // sets of parts that may correspond to one part
  std::vector<Part_extent> union_parts;
  Measured_boxes union_boxes;

  // Features of the parts and of the unions, one column each, of length 1. A part or union without features gets the
  // mean of the parts with features, and so their mean distance from parts of the other shape. Empty: the shape has no
  // features
  Eigen::MatrixXd learned, learned_of_unions;
  Eigen::VectorXd mean_learned;  // mean of the parts with features
  std::vector<char> has_learned; // for each part, whether it has features

  Shape_rank rank;

  Shape_features(const Aligned_shape& shape, const Part_matching_options& options);

  std::size_t size() const { return shape.parts.size(); }
};

// Whether `Shape_features` are the same under both options.
bool have_same_features(const Part_matching_options& a, const Part_matching_options& b);

} // namespace CGAL::Shape_correspondence::internal
