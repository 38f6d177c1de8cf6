// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_BLEND_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_BLEND_H

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <iosfwd>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a shape as Wavefront OBJ: one object for each part, with the part's name. Coordinates are written exactly.
void write_segmented_shape_obj(std::ostream& out, const Segmented_shape& shape);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a shape as binary PLY: one mesh, with the part index as property `part` of every face; comments list the
/// names of parts.
void write_segmented_shape_ply(std::ostream& out, const Segmented_shape& shape);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a blend as binary glTF 2.0 with an animation: the source for half a second; `frames` shapes at equal time
/// steps, including source and target, in two seconds, interpolated linearly; the target for half a second.
/// Corresponding parts have the same colour. Needs nlohmann-json: link `CGAL::Shape_correspondence_IO`.
/// \pre `frames >= 2`
void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Correspondence& correspondence, int frames);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a description of a blend in the JSON format `shape_correspondence/blend`, version 1: schedules with their
/// tasks, and the quality of every frame. `source_file` and `target_file` are the inputs as the user named them,
/// `output` is the file or folder of the frames, `warnings` are added to the document.
void write_blend_json(std::ostream& out, const Shape_blend& blend, const Structural_graph& source,
                      const Structural_graph& target, const std::string& source_file, const std::string& target_file,
                      const std::string& output, int frames, const std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_WRITE_BLEND_H
