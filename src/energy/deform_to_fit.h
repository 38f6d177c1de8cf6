// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Sampled_part.h"

#include <CGAL/Shape_correspondence/Matching_options.h>

#include <vector>

namespace CGAL::Shape_correspondence {

/// Deform-to-fit (paper, section 5): where the samples of `source` go when it takes the shape of `target`. By samples,
/// these are the target's in the order of `match_extremities()`; by extremities, those of the source moved by what is
/// interpolated between the displacements of ends or corners. If one of the two is a sheet, these are e² samples.
Points deform_to_fit(const Sampled_part& source, const Sampled_part& target,
                     Deform_to_fit fit = Deform_to_fit::SAMPLES);

/// The first step of it: sample i of the source goes to sample [i] of the target. Centres are aligned, then extremities
/// are matched by proximity: of the 2 directions of a curve, the 8 layouts of a sheet and the 2 e of a closed curve the
/// one whose ends, corners or samples have the least sum of squared distances. If one part is a sheet, a curve counts
/// as a sheet of e equal columns: [i] is its sample [i] / e. Refers to a static table.
const std::vector<int>& match_extremities(const Sampled_part& source, const Sampled_part& target);

/// The samples of the target in such an order.
Points ordered_samples(const Sampled_part& target, const std::vector<int>& order);

/// Every sample `repeats` times in a row: a curve as a sheet of equal columns.
Points repeated(const Points& samples, int repeats);

} // namespace CGAL::Shape_correspondence
