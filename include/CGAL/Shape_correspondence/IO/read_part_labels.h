// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_READ_PART_LABELS_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_READ_PART_LABELS_H

#include <CGAL/Shape_correspondence/ground_truth.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// A shape with labelled parts.
struct Labelled_shape
{
  std::string file;               ///< path of its `labels.json`
  std::string name;               ///< name of its folder
  std::string category;           ///< from the file; if not given there, the name of the parent folder
  std::string source;             ///< origin of the shape; empty if not given
  std::string license;            ///< licence of the shape; empty if not given
  std::vector<std::string> parts; ///< names of the parts, each once
  std::vector<Part_label> labels; ///< indexed by part

  /// Index of the part of this name; the number of parts if there is none.
  std::size_t index(const std::string& part) const;
};

/// \ingroup PkgShapeCorrespondenceIO
/// Reads labels: `path` is a `labels.json`, or a folder that contains one, or SHAPE/labels.json, or
/// CATEGORY/SHAPE/labels.json. A file is an object with `parts`, a list of objects with `name`, `coarse` and,
/// optionally, `fine`; and, optionally, `category`, `source` and `license`. Shapes are sorted by path.
/// \throw Invalid_input if there are no labels, or a file is unusable; the message gives the file and the error
std::vector<Labelled_shape> read_part_labels(const std::string& path);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_READ_PART_LABELS_H
