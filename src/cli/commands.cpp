// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"

namespace CGAL::Shape_correspondence::cli {

const std::vector<Command_entry>& commands()
{
  static const std::vector<Command_entry> result{
      {"parts", "lists the objects of model files and the parts made of them", parts_command},
      {"graph", "builds the structural graph of a shape", graph_command},
      {"match", "finds the part correspondence of two shapes", match_command},
      {"blend", "makes the in-between shapes of two shapes", blend_command},
#ifndef __EMSCRIPTEN__ // the page for browsers is to be small
      {"transfer", "carries colours, textures or labels from one shape to the other", transfer_command},
      {"collection", "matches all pairs of a set of shapes and analyses the set", collection_command},
      {"evaluate", "scores correspondences against labelled parts", evaluate_command},
      {"roles", "learns the roles of parts from labelled shapes and predicts them", roles_command},
      {"label", "labels the parts of a shape by their roles", label_command},
      {"demo", "matches and blends two chairs that come with the program", demo_command},
      {"completion", "prints a script that completes commands in bash, zsh or fish", completion_command},
      {"help", "prints this text, or all options of a command", help_command},
#endif
  };
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
