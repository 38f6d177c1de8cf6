// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Shape_features.h"
#include "base/eigen_system.h"
#include "base/quantized.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr double no_variance = 1e-12; // variance in a direction, over the largest one, below which it counts as zero

// Square root of the covariance matrix, of Frobenius norm 1: form and orientation of a part, independent of size.
Eigen::Matrix3d orientation(const Surface& surface)
{
  const Surface centred = surface.rowwise() - surface.colwise().mean();
  const Eigen::Matrix3d covariance = scatter_matrix(centred.matrix().transpose()) / double(surface.rows());
  const Eigen_system eigen = eigen_system(covariance);
  const Eigen::Array3d squares = eigen.values;
  const double largest = squares.maxCoeff();
  if (!(largest > zero_squared_length)) return Eigen::Matrix3d::Zero();
  // The variance of a plane surface across the plane is rounding noise, the square root of which would not be small
  const Eigen::Vector3d lengths = (squares > no_variance * largest).select(squares.sqrt(), 0.);
  const double norm = lengths.norm();
  return eigen.vectors * (lengths / norm).asDiagonal() * eigen.vectors.transpose();
}

bool is_board(const Axes& sides, double wall_width)
{
  return quantized(std::min(sides[1], std::max(sides[0], sides[2]))) >= quantized(wall_width);
}

Part_extent part_extent(const Surface& surface, const Part_matching_options& options)
{
  const Axes low = surface.colwise().minCoeff(), high = surface.colwise().maxCoeff();
  Part_extent result;
  result.orientation = orientation(surface);
  result.is_board = is_board(high - low, options.wall_width);
  return result;
}

Surface surface_of(const Shape_features& shape, const std::vector<std::size_t>& parts)
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

void add_box(Boxes& boxes, Eigen::Index row, const Surface& surface)
{
  boxes.low.row(row) = surface.colwise().minCoeff();
  boxes.high.row(row) = surface.colwise().maxCoeff();
}

// Adds the groups and panels that may match one part as unions.
void add_unions(Shape_features& result)
{
  const Aligned_shape& shape = result.shape;
  const Part_matching_options& options = result.options;
  for (const Part_group& group : groups(shape))
    if (group.parts.size() >= options.repetition) result.unions.push_back(group.parts);
  for (const std::vector<std::size_t>& panel : result.assemblies.panels)
    if (shape.group(shape.group_of[panel[0]]).parts != panel) result.unions.push_back(panel);
  const auto is_all = [&](const std::vector<std::size_t>& parts) { return parts.size() == shape.parts.size(); };
  result.unions.erase(std::remove_if(result.unions.begin(), result.unions.end(), is_all), result.unions.end());

  const auto n = Eigen::Index(result.unions.size());
  Boxes boxes{Eigen::ArrayX3d(n, 3), Eigen::ArrayX3d(n, 3)};
  for (const std::vector<std::size_t>& parts : result.unions) {
    const Surface surface = surface_of(result, parts);
    add_box(boxes, Eigen::Index(result.union_parts.size()), surface);
    result.union_parts.push_back(part_extent(surface, options));
    result.union_parts.back().on_ground =
        std::any_of(parts.begin(), parts.end(), [&](std::size_t part) { return result.parts[part].on_ground; });
    result.union_parts.back().is_in_chain =
        std::all_of(parts.begin(), parts.end(), [&](std::size_t part) { return result.parts[part].is_in_chain; });
  }
  result.union_boxes = Measured_boxes(boxes, options.tolerance);
}

// Adds the features of parts and unions, by their integrals over the surfaces.
void add_learned(Shape_features& result)
{
  const std::vector<Sampled_part>& parts = result.shape.parts;
  const Eigen::Index dimension = parts[0].features.size();
  Eigen::MatrixXd& learned = result.learned;
  learned.resize(dimension, Eigen::Index(parts.size()));
  Eigen::Index known = 0;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    learned.col(Eigen::Index(part)) = parts[part].features.stableNormalized();
    result.has_learned.push_back(!parts[part].features.isZero(0));
    known += result.has_learned.back();
  }
  if (known == 0) return learned.resize(0, 0);
  result.mean_learned = learned.rowwise().sum() / double(known);
  for (std::size_t part = 0; part < parts.size(); ++part)
    if (!result.has_learned[part]) learned.col(Eigen::Index(part)) = result.mean_learned;
  result.learned_of_unions.resize(dimension, Eigen::Index(result.unions.size()));
  for (std::size_t k = 0; k < result.unions.size(); ++k) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(dimension);
    for (std::size_t part : result.unions[k])
      sum += parts[part].features;
    result.learned_of_unions.col(Eigen::Index(k)) =
        sum.isZero(0) ? result.mean_learned : Eigen::VectorXd(sum.stableNormalized());
  }
}

