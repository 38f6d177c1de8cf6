// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"

// The commands that a web page has, in place of commands.cpp: the page is to be small

namespace CGAL::Shape_correspondence::cli {

const std::vector<Command_entry>& commands()
{
  static const std::vector<Command_entry> result{
      {"parts", "lists the objects of model files and the parts made of them", parts_command},
      {"graph", "builds the structural graph of a shape", graph_command},
      {"match", "finds the part correspondence of two shapes", match_command},
      {"blend", "makes the in-between shapes of two shapes", blend_command}};
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
