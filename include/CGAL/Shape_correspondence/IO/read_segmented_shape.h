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
#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Reads a model file (OBJ, PLY, STL, OFF, glTF/GLB, COLLADA, FBX, 3DS, DXF, AC3D; every node that owns triangles is a
/// part) or a folder of part meshes (every model file in it, or in its sub-folder `parts`, is a part, named after the
/// file; sorted by name). Vertices at the same place are merged, polygons triangulated; faces of fewer than three
/// corners, and parts of a file that have no area, are left out.
///
/// In OBJ every `o` or `g` statement with faces is a part, in STL every solid; groups of one name in several objects
/// are named `object/group`; if there is only one object, mostly one piece, its materials are the parts. If a name
/// occurs again, it gets a number: `leg`, `leg#2`. Names become UTF-8; those that are not UTF-8 are read as Latin-1.
/// OBJ, OFF, PLY and STL keep double precision, the other formats are read in single precision. COLLADA files define
/// the upright axis: they are turned to y up.
///
/// Formats other than OBJ, OFF, PLY and STL are read by assimp in a process of its own, a `fork()` of the caller's. If
/// it takes more than 2 GB of memory or 60 seconds of processor time, that is an error. Link
/// `CGAL::Shape_correspondence_IO`.
/// \param path the file or folder
/// \param up the upright direction
/// \param warnings if not null, sentences on what was left out are appended
/// \param appearance if not null, gets the materials (base colours of MTL libraries and of the formats of assimp),
/// textures (PNG and JPEG of up to 64 MB, inside the model, relative to it or beside it), texture coordinates and
/// colours of vertices and faces; what is missing or damaged of them is left out, with a warning
/// \throw Invalid_input if the file is missing, empty, of an unknown format, damaged or beyond the limits, if it has no
/// parts or more than 2000, or a part that `Segmented_shape::add_part()` refuses; the message names the file and the
/// part
Segmented_shape read_segmented_shape(const std::string& path, const Point& up = Point(0, 1, 0),
                                     std::vector<std::string>* warnings = nullptr,
                                     Shape_appearance* appearance = nullptr);

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_READ_SEGMENTED_SHAPE_H
