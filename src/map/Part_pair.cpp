// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Part_pair.h"

#include "base/quantized.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

std::vector<Eigen::Matrix3d> cube_rotations()
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

std::optional<Eigen::Matrix3d> best_turn(const Part_chart& source, const Part_chart& target, Pair_kind kind,
                                         const std::function<bool(const Eigen::Matrix3d&)>& is_allowed)
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

namespace {

Eigen::Matrix3d best_turn(const Part_chart& source, const Part_chart& target, Pair_kind kind)
{
  return *best_turn(source, target, kind, [](const Eigen::Matrix3d&) { return true; });
}

/// What a part is divided among: middle and half extents along the axes of the part, and the piece.
struct Share
{
  Point middle, half;
  Chart_box* piece;
};

/// Divides a box among shares as they are arranged: along the axis that they are spread over most, in proportion to
/// their extents; those of one place along it are divided on. What lies about one middle shares the box.
void divide(const Chart_box& box, std::vector<Share> shares)
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

Share share_of(const Part_chart& divided, const Part_chart& other, Chart_box& piece)
{
  const Eigen::Matrix3d axes = divided.axes();
  return {axes.transpose() * other(Point::Zero()), (axes.transpose() * other.axes()).cwiseAbs() * other.half_extents(),
          &piece};
}

} // namespace

std::array<Part_chart, 2> piece_charts(const Part_pair& pair, const Charted_shape& source, const Charted_shape& target)
{
  const auto piece = [](const Part_chart& chart, const Chart_box& box) {
    return is_whole(box) ? chart : chart.restricted(box.min(), box.max());
  };
  return {piece(source.charts[pair.source], pair.source_piece), piece(target.charts[pair.target], pair.target_piece)};
}

Pair_kind pair_kind(const Part_pair& pair, const Charted_shape& source, const Charted_shape& target)
{
  if (source.parts[pair.source]->is_closed_curve() || target.parts[pair.target]->is_closed_curve())
    return Pair_kind::BOXES;
  const bool are_alike = source.charts[pair.source].is_sheet() == target.charts[pair.target].is_sheet();
  return are_alike ? Pair_kind::SAME : Pair_kind::LENGTHWISE;
}

std::vector<Part_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target, const Part_pairs& paired)
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

std::vector<Part_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target,
                                   const Correspondence& correspondence)
{
  return piece_pairs(source, target, matched_members(source, target, part_pairs(correspondence.pairs)));
}

Pair_charts pair_charts(const Part_pair& pair, const Charted_shape& source, const Charted_shape& target,
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

} // namespace CGAL::Shape_correspondence::internal
