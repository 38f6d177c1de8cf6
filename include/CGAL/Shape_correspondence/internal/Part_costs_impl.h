// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_COSTS_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_COSTS_IMPL_H

#include <CGAL/Shape_correspondence/Part_costs.h>

#include <CGAL/Shape_correspondence/internal/nearest_points_kernel.h>
#include <CGAL/Shape_correspondence/internal/part_assemblies_impl.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Lengths in the unit box
constexpr double box_padding = 0.02;    // keeps the volume of flat boxes above 0
constexpr double extent_padding = 0.03; // under it, extents count as equal

constexpr double board_width = 0.7, board_height = 0.5; // at least
constexpr double board_share = 0.5; // of the cost of ground contact, for boards: many reach down where others end above

constexpr double flat = 1e-12; // variance in a direction, over the largest, that counts as none

constexpr double anchor_confidence = 0.2; // pairs above it bend one box onto the other
constexpr double warp_width = 0.15;       // standard deviation of their influence, in the unit box
constexpr double warp_inertia = 0.3;      // weight of staying in place

constexpr double group_share = 0.3;      // of a group's cost in those of its parts
constexpr double whole_group_charge = 1; // added to the cost of their union

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
         quantized(std::max(sides[0], sides[2])) >= quantized(board_width);
}

inline Part_extent part_extent(const Surface& surface)
{
  const Axes low = surface.colwise().minCoeff(), high = surface.colwise().maxCoeff();
  Part_extent result;
  result.orientation = orientation(surface);
  result.on_ground = quantized(low[1]) < quantized(ground_tolerance);
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
  for (std::size_t part = 0; part < assemblies.is_link.size(); ++part)
    result.parts[part].is_link = assemblies.is_link[part];
  add_wholes(result, shape, assemblies);
  return result;
}

// Distances of the points of the parts of one shape from the parts of another: [part](point, other part).
using Point_distances = std::vector<Eigen::ArrayXXd>;

inline Point_distances room_for_distances(const Compared_shape& from, const Compared_shape& to)
{
  Point_distances result;
  for (const Surface& surface : from.surfaces)
    result.emplace_back(surface.rows(), Eigen::Index(to.surfaces.size()));
  return result;
}

inline std::vector<Point_lanes> lanes_of(const Compared_shape& shape)
{
  return {shape.surfaces.begin(), shape.surfaces.end()};
}

// Distances of the points of either surface from the other.
inline void nearest_distances(const Point_lanes& p, const Point_lanes& q, Eigen::ArrayXd& p_from_q,
                              Eigen::ArrayXd& q_from_p)
{
  p_from_q.resize(p.padded());
  q_from_p.resize(q.padded());
  nearest_squared_kernel()(p, q, p_from_q.data(), q_from_p.data());
  p_from_q.conservativeResize(p.count());
  q_from_p.conservativeResize(q.count());
  p_from_q = p_from_q.sqrt();
  q_from_p = q_from_p.sqrt();
}

inline void point_distances(const Compared_shape& a, const Compared_shape& b, Point_distances& a_from_b,
                            Point_distances& b_from_a)
{
  a_from_b = room_for_distances(a, b);
  b_from_a = room_for_distances(b, a);
  const std::vector<Point_lanes> a_lanes = lanes_of(a), b_lanes = lanes_of(b);
  Eigen::ArrayXd p_from_q, q_from_p;
  for (std::size_t i = 0; i < a_lanes.size(); ++i)
    for (std::size_t j = 0; j < b_lanes.size(); ++j) {
      nearest_distances(a_lanes[i], b_lanes[j], p_from_q, q_from_p);
      a_from_b[i].col(Eigen::Index(j)) = p_from_q;
      b_from_a[j].col(Eigen::Index(i)) = q_from_p;
    }
}

inline double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t j)
{
  return (a_from_b[i].col(Eigen::Index(j)).mean() + b_from_a[j].col(Eigen::Index(i)).mean()) / 2;
}

// The chamfer distance of a part and the union of several.
inline double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i,
                      const std::vector<std::size_t>& parts)
{
  Eigen::ArrayXd nearest = a_from_b[i].col(Eigen::Index(parts[0]));
  double sum = 0, n = 0;
  for (std::size_t j : parts) {
    nearest = nearest.min(a_from_b[i].col(Eigen::Index(j)));
    sum += b_from_a[j].col(Eigen::Index(i)).sum();
    n += double(b_from_a[j].rows());
  }
  return (nearest.mean() + sum / n) / 2;
}

