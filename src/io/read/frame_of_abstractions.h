// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The frame of a shape of which nothing but the abstractions is known.
inline Shape_frame frame_of_abstractions(const std::vector<Part_abstraction>& parts, const Point& up)
{
  constexpr int samples_along = 6; // of a curve; of a sheet along each side
  Points all(3, 0);
  for (const Part_abstraction& part : parts) {
    const Points samples = sample(part, samples_along);
    all.conservativeResize(Eigen::NoChange, all.cols() + samples.cols());
    all.rightCols(samples.cols()) = samples;
  }
  return compute_shape_frame(all, up);
}

} // namespace CGAL::Shape_correspondence::IO
