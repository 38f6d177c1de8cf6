// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Surface_patches.h"

#include "base/directions.h"
#include "base/quantized.h"
#include "shape/Welded_triangles.h"
#include "shape/patch_contacts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

// Areas are shares of the area of all triangles.

constexpr double cosine_of_crease = 0.5;                     // 60 degrees: where the surface turns more, a patch ends
constexpr double least_sheet = 0.002, least_patch = 0.0015;  // areas below which a sheet or a patch joins a neighbour
constexpr std::size_t many_sheets = 150, many_patches = 120; // if there are as many, larger ones join, too
constexpr std::size_t most_triangles_at_edge = 64;           // at an edge with more, no triangles are paired
constexpr double turn_around = 2 * double(EIGEN_PI);         // full turn, in radians
constexpr double same_angle = 0.002; // largest angle, in radians, of triangles at an edge that lie on each other

class Patch_finder
{
public:
  Patch_finder(const Welded_triangles& triangles, const std::vector<std::vector<int>>& materials)
      : triangles_(triangles)
  {
    std::map<std::pair<std::size_t, int>, std::size_t> numbers;
    for (std::size_t t = 0, object = 0, begin = 0; t < triangles.size(); ++t) {
      if (triangles.objects[t] != object) {
        object = triangles.objects[t];
        begin = t;
      }
      const int material = materials.empty() ? 0 : materials[object][t - begin];
      material_.push_back(numbers.emplace(std::pair(object, material), numbers.size()).first->second);
    }
    find_sheets();
    find_patches();
    sort_patches();
  }

  Triangle_pieces found() && { return {std::move(sheet_), std::move(component_), std::move(patch_)}; }

private:
  using Pair = std::pair<std::size_t, std::size_t>;
  using Weights = std::map<Pair, double>;

