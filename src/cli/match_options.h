// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "cli/program_options_fwd.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The options of the search as they are written on the command line.
struct Match_options
{
  Search_options search;
  std::string method = "auto";
  std::string direction = "both";
  std::string alignments = "auto";
  std::string front = "likely";
  std::string coarse_shapes = "auto";
  std::string weights = "0.6,0.4";
  std::string norm = "sum";
  std::string without;
  std::string source_parts, target_parts;
  std::vector<std::string> pinned, forbidden; ///< A=B
  std::string roles = "auto";                 ///< auto, none or a file
  std::string examples;                       ///< a folder; empty: none
  double role_weight = 0;
  bool paper = false;
};

boost::program_options::options_description match_options(Match_options& match);

/// The search that the options ask for, but for `choose_parts()`. \throw Usage_error
Search_options search_options(const Match_options& match, const boost::program_options::variables_map& values);

/// For commands that take a correspondence in place of a search. `min-confidence` is of both.
/// \throw Usage_error if an option of the search is given
void refuse_search_options(const boost::program_options::variables_map& given);

/// Adds the labelled shapes of `--examples`, if any, to the roles of a search.
void add_examples(const Match_options& match, const Common_options& common, Search_options& search);

} // namespace CGAL::Shape_correspondence::cli
