// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/match_page.h"
#include "viewer/page_models.h"

#include <CGAL/Shape_correspondence/IO/write_glb.h>

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
  return {
      structure(source).name + " and " + structure(target).name, {{"match", json.str()}}, {{"match.glb", glb.str()}}};
}

} // namespace CGAL::Shape_correspondence::IO
