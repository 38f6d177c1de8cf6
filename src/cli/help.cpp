// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/run.h"

#include <boost/algorithm/string/join.hpp>

#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

class Help_command : public Command
{
public:
  Help_command()
      : Command(R"(Usage: shape_correspondence help [COMMAND]

Prints what the program does, or what a command does and all its options.

)",
                0, 1)
  {
    table.group("Options of help")("help,h", &common.help, "print this text");
  }

private:
  void work() override
  {
    if (inputs.empty())
      cli::write_help(std::cout);
    else
      command_of(inputs[0])->write_help(std::cout, true);
  }
};

std::string names_of_commands() { return boost::algorithm::join(mapped(commands(), &Command_entry::name), " "); }

/// The words that a command takes as inputs; empty if it takes files.
std::string words_of_inputs(const std::string& command)
{
  return command == "help" ? names_of_commands() : command == "completion" ? "bash" : command == "roles" ? "train" : "";
}

/// Writes completion for Bash: of commands, options and values from lists of words; for the rest, Bash completes files.
void write_bash(std::ostream& out)
{
  out << "# bash completion of shape_correspondence\n"
         "_shape_correspondence()\n{\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
         "  if [ \"$word\" = = ]; then\n" // Bash splits --option=VALUE into three words
         "    word=\n"
         "  elif [ \"$before\" = = ]; then\n"
         "    before=${COMP_WORDS[COMP_CWORD-2]}\n"
         "  fi\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    words=\""
      << names_of_commands()
      << " --help --version\"\n"
         "  else\n"
         "    case ${COMP_WORDS[1]} in\n";
  for (const Command_entry& command : commands()) {
    const std::unique_ptr<Command> made = command.make();
    out << "      " << command.name << ") words=\"" << words_of_inputs(command.name);
    for (const Option& option : made->options().options())
      out << " --" << option.name;
    out << "\"\n        case $before in\n";
    for (const Option& option : made->options().options())
      if (!option.is_switch())
        out << "          --" << option.name << (option.short_name.empty() ? "" : "|-" + option.short_name)
            << ") words=\"" << boost::algorithm::join(option.known, " ") << "\" ;;\n";
    out << "        esac ;;\n";
  }
  out << "    esac\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _shape_correspondence shape_correspondence\n";
}

class Completion_command : public Command
{
public:
  Completion_command()
      : Command(R"text(Usage: shape_correspondence completion bash

Prints a script with which bash completes commands, options and their values.

Example: eval "$(shape_correspondence completion bash)"

)text",
                1, 1)
  {
    table.group("Options of completion")("help,h", &common.help, "print this text");
  }

private:
  void work() override
  {
    if (inputs[0] != "bash") throw Usage_error("'" + inputs[0] + "' is not a shell that it knows; known is: bash");
    write_bash(std::cout);
  }
};

} // namespace

std::unique_ptr<Command> help_command() { return std::make_unique<Help_command>(); }

std::unique_ptr<Command> completion_command() { return std::make_unique<Completion_command>(); }

} // namespace CGAL::Shape_correspondence::cli
