// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/match_shapes.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>

namespace CGAL::Shape_correspondence::cli {
namespace {

using Rows = std::vector<std::vector<std::string>>;
using Parts = std::vector<std::size_t>;

constexpr std::size_t column_width = 36; // characters of a column of part names

std::vector<std::string> names(const Parts& parts, const Structural_graph& graph)
{
  std::vector<std::string> result;
  for (std::size_t part : parts)
    result.push_back(structure(graph).parts[part].name);
  return result;
}

/// Names with commas in between, in lines of limited length.
std::vector<std::string> lines_of(const Parts& parts, const Structural_graph& graph)
{
  std::vector<std::string> lines{""};
  for (const std::string& name : names(parts, graph)) {
    if (!lines.back().empty() && lines.back().size() + 2 + name.size() > column_width) {
      lines.back() += ',';
      lines.emplace_back();
    }
    lines.back() += (lines.back().empty() ? "" : ", ") + name;
  }
  return lines;
}

/// Source parts that correspond to the same target parts.
struct Block
{
  Parts source, target;
  Parts merged; ///< all source parts that correspond to any of these target parts
  bool is_cut = false, is_joined = false;
  double lowest = 1, highest = 0; ///< confidence
};

/// Sorted by source.
std::vector<Block> blocks_of(const Correspondence& correspondence)
{
  std::map<std::size_t, Parts> targets_of;
  std::map<std::size_t, std::set<std::size_t>> sources_of;
  for (const Part_correspondence& pair : correspondence.pairs) {
    Parts& targets = targets_of[pair.source];
    if (targets.empty() || targets.back() != pair.target) targets.push_back(pair.target);
    sources_of[pair.target].insert(pair.source);
  }
  std::vector<Block> blocks;
  std::map<Parts, std::size_t> block_of;
  for (const auto& [source, targets] : targets_of) {
    const auto [entry, is_new] = block_of.emplace(targets, blocks.size());
    if (is_new) {
      blocks.emplace_back();
      blocks.back().target = targets;
    }
    blocks[entry->second].source.push_back(source);
  }
  for (Block& block : blocks) {
    std::set<std::size_t> merged;
    for (std::size_t target : block.target)
      merged.insert(sources_of[target].begin(), sources_of[target].end());
    block.merged.assign(merged.begin(), merged.end());
  }
  for (const Part_correspondence& pair : correspondence.pairs) {
    Block& block = blocks[block_of[targets_of[pair.source]]];
    block.is_cut |= !pair.source_segment.is_whole_part();
    block.is_joined |= !pair.target_segment.is_whole_part();
    block.lowest = std::min(block.lowest, pair.confidence);
    block.highest = std::max(block.highest, pair.confidence);
  }
  return blocks;
}

/// The operation by which the source parts become the target parts.
Operation operation_of(const Block& block)
{
  const std::size_t sources = block.merged.size(), targets = block.target.size();
  if (block.is_cut) return Operation::CUT;
  if (block.is_joined) return Operation::JOIN;
  if (sources == targets) return Operation::MATCH;
  if (sources > targets) return Operation::MERGE;
  return sources == 1 ? Operation::SPLIT : Operation::DUPLICATE;
}

std::string operation_text(const Block& block)
{
  const std::string name = name_of(operation_of(block));
  if (block.merged.size() == 1 && block.target.size() == 1) return name;
  return name + " " + std::to_string(block.merged.size()) + ":" + std::to_string(block.target.size());
}

std::string confidence_text(const Block& block)
{
  const std::string lowest = percentage(block.lowest), highest = percentage(block.highest);
  return lowest == highest ? lowest : lowest.substr(0, lowest.find(' ')) + " to " + highest;
}

/// The roles of the source parts, each once.
std::string roles_text(const Block& block, const std::vector<std::string>& roles)
{
  std::set<std::string> result;
  for (std::size_t part : block.source)
    result.insert(roles[part]);
  return listed({result.begin(), result.end()});
}

/// A row for people, several lines where the names are many.
void add_rows(const Parts& from, const Parts& to, std::vector<std::string> others, const Structural_graph& source,
              const Structural_graph& target, Rows& rows)
{
  const std::vector<std::string> left = lines_of(from, source), right = lines_of(to, target);
  for (std::size_t line = 0; line < std::max(left.size(), right.size()); ++line) {
    std::vector<std::string> row{line < left.size() ? left[line] : "", line < right.size() ? right[line] : ""};
    row.insert(row.end(), others.begin(), others.end());
    rows.push_back(std::move(row));
    others.assign(others.size(), "");
  }
}

std::string with_article(const std::string& noun)
{
  const bool begins_with_vowel = std::string("aeiou").find(noun[0]) != std::string::npos;
  return (begins_with_vowel ? "an " : "a ") + noun;
}

} // namespace

Matched_shapes match_shapes(const Loaded_shape& source, const Loaded_shape& target, const Search_options& options)
{
  const Prepared_shape prepared_source(source.graph), prepared_target(target.graph);
  const double begin_roles = now();
  for (const Prepared_shape* shape : {&prepared_source, &prepared_target})
    shape->read_roles(options.roles);
  const double begin = now();
  Matched_shapes result{Correspondence_finder(prepared_source, options).ranked(prepared_target), {}};
  result.seconds = {source.read_seconds + target.read_seconds, source.abstraction_seconds + target.abstraction_seconds,
                    source.structure_seconds + target.structure_seconds + begin - begin_roles, now() - begin};
  return result;
}

void write_match_table(std::ostream& out, const Correspondence& c, const Structural_graph& source,
                       const Structural_graph& target)
{
  const bool has_confidence = !c.pairs.empty() && c.pairs[0].has_confidence();
  Rows rows{{"source", "target", "operation"}};
  if (has_confidence) rows[0].push_back("confidence");
  if (!c.category.empty()) rows[0].push_back("role in " + with_article(c.category));
  for (const Block& block : blocks_of(c)) {
    std::vector<std::string> others{operation_text(block)};
    if (has_confidence) others.push_back(confidence_text(block));
    if (!c.category.empty()) others.push_back(roles_text(block, c.source_roles));
    add_rows(block.source, block.target, others, source, target, rows);
  }
  write_table(out, rows);
  const auto unmatched = [](const Parts& parts, const Structural_graph& graph) {
    return IO::quote_terminal(listed(names(parts, graph)));
  };
  out << "\nunmatched in the source: " << unmatched(c.unmatched_source, source)
      << "\nunmatched in the target: " << unmatched(c.unmatched_target, target)
      << "\ndeformation energy: " << short_number(c.energy) << " (distortion " << short_number(c.terms.distortion)
      << ", connectedness " << short_number(c.terms.connectedness) << ", split " << short_number(c.terms.split)
      << "), the "
      << (c.direction == Direction::SOURCE_TO_TARGET ? "source deformed into the target"
                                                     : "target deformed into the source")
      << (c.complete ? "" : ", incomplete") << (c.optimal ? ", proven minimal for this direction" : "")
      << "\ndistance: " << short_number(distance_energy(c, Energy_matrix_options().unmatched_energy))
      << " (energy per pair of connected parts)\n";
  print_warnings(out, c.warnings);
}

void write_group_table(std::ostream& out, const Correspondence& c, const Structural_graph& source,
                       const Structural_graph& target)
{
  Rows rows{{"group in the source", "target", "operation", "energy", "distortion", "connectedness"}};
  if (c.direction == Direction::TARGET_TO_SOURCE)
    rows[0][0] = "source", rows[0][1] = "group in the target", rows[0][2] = "operation on the target";
  for (const Group_match& group : c.groups)
    add_rows(group.source, group.target,
             {name_of(group.operation), short_number(group.energy), short_number(group.distortion),
              short_number(group.connectedness)},
             source, target, rows);
  out << '\n';
  write_table(out, rows);
}

} // namespace CGAL::Shape_correspondence::cli
