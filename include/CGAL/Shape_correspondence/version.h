// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_VERSION_H
#define CGAL_SHAPE_CORRESPONDENCE_VERSION_H

/// \file version.h

/// \ingroup PkgShapeCorrespondenceRef
/// The version of the package, as "major.minor.patch".
#define CGAL_SHAPE_CORRESPONDENCE_VERSION "0.1.0"

#endif // CGAL_SHAPE_CORRESPONDENCE_VERSION_H
