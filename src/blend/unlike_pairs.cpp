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
  Points result(3, steps * steps * steps);
  Eigen::Index at = 0;
  const auto coordinate = [](int i) { return 2. * i / (steps - 1) - 1; };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k)
        result.col(at++) = chart({coordinate(i), coordinate(j), coordinate(k)});
  return result;
}

/// Where the middle of a chart is in the box around the whole, from 0 to 1 along each axis.
Point relative_place(const Part_chart& chart, const contacts::Box& whole)
{
  const Point sizes = whole.sizes().cwiseMax(Part_chart::least_half_extent);
  return (chart(Point::Zero()) - whole.min()).cwiseQuotient(sizes);
}

/// The box of a part in units of the box around the whole, made a little larger, as a plate has none.
contacts::Box relative_box(const Blend_stage& stage, std::size_t end, std::size_t part)
{
  constexpr double around = 0.03;
  const contacts::Box &whole = stage.boxes[end], box = box_of(stage.meshes[end][part].points);
  const Point sizes = whole.sizes().cwiseMax(2 * Part_chart::least_half_extent);
  const Point low = (box.min() - whole.min()).cwiseQuotient(sizes),
              high = (box.max() - whole.min()).cwiseQuotient(sizes);
  return {low.array() - around, high.array() + around};
}

/// How much extents change, in logarithms, summed.
double change_of_extents(const Point& from, const Point& to)
{
  constexpr double thin = 0.05; // of the height: among thin parts, how many times as thick is hardly seen
  return ((from.array() + thin) / (to.array() + thin)).log().abs().sum();
}

Part_chart chart_of(const contacts::Box& box)
{
  Points corners(3, 2);
  corners << box.min(), box.max();
  return Part_chart::box(corners, Eigen::Matrix3d::Identity());
}

/// Minus how much of their place two parts share, and the parts.
using Placed_pair = std::pair<Steps, Part_pairs::value_type>;

/// Whether one of two parts is nearly as much in the place of another.
bool has_rival(const Placed_pair& placed, const std::vector<Placed_pair>& all)
{
  constexpr double nearly = 0.8; // of the shared place
  const auto share = [](const Placed_pair& of) { return -double(of.first); };
  return std::any_of(all.begin(), all.end(), [&](const Placed_pair& other) {
    const bool has_source = other.second.first == placed.second.first,
               has_target = other.second.second == placed.second.second;
    return has_source != has_target && share(other) >= nearly * share(placed);
  });
}

} // namespace

Difference::Difference(const std::array<Part_chart, 2>& charts, bool are_whole, const Blend_stage& stage)
{
  const Points a = samples(charts[0]), b = samples(charts[1]);
  const Pair_charts boxes = pair_boxes({&a, &b}, {charts[0].axes(), charts[1].axes()});
  turn = internal::turn(boxes);
  const auto extents = [&](std::size_t end) -> Point {
    return stage.boxes[end].sizes().cwiseMax(Part_chart::least_half_extent);
  };
  const Point growth = extents(1).cwiseQuotient(extents(0));
  const Point from = boxes.source.half_extents(), to = boxes.target.half_extents(),
              with_the_whole =
                  (growth.asDiagonal() * boxes.source.axes()).colwise().norm().transpose().cwiseProduct(from);
  change = change_of_extents(from, to);
  const auto stretch_from = [&](const Point& extents) {
    return std::abs(std::log(extents.maxCoeff() / to.maxCoeff()));
  };
  stretch = stretch_from(from);
  if (are_whole) {
    change = std::min(change, change_of_extents(with_the_whole, to));
    stretch = std::min(stretch, stretch_from(with_the_whole));
  }
  size = std::max(box_of(a).sizes().maxCoeff(), box_of(b).sizes().maxCoeff());
  const Point relative = relative_place(charts[1], stage.boxes[1]) - relative_place(charts[0], stage.boxes[0]);
  way = relative.cwiseProduct((stage.boxes[0].sizes() + stage.boxes[1].sizes()) / 2).norm();
}

Difference::Difference(const std::array<contacts::Box, 2>& boxes, const Blend_stage& stage)
    : Difference(std::array<Part_chart, 2>{chart_of(boxes[0]), chart_of(boxes[1])}, true, stage)
{}

bool Difference::keeps_shape() const
{
  constexpr double most_turn = 0.6, most_change = 1.2, most_stretch = 0.6;
  return turn <= most_turn && change <= most_change && stretch <= most_stretch;
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
  const contacts::Box box = relative_box(stage, a.end, a.part), other = relative_box(stage, b.end, b.part);
  return box.intersects(other) ? box.intersection(other).volume() / box.volume() : 0;
}

double shared_place(const Blend_stage& stage, std::size_t source, std::size_t target)
{
  return std::max(shared_place(stage, {0, source}, {1, target}), shared_place(stage, {1, target}, {0, source}));
}

Part_pairs with_leftovers(const Blend_stage& stage, const Unlike_pairs& unlike, Part_pairs paired)
{
  std::array<std::vector<char>, 2> is_used = {std::vector<char>(stage.meshes[0].size(), 0),
                                              std::vector<char>(stage.meshes[1].size(), 0)};
  std::array<std::vector<char>, 2> has_counterpart = is_used;
  for (const auto& [s, t] : paired)
    is_used[0][s] = is_used[1][t] = 1;
  for (const auto& [s, t] : unlike.all)
    has_counterpart[0][s] = has_counterpart[1][t] = 1;
  std::vector<Placed_pair> alike;
  for (std::size_t s = 0; s < is_used[0].size(); ++s)
    for (std::size_t t = 0; t < is_used[1].size(); ++t) {
      const std::pair pair(s, t);
      const bool correspond = std::binary_search(unlike.all.begin(), unlike.all.end(), pair);
      if (is_used[0][s] || is_used[1][t] || unlike.torn.count(pair) > 0) continue;
      if (!correspond && (has_counterpart[0][s] || has_counterpart[1][t])) continue;
      const double shared = shared_place(stage, s, t);
      if (shared <= same_place) continue;
      if (Difference({stage.charted[0].charts[s], stage.charted[1].charts[t]}, true, stage).is_little())
        alike.emplace_back(-quantized(shared), pair);
    }
  std::sort(alike.begin(), alike.end());
  for (const Placed_pair& placed : alike) {
    const auto& pair = placed.second;
    if (is_used[0][pair.first] || is_used[1][pair.second] || has_rival(placed, alike)) continue;
    is_used[0][pair.first] = is_used[1][pair.second] = 1;
    paired.push_back(pair);
  }
  std::sort(paired.begin(), paired.end());
  return paired;
}

void take_unlike_pairs(const Blend_stage& stage, Unlike_pairs& unlike, Part_pairs& paired)
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
    known = !Difference(piece_charts(piece, stage.charted[0], stage.charted[1]), is_whole(piece), stage).is_little();
  }
  const auto first_unlike = std::stable_partition(paired.begin(), paired.end(),
                                                  [&](const auto& pair) { return !is_unlike[sets[pair.first]]; });
  unlike.all.assign(first_unlike, paired.end());
  paired.erase(first_unlike, paired.end());
}

} // namespace CGAL::Shape_correspondence::internal
