// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Option_table.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

class Role_model;
}

namespace CGAL::Shape_correspondence::cli {

/// The options of all commands.
struct Common_options
{
  std::string json, glb, html; ///< files to write; empty: none
  std::string cache;           ///< folder of cached graphs; empty: none
  bool keeps_reading = true;   ///< whether the cache keeps the parts and upright axes found for models, too
  std::string up;              ///< x, -x, +x etc., or auto; empty: the axis in the file, or an estimate that favours y
  std::string progress = "auto"; ///< auto, always or never
  Part_splitting parts = Part_splitting::AUTO;
  std::string features;   ///< like `Of_input::features`, set by `of_input()`
  std::string parts_from; ///< a file that assigns pieces to parts, or has labels of faces; empty: none
  IO::Reading_options reading;
  Structure_options structure;
  struct Of_input
  {
    std::string up, parts_from; ///< empty: the value for all inputs
    std::string features;       ///< file with features of its faces or vertices; empty: none
  };
  std::array<Of_input, 2> of_pair; ///< options of the source and of the target
  /// Role model to find the upright axes of models that do not give one; null: by stability alone.
  std::shared_ptr<const Role_model> roles;
  /// Called, instead of a progress bar, with the name of the work, the amount done and the total. May throw to end it.
  std::function<void(const std::string&, std::size_t, std::size_t)> on_progress;
  bool quiet = false, verbose = false, help = false, help_all = false;
  int threads = 0; ///< number of threads; 0: as many as the machine has

  Common_options of_input(std::size_t index) const;
  /// The options for reading model files, including the labels of faces that define parts.
  IO::Reading_options reading_options() const;
  /// Whether `parts_from` is a file of labels of faces rather than of pieces.
  bool has_face_labels() const;
  /// The upright direction; y if it is to be estimated.
  Point up_vector() const;
  bool finds_up() const { return up == "auto"; }
  /// Whether to print a table: not if standard output takes the JSON.
  bool prints_table() const { return !quiet && json != "-"; }
};

/// The field of `--output`: files by the endings of their names; `-` is JSON on standard output.
/// \param files an ending, such as `.json`, and the variable that it sets; the setter throws `Usage_error` for others
Text_field output_by_ending(const std::vector<std::pair<std::string, std::string*>>& files);

/// The words of a comma-separated list.
std::vector<std::string> words_of(const std::string& list);

constexpr const char* reading_group = "Options on model files";
constexpr const char* abstraction_group = "Options on part abstraction";
constexpr const char* abstraction_option = "abstraction";

/// Adds the options of all commands.
void add_common_options(Option_table& table, Common_options& options);
/// Adds the options for reading model files: upright axis and parts.
void add_reading_options(Option_table& table, Common_options& options);
/// Adds the options for reading models, abstracting their parts and building their structural graphs.
void add_model_options(Option_table& table, Common_options& options);
/// Adds the options that apply to the source or to the target only.
void add_pair_options(Option_table& table, Common_options& options);

} // namespace CGAL::Shape_correspondence

namespace CGAL::Shape_correspondence::cli {

constexpr const char* match_group = "Options of match";

/// The search methods with their names on the command line.
extern const std::vector<std::pair<const char*, Search_method>> search_methods;

/// The options of the search as given on the command line.
struct Match_options
{
  Search_options search;               ///< its members that options set directly
  std::optional<Search_method> method; ///< empty: selected by other options
  std::string front = "likely";        ///< given, likely or auto
  std::optional<int> alignments;       ///< number of alignments; empty: depends on `front`
  bool paper = false;
  std::string roles = "auto"; ///< auto, none or a file
  std::string examples;       ///< a folder; empty: none
  std::string source_parts, target_parts;
  std::array<std::string, 2> features;        ///< files for the source and the target; empty: none
  std::vector<std::string> pinned, forbidden; ///< pairs of parts, A=B
};

void add_match_options(Option_table& table, Match_options& match);

/// The search options, without those set by `choose_parts()`. \throw Usage_error
Search_options search_options(const Match_options& match, const Option_table& given);

/// Sets the options of graphs implied by `--paper`, unless they are given.
void take_graphs_of_paper(const Match_options& match, const Option_table& given, Structure_options& options);

} // namespace CGAL::Shape_correspondence::cli
