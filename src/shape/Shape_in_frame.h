// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A shape whose surfaces are canonical, and its frame: the same to the bit whatever the order of its parts and of
/// their triangles.
struct Shape_in_frame
{
  explicit Shape_in_frame(const Segmented_shape& given);

  Segmented_shape shape;
  Shape_frame frame;
};

/// The frame of a surface. \param surface points sampled by area, for its symmetry \param vertices for its exact
/// extents
Shape_frame frame_of_samples(const Points& surface, const Points& vertices, const Point& up);

/// The frame of a shape of canonical surfaces, from fewer samples.
Shape_frame rough_frame(const std::vector<const Part_mesh*>& surfaces, const Point& up);

/// The frames that a shape would have with x, y or z up.
std::array<Shape_frame, 3> frames_by_axis(const Segmented_shape& shape);

} // namespace CGAL::Shape_correspondence::internal
