// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_READ_SEGMENTED_SHAPE_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_READ_SEGMENTED_SHAPE_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a model file (OBJ, PLY, STL, OFF, glTF/GLB, COLLADA; every node that owns triangles is a part) or a folder of
/// part meshes (every model file in it, or in its sub-folder `parts`, is a part, its stem the name; sorted by name).
/// Vertices at the same place are welded, polygons triangulated.
///
/// In OBJ every `o` or `g` statement with faces is a part; groups of one name in several objects are named
/// `object/group`. OBJ, OFF and PLY keep double precision, the other formats are read in single precision. COLLADA
/// files say which way is up: they are turned to y up. Needs assimp: link `CGAL::Shape_correspondence_IO`.
/// \param path the file or folder
/// \param up the upright direction
/// \throw Invalid_input if the file is missing, empty, of an unknown format or unreadable, if it has no parts, two
/// parts of the same name, or a part that `Segmented_shape::add_part()` refuses; the message names the file and the
/// part
Segmented_shape read_segmented_shape(const std::string& path, const Point& up = Point::UnitY());

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_READ_SEGMENTED_SHAPE_H
