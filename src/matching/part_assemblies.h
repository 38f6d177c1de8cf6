// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// A regular arrangement, a row or a chain, has so many parts or more; a symmetry group of so many may correspond to
/// one part as a whole.
constexpr std::size_t minimum_repetition = 3;

/// Sets of parts of one shape with a common function, which people take as one thing; by index of the aligned shape,
/// ascending.
struct Part_assemblies
{
  /// Panels; no part is in two of them.
  ///  - A row of `minimum_repetition` or more parts that a translation maps to one another, with its frame: the parts
  ///  in
  ///    the plane of an upright row that are connected to it and extend little further (the rails and posts of a back
  ///    of slats). What stands on the ground or is no higher than the main surface frames nothing above it, and no row
  ///    is in the frame of another.
  ///  - The parts that lie flat in one of the four sides of the shape, above its main surface and off the ground,
  ///    connected by each other or the support (the boards and rails at the head of a bed).
  ///  - A chain.
  std::vector<std::vector<std::size_t>> panels;
  /// The parts that support the main surface: those on the ground, and those without which one of these would lose its
  /// connection to the main surface (the column of a pedestal). Empty where there is no main surface.
  std::vector<std::size_t> support;
  /// The support without the wide parts on the ground, where there are narrow ones (legs rather than side panels).
  std::vector<std::size_t> legs;
  std::vector<char> is_on_ground; ///< by part
  /// By part, whether it is in a chain: one of at least `minimum_repetition` rings (closed curves) of like size, of
  /// which each touches the next.
  std::vector<char> is_in_chain;
  /// The main surface is the lowest horizontal part that covers enough of the shape as seen from above (a seat, a
  /// tabletop, a mattress).
  bool has_main_surface = false;
};

/// The assemblies of a shape, by places, contacts and symmetry groups alone. O(n (n + c)) for n parts and c contacts.
Part_assemblies part_assemblies(const Aligned_shape& shape);

} // namespace CGAL::Shape_correspondence
