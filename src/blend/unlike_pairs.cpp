// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/unlike_pairs.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/pair_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Points all over the spine and the sides of a chart.
Points samples(const Part_chart& chart)
{
  constexpr int steps = 5;
  const auto coordinate = [](int i) { return 2. * (i % steps) / (steps - 1) - 1; };
  Points result(3, steps * steps * steps);
  for (int i = 0; i < int(result.cols()); ++i)
    result.col(i) = chart({coordinate(i / steps / steps), coordinate(i / steps), coordinate(i)});
  return result;
}

/// The extents of the box around a whole shape, which may be flat.
Point extents_of(const contacts::Box& whole) { return whole.sizes().cwiseMax(2 * Part_chart::least_half_extent); }

/// The box of a part in units of the box around the whole, made a little larger, as a plate has none.
contacts::Box relative_box(const Blend_stage& stage, const Part_of_end& of)
{
  constexpr double around = 0.03;
  const contacts::Box &whole = stage.boxes[of.end], box = box_of(stage.meshes[of.end][of.part].points);
  const Point low = (box.min() - whole.min()).cwiseQuotient(extents_of(whole)),
              high = (box.max() - whole.min()).cwiseQuotient(extents_of(whole));
  return {low.array() - around, high.array() + around};
}

/// How much extents change, in logarithms, summed.
double change_of_extents(const Point& from, const Point& to)
{
  constexpr double thin = 0.05; // of the height: among thin parts, how many times as thick is hardly seen
  return ((from.array() + thin) / (to.array() + thin)).log().abs().sum();
}

/// A source part and a target part, and how much of their place they share.
struct Placed_pair
{
  std::size_t source, target;
  double shared;

  /// Whether one of both parts is nearly as much in the place of one of these.
  bool has_rival(const std::vector<Placed_pair>& all) const
  {
    constexpr double nearly = 0.8; // of the shared place
    return std::any_of(all.begin(), all.end(), [&](const Placed_pair& other) {
      return (other.source == source) != (other.target == target) &&
             quantized(other.shared) >= quantized(nearly * shared);
    });
  }
};

/// Adds pairs of leftover parts.
void add_leftovers(const Blend_stage& stage, const Unlike_pairs& unlike, Part_pairs& paired)
{
  std::vector<char> is_source(stage.meshes[0].size(), 0), is_target(stage.meshes[1].size(), 0); // of any pair
  for (const Part_pairs* pairs : std::array<const Part_pairs*, 2>{&paired, &unlike.all})
    for (const auto& [s, t] : *pairs)
      is_source[s] = is_target[t] = 1;
  Part_pairs leftover = unlike.all;
  for (std::size_t s = 0; s < is_source.size(); ++s)
    for (std::size_t t = 0; t < is_target.size(); ++t)
      if (!is_source[s] && !is_target[t]) leftover.emplace_back(s, t);
  std::vector<Placed_pair> alike;
  for (const auto& [s, t] : leftover) {
    const double shared = shared_place(stage, s, t);
    if (shared <= same_place || unlike.torn.count({s, t}) > 0) continue;
    if (Difference(stage, {stage.charted[0].charts[s], stage.charted[1].charts[t]}).is_little())
      alike.push_back({s, t, shared});
  }
  for (const Placed_pair& placed : alike)
    if (!placed.has_rival(alike)) paired.emplace_back(placed.source, placed.target);
  std::sort(paired.begin(), paired.end());
}

} // namespace

Difference::Difference(const Blend_stage& stage, const std::array<Part_chart, 2>& charts, bool are_whole)
{
  const Points a = samples(charts[0]), b = samples(charts[1]);
  const Pair_charts boxes = pair_boxes({&a, &b}, {charts[0].axes(), charts[1].axes()});
  const std::array<Point, 2> wholes = {extents_of(stage.boxes[0]), extents_of(stage.boxes[1])};
  const Point from = boxes.source.half_extents(), to = boxes.target.half_extents(),
              growth = are_whole ? Point(wholes[1].cwiseQuotient(wholes[0])) : Point::Ones(),
              grown = (growth.asDiagonal() * boxes.source.axes()).colwise().norm().transpose().cwiseProduct(from);
  const auto stretch_of = [&](const Point& extents) { return std::abs(std::log(extents.maxCoeff() / to.maxCoeff())); };
  change = std::min(change_of_extents(from, to), change_of_extents(grown, to));
  stretch = std::min(stretch_of(from), stretch_of(grown));
  size = std::max(box_of(a).sizes().maxCoeff(), box_of(b).sizes().maxCoeff());
  const auto relative_place = [&](std::size_t end) -> Point {
    return (charts[end](Point::Zero()) - stage.boxes[end].min()).cwiseQuotient(wholes[end]);
  };
  way = (relative_place(1) - relative_place(0)).cwiseProduct((wholes[0] + wholes[1]) / 2).norm();
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

bool Difference::stays_near() const
{
  constexpr double most_way = 0.4, by_size = 0.5;
  return way <= most_way + by_size * size;
}

double shared_place(const Blend_stage& stage, const Part_of_end& a, const Part_of_end& b)
{
  const contacts::Box box = relative_box(stage, a), other = relative_box(stage, b);
  return box.intersects(other) ? box.intersection(other).volume() / box.volume() : 0;
}

double shared_place(const Blend_stage& stage, std::size_t source, std::size_t target)
{
  return std::max(shared_place(stage, {0, source}, {1, target}), shared_place(stage, {1, target}, {0, source}));
}

Part_pairs like_pairs(const Blend_stage& stage, const Part_pairs& paired, Unlike_pairs& unlike)
{
  const std::size_t sources = stage.meshes[0].size();
  Disjoint_sets sets(sources + stage.meshes[1].size()); // of parts that pairs connect, mirror images together
  for (const auto& [s, t] : paired) {
    sets.unite(s, sources + t);
    const auto source_image = stage.images[0][s], target_image = stage.images[1][t];
    if (!source_image || !target_image) continue;
    sets.unite(s, *source_image);
    sets.unite(sources + t, sources + *target_image);
  }
  std::vector<char> is_unlike(sets.size(), 0); // by set, whether a pair in it is: a part is divided as a whole
  for (const auto& [s, t] : unlike.torn)
    is_unlike[sets[s]] = 1;
  for (const Piece_pair& piece : piece_pairs(stage.charted[0], stage.charted[1], paired)) {
    char& known = is_unlike[sets[piece.source]];
    if (known) continue;
    known = !Difference(stage, piece_charts(piece, stage.charted[0], stage.charted[1]), is_whole(piece)).is_little();
  }
  Part_pairs result;
  unlike.all.clear();
  for (const auto& pair : paired)
    (is_unlike[sets[pair.first]] ? unlike.all : result).push_back(pair);
  add_leftovers(stage, unlike, result);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
