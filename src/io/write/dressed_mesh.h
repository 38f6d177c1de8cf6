// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/glb_builder.h"

#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The materials of a shape in a GLB file; they, and their textures, are added when they are first asked for.
class Glb_materials
{
public:
  Glb_materials(Glb_builder& glb, const Shape_appearance& appearance) : glb_(glb), appearance_(appearance) {}

  /// Of a material of the shape, or the grey one for -1, or its colour's white twin for colours of vertices.
  int operator()(int material, bool has_colours);
  /// A material's colour: grey where there is none.
  Eigen::Vector4d colour_of(int material, bool has_colours) const;
  /// Whether a material has a texture.
  bool has_texture(int material) const;

private:
  int texture(int number);

  Glb_builder& glb_;
  const Shape_appearance& appearance_;
  std::map<std::pair<int, bool>, int> materials_;
  std::map<int, int> textures_;
};

/// Some triangles of a mesh, and what they look like.
struct Dressed_mesh
{
  int material = -1;       ///< of the shape
  std::vector<int> points; ///< which of the mesh's its points are
  Eigen::Matrix3Xi triangles;
  std::vector<Eigen::Vector2f> coordinates; ///< by point; empty: none
  std::vector<Eigen::Vector3f> colours;     ///< by point; empty: none
};

/// The triangles of each material; points are repeated where texture coordinates or colours are cut.
std::vector<Dressed_mesh> dressed_meshes(const Eigen::Matrix3Xi& triangles, const Part_appearance& appearance);

/// A drawn mesh by its materials, to be drawn.
std::vector<std::pair<Drawn_mesh, int>> dressed(const Drawn_mesh& mesh, const Part_appearance& appearance,
                                                Glb_materials& materials);

} // namespace CGAL::Shape_correspondence::IO
