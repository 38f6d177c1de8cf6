// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/choose_parts.h"
#include "cli/command_line.h"
#include "cli/suggestion.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::cli {

namespace {

std::vector<std::string> names_of_parts(const Structural_graph& graph)
{
  std::vector<std::string> result;
  for (const Part_abstraction& part : structure(graph).parts)
    result.push_back(part.name);
  return result;
}

/// The index of the part of a name, or the number of parts.
std::size_t index_of(const std::string& name, const std::vector<std::string>& names)
{
  return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
}

std::size_t part_of(const std::string& name, const Named_graph& shape, const std::string& option)
{
  const std::vector<std::string> names = names_of_parts(shape.graph);
  const std::size_t index = index_of(name, names);
  if (index == names.size())
    throw Usage_error("--" + option + ": '" + shape.path + "' has no part '" + name + "'" + suggestion(name, names) +
                      "; `shape_correspondence graph` lists its parts");
  return index;
}

std::vector<std::size_t> parts_of(const std::string& list, const Named_graph& shape, const std::string& option)
{
  std::vector<std::size_t> result;
  for (const std::string& name : words_of(list))
    result.push_back(part_of(name, shape, option));
  return result;
}

/// The pair that A=B names, where names may have = themselves.
Part_pair pair_of(const std::string& text, const Named_graph& source, const Named_graph& target,
                  const std::string& option)
{
  const std::vector<std::string> from = names_of_parts(source.graph), to = names_of_parts(target.graph);
  std::vector<Part_pair> found;
  std::size_t first = text.find('=');
  for (std::size_t at = first; at != std::string::npos; at = text.find('=', at + 1)) {
    const Part_pair pair{index_of(text.substr(0, at), from), index_of(text.substr(at + 1), to)};
    if (pair.source < from.size() && pair.target < to.size()) found.push_back(pair);
  }
  if (found.size() == 1) return found[0];
  if (found.size() > 1)
    throw Usage_error("--" + option + ": '" + text + "' can be read as several pairs of parts, as names have '='");
  if (first == std::string::npos)
    throw Usage_error("--" + option + " takes a part of the source and a part of the target, A=B, not '" + text + "'");
  return {part_of(text.substr(0, first), source, option), part_of(text.substr(first + 1), target, option)};
}

std::vector<Part_pair> pairs_of(const std::vector<std::string>& texts, const Named_graph& source,
                                const Named_graph& target, const std::string& option)
{
  std::vector<Part_pair> result;
  for (const std::string& text : texts)
    result.push_back(pair_of(text, source, target, option));
  return result;
}

} // namespace

void choose_parts(const Match_options& match, const Named_graph& source, const Named_graph& target,
                  Search_options& search)
{
  search.source_parts = parts_of(match.source_parts, source, "source-parts");
  search.target_parts = parts_of(match.target_parts, target, "target-parts");
  search.matching.pinned = pairs_of(match.pinned, source, target, "pin");
  search.matching.forbidden = pairs_of(match.forbidden, source, target, "forbid");
  for (const Part_pair& pin : search.matching.pinned)
    for (const Part_pair& other : search.matching.forbidden)
      if (pin.source == other.source && pin.target == other.target)
        throw Usage_error("--pin and --forbid name the same pair, '" + structure(source.graph).parts[pin.source].name +
                          "' and '" + structure(target.graph).parts[pin.target].name + "'");
}

} // namespace CGAL::Shape_correspondence::cli
