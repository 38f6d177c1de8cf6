// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "io/write/Json.h"
#include "matching/check_correspondence.h"
#include "matching/rate.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr const char* match_format = "shape_correspondence/match";

const char* direction_name(Direction direction)
{
  return direction == Direction::SOURCE_TO_TARGET ? "source_to_target" : "target_to_source";
}

Json names(const std::vector<std::size_t>& parts, const Structural_graph& graph)
{
  Json result = Json::array();
  for (std::size_t part : parts)
    result.push_back(structure(graph).parts[part].name);
  return result;
}

/// The names of a shape's parts as JSON.
std::vector<std::string> quoted_names(const Structural_graph& graph)
{
  std::vector<std::string> result;
  for (const Part_abstraction& part : structure(graph).parts)
    result.push_back(Json(part.name).line());
  return result;
}

/// The pairs as JSON text, since a million pairs of JSON values take half a gigabyte.
Json pairs(const Correspondence& correspondence, const Structural_graph& source, const Structural_graph& target)
{
  const std::vector<std::string> sources = quoted_names(source), targets = quoted_names(target);
  std::string text;
  for (const Part_correspondence& pair : correspondence.pairs)
    text.append(text.empty() ? "[[" : ",[").append(sources[pair.source]).append(",").append(targets[pair.target]) +=
        ']';
  return Json::of_text(text.empty() ? "[]" : std::move(text += ']'));
}

/// The confidences of all pairs as JSON text; empty if the method computes none.
std::string confidences(const Correspondence& correspondence)
{
  std::string text;
  for (const Part_correspondence& pair : correspondence.pairs) {
    if (!pair.has_confidence()) return "";
    text.append(text.empty() ? "[" : ",").append(Json(pair.confidence).line());
  }
  return text.empty() ? text : std::move(text += ']');
}

/// An object with the role of each part, by the part's name.
Json roles(const std::vector<std::string>& roles, const Structural_graph& graph)
{
  Json result = Json::object();
  for (std::size_t part = 0; part < roles.size(); ++part)
    result[structure(graph).parts[part].name] = roles[part];
  return result;
}

Json blocks(const Correspondence& correspondence, const Structural_graph& source, const Structural_graph& target)
{
  Json result = Json::array();
  for (const Correspondence_block& block : correspondence_blocks(correspondence)) {
    result.push_back({{"source", names(block.source, source)}, {"target", names(block.target, target)}});
    if (!block.role.empty()) result.back()["role"] = block.role;
    result.back()["operation"] = name_of(block.operation);
    if (!std::isnan(block.confidence)) result.back()["confidence"] = block.confidence;
  }
  return result;
}

Json groups(const Correspondence& correspondence, const Structural_graph& source, const Structural_graph& target)
{
  Json result = Json::array();
  for (const Group_match& group : correspondence.groups) {
    result.push_back({{"source", names(group.source, source)},
                      {"target", names(group.target, target)},
                      {"operation", name_of(group.operation)},
                      {"energy", group.energy},
                      {"terms", {{"distortion", group.distortion}, {"connectedness", group.connectedness}}},
                      {"solidity_ratio", group.solidity_ratio}});
    // A min-marginal is NaN unless requested, and infinite, which JSON cannot express, if the group has no other match
    if (std::isinf(group.min_marginal))
      result.back()["min_marginal"] = "infinite";
    else if (!std::isnan(group.min_marginal))
      result.back()["min_marginal"] = group.min_marginal;
  }
  return result;
}

Json contacts(const Correspondence& correspondence, const Structural_graph& deformed)
{
  Json result = Json::array();
  for (const Contact_energy& contact : correspondence.contacts) {
    result.push_back({{"parts", names({contact.parts[0], contact.parts[1]}, deformed)},
                      {"distortion", contact.distortion},
                      {"connectedness", contact.connectedness}});
  }
  return result;
}

Json terms(const Energy_terms& terms)
{
  Json result = {{"distortion", terms.distortion}, {"connectedness", terms.connectedness}, {"split", terms.split}};
  if (terms.unmatched > 0) result["unmatched"] = terms.unmatched;
  if (terms.roles > 0) result["roles"] = terms.roles;
  return result;
}

Json solutions(const std::vector<Correspondence>& ranked, const Structural_graph& source,
               const Structural_graph& target)
{
  Json result = Json::array();
  for (const Correspondence& c : ranked)
    result.push_back({{"energy", c.energy}, {"terms", terms(c.terms)}, {"pairs", pairs(c, source, target)}});
  return result;
}

/// For each part of a graph, its role from `roles`, which are by name; empty: unknown.
std::vector<std::string> roles_of_parts(const std::map<std::string, std::string>& roles, const Structural_graph& graph)
{
  std::vector<std::string> result;
  for (const Part_abstraction& part : structure(graph).parts) {
    const auto found = roles.find(part.name);
    result.push_back(found == roles.end() ? "" : found->second);
  }
  return result;
}

} // namespace

void write_correspondence_json(std::ostream& out, const Correspondence& c, const Structural_graph& source,
                               const Structural_graph& target, const std::string& source_file,
                               const std::string& target_file, const Match_seconds& seconds)
{
  write_correspondences_json(out, {c}, source, target, source_file, target_file, seconds);
}

