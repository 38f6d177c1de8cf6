// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Shape_features.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Match_matrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

// Parts of both shapes that correspond as sets: a block of the matrix of matches.
struct Block
{
  std::vector<std::size_t> source, target;
};

// The blocks that confident pairs and panels make.
std::vector<Block> blocks_of(const Match_matrix& confident, const Shape_features& source, const Shape_features& target);

} // namespace CGAL::Shape_correspondence::internal
