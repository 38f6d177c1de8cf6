// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A shape with its labels.
struct Labelled_model
{
  std::string folder; ///< that was asked for
  IO::Labelled_shape labels;
  Structural_graph graph;
  std::vector<Part_label> part_labels; ///< by part of the graph
};

/// All labelled shapes of a folder of SHAPE/ or CATEGORY/SHAPE/ with `labels.json` and `parts/`.
/// \throw Invalid_input if one cannot be used, or a part has no label
std::vector<Labelled_model> load_labelled_models(const std::string& folder, const Common_options& options);

/// Pairs of shapes of a category and folder: those that FOLDER/pairs.json lists, or else at most `most` of a category,
/// spread evenly over all. \throw Invalid_input if a list names a shape that is not there
std::vector<std::array<std::size_t, 2>> listed_pairs(const std::vector<Labelled_model>& models, std::size_t most);

} // namespace CGAL::Shape_correspondence::cli
