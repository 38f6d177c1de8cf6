// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/match_table.h"
#include "cli/text_table.h"
#include "io/quoting.h"

#include <algorithm>
#include <ostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

using Rows = std::vector<std::vector<std::string>>;

bool contains(const std::vector<std::size_t>& parts, std::size_t part)
{
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

std::string names(const std::vector<std::size_t>& parts, const Structural_graph& graph)
{
  std::vector<std::string> result;
  for (std::size_t part : parts)
    result.push_back(structure(graph).parts[part].name);
  return IO::quote_terminal(listed(result));
}

/// The pairs of one group of the deformed shape; operation and energy stand in the first line.
void add_rows(const Group_match& group, const Correspondence& correspondence, const Structural_graph& source,
              const Structural_graph& target, Rows& rows)
{
  const auto role = [&](const Part_correspondence& pair) {
    return correspondence.source_roles.empty() ? "" : correspondence.source_roles[pair.source];
  };
  std::string operation = name_of(group.operation), energy = short_number(group.energy);
  for (const Part_correspondence& pair : correspondence.pairs) {
    if (!contains(group.source, pair.source) || !contains(group.target, pair.target)) continue;
    rows.push_back({structure(source).parts[pair.source].name, structure(target).parts[pair.target].name, operation,
                    energy, role(pair)});
    operation = energy = "";
  }
  if (!operation.empty()) rows.push_back({names(group.source, source), names(group.target, target), "-", energy, ""});
}

} // namespace

void write_match_table(std::ostream& out, const Correspondence& c, const Structural_graph& source,
                       const Structural_graph& target)
{
  Rows rows{{"source", "target", "operation", "energy", c.category.empty() ? "" : "role in a " + c.category}};
  for (const Group_match& group : c.groups)
    add_rows(group, c, source, target, rows);
  if (c.category.empty())
    for (std::vector<std::string>& row : rows)
      row.pop_back();
  write_table(out, rows);
  out << "\nunmatched in the source: " << names(c.unmatched_source, source)
      << "\nunmatched in the target: " << names(c.unmatched_target, target) << "\nenergy: " << short_number(c.energy)
      << " (distortion " << short_number(c.terms.distortion) << ", connectedness "
      << short_number(c.terms.connectedness) << ", split " << short_number(c.terms.split) << "), the "
      << (c.direction == Direction::SOURCE_TO_TARGET ? "source deformed into the target"
                                                     : "target deformed into the source")
      << (c.complete ? "" : ", incomplete") << (c.optimal ? ", proven minimal for this direction" : "") << '\n';
  for (const std::string& warning : c.warnings)
    out << "warning: " << IO::quote_terminal(warning) << '\n';
}

} // namespace CGAL::Shape_correspondence::cli
