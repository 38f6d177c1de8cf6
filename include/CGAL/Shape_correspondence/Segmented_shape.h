// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEGMENTED_SHAPE_H
#define CGAL_SHAPE_CORRESPONDENCE_SEGMENTED_SHAPE_H

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/internal/part_mesh.h>

#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// An indexed triangle mesh as read from a file; it may be open, non-manifold or inconsistently oriented.
struct Part_mesh
{
  Points points;              ///< one vertex in each column
  Eigen::Matrix3Xi triangles; ///< one triangle in each column: indices into `points`
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
/// Units and position are arbitrary, with absolute coordinates up to 1e15; the up direction is the only convention.
class Segmented_shape
{
public:
  /// A shape without parts.
  /// \param name name of the shape in messages and files
  /// \param up the upright direction, a unit vector
  explicit Segmented_shape(std::string name = "shape", const Point& up = Point(0, 1, 0));

  /// Builds a shape from a range of pairs (name, triangle mesh).
  /// \tparam NamedMeshRange a range of pairs of a `std::string` and a model of `FaceListGraph`
  /// \param meshes the parts
  /// \param name name of the shape in messages and files
  /// \param up the upright direction, a unit vector
  /// \param np optional named parameters for every mesh, those of `add_mesh()`
  template <typename NamedMeshRange, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  static Segmented_shape from_meshes(const NamedMeshRange& meshes, std::string name = "shape",
                                     const Point& up = Point(0, 1, 0), const NamedParameters& np = NamedParameters())
  {
    Segmented_shape result(std::move(name), up);
    for (const auto& [part_name, mesh] : meshes)
      result.add_mesh(part_name, mesh, np);
    return result;
  }

  /// Builds a shape from one triangle mesh and a map from faces to segment ids, as from
  /// `CGAL::segmentation_from_sdf_values()`: the faces of one id become a part. Parts are in ascending order of ids.
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \tparam SegmentIdMap a model of `ReadablePropertyMap`, face descriptor to an integer
  /// \param mesh the surface of the shape
  /// \param segment_ids the segment of every face
  /// \param name name of the shape in messages and files
  /// \param up the upright direction, a unit vector
  /// \param np an optional sequence of named parameters among the ones listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{part_names}
  ///     \cgalParamDescription{the names of the parts by segment id (`parameters::part_names()`)}
  ///     \cgalParamType{a container with `at(id)`, such as a `std::vector<std::string>` or a
  ///                    `std::map<int, std::string>`}
  ///     \cgalParamDefault{`segment_i` for the id `i`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{the points of the vertices of the mesh}
  ///     \cgalParamType{a model of `ReadablePropertyMap`, vertex descriptor to a point with `x()`, `y()` and `z()`}
  ///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throw Invalid_input if the mesh has no faces or a segment has no name
  template <typename TriangleMesh, typename SegmentIdMap,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  static Segmented_shape from_segmentation(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                                           std::string name = "shape", const Point& up = Point(0, 1, 0),
                                           const NamedParameters& np = NamedParameters())
  {
    const auto segments = internal::meshes_of_segments(
        mesh, [&](auto face) { return get(segment_ids, face); }, internal::vertex_point_map(mesh, np));
    if (segments.empty())
      throw Invalid_input("shape '" + name + "': the mesh has no faces; give a mesh with a surface");
    Segmented_shape result(std::move(name), up);
    for (const auto& [id, segment] : segments)
      result.add_part(internal::part_name(id, np), {segment.points(), segment.triangles()});
    return result;
  }

  /// As above, with the name "shape" and the y axis up.
  template <typename TriangleMesh, typename SegmentIdMap, typename T, typename Tag, typename Base>
  static Segmented_shape from_segmentation(const TriangleMesh& mesh, SegmentIdMap segment_ids,
                                           const CGAL::Named_function_parameters<T, Tag, Base>& np)
  {
    return from_segmentation(mesh, segment_ids, "shape", Point(0, 1, 0), np);
  }

  /// Adds a part.
  /// \throw Invalid_input if the name is empty or taken, an index or a coordinate is invalid (NaN, beyond 1e15),
  /// or the part has no triangle of positive area
  void add_part(std::string name, Part_mesh mesh);

  /// Adds a part given as a triangle mesh; throws like `add_part()`.
  /// \tparam TriangleMesh a model of `FaceListGraph`
  /// \param name the name of the part
  /// \param mesh its surface
  /// \param np an optional named parameter, listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{the points of the vertices of the mesh}
  ///     \cgalParamType{a model of `ReadablePropertyMap`, vertex descriptor to a point with `x()`, `y()` and `z()`}
  ///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  void add_mesh(std::string name, const TriangleMesh& mesh, const NamedParameters& np = NamedParameters())
  {
    auto segments = internal::meshes_of_segments(
        mesh, [](auto) { return 0; }, internal::vertex_point_map(mesh, np));
    add_part(std::move(name), {segments[0].points(), segments[0].triangles()});
  }

  /// Sets the upright direction, which is normalised.
  /// \throw Invalid_input if the direction is zero or not finite
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
  std::unordered_set<std::string> names_; ///< names of the parts
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SEGMENTED_SHAPE_H
