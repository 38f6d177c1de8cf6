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
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Options for reading models.
struct Reading_options
{
  /// Files that a model names (buffers, materials, textures, meshes of parts) may be anywhere. By default they must be
  /// in the model's folder or below it, so that an untrusted model cannot read others. They must always be regular
  /// files.
  bool allow_outside_files = false;
  /// A file with a label for each face of an OBJ, OFF, PLY or STL model; the labels become the parts: one line or word
  /// for each face, or for each label a line with its name, followed by lines with the numbers of its faces, from 1 on.
  /// Empty: the list next to the model with its name and the extension `.seg`, if there is one.
  std::string face_labels = {};
};

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a model file (OBJ, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, 3MF, DXF, AC3D; every node that owns triangles
/// is a part; or URDF, of which every link with visuals is a part) or a folder of part meshes (every model file in it,
/// or in its sub-folder `parts`, is a part, named after the file; sorted by name). Vertices at the same place are
/// merged, polygons triangulated; faces of fewer than three corners, and parts of a file without area, are left out.
///
/// In OBJ every `o` or `g` statement with faces is a part, in STL every solid. A repeated OBJ group that uses vertices
/// of the earlier one continues it; groups of an `o` that share vertices are one part, unless the file would then have
/// only one part; groups with the same name in several objects are named `object/group`; if there is only one object,
/// mostly one piece, its materials are the parts. Labels of faces become parts if a PLY file has them (face property
/// `part`, `segment`, `label`, `category_id`, `object_id` or the like) or a list gives them. Hidden files in folders
/// are ignored. Repeated names get a number: `leg`, `leg#2`. Names become UTF-8; those that are not UTF-8 are read as
/// Latin-1. OBJ, OFF, PLY, STL and glTF keep double precision, the other formats are read in single precision. COLLADA
/// files define the upright axis: they are turned to y up. FBX, 3MF and URDF define it as well: it becomes that of the
/// shape, unless `up` differs from y.
///
/// Formats other than OBJ, OFF, PLY, STL, URDF and glTF 2.0 without compression are read in a separate program,
/// `shape_correspondence_import`, which is installed with the package. It is limited to 2 GB of memory, 60 seconds of
/// processor time and 120 seconds; exceeding a limit is an error. If a program linked with the static library is moved
/// to another machine, the environment variable `SHAPE_CORRESPONDENCE_IMPORT` must give its path. Link
/// `CGAL::Shape_correspondence_IO`.
/// \param path the file or folder
/// \param up the upright direction
/// \param warnings receives sentences on what was left out; may be null
/// \param options labels of faces, and which files may be read
/// \throw Invalid_input if the file is missing, empty, of an unknown format, damaged or beyond the limits, if it has no
/// parts or more than 2000, or a part that `Segmented_shape::add_part()` refuses; the message names the file and the
/// part
Segmented_shape read_segmented_shape(const std::string& path, const Point& up = Point(0, 1, 0),
                                     std::vector<std::string>* warnings = nullptr, const Reading_options& options = {});

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_READ_SEGMENTED_SHAPE_H
