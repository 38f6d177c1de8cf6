// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_PART_ASSEMBLIES_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_PART_ASSEMBLIES_H

#include "structure/align_shapes.h"

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// Parts of one shape that do one thing together, so that people take them as a whole; by index of the aligned shape,
/// ascending.
struct Part_assemblies
{
  /// Sets of parts that make up a panel. Rows of `whole_group_size` or more parts that a translation takes to one
  /// another, with their frames: the parts in the plane of an upright row that are connected to it and reach little
  /// further (the rails and posts of a back of slats). What stands on the ground or is level with the deck frames
  /// nothing above it, and a row frames no other. And the parts that lie flat in one of the four sides of the shape,
  /// above its deck and off the ground, connected by each other or the support (the boards and rails at the head of a
  /// bed). And chains. No part is in two panels.
  std::vector<std::vector<std::size_t>> panels;
  /// What carries the deck, which is the lowest flat part that covers enough of the shape as seen from above (a seat, a
  /// tabletop, a mattress): the parts on the ground, and those without which one of them would lose its connection to
  /// the deck (the column of a pedestal). Empty where there is no deck.
  std::vector<std::size_t> support;
  /// The support without the wide parts on the ground, where there are narrow ones (legs rather than side panels).
  std::vector<std::size_t> legs;
  std::vector<char> is_on_ground; ///< by part
  /// By part, whether it is a link of a chain: one of at least `whole_group_size` closed curves of like size, of which
  /// each touches the next.
  std::vector<char> is_link;
  bool has_deck = false;
};

/// A symmetry group of so many parts or more may stand as a whole for one part.
constexpr std::size_t whole_group_size = 3;

/// The assemblies of a shape, by places, contacts and symmetry groups alone. O(n (n + c)) for n parts and c contacts.
Part_assemblies part_assemblies(const Aligned_shape& shape);

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_PART_ASSEMBLIES_H
