// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Pair_command.h"
#include "cli/labels.h"
#include "cli/text.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>

namespace CGAL::Shape_correspondence::cli {

namespace {

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

/// The pair named by A=B, where names may contain `=`.
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
    search.matching.pinned.push_back(pair_of(text, from, to, "pin"));
  for (const std::string& text : match.forbidden)
    search.matching.forbidden.push_back(pair_of(text, from, to, "forbid"));
  for (const Part_pair& pin : search.matching.pinned)
    for (const Part_pair& other : search.matching.forbidden)
      if (pin.source == other.source && pin.target == other.target)
        throw Usage_error("--pin and --forbid name the same pair, '" + from.names[pin.source] + "' and '" +
                          to.names[pin.target] + "'");
}

} // namespace

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
