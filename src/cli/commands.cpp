// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/commands.h"
#include "cli/Common_options.h"
#include "cli/suggestion.h"

#include <iomanip>
#include <ostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const description = R"(Usage: shape_correspondence COMMAND [options] INPUTS...

Finds which parts of two segmented 3D shapes correspond, also where one part corresponds to several.

Commands:
)";

const char* const ending = R"(
Examples: shape_correspondence demo
          shape_correspondence match chair.obj swivel_chair.obj --json result.json --html result.html

  shape_correspondence help COMMAND   prints the options of a command; so does COMMAND --help
  shape_correspondence --version      prints the version

Exit status: 0 success; 1 an input cannot be used or an output cannot be written; 2 wrong usage.
)";

} // namespace

const std::vector<Command>& commands()
{
  static const std::vector<Command> result{
      {"parts", "lists the objects of model files and the parts made of them", run_parts, help_of_parts},
      {"graph", "builds the structural graph of a shape", run_graph, help_of_graph},
      {"match", "finds the part correspondence of two shapes", run_match, help_of_match},
      {"blend", "makes the in-between shapes of two shapes", run_blend, help_of_blend},
      {"transfer", "carries colours, textures or labels from one shape to the other", run_transfer, help_of_transfer},
      {"collection", "matches all pairs of a set of shapes and analyses the set", run_collection, help_of_collection},
      {"evaluate", "scores correspondences against labelled parts", run_evaluate, help_of_evaluate},
      {"roles", "learns the roles of parts from labelled shapes and predicts them", run_roles, help_of_roles},
      {"label", "labels the parts of a shape by their roles", run_label, help_of_label},
      {"demo", "matches and blends two chairs that come with the program", run_demo, help_of_demo},
      {"completion", "prints a script that completes commands and options in bash or zsh", run_completion,
       help_of_completion},
      {"help", "prints this text, or the options of a command", run_help, help_of_help}};
  return result;
}

const Command& command_of(const std::string& name)
{
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    if (command.name == name) return command;
    names.push_back(command.name);
  }
  throw Usage_error("there is no command '" + name + "'" + suggestion(name, names));
}

void write_help(std::ostream& out)
{
  constexpr int width = 12; // of the column of commands
  out << description;
  for (const Command& command : commands())
    out << "  " << std::left << std::setw(width) << command.name << command.summary << '\n';
  out << ending;
}

void write_help(std::ostream& out, const Command& command)
{
  const Command_help help = command.help();
  out << help.text << help.options;
}

} // namespace CGAL::Shape_correspondence::cli
