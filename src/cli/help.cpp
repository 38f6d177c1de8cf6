// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/manual_page.h"

#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence help [COMMAND]
       shape_correspondence help --man

Prints what the program does, or what a command does and all its options.

)";

po::options_description help_options(bool& as_manual_page)
{
  po::options_description result = option_group("Options of help");
  result.add_options()("man", po::bool_switch(&as_manual_page),
                       "print the help of all commands as a manual page, for man(1)")("help,h", "print this text");
  return result;
}

} // namespace

Command_help help_of_help()
{
  static bool unused;
  return {help_text, help_options(unused)};
}

void run_help(const std::vector<std::string>& arguments)
{
  bool as_manual_page = false;
  const Arguments parsed = parse(arguments, help_options(as_manual_page), 0, 1);
  if (parsed.help)
    write_help(std::cout, command_of("help"));
  else if (as_manual_page && !parsed.inputs.empty())
    throw Usage_error("--man is the manual page of all commands; it takes no command");
  else if (as_manual_page)
    write_manual_page(std::cout);
  else if (parsed.inputs.empty())
    write_help(std::cout);
  else
    write_help(std::cout, command_of(parsed.inputs[0]));
}

} // namespace CGAL::Shape_correspondence::cli
