// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <memory>

namespace CGAL::Shape_correspondence::internal {

class Flat_faces;

/// A surface in triangles that depend on the surface alone, not on how a file divides it into triangles, nor on
/// their order: connected triangles of a plane become one face, of which points within straight edges are left out, and
/// which is divided anew; points and triangles are sorted by their place. Faces that cannot be divided are kept.
class Canonical_surface
{
public:
  /// \param mesh kept by reference
  /// \param tolerance greatest distance from a plane or a line that counts as rounding noise
  Canonical_surface(const Part_mesh& mesh, double tolerance);

  /// \param axes of the shape; ties are settled by directions along them, so that the result turns with the shape
  Part_mesh mesh(const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity()) const;

private:
  const Part_mesh* given_;
  std::shared_ptr<const Flat_faces> faces_;
};

inline Part_mesh canonical_surface(const Part_mesh& mesh, double tolerance)
{
  return Canonical_surface(mesh, tolerance).mesh();
}

/// The `tolerance` of canonical surfaces for a shape of this size. Many files have coordinates with five decimals.
inline double flatness_tolerance(double size) { return 1.5e-5 * size; }

/// The canonical surface of every part of a shape. \param axes of the shape; the second one is up, if that is known
std::vector<Canonical_surface> canonical_surfaces(const Segmented_shape& shape,
                                                  const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());

/// A shape with the canonical surfaces of its parts.
Segmented_shape canonical_shape(const Segmented_shape& shape, const std::vector<Canonical_surface>& surfaces,
                                const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());

} // namespace CGAL::Shape_correspondence::internal
