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

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `segment_mesh()`.
struct Segmentation_options
{
  std::size_t patches = 256; ///< number of surface patches that segments are composed of, at least 1
  double probability = 0.5;  ///< least probability, in (0, 1), that merged neighbours belong to one part
  double least_area = 0.01;  ///< share of the area of its component below which a segment joins a neighbour
};

/// \ingroup PkgShapeCorrespondenceShapes
/// The result of `segment_mesh()`.
struct Mesh_segmentation
{
  Segmented_shape shape;             ///< the parts
  std::size_t pieces_left_out = 0;   ///< number of components and segments without area, which cannot be parts
  std::size_t pieces_kept_whole = 0; ///< number of closed components without an interior, one part each
};

/// \ingroup PkgShapeCorrespondenceShapes
/// Divides a mesh into parts: its connected components, each closed one divided further where it is concave or its
/// thickness changes. The surface is cut into patches, which are merged in the order of the probability that neighbours
/// belong to one part. It is high if most of their points see each other through the interior (Asafi, Goren and
/// Cohen-Or 2013), if their common border is not concave, and if they are equally thick, and was fitted to labelled
/// shapes. Pieces without area are left out and counted. Part names are `segment_0`, `segment_1`, … `up` is the upright
/// direction of the result. O(n log n) in the number of triangles, and O(patches² log n).
/// \throw Invalid_input if a coordinate or an index of the mesh is invalid, or an option is out of its range
Mesh_segmentation segment_mesh(const Part_mesh& mesh, const Segmentation_options& options = {},
                               std::string name = "shape", const Point& up = Point(0, 1, 0));

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SEGMENT_MESH_H
