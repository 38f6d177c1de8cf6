// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/library_call.h"
#include "shape/meshes.h"
#include "shape/oriented_box.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/alpha_wrap_3.h>

#include <vector>

namespace CGAL::Shape_correspondence {

Part_mesh Shape_blend::solid(double t, double detail) const
{
  constexpr double least_detail = 0.001;
  constexpr double offset = 0.1; // distance of the wrap from the surface, over the detail
  if (!(detail >= least_detail && detail <= 1))
    throw Invalid_input("Shape_blend: the detail of a solid must be between 0.001 and 1");
  const Segmented_shape shape = (*this)(t);
  std::vector<const Part_mesh*> meshes;
  for (const Shape_part& part : shape.parts())
    meshes.push_back(&part.mesh);
  const Part_mesh all = internal::joined(meshes);
  const internal::Triangle_soup soup = internal::to_soup(all);
  const double alpha = detail * internal::diagonal(all.points);
  const auto wrap = [&] {
    internal::Halfedge_mesh result;
    CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, offset * alpha, result);
    const bool is_solid = CGAL::is_closed(result) && CGAL::Polygon_mesh_processing::is_outward_oriented(result);
    return is_solid ? result : internal::Halfedge_mesh();
  };
  const internal::Halfedge_mesh result =
      internal::library_call("wrap of a blend", wrap, [] { return internal::Halfedge_mesh(); });
  if (result.is_empty())
    throw Invalid_input("Shape_blend: the shape at this time has no closed surface around it; repair its parts");
  return internal::to_part_mesh(result);
}

} // namespace CGAL::Shape_correspondence