constexpr Eigen::Index most_kept_parts = 128; // limit for caching, which takes 96 bytes for each pair of parts

// The influence of an end of a box on other ends, a Gaussian of their distance. \param others an even number of ends,
// since the vectorized exponential and the scalar one differ in bits
template <typename Ends>
auto closeness_to(const Ends& others, double end, double width)
{
  return (-((others - end) / width).square() / 2).exp();
}

} // namespace

Measured_boxes::Measured_boxes(const Boxes& boxes, double tolerance) : Boxes(boxes)
{
  const Eigen::ArrayX3d extents = (high - low).max(0.) + tolerance;
  volumes = extents.rowwise().prod();
  logs = extents.log();
}

Closeness::Closeness(const Boxes& boxes, double width) : width_(width)
{
  const Eigen::Index parts = boxes.low.rows(), n = 2 * parts;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::ArrayXd& ends = ends_[std::size_t(axis)];
    ends.resize(n);
    for (Eigen::Index part = 0; part < parts; ++part) {
      ends[2 * part] = boxes.low(part, axis);
      ends[2 * part + 1] = boxes.high(part, axis);
    }
    if (parts > most_kept_parts) continue;
    Eigen::MatrixXd& kept = kept_[std::size_t(axis)];
    kept.resize(n, n);
    for (Eigen::Index end = 0; end < n; ++end) {
      const Eigen::Index rest = n - end / 2 * 2;
      kept.col(end).tail(rest) = closeness_to(ends.tail(rest), ends[end], width).matrix();
      for (Eigen::Index other = end + 1; other < n; ++other)
        kept(end, other) = kept(other, end);
    }
  }
}

void Closeness::of_end(int axis, Eigen::Index end, const std::vector<Eigen::Index>& parts, Eigen::ArrayXd& result) const
{
  const Eigen::MatrixXd& kept = kept_[std::size_t(axis)];
  const Eigen::ArrayXd& ends = ends_[std::size_t(axis)];
  const double* const values = kept.size() > 0 ? kept.col(end).data() : ends.data();
  result.resize(2 * Eigen::Index(parts.size()));
  for (std::size_t k = 0; k < parts.size(); ++k)
    std::copy_n(values + 2 * parts[k], 2, result.data() + 2 * k);
  if (kept.size() == 0) result = closeness_to(result, ends[end], width_);
}

Shape_rank rank_of(const Aligned_shape& shape)
{
  double height = 0, off_axis = 0;
  for (const Sampled_part& part : shape.parts) {
    height += part.surface.row(1).mean();
    off_axis += part.surface.row(0).cwiseAbs2().mean() + part.surface.row(2).cwiseAbs2().mean();
  }
  return {shape.parts.size(), quantized(height), quantized(off_axis)};
}

Shape_features::Shape_features(const Aligned_shape& shape, const Part_matching_options& options)
    : shape(shape), options(options), assemblies(part_assemblies(shape, options)), rank(rank_of(shape))
{
  if (!options.panels) assemblies.panels.clear();
  if (!options.support) assemblies.support.clear();
  Axes low = Axes::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Sampled_part& part : shape.parts) {
    low = low.min(part.surface.rowwise().minCoeff().array());
    high = high.max(part.surface.rowwise().maxCoeff().array());
  }
  const Axes side = (high - low > comparison_grid).select(high - low, 1.);

  const auto n = Eigen::Index(size());
  Boxes of_parts{Eigen::ArrayX3d(n, 3), Eigen::ArrayX3d(n, 3)};
  for (std::size_t part = 0; part < size(); ++part) {
    surfaces.push_back((shape.parts[part].surface.transpose().array().rowwise() - low.transpose()).rowwise() /
                       side.transpose());
    add_box(of_parts, Eigen::Index(part), surfaces.back());
    parts.push_back(part_extent(surfaces.back(), options));
    parts.back().on_ground = assemblies.is_on_ground[part];
    parts.back().is_in_chain = assemblies.is_in_chain[part];
  }
  boxes = Measured_boxes(of_parts, options.tolerance);
  closeness = Closeness(of_parts, options.warp_width);
  add_unions(*this);
  if (shape.parts[0].features.size() > 0) add_learned(*this);
  lanes = {surfaces.begin(), surfaces.end()};
}

bool have_same_features(const Part_matching_options& a, const Part_matching_options& b)
{
  const auto values = [](const Part_matching_options& o) {
    const Part_cost_weights& w = o.weights;
    return std::make_tuple(w.overlap, w.extent, w.ground, w.place, w.orientation, w.chamfer, o.tolerance, o.warp_width,
                           o.main_surface, o.side_depth, o.wall_width, o.repetition, o.panels, o.support);
  };
  return values(a) == values(b);
}

} // namespace CGAL::Shape_correspondence::internal
