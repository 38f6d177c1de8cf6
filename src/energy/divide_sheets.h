// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/match_groups.h"

namespace CGAL::Shape_correspondence {

/// A rectangle of a sheet, sampled like a part. \pre the part is a sheet
Sampled_part rectangle(const Sampled_part& sheet, const std::array<double, 2>& low, const std::array<double, 2>& high);

/// Splits and merges sheets (paper, section 5, Figure 7c): a source sheet that turns into several parts is divided
/// among them, and a target sheet that several parts turn into among those, by their arrangement along it. The map of
/// points divides parts in the same way (`divide_box()`).
void divide_sheets(const Aligned_shape& source, const Aligned_shape& target, Group_label& label);

} // namespace CGAL::Shape_correspondence
