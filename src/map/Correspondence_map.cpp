// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quantized.h"
#include "map/Surface_pair.h"
#include "map/check_model.h"

#include <CGAL/Shape_correspondence/Correspondence_map.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

/// How two closed curves are run through: from where on the second, and in which direction, so that the sum of squared
/// distances is least once the centres are aligned (paper, section 5, "Deform-to-fit").
std::pair<double, double> closed_curve_fit(const Part_abstraction& source, const Points& source_points,
                                           const Part_abstraction& target, const Points& target_points)
{
  constexpr int n = 48;
  const auto samples = [&](const Part_abstraction& part, const Points& points) {
    const Points result = sample(Curve{points, std::get<Curve>(part.geometry).closed}, n);
    return Points(result.colwise() - result.rowwise().mean());
  };
  const Points from = samples(source, source_points), to = samples(target, target_points);
  std::pair<double, double> best(0, 1);
  long best_score = std::numeric_limits<long>::min();
  for (int step : {1, -1})
    for (int start = 0; start < n; ++start) {
      double sum = 0;
      for (int i = 0; i < n; ++i)
        sum += from.col(i).dot(to.col((start + step * i + n) % n));
      if (quantized(sum) > best_score) best_score = quantized(sum), best = {double(start) / n, step};
    }
  return best;
}

/// The points that stand for the surfaces of parts without a mesh.
std::vector<const Points*> sampled_surfaces(const Structural_graph& graph)
{
  std::vector<const Points*> result;
  for (const Part_abstraction& part : structure(graph).parts)
    result.push_back(&part.surface);
  return result;
}

} // namespace

Correspondence_map::Correspondence_map(const Structural_graph& source, const Structural_graph& target,
                                       const Correspondence& correspondence)
    : pieces_(structure(source).parts.size()), targets_(structure(target).parts.size())
{
  using namespace internal;
  const int turns = correspondence.target_quarter_turns;
  const Charted_shape from = charted_shape(source, 0, sampled_surfaces(source));
  const Charted_shape to = charted_shape(target, turns, sampled_surfaces(target));
  const auto side = [](const Charted_shape& shape, std::size_t part, const Chart_box& piece) {
    Side result;
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
    Piece_map map;
    map.source = side(from, pair.source, pair.source_piece);
    map.target = side(to, pair.target, pair.target_piece);
    Eigen::Matrix3d turn = pair.turn;
    if (pair_kind(pair, from, to) == Pair_kind::BOXES) // a closed curve runs the long way of a sheet, from its start
      turn = to.charts[pair.target].lengthwise_turn() * from.charts[pair.source].lengthwise_turn().transpose();
    map.turn = turn.topLeftCorner<2, 2>();
    map.closed = s.is_closed_curve() && t.is_closed_curve();
    if (map.closed)
      std::tie(map.shift, map.step) =
          closed_curve_fit(s, to_common_frame(structure(source).frame, 0, s.control_points()), t,
                           to_common_frame(structure(target).frame, turns, t.control_points()));
    pieces_[pair.source].push_back(map);
  }
}

std::vector<Part_parameter> Correspondence_map::operator()(const Part_parameter& place) const
{
  constexpr double on_border = 1e-9;
  std::vector<Part_parameter> result;
  for (const Piece_map& map : pieces_[place.part]) {
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
      const double f = std::clamp((turned[i] + 1) / 2, 0., 1.);
      image.parameter[i] = (1 - f) * map.target.low[i] + f * map.target.high[i];
    }
    result.push_back(image);
  }
  return result;
}

Correspondence_map Correspondence_map::inverse() const
{
  Correspondence_map result;
  result.pieces_.resize(targets_);
  result.targets_ = pieces_.size();
  for (const std::vector<Piece_map>& pieces : pieces_)
    for (Piece_map map : pieces) {
      std::swap(map.source, map.target);
      map.turn.transposeInPlace();
      map.shift = map.step > 0 ? -map.shift : map.shift;
      result.pieces_[map.source.part].push_back(map);
    }
  return result;
}

Surface_map::Surface_map(const Structural_graph& source, const Segmented_shape& source_shape,
                         const Structural_graph& target, const Segmented_shape& target_shape,
                         const Correspondence& correspondence)
{
  using namespace internal;
  check_model(source, source_shape);
  check_model(target, target_shape);
  const std::array<const Segmented_shape*, 2> shapes = {&source_shape, &target_shape};
  const std::array<Charted_shape, 2> charted = {
      charted_shape(source, 0, mesh_surfaces(source_shape)),
      charted_shape(target, correspondence.target_quarter_turns, mesh_surfaces(target_shape))};
  std::array<Places*, 2> places = {&targets_, &sources_}; // of the source's vertices, of the target's
  std::array<std::vector<std::vector<double>>, 2> off;    // of every vertex, how far it is outside of its piece
  for (std::size_t s = 0; s < 2; ++s)
    for (const Shape_part& part : shapes[s]->parts()) {
      places[s]->emplace_back(std::size_t(part.mesh.points.cols()));
      off[s].emplace_back(std::size_t(part.mesh.points.cols()), std::numeric_limits<double>::infinity());
      if (s == 0) triangles_.push_back(part.mesh.triangles);
    }

  for (const Piece_pair& pair : piece_pairs(charted[0], charted[1], correspondence)) {
    const std::array<std::size_t, 2> part = {pair.source, pair.target};
    const std::array<Chart_box, 2> boxes = {pair.source_piece, pair.target_piece};
    const auto mesh = [&](std::size_t s) -> const Part_mesh& { return shapes[s]->parts()[part[s]].mesh; };
    const std::array<Charted_mesh, 2> whole = surface_pair(pair, charted, {&mesh(0), &mesh(1)}).meshes;
    const std::array<Points, 2> normals = {chart_normals(whole[0]), chart_normals(whole[1])};
    for (std::size_t s = 0; s < 2; ++s) {
      const std::size_t other = 1 - s;
      const Place_finder finder(whole[other].coordinates, whole[other].triangles, normals[other]);
      for (Eigen::Index v = 0; v < whole[s].points.cols(); ++v) {
        const Point k = charted[s].charts[part[s]].coordinates(whole[s].points.col(v));
        const double outside = is_whole(boxes[s]) ? 0 : boxes[s].squaredExteriorDistance(k);
        double& least = off[s][part[s]][std::size_t(v)];
        if (outside >= least) continue;
        least = outside;
        const Mesh_place found = finder(whole[s].coordinates.col(v), normals[s].col(v));
        (*places[s])[part[s]][std::size_t(v)] = Surface_place{part[other], found.triangle, found.weights,
                                                              found.of(mesh(other).points, mesh(other).triangles)};
      }
    }
  }
}

std::optional<Surface_place> Surface_map::source_of(std::size_t target_part, Eigen::Index vertex) const
{
  return sources_[target_part][std::size_t(vertex)];
}

std::optional<Surface_place> Surface_map::target_of(std::size_t source_part, Eigen::Index vertex) const
{
  return targets_[source_part][std::size_t(vertex)];
}

} // namespace CGAL::Shape_correspondence
