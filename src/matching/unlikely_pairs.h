// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Correspondence.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Removes and returns the pairs of confidence below `least`, but none without a confidence; updates unmatched parts.
std::vector<Part_correspondence> remove_unlikely_pairs(Correspondence& correspondence, double least);

} // namespace CGAL::Shape_correspondence::internal
