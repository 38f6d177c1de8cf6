// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

constexpr const char* match_group = "Options of match";

/// The names of methods on the command line.
extern const std::vector<std::pair<const char*, Search_method>> search_methods;

/// The options of the search as given on the command line.
struct Match_options
{
  Search_options search;               ///< members that options set directly
  std::optional<Search_method> method; ///< empty: selected by other options
  std::string front = "likely";        ///< given, likely or auto
  std::optional<int> alignments;       ///< empty: depends on `front`
  bool paper = false;
  std::string roles = "auto"; ///< auto, none or a file
  std::string examples;       ///< a folder; empty: none
  std::string source_parts, target_parts;
  std::vector<std::string> pinned, forbidden; ///< A=B
};

void add_match_options(Option_table& table, Match_options& match);

/// The search options, without those set by `choose_parts()`. \throw Usage_error
Search_options search_options(const Match_options& match, const Option_table& given);

/// Sets the options of graphs implied by `--paper`, unless they are given.
void take_graphs_of_paper(const Match_options& match, const Option_table& given, Structure_options& options);

} // namespace CGAL::Shape_correspondence::cli
