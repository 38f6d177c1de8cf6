// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

// By how much scores are higher than others of the same correspondences, paired, with intervals as of `mean_scores()`.
// Those of a difference are narrower than those of two means suggest, since both are of the same shapes.
// \throw Invalid_input as `mean_scores()`, or if the correspondences are not the same
Evaluation mean_differences(const std::vector<Scored_correspondence>& scores,
                            const std::vector<Scored_correspondence>& others, const Evaluation_options& options);

} // namespace CGAL::Shape_correspondence::internal