// The costs that no place changes.
inline double cost_of_kind(const Part_extent& a, const Part_extent& b, const Part_cost_weights& weights)
{
  double result = weights.orientation * (a.orientation - b.orientation).norm();
  if (a.on_ground != b.on_ground) result += (a.is_board || b.is_board ? board_share : 1) * weights.ground;
  if (a.is_link != b.is_link) result += weights.link;
  return result;
}

// The costs of places and extents.
inline Eigen::MatrixXd costs_of_boxes(const Boxes& a, const Boxes& b, const Part_cost_weights& weights)
{
  const auto extents = [](const Boxes& boxes) -> Eigen::ArrayX3d { return (boxes.high - boxes.low).max(0.); };
  const Eigen::ArrayX3d a_extents = extents(a), b_extents = extents(b);
  const Eigen::ArrayXd a_volumes = (a_extents + box_padding).rowwise().prod();
  const Eigen::ArrayXd b_volumes = (b_extents + box_padding).rowwise().prod();
  const Eigen::ArrayX3d a_logs = (a_extents + extent_padding).log(), b_logs = (b_extents + extent_padding).log();

  Eigen::MatrixXd result(a.low.rows(), b.low.rows());
  for (Eigen::Index j = 0; j < result.cols(); ++j)
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      const double overlap =
          (a.high.row(i).min(b.high.row(j)) - a.low.row(i).max(b.low.row(j)) + box_padding).max(0.).prod();
      const Axes apart = ((a.low.row(i) + a.high.row(i)) - (b.low.row(j) + b.high.row(j))).abs().transpose() / 2;
      result(i, j) = weights.overlap * (1 - overlap / std::min(a_volumes[i], b_volumes[j])) +
                     weights.extent * (a_logs.row(i) - b_logs.row(j)).abs().sum() + weights.side * apart[0] +
                     weights.front * apart[2];
    }
  return result;
}

// Ends of boxes and where they belong in the other shape.
struct Anchors
{
  Eigen::ArrayX3d from, to;
  Eigen::ArrayXd weights;
};

// Where the anchors pull the ends of boxes to: along each axis, the kernel-weighted mean of their displacements.
inline Eigen::ArrayX3d warped(const Eigen::ArrayX3d& ends, const Anchors& anchors)
{
  Eigen::ArrayX3d result = ends;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd from = anchors.from.col(axis), displacement = anchors.to.col(axis) - from;
    const auto influence = [&](const Eigen::ArrayXd& at, double x) -> Eigen::ArrayXd {
      return anchors.weights * (-((at - x) / warp_width).square() / 2).exp();
    };
    for (Eigen::Index i = 0; i < ends.rows(); ++i) {
      const Eigen::ArrayXd near = influence(from, ends(i, axis));
      double pull = (near * displacement).sum(), weight = near.sum();
      if (axis == 0) { // what is true of the left side is true of the right one
        const Eigen::ArrayXd mirrored = influence(1 - from, ends(i, axis));
        pull -= (mirrored * displacement).sum();
        weight += mirrored.sum();
      }
      result(i, axis) += pull / (weight + warp_inertia);
    }
  }
  return result;
}

inline Boxes warped(const Boxes& boxes, const Anchors& anchors)
{
  return {warped(boxes.low, anchors), warped(boxes.high, anchors)};
}

// How likely parts are to stand for one another, going by either of them: geometric mean of the two softmaxes. Sums run
// along rows both times: with the shapes swapped, the same bits.
inline Eigen::ArrayXXd mutual_softmax(const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likelihood = (-costs.array()).exp(), transposed = likelihood.transpose();
  const Eigen::VectorXd of_rows = likelihood.rowwise().sum(), of_columns = transposed.rowwise().sum();
  return likelihood / (of_rows * of_columns.transpose()).array().sqrt();
}

inline Anchors anchors_of(const Boxes& a, const Boxes& b, const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likely = mutual_softmax(costs);
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j)
      if (quantized(likely(i, j)) > quantized(anchor_confidence)) pairs.emplace_back(i, j);

  const auto n = Eigen::Index(2 * pairs.size());
  Anchors result{Eigen::ArrayX3d(n, 3), Eigen::ArrayX3d(n, 3), Eigen::ArrayXd(n)};
  for (Eigen::Index k = 0; k < n; k += 2) {
    const auto& [i, j] = pairs[std::size_t(k / 2)];
    result.from.row(k) = a.low.row(i), result.from.row(k + 1) = a.high.row(i);
    result.to.row(k) = b.low.row(j), result.to.row(k + 1) = b.high.row(j);
    result.weights.segment(k, 2) = likely(i, j) / 2;
  }
  return result;
}

inline Eigen::MatrixXd costs_after_warping(const Boxes& a, const Boxes& b, const Eigen::MatrixXd& costs_of_kind,
                                           const Part_cost_weights& weights)
{
  const Eigen::MatrixXd given = costs_of_boxes(a, b, weights);
  const Anchors there = anchors_of(a, b, costs_of_kind + given), back{there.to, there.from, there.weights};
  const Eigen::MatrixXd source_warped = costs_of_boxes(warped(a, there), b, weights);
  const Eigen::MatrixXd target_warped = costs_of_boxes(a, warped(b, back), weights);
  return costs_of_kind + (given + (source_warped + target_warped)) / 3;
}

inline Eigen::MatrixXd shared_in_groups(const Eigen::MatrixXd& costs, const Aligned_shape& source,
                                        const Aligned_shape& target)
{
  Eigen::MatrixXd result(costs.rows(), costs.cols());
  for (const Aligned_shape::Group& g : source.groups)
    for (const Aligned_shape::Group& h : target.groups) {
      const double group_cost = set_cost(costs, g.parts, h.parts);
      for (std::size_t i : g.parts)
        for (std::size_t j : h.parts) {
          const auto row = Eigen::Index(i), column = Eigen::Index(j);
          result(row, column) = (1 - group_share) * costs(row, column) + group_share * group_cost;
        }
    }
  return result;
}

// What it costs that a part of `a` stands for a whole of `b`; infinite for parts in none.
inline Eigen::MatrixXd costs_of_wholes(const Compared_shape& a, const Compared_shape& b,
                                       const Point_distances& a_from_b, const Point_distances& b_from_a,
                                       const Part_cost_weights& weights)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()),
                                                     std::numeric_limits<double>::infinity());
  const Eigen::MatrixXd boxes = costs_of_boxes(a.boxes, b.whole_boxes, weights);
  for (std::size_t h = 0; h < b.wholes.size(); ++h)
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      const std::vector<std::size_t>& parts = b.wholes[h];
      const double cost = cost_of_kind(a.parts[i], b.whole_parts[h], weights) +
                          boxes(Eigen::Index(i), Eigen::Index(h)) +
                          weights.chamfer * chamfer(a_from_b, b_from_a, i, parts) + whole_group_charge;
      for (std::size_t j : parts) {
        double& least = result(Eigen::Index(i), Eigen::Index(j));
        least = std::min(least, cost);
      }
    }
  return result;
}

using Part_indices = std::vector<Eigen::Index>;

// Of every part, the parts that it touches.
inline std::vector<Part_indices> touching_parts(const Aligned_shape& shape)
{
  std::vector<Part_indices> result(shape.parts.size());
  for (const Aligned_shape::Contact& contact : shape.contacts) {
    result[contact.parts[0]].push_back(Eigen::Index(contact.parts[1]));
    result[contact.parts[1]].push_back(Eigen::Index(contact.parts[0]));
  }
  return result;
}

inline double mean_of_best(const Eigen::ArrayXXd& likelihood, const Part_indices& rows, const Part_indices& columns)
{
  double sum = 0;
  for (Eigen::Index i : rows) {
    double best = 0;
    for (Eigen::Index j : columns)
      best = std::max(best, likelihood(i, j));
    sum += best;
  }
  return sum / double(rows.size());
}

// How well the parts that two parts touch stand for one another: the mean over those of either of how likely their best
// counterpart among the other's is; geometric mean of the two.
inline Eigen::ArrayXXd support_of_contacts(const Eigen::ArrayXXd& likelihood, const Aligned_shape& source,
                                           const Aligned_shape& target)
{
  const Eigen::ArrayXXd transposed = likelihood.transpose();
  const std::vector<Part_indices> of_source = touching_parts(source), of_target = touching_parts(target);
  Eigen::ArrayXXd result = Eigen::ArrayXXd::Zero(likelihood.rows(), likelihood.cols());
  for (std::size_t i = 0; i < of_source.size(); ++i)
    for (std::size_t j = 0; j < of_target.size(); ++j)
      if (!of_source[i].empty() && !of_target[j].empty())
        result(Eigen::Index(i), Eigen::Index(j)) = std::sqrt(mean_of_best(likelihood, of_source[i], of_target[j]) *
                                                             mean_of_best(transposed, of_target[j], of_source[i]));
  return result;
}

// The costs without those of surfaces: for a first look.
inline Eigen::MatrixXd rough_costs(const Compared_shape& a, const Compared_shape& b, const Part_cost_weights& weights)
{
  Eigen::MatrixXd result = costs_of_boxes(a.boxes, b.boxes, weights);
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t j = 0; j < b.parts.size(); ++j)
      result(Eigen::Index(i), Eigen::Index(j)) += cost_of_kind(a.parts[i], b.parts[j], weights);
  return result;
}

// The costs that no warp changes.
inline Eigen::MatrixXd costs_of_kind(const Compared_shape& a, const Compared_shape& b, const Point_distances& a_from_b,
                                     const Point_distances& b_from_a, const Part_cost_weights& weights)
{
  Eigen::MatrixXd result(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()));
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t j = 0; j < b.parts.size(); ++j)
      result(Eigen::Index(i), Eigen::Index(j)) =
          cost_of_kind(a.parts[i], b.parts[j], weights) + weights.chamfer * chamfer(a_from_b, b_from_a, i, j);
  return result;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE double set_cost(const Eigen::MatrixXd& costs, const std::vector<std::size_t>& rows,
                                                 const std::vector<std::size_t>& columns)
{
  double over_rows = 0, over_columns = 0;
  for (std::size_t i : rows) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j : columns)
      least = std::min(least, costs(Eigen::Index(i), Eigen::Index(j)));
    over_rows += least;
  }
  for (std::size_t j : columns) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i : rows)
      least = std::min(least, costs(Eigen::Index(i), Eigen::Index(j)));
    over_columns += least;
  }
  return (over_rows / double(rows.size()) + over_columns / double(columns.size())) / 2;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double mean_least_cost(const Eigen::MatrixXd& costs)
{
  return costs.rowwise().minCoeff().mean() + costs.colwise().minCoeff().mean();
}

namespace internal {

struct Cost_matrices
{
  Eigen::MatrixXd of_parts, all; // without the cost of contacts, and with it
};

inline Cost_matrices part_costs(const Compared_shape& a, const Aligned_shape& source, const Compared_shape& b,
                                const Aligned_shape& target, const Part_cost_weights& weights)
{
  Point_distances a_from_b, b_from_a;
  point_distances(a, b, a_from_b, b_from_a);

  const Eigen::MatrixXd of_kind = costs_of_kind(a, b, a_from_b, b_from_a, weights);
  const Eigen::MatrixXd alone = costs_after_warping(a.boxes, b.boxes, of_kind, weights);
  Cost_matrices result;
  result.of_parts = shared_in_groups(alone, source, target)
                        .cwiseMin(costs_of_wholes(a, b, a_from_b, b_from_a, weights))
                        .cwiseMin(costs_of_wholes(b, a, b_from_a, a_from_b, weights).transpose());
  const Eigen::ArrayXXd support = support_of_contacts(mutual_softmax(result.of_parts), source, target);
  result.all = result.of_parts + weights.contacts * (1 - support).matrix();
  return result;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Eigen::MatrixXd part_costs(const Aligned_shape& source, const Aligned_shape& target,
                                                            const Part_cost_weights& weights)
{
  using namespace internal;
  const Compared_shape a = compared_shape(source, part_assemblies(source)),
                       b = compared_shape(target, part_assemblies(target));
  return internal::part_costs(a, source, b, target, weights).all;
}

namespace internal {

// The costs of the parts of one shape among each other, as far as one of the two is chosen; of others some are missing.
inline Eigen::MatrixXd own_part_costs(const Compared_shape& a, const std::vector<char>& is_chosen,
                                      const Part_cost_weights& weights)
{
  Eigen::MatrixXd result = costs_of_boxes(a.boxes, a.boxes, weights);
  const std::vector<Point_lanes> lanes = lanes_of(a);
  Eigen::ArrayXd i_from_j, j_from_i;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_chosen[i] && !is_chosen[j]) continue;
      nearest_distances(lanes[i], lanes[j], i_from_j, j_from_i);
      const auto row = Eigen::Index(i), column = Eigen::Index(j);
      result(row, column) +=
          cost_of_kind(a.parts[i], a.parts[j], weights) + weights.chamfer * (i_from_j.mean() + j_from_i.mean()) / 2;
      result(column, row) = result(row, column);
    }
  return result;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Eigen::MatrixXd part_costs(const Aligned_shape& shape,
                                                            const Part_cost_weights& weights)
{
  return internal::own_part_costs(internal::compared_shape(shape, part_assemblies(shape)),
                                  std::vector<char>(shape.parts.size(), 1), weights);
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif
