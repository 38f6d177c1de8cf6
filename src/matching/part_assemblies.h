// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Part_matching_options.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// Sets of parts with a common function, which people perceive as one thing; indices in the aligned shape, ascending.
struct Part_assemblies
{
  /// Panels, which are disjoint:
  ///  - A row of at least `Part_matching_options::repetition` parts that a translation maps to one another (slats).
  ///  - The parts that lie flat in one of the four sides of the shape, above its main surface and off the ground, and
  /// are connected to each other, also by way of the support (the boards and rails at the head of a bed).
  ///  - The rings of a chain, see `is_in_chain`.
  std::vector<std::vector<std::size_t>> panels;
  /// The parts that support the main surface: those on the ground, and those without which one of these would lose its
  /// connection to the main surface (the column of a pedestal). The main surface is the lowest horizontal part that
  /// covers enough of the shape as seen from above (a seat, a tabletop, a mattress); empty if there is none.
  std::vector<std::size_t> support;
  /// The support without wide parts on the ground, if there are narrow ones (legs rather than side panels).
  std::vector<std::size_t> legs;
  std::vector<char> is_on_ground; ///< indexed by part
  /// For each part, whether it is in a chain: at least `Part_matching_options::repetition` rings (closed curves) of
  /// similar size, each touching the next. A shape hangs from its chain, whose rings only correspond to those of a
  /// chain.
  std::vector<char> is_in_chain;
  bool has_chain() const { return std::find(is_in_chain.begin(), is_in_chain.end(), 1) != is_in_chain.end(); }
};

/// The assemblies of a shape, by positions, contacts and symmetry groups. O(n (n + c)) for n parts and c contacts.
Part_assemblies part_assemblies(const Aligned_shape& shape, const Part_matching_options& options = {});

} // namespace CGAL::Shape_correspondence