void write_correspondences_json(std::ostream& out, const std::vector<Correspondence>& ranked,
                                const Structural_graph& source, const Structural_graph& target,
                                const std::string& source_file, const std::string& target_file,
                                const Match_seconds& seconds)
{
  for (const Correspondence& of_graphs : ranked)
    internal::check_correspondence("write_correspondence_json", of_graphs, structure(source).parts.size(),
                                   structure(target).parts.size());
  const Correspondence& c = ranked.front();
  const bool forward = c.direction == Direction::SOURCE_TO_TARGET;
  Json result;
  result["format"] = match_format;
  result["version"] = 1;
  result["source"] = source_file;
  result["target"] = target_file;
  result["energy"] = c.energy;
  result["terms"] = terms(c.terms);
  result["direction"] = direction_name(c.direction);
  result["target_quarter_turns"] = c.target_quarter_turns;
  result["complete"] = c.complete;
  result["optimal"] = c.optimal;
  result["pairs"] = pairs(c, source, target);
  if (std::string known = confidences(c); !known.empty()) result["confidences"] = Json::of_text(std::move(known));
  if (!c.category.empty()) {
    result["category"] = c.category;
    result["roles"] = {{"source", roles(c.source_roles, source)}, {"target", roles(c.target_roles, target)}};
  }
  if (c.feature_dimension > 0)
    result["features"] = {{"dimension", c.feature_dimension}, {"weight", c.feature_weight}, {"calibrated", false}};
  result["blocks"] = blocks(c, source, target);
  result["groups"] = groups(c, source, target);
  result["contacts"] = contacts(c, forward ? source : target);
  result["unmatched_source"] = names(c.unmatched_source, source);
  result["unmatched_target"] = names(c.unmatched_target, target);
  result["seconds"] = {{"read", seconds.read},
                       {"abstraction", seconds.abstraction},
                       {"structure", seconds.structure},
                       {"search", seconds.search}};
  result["search"] = {{"method", c.search.method},
                      {"states", c.search.states},
                      {"evaluations", c.search.evaluations},
                      {"lower_bound", c.search.lower_bound}};
  result["warnings"] = c.warnings;
  if (ranked.size() > 1) result["solutions"] = solutions(ranked, source, target);
  result.write(out);
}

Named_correspondence read_correspondence_json(const std::string& file)
{
  const Json_field root = read_json_file(file);
  if (root["format"].text() != match_format)
    root["format"].fail("is '" + root["format"].text() + "', not '" + match_format + "'");
  if (root["version"].integer() != 1) root["version"].fail("is not 1, the one that this program knows");
  Named_correspondence result;
  result.source = root["source"].text();
  result.target = root["target"].text();
  result.complete = root["complete"].boolean();
  for (const Json_field& pair : root["pairs"].elements()) {
    const std::vector<Json_field> names = pair.elements(2, "a pair of part names");
    result.pairs.push_back({names[0].text(), names[1].text()});
  }
  if (root.has("target_quarter_turns")) {
    result.target_quarter_turns = root["target_quarter_turns"].integer();
    if (result.target_quarter_turns < 0 || result.target_quarter_turns > 3)
      root["target_quarter_turns"].fail("is not 0, 1, 2 or 3");
  }
  if (root.has("category") && root.has("roles")) {
    result.category = root["category"].text();
    result.source_roles = root["roles"]["source"].texts_by_key();
    result.target_roles = root["roles"]["target"].texts_by_key();
  }
  if (!root.has("confidences")) return result;
  auto pair = result.pairs.begin();
  for (const Json_field& confidence : root["confidences"].elements(result.pairs.size(), "a confidence for each pair"))
    if ((pair++->confidence = confidence.number_at_least_0()) > 1) confidence.fail("is greater than 1");
  return result;
}

Correspondence correspondence_of(const Named_correspondence& named, const Structural_graph& source,
                                 const Structural_graph& target, const std::string& file)
{
  const auto part = [&](const std::string& name, const Structural_graph& graph) {
    const auto& parts = structure(graph).parts;
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const Part_abstraction& p) { return p.name == name; });
    if (found == parts.end())
      throw Invalid_input(file + ": it matches part '" + name + "', which " + structure(graph).name +
                          " does not have; give the shapes that were matched, in that order");
    return static_cast<std::size_t>(found - parts.begin());
  };
  Correspondence result;
  for (const Named_part_correspondence& pair : named.pairs) {
    const std::size_t t = part(pair.target, target), s = part(pair.source, source);
    result.pairs.push_back({s, t, pair.confidence});
  }
  std::sort(result.pairs.begin(), result.pairs.end(), is_before);
  internal::collect_unmatched(structure(source).parts.size(), structure(target).parts.size(), result);
  if (!named.category.empty()) {
    result.category = named.category;
    result.source_roles = roles_of_parts(named.source_roles, source);
    result.target_roles = roles_of_parts(named.target_roles, target);
  }
  result.target_quarter_turns = named.target_quarter_turns;
  result.complete = named.complete;
  return result;
}

bool is_correspondence_json(const std::string& file) { return read_json_file(file).has("format", match_format); }

} // namespace CGAL::Shape_correspondence::IO
