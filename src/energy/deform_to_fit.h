// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Sampled_part.h"

#include <CGAL/Shape_correspondence/Energy_options.h>

#include <vector>

namespace CGAL::Shape_correspondence {

/// Deform-to-fit (paper, section 5): the positions of the samples of `source` after it takes the shape of `target`.
/// With `SAMPLES` these are the target's samples in the order of `match_extremities()`; with `EXTREMITIES`, the
/// source's samples displaced by interpolation between its ends or corners. If one part is a sheet, there are e²
/// samples.
Points deform_to_fit(const Sampled_part& source, const Sampled_part& target,
                     Deform_to_fit fit = Deform_to_fit::SAMPLES);

/// The first step of deform-to-fit: sample i of the source goes to sample `result[i]` of the target. After the centres
/// are aligned, extremities are matched by proximity: of the 2 directions of a curve, the 8 layouts of a sheet or the
/// 2 e orders of a closed curve, the one with the least sum of squared distances of ends, corners or samples. If one
/// part is a sheet, a curve counts as a sheet of e equal columns: sample j of that sheet is sample j / e of the curve.
/// Refers to a static table.
const std::vector<int>& match_extremities(const Sampled_part& source, const Sampled_part& target);

Points ordered_samples(const Sampled_part& target, const std::vector<int>& order);

/// Every sample repeated `repeats` times in a row, as for a curve that counts as a sheet of equal columns.
Points repeated(const Points& samples, int repeats);

} // namespace CGAL::Shape_correspondence
