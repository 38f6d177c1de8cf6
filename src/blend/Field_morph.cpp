// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Field_morph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The half extents of the box of the grid: between the proportions of the boxes and those of a cube, since distances
/// across a plate are to count beside those along it.
Point grid_extents(const Pair_charts& boxes)
{
  constexpr double thin = 1e-3; // of the longest
  const Point extents = boxes.source.half_extents() + boxes.target.half_extents();
  return (extents / extents.maxCoeff()).cwiseMax(thin).cwiseSqrt();
}

/// Points so that they just fill the box from -1 to 1.
Points filling(Points points)
{
  for (int axis = 0; axis < 3 && points.cols() > 0; ++axis) {
    const double low = points.row(axis).minCoeff(), high = points.row(axis).maxCoeff();
    if (high > low) points.row(axis) = (2 * points.row(axis).array() - low - high) / (high - low);
  }
  return points;
}

} // namespace

/// The signed distances from both surfaces, and how much is inside.
struct Field_morph::Fields
{
  Distance_grid grid;
  std::array<Distance_grid::Values, 2> ends;
  std::array<std::size_t, 2> sizes; ///< the number of points inside
  int most_pieces = 1, most_holes = 0;
  bool is_fine = false; ///< either is of rods or has holes that would run together, as spokes and wheels with them

  void add(std::size_t end, const Part_mesh& surface)
  {
    constexpr double excess = 0.3; // of the thickness that the grid gives surfaces
    constexpr int few_holes = 4, many_holes = 30;
    constexpr double least_share = 0.66; // of rods there is half without the excess, of plates 0.7
    Distance_grid::Values& values = ends[end] = grid.signed_distances(surface);
    double level = -excess * grid.thickness();
    const int own_holes = grid.holes_below(values, 0);
    const std::size_t all = grid.number_below(values, 0), without_excess = grid.number_below(values, level);
    if (grid.holes_below(values, level) > own_holes + few_holes) level = 0; // thin plates would be pierced
    sizes[end] = level < 0 ? without_excess : all;
    most_pieces = std::max(most_pieces, grid.pieces_below(values, 0));
    most_holes = end == 0 ? own_holes : std::max(most_holes, own_holes);
    is_fine = is_fine || own_holes > many_holes || double(without_excess) < least_share * double(all);
  }

  /// The share of the smaller inside that is inside of the other, too.
  double common_share() const
  {
    std::size_t common = 0;
    for (std::size_t i = 0; i < ends[0].size(); ++i)
      common += std::size_t(ends[0][i] < 0 && ends[1][i] < 0);
    const auto all = [&](std::size_t end) { return grid.number_below(ends[end], 0); };
    return double(common) / double(std::min(all(0), all(1)));
  }

  /// The level below which there are as many points.
  static double level_of(Distance_grid::Values values, double due)
  {
    const auto number = std::clamp<std::size_t>(std::size_t(std::llround(due)), 1, values.size() - 1);
    const auto at = values.begin() + std::ptrdiff_t(number);
    std::nth_element(values.begin(), at, values.end());
    return *at;
  }
};

Field_morph::Field_morph(const Pair_charts& boxes, const Part_mesh& source, const Part_mesh& target) : Part_morph(boxes)
{
  constexpr int level_sets = 8;
  constexpr double least_common = 0.5;  // of the smaller inside
  constexpr double first_change = 0.35; // when the first level set takes over from the source's surface
  const Point extents = grid_extents(boxes);
  Fields fields{Distance_grid(extents), {}, {}};
  for (int end : {0, 1}) {
    Part_mesh surface = end == 0 ? source : target;
    for (Eigen::Index i = 0; i < surface.points.cols(); ++i)
      surface.points.col(i) = coordinates(end, surface.points.col(i));
    surfaces_.push_back(surface);
    surface.points = extents.asDiagonal() * surface.points;
    fields.add(std::size_t(end), surface);
  }
  Part_mesh last = std::move(surfaces_.back());
  surfaces_.pop_back();
  bool holds = !fields.is_fine && fields.common_share() >= least_common;
  for (int i = 0; i < level_sets && holds; ++i) {
    changes_.push_back(first_change + (1 - 2 * first_change) * i / level_sets);
    holds = add_level_set(fields, (i + 0.5) / level_sets);
  }
  changes_.push_back(1 - first_change);
  if (!holds) {
    changes_ = {0.5};
    surfaces_.resize(1);
  }
  surfaces_.push_back(std::move(last));
}

/// \return whether it holds together
bool Field_morph::add_level_set(const Fields& fields, double share)
{
  constexpr double least_extent = 0.85;
  constexpr int more_holes = 6;
  const Distance_grid& grid = fields.grid;
  Distance_grid::Values mean(fields.ends[0].size());
  for (std::size_t i = 0; i < mean.size(); ++i)
    mean[i] = (1 - share) * fields.ends[0][i] + share * fields.ends[1][i];
  const double due = (1 - share) * double(fields.sizes[0]) + share * double(fields.sizes[1]);
  const double level = Fields::level_of(mean, due);
  if (grid.extents_below(mean, level).minCoeff() < least_extent || grid.pieces_below(mean, level) > fields.most_pieces)
    return false;
  const int own_holes = grid.holes_below(mean, level);
  if (own_holes > fields.most_holes + more_holes) return false;
  Part_mesh surface = grid.level_set(mean, level);
  surface.points = filling(std::move(surface.points));
  surfaces_.push_back(std::move(surface));
  return true;
}

/// A surface goes with the box.
Points Field_morph::points(int surface, double t) const
{
  const Part_chart chart = chart_at(t);
  Points result = surfaces_[std::size_t(surface)].points;
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = chart(result.col(i));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
