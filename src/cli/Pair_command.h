// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Command.h"
#include "cli/Match_options.h"
#include "cli/load_shape.h"

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

class Pair_command : public Command
{
protected:
  explicit Pair_command(const char* text) : Command(text, 2, 2) {}

  /// Adds the option for reading the correspondence from a file.
  void add_result_option(Option_table::Group& add);
  /// Adds the options for the match and the shapes, after those of the specific command.
  void add_shared_options();

  void check() override;

  /// Loads the shapes, and resolves the parts named by options.
  void load();
  /// The correspondence, read or computed.
  Correspondence correspondence() const;

  const Loaded_shape& source() const { return shapes[0]; }
  const Loaded_shape& target() const { return shapes[1]; }

  Match_options match;
  std::string result; ///< result file of `match --json`; empty: the correspondence is computed
  Search_options search;
  std::vector<Loaded_shape> shapes;
  std::vector<std::string> warnings; ///< about the shapes and examples
};

} // namespace CGAL::Shape_correspondence::cli
