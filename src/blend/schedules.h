// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_structure.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <functional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// When a part changes: in the first or second step of an exchange, or (`NONE`) by morphing, growing or shrinking.
enum class Exchange_step { NONE, FIRST, SECOND };

/// A part's step of exchange, and the order in which the parts of a step change.
struct Exchange
{
  Exchange_step step = Exchange_step::NONE;
  double order = 0.5; ///< from 0 to 1, from the ground up; equal for parts in one place
};

/// For each part, how it is exchanged.
///
/// Parts are *exchanged* if they replace others or are replaced by them: if groups, contacts and shared places connect
/// them with parts of both ends. A *group* changes in one step: parts that correspond, mirror images, all parts on the
/// ground, and old and new parts without counterpart that are attached to the same place.
///
/// Between the steps there is a *mixed shape*: new parts of the groups that change first, old parts of the others, and
/// all matched parts. Its cost is the total size of old and new parts that are in the same place or have left a place
/// empty, that are detached from all that they touched, or that are not connected to the rest, plus a cost for holes.
/// The share that changes in the smaller step reduces the cost, and must not be too small. The steps of least cost are
/// found by local search, starting from steps in order of height. If no mixed shape costs less than both ends,
/// everything is in the second step.
/// \param progress called before every search with the share done; `false` ends the search with the best steps so far
std::vector<Exchange> exchange_steps(const Blend_structure& blend, const std::function<bool(double)>& progress);

bool have_same_times(const std::vector<Blend_task>& a, const std::vector<Blend_task>& b);

/// All schedules with their qualities by samples of their in-between shapes, the best one first.
std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options);

} // namespace CGAL::Shape_correspondence::internal
