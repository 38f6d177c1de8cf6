// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/match_page.h"
#include "io/write/Json.h"
#include "io/write/part_labels.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <sstream>

namespace CGAL::Shape_correspondence::IO {

namespace {

using Labels = std::vector<std::string>;

Labels labels_of(const Structural_graph& graph, const std::vector<std::string>& roles)
{
  Labels names;
  for (const Part_abstraction& part : structure(graph).parts)
    names.push_back(part.name);
  return part_labels(names, roles);
}

std::string listed(const std::vector<std::size_t>& parts, const Labels& labels)
{
  Labels of_parts;
  for (std::size_t part : parts)
    of_parts.push_back(labels[part]);
  std::string result;
  for (const std::string& label : with_ranges(of_parts))
    result += (result.empty() ? "" : ", ") + label;
  return result;
}

/// A line for each block.
std::string summary_of(const Correspondence& correspondence, const Labels& source, const Labels& target)
{
  std::string result;
  for (const Correspondence_block& block : correspondence_blocks(correspondence))
    result += (block.role.empty() ? "" : block.role + ": ") + listed(block.source, source) + " → " +
              listed(block.target, target) + " (" + name_of(block.operation) + ")\n";
  return result;
}

} // namespace

Page match_page(const std::vector<Correspondence>& ranked, const Structural_graph& source,
                const Structural_graph& target, const Segmented_shape* source_shape,
                const Segmented_shape* target_shape, const std::string& source_file, const std::string& target_file,
                const Match_seconds& seconds, const Add_scenes& add_scenes)
{
  std::ostringstream json, glb;
  write_correspondences_json(json, ranked, source, target, source_file, target_file, seconds);
  const Page_models models({source_shape, target_shape}, largest_page_triangles);
  write_correspondence_glb(glb, ranked.front(), source, target, models[0], models[1], add_scenes);
  const Labels source_labels = labels_of(source, ranked.front().source_roles),
               target_labels = labels_of(target, ranked.front().target_roles);
  std::ostringstream labels;
  labels << Json::array({source_labels, target_labels}).line();
  return {structure(source).name + " and " + structure(target).name,
          {{"match", json.str()}, {"labels", labels.str()}},
          {{"match.glb", glb.str()}},
          summary_of(ranked.front(), source_labels, target_labels)};
}

void add_blend(Page& page, const std::string& json, const Shape_blend& blend, const Correspondence& correspondence,
               int frames)
{
  std::ostringstream glb;
  write_blend_glb(glb, blend, correspondence, frames);
  page.json.push_back({"blend", json});
  page.glb.push_back({"blend.glb", glb.str()});
}

} // namespace CGAL::Shape_correspondence::IO
