// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_structure.h"

#include <functional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// How a part changes: it morphs, comes or goes by itself, or is exchanged in the first or second of two steps.
enum class Exchange_step { NONE, FIRST, SECOND };

/// By part, how it changes.
///
/// Parts are *exchanged* if they take the place of others, or leave it to them: if groups, touches, and places that are
/// the same join them with parts of both ends. A *group* changes in one step: parts that correspond, mirror images,
/// what stands on the ground, and old and new parts without counterpart that hold on to one place.
///
/// Between the steps there is a *mixed shape*: new parts of the groups that change first, old parts of the others, and
/// all that is matched. It costs as much, by size, as old and new parts are in one place or have left a place empty,
/// have come off what held them, or hang together with nothing, and as there are holes in it. It gains a share of what
/// changes in the lesser step, which must not be too little. The steps with the least cost are found by local search,
/// from steps in order of height. If no mixed shape costs less than either of both ends, all is in the second step.
/// \param progress called before every search, with the share done; `false` ends it, and the best so far is taken
std::vector<Exchange_step> exchange_steps(const Blend_structure& blend, const std::function<bool(double)>& progress);

} // namespace CGAL::Shape_correspondence::internal
