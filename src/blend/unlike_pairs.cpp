// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// A grid of points on the spine and the sides of a chart.
Points samples(const Part_chart& chart)
{
  constexpr int steps = 5;
  const auto coordinate = [](int i) { return 2. * (i % steps) / (steps - 1) - 1; };
  Points result(3, steps * steps * steps);
  for (int i = 0; i < int(result.cols()); ++i)
    result.col(i) = chart({coordinate(i / steps / steps), coordinate(i / steps), coordinate(i)});
  return result;
}

/// The extents of the bounding box of a shape, with a lower bound, so that one can divide by them.
Point extents_of(const contacts::Box& whole) { return whole.sizes().cwiseMax(2 * Part_chart::least_half_extent); }

/// A point in units of the bounding box of the shape.
Point relative_place(const contacts::Box& whole, const Point& p)
{
  return (p - whole.min()).cwiseQuotient(extents_of(whole));
}

/// The bounding box of a part in units of the shape's bounding box, enlarged so that a plate's box has a volume.
contacts::Box relative_box(const contacts::Box& whole, const Part_mesh& part)
{
  constexpr double around = 0.03; // margin on every side
  const contacts::Box box = box_of(part.points);
  return {relative_place(whole, box.min()).array() - around, relative_place(whole, box.max()).array() + around};
}

/// The share of the smaller box of a source part and a target part that lies in the other box.
double shared_place(const Blend_stage& stage, std::size_t source, std::size_t target)
{
  const contacts::Box a = relative_box(stage.boxes[0], stage.meshes[0][source]),
                      b = relative_box(stage.boxes[1], stage.meshes[1][target]);
  return a.intersects(b) ? a.intersection(b).volume() / std::min(a.volume(), b.volume()) : 0;
}

void add_leftovers(const Blend_stage& stage, const Unlike_pairs& unlike, Part_pairs& paired)
{
  constexpr double same_place = 0.4; // limit of `shared_place()`, which pairs must exceed
  constexpr double nearly = 0.8;     // share of a pair's shared place with which another pair is its rival
  // Whether a part is in any pair
  std::vector<char> is_source(stage.meshes[0].size(), 0), is_target(stage.meshes[1].size(), 0);
  for (const Part_pairs* pairs : std::array<const Part_pairs*, 2>{&paired, &unlike.all})
    for (const auto& [s, t] : *pairs)
      is_source[s] = is_target[t] = 1;
  Part_pairs leftover = unlike.all;
  for (std::size_t s = 0; s < is_source.size(); ++s)
    for (std::size_t t = 0; t < is_target.size(); ++t)
      if (!is_source[s] && !is_target[t]) leftover.emplace_back(s, t);
  // Shared place of each pair with little difference; 0: no such pair
  Eigen::MatrixXd alike = Eigen::MatrixXd::Zero(is_source.size(), is_target.size());
  for (const auto& [s, t] : leftover) {
    const double shared = shared_place(stage, s, t);
    if (shared <= same_place || unlike.torn.count({s, t}) > 0) continue;
    if (Difference(stage, {stage.charted[0].charts[s], stage.charted[1].charts[t]}).is_little()) alike(s, t) = shared;
  }
  for (const auto& [s, t] : leftover) {
    if (alike(s, t) == 0) continue;
    const Steps least = quantized(nearly * alike(s, t));
    const auto rivals = [&](const Eigen::VectorXd& all) {
      return (all.unaryExpr(&quantized).array() >= least).count();
    };
    // The only rival in its row and in its column is the pair itself
    if (rivals(alike.row(s)) + rivals(alike.col(t)) == 2) paired.emplace_back(s, t);
  }
  std::sort(paired.begin(), paired.end());
}

} // namespace

Difference::Difference(const Blend_stage& stage, const std::array<Part_chart, 2>& charts, bool are_whole)
{
  // Length over the height of the shape, added to extents: ratios of the thickness of thin parts are hardly visible
  constexpr double thin = 0.05;
  const Points a = samples(charts[0]), b = samples(charts[1]);
  const Pair_charts boxes = pair_boxes({&a, &b}, {charts[0].axes(), charts[1].axes()});
  const auto& [whole_box, other_box] = stage.boxes;
  const Point extents = extents_of(whole_box), other_extents = extents_of(other_box);
  const Point from = boxes.source.half_extents(), to = boxes.target.half_extents(),
              growth = are_whole ? Point(other_extents.cwiseQuotient(extents)) : Point::Ones(),
              grown = (growth.asDiagonal() * boxes.source.axes()).colwise().norm().transpose().cwiseProduct(from);
  const auto change_of = [&](const Point& half) {
    return ((half.array() + thin) / (to.array() + thin)).log().abs().sum();
  };
  const auto stretch_of = [&](const Point& half) { return std::abs(std::log(half.maxCoeff() / to.maxCoeff())); };
  change = std::min(change_of(from), change_of(grown));
  stretch = std::min(stretch_of(from), stretch_of(grown));
  size = std::max(box_of(a).sizes().maxCoeff(), box_of(b).sizes().maxCoeff());
  const Point place = relative_place(whole_box, charts[0](Point::Zero())),
              other_place = relative_place(other_box, charts[1](Point::Zero()));
  way = (other_place - place).cwiseProduct((extents + other_extents) / 2).norm();
  whole = (whole_box.diagonal().norm() + other_box.diagonal().norm()) / 2;
}

bool Difference::keeps_shape() const
{
  constexpr double most_change = 1.2, most_stretch = 0.6;
  return change <= most_change && stretch <= most_stretch;
}

bool Difference::is_little() const
{
  constexpr double most_way = 0.25, by_size = 1. / 8;
  return keeps_shape() && way <= most_way + by_size * size;
}

bool Difference::is_possible() const
{
  constexpr double most_way = 0.25; // distance over the diagonal of the shapes
  return is_little() || way <= most_way * whole;
}

bool Difference::stays_near() const
{
  constexpr double most_way = 0.4, by_size = 0.5;
  return way <= most_way + by_size * size;
}

Part_pairs like_pairs(const Blend_stage& stage, const Part_pairs& paired, Unlike_pairs& unlike)
{
  const std::size_t sources = stage.meshes[0].size();
  Disjoint_sets sets(sources + stage.meshes[1].size()); // parts connected by pairs, united with mirror images
  for (const auto& [s, t] : paired) {
    sets.unite(s, sources + t);
    const auto source_image = stage.images[0][s], target_image = stage.images[1][t];
    if (!source_image || !target_image) continue;
    sets.unite(s, *source_image);
    sets.unite(sources + t, sources + *target_image);
  }
  // For each set, whether it has an unlike pair: parts are divided as a whole
  std::vector<char> is_unlike(sets.size(), 0);
  for (const auto& [s, t] : unlike.torn)
    is_unlike[sets[s]] = 1;
  for (const Piece_pair& piece : piece_pairs(stage.charted[0], stage.charted[1], paired)) {
    char& known = is_unlike[sets[piece.source]];
    if (known) continue;
    const Difference difference(stage, piece_charts(piece, stage.charted[0], stage.charted[1]), is_whole(piece));
    known = is_whole(piece) ? !difference.is_possible() : !difference.is_little();
  }
  Part_pairs result;
  unlike.all.clear();
  for (const auto& pair : paired)
    (is_unlike[sets[pair.first]] ? unlike.all : result).push_back(pair);
  add_leftovers(stage, unlike, result);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
