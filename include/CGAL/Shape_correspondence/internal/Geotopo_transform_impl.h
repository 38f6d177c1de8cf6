// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_GEOTOPO_TRANSFORM_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_GEOTOPO_TRANSFORM_IMPL_H

#include <CGAL/Shape_correspondence/Geotopo_transform.h>

#include <CGAL/Shape_correspondence/internal/optimal_assignment.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr int curve_samples = samples_per_side;
constexpr int sheet_samples = samples_per_side * samples_per_side;

using Permutation = std::vector<int>;

// The ways to run through the samples of a curve, or of a closed one from every start.
inline std::vector<Permutation> curve_orientations(bool closed)
{
  std::vector<Permutation> result;
  for (int start = 0; start < (closed ? curve_samples : 1); ++start)
    for (int step : {1, -1}) {
      Permutation p(curve_samples);
      for (int i = 0; i < curve_samples; ++i)
        p[i] = ((step > 0 ? i : curve_samples - 1 - i) + start) % curve_samples;
      result.push_back(p);
    }
  return result;
}

// The 8 ways to lay a square grid onto itself.
inline std::vector<Permutation> sheet_orientations()
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int transposed : {0, 1})
    for (int flip_u : {0, 1})
      for (int flip_v : {0, 1}) {
        Permutation p(sheet_samples);
        for (int i = 0; i < e; ++i)
          for (int j = 0; j < e; ++j) {
            const int u = flip_u ? e - 1 - i : i, v = flip_v ? e - 1 - j : j;
            p[i * e + j] = transposed ? v * e + u : u * e + v;
          }
        result.push_back(p);
      }
  return result;
}

inline const std::vector<Permutation>& orientations(const Sampled_part& source, const Sampled_part& target)
{
  static const std::vector<Permutation> open = curve_orientations(false), closed = curve_orientations(true),
                                        sheet = sheet_orientations();
  using Kind = Sampled_part::Kind;
  if (source.kind == Kind::SHEET || target.kind == Kind::SHEET) return sheet;
  return source.kind == Kind::CLOSED_CURVE || target.kind == Kind::CLOSED_CURVE ? closed : open;
}

// Centroids of a group's parts in the unit box of the group; a direction in which the group has no extent counts as its
// middle.
inline Points unit_box_centroids(const Aligned_shape& shape, const std::vector<std::size_t>& parts)
{
  constexpr double flat_extent = 0.02; // of the shape's height
  Eigen::AlignedBox3d box;
  for (std::size_t part : parts)
    for (Eigen::Index i = 0; i < shape.parts[part].samples.cols(); ++i)
      box.extend(shape.parts[part].samples.col(i));
  Points result(3, parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = box.sizes()[axis];
      result(axis, i) = extent < flat_extent ? 0.5 : (shape.parts[parts[i]].centroid[axis] - box.min()[axis]) / extent;
    }
  return result;
}

// Columns of a row that no row has taken go to the nearest row.
inline std::vector<std::vector<std::size_t>> assign_members(const Eigen::MatrixXd& cost)
{
  std::vector<std::vector<std::size_t>> cols_of(cost.rows());
  std::vector<char> taken(cost.cols(), 0);
  const std::vector<std::size_t> first = optimal_assignment(cost);
  for (std::size_t row = 0; row < first.size(); ++row) {
    cols_of[row].push_back(first[row]);
    taken[first[row]] = 1;
  }
  for (Eigen::Index col = 0; col < cost.cols(); ++col) {
    if (taken[col]) continue;
    Eigen::Index nearest;
    cost.col(col).minCoeff(&nearest);
    cols_of[nearest].push_back(std::size_t(col));
  }
  for (auto& cols : cols_of)
    std::sort(cols.begin(), cols.end());
  return cols_of;
}

inline Operation operation(std::size_t source_size, std::size_t target_size)
{
  if (source_size == target_size) return Operation::MATCH;
  if (source_size > target_size) return Operation::MERGE;
  return source_size == 1 ? Operation::SPLIT : Operation::DUPLICATE;
}

// S_i of Eq. 5: 1 between single parts and where one side is a rotational group.
inline double solidity_ratio(const Aligned_shape::Group& source, const Aligned_shape::Group& target)
{
  const bool single = source.parts.size() == 1 && target.parts.size() == 1;
  const bool rotational =
      source.symmetry.type == Symmetry_type::ROTATION || target.symmetry.type == Symmetry_type::ROTATION;
  if (single || rotational) return 1;
  return std::min(source.solidity, target.solidity) / std::max(source.solidity, target.solidity);
}

