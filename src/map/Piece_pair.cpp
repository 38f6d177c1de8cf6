// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Piece_pair.h"

#include "base/divide_box.h"
#include "base/quantized.h"

#include <algorithm>
#include <cstdint>
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

namespace {

/// The rotation between the coordinates of two charts that best aligns their longest extents (paper, section 5,
/// "Deform-to-fit": extremities are matched by proximity).
Eigen::Matrix3d best_turn(const Part_chart& source, const Part_chart& target, Pair_kind kind)
{
  const bool lengthwise = kind == Pair_kind::LENGTHWISE;
  const Part_chart a = lengthwise ? source.lengthwise() : source, b = lengthwise ? target.lengthwise() : target;
  Eigen::Matrix3d before = Eigen::Matrix3d::Identity(), after = before;
  if (lengthwise) before = source.lengthwise_turn().transpose(), after = target.lengthwise_turn();
  const Eigen::Matrix3d from = a.axes() * a.half_extents().asDiagonal();
  const Eigen::Matrix3d to = b.axes() * b.half_extents().asDiagonal();
  const int kept = a.is_sheet() ? 2 : 0;
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  std::int64_t best_score = std::numeric_limits<std::int64_t>::min();
  for (const Eigen::Matrix3d& turn : cube_rotations()) {
    if (kind != Pair_kind::BOXES && turn(kept, kept) == 0) continue;
    const std::int64_t score = quantized(from.cwiseProduct(to * turn).sum());
    if (score > best_score) best = after * turn * before, best_score = score;
  }
  return best;
}

/// Centre and extents of another part along the axes of a part to be divided.
Share share_of(const Part_chart& divided, const Part_chart& other)
{
  const Eigen::Matrix3d axes = divided.axes();
  return {axes.transpose() * other(Point::Zero()), (axes.transpose() * other.axes()).cwiseAbs() * other.half_extents()};
}

/// The shares by which a part is divided, and the resulting pieces.
struct Division
{
  std::vector<Share> shares;
  std::vector<Chart_box*> pieces;

  void add(const Share& share, Chart_box& piece)
  {
    shares.push_back(share);
    pieces.push_back(&piece);
  }

  void divide() const
  {
    const std::vector<Chart_box> boxes = divide_box(whole_chart(), shares);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      *pieces[i] = boxes[i];
  }
};

} // namespace

std::array<Part_chart, 2> piece_charts(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target)
{
  const auto piece = [](const Part_chart& chart, const Chart_box& box) {
    return is_whole(box) ? chart : chart.restricted(box.min(), box.max());
  };
  return {piece(source.charts[pair.source], pair.source_piece), piece(target.charts[pair.target], pair.target_piece)};
}

Pair_kind pair_kind(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target)
{
  if (source.parts[pair.source]->is_closed_curve() || target.parts[pair.target]->is_closed_curve())
    return Pair_kind::BOXES;
  const bool are_alike = source.charts[pair.source].is_sheet() == target.charts[pair.target].is_sheet();
  return are_alike ? Pair_kind::SAME : Pair_kind::LENGTHWISE;
}

std::vector<Piece_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target, const Part_pairs& paired)
{
  std::vector<Piece_pair> result(paired.size());
  std::vector<Division> of_source(source.charts.size()), of_target(target.charts.size());
  for (std::size_t i = 0; i < paired.size(); ++i) {
    Piece_pair& pair = result[i];
    std::tie(pair.source, pair.target) = paired[i];
    const Part_chart &from = source.charts[pair.source], &to = target.charts[pair.target];
    of_source[pair.source].add(share_of(from, to), pair.source_piece);
    of_target[pair.target].add(share_of(to, from), pair.target_piece);
  }
  for (const auto* divisions : {&of_source, &of_target})
    for (const Division& division : *divisions)
      division.divide();
  for (Piece_pair& pair : result) {
    const auto [from, to] = piece_charts(pair, source, target);
    pair.turn = best_turn(from, to, pair_kind(pair, source, target));
  }
  return result;
}

std::vector<Piece_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target,
                                    const Correspondence& correspondence)
{
  return piece_pairs(source, target, matched_members(source, target, part_pairs(correspondence.pairs)));
}

Pair_charts pair_charts(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target,
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
