// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/match_page.h"
#include "io/write/Json.h"
#include "io/write/part_labels.h"
#include "viewer/page_models.h"

#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/correspondence_blocks.h>

#include <sstream>

namespace CGAL::Shape_correspondence::IO {

namespace {

constexpr std::size_t largest_page_textures = std::size_t(16) << 20; // bytes

std::size_t bytes_of_textures(const Shape_appearance& appearance)
{
  std::size_t result = 0;
  for (const Texture& texture : appearance.textures)
    result += texture.bytes.size();
  return result;
}

/// What a simplified model looks like.
Shape_appearance simplified_appearance(const Shape_appearance* appearance, const Segmented_shape* model,
                                       const Segmented_shape* simplified)
{
  Shape_appearance result;
  if (!appearance || appearance->empty() || !model || bytes_of_textures(*appearance) > largest_page_textures)
    return result;
  if (model == simplified) return *appearance;
  result.materials = appearance->materials;
  result.textures = appearance->textures;
  for (std::size_t part = 0; part < model->parts().size(); ++part)
    result.parts.push_back(
        appearance_on(model->parts()[part].mesh, appearance->parts[part], simplified->parts()[part].mesh));
  return result;
}

using Labels = std::vector<std::string>;

Labels labels_of(const Structural_graph& graph)
{
  Labels names;
  for (const Part_abstraction& part : structure(graph).parts)
    names.push_back(part.name);
  return part_labels(names);
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
                const Match_seconds& seconds, const Shape_appearance* source_appearance,
                const Shape_appearance* target_appearance)
{
  std::ostringstream json, glb;
  write_correspondences_json(json, ranked, source, target, source_file, target_file, seconds);
  const Page_models models({source_shape, target_shape}, largest_page_triangles);
  const Shape_appearance source_looks = simplified_appearance(source_appearance, source_shape, models[0]);
  const Shape_appearance target_looks = simplified_appearance(target_appearance, target_shape, models[1]);
  write_correspondence_glb(glb, ranked.front(), source, target, models[0], models[1], &source_looks, &target_looks);
  const Labels source_labels = labels_of(source), target_labels = labels_of(target);
  std::ostringstream labels;
  labels << Json::array({source_labels, target_labels}).line();
  return {structure(source).name + " and " + structure(target).name,
          {{"match", json.str()}, {"labels", labels.str()}},
          {{"match.glb", glb.str()}},
          summary_of(ranked.front(), source_labels, target_labels)};
}

} // namespace CGAL::Shape_correspondence::IO
