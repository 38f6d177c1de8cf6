// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SHAPE_APPEARANCE_H
#define CGAL_SHAPE_CORRESPONDENCE_SHAPE_APPEARANCE_H

#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceAppearance
/// A picture: red, green, blue, alpha of each pixel in bytes, sRGB, row by row from the top.
struct Image
{
  int width = 0;                    ///< pixels in a row
  int height = 0;                   ///< rows
  std::vector<std::uint8_t> pixels; ///< four bytes for each pixel

  /// Whether there is no pixel.
  bool empty() const { return pixels.empty(); }
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// How a texture is continued outside of [0, 1].
enum class Texture_wrap { REPEAT, MIRROR, CLAMP };

/// \ingroup PkgShapeCorrespondenceAppearance
/// A texture as a model has it.
struct Texture
{
  std::string name;                           ///< file name, or a name inside the model
  std::string bytes;                          ///< of a PNG or JPEG file
  Image image;                                ///< the same decoded; empty: not decoded
  Texture_wrap wrap_u = Texture_wrap::REPEAT; ///< along the first coordinate
  Texture_wrap wrap_v = Texture_wrap::REPEAT; ///< along the second coordinate
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// A material, as far as it is transferred: its base colour, multiplied by a texture.
struct Surface_material
{
  std::string name;                   ///< as in the model
  Eigen::Vector4d colour{1, 1, 1, 1}; ///< linear red, green, blue, and alpha, in [0, 1]
  int texture = -1;                   ///< index of the texture; -1: none
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// What the triangles of a part look like, in addition to its `Part_mesh`. Empty: unknown.
struct Part_appearance
{
  std::vector<int> materials; ///< by triangle, index of its material; -1: none
  std::vector<Eigen::Vector2f>
      coordinates;                      ///< by corner, three per triangle: texture coordinates, v downwards as in glTF
  std::vector<Eigen::Vector3f> colours; ///< by corner, three per triangle: linear factors of the base colour, in [0, 1]

  /// Whether nothing is known.
  bool empty() const { return materials.empty() && coordinates.empty() && colours.empty(); }
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// Materials, textures and colours of a shape. They are kept beside its `Segmented_shape`: no result of matching
/// depends on them.
struct Shape_appearance
{
  std::vector<Surface_material> materials; ///< of all parts
  std::vector<Texture> textures;           ///< of all materials
  std::vector<Part_appearance> parts;      ///< by part of the shape
  std::vector<std::string> warnings;       ///< which files named by the model are missing or damaged, in sentences

  /// Whether no part has a material or colours.
  bool empty() const
  {
    return std::all_of(parts.begin(), parts.end(), [](const Part_appearance& part) {
      return part.colours.empty() &&
             std::all_of(part.materials.begin(), part.materials.end(), [](int m) { return m < 0; });
    });
  }
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SHAPE_APPEARANCE_H
