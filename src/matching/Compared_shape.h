// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_COMPARED_SHAPE_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_COMPARED_SHAPE_H

#include "base/quantized.h"
#include "matching/Shape_layout.h"
#include "matching/part_assemblies.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr double board_height = 0.5; // at least
constexpr double flat = 1e-12;       // variance in a direction, over the largest, that counts as none

using Axes = Eigen::Array3d;
using Surface = Eigen::ArrayX3d; // a point a row

// The boxes of all parts, one a row.
struct Boxes
{
  Eigen::ArrayX3d low, high;
};

// A part, or several as one.
struct Part_extent
{
  Eigen::Matrix3d orientation;
  bool on_ground = false;
  bool is_board = false; // upright, from side to side
  bool is_link = false;  // of a chain
};

// The parts of a shape in its unit box.
struct Compared_shape
{
  std::vector<Surface> surfaces;
  std::vector<Part_extent> parts;
  Boxes boxes;

  std::vector<std::vector<std::size_t>> wholes; // sets of parts that may stand for one part
  std::vector<Part_extent> whole_parts;
  Boxes whole_boxes;
};

// Square root of the covariance, of Frobenius norm 1: what is long where, whatever the size.
inline Eigen::Matrix3d orientation(const Surface& surface)
{
  const Surface centred = surface.rowwise() - surface.colwise().mean();
  const Eigen::Matrix3d covariance = centred.matrix().transpose() * centred.matrix() / double(surface.rows());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  const Eigen::Array3d squares = eigen.eigenvalues();
  const double largest = squares.maxCoeff();
  if (!(largest > zero_squared_length)) return Eigen::Matrix3d::Zero();
  // What is flat is exactly flat: a root would blow rounding noise up
  const Eigen::Vector3d lengths = (squares > flat * largest).select(squares.sqrt(), 0.);
  const double norm = lengths.norm();
  return eigen.eigenvectors() * (lengths / norm).asDiagonal() * eigen.eigenvectors().transpose();
}

inline bool is_board(const Axes& sides)
{
  return quantized(sides[1]) >= quantized(board_height) &&
         quantized(std::max(sides[0], sides[2])) >= quantized(wall_width);
}

inline Part_extent part_extent(const Surface& surface)
{
  const Axes low = surface.colwise().minCoeff(), high = surface.colwise().maxCoeff();
  Part_extent result;
  result.orientation = orientation(surface);
  result.is_board = is_board(high - low);
  return result;
}

inline Surface surface_of(const Compared_shape& shape, const std::vector<std::size_t>& parts)
{
  Eigen::Index n = 0;
  for (std::size_t part : parts)
    n += shape.surfaces[part].rows();
  Surface result(n, 3);
  for (std::size_t part : parts) {
    const Surface& surface = shape.surfaces[part];
    result.middleRows(result.rows() - n, surface.rows()) = surface;
    n -= surface.rows();
  }
  return result;
}

inline void add_box(Boxes& boxes, Eigen::Index row, const Surface& surface)
{
  boxes.low.row(row) = surface.colwise().minCoeff();
  boxes.high.row(row) = surface.colwise().maxCoeff();
}

// Groups and panels, as one part each.
inline void add_wholes(Compared_shape& compared, const Aligned_shape& shape, const Part_assemblies& assemblies)
{
  for (const Aligned_shape::Group& group : shape.groups)
    if (group.parts.size() >= whole_group_size) compared.wholes.push_back(group.parts);
  for (const std::vector<std::size_t>& panel : assemblies.panels)
    if (shape.groups[shape.group_of[panel[0]]].parts != panel) compared.wholes.push_back(panel);
  const auto is_all = [&](const std::vector<std::size_t>& whole) { return whole.size() == shape.parts.size(); };
  compared.wholes.erase(std::remove_if(compared.wholes.begin(), compared.wholes.end(), is_all), compared.wholes.end());

  const auto n = Eigen::Index(compared.wholes.size());
  compared.whole_boxes = {Eigen::ArrayX3d(n, 3), Eigen::ArrayX3d(n, 3)};
  for (const std::vector<std::size_t>& whole : compared.wholes) {
    const Surface surface = surface_of(compared, whole);
    add_box(compared.whole_boxes, Eigen::Index(compared.whole_parts.size()), surface);
    compared.whole_parts.push_back(part_extent(surface));
    compared.whole_parts.back().on_ground =
        std::any_of(whole.begin(), whole.end(), [&](std::size_t part) { return compared.parts[part].on_ground; });
    compared.whole_parts.back().is_link =
        std::all_of(whole.begin(), whole.end(), [&](std::size_t part) { return compared.parts[part].is_link; });
  }
}

inline Compared_shape compared_shape(const Aligned_shape& shape, const Part_assemblies& assemblies)
{
  Compared_shape result;
  Axes low = Axes::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Sampled_part& part : shape.parts) {
    low = low.min(part.surface.rowwise().minCoeff().array());
    high = high.max(part.surface.rowwise().maxCoeff().array());
  }
  const Axes side = (high - low > comparison_grid).select(high - low, 1.);

  const auto n = Eigen::Index(shape.parts.size());
  result.boxes = {Eigen::ArrayX3d(n, 3), Eigen::ArrayX3d(n, 3)};
  for (const Sampled_part& part : shape.parts) {
    result.surfaces.push_back((part.surface.transpose().array().rowwise() - low.transpose()).rowwise() /
                              side.transpose());
    add_box(result.boxes, Eigen::Index(result.parts.size()), result.surfaces.back());
    result.parts.push_back(part_extent(result.surfaces.back()));
  }
  for (std::size_t part = 0; part < shape.parts.size(); ++part) {
    result.parts[part].on_ground = assemblies.is_on_ground[part];
    result.parts[part].is_link = assemblies.is_link[part];
  }
  add_wholes(result, shape, assemblies);
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_COMPARED_SHAPE_H
