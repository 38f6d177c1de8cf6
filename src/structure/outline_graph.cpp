// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "structure/outline_graph.h"
#include "shape/Shape_in_frame.h"
#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/detect_contacts.h>

#include <Eigen/Geometry>

#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

Part_abstraction outline(const Shape_part& part)
{
  const Part_mesh& mesh = part.mesh;
  Part_abstraction result;
  result.name = part.name;
  Curve diagonal;
  diagonal.points.resize(3, 2);
  diagonal.points << mesh.points.rowwise().minCoeff(), mesh.points.rowwise().maxCoeff();
  result.geometry = diagonal;
  result.surface = sample_surface(mesh, surface_samples);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Point p = mesh.points.col(mesh.triangles(0, t)), q = mesh.points.col(mesh.triangles(1, t)),
                r = mesh.points.col(mesh.triangles(2, t));
    result.area += (q - p).cross(r - p).norm() / 2;
  }
  return result;
}

/// The shape without contacts.
Shape_structure outlines(const Segmented_shape& shape, const Shape_frame& frame)
{
  Shape_structure result;
  result.name = shape.name();
  result.frame = frame;
  for (const Shape_part& part : shape.parts())
    result.parts.push_back(outline(part));
  return result;
}

Structural_graph graph_of_parts(Shape_structure shape)
{
  std::vector<Part_group> groups(shape.parts.size());
  for (std::size_t i = 0; i < groups.size(); ++i)
    groups[i].parts = {i};
  return make_structural_graph(std::move(shape), std::move(groups));
}

} // namespace

Structural_graph outline_graph(const Segmented_shape& given)
{
  const Shape_in_frame placed(given);
  Shape_structure result = outlines(placed.shape, placed.frame);
  result.contacts =
      detect_contacts<CGAL::Sequential_tag>(placed.shape, result.parts, result.frame, {}, result.warnings);
  return graph_of_parts(std::move(result));
}

Structural_graph outline_graph(const Segmented_shape& shape, const Shape_frame& frame,
                               const std::set<std::array<std::size_t, 2>>& touching)
{
  Shape_structure result = outlines(shape, frame);
  for (const std::array<std::size_t, 2>& parts : touching)
    result.contacts.push_back({parts, {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()}, {}});
  return graph_of_parts(std::move(result));
}

} // namespace CGAL::Shape_correspondence::internal
