// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Boxes.h"
#include "matching/nearest_points_kernel.h"
#include "matching/part_assemblies.h"
#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Part_matching_options.h>

#include <Eigen/Core>

#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Axes = Eigen::Array3d;
using Surface = Eigen::ArrayX3d; // a point a row

// A part, or several as one.
struct Part_extent
{
  Eigen::Matrix3d orientation;
  bool on_ground = false;
  bool is_board = false;    // upright, as high and as wide as a wall
  bool is_in_chain = false; // a ring of a chain
};

// An order of shapes that does not depend on turns about the up axis.
using Shape_rank = std::tuple<std::size_t, long, long>;

Shape_rank rank_of(const Aligned_shape& shape);

// The parts of a shape in its unit box.
struct Normalized_shape
{
  std::vector<Surface> surfaces;
  std::vector<Point_lanes> lanes; // of the surfaces
  std::vector<Part_extent> parts;
  Measured_boxes boxes;
  Closeness closeness; // of the ends of the boxes

  std::vector<std::vector<std::size_t>> unions; // sets of parts that may correspond to one part as a whole
  std::vector<Part_extent> union_parts;
  Measured_boxes union_boxes;

  Shape_rank rank;
};

Normalized_shape normalized_shape(const Aligned_shape& shape, const Part_assemblies& assemblies,
                                  const Part_matching_options& options);

} // namespace CGAL::Shape_correspondence::internal
