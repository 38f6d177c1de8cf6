// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_READ_FEATURES_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_READ_FEATURES_H

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/features_of_parts.h>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Reads features from a file in NumPy's format `.npy`, version 1.0 to 3.0: an array of shape (n, d) of float32 or
/// float64, little-endian, in C or Fortran order. Arrays of Python objects are refused.
/// \param file the file
/// \return one column for each of the n rows of the array
/// \throw Invalid_input if the file cannot be read, or a number is not finite; the message names the file
Eigen::MatrixXf read_features(const std::string& file);

/// \ingroup PkgShapeCorrespondenceIO
/// The features of the parts that were made of a model in OBJ, OFF, PLY or STL, or of a folder of such files. Given are
/// features of its faces or vertices, in the order of the file, or of the files sorted by name. Polygons are one face
/// each; faces and vertices that reading leaves out or merges count. STL has no vertices. If a model has as many
/// faces as vertices, the features are those of faces.
/// \param features one column for each face, or else for each vertex
/// \param model the file or folder
/// \param split its parts, as from `split_parts()`
/// \param options the options with which the model was read
/// \return one column for each part (`Shape_structure::features`)
/// \throw Invalid_input if the model cannot be read or is of another format, the number of columns is neither that of
/// its faces nor that of its vertices, or a number is not finite
Eigen::MatrixXd features_of_parts(const Eigen::MatrixXf& features, const std::string& model, const Part_split& split,
                                  const Reading_options& options = {});

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_READ_FEATURES_H
