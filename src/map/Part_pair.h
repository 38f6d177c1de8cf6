// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MAP_PART_PAIR_H
#define CGAL_SHAPE_CORRESPONDENCE_MAP_PART_PAIR_H

#include "base/Disjoint_sets.h"
#include "base/optimal_assignment.h"
#include "base/quantized.h"
#include "base/quarter_turn.h"
#include "map/Part_chart.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

using Chart_box = Eigen::AlignedBox3d;

inline Chart_box whole_chart() { return Chart_box(Point::Constant(-1), Point::Constant(1)); }
inline bool is_whole(const Chart_box& box) { return box.contains(whole_chart()); }

/// Two parts, or pieces of parts, that become each other, and how.
struct Part_pair
{
  std::size_t source = 0, target = 0;
  Chart_box source_piece = whole_chart(), target_piece = whole_chart(); ///< in the parts' chart coordinates
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< from coordinates of the source's piece to the target's
};

/// A shape in the common frame: height 1, standing on the ground.
struct Charted_shape
{
  std::vector<Points> surfaces; ///< vertices of the parts' meshes, or points of their surfaces
  std::vector<Part_chart> charts;
  std::vector<Part_abstraction const*> parts;
};

inline Points to_common_frame(const Shape_frame& frame, int quarter_turns, const Points& world)
{
  return quarter_turn(quarter_turns) * frame.to_frame(world);
}

/// \param surfaces of the parts, in the world; where one is empty, the control points stand for it
inline Charted_shape charted_shape(const Structural_graph& graph, int quarter_turns,
                                   const std::vector<const Points*>& surfaces)
{
  const Shape_structure& shape = structure(graph);
  Charted_shape result;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    const Part_abstraction& part = shape.parts[i];
    const Points spine = to_common_frame(shape.frame, quarter_turns, part.control_points());
    const bool known = surfaces[i] && surfaces[i]->cols() > 0;
    result.surfaces.push_back(known ? to_common_frame(shape.frame, quarter_turns, *surfaces[i]) : spine);
    result.charts.push_back(Part_chart::around(part, spine, result.surfaces.back()));
    result.parts.push_back(&part);
  }
  return result;
}

/// The rotations of the cube onto itself, the identity first.
inline std::vector<Eigen::Matrix3d> cube_rotations()
{
  std::vector<Eigen::Matrix3d> result;
  std::array<int, 3> order = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 3; ++i)
        m(order[std::size_t(i)], i) = signs >> i & 1 ? -1 : 1;
      if (m.determinant() > 0) result.push_back(m);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

/// How the charts of two parts are laid on each other.
enum class Pair_kind {
  SAME,       ///< two curves or two sheets: along both
  LENGTHWISE, ///< a curve and a sheet: along the curve and the long way of the sheet
  BOXES       ///< with a closed curve: by the boxes around both
};

/// The turn from coordinates of one chart to those of another that lays the longest extents on each other best (paper,
/// section 5, "Deform-to-fit": extremities are matched by proximity), of those for which `is_allowed(turn)` holds; none
/// if it holds for none.
template <typename Allowed>
std::optional<Eigen::Matrix3d> best_turn(const Part_chart& source, const Part_chart& target, Pair_kind kind,
                                         const Allowed& is_allowed)
{
  const bool lengthwise = kind == Pair_kind::LENGTHWISE;
  const Part_chart a = lengthwise ? source.lengthwise() : source, b = lengthwise ? target.lengthwise() : target;
  Eigen::Matrix3d before = Eigen::Matrix3d::Identity(), after = before;
  if (lengthwise) before = source.lengthwise_turn().transpose(), after = target.lengthwise_turn();
  const Eigen::Matrix3d from = a.axes() * a.half_extents().asDiagonal();
  const Eigen::Matrix3d to = b.axes() * b.half_extents().asDiagonal();
  const int kept = a.is_sheet() ? 2 : 0;
  std::optional<Eigen::Matrix3d> best;
  long best_score = std::numeric_limits<long>::min();
  for (const Eigen::Matrix3d& turn : cube_rotations()) {
    if (kind != Pair_kind::BOXES && turn(kept, kept) == 0) continue;
    if (!is_allowed(after * turn * before)) continue;
    const long score = quantized(from.cwiseProduct(to * turn).sum());
    if (!best || score > best_score) best = after * turn * before, best_score = score;
  }
  return best;
}

inline Eigen::Matrix3d best_turn(const Part_chart& source, const Part_chart& target, Pair_kind kind)
{
  return *best_turn(source, target, kind, [](const Eigen::Matrix3d&) { return true; });
}

/// Sets of parts that pairs connect, as two lists of indices.
struct Connected_parts
{
  std::vector<std::size_t> source, target;
};

