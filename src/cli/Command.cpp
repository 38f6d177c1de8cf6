// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "cli/text.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const program_description = R"(Usage: shape_correspondence COMMAND [options] INPUTS...

Finds which parts of two segmented 3D shapes correspond, also where one part
corresponds to several.

Commands:
)";

const char* const program_ending = R"(
Examples: shape_correspondence demo
          shape_correspondence match chair.obj swivel_chair.obj -o result.html

  shape_correspondence COMMAND --help   prints what a command does, and its usual
                                        options; --help-all prints all
  shape_correspondence --version        prints the version

Exit status: 0 success; 1 an input cannot be used or an output cannot be
written; 2 wrong usage.
)";

/// The values of options that are marked as files.
std::vector<std::string> files_of(const Option_table& table, bool Option::*mark)
{
  std::vector<std::string> result;
  for (const Option& option : table.options())
    if (option.*mark) result.push_back(option.text());
  return result;
}

void check_number(std::size_t inputs, std::size_t least, std::size_t most)
{
  if (inputs >= least && inputs <= most) return;
  throw Usage_error("it takes " + std::to_string(least) +
                    (most == any_number ? " or more"
                     : most > least     ? " or " + std::to_string(most)
                                        : "") +
                    (most == 1 ? " input" : " inputs") + ", not " + std::to_string(inputs));
}

} // namespace

void Command::write_help(std::ostream& out, bool all) const
{
  out << reflowed(text_) << table.help(all);
  const auto rare = std::count_if(table.options().begin(), table.options().end(),
                                  [](const Option& option) { return option.is_rare; });
  if (!all && rare > 0) out << "\n--help-all lists " << rare << " more options.\n";
}

void Command::run(const std::vector<std::string>& arguments)
{
  inputs = table.parse(arguments);
  if (table.help_is_given()) return write_help(std::cout, !table.is_given("help"));
  if (common.quiet && common.verbose) throw Usage_error("--quiet and --verbose do not go together");
  if (std::count(inputs.begin(), inputs.end(), "") > 0) throw Usage_error("the name of an input is empty");
  check_number(inputs.size(), least_, most_);
  const Run_report report(common);
  check();
  check_outputs(output_files(), input_files());
  const Thread_limit limit(common.threads);
  work();
}

std::vector<std::string> Command::output_files() const { return files_of(table, &Option::is_output); }

std::vector<std::string> Command::input_files() const
{
  std::vector<std::string> result = files_of(table, &Option::is_input);
  result.insert(result.end(), inputs.begin(), inputs.end());
  return result;
}

void Command::refuse_abstraction_of_graphs() const
{
  if (!std::all_of(inputs.begin(), inputs.end(), is_graph_file)) return;
  for (const Option& option : table.options())
    if (option.is_given && option.group == abstraction_group)
      refuse_option(option.name, "on structural graphs, which are abstracted already");
}

std::unique_ptr<Command> command_of(const std::string& name)
{
  std::vector<std::string> names;
  for (const Command_entry& command : commands()) {
    if (command.name == name) return command.make();
    names.push_back(command.name);
  }
  throw Usage_error("there is no command '" + name + "'" + suggestion(name, names));
}

void write_help(std::ostream& out)
{
  constexpr int width = 12; // of the column of commands
  out << program_description;
  for (const Command_entry& command : commands())
    out << "  " << std::left << std::setw(width) << command.name << command.summary << '\n';
  out << program_ending;
}

} // namespace CGAL::Shape_correspondence::cli
