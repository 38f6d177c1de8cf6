// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/jobs.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

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

/// Prints to standard error, when it is destroyed and if `verbose` is set, the time and memory that the command took.
struct Run_report
{
  const Common_options& options;
  double begin = now();

  ~Run_report()
  {
    if (options.verbose)
      std::cerr << "shape_correspondence: " << short_number(now() - begin) << " s, at most "
                << short_number(IO::peak_megabytes()) << " MB\n";
  }
};

/// Help text with paragraphs and list items wrapped to `line_width`; a long command continues after a backslash.
std::string reflowed(const std::string& text)
{
  std::string result, paragraph;
  std::size_t indent = 0; // indentation of a paragraph's lines after the first
  const auto flush = [&] {
    if (paragraph.empty()) return;
    const std::size_t first = paragraph.find_first_not_of(' ');
    const bool is_command = paragraph.find("shape_correspondence ") < paragraph.find_first_of(".,`");
    const std::size_t sign = is_command ? 2 : 0; // width of the backslash that continues a command
    const std::vector<std::string> lines = wrapped(paragraph, line_width - std::max(indent, first) - sign);
    for (std::size_t i = 0; i < lines.size(); ++i)
      result += std::string(i == 0 ? first : indent, ' ') + lines[i] +
                (is_command && i + 1 < lines.size() ? " \\" : "") + '\n';
    paragraph.clear();
  };
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t start = line.find_first_not_of(' ');
    const bool begins = line.empty() || line.rfind("Usage", 0) == 0 || line.rfind("Example", 0) == 0,
               is_item = !line.empty() && line.compare(start, 2, "- ") == 0;
    if (begins || is_item || paragraph.empty() || start != indent || start > 4) {
      flush();
      indent = begins ? 12 : is_item ? start + 2 : start == 0 ? 0 : start + 2;
    }
    if (line.empty())
      result += '\n';
    else
      paragraph += (paragraph.empty() ? "" : " ") + (paragraph.empty() ? line : line.substr(start));
  }
  flush();
  return result;
}

/// The values of the options that have a mark: `Option::is_input` or `Option::is_output`.
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

namespace fs = std::filesystem;

/// Whether two paths are the same file, existing or not.
bool are_same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error)) return fs::equivalent(a, b, error);
  const auto place = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(IO::written_file(path), error), error);
  };
  return a == b || IO::are_same_name(place(a), place(b));
}

/// Checks output files before long work; empty paths are ignored, `-` is standard output.
/// \param inputs files and folders that are read
/// \throw Usage_error if two are the same file, in any spelling, or one is an input; Invalid_input if one is not
/// writable
void check_outputs(const std::vector<std::string>& files, const std::vector<std::string>& inputs)
{
  std::vector<std::string> outputs;
  for (const std::string& file : files) {
    if (file.empty()) continue;
    for (const std::string& other : outputs)
      if (are_same_file(file, other)) throw Usage_error("two outputs are the same file, " + file);
    for (const std::string& input : inputs)
      if (file != "-" && !input.empty() && are_same_file(file, input))
        throw Usage_error("the output " + file + " is an input, too");
    outputs.push_back(file);
    IO::check_writable(file);
  }
}

/// Refuses options of the search when the correspondence is read from a file; only `min-confidence` applies then.
/// \throw Usage_error
void refuse_search_options(const Option_table& given)
{
  for (const Option& option : given.options())
    if (option.is_given && option.group == match_group && option.name != "min-confidence")
      throw Usage_error("the correspondence is given by --match; leave --" + option.name + " out");
}

/// A shape whose parts are chosen by name.
struct Named_parts
{
  const std::string& path;
  std::vector<std::string> names;

  /// The index of the part with this name; the number of parts if there is none.
  std::size_t find(const std::string& name) const
  {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
  }

  std::size_t index(const std::string& name, const std::string& option) const
  {
    if (const std::size_t found = find(name); found < names.size()) return found;
    throw Usage_error("--" + option + ": '" + path + "' has no part '" + name + "'" + suggestion(name, names) +
                      "; `shape_correspondence graph` lists its parts");
  }

  std::vector<std::size_t> indices(const std::string& list, const std::string& option) const
  {
    return mapped(words_of(list), [&](const std::string& name) { return index(name, option); });
  }
};

