// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_PARTS_JSON_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_PARTS_JSON_H

#include <CGAL/Shape_correspondence/split_parts.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes the assignment of a model's pieces to parts, to be edited by hand; the manual describes the format. Link
/// `CGAL::Shape_correspondence_IO`.
/// \param out the stream
/// \param split the pieces and parts
void write_parts_json(std::ostream& out, const Part_split& split);

/// \ingroup PkgShapeCorrespondenceIO
/// Splits a model into the parts that a file of `write_parts_json()`, perhaps edited, defines.
/// \param objects the model
/// \param path the file
/// \param materials as in `Part_splitting_options`, for files whose pieces end at changes of the material
/// \return the parts
/// \throw Invalid_input if the file cannot be read, is not of this format, or does not list the pieces of the model;
/// the message names the file
Part_split split_parts_by_json(const Segmented_shape& objects, const std::string& path,
                               const std::vector<std::vector<int>>& materials = {});

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_PARTS_JSON_H
