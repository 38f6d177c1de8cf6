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

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceAppearance
/// An sRGB image with one byte each for red, green, blue and alpha, row by row from the top.
struct Image
{
  int width = 0;                    ///< number of pixels in a row
  int height = 0;                   ///< number of rows
  std::vector<std::uint8_t> pixels; ///< four bytes for each pixel

  /// Whether there is no pixel.
  bool empty() const { return pixels.empty(); }
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// How a texture continues at coordinates outside of [0, 1].
enum class Texture_wrap { REPEAT, MIRROR, CLAMP };

/// \ingroup PkgShapeCorrespondenceAppearance
/// A texture of a model.
struct Texture
{
  std::string name;                           ///< file name, or a name inside the model
  std::string bytes;                          ///< content of a PNG or JPEG file
  Image image;                                ///< the decoded image; empty: not decoded
  Texture_wrap wrap_u = Texture_wrap::REPEAT; ///< along the first coordinate
  Texture_wrap wrap_v = Texture_wrap::REPEAT; ///< along the second coordinate
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// The part of a material that is transferred: its base colour, multiplied by a texture.
struct Surface_material
{
  std::string name;                   ///< as in the model
  Eigen::Vector4d colour{1, 1, 1, 1}; ///< linear red, green, blue, and alpha, in [0, 1]
  int texture = -1;                   ///< index of the texture; -1: none
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// The appearance of the triangles of a `Part_mesh`; empty: unknown.
struct Part_appearance
{
  std::vector<int> materials; ///< for each triangle, the index of its material; -1: none
  /// Indexed by corner, three per triangle: texture coordinates, v downwards as in glTF.
  std::vector<Eigen::Vector2f> coordinates;
  /// Indexed by corner, three per triangle: linear factors of the base colour, in [0, 1].
  std::vector<Eigen::Vector3f> colours;

  /// Whether the appearance is unknown.
  bool empty() const { return materials.empty() && coordinates.empty() && colours.empty(); }
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// Materials, textures and colours of a shape, apart from its `Segmented_shape`, since matching does not use them.
struct Shape_appearance
{
  std::vector<Surface_material> materials; ///< materials of all parts
  std::vector<Texture> textures;           ///< textures of all materials
  std::vector<Part_appearance> parts;      ///< indexed by part of the shape
  std::vector<std::string> warnings;       ///< sentences on missing or damaged files named by the model

  /// Whether no part has a material or colours.
  bool empty() const
  {
    return std::all_of(parts.begin(), parts.end(), [](const Part_appearance& part) {
      return part.colours.empty() &&
             std::all_of(part.materials.begin(), part.materials.end(), [](int m) { return m < 0; });
    });
  }
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SHAPE_APPEARANCE_H