/// The pair of parts named by the text A=B, where names may contain `=`.
Part_pair pair_of(const std::string& text, const Named_parts& source, const Named_parts& target,
                  const std::string& option)
{
  std::vector<Part_pair> found;
  std::size_t first = text.find('=');
  for (std::size_t at = first; at != std::string::npos; at = text.find('=', at + 1)) {
    const Part_pair pair{source.find(text.substr(0, at)), target.find(text.substr(at + 1))};
    if (pair.source < source.names.size() && pair.target < target.names.size()) found.push_back(pair);
  }
  if (found.size() == 1) return found[0];
  if (found.size() > 1)
    throw Usage_error("--" + option + ": '" + text + "' can be read as several pairs of parts, as names have '='");
  if (first == std::string::npos)
    throw Usage_error("--" + option + " takes a part of the source and a part of the target, A=B, not '" + text + "'");
  return {source.index(text.substr(0, first), option), target.index(text.substr(first + 1), option)};
}

/// Sets the chosen parts, the pinned pairs and the forbidden pairs of `search`.
/// \throw Usage_error if no part has a given name
void choose_parts(const Match_options& match, const Loaded_shape& source, const Loaded_shape& target,
                  Search_options& search)
{
  const Named_parts from{source.path, part_names(source.graph)}, to{target.path, part_names(target.graph)};
  search.source_parts = from.indices(match.source_parts, "source-parts");
  search.target_parts = to.indices(match.target_parts, "target-parts");
  for (const std::string& text : match.pinned)
    search.energy.pinned.push_back(pair_of(text, from, to, "pin"));
  for (const std::string& text : match.forbidden)
    search.energy.forbidden.push_back(pair_of(text, from, to, "forbid"));
  for (const Part_pair& pin : search.energy.pinned)
    for (const Part_pair& other : search.energy.forbidden)
      if (pin.source == other.source && pin.target == other.target)
        throw Usage_error("--pin and --forbid name the same pair, '" + from.names[pin.source] + "' and '" +
                          to.names[pin.target] + "'");
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
  const Run_report report{common};
  start_outputs();
  check();
  check_outputs(output_files(), input_files());
  const std::shared_ptr<void> limit = limit_threads(common.threads);
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

const std::vector<Command_entry>& commands()
{
  static const std::vector<Command_entry> result{
      {"parts", "lists the objects of model files and the parts made of them", parts_command},
      {"graph", "builds the structural graph of a shape", graph_command},
      {"match", "finds the part correspondence of two shapes", match_command},
      {"blend", "makes the in-between shapes of two shapes", blend_command},
#ifndef __EMSCRIPTEN__ // left out of the browser application to keep it small
      {"transfer", "transfers colours, textures or labels from one shape to the other", transfer_command},
      {"collection", "matches all pairs of a set of shapes and analyses the set", collection_command},
      {"evaluate", "scores correspondences against labelled parts", evaluate_command},
      {"roles", "learns the roles of parts from labelled shapes", roles_command},
      {"label", "labels the parts of a shape by their roles", label_command},
      {"demo", "matches and blends two chairs that come with the program", demo_command},
      {"completion", "prints a script that completes commands in bash", completion_command},
      {"help", "prints this text, or all options of a command", help_command},
#endif
  };
  return result;
}

std::unique_ptr<Command> command_of(const std::string& name)
{
  for (const Command_entry& command : commands())
    if (command.name == name) return command.make();
  throw Usage_error("there is no command '" + name + "'" + suggestion(name, mapped(commands(), &Command_entry::name)));
}

void write_help(std::ostream& out)
{
  constexpr int width = 12; // width of the column of commands
  out << program_description;
  for (const Command_entry& command : commands())
    out << "  " << std::left << std::setw(width) << command.name << command.summary << '\n';
  out << program_ending;
}

void Pair_command::add_result_option(Option_table::Group& add)
{
  add("match", "R.json", &result, "read the correspondence from a result that `match --json` wrote for these shapes")
      .input();
}

void Pair_command::add_shared_options()
{
  add_match_options(table, match);
  add_pair_options(table, common);
  add_model_options(table, common);
  add_common_options(table, common);
}

void Pair_command::check()
{
  refuse_abstraction_of_graphs();
  search = search_options(match, table);
  take_graphs_of_paper(match, table, common.structure);
  if (!result.empty()) refuse_search_options(table);
}

void Pair_command::load()
{
  common.roles = search.roles;
  for (std::size_t i = 0; i < 2; ++i)
    common.of_pair[i].features = match.features[i];
  shapes = load_pair(inputs, common, warnings);
  for (const Loaded_shape& shape : shapes)
    append(warnings, about(shape.path, structure(shape.graph).warnings));
  append(warnings, add_examples(match.examples, common, search.roles, search.category));
  choose_parts(match, source(), target(), search);
}

Correspondence Pair_command::correspondence() const
{
  if (result.empty()) return find_correspondence(source().graph, target().graph, search);
  return IO::correspondence_of(IO::read_correspondence_json(result), source().graph, target().graph, result);
}

} // namespace CGAL::Shape_correspondence::cli
