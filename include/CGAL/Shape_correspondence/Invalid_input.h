// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_INVALID_INPUT_H
#define CGAL_SHAPE_CORRESPONDENCE_INVALID_INPUT_H

#include <stdexcept>
#include <string>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// Thrown, in Release as in Debug mode, when input data cannot be used. The message gives the file and part, if any,
/// the error, and a remedy.
class Invalid_input : public std::runtime_error
{
public:
  /// An error with this message.
  explicit Invalid_input(const std::string& message) : std::runtime_error(message) {}
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_INVALID_INPUT_H
