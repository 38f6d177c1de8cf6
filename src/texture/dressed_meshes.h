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

/// The materials of a shape in a GLB file; they, and their textures, are added when they are first used.
class Glb_materials
{
public:
  /// \param appearance is kept by reference
  Glb_materials(Glb_file& glb, const Shape_appearance& appearance) : glb_(glb), appearance_(appearance) {}

  /// The looks of a part; empty where they are not known.
  const Part_appearance& of_part(std::size_t part) const;
  /// The colour of a part that is of one colour.
  std::optional<Eigen::Vector4d> only_colour(std::size_t part) const;
  /// The triangles of each material; points are repeated where texture coordinates or colours are cut.
  /// \param instead where not -1, the file's material that they have instead of their own
  std::vector<Blend_painter::Painted_mesh> dressed(const Eigen::Matrix3Xi& triangles, const Part_appearance& looks,
                                                   int instead = -1);
  /// A drawn mesh of a part by its materials, to be drawn.
  std::vector<Drawn_mesh> dressed(const Drawn_mesh& mesh, std::size_t part);

private:
  bool has_texture(int material) const;
  /// A material's colour: grey for -1, but white where there are colours of vertices.
  Eigen::Vector4d colour_of(int material, bool has_colours) const;
  int in_file(int material, bool has_colours);
  int texture_in_file(int number);

  Glb_file& glb_;
  const Shape_appearance& appearance_;
  std::map<std::pair<int, bool>, int> materials_;
  std::map<int, int> textures_;
};

/// Scenes that show shapes by their materials, where one of them has some.
/// \param models that the looks belong to; pictures may have simplified ones
/// \param most_bytes of the textures of a shape; if they are more, its looks are left out
Add_scenes dressed_scenes(std::vector<std::pair<const Segmented_shape*, const Shape_appearance*>> models,
                          std::size_t most_bytes = std::size_t(-1));

/// How much of textures a web page may have.
constexpr std::size_t largest_page_textures = std::size_t(16) << 20; // bytes of a shape

} // namespace CGAL::Shape_correspondence::IO
