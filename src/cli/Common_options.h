// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Option_table.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {
class Role_model;
}

namespace CGAL::Shape_correspondence::cli {

/// What every command knows.
struct Common_options
{
  std::string json, glb, html;   ///< files to write; empty: none
  std::string cache;             ///< folder of graphs; empty: none
  std::string up;                ///< x, -x, +x etc., or auto; empty: what the file says, or a guess that favours y
  std::string progress = "auto"; ///< auto, always or never
  Part_splitting parts = Part_splitting::AUTO;
  std::string parts_from; ///< a file that says which piece is in which part, or has labels of faces; empty: none
  IO::Reading_options reading;
  Structure_options structure;
  struct Of_input
  {
    std::string up, parts_from; ///< empty: the value for all inputs
  };
  std::array<Of_input, 2> of_pair; ///< of the source and the target
  /// By which the upright axes of models are found where nothing says them; null: by how the models stand.
  std::shared_ptr<const Role_model> roles;
  /// Called with the progress in place of a bar: what is done, how much of it, of how much. It may throw, which ends
  /// the work.
  std::function<void(const std::string&, std::size_t, std::size_t)> on_progress;
  bool quiet = false, verbose = false, help = false, help_all = false;
  int threads = 0; ///< 0: all
  std::int64_t seed = 0;

  /// The options for one input of several.
  Common_options of_input(std::size_t index) const;
  /// How model files are read, with the labels of faces that make parts.
  IO::Reading_options reading_options() const;
  /// Whether `parts_from` has labels of faces, not pieces.
  bool has_face_labels() const;
  /// The upright direction; y where it is to be found.
  Point up_vector() const;
  bool finds_up() const { return up == "auto"; }
  /// Whether a table belongs on standard output: not where the JSON goes.
  bool prints_table() const { return !quiet && json != "-"; }
};

/// Files by the endings of their names, for an option `--output`; `-` is JSON on standard output.
/// \param files an ending, such as `.json`, and the file that it sets \throw Usage_error by its setter, for other endings
Text_field output_by_ending(const std::vector<std::pair<std::string, std::string*>>& files);

/// The words of a list with commas in between.
std::vector<std::string> words_of(const std::string& list);

constexpr const char* reading_group = "Options on model files";
constexpr const char* abstraction_group = "Options on part abstraction";
constexpr const char* abstraction_option = "abstraction";

// Each adds options to the table of a command

/// The options of all commands.
void add_common_options(Option_table& table, Common_options& options);
/// How model files are read: the upright axis and the parts.
void add_reading_options(Option_table& table, Common_options& options);
/// How models are read, their parts abstracted, and their structural graphs built.
void add_model_options(Option_table& table, Common_options& options);
/// The options of the source alone and of the target alone.
void add_pair_options(Option_table& table, Common_options& options);

} // namespace CGAL::Shape_correspondence::cli
