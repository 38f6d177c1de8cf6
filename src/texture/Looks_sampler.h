// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <array>
#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

/// The colours of points of a shape's surface, in linear light.
class Looks_sampler
{
public:
  /// \param appearance is kept by reference \param neutral the colour where nothing is known
  Looks_sampler(const Shape_appearance& appearance, const Eigen::Vector3d& neutral);

  /// Whether anything is known of a part.
  bool is_known(std::size_t part) const;

  /// \param weights barycentric coordinates in the triangle
  Eigen::Vector3d operator()(std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights) const;

private:
  Eigen::Vector3d texture_at(const Texture& texture, const Eigen::Vector2d& at) const;

  const Shape_appearance& appearance_;
  Eigen::Vector3d neutral_;
  std::array<double, 256> linear_; ///< by byte
};

} // namespace CGAL::Shape_correspondence::internal