using Index_pairs = std::vector<std::pair<std::size_t, std::size_t>>; ///< source part, target part

inline std::vector<Connected_parts> connected_parts(const Index_pairs& pairs, std::size_t sources, std::size_t targets)
{
  Disjoint_sets sets(sources + targets);
  for (const auto& [s, t] : pairs)
    sets.unite(s, sources + t);
  std::vector<Connected_parts> all(sources + targets), result;
  for (std::size_t i = 0; i < sets.size(); ++i)
    (i < sources ? all[sets[i]].source : all[sets[i]].target).push_back(i < sources ? i : i - sources);
  for (Connected_parts& block : all)
    if (!block.source.empty() && !block.target.empty()) result.push_back(std::move(block));
  return result;
}

/// Where parts lie among each other: their middles in the box around all of them.
inline Points places(const Charted_shape& shape, const std::vector<std::size_t>& parts)
{
  constexpr double flat = 0.02; // of the shape's height: no extent to tell places by
  Points result(3, Eigen::Index(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i)
    result.col(Eigen::Index(i)) = shape.charts[parts[i]](Point::Zero());
  const Point low = result.rowwise().minCoeff(), extent = result.rowwise().maxCoeff() - low;
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] < flat)
      result.row(axis).setConstant(0.5);
    else
      result.row(axis) = (result.row(axis).array() - low[axis]) / extent[axis];
  }
  return result;
}

/// Pairs in which every part of a block is: one to one by optimal assignment as far as numbers allow, every part left
/// over with the nearest one, or with all of several that are as near, so that a symmetric block is paired
/// symmetrically.
inline Index_pairs pairs_in(const Connected_parts& block, const Charted_shape& source, const Charted_shape& target)
{
  constexpr double as_near = 0.02;
  const Points from = places(source, block.source), to = places(target, block.target);
  Eigen::MatrixXd cost(from.cols(), to.cols());
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j)
      cost(i, j) = double(quantized((from.col(i) - to.col(j)).norm())) * comparison_grid;
  const bool fewer_sources = cost.rows() <= cost.cols();
  if (!fewer_sources) cost.transposeInPlace();
  Index_pairs result;
  const auto add = [&](std::size_t row, std::size_t col) {
    result.emplace_back(block.source[fewer_sources ? row : col], block.target[fewer_sources ? col : row]);
  };
  std::vector<char> taken(std::size_t(cost.cols()), 0);
  const std::vector<std::size_t> first = optimal_assignment(cost);
  for (std::size_t row = 0; row < first.size(); ++row) {
    add(row, first[row]);
    taken[first[row]] = 1;
  }
  for (Eigen::Index col = 0; col < cost.cols(); ++col) {
    if (taken[std::size_t(col)]) continue;
    const double least = cost.col(col).minCoeff();
    for (Eigen::Index row = 0; row < cost.rows(); ++row)
      if (cost(row, col) <= least + as_near) add(std::size_t(row), std::size_t(col));
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// What a part is divided among: middle and half extents along the axes of the part, and the piece.
struct Share
{
  Point middle, half;
  Chart_box* piece;
};

/// Divides a box among shares as they are arranged: along the axis that they are spread over most, in proportion to
/// their extents; those of one place along it are divided on. What lies about one middle shares the box.
inline void divide(const Chart_box& box, std::vector<Share> shares)
{
  constexpr double apart = 0.25;     // a spread that tells, over the largest extent of a share
  constexpr double one_place = 0.15; // over the spread
  int axis = -1;
  double spread = 0;
  for (int a = 0; a < 3; ++a) {
    double low = shares[0].middle[a], high = low, extent = 0;
    for (const Share& share : shares) {
      low = std::min(low, share.middle[a]);
      high = std::max(high, share.middle[a]);
      extent = std::max(extent, 2 * share.half[a]);
    }
    if (quantized(high - low) > quantized(spread) && high - low > apart * extent) axis = a, spread = high - low;
  }
  if (axis < 0) {
    for (const Share& share : shares)
      *share.piece = box;
    return;
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [&](const Share& a, const Share& b) { return a.middle[axis] < b.middle[axis]; });
  std::vector<std::vector<Share>> clusters;
  for (const Share& share : shares) {
    if (clusters.empty() || share.middle[axis] - clusters.back().front().middle[axis] > one_place * spread)
      clusters.emplace_back();
    clusters.back().push_back(share);
  }
  std::vector<double> ends{0};
  for (const std::vector<Share>& cluster : clusters) {
    double extent = Part_chart::least_half_extent;
    for (const Share& share : cluster)
      extent = std::max(extent, share.half[axis]);
    ends.push_back(ends.back() + extent);
  }
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    Chart_box part = box;
    const double low = box.min()[axis], extent = box.sizes()[axis] / ends.back();
    if (c > 0) part.min()[axis] = low + extent * ends[c];
    if (c + 1 < clusters.size()) part.max()[axis] = low + extent * ends[c + 1];
    divide(part, std::move(clusters[c]));
  }
}

