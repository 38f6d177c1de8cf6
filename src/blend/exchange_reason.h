// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// What is wrong with the surfaces of a matched part on their way, where it is worst, as `Blend_quality` measures it.
struct Surface_fault
{
  double torn = 0;       ///< area
  double torn_share = 0; ///< of the surface
  double thinning = 0;
};

/// Of the surface that there is, at some times.
Surface_fault surface_fault(const Blend_part& part);

/// Which parts are better exchanged, and why: those that are thin, those a large share of which is torn, and of the
/// others those that are torn most, until little of the whole surface is.
std::vector<Blend_exchange> exchanges(const std::vector<Blend_part>& parts);

/// By what share a surface of a part is thinner than the part's surfaces at the ends, or than what is left of them.
/// \param remaining of an unmatched part, how much of it there is
double thinning_of(const Blend_part& part, const Surface_extent& extent, double remaining);

} // namespace CGAL::Shape_correspondence::internal
