// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/match_groups.h"

#include <array>

namespace CGAL::Shape_correspondence {

/// The `index`-th of `count` equally long segments of a curve, sampled like a part (paper, section 5).
/// \pre the part is an open curve
Sampled_part segment(const Sampled_part& curve, int index, int count);

/// A rectangle of a sheet, sampled like a part. \pre the part is a sheet
Sampled_part rectangle(const Sampled_part& sheet, const std::array<double, 2>& low, const std::array<double, 2>& high);

/// The label after cutting curves (paper, section 5): a source curve that turns into several curves is cut into as many
/// equally long segments, each of which turns into one (`Operation::CUT`); several curves that turn into one become its
/// segments (`Operation::JOIN`). Segments and curves are matched by their positions in the groups' unit boxes.
/// Unchanged if there is nothing to cut.
Group_label cut_curves(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                       const Group_label& label);

/// Splits and merges sheets (paper, section 5, Figure 7c): a source sheet that turns into several parts is divided
/// among them, and a target sheet that several parts turn into is divided among those, by their arrangement along it.
/// The map of points divides parts in the same way (`divide_box()`).
void divide_sheets(const Aligned_shape& source, const Aligned_shape& target, Group_label& label);

} // namespace CGAL::Shape_correspondence
