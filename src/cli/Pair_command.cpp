// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Pair_command.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

namespace CGAL::Shape_correspondence::cli {

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
  for (const std::string& warning : warnings_of(inputs, shapes))
    warnings.push_back(warning);
  for (const std::string& left_out : add_examples(match, common, search))
    warnings.push_back(left_out);
  choose_parts(match, source().graph, target().graph, inputs, search);
}

Correspondence Pair_command::correspondence() const
{
  if (result.empty()) return find_correspondence(source().graph, target().graph, search);
  return IO::correspondence_of(IO::read_correspondence_json(result), source().graph, target().graph, result);
}

} // namespace CGAL::Shape_correspondence::cli
