// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_OPTIONS_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// How the energies of connected pairs of parts make up E_d and E_c.
enum class Energy_norm {
  SUM,   ///< sums over the connected pairs (the paper's Eq. 1)
  POOLED ///< E_d: one norm over the rods of all pairs, as many as their samples give, unlifted; E_c: the mean
};

/// \ingroup PkgShapeCorrespondenceOptions
/// A part of the source and a part of the target, by their indices.
struct Part_pair
{
  std::size_t source = 0; ///< index of a part of the source
  std::size_t target = 0; ///< index of a part of the target
};

/// \ingroup PkgShapeCorrespondenceOptions
/// What may be matched and what it costs.
struct Matching_options
{
  /// A cost that nothing outweighs.
  static constexpr double never = std::numeric_limits<double>::infinity();

  Energy_weights weights;              ///< weights of the terms of the energy
  Energy_norm norm = Energy_norm::SUM; ///< how the energies of pairs of parts are summed
  bool cut_curves = true;              ///< offer `Operation::CUT` and `Operation::JOIN` beside splitting and merging
  /// A group may be left unmatched, at this cost for each of its contacts (at least once); `never`: it may not.
  double unmatched_cost = never;
  /// Pairs that correspond, whatever they cost, and the only ones of their parts. Several of one part make it
  /// correspond to several. A search takes these parts out of their symmetry groups and charges no E_s for them.
  std::vector<Part_pair> pinned;
  std::vector<Part_pair> forbidden; ///< pairs that do not correspond
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_OPTIONS_H
