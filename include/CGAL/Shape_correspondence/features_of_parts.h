// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_FEATURES_OF_PARTS_H
#define CGAL_SHAPE_CORRESPONDENCE_FEATURES_OF_PARTS_H

#include <CGAL/Shape_correspondence/split_parts.h>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// The features of the parts of a shape, for `Shape_structure::features`: features of its surface, such as a neural
/// network computes, integrated over each part and divided by the area of the shape. Features of vertices are
/// interpolated.
/// \param features one column for each triangle, or else for each vertex, of all parts, in their order
/// \param shape the shape
/// \return one column for each part
/// \throw Invalid_input if there is not one column for each triangle or vertex, or a number is not finite
Eigen::MatrixXd features_of_parts(const Eigen::MatrixXf& features, const Segmented_shape& shape);

/// \ingroup PkgShapeCorrespondenceShapes
/// The features of the parts that were made of the objects of a model. A triangle of a part has the features of the
/// triangle of the objects with the same corners, or else of the one nearest to its centre.
/// \param features one column for each triangle, or else for each vertex, of all objects, in their order
/// \param objects the objects
/// \param split the parts made of them
/// \return one column for each part
/// \throw Invalid_input if there is not one column for each triangle or vertex, or a number is not finite
Eigen::MatrixXd features_of_parts(const Eigen::MatrixXf& features, const Segmented_shape& objects,
                                  const Part_split& split);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_FEATURES_OF_PARTS_H
