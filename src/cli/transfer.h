// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// What is to be transferred, and where to.
struct Transfer_request
{
  std::string output; ///< FILE.glb, FILE.obj or FILE.ply
  std::string labels; ///< `parts`, or a file of labels of the source; empty: looks
  Transfer_options options;
};

/// What was transferred.
struct Transferred_looks
{
  Transferred_appearance result;
  std::vector<std::string> labels; ///< names; empty: looks were transferred
  std::vector<std::string> warnings;
};

/// Transfers looks or labels along a correspondence and writes the target with them.
/// \throw Invalid_input
Transferred_looks transfer_looks(Loaded_shape& source, Loaded_shape& target, const Correspondence& correspondence,
                                 const Transfer_request& request);

/// Writes what every target part got, in the format `shape_correspondence/transfer`, version 1.
void write_transfer_json(std::ostream& out, const Loaded_shape& source, const Loaded_shape& target,
                         const Transfer_request& request, const Transferred_looks& transferred);

} // namespace CGAL::Shape_correspondence::cli
