// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_stage.h"
#include "base/Disjoint_sets.h"
#include "base/directions.h"
#include "base/quantized.h"
#include "map/Piece_pair.h"
#include "shape/oriented_box.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether a point is inside a surface, which may have holes: most of six rays cross it an odd number of times.
bool is_inside(const Point& p, const contacts::Triangle_tree& surface)
{
  static const std::array<Point, 3> along = {Point(1, 0.0123, 0.0217), Point(0.0171, 1, 0.0119),
                                             Point(0.0223, 0.0137, 1)}; // oblique, since edges may follow the axes
  constexpr double least_depth = 0.005; // distance, over the height, below which a point is on the surface
  constexpr int most = 5;               // least number of rays with odd crossings of a point inside
  if (!surface.box().contains(p)) return false;
  int votes = 0;
  for (const Point& way : along)
    votes += surface.crossings(p, way) % 2 + surface.crossings(p, -way) % 2;
  return votes >= most && !surface.is_near(p, least_depth * least_depth);
}

bool is_mirrored_in_x(const Blend_input& input)
{
  const Shape_frame& frame = structure(input.graph).frame;
  return input.quarter_turns % 2 == 0 ? frame.mirror_x : frame.mirror_z;
}

/// The frame of the stage, in which the surface itself, not its samples, stands on the ground, centred, with height 1.
Shape_frame staged_frame(const Blend_input& input)
{
  constexpr double upright = 0.5; // height in the given frame, up to which a shape counts as flat and keeps that scale
  Shape_frame frame = structure(input.graph).frame;
  contacts::Box box;
  for (const Shape_part& part : input.shape.parts())
    box.extend(box_of(to_common_frame(frame, input.quarter_turns, part.mesh.points)));
  const Point origin(is_mirrored_in_x(input) ? 0 : box.center().x(), box.min().y(), box.center().z());
  frame.origin += frame.axes * quarter_turn(input.quarter_turns).transpose() * (frame.height * origin);
  if (box.sizes().y() > upright) frame.height *= box.sizes().y();
  return frame;
}

/// Whether the mirror image of a box nearly equals another box.
bool are_mirror_images(const contacts::Box& box, const contacts::Box& other, double tolerance)
{
  const contacts::Box image = contacts::Box(mirrored(box.min())).extend(mirrored(box.max()));
  return (image.min() - other.min()).cwiseAbs().maxCoeff() <= tolerance &&
         (image.max() - other.max()).cwiseAbs().maxCoeff() <= tolerance;
}

/// Pairs up parts that mirror each other, the pairs with the least residual first.
Mirror_images mirror_images(const std::vector<const Points*>& parts, const std::vector<contacts::Triangle_tree>& trees)
{
  constexpr double tolerance = 0.05; // largest distance between a part and the mirror image of another, over the height
  std::vector<std::tuple<Steps, std::size_t, std::size_t>> likely;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i; j < parts.size(); ++j) {
      if (!are_mirror_images(trees[i].box(), trees[j].box(), 2 * tolerance)) continue;
      const double distance =
          std::max(mirror_residual({parts[i]}, {&trees[j]}), mirror_residual({parts[j]}, {&trees[i]}));
      if (distance <= tolerance) likely.emplace_back(quantized(distance), i, j);
    }
  std::sort(likely.begin(), likely.end());
  Mirror_images result(parts.size());
  for (const auto& [distance, i, j] : likely)
    if (!result[i] && !result[j]) result[i] = j, result[j] = i;
  return result;
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

double mirror_residual(const std::vector<const Points*>& surfaces, const Tree_pointers& trees)
{
  constexpr Eigen::Index samples = 24; // number of points taken of each surface, at most
  double sum = 0;
  Eigen::Index count = 0;
  std::size_t last = 0; // tree nearest to the last point, tried first, since it is probably nearest to the next one
  for (const Points* points : surfaces) {
    const Eigen::Index n = std::min(points->cols(), samples);
    count += n;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Point p = mirrored(points->col(i * points->cols() / n));
      Point nearest;
      std::size_t triangle;
      double squared = std::numeric_limits<double>::infinity();
      const auto improve = [&](std::size_t tree) {
        if (contacts::squared_distance(trees[tree]->box(), p) < squared &&
            trees[tree]->improve_nearest(p, nearest, squared, triangle))
          last = tree;
      };
      improve(last);
      for (std::size_t tree = 0; tree < trees.size(); ++tree)
        improve(tree);
      sum += squared;
    }
  }
  return std::sqrt(sum / double(count));
}

Blend_stage::Blend_stage(const std::array<Blend_input, 2>& inputs, Blend_size size)
    : are_symmetric(is_mirrored_in_x(inputs[0]) && is_mirrored_in_x(inputs[1])),
      graphs{inputs[0].graph, inputs[1].graph}
{
  for (std::size_t end : {0u, 1u}) {
    structure(graphs[end]).frame = staged_frame(inputs[end]);
    heights[end] = structure(graphs[end]).frame.height;
  }
  if (size == Blend_size::SOURCE) heights[1] = heights[0];
  if (size == Blend_size::TARGET) heights[0] = heights[1];
  if (size == Blend_size::SAME) heights = {1, 1};
  for (std::size_t end : {0u, 1u}) {
    shapes[end] = moved(inputs[end], inputs[0].shape.up(), end);
    add(inputs[end], end);
  }
}

/// The shape as given, scaled to its height in the world and rotated to the axes of the source.
Segmented_shape Blend_stage::moved(const Blend_input& input, const Point& up, std::size_t end) const
{
  const Shape_frame& frame = structure(graphs[end]).frame;
  const Eigen::Matrix3d rotation =
      structure(graphs[0]).frame.axes * quarter_turn(input.quarter_turns) * frame.axes.transpose();
  const bool is_turned = end == 1 && !rotation.isIdentity(1e-12); // otherwise coordinates stay exact
  const double scale = heights[end] / frame.height;
  Segmented_shape result(input.shape.name(), up);
  for (const Shape_part& part : input.shape.parts()) {
    Points points = part.mesh.points.colwise() - frame.origin;
    if (is_turned) points = rotation * points;
    if (scale != 1) points *= scale;
    result.add_part(part.name, {std::move(points), part.mesh.triangles});
  }
  return result;
}

void Blend_stage::add(const Blend_input& input, std::size_t end)
{
  const std::vector<Shape_part>& parts = input.shape.parts();
  charted[end] = charted_shape(graphs[end], input.quarter_turns, mesh_surfaces(input.shape));
  std::vector<const Points*> surfaces;
  std::vector<contacts::Triangle_tree> trees;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    surfaces.push_back(&charted[end].surfaces[i]);
    meshes[end].push_back({*surfaces[i], parts[i].mesh.triangles});
    trees.push_back(tree_of(*surfaces[i], parts[i].mesh.triangles));
    boxes[end].extend(box_of(*surfaces[i]));
  }
  widest_gap[end] = internal::widest_gap(pointers_to(trees));
  images[end].resize(parts.size());
  if (are_symmetric) images[end] = mirror_images(surfaces, trees);
}

void Blend_stage::add_mirrored(Part_pairs& pairs) const
{
  for (std::size_t i = 0, count = pairs.size(); i < count; ++i) {
    const auto source = images[0][pairs[i].first], target = images[1][pairs[i].second];
    if (source && target) pairs.emplace_back(*source, *target);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

Points Blend_stage::to_world(const Points& points, double done) const
{
  return structure(graphs[0]).frame.axes * (std::pow(heights[0], 1 - done) * std::pow(heights[1], done)) * points;
}

} // namespace CGAL::Shape_correspondence::internal
