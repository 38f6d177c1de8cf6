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

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Decodes the textures of a model, PNG or JPEG of at most 8192 pixels in each direction. Those that are damaged are
/// left out of their materials, with a warning. Needs libpng and libjpeg: link `CGAL::Shape_correspondence_IO`.
void decode_textures(Shape_appearance& appearance, std::vector<std::string>& warnings);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a shape with what was transferred to it:
/// - `.glb`: binary glTF 2.0 with the texture in it;
/// - `.obj`: Wavefront OBJ with `FILE.mtl` and `FILE.png` beside it;
/// - `.ply`: binary PLY with colours of vertices, for which triangles are divided, and the face properties `part` and,
/// if
///   there are labels, `label`; comments list the names of parts and labels.
/// \param path the file to write; its extension determines the format
/// \param shape the target
/// \param transferred what was transferred to it
/// \param labels the names of labels
/// \throw Invalid_input if a file cannot be written, or the extension is none of these
void write_transferred_shape(const std::string& path, const Segmented_shape& shape,
                             const Transferred_appearance& transferred, const std::vector<std::string>& labels = {});

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_APPEARANCE_FILES_H
