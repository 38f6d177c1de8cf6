// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/match_groups.h"

namespace CGAL::Shape_correspondence {

/// The `index`-th of `count` equally long segments of a curve, sampled like a part (paper, section 5).
/// \pre the part is an open curve
Sampled_part segment(const Sampled_part& curve, int index, int count);

/// The label with curves cut (paper, section 5): a source curve that turns into several curves is cut into as many
/// equally long segments, each of which turns into one (`Operation::CUT`); several curves that turn into one become its
/// segments (`Operation::JOIN`). Segments and curves are matched by their places in the groups' unit boxes. The label
/// itself where there is nothing to cut.
Group_label cut_curves(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                       const Group_label& label);

} // namespace CGAL::Shape_correspondence
