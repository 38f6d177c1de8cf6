// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ALIGN_SHAPES_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ALIGN_SHAPES_IMPL_H

#include <CGAL/Shape_correspondence/align_shapes.h>

#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Quarter turn about y as an exact rotation: no rounding, so that a self-match costs exactly 0.
inline Eigen::Matrix3d quarter_turn(int turns)
{
  static constexpr int cosine[] = {1, 0, -1, 0};
  const int k = ((turns % 4) + 4) % 4;
  const double c = cosine[k], s = cosine[(k + 3) % 4];
  Eigen::Matrix3d turn;
  turn << c, 0, s, 0, 1, 0, -s, 0, c;
  return turn;
}

inline Point frame_point(const Shape_frame& frame, const Point& world)
{
  return frame.axes.transpose() * (world - frame.origin) / frame.height;
}

inline Sampled_part sampled_part(const Part_abstraction& part, const Shape_frame& frame, const Eigen::Matrix3d& turn)
{
  Sampled_part result;
  result.kind = part.is_sheet()          ? Sampled_part::Kind::SHEET
                : part.is_closed_curve() ? Sampled_part::Kind::CLOSED_CURVE
                                         : Sampled_part::Kind::CURVE;
  result.samples = turn * frame.to_frame(sample(part, samples_per_side));
  result.centroid = result.samples.rowwise().mean();
  const Eigen::Index n = std::min<Eigen::Index>(part.surface.cols(), surface_samples);
  result.surface = n > 0 ? Points(turn * frame.to_frame(part.surface.leftCols(n))) : result.samples;
  return result;
}

// The part's volume, or that of its bounding box scaled down where the file has none.
inline double prominence(const Part_abstraction& part, const Sampled_part& sampled)
{
  if (part.volume > 0) return part.volume;
  if (part.hull_volume > 0) return part.hull_volume;
  constexpr double assumed_thickness = 0.02; // of the shape's height
  const Point extent = sampled.samples.rowwise().maxCoeff() - sampled.samples.rowwise().minCoeff();
  return (extent.array() + assumed_thickness).prod();
}

inline Symmetry in_common_frame(const Symmetry& symmetry, const Shape_frame& frame, const Eigen::Matrix3d& turn)
{
  Symmetry result = symmetry;
  result.point = turn * frame_point(frame, symmetry.point);
  result.direction = turn * (frame.axes.transpose() * symmetry.direction);
  if (symmetry.type == Symmetry_type::TRANSLATION) result.direction /= frame.height;
  return result;
}

// The order that sorts the keys, ties by index.
template <typename Key>
std::vector<std::size_t> sorting_order(const std::vector<Key>& keys)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

inline std::size_t nearest_sample(const Points& samples, const Point& p)
{
  Eigen::Index nearest;
  (samples.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
  return std::size_t(nearest);
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Aligned_shape align_shape(const Structural_graph& graph, int quarter_turns)
{
  using namespace internal;
  const Shape_structure& shape = structure(graph);
  const Eigen::Matrix3d turn = quarter_turn(quarter_turns);

  std::vector<Sampled_part> sampled;
  std::vector<std::array<long, 6>> keys;
  for (const Part_abstraction& part : shape.parts) {
    sampled.push_back(sampled_part(part, shape.frame, turn));
    const Points& s = sampled.back().samples;
    const Point c = sampled.back().centroid, extent = s.rowwise().maxCoeff() - s.rowwise().minCoeff();
    keys.push_back({quantized(c.y()), quantized(c.x()), quantized(c.z()), quantized(extent.y()), quantized(extent.x()),
                    quantized(extent.z())});
  }

  Aligned_shape result;
  result.original = sorting_order(keys);
  std::vector<std::size_t> rank(sampled.size());
  for (std::size_t i = 0; i < rank.size(); ++i) {
    const std::size_t part = result.original[i];
    rank[part] = i;
    result.parts.push_back(std::move(sampled[part]));
    result.prominence.push_back(prominence(shape.parts[part], result.parts.back()));
  }

  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    Aligned_shape::Group group;
    for (std::size_t part : graph[v].parts)
      group.parts.push_back(rank[part]);
    std::sort(group.parts.begin(), group.parts.end());
    group.symmetry = in_common_frame(graph[v].symmetry, shape.frame, turn);
    group.solidity = solidity(graph[v].volume, graph[v].hull_volume);
    result.groups.push_back(std::move(group));
  }
  std::sort(result.groups.begin(), result.groups.end(),
            [](const Aligned_shape::Group& a, const Aligned_shape::Group& b) { return a.parts[0] < b.parts[0]; });
  result.group_of.resize(rank.size());
  for (std::size_t g = 0; g < result.groups.size(); ++g)
    for (std::size_t part : result.groups[g].parts)
      result.group_of[part] = g;

  for (const Contact& contact : shape.contacts) {
    Aligned_shape::Contact c;
    const bool swap = rank[contact.parts[0]] > rank[contact.parts[1]];
    for (int side = 0; side < 2; ++side) {
      const std::size_t part = contact.parts[side];
      const Point p = turn * frame_point(shape.frame, evaluate(shape.parts[part], contact.parameters[side]));
      c.parts[side ^ int(swap)] = rank[part];
      c.samples[side ^ int(swap)] = nearest_sample(result.parts[rank[part]].samples, p);
    }
    result.contacts.push_back(c);
  }
  std::sort(result.contacts.begin(), result.contacts.end(),
            [](const Aligned_shape::Contact& a, const Aligned_shape::Contact& b) { return a.parts < b.parts; });
  for (std::size_t c = 0; c < result.contacts.size(); ++c) {
    const std::size_t g = result.group_of[result.contacts[c].parts[0]],
                      h = result.group_of[result.contacts[c].parts[1]];
    result.groups[g].contacts.push_back(c);
    if (h != g) result.groups[h].contacts.push_back(c);
  }
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE std::vector<int> alignment_turns(const Shape_frame& source, const Shape_frame& target)
{
  // The turn about up that carries the target's frame into the source's, as the shapes were given
  const Eigen::Matrix3d relative = source.axes.transpose() * target.axes;
  const double given = std::atan2(relative(0, 2) - relative(2, 0), relative(0, 0) + relative(2, 2));
  const bool half_turns = source.mirror_x != source.mirror_z && target.mirror_x != target.mirror_z;

  std::vector<std::pair<long, int>> turns;
  for (int q = 0; q < 4; q += half_turns ? 2 : 1) {
    const double off = std::abs(std::remainder(given - q * EIGEN_PI / 2, 2 * EIGEN_PI));
    turns.emplace_back(internal::quantized(off), q);
  }
  std::sort(turns.begin(), turns.end());
  std::vector<int> result;
  for (const auto& turn : turns)
    result.push_back(turn.second);
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif
