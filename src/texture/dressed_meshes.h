// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/pictures.h"

#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The materials of a shape in a GLB file; materials and textures are added when first used.
class Glb_materials
{
public:
  /// \param appearance kept by reference
  Glb_materials(Glb_file& glb, const Shape_appearance& appearance) : glb_(glb), appearance_(appearance) {}

  /// The appearance of a part; empty if it is unknown.
  const Part_appearance& of_part(std::size_t part) const;
  /// The colour of a part that has the same colour everywhere, without texture; none for other parts.
  std::optional<Eigen::Vector4d> only_colour(std::size_t part) const;
  /// The triangles of each material; points are duplicated at seams of texture coordinates or colours.
  /// \param instead material of the file that replaces all materials; -1: none
  std::vector<Blend_painter::Painted_mesh> dressed(const Eigen::Matrix3Xi& triangles, const Part_appearance& looks,
                                                   int instead = -1);
  /// Splits a drawn mesh of a part by material.
  std::vector<Drawn_mesh> dressed(const Drawn_mesh& mesh, std::size_t part);

private:
  bool has_texture(int material) const;
  /// A material's colour; for -1, grey, or white if there are vertex colours.
  Eigen::Vector4d colour_of(int material, bool has_colours) const;
  int in_file(int material, bool has_colours);
  int texture_in_file(int number);

  Glb_file& glb_;
  const Shape_appearance& appearance_;
  std::map<std::pair<int, bool>, int> materials_;
  std::map<int, int> textures_;
};

/// Scenes that show shapes with their materials, if at least one has any.
/// \param models the shapes that the appearances belong to; the drawn shapes may be simplified
/// \param most_bytes limit for the textures of a shape; if exceeded, its appearance is left out
Add_scenes dressed_scenes(std::vector<std::pair<const Segmented_shape*, const Shape_appearance*>> models,
                          std::size_t most_bytes = std::size_t(-1));

/// Limit for textures in a web page
constexpr std::size_t largest_page_textures = std::size_t(16) << 20; // number of bytes for each shape

} // namespace CGAL::Shape_correspondence::IO
