// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "shape/Loose_piece.h"

#include <CGAL/Shape_correspondence/split_parts.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The loose pieces that make up each part.
struct Piece_groups
{
  Disjoint_sets sets;               ///< sets of pieces
  std::vector<std::string> reasons; ///< indexed by piece: why it joined another one; empty if it did not
  std::vector<std::string> kept;    ///< indexed by object: why its several pieces stay together; else empty
};

/// Groups loose pieces into parts, as `split_parts()` documents it for `Part_splitting::AUTO`.
/// \param pieces of all objects, those of an object next to one another
/// \param names of the pieces, for the reasons \param objects number of objects \param size the model's `size_of()`
Piece_groups group_pieces(const std::vector<Loose_piece>& pieces, const std::vector<std::string>& names,
                          std::size_t objects, double size, const Part_splitting_options& options);

} // namespace CGAL::Shape_correspondence::internal
