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

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSets
/// The shape of a set that has the least sum of distances to the others (paper, section 6.1): its representative.
/// Of equal sums the first shape is taken. O(n²).
/// \param distances symmetric, as `symmetric_distances()` makes them
/// \pre there is a shape
std::size_t topological_medoid(const Eigen::Ref<const Eigen::MatrixXd>& distances);

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H
