// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/pictures.h"

#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The materials of a shape in a GLB file; they, and their textures, are added when they are first asked for.
class Glb_materials
{
public:
  /// \param appearance is kept by reference
  Glb_materials(Glb_file& glb, const Shape_appearance& appearance) : glb_(glb), appearance_(appearance) {}

  /// Of a material of the shape, or the grey one for -1, or its colour's white twin for colours of vertices.
  int operator()(int material, bool has_colours);
  /// A material's colour: grey where there is none.
  Eigen::Vector4d colour_of(int material, bool has_colours) const;
  bool has_texture(int material) const;
  /// The looks of a part; empty where they are not known.
  const Part_appearance& of_part(std::size_t part) const;

private:
  int texture(int number);

  Glb_file& glb_;
  const Shape_appearance& appearance_;
  std::map<std::pair<int, bool>, int> materials_;
  std::map<int, int> textures_;
};

/// The triangles of each material; points are repeated where texture coordinates or colours are cut.
/// \param material_of the file's material, by the shape's and whether there are colours
std::vector<Blend_painter::Painted_mesh> dressed_meshes(const Eigen::Matrix3Xi& triangles, const Part_appearance& looks,
                                                        const Glb_materials& materials,
                                                        const std::function<int(int, bool)>& material_of);

/// A drawn mesh by its materials, to be drawn.
std::vector<Drawn_mesh> dressed(const Drawn_mesh& mesh, const Part_appearance& looks, Glb_materials& materials);

/// Scenes that show shapes by their materials, where one of them has some.
/// \param models that the looks belong to; pictures may have simplified ones
/// \param most_bytes of the textures of a shape; if they are more, its looks are left out
Add_scenes dressed_scenes(std::vector<std::pair<const Segmented_shape*, const Shape_appearance*>> models,
                          std::size_t most_bytes = std::size_t(-1));

/// How much of textures a web page may have.
constexpr std::size_t largest_page_textures = std::size_t(16) << 20; // bytes of a shape

} // namespace CGAL::Shape_correspondence::IO
