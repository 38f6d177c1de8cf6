// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_GEOTOPO_OPERATION_H
#define CGAL_SHAPE_CORRESPONDENCE_GEOTOPO_OPERATION_H

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// Operations of the GeoTopo transform on the parts of a group, in the direction of the deformation (paper, section
/// 4.1).
enum class Operation {
  MATCH,     ///< parts correspond one to one
  SPLIT,     ///< one part becomes many
  DUPLICATE, ///< some of several parts are cloned
  MERGE,     ///< many parts become fewer
  CUT,       ///< curves are cut into equally long segments, one for each target part
  JOIN,      ///< the inverse of `CUT`: several curves become the segments of one
  NONE       ///< the group is left unmatched
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// The operation's name in files and messages.
inline const char* name_of(Operation operation)
{
  static constexpr const char* names[] = {"match", "split", "duplicate", "merge", "cut", "join", "none"};
  return names[int(operation)];
}

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_GEOTOPO_OPERATION_H
