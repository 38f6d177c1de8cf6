// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ABSTRACT_PART_H
#define CGAL_SHAPE_CORRESPONDENCE_ABSTRACT_PART_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>
#include <CGAL/Shape_correspondence/config.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// Options of `abstract_part()` and `abstract_parts()`. Lengths are relative to the diagonal of the part's bounding
/// box.
struct Abstraction_options
{
  double edge_length = 0.02;    ///< target edge length of the remeshing before the flow
  double stop_volume = 0.02;    ///< the meso-skeleton is taken when its volume falls under this fraction of the part's
  int maximum_iterations = 300; ///< of the flow; the bounding box stands in for a part that needs more
  double time_limit = 20;       ///< seconds a part; the bounding box stands in for a part that needs more
  int curve_points = 16;        ///< control points of a curve
  int sheet_points = 8;         ///< control points of a sheet along each side
  /// Called after every part with the number of parts done and their total; from one thread at a time.
  std::function<void(std::size_t, std::size_t)> progress;
};

/// Finds the curve or sheet of one part by mean curvature flow skeletonization, its volume, hull and surface samples
/// (paper, section 3; Tagliasacchi et al. 2012). Never fails on a part that `Segmented_shape` accepts: what the flow
/// cannot treat gets the medial curve or sheet of its bounding box, and the report says so. Deterministic.
Part_abstraction abstract_part(const Shape_part& part, const Abstraction_options& options = {});

/// Finds the abstractions of all parts of a shape, in the frame `frame` (so that turning the shape changes nothing), in
/// world coordinates. The same bits with `Sequential_tag` and `Parallel_tag`.
template <typename ConcurrencyTag = CGAL::Sequential_tag>
std::vector<Part_abstraction> abstract_parts(const Segmented_shape& shape, const Shape_frame& frame,
                                             const Abstraction_options& options = {});

/// Points spread evenly over the surface of a mesh, `n` of them, the same ones for the same mesh.
Points sample_surface(const Part_mesh& mesh, std::size_t n);

/// Volume of the convex hull of points; 0 if they are flat.
double convex_hull_volume(const Points& points);

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/abstract_part_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_ABSTRACT_PART_H
