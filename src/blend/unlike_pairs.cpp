// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/unlike_pairs.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/pair_boxes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double most_change_divided = 1.2; // of the extents of pieces, as `change()` sums them

/// The lowest and the highest corner.
Points corners(const contacts::Box& box)
{
  Points result(3, 2);
  result << box.min(), box.max();
  return result;
}

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

/// Whether two parts, or pieces, are too unlike to become each other.
/// \param is_divided whether either is a piece: pieces have to fit better
bool are_unlike(const std::array<Part_chart, 2>& charts, bool is_divided, const Blend_stage& stage)
{
  constexpr double most_turn = 0.6; // radians
  const double most_change = is_divided ? most_change_divided : 1.5, most_travel = is_divided ? 0.25 : 0.4;
  const Points a = samples(charts[0]), b = samples(charts[1]);
  const double size = std::max(box_of(a).sizes().maxCoeff(), box_of(b).sizes().maxCoeff());
  const Point travel = relative_place(charts[1], stage.boxes[1]) - relative_place(charts[0], stage.boxes[0]);
  const Point sizes = (stage.boxes[0].sizes() + stage.boxes[1].sizes()) / 2;
  if (travel.cwiseProduct(sizes).norm() > most_travel + size / 8) return true;
  const Pair_charts boxes = pair_boxes({&a, &b}, {charts[0].axes(), charts[1].axes()});
  const double by = turn(boxes);
  return by > most_turn || change(boxes) - by > most_change;
}

/// The boxes around the parts that a divided pair is of, and all counterparts, have to be alike, too: a shelf is not
/// cut up for shelves above each other.
bool are_unlike(const std::array<contacts::Box, 2>& around)
{
  const Points a = corners(around[0]), b = corners(around[1]);
  return change(upright_boxes({&a, &b})) > most_change_divided;
}

} // namespace

bool are_unlike(const Blend_stage& stage, std::size_t source, std::size_t target)
{
  return are_unlike({stage.charted[0].charts[source], stage.charted[1].charts[target]}, false, stage);
}

Part_pairs take_unlike_pairs(const Blend_stage& stage, Part_pairs& paired)
{
  const std::size_t sources = stage.meshes[0].size(), targets = stage.meshes[1].size();
  Disjoint_sets sets(sources + targets);
  std::vector<std::size_t> uses(sources + targets, 0);
  for (const auto& [s, t] : paired) {
    sets.unite(s, sources + t);
    ++uses[s];
    ++uses[sources + t];
    const std::size_t other_s = stage.images[0][s], other_t = stage.images[1][t];
    if (other_s != Mirror_images::none && other_t != Mirror_images::none) { // images go together
      sets.unite(s, other_s);
      sets.unite(sources + t, sources + other_t);
    }
  }
  const auto boxes_around = [&](const std::pair<std::size_t, std::size_t>& pair) {
    std::array<contacts::Box, 2> result;
    for (const auto& [s, t] : paired)
      if (s == pair.first || t == pair.second) {
        result[0].extend(box_of(stage.meshes[0][s].points));
        result[1].extend(box_of(stage.meshes[1][t].points));
      }
    return result;
  };
  std::vector<char> is_unlike(sources + targets, 0); // by set
  for (const Piece_pair& pair : piece_pairs(stage.charted[0], stage.charted[1], paired)) {
    const bool is_divided = uses[pair.source] > 1 || uses[sources + pair.target] > 1;
    if ((is_divided && are_unlike(boxes_around({pair.source, pair.target}))) ||
        are_unlike(piece_charts(pair, stage.charted[0], stage.charted[1]), is_divided, stage))
      is_unlike[sets[pair.source]] = 1;
  }
  Part_pairs kept, result;
  for (const auto& pair : paired)
    (is_unlike[sets[pair.first]] ? result : kept).push_back(pair);
  paired = std::move(kept);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
