// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Shape_features.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Match_matrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

// Parts of either shape that correspond as sets: a block of the matrix of matches.
struct Block
{
  std::vector<std::size_t> source, target;

  bool is_one_sided() const { return source.empty() || target.empty(); }
};

// The blocks that confident pairs, symmetry groups and panels make. One that has parts of one shape only joins the
// block of the parts that it resembles in this shape, the most alike first.
std::vector<Block> joined_blocks(const Match_matrix& confident, const Shape_features& source,
                                 const Shape_features& target, const Part_matching_options& options);

} // namespace CGAL::Shape_correspondence::internal
