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

/// What to transfer, and the output.
struct Transfer_request
{
  std::string output; ///< FILE.glb, FILE.obj or FILE.ply
  std::string labels; ///< `parts`, or a file of labels of the source; empty: transfer the appearance
  Transfer_options options;
};

/// The result of a transfer.
struct Transferred_looks
{
  Transferred_appearance result;
  std::vector<std::string> labels; ///< names; empty: the appearance was transferred
  std::vector<std::string> warnings;
};

/// Transfers the appearance or labels along a correspondence, and writes the target with them. \throw Invalid_input
Transferred_looks transfer_looks(Loaded_shape& source, Loaded_shape& target, const Correspondence& correspondence,
                                 const Transfer_request& request);

/// Writes what every target part received, in the format `shape_correspondence/transfer`, version 1.
void write_transfer_json(std::ostream& out, const Loaded_shape& source, const Loaded_shape& target,
                         const Transfer_request& request, const Transferred_looks& transferred);

} // namespace CGAL::Shape_correspondence::cli
