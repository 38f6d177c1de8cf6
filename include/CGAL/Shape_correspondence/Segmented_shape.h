// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEGMENTED_SHAPE_H
#define CGAL_SHAPE_CORRESPONDENCE_SEGMENTED_SHAPE_H

#include <CGAL/Shape_correspondence/Points.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// An indexed triangle mesh as files hold them: open, non-manifold and badly oriented ones included.
struct Part_mesh
{
  Points points;              ///< a vertex a column
  Eigen::Matrix3Xi triangles; ///< a triangle a column, indices into `points`
};

/// \ingroup PkgShapeCorrespondenceShapes
/// A named part of a shape.
struct Shape_part
{
  std::string name; ///< name of the part, unique in the shape
  Part_mesh mesh;   ///< its surface
};

/// \ingroup PkgShapeCorrespondenceShapes
/// A shape that is segmented into named parts, each a triangle mesh; the input of the package.
///
/// Units and position are arbitrary; the up direction is the only convention.
class Segmented_shape
{
public:
  /// \param name names the shape in messages and files
  /// \param up the upright direction, a unit vector
  explicit Segmented_shape(std::string name = "shape", const Point& up = Point::UnitY());

  /// Builds a shape of a range of pairs (name, triangle mesh), where a mesh is a model of `FaceListGraph`.
  template <typename NamedMeshRange>
  static Segmented_shape from_meshes(const NamedMeshRange& meshes, std::string name = "shape",
                                     const Point& up = Point::UnitY());

  /// Builds a shape of one triangle mesh and a map from faces to segment ids, as `CGAL::segmentation_from_sdf_values()`
  /// makes it: the faces of id `i` become the part `segment_i`, parts in ascending order of their ids.
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \tparam SegmentIdMap a model of `ReadablePropertyMap`, face descriptor to an integer
  template <typename TriangleMesh, typename SegmentIdMap>
  static Segmented_shape from_segmentation(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                                           std::string name = "shape", const Point& up = Point::UnitY());

  /// Adds a part.
  /// \throw Invalid_input if the name is empty or taken, an index or a coordinate is invalid (NaN, infinite),
  /// or the part has no triangle of positive area
  void add_part(std::string name, Part_mesh mesh);

  /// Adds a part given as a triangle mesh, a model of `FaceListGraph`; throws as the other overload does.
  template <typename TriangleMesh>
  void add_mesh(std::string name, const TriangleMesh& mesh);

  /// Says which way is up. \throw Invalid_input if the direction is zero or not finite
  void set_up(const Point& up);

  /// The name of the shape.
  const std::string& name() const { return name_; }
  /// The upright direction, a unit vector.
  const Point& up() const { return up_; }
  /// The parts in the order in which they were added.
  const std::vector<Shape_part>& parts() const { return parts_; }

private:
  std::string name_;
  Point up_;
  std::vector<Shape_part> parts_;
};

} // namespace Shape_correspondence
} // namespace CGAL

#include <CGAL/Shape_correspondence/internal/Part_mesh_builder.h>
#endif // CGAL_SHAPE_CORRESPONDENCE_SEGMENTED_SHAPE_H
