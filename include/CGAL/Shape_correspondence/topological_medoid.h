// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H
#define CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSets
/// The representative of a set: the index of the shape with the least sum of distances to the others (paper, section
/// 6.1), the first one in case of a tie. O(n²) for n shapes.
/// \param distances symmetric matrix, see `symmetric_distances()`
/// \pre there is at least one shape
std::size_t topological_medoid(const Eigen::Ref<const Eigen::MatrixXd>& distances);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H
