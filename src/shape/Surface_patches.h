// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The area of a surface and the integrals over its points x: of x (first moment) and of x xᵀ (second moment).
struct Surface_moments
{
  double area = 0;
  Point first = Point::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  Surface_moments& operator+=(const Surface_moments& other)
  {
    area += other.area;
    first += other.first;
    second += other.second;
    return *this;
  }
};

/// A connected set of triangles without creases inside.
struct Surface_patch
{
  Surface_moments moments;
  Eigen::AlignedBox3d box;
  std::size_t object = 0;    ///< index of its object
  std::size_t sheet = 0;     ///< number of its sheet, whose triangles are connected across edges
  std::size_t component = 0; ///< number of its component, whose triangles are connected through vertices
  std::size_t shape = 0;     ///< number that patches of about the same area and principal lengths share
  std::vector<std::array<Point, 3>> triangles{}; ///< triangles of the canonical surface
};

/// The contact of two patches, or of two unions of patches.
struct Patch_contact
{
  double gap = 0;                   ///< distance; 0 where they have a common border
  std::array<double, 2> near{0, 0}; ///< area of each patch within `patch_reach` of the other
  double border = 0;                ///< length of the common border
  double flat_border = 0;           ///< integral over the common border of the cosine of the angle between the normals
  double concave_border = 0;        ///< length of the part of the border at which the surface is concave
  bool has_common_places = false;   ///< whether the patches are of different sheets and have common vertices

  Patch_contact& operator+=(const Patch_contact& other);
  Patch_contact reversed() const;
};

/// A model divided at creases, in a frame with y up in which its box begins at the origin and has diagonal 1.
struct Surface_patches
{
  struct Contact
  {
    std::size_t first, second; ///< indices of patches, the lower one first
    Patch_contact contact;
  };

  Point sides = Point::Ones();                        ///< lengths of the sides of the box
  double area = 0;                                    ///< area of all patches
  std::vector<Surface_patch> patches;                 ///< at least one
  std::vector<Contact> contacts;                      ///< contacts of patches that may be merged
  std::vector<std::vector<std::size_t>> of_triangles; ///< indexed by object and triangle: the index of its patch
};

constexpr double patch_reach = 0.02; ///< greatest distance of patches that touch, over the diagonal

constexpr std::size_t most_patches = 3000; ///< if there are more, neither measures nor contacts are found

/// Divides the objects into sheets, and these at creases of 60 degrees or more; small patches join the patch of their
/// sheet with which they have the longest border. O(n log n) in the number of triangles.
/// \param axes the rows are the axes of the frame, the second one up
/// \param materials indexed by object and triangle; patches end where the material changes; empty if it never does
/// \pre at least one object has area
Surface_patches surface_patches(const Segmented_shape& objects, const Eigen::Matrix3d& axes,
                                const std::vector<std::vector<int>>& materials = {});

} // namespace CGAL::Shape_correspondence::internal
