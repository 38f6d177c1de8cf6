// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/row_frame.h"
#include "base/eigen_system.h"
#include "matching/part_assemblies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Set on one half of the development set, by source family, and on the generated shapes
constexpr double upright_limit = 0.7;   // an upright row: the vertical component of its plane's normal is less
constexpr double planarity = 2;         // least ratio of a row's spreads in its plane and across it
constexpr double frame_thickness = 5;   // of a row with its frame, over that of the row, at most;
constexpr double frame_allowance = 0.1; // or over the height of the shape
constexpr double frame_reach = 1.25;    // by so much of a row's extents its frame may exceed it in the plane

class Row_frame_finder
{
public:
  Row_frame_finder(const Aligned_shape& shape, const Shape_layout& layout, std::size_t main_surface,
                   const std::vector<char>& is_in_chain)
      : shape_(shape), layout_(layout), main_surface_(main_surface), is_in_chain_(is_in_chain)
  {}

  std::vector<std::size_t> with_frame(const std::vector<std::size_t>& row) const
  {
    std::vector<std::size_t> result = row;
    const Eigen::Matrix3d axes = plane_of(row);
    if (axes.isZero()) return result;
    const auto box_in_plane = [&](std::size_t part) { return box_of(axes.transpose() * shape_.parts[part].surface); };
    Axis_box of_row = box_in_plane(row[0]);
    double middle = 0;
    bool is_on_ground = false;
    for (std::size_t part : row) {
      of_row = joined(of_row, box_in_plane(part));
      middle += layout_.boxes[part].middle() / double(row.size());
      is_on_ground = is_on_ground || layout_.is_on_ground[part];
    }
    const bool is_above_main_surface =
        main_surface_ != no_part && is_less(layout_.boxes[main_surface_].middle(), middle);
    const Eigen::Array3d row_sides = of_row.sides(),
                         most{std::max(frame_thickness * row_sides.x(), frame_allowance * layout_.bounds.sides().y()),
                              (1 + frame_reach) * row_sides.y(), (1 + frame_reach) * row_sides.z()};

    std::vector<char> is_in(layout_.boxes.size(), 0);
    for (std::size_t part : row)
      is_in[part] = 1;
    for (std::size_t k = 0; k < result.size(); ++k)
      for (std::size_t part : layout_.neighbours[result[k]]) {
        if (is_in[part] || !may_frame(part, is_on_ground, is_above_main_surface)) continue;
        const Eigen::Array3d sides = joined(of_row, box_in_plane(part)).sides();
        if (is_less(most.x(), sides.x()) || is_less(most.y(), sides.y()) || is_less(most.z(), sides.z())) continue;
        is_in[part] = 1;
        result.push_back(part);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  // May a part frame a row, by its role? Knobs in a row do not frame the drawers that they are on.
  bool may_frame(std::size_t part, bool row_is_on_ground, bool row_is_above_main_surface) const
  {
    if (is_in_chain_[part] || is_row(shape_.group(shape_.group_of[part]))) return false;
    if (layout_.is_on_ground[part] && !row_is_on_ground) return false;
    return !row_is_above_main_surface || is_less(layout_.boxes[main_surface_].middle(), layout_.boxes[part].middle());
  }

  // Normal, level and rising axis of an upright row's plane; zero if it is not upright, or not in a plane.
  Eigen::Matrix3d plane_of(const std::vector<std::size_t>& row) const
  {
    Eigen::Index n = 0;
    for (std::size_t part : row)
      n += shape_.parts[part].surface.cols();
    Points points(3, n);
    for (std::size_t part : row) {
      const Points& surface = shape_.parts[part].surface;
      points.middleCols(points.cols() - n, surface.cols()) = surface;
      n -= surface.cols();
    }
    points.colwise() -= points.rowwise().mean().eval();
    const Eigen_system eigen = eigen_system(scatter_matrix(points) / double(points.cols()));
    const Eigen::Vector3d spread = eigen.values.cwiseMax(0).cwiseSqrt(), normal = eigen.vectors.col(0);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    if (is_less(std::abs(normal.y()), upright_limit) && is_less(planarity * spread[0], spread[1])) {
      const Eigen::Vector3d level = normal.cross(Eigen::Vector3d::UnitY()).normalized();
      axes << normal, level, normal.cross(level);
    }
    return axes;
  }

  const Aligned_shape& shape_;
  const Shape_layout& layout_;
  std::size_t main_surface_;
  const std::vector<char>& is_in_chain_;
};

} // namespace

bool is_row(const Part_group& group)
{
  return group.symmetry.type == Symmetry_type::TRANSLATION && group.parts.size() >= minimum_repetition;
}

std::vector<std::size_t> row_with_frame(const std::vector<std::size_t>& row, const Aligned_shape& shape,
                                        const Shape_layout& layout, std::size_t main_surface,
                                        const std::vector<char>& is_in_chain)
{
  return Row_frame_finder(shape, layout, main_surface, is_in_chain).with_frame(row);
}

} // namespace CGAL::Shape_correspondence::internal
