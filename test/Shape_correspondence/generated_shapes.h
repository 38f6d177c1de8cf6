// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Converts meshes and assemblies of the generator to meshes and shapes of the library.
#ifndef SHAPE_CORRESPONDENCE_TEST_GENERATED_SHAPES_H
#define SHAPE_CORRESPONDENCE_TEST_GENERATED_SHAPES_H

#include "generator/models.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace generated_shapes {

namespace gen = CGAL::Shape_correspondence::generator;

inline CGAL::Shape_correspondence::Part_mesh mesh_of(const gen::Mesh& mesh)
{
  CGAL::Shape_correspondence::Part_mesh result;
  result.points.resize(3, mesh.points.size());
  result.triangles.resize(3, mesh.faces.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    result.points.col(i) = mesh.points[i];
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    result.triangles.col(i) << mesh.faces[i][0], mesh.faces[i][1], mesh.faces[i][2];
  return result;
}

inline CGAL::Shape_correspondence::Segmented_shape shape_of(const gen::Assembly& assembly)
{
  CGAL::Shape_correspondence::Segmented_shape shape(assembly.name);
  for (const gen::Part& part : assembly.parts)
    shape.add_part(part.name, mesh_of(part.solid.mesh));
  return shape;
}

} // namespace generated_shapes

#endif // SHAPE_CORRESPONDENCE_TEST_GENERATED_SHAPES_H
