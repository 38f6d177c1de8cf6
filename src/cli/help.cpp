// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/text.h"

#include <CGAL/Shape_correspondence/version.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <iostream>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// A line of text as troff shows it unchanged.
std::string escaped(std::string line)
{
  boost::replace_all(line, "\\", "\\e");
  boost::replace_all(line, "-", "\\-");
  if (!line.empty() && (line[0] == '.' || line[0] == '\'')) line = "\\&" + line; // else a request
  return line;
}

/// A text with its lines and indentation kept.
void write_as_it_is(std::ostream& out, const std::string& text)
{
  out << ".nf\n";
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    out << escaped(line) << '\n';
  out << ".fi\n";
}

/// The help of all commands as troff.
void write_manual_page(std::ostream& out)
{
  out << ".TH SHAPE_CORRESPONDENCE 1 \"\" \"shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION "\"\n"
      << ".SH NAME\nshape_correspondence \\- part correspondences of segmented 3D shapes\n.SH SYNOPSIS\n";
  std::ostringstream help;
  write_help(help);
  write_as_it_is(out, help.str());
  for (const Command_entry& command : commands()) {
    out << ".SH " << boost::to_upper_copy(command.name) << '\n';
    std::ostringstream text;
    command.make()->write_help(text, true);
    write_as_it_is(out, text.str());
  }
}

class Help_command : public Command
{
public:
  Help_command()
      : Command(R"(Usage: shape_correspondence help [COMMAND]
       shape_correspondence help --man

Prints what the program does, or what a command does and all its options.

)",
                0, 1)
  {
    Option_table::Group add = table.group("Options of help");
    add("man", &as_manual_page_, "print the help of all commands as a manual page, for man(1)");
    add("help,h", &common.help, "print this text");
  }

private:
  void work() override
  {
    if (as_manual_page_ && !inputs.empty())
      throw Usage_error("--man is the manual page of all commands; it takes no command");
    if (as_manual_page_)
      write_manual_page(std::cout);
    else if (inputs.empty())
      cli::write_help(std::cout);
    else
      command_of(inputs[0])->write_help(std::cout, true);
  }

  bool as_manual_page_ = false;
};

std::string names_of_commands() { return boost::algorithm::join(mapped(commands(), &Command_entry::name), " "); }

/// The inputs of a command that are words.
std::string words_of_inputs(const std::string& command)
{
  return command == "help"         ? names_of_commands()
         : command == "completion" ? "bash zsh fish"
         : command == "roles"      ? "train evaluate predict"
                                   : "";
}

/// Bash completes names of commands and options, and values that are words; for all else its own completion of files
/// stands in.
void write_bash(std::ostream& out)
{
  out << "# bash completion of shape_correspondence\n"
         "_shape_correspondence()\n{\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} words=\n"
         "  if [ \"$word\" = = ]; then\n" // --option=VALUE is three words
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

/// What zsh shows beside an option: the first clause of its description, without what zsh would expand.
std::string zsh_text(const std::string& description)
{
  std::string result = description.substr(0, description.find_first_of(";:("));
  for (const char* special : {"'", "[", "]", "`"})
    boost::replace_all(result, special, "");
  return result;
}

/// How zsh completes a value.
std::string zsh_value(const Option& option)
{
  if (option.is_switch()) return "";
  return ":" + option.value_name + ":" +
         (option.known.empty() ? "_files" : "(" + boost::algorithm::join(option.known, " ") + ")");
}

void write_zsh(std::ostream& out)
{
  out << "#compdef shape_correspondence\n"
         "_shape_correspondence() {\n"
         "  local -a commands\n"
         "  commands=(\n";
  for (const Command_entry& command : commands())
    out << "    '" << command.name << ':' << zsh_text(command.summary) << "'\n";
  out << "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  local command=$words[2]\n"
         "  shift words\n" // so that the first input is number 1
         "  (( CURRENT-- ))\n"
         "  case $command in\n";
  for (const Command_entry& command : commands()) {
    out << "    " << command.name << ")\n      _arguments -S";
    const std::unique_ptr<Command> made = command.make();
    for (const Option& option : made->options().options())
      out << " \\\n        '--" << option.name << '[' << zsh_text(option.help) << ']' << zsh_value(option) << '\'';
    const std::string words = words_of_inputs(command.name);
    out << " \\\n        " << (words.empty() ? "" : "'1:word:(" + words + ")' ") << "'*:input:_files'\n      ;;\n";
  }
  out << "  esac\n"
         "}\n"
         "if [ \"$funcstack[1]\" = _shape_correspondence ]; then\n" // loaded by its name, not evaluated
         "  _shape_correspondence \"$@\"\n"
         "else\n"
         "  compdef _shape_correspondence shape_correspondence\n"
         "fi\n";
}

/// What fish shows beside a command or an option. \return quoted
std::string fish_text(const std::string& description) { return "'" + zsh_text(description) + "'"; }

void write_fish(std::ostream& out)
{
  const std::string complete = "complete -c shape_correspondence -n ";
  for (const Command_entry& command : commands()) {
    out << complete << "__fish_use_subcommand -f -a " << command.name << " -d " << fish_text(command.summary) << '\n';
    const std::string of_command = complete + "'__fish_seen_subcommand_from " + command.name + "'";
    if (const std::string words = words_of_inputs(command.name); !words.empty())
      out << of_command << " -f -a '" << words << "'\n";
    const std::unique_ptr<Command> made = command.make();
    for (const Option& option : made->options().options()) {
      out << of_command << " -l " << option.name;
      if (!option.short_name.empty()) out << " -s " << option.short_name;
      if (!option.known.empty())
        out << " -x -a '" << boost::algorithm::join(option.known, " ") << "'";
      else if (!option.is_switch())
        out << " -r";
      out << " -d " << fish_text(option.help) << '\n';
    }
  }
}

class Completion_command : public Command
{
public:
  Completion_command()
      : Command(R"text(Usage: shape_correspondence completion bash|zsh|fish

Prints a script with which the shell completes commands, options and their values.

Examples: eval "$(shape_correspondence completion bash)"
          shape_correspondence completion zsh > ~/.zsh/_shape_correspondence
          shape_correspondence completion fish | source

)text",
                1, 1)
  {
    table.group("Options of completion")("help,h", &common.help, "print this text");
  }

private:
  void work() override
  {
    if (inputs[0] == "bash")
      write_bash(std::cout);
    else if (inputs[0] == "zsh")
      write_zsh(std::cout);
    else if (inputs[0] == "fish")
      write_fish(std::cout);
    else
      throw Usage_error("'" + inputs[0] + "' is not a shell that it knows; known are: bash, zsh, fish");
  }
};

} // namespace

std::unique_ptr<Command> help_command() { return std::make_unique<Help_command>(); }

std::unique_ptr<Command> completion_command() { return std::make_unique<Completion_command>(); }

} // namespace CGAL::Shape_correspondence::cli
