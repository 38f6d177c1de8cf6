// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/clamped.h"
#include "base/limits.h"
#include "base/quantized.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Correspondence_map.h>

#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

/// Start on the second of two closed curves, and direction (1 or -1), for which the sum of squared distances is least
/// after aligning the centres (paper, section 5, "Deform-to-fit").
std::pair<double, double> closed_curve_fit(const Part_abstraction& source, const Points& source_points,
                                           const Part_abstraction& target, const Points& target_points)
{
  constexpr int n = 48; // number of samples of either curve, and of starts that are tried
  const auto samples = [&](const Part_abstraction& part, const Points& points) {
    const Points result = sample(Curve{points, std::get<Curve>(part.geometry).closed}, n);
    return Points(result.colwise() - result.rowwise().mean());
  };
  const Points from = samples(source, source_points), to = samples(target, target_points);
  std::pair<double, double> best(0, 1);
  std::int64_t best_score = std::numeric_limits<std::int64_t>::min();
  for (int step : {1, -1})
    for (int start = 0; start < n; ++start) {
      double sum = 0;
      for (int i = 0; i < n; ++i)
        sum += from.col(i).dot(to.col((start + step * i + n) % n));
      if (quantized(sum) > best_score) best_score = quantized(sum), best = {double(start) / n, step};
    }
  return best;
}

/// The samples of the parts' surfaces, which stand for their meshes.
std::vector<const Points*> sampled_surfaces(const Structural_graph& graph)
{
  std::vector<const Points*> result;
  for (const Part_abstraction& part : structure(graph).parts)
    result.push_back(&part.surface);
  return result;
}

} // namespace

struct Correspondence_map::Pieces
{
  struct Side
  {
    std::size_t part = 0;
    int dimension = 1;                           ///< 1 for a curve, 2 for a sheet
    std::array<double, 2> low{0, 0}, high{1, 1}; ///< bounds of the piece, in parameters
  };
  /// A map between pieces of two parts.
  struct Piece_map
  {
    Side source, target;
    Eigen::Matrix2d turn; ///< maps parameters of one piece, in [-1, 1], to those of the other
    bool closed = false;  ///< whether both are closed curves: then t becomes shift + step t
    double shift = 0, step = 1;
  };

  std::vector<std::vector<Piece_map>> of_part; ///< maps by source part
  std::size_t targets = 0;
};

Correspondence_map::Correspondence_map(std::shared_ptr<const Pieces> pieces) : pieces_(std::move(pieces)) {}

Correspondence_map::Correspondence_map(const Structural_graph& source, const Structural_graph& target,
                                       const Correspondence& correspondence)
{
  Pieces pieces;
  pieces.of_part.resize(structure(source).parts.size());
  pieces.targets = structure(target).parts.size();
  const int turns = correspondence.target_quarter_turns;
  const Charted_shape from = charted_shape(source, 0, sampled_surfaces(source));
  const Charted_shape to = charted_shape(target, turns, sampled_surfaces(target));
  const auto side = [](const Charted_shape& shape, std::size_t part, const Chart_box& piece) {
    Pieces::Side result;
    result.part = part;
    result.dimension = shape.parts[part]->is_sheet() ? 2 : 1;
    if (shape.parts[part]->is_closed_curve()) return result;
    for (int i = 0; i < result.dimension; ++i) {
      result.low[i] = (piece.min()[i] + 1) / 2;
      result.high[i] = (piece.max()[i] + 1) / 2;
    }
    return result;
  };
  for (const Piece_pair& pair : piece_pairs(from, to, correspondence)) {
    const Part_abstraction &s = *from.parts[pair.source], &t = *to.parts[pair.target];
    Pieces::Piece_map map;
    map.source = side(from, pair.source, pair.source_piece);
    map.target = side(to, pair.target, pair.target_piece);
    Eigen::Matrix3d turn = pair.turn;
    // Maps a closed curve along the longer direction of a sheet, from its start
    if (pair_kind(pair, from, to) == Pair_kind::BOXES)
      turn = to.charts[pair.target].lengthwise_turn() * from.charts[pair.source].lengthwise_turn().transpose();
    map.turn = turn.topLeftCorner<2, 2>();
    map.closed = s.is_closed_curve() && t.is_closed_curve();
    if (map.closed)
      std::tie(map.shift, map.step) =
          closed_curve_fit(s, to_common_frame(structure(source).frame, 0, s.control_points()), t,
                           to_common_frame(structure(target).frame, turns, t.control_points()));
    pieces.of_part[pair.source].push_back(map);
  }
  pieces_ = std::make_shared<const Pieces>(std::move(pieces));
}

std::vector<Part_parameter> Correspondence_map::operator()(const Part_parameter& place) const
{
  constexpr double on_border = 1e-9; // distance from a piece, in its coordinates from -1 to 1, that counts as inside
  check_index("Correspondence_map", "part", place.part, pieces_->of_part.size());
  std::vector<Part_parameter> result;
  for (const Pieces::Piece_map& map : pieces_->of_part[place.part]) {
    if (map.closed) {
      const double t = map.shift + map.step * place.parameter[0];
      result.push_back({map.target.part, {t - std::floor(t), 0}});
      continue;
    }
    Eigen::Vector2d inside = Eigen::Vector2d::Zero();
    bool is_inside = true;
    for (int i = 0; i < map.source.dimension; ++i) {
      const double extent = map.source.high[i] - map.source.low[i];
      inside[i] = 2 * (place.parameter[i] - map.source.low[i]) / extent - 1;
      is_inside = is_inside && std::abs(inside[i]) <= 1 + on_border;
    }
    if (!is_inside) continue;
    const Eigen::Vector2d turned = map.turn * inside;
    Part_parameter image{map.target.part, Eigen::Vector2d::Zero()};
    for (int i = 0; i < map.target.dimension; ++i) {
      const double f = clamped_to_unit((turned[i] + 1) / 2);
      image.parameter[i] = (1 - f) * map.target.low[i] + f * map.target.high[i];
    }
    result.push_back(image);
  }
  return result;
}

Correspondence_map Correspondence_map::inverse() const
{
  Pieces result;
  result.of_part.resize(pieces_->targets);
  result.targets = pieces_->of_part.size();
  for (const std::vector<Pieces::Piece_map>& pieces : pieces_->of_part)
    for (Pieces::Piece_map map : pieces) {
      std::swap(map.source, map.target);
      map.turn.transposeInPlace();
      map.shift = map.step > 0 ? -map.shift : map.shift;
      result.of_part[map.source.part].push_back(map);
    }
  return Correspondence_map(std::make_shared<const Pieces>(std::move(result)));
}

} // namespace CGAL::Shape_correspondence
