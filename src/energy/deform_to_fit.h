// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <vector>

namespace CGAL::Shape_correspondence {

/// Deform-to-fit (paper, section 5): how `source` takes the shape of `target`. Its sample i goes to sample [i] of the
/// target. Centres are aligned, then extremities are matched by proximity: of the 2 directions of a curve, the 8
/// layouts of a sheet and the 2 e of a closed curve the one whose ends, corners or samples have the least sum of
/// squared distances. Where one part is a sheet, the curve counts as a sheet of e equal columns
/// (each of its samples counts e times), so that sample [i] of a target curve is its sample [i] / e. A reference that
/// stays valid; one of few.
const std::vector<int>& deform_to_fit(const Sampled_part& source, const Sampled_part& target);

} // namespace CGAL::Shape_correspondence
