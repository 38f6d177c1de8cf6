// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Piece_pair.h"
#include "base/Disjoint_sets.h"
#include "base/directions.h"
#include "base/divide_box.h"
#include "base/optimal_assignment.h"
#include "base/quantized.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

Points to_common_frame(const Shape_frame& frame, int quarter_turns, const Points& world)
{
  return quarter_turn(quarter_turns) * frame.to_frame(world);
}

Charted_shape charted_shape(const Structural_graph& graph, int quarter_turns,
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

std::vector<Connected_parts> connected_parts(const Part_pairs& pairs, std::size_t sources, std::size_t targets)
{
  Disjoint_sets connected(sources + targets);
  for (const auto& [s, t] : pairs)
    connected.unite(s, sources + t);
  std::vector<Connected_parts> all(sources + targets), result;
  for (std::size_t i = 0; i < connected.size(); ++i)
    (i < sources ? all[connected[i]].source : all[connected[i]].target).push_back(i < sources ? i : i - sources);
  for (Connected_parts& sets : all)
    if (!sets.source.empty() && !sets.target.empty()) result.push_back(std::move(sets));
  return result;
}

namespace {

/// Relative positions of parts: their centres in the bounding box of all centres.
Points places(const Charted_shape& shape, const std::vector<std::size_t>& parts)
{
  constexpr double least_extent = 0.02; // ratio to the shape's height; along shorter extents, positions count as equal
  Points result(3, Eigen::Index(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i)
    result.col(Eigen::Index(i)) = shape.charts[parts[i]](Point::Zero());
  const Point low = result.rowwise().minCoeff(), extent = result.rowwise().maxCoeff() - low;
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] < least_extent)
      result.row(axis).setConstant(0.5);
    else
      result.row(axis) = (result.row(axis).array() - low[axis]) / extent[axis];
  }
  return result;
}

/// Matches the parts of two sets by relative positions: by optimal assignment as far as their numbers allow; every
/// remaining part with the nearest one, or all about as near, so that symmetric sets are matched symmetrically.
Part_pairs matched_by_place(const Connected_parts& sets, const Charted_shape& source, const Charted_shape& target)
{
  constexpr double as_near =
      0.02; // tolerance, in units of the bounding box, for parts about as near as the nearest one
  // Weight of the distance in the common frame, so that ties are not settled by the order of parts
  constexpr double tie = 1e-3;
  const Points from = places(source, sets.source), to = places(target, sets.target);
  Eigen::MatrixXd cost(from.cols(), to.cols());
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j) {
      const Point way = source.charts[sets.source[std::size_t(i)]](Point::Zero()) -
                        target.charts[sets.target[std::size_t(j)]](Point::Zero());
      cost(i, j) = double(quantized((from.col(i) - to.col(j)).norm() + tie * way.norm())) * comparison_grid;
    }
  const bool fewer_sources = cost.rows() <= cost.cols();
  if (!fewer_sources) cost.transposeInPlace();
  Part_pairs result;
  const auto add = [&](std::size_t row, std::size_t col) {
    result.emplace_back(sets.source[fewer_sources ? row : col], sets.target[fewer_sources ? col : row]);
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
  return result;
}

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

/// The centre and the extents of another part along the axes of the part that is divided.
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

Part_pairs matched_members(const Charted_shape& source, const Charted_shape& target, const Part_pairs& pairs)
{
  Part_pairs result;
  for (const Connected_parts& sets : connected_parts(pairs, source.charts.size(), target.charts.size())) {
    if (sets.source.size() == 1 || sets.target.size() == 1) {
      for (std::size_t s : sets.source)
        for (std::size_t t : sets.target)
          result.emplace_back(s, t);
    } else {
      const Part_pairs matched = matched_by_place(sets, source, target);
      result.insert(result.end(), matched.begin(), matched.end());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

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

std::vector<const Points*> mesh_surfaces(const Segmented_shape& shape)
{
  std::vector<const Points*> result;
  for (const Shape_part& part : shape.parts())
    result.push_back(&part.mesh.points);
  return result;
}

Surface_pair surface_pair(const Piece_pair& pair, const std::array<Charted_shape, 2>& shapes,
                          const std::array<const Part_mesh*, 2>& meshes)
{
  constexpr double longest_edge = 0.3; // length in chart coordinates
  const std::array<std::size_t, 2> part = {pair.source, pair.target};
  const std::array<Chart_box, 2> boxes = {pair.source_piece, pair.target_piece};
  std::array<Part_mesh, 2> wholes, pieces;
  for (std::size_t s = 0; s < 2; ++s) {
    wholes[s] = {shapes[s].surfaces[part[s]], meshes[s]->triangles};
    pieces[s] = piece_of(wholes[s], shapes[s].charts[part[s]], boxes[s]);
  }
  Pair_charts charts = pair_charts(pair, shapes[0], shapes[1], pieces[0].points, pieces[1].points);
  finely_charted(pieces[0], charts.source, longest_edge);
  finely_charted(pieces[1], charts.target, longest_edge);
  const double any_length = std::numeric_limits<double>::infinity();
  return {charts,
          {charted_mesh(wholes[0], charts.source, any_length), charted_mesh(wholes[1], charts.target, any_length)}};
}

} // namespace CGAL::Shape_correspondence::internal
