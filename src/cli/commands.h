// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <boost/program_options.hpp>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// What the help, the manual page and the completion tell of a command.
struct Command_help
{
  const char* text; ///< usage, description and examples
  boost::program_options::options_description options;
};

/// A command of the program. `run` throws `Usage_error` and `Invalid_input`.
struct Command
{
  const char* name;
  const char* summary; ///< in one line
  void (*run)(const std::vector<std::string>& arguments);
  Command_help (*help)();
};

/// All commands, in the order in which they are listed.
const std::vector<Command>& commands();

/// The command of a name. \throw Usage_error if there is none; it suggests one that is spelt alike
const Command& command_of(const std::string& name);

/// Writes the help of the program, and of a command.
void write_help(std::ostream& out);
void write_help(std::ostream& out, const Command& command);

// The functions of the table, one source each
void run_parts(const std::vector<std::string>& arguments);
void run_graph(const std::vector<std::string>& arguments);
void run_match(const std::vector<std::string>& arguments);
void run_blend(const std::vector<std::string>& arguments);
void run_transfer(const std::vector<std::string>& arguments);
void run_collection(const std::vector<std::string>& arguments);
void run_evaluate(const std::vector<std::string>& arguments);
void run_roles(const std::vector<std::string>& arguments);
void run_label(const std::vector<std::string>& arguments);
void run_demo(const std::vector<std::string>& arguments);
void run_completion(const std::vector<std::string>& arguments);
void run_help(const std::vector<std::string>& arguments);
Command_help help_of_parts();
Command_help help_of_graph();
Command_help help_of_match();
Command_help help_of_blend();
Command_help help_of_transfer();
Command_help help_of_collection();
Command_help help_of_evaluate();
Command_help help_of_roles();
Command_help help_of_label();
Command_help help_of_demo();
Command_help help_of_completion();
Command_help help_of_help();

} // namespace CGAL::Shape_correspondence::cli