  void find_sheets()
  {
    Disjoint_sets sheets(triangles_.size()), components(std::size_t(triangles_.points.cols()));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int k = 1; k < 3; ++k)
        components.unite(triangles_.place(t, 0), triangles_.place(t, k));
    triangles_.for_each_edge([&](std::size_t begin, std::size_t end) { join_across(begin, end, sheets); });
    const Numbers of_places = numbers_of_sets(components);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      component_.push_back(of_places[triangles_.place(t, 0)]);
    sheet_ = numbers_of_sets(sheets);
    absorb_small_sheets();
  }

  void join_across(std::size_t begin, std::size_t end, Disjoint_sets& sheets) const
  {
    Numbers sides;
    for (std::size_t e = begin; e < end; ++e)
      if (!triangles_.is_degenerate(triangles_.edges[e].triangle)) sides.push_back(e);
    if (sides.size() < 2 || sides.size() > most_triangles_at_edge) return;
    if (sides.size() == 2) return join(sides[0], sides[1], sheets);
    const std::vector<double> angles = angles_around(sides);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      // the nearest triangle on the inner side of this one, of those that run along the edge in the other direction
      double least = 9;
      std::size_t next = i;
      for (std::size_t j = 0; j < sides.size(); ++j) {
        if (triangles_.edges[sides[i]].is_forward == triangles_.edges[sides[j]].is_forward) continue;
        double turn = triangles_.edges[sides[i]].is_forward ? angles[i] - angles[j] : angles[j] - angles[i];
        turn -= turn_around * std::floor(turn / turn_around);
        if (turn < same_angle || turn >= least) continue;
        least = turn;
        next = j;
      }
      if (next != i) join(sides[i], sides[next], sheets);
    }
  }

  void join(std::size_t a, std::size_t b, Disjoint_sets& sheets) const
  {
    if (material_[triangles_.edges[a].triangle] == material_[triangles_.edges[b].triangle])
      sheets.unite(triangles_.edges[a].triangle, triangles_.edges[b].triangle);
  }

  /// The angles of triangles around an edge, in radians, rounded to 0.001.
  std::vector<double> angles_around(const Numbers& sides) const
  {
    const auto end = [&](const Triangle_side& edge, bool last) {
      return triangles_.corner(edge.triangle, (edge.corner + (last == edge.is_forward ? 1 : 0)) % 3);
    };
    const Triangle_side& first = triangles_.edges[sides[0]];
    const Point along = (end(first, true) - end(first, false)).normalized();
    Point x = Point::Zero(), y = Point::Zero();
    std::vector<double> result;
    for (std::size_t side : sides) {
      const Triangle_side& edge = triangles_.edges[side];
      Point w = triangles_.corner(edge.triangle, (edge.corner + 2) % 3) - end(edge, false);
      w -= w.dot(along) * along;
      if (result.empty()) {
        x = w.normalized();
        y = along.cross(x);
      }
      result.push_back(std::round(std::atan2(w.dot(y), w.dot(x)) * 1000) / 1000);
    }
    return result;
  }

  std::vector<double> areas_of(const Numbers& numbers) const
  {
    std::vector<double> result(numbers_in(numbers), 0);
    for (std::size_t t = 0; t < numbers.size(); ++t)
      result[numbers[t]] += triangles_.areas[t];
    return result;
  }

  /// Lets sheets or patches with less than a share of the area join their neighbour of greatest weight, if that is
  /// larger. \param numbers indexed by triangle: its sheet or patch \return whether any joined
  bool join_small(Numbers& numbers, const Weights& weights, double share) const
  {
    const std::vector<double> areas = areas_of(numbers);
    const auto is_better = [&](double weight, std::size_t i, double than, std::size_t j) {
      return weight != than ? weight > than : areas[i] > areas[j];
    };
    std::vector<std::pair<double, std::size_t>> best(areas.size(), {0, areas.size()});
    const auto offer = [&](std::size_t to, std::size_t from, double weight) {
      if (areas[to] >= share * triangles_.area) return;
      auto& [greatest, neighbour] = best[to];
      if (neighbour == areas.size() || is_better(weight, from, greatest, neighbour)) best[to] = {weight, from};
    };
    for (const auto& [pair, weight] : weights) {
      offer(pair.first, pair.second, weight);
      offer(pair.second, pair.first, weight);
    }
    Disjoint_sets sets(areas.size());
    for (std::size_t i = 0; i < best.size(); ++i) {
      const std::size_t to = best[i].second;
      if (to < areas.size() && std::pair(areas[to], i) > std::pair(areas[i], to)) sets.unite(i, to);
    }
    if (sets.number_of_sets() == areas.size()) return false;
    const Numbers joined = numbers_of_sets(sets);
    for (std::size_t& number : numbers)
      number = joined[number];
    return true;
  }

  /// Lets small sheets join the sheet of the same object and material with which they share most length of edges.
  void absorb_small_sheets()
  {
    for (double factor : {1., 1., 4., 10.}) {
      if (factor > 1 && numbers_in(sheet_) < many_sheets) return;
      Weights common;
      triangles_.for_each_edge([&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin + 1; e < end; ++e)
          add_common(triangles_.edges[e - 1].triangle, triangles_.edges[e].triangle,
                     triangles_.length(triangles_.edges[e]), common);
      });
      for (const Numbers& at : triangles_.triangles_of_places())
        for (std::size_t i = 1; i < at.size(); ++i)
          add_common(at[i - 1], at[i], welding_distance, common);
      if (!join_small(sheet_, common, factor * least_sheet)) return;
    }
  }

  void add_common(std::size_t a, std::size_t b, double length, Weights& common) const
  {
    if (sheet_[a] != sheet_[b] && material_[a] == material_[b]) common[std::minmax(sheet_[a], sheet_[b])] += length;
  }

  void find_patches()
  {
    Disjoint_sets sets(triangles_.size());
    triangles_.for_each_neighbours(sheet_, [&](const Triangle_side& a, const Triangle_side& b) {
      const bool is_flat = triangles_.areas[a.triangle] <= 0 || triangles_.areas[b.triangle] <= 0;
      if (is_flat || triangles_.cosine(a, b) > cosine_of_crease) sets.unite(a.triangle, b.triangle);
    });
    patch_ = numbers_of_sets(sets);
    double least = least_patch;
    constexpr int rounds = 24, rounds_of_small_ones = 6; // later rounds also join larger patches, if there are many
    for (int round = 0; round < rounds; ++round) {
      if (round >= rounds_of_small_ones) {
        if (numbers_in(patch_) < many_patches) break;
        least *= 1.5;
      }
      Weights borders;
      triangles_.for_each_neighbours(sheet_, [&](const Triangle_side& a, const Triangle_side& b) {
        const auto [i, j] = std::minmax(patch_[a.triangle], patch_[b.triangle]);
        if (i != j) borders[{i, j}] += triangles_.length(a) + 1e-9;
      });
      if (!join_small(patch_, borders, least) && round < rounds_of_small_ones) round = rounds_of_small_ones - 1;
      if (borders.empty()) break;
    }
  }

  /// Numbers the patches by their positions, so that ties do not depend on the order of triangles.
  void sort_patches()
  {
    std::vector<Surface_moments> moments(numbers_in(patch_));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      moments[patch_[t]] += {triangles_.areas[t], triangles_.areas[t] * triangles_.middle(t), Eigen::Matrix3d::Zero()};
    std::vector<std::tuple<Steps, Steps, std::size_t>> order;
    for (const Surface_moments& of_patch : moments)
      order.emplace_back(quantized(generic_direction().dot(of_patch.first) / std::max(of_patch.area, 1e-12)),
                         -quantized(of_patch.area), order.size());
    std::sort(order.begin(), order.end());
    Numbers number(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      number[std::get<2>(order[i])] = i;
    for (std::size_t& patch : patch_)
      patch = number[patch];
  }

  const Welded_triangles& triangles_;
  Numbers material_, sheet_, component_, patch_; // indexed by triangle; each object has material numbers of its own
};

} // namespace

Patch_contact& Patch_contact::operator+=(const Patch_contact& other)
{
  gap = std::min(gap, other.gap);
  near[0] += other.near[0];
  near[1] += other.near[1];
  border += other.border;
  flat_border += other.flat_border;
  concave_border += other.concave_border;
  has_common_places |= other.has_common_places;
  return *this;
}

Patch_contact Patch_contact::reversed() const
{
  Patch_contact result = *this;
  std::swap(result.near[0], result.near[1]);
  return result;
}

Surface_patches surface_patches(const Segmented_shape& objects, const Eigen::Matrix3d& axes,
                                const std::vector<std::vector<int>>& materials)
{
  const Welded_triangles triangles(objects, axes);
  const Triangle_pieces pieces = Patch_finder(triangles, materials).found();
  Surface_patches result;
  result.sides = triangles.sides;
  result.area = triangles.area;
  std::size_t next = 0;
  for (const Shape_part& object : objects.parts()) {
    const auto begin = pieces.patches.begin() + std::ptrdiff_t(next);
    next += std::size_t(object.mesh.triangles.cols());
    result.of_triangles.emplace_back(begin, pieces.patches.begin() + std::ptrdiff_t(next));
  }
  measure_patches(triangles, pieces, result);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
