// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Common_options.h"
#include "cli/commands.h"
#include "io/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/version.h>

#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

enum Exit_status { done = 0, unusable_input = 1, bad_usage = 2 };

const char* const help_text =
    R"(Usage: shape_correspondence COMMAND [options] INPUTS...

Finds which parts correspond between segmented shapes of one kind, however different their parts are.

Commands:
  parts       shows what is in model files, and what their parts would be
  graph       builds the structural graph of one shape: curves and sheets, symmetry groups, contacts
  match       finds the part correspondence of two shapes
  blend       makes the shapes in between two shapes, as files or as an animation
  collection  matches all pairs of a set of shapes: energies, the medoid, clusters of parts
  evaluate    scores correspondences against labelled parts
  roles       learns from labelled shapes what parts are for, and tells it of others

Example: shape_correspondence match chair.obj swivel_chair.obj --json result.json --glb result.glb

  shape_correspondence COMMAND --help   tells a command's options
  shape_correspondence --version        tells the version

Exit status: 0 done; 1 an input cannot be used or an output not be written; 2 bad usage.
)";

using Command = void (*)(const std::vector<std::string>&);

Command command_of(const std::string& name)
{
  if (name == "parts") return run_parts;
  if (name == "graph") return run_graph;
  if (name == "match") return run_match;
  if (name == "blend") return run_blend;
  if (name == "collection") return run_collection;
  if (name == "evaluate") return run_evaluate;
  if (name == "roles") return run_roles;
  return nullptr;
}

int complain(const std::string& message, Exit_status status)
{
  std::cerr << "shape_correspondence: " << IO::quote_terminal(message, true) << '\n';
  return status;
}

int run_command(const std::string& name, const std::vector<std::string>& arguments)
{
  const Command command = command_of(name);
  if (!command) return complain("there is no command '" + name + "'; try 'shape_correspondence --help'", bad_usage);
  try {
    command(arguments);
    std::cout.flush();
    return std::cout ? done : complain("standard output: it cannot be written", unusable_input);
  } catch (const Usage_error& error) {
    return complain(name + ": " + error.what() + "; try 'shape_correspondence " + name + " --help'", bad_usage);
  } catch (const Invalid_input& error) {
    return complain(error.what(), unusable_input);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(error.path1().string() + ": it cannot be used (" + error.code().message() +
                        "); check the path and its permissions",
                    unusable_input);
  } catch (const std::bad_alloc&) {
    return complain("the memory is not enough for this input", unusable_input);
  } catch (const std::exception& error) {
    return complain("unexpected error: " + std::string(error.what()), unusable_input);
  }
}

int run(const std::vector<std::string>& arguments)
{
  if (arguments.empty()) {
    std::cerr << help_text;
    return bad_usage;
  }
  if (arguments[0] == "--help" || arguments[0] == "-h")
    std::cout << help_text;
  else if (arguments[0] == "--version")
    std::cout << "shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION "\n";
  else
    return run_command(arguments[0], {arguments.begin() + 1, arguments.end()});
  return done;
}

} // namespace
} // namespace CGAL::Shape_correspondence::cli

int main(int argc, char* argv[])
{
  return CGAL::Shape_correspondence::cli::run(std::vector<std::string>(argv + 1, argv + argc));
}
