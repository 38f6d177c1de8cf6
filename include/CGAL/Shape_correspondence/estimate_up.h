// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_ESTIMATE_UP_H
#define CGAL_SHAPE_CORRESPONDENCE_ESTIMATE_UP_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// Guesses which of the axes x, y and z points up: the one along which the shape stands most firmly, which is by how
/// far its centre is inside of what it stands on, and has the most horizontal surface. A guess, since things that lie
/// are like things that stand; a model that is upside down or aslant has no right answer. Of equal axes the first of
/// y, z, x. O(n log n) in the number of vertices.
/// \return a unit vector
/// \pre the shape has a part
Point estimate_up(const Segmented_shape& shape);

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ESTIMATE_UP_H
