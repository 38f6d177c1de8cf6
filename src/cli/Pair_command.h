// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Command.h"
#include "cli/Match_options.h"
#include "cli/load_shape.h"

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A command on two shapes and their correspondence.
class Pair_command : public Command
{
protected:
  explicit Pair_command(const char* text) : Command(text, 2, 2) {}

  /// An option for the correspondence to be read.
  void add_result_option(Option_table::Group& add);
  /// The options on the match and the shapes, after those of the command alone.
  void add_shared_options();

  void check() override;

  /// Loads the shapes, and looks up what options name in them.
  void load();
  /// The correspondence that is read or found.
  Correspondence correspondence() const;

  const Loaded_shape& source() const { return shapes[0]; }
  const Loaded_shape& target() const { return shapes[1]; }

  Match_options match;
  std::string result; ///< a file of `match --json`; empty: the correspondence is searched for
  Search_options search;
  std::vector<Loaded_shape> shapes;
  std::vector<std::string> warnings; ///< of the shapes and examples
};

} // namespace CGAL::Shape_correspondence::cli
