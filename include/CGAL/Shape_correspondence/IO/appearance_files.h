// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_APPEARANCE_FILES_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_APPEARANCE_FILES_H

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a model like `read_segmented_shape()`, with its appearance: materials (base colours of MTL libraries and of
/// glTF and the formats of assimp), textures (PNG and JPEG, inside the model, relative to it or beside it), texture
/// coordinates, and colours of vertices and faces. Missing or damaged ones are left out, with a warning in
/// `appearance`. This function and those below are in `CGAL::Shape_correspondence_Texture`.
/// \param path the file or folder
/// \param appearance receives the appearance of the parts, with warnings on what was left out
/// \param up the upright direction
/// \param warnings receives sentences on what was left out of the shape; may be null
/// \param options which files are read
/// \throw Invalid_input see `read_segmented_shape()`
Segmented_shape read_shape_and_appearance(const std::string& path, Shape_appearance& appearance,
                                          const Point& up = Point(0, 1, 0),
                                          std::vector<std::string>* warnings = nullptr,
                                          const Reading_options& options = {});

/// \ingroup PkgShapeCorrespondenceIO
/// Decodes the textures of a model, PNG or JPEG of at most 8192 pixels in each direction. Damaged ones are removed from
/// their materials, with a warning. Needs libpng and libjpeg.
void decode_textures(Shape_appearance& appearance, std::vector<std::string>& warnings);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a shape with the transferred appearance:
/// - `.glb`: binary glTF 2.0 with the texture in it;
/// - `.obj`: Wavefront OBJ with `FILE.mtl` and `FILE.png` beside it;
/// - `.ply`: binary PLY with colours of vertices, for which triangles are divided, and the face properties `part` and,
///   if there are labels, `label`; comments list the names of parts and labels.
/// \param path the file to write; its extension determines the format
/// \param shape the target
/// \param transferred the transferred appearance
/// \param labels the names of labels
/// \throw Invalid_input if a file cannot be written, or the extension is none of these
void write_transferred_shape(const std::string& path, const Segmented_shape& shape,
                             const Transferred_appearance& transferred, const std::vector<std::string>& labels = {});

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a shape as binary glTF 2.0 with its materials, textures, texture coordinates and colours, turned to y up, one
/// node for each part. Parts without material are grey.
void write_segmented_shape_glb(std::ostream& out, const Segmented_shape& shape, const Shape_appearance& appearance);

/// \ingroup PkgShapeCorrespondenceIO
/// The same as `write_correspondence_glb()` without appearance, plus a scene named `materials` that shows the shapes
/// with their own materials and textures.
void write_correspondence_glb(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                              const Structural_graph& target, const Segmented_shape* source_shape,
                              const Segmented_shape* target_shape, const Shape_appearance& source_appearance,
                              const Shape_appearance& target_appearance);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the picture of `write_structural_graph_glb()` without appearance, plus a scene named `materials`.
void write_structural_graph_glb(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape,
                                const Shape_appearance& appearance);

/// \ingroup PkgShapeCorrespondenceIO
/// The appearance of the two shapes of a blend.
struct Blend_appearance
{
  Shape_appearance source; ///< appearance of the source
  Shape_appearance target; ///< appearance of the target
};

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the animation of `write_blend_glb()` for a correspondence, with the shapes' own materials and textures. If
/// two corresponding parts have one colour each, the colour changes in five steps, since glTF cannot animate materials.
/// Textures, colours of vertices, and several materials of a part do not fade: they stay on the part's surface until it
/// is replaced by the target's.
/// \pre `frames >= 2`
void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, int frames);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the shape at `t` as binary glTF 2.0 with materials and textures; here colours change continuously.
void write_blend_frame_glb(std::ostream& out, const Shape_blend& blend, const Blend_appearance& appearance, double t);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_APPEARANCE_FILES_H
