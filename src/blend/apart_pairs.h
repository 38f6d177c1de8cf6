// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;
class Blend_structure;
struct Unlike_pairs;

/// Finds parts that come off what they touch on the way, and takes out the pairs to whom most happens of these and of
/// what they touch, with their mirror images. Pairs to whom little happens stay.
/// \param unlike gets the pairs
/// \return whether there are any
bool take_apart_pairs(const Blend_stage& stage, const Blend_structure& blend, Unlike_pairs& unlike);

} // namespace CGAL::Shape_correspondence::internal
