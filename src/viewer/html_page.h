// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/colours.h"
#include "io/glb_builder.h"

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A page with a picture of coloured layers, which the mouse turns, and a table. Things are what the mouse points at:
/// it shows their details and lights up their layers and rows.
class Html_page
{
public:
  explicit Html_page(const std::string& title);

  /// A line of text under the title.
  void add_note(const std::string& note);

  /// \param details names and values \return the thing's index
  int add_thing(const std::string& name, const std::vector<std::pair<std::string, std::string>>& details);

  /// \param thing -1: none
  /// \param role layers of one role are shown and hidden together, in the order in which roles come up
  /// \param alpha below 1: see-through
  void add_layer(int thing, const std::string& role, const Drawn_mesh& mesh, const Colour& colour, double alpha,
                 const Point& translation = Point::Zero());

  void set_table_heading(const std::vector<std::string>& cells);
  void add_row(const std::vector<int>& things, const Colour& colour, const std::vector<std::string>& cells);

  void write(std::ostream& out) const;

private:
  Json data_;
};

} // namespace CGAL::Shape_correspondence::IO
