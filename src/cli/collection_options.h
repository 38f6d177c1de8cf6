// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/match_options.h"
#include "cli/program_options_fwd.h"

#include <CGAL/Shape_correspondence/co_analysis.h>

#include <string>

namespace CGAL::Shape_correspondence::cli {

/// The options that only this command has.
struct Collection_options
{
  std::string npy, csv, store, tile, nearest, labels_from, labels_to;
  bool merge = false, skip_bad = false, matches = false, agreeing = false;
  std::size_t block_size = 0, neighbours = 0, nearest_count = 5;
  double unmatched_energy = 0.5;
  Co_analysis_options co_analysis;
  std::size_t tile_number = 0, tile_count = 1;
};

boost::program_options::options_description collection_options(Common_options& common, Collection_options& options);

/// Reads the tile, and checks options one by one and together.
/// \throw Usage_error
void check(Collection_options& options, const Common_options& common,
           const boost::program_options::variables_map& values);

/// All that energies and pairs depend on besides the shapes.
std::string key_of(const Match_options& match, const Search_options& search, const Collection_options& options,
                   const boost::program_options::variables_map& values);
/// The same of options of the match in other words. \param search what has the roles
std::string key_of(const std::string& match_options, const Search_options& search, double unmatched_energy);

} // namespace CGAL::Shape_correspondence::cli