inline Share share_of(const Part_chart& divided, const Part_chart& other, Chart_box& piece)
{
  const Eigen::Matrix3d axes = divided.axes();
  return {axes.transpose() * other(Point::Zero()), (axes.transpose() * other.axes()).cwiseAbs() * other.half_extents(),
          &piece};
}

/// Which parts become which: pairs in every set of parts that `pairs` connect, sorted.
inline Index_pairs paired_parts(const Charted_shape& source, const Charted_shape& target, const Index_pairs& pairs)
{
  Index_pairs result;
  for (const Connected_parts& block : connected_parts(pairs, source.charts.size(), target.charts.size())) {
    const Index_pairs in_block = pairs_in(block, source, target);
    result.insert(result.end(), in_block.begin(), in_block.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The charts of the pieces of a pair.
inline std::array<Part_chart, 2> piece_charts(const Part_pair& pair, const Charted_shape& source,
                                              const Charted_shape& target)
{
  const auto piece = [](const Part_chart& chart, const Chart_box& box) {
    return is_whole(box) ? chart : chart.restricted(box.min(), box.max());
  };
  return {piece(source.charts[pair.source], pair.source_piece), piece(target.charts[pair.target], pair.target_piece)};
}

/// By the charts: a part may have that of its mirror image, which need not be of the part's kind.
inline Pair_kind pair_kind(const Part_pair& pair, const Charted_shape& source, const Charted_shape& target)
{
  if (source.parts[pair.source]->is_closed_curve() || target.parts[pair.target]->is_closed_curve())
    return Pair_kind::BOXES;
  const bool are_alike = source.charts[pair.source].is_sheet() == target.charts[pair.target].is_sheet();
  return are_alike ? Pair_kind::SAME : Pair_kind::LENGTHWISE;
}

/// The pairs of pieces that pairs of parts consist of, in the same order.
inline std::vector<Part_pair> part_pairs(const Charted_shape& source, const Charted_shape& target,
                                         const Index_pairs& paired)
{
  std::vector<Part_pair> result(paired.size());
  std::vector<std::vector<Share>> of_source(source.charts.size()), of_target(target.charts.size());
  for (std::size_t i = 0; i < paired.size(); ++i) {
    Part_pair& pair = result[i];
    std::tie(pair.source, pair.target) = paired[i];
    const Part_chart &from = source.charts[pair.source], &to = target.charts[pair.target];
    of_source[pair.source].push_back(share_of(from, to, pair.source_piece));
    of_target[pair.target].push_back(share_of(to, from, pair.target_piece));
  }
  for (const auto* shares : {&of_source, &of_target})
    for (const std::vector<Share>& of_part : *shares)
      if (of_part.size() > 1) divide(whole_chart(), of_part);
  for (Part_pair& pair : result) {
    const auto [from, to] = piece_charts(pair, source, target);
    pair.turn = best_turn(from, to, pair_kind(pair, source, target));
  }
  return result;
}

/// The pairs of pieces that a correspondence consists of, by source part, then target part.
inline std::vector<Part_pair> part_pairs(const Charted_shape& source, const Charted_shape& target,
                                         const Correspondence& correspondence)
{
  return part_pairs(source, target, paired_parts(source, target, correspondence.pairs));
}

/// The charts that a pair of pieces is mapped by: both of one kind, with the same coordinates.
struct Pair_charts
{
  Part_chart source, target;
};

inline Pair_charts pair_charts(const Part_pair& pair, const Charted_shape& source, const Charted_shape& target,
                               const Points& source_piece, const Points& target_piece)
{
  const auto [source_chart, target_chart] = piece_charts(pair, source, target);
  switch (pair_kind(pair, source, target)) {
  case Pair_kind::SAME:
    return {source_chart.fitted(source_piece), target_chart.turned(pair.turn).fitted(target_piece)};
  case Pair_kind::LENGTHWISE: {
    const Eigen::Matrix3d turn =
        target_chart.lengthwise_turn().transpose() * pair.turn * source_chart.lengthwise_turn();
    return {source_chart.lengthwise().fitted(source_piece),
            target_chart.lengthwise().turned(turn).fitted(target_piece)};
  }
  default:
    return {Part_chart::box(source_piece, source_chart.axes()),
            Part_chart::box(target_piece, target_chart.axes() * pair.turn)};
  }
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MAP_PART_PAIR_H
