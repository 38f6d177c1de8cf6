// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Where a part is carried.
struct Root
{
  Point at;
  std::vector<std::size_t> carriers; ///< what carries it there, pieces of one part; none if the ground does
};

/// A part of a shape that goes, and its roots, where it touches what is before it on the shortest way to what stays.
struct Carried_part
{
  std::size_t part;
  std::vector<Root> roots; ///< carriers are parts of the shape
  std::size_t chain;       ///< the same number for parts that go and touch each other, directly or not
  bool joins;              ///< whether its chain joins parts that nothing else joins
};

/// The parts of a shape that go, those that carry others before them. What is large enough carries first, then the
/// ground what is on it, then what is small; what touches nothing that is found grows out of the ground below it.
/// \param stays by part
std::vector<Carried_part> carried_parts(const Blend_stage& stage, int end, const std::vector<char>& stays);

} // namespace CGAL::Shape_correspondence::internal
