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

} // namespace

Structural_graph outline_graph(const Segmented_shape& given)
{
  const Shape_in_frame placed(given);
  const Segmented_shape& shape = placed.shape;
  Shape_structure result;
  result.name = shape.name();
  result.frame = placed.frame;
  std::vector<Part_group> groups;
  for (const Shape_part& part : shape.parts()) {
    groups.emplace_back().parts = {result.parts.size()};
    result.parts.push_back(outline(part));
  }
  result.contacts = detect_contacts<CGAL::Sequential_tag>(shape, result.parts, result.frame, {}, result.warnings);
  return make_structural_graph(std::move(result), std::move(groups));
}

} // namespace CGAL::Shape_correspondence::internal
