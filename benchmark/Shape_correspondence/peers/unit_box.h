// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace CGAL::Shape_correspondence::peers {

/// Two shapes of a collection, by index.
using Shape_pair = std::array<std::size_t, 2>;

/// A method: the part pairs of each of the pairs of shapes of a collection. It sees the graphs, and no names.
using Peer = std::function<std::vector<Part_pairs>(const std::vector<Structural_graph>& shapes,
                                                   const std::vector<Shape_pair>& pairs)>;

/// A shape in its own frame, stretched to the unit box per axis; parts and groups by their index in the graph.
struct Boxed_shape
{
  std::vector<Points> surfaces; ///< sample points of each part
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<std::vector<std::size_t>> groups;
  std::vector<Symmetry> symmetries; ///< symmetry of each group
  std::vector<std::size_t> group_of;
  std::vector<std::vector<std::size_t>> neighbours; ///< parts in contact, by part
};

inline Boxed_shape boxed(const Structural_graph& graph, int quarter_turns)
{
  const Aligned_shape aligned = align_shape(graph, quarter_turns);
  const std::size_t n = aligned.parts.size();
  Boxed_shape shape;
  shape.surfaces.resize(n);
  shape.boxes.resize(n);
  shape.group_of.resize(n);
  shape.neighbours.resize(n);
  Eigen::AlignedBox3d all;
  for (const Sampled_part& part : aligned.parts)
    for (Eigen::Index k = 0; k < part.surface.cols(); ++k)
      all.extend(Point(part.surface.col(k)));
  const Point side = all.diagonal().cwiseMax(1e-6 * all.diagonal().maxCoeff());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t part = aligned.original[i];
    shape.surfaces[part] = side.cwiseInverse().asDiagonal() * (aligned.parts[i].surface.colwise() - all.min());
    for (Eigen::Index k = 0; k < shape.surfaces[part].cols(); ++k)
      shape.boxes[part].extend(Point(shape.surfaces[part].col(k)));
  }
  for (const Part_group& group : groups(aligned)) {
    shape.groups.emplace_back();
    shape.symmetries.push_back(group.symmetry);
    for (std::size_t i : group.parts) {
      shape.groups.back().push_back(aligned.original[i]);
      shape.group_of[aligned.original[i]] = shape.groups.size() - 1;
    }
  }
  for (const Aligned_shape::Contact& contact : aligned.contacts) {
    const std::size_t a = aligned.original[contact.parts[0]], b = aligned.original[contact.parts[1]];
    shape.neighbours[a].push_back(b);
    shape.neighbours[b].push_back(a);
  }
  return shape;
}

/// Both shapes of a pair; the target is turned to the orientation of the source, according to their files.
inline std::array<Boxed_shape, 2> boxed_pair(const Structural_graph& source, const Structural_graph& target)
{
  const int turns = alignment_turns(structure(source).frame, structure(target).frame).front();
  return {boxed(source, 0), boxed(target, turns)};
}

/// The distance of each point of `from` from the nearest point of `to`.
inline Eigen::ArrayXd distances(const Points& from, const Points& to)
{
  Eigen::ArrayXd result(from.cols());
  for (Eigen::Index k = 0; k < from.cols(); ++k)
    result[k] = (to.colwise() - from.col(k)).colwise().norm().minCoeff();
  return result;
}

inline double hausdorff(const Points& a, const Points& b)
{
  return std::max(distances(a, b).maxCoeff(), distances(b, a).maxCoeff());
}

/// Chamfer distance: half the sum of the mean distances in both directions.
inline double chamfer(const Points& a, const Points& b)
{
  return (distances(a, b).mean() + distances(b, a).mean()) / 2;
}

/// Distances of all parts of `a` (rows) from all parts of `b` (columns).
template <typename Distance>
Eigen::MatrixXd part_distances(const Boxed_shape& a, const Boxed_shape& b, const Distance& distance)
{
  Eigen::MatrixXd result(a.surfaces.size(), b.surfaces.size());
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    for (Eigen::Index j = 0; j < result.cols(); ++j)
      result(i, j) = distance(a.surfaces[std::size_t(i)], b.surfaces[std::size_t(j)]);
  return result;
}

/// Row and column of the entries that are at least `share` of the largest one of their row and of their column.
inline Part_pairs strong_entries(const Eigen::MatrixXd& weights, double share)
{
  Part_pairs pairs;
  for (Eigen::Index i = 0; i < weights.rows(); ++i)
    for (Eigen::Index j = 0; j < weights.cols(); ++j)
      if (weights(i, j) >= share * weights.row(i).maxCoeff() && weights(i, j) >= share * weights.col(j).maxCoeff())
        pairs.emplace_back(i, j);
  return pairs;
}

/// A method that matches each pair of shapes on its own.
template <typename Match>
Peer pairwise(const Match& match)
{
  return [match](const std::vector<Structural_graph>& shapes, const std::vector<Shape_pair>& pairs) {
    std::vector<Part_pairs> result;
    for (const Shape_pair& pair : pairs) {
      const auto [source, target] = boxed_pair(shapes[pair[0]], shapes[pair[1]]);
      result.push_back(match(source, target));
    }
    return result;
  };
}

} // namespace CGAL::Shape_correspondence::peers