// What the generator of a group makes of a movement of one member, for the member `steps` further.
inline Point symmetric_displacement(const Symmetry& symmetry, const Point& displacement, const Point& representative,
                                    const Point& member)
{
  switch (symmetry.type) {
  case Symmetry_type::REFLECTION: {
    // Members on the same side move alike
    const double side = symmetry.direction.dot(representative - symmetry.point);
    if (side * symmetry.direction.dot(member - symmetry.point) >= 0) return displacement;
    return displacement - 2 * symmetry.direction.dot(displacement) * symmetry.direction;
  }
  case Symmetry_type::ROTATION: {
    const Point axis = symmetry.direction;
    const Point from = representative - symmetry.point - axis * axis.dot(representative - symmetry.point);
    const Point to = member - symmetry.point - axis * axis.dot(member - symmetry.point);
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    return Eigen::AngleAxisd(angle, axis) * displacement;
  }
  default:
    return displacement;
  }
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Points lifted_samples(const Sampled_part& part, Eigen::Index count)
{
  if (part.samples.cols() == count) return part.samples;
  Points result(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    result.col(i) = part.samples.col(i / samples_per_side);
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Points deform_to_fit(const Sampled_part& source, const Sampled_part& target)
{
  const Eigen::Index count = std::max(source.samples.cols(), target.samples.cols());
  const Points from = lifted_samples(source, count).colwise() - source.centroid;
  const Points to = lifted_samples(target, count);
  const Points centred = to.colwise() - target.centroid;

  const auto& candidates = internal::orientations(source, target);
  const internal::Permutation* best = nullptr;
  long best_score = 0; // the sum of products: greatest where the sum of squared distances is least
  for (const internal::Permutation& candidate : candidates) {
    double sum = 0;
    for (Eigen::Index i = 0; i < count; ++i)
      sum += from.col(i).dot(centred.col(candidate[i]));
    const long score = internal::quantized(sum);
    if (!best || score > best_score) best = &candidate, best_score = score;
  }
  Points result(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    result.col(i) = to.col((*best)[i]);
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Group_label match_members(const Aligned_shape& source, std::size_t source_group,
                                                           const Aligned_shape& target, std::size_t target_group)
{
  const auto& from = source.groups[source_group].parts;
  const auto& to = target.groups[target_group].parts;
  const Points p = internal::unit_box_centroids(source, from), q = internal::unit_box_centroids(target, to);
  Eigen::MatrixXd cost(from.size(), to.size());
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j)
      cost(i, j) = double(internal::quantized((p.col(i) - q.col(j)).norm()));

  Group_label label;
  label.target_group = target_group;
  label.operation = internal::operation(from.size(), to.size());
  label.solidity_ratio = internal::solidity_ratio(source.groups[source_group], target.groups[target_group]);
  label.images.resize(from.size());
  if (from.size() <= to.size()) {
    const auto images = internal::assign_members(cost);
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t j : images[i])
        label.images[i].push_back(to[j]);
  } else {
    const auto preimages = internal::assign_members(cost.transpose());
    for (std::size_t j = 0; j < to.size(); ++j)
      for (std::size_t i : preimages[j])
        label.images[i].push_back(to[j]);
  }
  return label;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE void propagate(const Aligned_shape& shape, const std::vector<char>& matched,
                                                const std::vector<std::array<Point, 2>>& contact_displacement,
                                                Points& displacement)
{
  std::vector<char> placed = matched;
  std::vector<Point> sum(shape.parts.size(), Point::Zero());
  std::vector<int> count(shape.parts.size(), 0);
  const auto place = [&](std::size_t group) {
    // The representative is the member that touches most placed parts; one that touches none stays
    const auto& parts = shape.groups[group].parts;
    std::size_t representative = parts[0];
    for (std::size_t part : parts)
      if (count[part] > count[representative]) representative = part;
    const Point moved = count[representative] ? Point(sum[representative] / count[representative]) : Point::Zero();
    for (std::size_t part : parts)
      displacement.col(part) = internal::symmetric_displacement(
          shape.groups[group].symmetry, moved, shape.parts[representative].centroid, shape.parts[part].centroid);
  };

  // Breadth-first, a layer of groups at a time: what touches the last layer is the next one
  std::vector<std::size_t> layer, next;
  for (std::size_t group = 0; group < matched.size(); ++group)
    if (matched[group]) layer.push_back(group);
  while (!layer.empty()) {
    next.clear();
    for (std::size_t group : layer)
      for (std::size_t c : shape.groups[group].contacts)
        for (int side : {0, 1}) {
          const std::size_t mover = shape.contacts[c].parts[side], part = shape.contacts[c].parts[1 - side];
          if (shape.group_of[mover] != group || placed[shape.group_of[part]]) continue;
          sum[part] += matched[group] ? contact_displacement[c][side] : Point(displacement.col(mover));
          ++count[part];
          next.push_back(shape.group_of[part]);
        }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    for (std::size_t group : next)
      place(group), placed[group] = 1;
    layer.swap(next);
  }
  for (std::size_t group = 0; group < placed.size(); ++group)
    if (!placed[group])
      for (std::size_t part : shape.groups[group].parts)
        displacement.col(part).setZero();
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif
