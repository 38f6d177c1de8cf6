// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <cstddef>
#include <string>

namespace CGAL::Shape_correspondence::cli {

/// The options that only `collection` has.
struct Collection_options
{
  std::string npy, csv, store, nearest, labels_from, labels_to; ///< empty: none
  bool skip_bad = false, matches = false, agreeing = false;
  std::size_t nearest_count = 5;
  std::size_t neighbours = 0; ///< 0: by the number of shapes
  double unmatched_energy = Energy_matrix_options().unmatched_energy;
  Co_analysis_options co_analysis;
};

/// Adds these options and the options for output files to the table of a command.
void add_collection_options(Option_table& table, Common_options& common, Collection_options& options);

} // namespace CGAL::Shape_correspondence::cli
