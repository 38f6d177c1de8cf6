// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Surface_patches.h"

#include "base/Disjoint_sets.h"
#include "base/eigen_system.h"
#include "base/generic_direction.h"
#include "base/quantized.h"
#include "shape/canonical_surface.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

// Lengths are fractions of the diagonal of the model's box, areas of the area of all triangles.

constexpr double welding_distance = 1e-5;                    // distance of vertices that are one
constexpr double cosine_of_crease = 0.5;                     // 60 degrees: where the surface turns more, a patch ends
constexpr double least_sheet = 0.002, least_patch = 0.0015;  // areas below which a piece joins a neighbour
constexpr std::size_t many_sheets = 150, many_patches = 120; // numbers from which on larger ones join neighbours, too
constexpr std::size_t most_triangles_at_edge = 64;           // at more, none are paired
constexpr double turn_around = 2 * double(EIGEN_PI);         // full turn, in radians
constexpr double same_angle = 0.002;    // angle, in radians, of triangles at an edge that lie on each other
constexpr double concave_height = 1e-6; // least height of a triangle's middle over its neighbour's plane
constexpr int all_samples = 8000;       // number of points on all patches
constexpr int fewest_samples = 12;      // number of points on a patch
// How far a patch may reach out of the box of another to lie in it, and the gap that such a pair counts as.
constexpr double box_margin = 0.01, gap_in_box = 0.03;
constexpr std::size_t most_in_box = 20; // patches that are paired with one that holds them

using Numbers = std::vector<std::size_t>;
using Grid_cell = std::array<std::int64_t, 3>;

struct Grid_cell_hash
{
  std::size_t operator()(const Grid_cell& c) const
  {
    std::uint64_t h = 1469598103934665603u;
    for (std::int64_t x : c)
      h = (h ^ std::uint64_t(x)) * 1099511628211u;
    return std::size_t(h ^ h >> 29);
  }
};

/// Points by cells of a grid, for points that are near each other.
class Point_grid
{
public:
  Point_grid(const Points& points, double cell) : points_(points), cell_(cell)
  {
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      cells_[cell_of(i)].push_back(std::size_t(i));
  }

  /// Calls a function with the other points of a point's cell and of those around it that are near, and with their
  /// squared distances. \param most number of points of a cell that are looked at
  template <typename Function>
  void for_each_near(std::size_t i, double distance, std::size_t most, Function function) const
  {
    const auto point = points_.col(Eigen::Index(i));
    const Grid_cell at = cell_of(Eigen::Index(i));
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto cell = cells_.find({at[0] + x, at[1] + y, at[2] + z});
          if (cell == cells_.end()) continue;
          const std::size_t count = std::min(most, cell->second.size());
          for (std::size_t k = 0; k < count; ++k) {
            const std::size_t j = cell->second[k];
            const double squared = (point - points_.col(Eigen::Index(j))).squaredNorm();
            if (j != i && squared <= distance * distance) function(j, squared);
          }
        }
  }

  /// Calls a function with the points of each cell.
  template <typename Function>
  void for_each_cell(Function function) const
  {
    for (const auto& [cell, points] : cells_)
      function(points);
  }

private:
  Grid_cell cell_of(Eigen::Index i) const
  {
    Grid_cell result;
    for (int k = 0; k < 3; ++k)
      result[std::size_t(k)] = std::int64_t(std::floor(points_(k, i) / cell_));
    return result;
  }

  const Points& points_;
  double cell_;
  std::unordered_map<Grid_cell, Numbers, Grid_cell_hash> cells_;
};

/// Numbers from 0 on for the sets, in the order of their first elements.
Numbers numbers_of_sets(const Disjoint_sets& sets)
{
  Numbers result(sets.size()), number(sets.size(), sets.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::size_t& n = number[sets[i]];
    if (n == sets.size()) n = count++;
    result[i] = n;
  }
  return result;
}

std::size_t numbers_in(const Numbers& numbers)
{
  return numbers.empty() ? 0 : 1 + *std::max_element(numbers.begin(), numbers.end());
}

/// A side of a triangle.
struct Triangle_side
{
  std::size_t low, high; // places of its ends
  std::size_t triangle;
  int corner;      // that it begins at
  bool is_forward; // from `low` to `high`
};

class Patch_finder
{
public:
  Patch_finder(const Segmented_shape& objects, const Eigen::Matrix3d& axes,
               const std::vector<std::vector<int>>& materials)
      : objects_(objects)
  {
    collect(axes);
    std::map<std::pair<std::size_t, int>, std::size_t> numbers;
    for (std::size_t t = 0, object = 0, begin = 0; t < object_.size(); ++t) {
      if (object_[t] != object) {
        object = object_[t];
        begin = t;
      }
      const int material = materials.empty() ? 0 : materials[object][t - begin];
      material_.push_back(numbers.emplace(std::pair(object, material), numbers.size()).first->second);
    }
    weld();
    find_edges();
  }

