// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/commands.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"text(Usage: shape_correspondence completion bash|zsh

Prints a script with which the shell completes commands and options.

Examples: eval "$(shape_correspondence completion bash)"
          shape_correspondence completion zsh > ~/.zsh/_shape_correspondence

)text";

po::options_description completion_options()
{
  po::options_description result = option_group("Options of completion");
  result.add_options()("help,h", "print this text");
  return result;
}

std::vector<std::string> option_names(const Command& command)
{
  std::vector<std::string> result;
  const po::options_description options = command.help().options;
  for (const auto& option : options.options())
    result.push_back("--" + option->long_name());
  return result;
}

/// Bash completes names of commands and options; for all else its own completion of files stands in.
void write_bash(std::ostream& out)
{
  std::vector<std::string> names;
  for (const Command& command : commands())
    names.push_back(command.name);
  const std::string all = boost::algorithm::join(names, " ");
  out << "# bash completion of shape_correspondence\n"
         "_shape_correspondence()\n{\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    words=\""
      << all
      << " --help --version\"\n"
         "  else\n"
         "    case ${COMP_WORDS[1]} in\n";
  for (const Command& command : commands()) {
    const std::string name = command.name;
    const std::string inputs = name == "help" ? " " + all : name == "completion" ? " bash zsh" : "";
    out << "      " << name << ") words=\"" << boost::algorithm::join(option_names(command), " ") << inputs
        << "\" ;;\n";
  }
  out << "    esac\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _shape_correspondence shape_correspondence\n";
}

/// What zsh shows beside an option: the first clause of its description, without what zsh would expand.
std::string zsh_text(const std::string& description)
{
  std::string result = description.substr(0, description.find_first_of(";:("));
  for (const char* special : {"'", "[", "]", "`"})
    boost::replace_all(result, special, "");
  return result;
}

void write_zsh(std::ostream& out)
{
  out << "#compdef shape_correspondence\n"
         "_shape_correspondence() {\n"
         "  local -a commands\n"
         "  commands=(\n";
  for (const Command& command : commands())
    out << "    '" << command.name << ':' << zsh_text(command.summary) << "'\n";
  out << "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  case $words[2] in\n";
  for (const Command& command : commands()) {
    out << "    " << command.name << ")\n      _arguments -S";
    const po::options_description options = command.help().options;
    for (const auto& option : options.options())
      out << " \\\n        '--" << option->long_name() << '[' << zsh_text(option->description()) << ']'
          << (option->semantic()->max_tokens() > 0 ? ":value:_files" : "") << '\'';
    const std::string name = command.name;
    out << " \\\n        "
        << (name == "help"         ? "'*:command:->commands'"
            : name == "completion" ? "'1:shell:(bash zsh)'"
                                   : "'*:input:_files'")
        << '\n';
    if (name == "help") out << "      _describe command commands\n";
    out << "      ;;\n";
  }
  out << "  esac\n"
         "}\n"
         "if [ \"$funcstack[1]\" = _shape_correspondence ]; then\n" // loaded by its name, not evaluated
         "  _shape_correspondence \"$@\"\n"
         "else\n"
         "  compdef _shape_correspondence shape_correspondence\n"
         "fi\n";
}

} // namespace

Command_help help_of_completion() { return {help_text, completion_options()}; }

void run_completion(const std::vector<std::string>& arguments)
{
  const Arguments parsed = parse(arguments, completion_options(), 1, 1);
  if (parsed.help)
    write_help(std::cout, command_of("completion"));
  else if (parsed.inputs[0] == "bash")
    write_bash(std::cout);
  else if (parsed.inputs[0] == "zsh")
    write_zsh(std::cout);
  else
    throw Usage_error("'" + parsed.inputs[0] + "' is not a shell that it knows; known are: bash, zsh");
}

} // namespace CGAL::Shape_correspondence::cli
