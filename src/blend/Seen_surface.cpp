// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Seen_surface.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "shape/all_vertices.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether a point is inside a surface, which may have holes: most of six rays cross it an odd number of times.
bool is_inside(const Point& p, const contacts::Triangle_tree& surface)
{
  static const std::array<Point, 3> along = {Point(1, 0.0123, 0.0217), Point(0.0171, 1, 0.0119),
                                             Point(0.0223, 0.0137, 1)}; // oblique, since edges may follow the axes
  constexpr double least_depth = 0.005; // distance, over the height, below which a point is on the surface
  constexpr int most = 5;               // least number of such rays
  if (!surface.box().contains(p)) return false;
  int votes = 0;
  for (const Point& way : along)
    votes += surface.crossings(p, way) % 2 + surface.crossings(p, -way) % 2;
  return votes >= most && !surface.is_near(p, least_depth * least_depth);
}

} // namespace

double share_inside(const Seen_surface& a, const Seen_surface& b)
{
  if (!a.tree.box().intersects(b.tree.box())) return 0;
  constexpr int samples = 24;
  const Part_mesh mesh{a.points, a.part.triangles(a.surface)};
  int inside = 0;
  for (const Point& p : contacts::sample_triangles(contacts::sampled_triangles_of(mesh), samples).points)
    inside += is_inside(p, b.tree);
  return double(inside) / samples;
}

Tree_pointers pointers_to(const std::vector<contacts::Triangle_tree>& trees)
{
  Tree_pointers result(trees.size());
  std::iota(result.begin(), result.end(), trees.data());
  return result;
}

double widest_gap(const Tree_pointers& surfaces, double enough)
{
  // An edge of the tree: quantized length, whether this is a lower bound, the two surfaces, length
  using Candidate = std::tuple<Steps, bool, std::size_t, std::size_t, double>;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue;
  Disjoint_sets components(surfaces.size());
  double result = 0;
  for (std::size_t a = 0; a < surfaces.size(); ++a)
    for (std::size_t b = a + 1; b < surfaces.size(); ++b) {
      const double bound = surfaces[a]->box().exteriorDistance(surfaces[b]->box());
      const bool may_touch = enough > 0 && bound <= enough && components[a] != components[b];
      if (may_touch && surfaces[a]->is_within(*surfaces[b], enough * enough)) {
        components.unite(a, b);
        result = enough;
      } else {
        queue.emplace(quantized(bound), true, a, b, bound);
      }
    }
  while (components.number_of_sets() > 1) {
    const auto [key, is_bound, a, b, length] = queue.top();
    queue.pop();
    if (components[a] == components[b]) continue;
    if (is_bound) {
      contacts::Closest_pair closest;
      surfaces[a]->improve_closest(*surfaces[b], closest);
      const double exact = std::sqrt(closest.squared);
      queue.emplace(quantized(exact), false, a, b, exact);
    } else {
      components.unite(a, b);
      result = length;
    }
  }
  return result;
}

Seen_surface::Seen_surface(const std::vector<Blend_part>& parts, std::size_t number, int surface, const Points& points)
    : number(number), part(parts[number]), surface(surface), points(points), tree(part.trees[std::size_t(surface)])
{
  tree.move([&](std::size_t t) { return triangle_of(points, part.triangles(surface), Eigen::Index(t)); });
}

double number_of_supports(const std::vector<Seen_surface>& surfaces)
{
  return double(std::count_if(surfaces.begin(), surfaces.end(), [](const Seen_surface& surface) {
    return surface.tree.box().min().y() <= Blend_part::on_ground;
  }));
}

} // namespace CGAL::Shape_correspondence::internal
