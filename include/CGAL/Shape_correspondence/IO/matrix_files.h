// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_MATRIX_FILES_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_MATRIX_FILES_H

#include <Eigen/Core>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a matrix in NumPy's format `.npy`, version 1.0: doubles, row by row; `numpy.load()` reads identical values.
void write_npy(std::ostream& out, const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a matrix as CSV (RFC 4180): the first line and the first column are names; numbers have the fewest digits
/// that read as the same double.
/// \pre the matrix is square, with one name for each row
void write_csv(std::ostream& out, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
               const std::vector<std::string>& names);

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_MATRIX_FILES_H
