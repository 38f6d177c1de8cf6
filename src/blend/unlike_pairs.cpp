// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/unlike_pairs.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/Rest_surface.h"
#include "blend/pair_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Part_pair = Part_pairs::value_type;

// Of the extents: of parts, of sets of parts, and of pieces
constexpr double most_change = 2, most_change_of_sets = 1.5, most_change_divided = 1.2;

/// The pair of the mirror images, if both parts have one.
std::optional<Part_pair> image_of(const Blend_stage& stage, const Part_pair& pair)
{
  const std::size_t s = stage.images[0][pair.first], t = stage.images[1][pair.second];
  if (s == Mirror_images::none || t == Mirror_images::none) return {};
  return Part_pair(s, t);
}

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

/// How far the middle of the one chart is from where it is due, that of the other, in the boxes of the shapes.
double travel(const std::array<Part_chart, 2>& charts, const Blend_stage& stage)
{
  const Point way = relative_place(charts[1], stage.boxes[1]) - relative_place(charts[0], stage.boxes[0]);
  return way.cwiseProduct((stage.boxes[0].sizes() + stage.boxes[1].sizes()) / 2).norm();
}

/// How much has to happen to a part, or a piece, to become another.
struct Difference
{
  Difference(const std::array<Part_chart, 2>& charts, const Blend_stage& stage)
  {
    constexpr double least_size = 1e-3; // of the height
    const Points a = samples(charts[0]), b = samples(charts[1]);
    const Pair_charts boxes = pair_boxes({&a, &b}, {charts[0].axes(), charts[1].axes()});
    size = std::max(box_of(a).sizes().maxCoeff(), box_of(b).sizes().maxCoeff());
    turns = turn(boxes);
    // What becomes wider or flatter as the whole does keeps its proportions
    const Point whole = stage.boxes[0].sizes().cwiseQuotient(stage.boxes[1].sizes().cwiseMax(least_size));
    const Points with_whole = whole.asDiagonal() * b;
    const Pair_charts relative = pair_boxes({&a, &with_whole}, {charts[0].axes(), charts[1].axes()});
    changes = std::min(change(boxes) - turns, change(relative) - turn(relative));
    travels = travel(charts, stage);
  }

  bool is_too_much(double most_travel, double most_changes) const
  {
    constexpr double most_turn = 0.6; // radians
    return travels > most_travel || turns > most_turn || changes > most_changes;
  }
  bool is_too_much_for_parts() const { return is_too_much(far(), most_change); }
  bool is_too_much_for_sets() const { return is_too_much(far(), most_change_of_sets); }
  bool is_too_much_for_pieces() const { return is_too_much(near(), most_change_divided); }
  /// Of one of several parts, so that one leg of four does not become a column.
  bool is_too_much_for_one_of_several() const { return is_too_much(near(), most_change); }
  double far() const { return 0.4 + size / 2; }
  double near() const { return 0.25 + size / 8; }

  double sum() const { return turns + changes + travels; }

  double size, turns, changes, travels;
};

/// Whether each of two parts is much longer than the other along some axis: neither is a piece of the other.
bool are_across(const Blend_stage& stage, const Part_pair& pair)
{
  constexpr double much = 2, thin = 0.05; // of the height: among thin parts, how many times as thick says little
  const Point from = box_of(stage.meshes[0][pair.first].points).sizes().array() + thin;
  const Point to = box_of(stage.meshes[1][pair.second].points).sizes().array() + thin;
  return from.cwiseQuotient(to).maxCoeff() > much && to.cwiseQuotient(from).maxCoeff() > much;
}

/// The boxes around the parts that a divided pair is of, and all counterparts, have to be alike, too: a shelf is not
/// cut up for shelves above each other.
bool are_boxes_unlike(const std::array<contacts::Box, 2>& around)
{
  const Points a = corners(around[0]), b = corners(around[1]);
  return change(upright_boxes({&a, &b})) > most_change_divided;
}

/// Pairs, and which parts they connect, mirror images together.
class Pair_sets
{
public:
  Pair_sets(const Blend_stage& stage, const Part_pairs& pairs)
      : stage_(stage), pairs_(pairs), sets_(stage.meshes[0].size() + stage.meshes[1].size()), uses_(sets_.size(), 0)
  {
    for (const Part_pair& pair : pairs) {
      sets_.unite(pair.first, target(pair));
      ++uses_[pair.first];
      ++uses_[target(pair)];
      if (const std::optional<Part_pair> image = image_of(stage, pair)) {
        sets_.unite(pair.first, image->first);
        sets_.unite(target(pair), target(*image));
      }
    }
  }

  std::size_t of(const Part_pair& pair) const { return sets_[pair.first]; }
  bool is_divided(const Part_pair& pair) const { return uses_[pair.first] > 1 || uses_[target(pair)] > 1; }

  /// By set, whether some pair in it is of pieces, or parts, that are too unlike: a part is divided as a whole.
  std::vector<char> are_unlike(const Torn_pairs& torn) const
  {
    std::vector<char> result(sets_.size(), 0);
    for (const auto& [pair, reason] : torn)
      result[of(pair)] = 1;
    const std::vector<Piece_pair> pieces = piece_pairs(stage_.charted[0], stage_.charted[1], pairs_);
    for (const Piece_pair& piece : pieces) {
      const Part_pair pair(piece.source, piece.target);
      if (result[of(pair)]) continue;
      const Difference difference(piece_charts(piece, stage_.charted[0], stage_.charted[1]), stage_);
      result[of(pair)] = is_divided(pair) ? are_boxes_unlike(boxes_around(pair)) || difference.is_too_much_for_pieces()
                                          : difference.is_too_much_for_parts();
    }
    return result;
  }

private:
  std::size_t target(const Part_pair& pair) const { return stage_.meshes[0].size() + pair.second; }

  std::array<contacts::Box, 2> boxes_around(const Part_pair& pair) const
  {
    std::array<contacts::Box, 2> result;
    for (const auto& [s, t] : pairs_)
      if (s == pair.first || t == pair.second) {
        result[0].extend(box_of(stage_.meshes[0][s].points));
        result[1].extend(box_of(stage_.meshes[1][t].points));
      }
    return result;
  }

  const Blend_stage& stage_;
  const Part_pairs& pairs_;
  Disjoint_sets sets_;
  std::vector<std::size_t> uses_;
};

double area_of(const Part_mesh& mesh) { return Rest_surface(mesh.points, mesh.triangles).extent().area; }

} // namespace

bool are_unlike(const Blend_stage& stage, std::size_t source, std::size_t target)
{
  return Difference({stage.charted[0].charts[source], stage.charted[1].charts[target]}, stage).is_too_much_for_parts();
}

bool are_unlike(const Blend_stage& stage, const Pair_charts& boxes)
{
  return Difference({boxes.source, boxes.target}, stage).is_too_much_for_sets();
}

Part_pairs most_alike(const Blend_stage& stage, const Part_pairs& pairs)
{
  std::vector<std::pair<Steps, Part_pair>> order;
  for (const Part_pair& pair : pairs) {
    if (stage.charted[0].parts[pair.first]->is_closed_curve() != stage.charted[1].parts[pair.second]->is_closed_curve())
      continue; // the hole would be torn open
    const double as_much =
        std::abs(std::log(area_of(stage.meshes[0][pair.first]) / area_of(stage.meshes[1][pair.second])));
    const Difference difference({stage.charted[0].charts[pair.first], stage.charted[1].charts[pair.second]}, stage);
    if (as_much <= most_change && !difference.is_too_much_for_one_of_several())
      order.emplace_back(quantized(difference.sum() + as_much), pair);
  }
  std::sort(order.begin(), order.end());
  std::array<std::vector<char>, 2> is_taken;
  for (std::size_t end : {0u, 1u})
    is_taken[end].resize(stage.meshes[end].size(), 0);
  const auto is_free = [&](const Part_pair& pair) { return !is_taken[0][pair.first] && !is_taken[1][pair.second]; };
  Part_pairs result;
  for (const auto& [cost, pair] : order) {
    const Part_pair image = image_of(stage, pair).value_or(pair);
    if (!is_free(pair) || !is_free(image) || (image.first == pair.first) != (image.second == pair.second)) continue;
    for (const Part_pair& taken : {pair, image}) {
      if (!is_free(taken)) continue; // its own image
      result.push_back(taken);
      is_taken[0][taken.first] = is_taken[1][taken.second] = 1;
    }
  }
  return result;
}

Part_pairs take_unlike_pairs(const Blend_stage& stage, const Torn_pairs& torn, Part_pairs& paired)
{
  const Pair_sets all(stage, paired);
  Part_pairs fitting;
  for (const Part_pair& pair : paired)
    if (!all.is_divided(pair) || !(are_across(stage, pair) || are_across(stage, image_of(stage, pair).value_or(pair))))
      fitting.push_back(pair);
  const Pair_sets sets(stage, fitting);
  const std::vector<char> is_unlike = sets.are_unlike(torn);
  Part_pairs kept;
  for (const Part_pair& pair : fitting)
    if (!is_unlike[sets.of(pair)]) kept.push_back(pair);
  Part_pairs result;
  std::set_difference(paired.begin(), paired.end(), kept.begin(), kept.end(), std::back_inserter(result));
  paired = std::move(kept);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
