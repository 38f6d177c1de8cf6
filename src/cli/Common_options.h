// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/detect_symmetry_groups.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {
class Role_model;
}

namespace CGAL::Shape_correspondence::cli {

/// The command line is not one that the program understands: exit status 2.
class Usage_error : public std::runtime_error
{
public:
  explicit Usage_error(const std::string& message) : std::runtime_error(message) {}
};

/// What every command knows.
struct Common_options
{
  std::string json;              ///< empty: none
  std::string glb;               ///< empty: none
  std::string html;              ///< empty: none
  std::string cache;             ///< empty: none
  std::string up;                ///< x, y, z or auto; empty: what the file says, or a guess that favours y
  std::string progress = "auto"; ///< auto, always or never
  bool no_symmetry = false;
  double symmetry_tolerance = 0.05;
  std::string symmetries = "reflection,rotation,translation";
  double contact_tolerance = 0.02;
  std::string parts = "auto"; ///< auto, file, components or segments
  std::string parts_from;     ///< a file that says which piece is in which part; empty: none
  IO::Reading_options reading;
  struct Of_input
  {
    std::string up, parts_from; ///< empty: those of all inputs
  };
  std::array<Of_input, 2> of_pair; ///< of the source and the target
  /// By which the upright axes of models are found where nothing says them; null: by how the models stand.
  std::shared_ptr<const Role_model> roles;
  Abstraction_options abstraction;
  /// Told of the progress in place of a bar: what is done, how much of it, of how much. It may throw, which ends the
  /// work.
  std::function<void(const std::string&, std::size_t, std::size_t)> on_progress;
  bool graphs_suffice = false; ///< shapes may be loaded without their models, where the cache has their graphs
  bool quiet = false;
  bool verbose = false;
  int threads = 0; ///< 0: all
  long seed = 0;

  /// The options for one input of several.
  Common_options of_input(std::size_t index) const;
  /// The upright direction; y where it is to be found.
  Point up_vector() const;
  bool finds_up() const { return up == "auto"; }
  Symmetry_options symmetry_options() const;
  /// Whether a table belongs on standard output: not where the JSON goes.
  bool prints_table() const { return !quiet && json != "-"; }
};

/// The words of a list with commas in between.
std::vector<std::string> words_of(const std::string& list);

/// Checks the values of common options but for the outputs. \throw Usage_error
void check(const Common_options& options);

/// Throws `Usage_error` if `value` is none of `known`.
void check_word(const std::string& option, const std::string& value, const std::vector<std::string>& known);

/// Throws `Usage_error` if `value` is less than `least`.
void check_at_least(const std::string& option, int value, int least);

/// Throws `Usage_error` if `value` is less than `least` or more than `most`.
void check_from_to(const std::string& option, int value, int least, int most);

} // namespace CGAL::Shape_correspondence::cli
