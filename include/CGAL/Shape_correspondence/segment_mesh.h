// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEGMENT_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_SEGMENT_MESH_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `segment_mesh()`, those of `CGAL::segmentation_from_sdf_values()`.
struct Segmentation_options
{
  int clusters = 2;         ///< levels of thickness that are distinguished in each connected component, at least 1
  double smoothness = 0.26; ///< weight of short borders between segments, in [0, 1]
};

/// \ingroup PkgShapeCorrespondenceShapes
/// What `segment_mesh()` makes.
struct Mesh_segmentation
{
  Segmented_shape shape;             ///< the parts
  std::size_t pieces_left_out = 0;   ///< number of components and segments without area, which cannot be parts
  std::size_t pieces_kept_whole = 0; ///< number of closed components whose thickness cannot be measured: one part each
};

/// \ingroup PkgShapeCorrespondenceShapes
/// Divides a mesh into parts: its connected components, each closed one divided further into the segments that CGAL's
/// package Triangulated Surface Mesh Segmentation finds by the shape diameter function (Shapira, Shamir and Cohen-Or
/// 2008). Pieces without area are left out, and counted. Part names are `segment_0`, `segment_1`, … The segments are
/// rough compared with a manual segmentation. `up` is the upright direction of the result.
/// \throw Invalid_input if the mesh cannot be used
Mesh_segmentation segment_mesh(const Part_mesh& mesh, const Segmentation_options& options = {},
                               std::string name = "shape", const Point& up = Point(0, 1, 0));

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SEGMENT_MESH_H
