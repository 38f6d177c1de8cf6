// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_POINTS_H
#define CGAL_SHAPE_CORRESPONDENCE_POINTS_H

#include <Eigen/Core>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// A point. After reading the input meshes, the package computes with `double` numbers and Eigen types.
using Point = Eigen::Vector3d;
/// \ingroup PkgShapeCorrespondenceShapes
/// A list of points, one in each column.
using Points = Eigen::Matrix3Xd;

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_POINTS_H