  Surface_patches divided()
  {
    find_sheets();
    find_patches();
    sort_patches();
    number_triangles();
    if (numbers_in(patch_) > most_patches) {
      result_.patches.resize(numbers_in(patch_));
      return std::move(result_);
    }
    measure();
    find_borders();
    find_near();
    find_common_places();
    find_in_boxes();
    find_shapes();
    for (const auto& [pair, contact] : contacts_)
      result_.contacts.push_back({pair.first, pair.second, contact});
    return std::move(result_);
  }

private:
  using Pair = std::pair<std::size_t, std::size_t>;
  using Weights = std::map<Pair, double>;

  void collect(const Eigen::Matrix3d& axes)
  {
    std::vector<Point> points;
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < objects_.parts().size(); ++i) {
      const Part_mesh& mesh = objects_.parts()[i].mesh;
      const std::size_t begin = points.size();
      for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
        points.push_back(axes * mesh.points.col(v));
      for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
        corners_.push_back({});
        for (int k = 0; k < 3; ++k) {
          corners_.back()[std::size_t(k)] = begin + std::size_t(mesh.triangles(k, t));
          box.extend(points[corners_.back()[std::size_t(k)]]);
        }
        object_.push_back(i);
      }
    }
    const double diagonal = box.diagonal().norm();
    result_.sides = box.diagonal() / diagonal;
    points_.resize(3, Eigen::Index(points.size()));
    for (std::size_t v = 0; v < points.size(); ++v)
      points_.col(Eigen::Index(v)) = (points[v] - box.min()) / diagonal;
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      const Point normal = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
      const double twice = normal.norm();
      areas_.push_back(twice / 2);
      normals_.push_back(normal / std::max(twice, 1e-30));
      result_.area += twice / 2;
    }
  }

  Point corner(std::size_t t, int k) const { return points_.col(Eigen::Index(corners_[t][std::size_t(k)])); }
  Point middle(std::size_t t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }
  std::size_t place(std::size_t t, int k) const { return place_[corners_[t][std::size_t(k)]]; }

  void weld()
  {
    constexpr std::size_t most_compared = 8; // of a cell, whose points are one place in any case
    Disjoint_sets sets(std::size_t(points_.cols()));
    const Point_grid grid(points_, welding_distance / 2);
    grid.for_each_cell([&](const Numbers& points) {
      for (std::size_t i : points)
        sets.unite(points[0], i);
      grid.for_each_near(points[0], welding_distance, most_compared,
                         [&](std::size_t j, double) { sets.unite(points[0], j); });
    });
    place_ = numbers_of_sets(sets);
  }

  void find_edges()
  {
    for (std::size_t t = 0; t < corners_.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const std::size_t a = place(t, k), b = place(t, (k + 1) % 3);
        if (a != b) edges_.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
      }
    std::stable_sort(edges_.begin(), edges_.end(), [](const Triangle_side& a, const Triangle_side& b) {
      return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
  }

  /// Calls a function with the range of sides at each edge.
  template <typename Function>
  void for_each_edge(Function function) const
  {
    for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
      while (end < edges_.size() && edges_[end].low == edges_[begin].low && edges_[end].high == edges_[begin].high)
        ++end;
      function(begin, end);
    }
  }

  bool is_degenerate(std::size_t t) const
  {
    return place(t, 0) == place(t, 1) || place(t, 1) == place(t, 2) || place(t, 2) == place(t, 0);
  }

  void find_sheets()
  {
    Disjoint_sets sheets(corners_.size()), components(std::size_t(points_.cols()));
    for (std::size_t t = 0; t < corners_.size(); ++t)
      for (int k = 1; k < 3; ++k)
        components.unite(place(t, 0), place(t, k));
    for_each_edge([&](std::size_t begin, std::size_t end) { join_across(begin, end, sheets); });
    const Numbers of_places = numbers_of_sets(components);
    for (std::size_t t = 0; t < corners_.size(); ++t)
      component_.push_back(of_places[place(t, 0)]);
    sheet_ = numbers_of_sets(sheets);
    absorb_small_sheets();
  }

  void join_across(std::size_t begin, std::size_t end, Disjoint_sets& sheets) const
  {
    Numbers sides;
    for (std::size_t e = begin; e < end; ++e)
      if (!is_degenerate(edges_[e].triangle)) sides.push_back(e);
    if (sides.size() < 2 || sides.size() > most_triangles_at_edge) return;
    if (sides.size() == 2) return join(sides[0], sides[1], sheets);
    const std::vector<double> angles = angles_around(sides);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      // the next one, on its inner side, that runs the other way
      double least = 9;
      std::size_t next = i;
      for (std::size_t j = 0; j < sides.size(); ++j) {
        if (edges_[sides[i]].is_forward == edges_[sides[j]].is_forward) continue;
        double turn = edges_[sides[i]].is_forward ? angles[i] - angles[j] : angles[j] - angles[i];
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
    if (material_[edges_[a].triangle] == material_[edges_[b].triangle])
      sheets.unite(edges_[a].triangle, edges_[b].triangle);
  }

  /// The angles of triangles around an edge, to a thousandth.
  std::vector<double> angles_around(const Numbers& sides) const
  {
    const auto end = [&](const Triangle_side& edge, bool last) {
      return corner(edge.triangle, (edge.corner + (last == edge.is_forward ? 1 : 0)) % 3);
    };
    const Triangle_side& first = edges_[sides[0]];
    const Point along = (end(first, true) - end(first, false)).normalized();
    Point x = Point::Zero(), y = Point::Zero();
    std::vector<double> result;
    for (std::size_t side : sides) {
      const Triangle_side& edge = edges_[side];
      Point w = corner(edge.triangle, (edge.corner + 2) % 3) - end(edge, false);
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
      result[numbers[t]] += areas_[t];
    return result;
  }

  /// Lets what is smaller than a share of the area join the neighbour of greatest weight, if that is larger.
  /// \return whether anything was joined
  bool join_small(Numbers& numbers, const Weights& weights, double share) const
  {
    const std::vector<double> areas = areas_of(numbers);
    const auto is_better = [&](double weight, std::size_t i, double than, std::size_t j) {
      return weight != than ? weight > than : areas[i] > areas[j];
    };
    std::vector<std::pair<double, std::size_t>> best(areas.size(), {0, areas.size()});
    const auto offer = [&](std::size_t to, std::size_t from, double weight) {
      if (areas[to] >= share * result_.area) return;
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

  /// Small sheets join the one of the same object with which they have the longest edges in common.
  void absorb_small_sheets()
  {
    for (double factor : {1., 1., 4., 10.}) {
      if (factor > 1 && numbers_in(sheet_) < many_sheets) return;
      Weights common;
      for_each_edge([&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin + 1; e < end; ++e)
          add_common(edges_[e - 1].triangle, edges_[e].triangle, length(edges_[e]), common);
      });
      for_each_place([&](const Numbers& triangles) {
        for (std::size_t i = 1; i < triangles.size(); ++i)
          add_common(triangles[i - 1], triangles[i], welding_distance, common);
      });
      if (!join_small(sheet_, common, factor * least_sheet)) return;
    }
  }

  void add_common(std::size_t a, std::size_t b, double length, Weights& common) const
  {
    if (sheet_[a] != sheet_[b] && material_[a] == material_[b]) common[std::minmax(sheet_[a], sheet_[b])] += length;
  }

  /// Calls a function with the triangles at each place.
  template <typename Function>
  void for_each_place(Function function) const
  {
    std::vector<Numbers> triangles(numbers_in(place_));
    for (std::size_t t = 0; t < corners_.size(); ++t)
      for (int k = 0; k < 3; ++k)
        triangles[place(t, k)].push_back(t);
    for (const Numbers& at : triangles)
      function(at);
  }

  /// Sides of neighbours in the same sheet.
  template <typename Function>
  void for_each_neighbours(Function function) const
  {
    for (std::size_t e = 1; e < edges_.size(); ++e) {
      const Triangle_side &a = edges_[e - 1], &b = edges_[e];
      if (a.low == b.low && a.high == b.high && sheet_[a.triangle] == sheet_[b.triangle]) function(a, b);
    }
  }

  /// Cosine of the angle between the normals, with one turned if the triangles are oriented differently.
  double cosine(const Triangle_side& a, const Triangle_side& b) const
  {
    const double d = normals_[a.triangle].dot(normals_[b.triangle]);
    return a.is_forward == b.is_forward ? -d : d;
  }

  double length(const Triangle_side& edge) const
  {
    return (corner(edge.triangle, (edge.corner + 1) % 3) - corner(edge.triangle, edge.corner)).norm();
  }

  void find_patches()
  {
    Disjoint_sets sets(corners_.size());
    for_each_neighbours([&](const Triangle_side& a, const Triangle_side& b) {
      const bool is_flat = areas_[a.triangle] <= 0 || areas_[b.triangle] <= 0;
      if (is_flat || cosine(a, b) > cosine_of_crease) sets.unite(a.triangle, b.triangle);
    });
    patch_ = numbers_of_sets(sets);
    double least = least_patch;
    constexpr int rounds = 24, rounds_of_small_ones = 6;
    for (int round = 0; round < rounds; ++round) {
      if (round >= rounds_of_small_ones) {
        if (numbers_in(patch_) < many_patches) break;
        least *= 1.5;
      }
      Weights borders;
      for_each_neighbours([&](const Triangle_side& a, const Triangle_side& b) {
        const auto [i, j] = std::minmax(patch_[a.triangle], patch_[b.triangle]);
        if (i != j) borders[{i, j}] += length(a) + 1e-9;
      });
      if (!join_small(patch_, borders, least) && round < rounds_of_small_ones) round = rounds_of_small_ones - 1;
      if (borders.empty()) break;
    }
  }

  /// Numbers the patches by their place, so that ties do not depend on the order of triangles.
  void sort_patches()
  {
    std::vector<Surface_moments> moments(numbers_in(patch_));
    for (std::size_t t = 0; t < corners_.size(); ++t)
      moments[patch_[t]] += {areas_[t], areas_[t] * middle(t), Eigen::Matrix3d::Zero()};
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

  /// The triangles of a patch, as they do not depend on how it is divided.
  std::vector<std::array<Point, 3>> canonical_triangles(const Numbers& triangles) const
  {
    Part_mesh mesh;
    mesh.points.resize(3, 3 * Eigen::Index(triangles.size()));
    mesh.triangles.resize(3, Eigen::Index(triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        mesh.points.col(3 * Eigen::Index(i) + k) = corner(triangles[i], k);
        mesh.triangles(k, Eigen::Index(i)) = 3 * int(i) + k;
      }
    const Part_mesh canonical = canonical_surface(mesh, flatness_tolerance(1));
    std::vector<std::array<Point, 3>> result;
    for (Eigen::Index t = 0; t < canonical.triangles.cols(); ++t)
      result.push_back(triangle_of(canonical, t));
    return result;
  }

  void measure()
  {
    std::vector<Numbers> triangles(numbers_in(patch_));
    for (std::size_t t = 0; t < corners_.size(); ++t)
      triangles[patch_[t]].push_back(t);
    for (const Numbers& of_patch : triangles) {
      result_.patches.push_back({{}, {}, object_[of_patch[0]], sheet_[of_patch[0]], component_[of_patch[0]], 0});
      Surface_patch& patch = result_.patches.back();
      surfaces_.emplace_back();
      for (const std::array<Point, 3>& t : canonical_triangles(of_patch)) {
        const double area = (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
        const Point sum = t[0] + t[1] + t[2];
        Eigen::Matrix3d second = sum * sum.transpose();
        for (const Point& p : t) {
          second += p * p.transpose();
          patch.box.extend(p);
        }
        patch.moments += {area, area / 3 * sum, area / 12 * second};
        surfaces_.back().push_back({t[0], t[1] - t[0], t[2] - t[0], area});
      }
    }
  }

  /// Tells the patch of each triangle.
  void number_triangles()
  {
    std::size_t next = 0;
    for (const Shape_part& object : objects_.parts()) {
      const auto count = std::ptrdiff_t(object.mesh.triangles.cols());
      const auto begin = patch_.begin() + std::ptrdiff_t(next);
      result_.of_triangles.emplace_back(begin, begin + count);
      next += std::size_t(count);
    }
  }

  Patch_contact& contact(std::size_t i, std::size_t j, double gap)
  {
    Patch_contact& result = contacts_.try_emplace(std::minmax(i, j), Patch_contact{gap}).first->second;
    result.gap = std::min(result.gap, gap);
    return result;
  }

  void find_borders()
  {
    for_each_neighbours([&](const Triangle_side& a, const Triangle_side& b) {
      const std::size_t i = patch_[a.triangle], j = patch_[b.triangle];
      if (i == j) return;
      Patch_contact& border = contact(i, j, 0);
      const double l = length(a);
      border.border += l;
      border.flat_border += l * cosine(a, b);
      const Point off = middle(b.triangle) - middle(a.triangle);
      if (normals_[a.triangle].dot(off) > concave_height) border.concave_border += l;
    });
  }

  /// Distances between patches, by samples.
  void find_near()
  {
    std::vector<Point> samples;
    Numbers of_patch, count;
    const int fewest = std::clamp(all_samples / int(surfaces_.size()), 3, fewest_samples);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const double share = result_.patches[i].moments.area / result_.area;
      const int number = std::max(fewest, int(std::lround(share * all_samples)));
      const auto found = contacts::sample_triangles(surfaces_[i], number);
      samples.insert(samples.end(), found.points.begin(), found.points.end());
      of_patch.resize(samples.size(), i);
      count.push_back(found.points.size());
    }
    Points points(3, Eigen::Index(samples.size()));
    for (std::size_t k = 0; k < samples.size(); ++k)
      points.col(Eigen::Index(k)) = samples[k];
    const Point_grid grid(points, patch_reach);
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> nearest(surfaces_.size(), far); // squared distance of a sample, by patch
    Numbers found;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const std::size_t own = of_patch[k];
      grid.for_each_near(k, patch_reach, samples.size(), [&](std::size_t other, double squared) {
        const std::size_t patch = of_patch[other];
        if (patch == own) return;
        if (nearest[patch] == far) found.push_back(patch);
        nearest[patch] = std::min(nearest[patch], squared);
      });
      for (std::size_t patch : found) {
        contact(own, patch, std::sqrt(nearest[patch])).near[own < patch ? 0 : 1] +=
            result_.patches[own].moments.area / double(count[own]);
        nearest[patch] = far;
      }
      found.clear();
    }
  }

  /// Patches of different sheets with common vertices.
  void find_common_places()
  {
    for_each_place([&](const Numbers& triangles) {
      std::set<std::size_t> patches;
      for (std::size_t t : triangles)
        patches.insert(patch_[t]);
      constexpr std::size_t most = 7; // at the hub of more, nothing is told by it
      if (patches.size() > most) return;
      for (auto i = patches.begin(); i != patches.end(); ++i)
        for (auto j = std::next(i); j != patches.end(); ++j)
          if (result_.patches[*i].sheet != result_.patches[*j].sheet) contact(*i, *j, 0).has_common_places = true;
    });
  }

  /// Patches that lie in the box of another one may be merged with it.
  void find_in_boxes()
  {
    if (result_.patches.size() > many_sheets) return;
    for (std::size_t i = 0; i < result_.patches.size(); ++i) {
      Eigen::AlignedBox3d box = result_.patches[i].box;
      box.min().array() -= box_margin;
      box.max().array() += box_margin;
      std::size_t count = 0;
      for (std::size_t j = 0; j < result_.patches.size() && count < most_in_box; ++j)
        if (j != i && box.contains(result_.patches[j].box)) {
          contact(i, j, gap_in_box);
          ++count;
        }
    }
  }

  /// Numbers for patches of about the same area and principal lengths.
  void find_shapes()
  {
    std::vector<Eigen::Array4d> sizes;
    for (const Surface_patch& patch : result_.patches) {
      const double area = std::max(patch.moments.area, 1e-12);
      const Point centre = patch.moments.first / area;
      const Eigen::Vector3d variances =
          eigen_system(patch.moments.second / area - centre * centre.transpose()).values.cwiseMax(0);
      sizes.push_back({std::sqrt(area), std::sqrt(variances[0]), std::sqrt(variances[1]), std::sqrt(variances[2])});
    }
    Numbers order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return quantized(sizes[a][0]) > quantized(sizes[b][0]); });
    constexpr double same_length = 0.004, same_share = 0.04, same_area = 0.015; // of roots of areas
    std::vector<bool> is_known(sizes.size(), false);
    std::size_t number = 0;
    for (std::size_t i : order) {
      if (is_known[i]) continue;
      for (std::size_t j : order)
        if (!is_known[j] && ((sizes[i] - sizes[j]).abs() <= same_length + same_share * sizes[i][0]).all() &&
            std::abs(sizes[i][0] - sizes[j][0]) <= same_area * sizes[i][0]) {
          is_known[j] = true;
          result_.patches[j].shape = number;
        }
      ++number;
    }
  }

  const Segmented_shape& objects_;
  Surface_patches result_;
  Points points_;
  std::vector<std::array<std::size_t, 3>> corners_;       // by triangle, indices of points
  Numbers object_, material_, sheet_, component_, patch_; // by triangle; a material is of one object
  std::vector<double> areas_;
  std::vector<Point> normals_;
  Numbers place_;                                                 // by point
  std::vector<Triangle_side> edges_;                              // sorted by place
  std::vector<std::vector<contacts::Sampled_triangle>> surfaces_; // by patch, canonical
  std::map<Pair, Patch_contact> contacts_;
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
  return Patch_finder(objects, axes, materials).divided();
}

} // namespace CGAL::Shape_correspondence::internal
