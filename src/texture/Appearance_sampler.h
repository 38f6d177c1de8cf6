// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The value at a point of a triangle, interpolated from its corners. \param weights barycentric coordinates
template <typename Number, typename Vector>
auto value_at(const std::vector<Vector>& of_corners, std::size_t triangle, const Eigen::Vector3d& weights)
{
  Eigen::Matrix<Number, Vector::RowsAtCompileTime, 1> result;
  result.setZero();
  for (std::size_t k = 0; k < 3; ++k)
    result += Number(weights[Eigen::Index(k)]) * of_corners[3 * triangle + k].template cast<Number>();
  return result;
}

/// Samples the colours of a shape's surface, in linear light.
class Appearance_sampler
{
public:
  /// \param appearance kept by reference \param neutral colour of parts without an appearance
  Appearance_sampler(const Shape_appearance& appearance, const Eigen::Vector3d& neutral);

  /// Whether a part has an appearance.
  bool is_known(std::size_t part) const;

  /// The colour of a point. \param weights its barycentric coordinates in the triangle
  Eigen::Vector3d operator()(std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights) const;

private:
  Eigen::Vector3d texture_at(const Texture& texture, const Eigen::Vector2d& at) const;

  const Shape_appearance& appearance_;
  Eigen::Vector3d neutral_;
  std::array<double, 256> linear_; ///< linear light, by byte of an sRGB channel
};

} // namespace CGAL::Shape_correspondence::internal
