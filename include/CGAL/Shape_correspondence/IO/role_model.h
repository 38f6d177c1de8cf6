// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_ROLE_MODEL_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_ROLE_MODEL_H

#include <CGAL/Shape_correspondence/Role_model.h>

#include <memory>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// \ingroup PkgShapeCorrespondenceIO
/// Writes a role model into the file `path`, completely or not at all, with a checksum.
/// \throw Invalid_input if the file cannot be written
void write_role_model(const std::string& path, const Role_model& model);

/// \ingroup PkgShapeCorrespondenceIO
/// Reads the file `path` written by `write_role_model()`. \throw Invalid_input if there is no such file, or it is
/// damaged or of another version; the message names the file
Role_model read_role_model(const std::string& path);

/// \ingroup PkgShapeCorrespondenceIO
/// The role model that comes with the package, for airplanes, beds, cars, chairs, lamps, plants, shelves, sofas, tables
/// and velocipedes, read once. `data/roles/manifest.json` lists the training shapes and its accuracy.
std::shared_ptr<const Role_model> shipped_role_model();

} // namespace CGAL::Shape_correspondence::IO

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_ROLE_MODEL_H
