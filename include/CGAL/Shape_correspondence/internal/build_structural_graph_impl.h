// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BUILD_STRUCTURAL_GRAPH_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BUILD_STRUCTURAL_GRAPH_IMPL_H

#include <CGAL/Real_timer.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <Eigen/Geometry>

#include <utility>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr std::size_t FRAME_SAMPLES = 4096;    ///< of a whole shape, to find its frame
constexpr std::size_t LEAST_FRAME_SAMPLES = 4; ///< of every part, however small

inline void check_number_of_parts(const std::string& name, std::size_t parts)
{
  if (parts < 2)
    throw Invalid_input("shape '" + name + "': has " + (parts == 0 ? "no part" : "only one part") +
                        "; correspondences need a shape that is segmented into two parts or more");
}

inline double surface_area(const Part_mesh& mesh)
{
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Point p = mesh.points.col(mesh.triangles(0, t));
    const Point u = Point(mesh.points.col(mesh.triangles(1, t))) - p;
    const Point v = Point(mesh.points.col(mesh.triangles(2, t))) - p;
    sum += u.cross(v).norm() / 2;
  }
  return sum;
}

/// Points spread over the whole shape, each part with its share of the area.
inline Points sample_shape(const Segmented_shape& shape)
{
  double total = 0;
  for (const Shape_part& part : shape.parts())
    total += surface_area(part.mesh);
  Points result(3, 0);
  for (const Shape_part& part : shape.parts()) {
    const double share = FRAME_SAMPLES * surface_area(part.mesh) / total;
    const std::size_t n = std::max(LEAST_FRAME_SAMPLES, static_cast<std::size_t>(share + 0.5));
    const Points samples = sample_surface(part.mesh, n);
    const Eigen::Index before = result.cols();
    result.conservativeResize(3, before + samples.cols());
    result.rightCols(samples.cols()) = samples;
  }
  return result;
}

/// Groups, unless given, and the graph.
inline Structural_graph assemble(Shape_structure shape, std::vector<Part_group> groups,
                                 const Structure_options& options)
{
  if (groups.empty()) groups = detect_symmetry_groups(shape.parts, shape.frame, options.symmetry);
  return make_structural_graph(std::move(shape), std::move(groups));
}

} // namespace internal

template <typename ConcurrencyTag>
Structural_graph build_structural_graph(const Segmented_shape& shape, const Structure_options& options,
                                        Structure_times* times)
{
  internal::check_number_of_parts(shape.name(), shape.parts().size());
  CGAL::Real_timer timer;
  timer.start();
  Shape_structure result;
  result.name = shape.name();
  result.frame = compute_shape_frame(internal::sample_shape(shape), shape.up());
  const double before = timer.time();
  result.parts = abstract_parts<ConcurrencyTag>(shape, result.frame, options.abstraction);
  const double abstraction = timer.time() - before;
  result.contacts = detect_contacts(shape, result.parts, result.frame, options.contacts, result.warnings);
  Structural_graph graph = internal::assemble(std::move(result), {}, options);
  if (times) *times = {abstraction, timer.time() - abstraction};
  return graph;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE
Structural_graph complete_structural_graph(Shape_structure shape, std::vector<Part_group> groups,
                                           const Structure_options& options)
{
  internal::check_number_of_parts(shape.name, shape.parts.size());
  if (shape.contacts.empty())
    shape.contacts = detect_contacts(shape.parts, shape.frame, options.contacts, shape.warnings);
  return internal::assemble(std::move(shape), std::move(groups), options);
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BUILD_STRUCTURAL_GRAPH_IMPL_H
