// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "degrade.h"

#include "../surface_distance.h"

namespace CGAL::Shape_correspondence::generator {

double diagonal(const Mesh& mesh) { return box_of(mesh.points).diagonal().norm(); }

std::vector<Part> cut(const Part& part)
{
  constexpr std::size_t least_faces = 20;
  const Box box = box_of(part.solid.mesh.points);
  int axis = 0;
  box.diagonal().maxCoeff(&axis);
  const double middle = box.center()[axis];
  Part low = part, high = part;
  low.name += "_a";
  high.name += "_b";
  low.solid.mesh = faces_where(part.solid.mesh, [=](const Point& p) { return p[axis] < middle; });
  high.solid.mesh = faces_where(part.solid.mesh, [=](const Point& p) { return p[axis] >= middle; });
  if (std::min(low.solid.mesh.faces.size(), high.solid.mesh.faces.size()) < least_faces) return {part};
  return {low, high};
}

Part joined(Part part, const Part& other)
{
  append(part.solid.mesh, other.solid.mesh);
  if (part.label.fine != other.label.fine) part.label.fine.clear();
  return part;
}

void degrade_segmentation(Assembly& shape, Random& random)
{
  constexpr double join_chance = 0.15, cut_chance = 0.2, touch = 0.005; // `touch`: gap over the diagonal
  const auto near = shape.near_parts(touch);
  std::vector<bool> used(shape.parts.size(), false);
  std::vector<Part> parts;
  for (const auto& pair : near) {
    const auto [a, b] = pair.parts;
    const bool alike = shape.parts[a].label.coarse == shape.parts[b].label.coarse;
    if (!alike || used[a] || used[b] || random.between(0, 1) > join_chance) continue;
    parts.push_back(joined(shape.parts[a], shape.parts[b]));
    used[a] = used[b] = true;
  }
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    if (used[i]) continue;
    const bool is_cut = random.between(0, 1) < cut_chance;
    for (const Part& piece : is_cut ? cut(shape.parts[i]) : std::vector<Part>{shape.parts[i]})
      parts.push_back(piece);
  }
  shape.parts = std::move(parts);
}

void open_surface(Mesh& mesh, Random& random)
{
  constexpr double depth = 0.12, least_left = 0.5;
  const std::size_t axis = random.below(3);
  const bool low = random.below(2) == 0;
  const Box box = box_of(mesh.points);
  const double edge =
      low ? box.min()[axis] + depth * box.diagonal()[axis] : box.max()[axis] - depth * box.diagonal()[axis];
  Mesh rest = faces_where(mesh, [=](const Point& p) { return low ? p[axis] > edge : p[axis] < edge; });
  if (double(rest.faces.size()) > least_left * double(mesh.faces.size())) mesh = std::move(rest);
}

void shrink(Mesh& mesh, double gap)
{
  const Box box = box_of(mesh.points);
  const Point middle = box.center(), extent = box.diagonal();
  Point factor;
  for (int k = 0; k < 3; ++k)
    factor[k] = extent[k] > 0 ? std::max(1 - 2 * gap / extent[k], 0.8) : 1;
  for (Point& p : mesh.points)
    p = middle + factor.cwiseProduct(p - middle);
}

void add_noise(Mesh& mesh, Random& random)
{
  std::vector<double> edges;
  for (const auto& f : mesh.faces)
    edges.push_back((mesh.points[f[0]] - mesh.points[f[1]]).norm());
  std::nth_element(edges.begin(), edges.begin() + std::ptrdiff_t(edges.size() / 2), edges.end());
  const double most = std::min(0.005 * diagonal(mesh), 0.2 * edges[edges.size() / 2]);
  for (Point& p : mesh.points)
    for (int k = 0; k < 3; ++k)
      p[k] += random.between(-most, most);
}

Assembly degraded(Assembly shape, const Degradation& ways, std::uint64_t seed)
{
  constexpr double open_chance = 0.5, widest_gap = 0.01, least_scale = 0.75, most_scale = 1.3;
  shape.groups.clear();
  shape.contacts.clear();
  Random segmentation(seed), openings(seed + 1), gaps(seed + 2), noise(seed + 3), scale(seed + 4), rotation(seed + 5);
  if (ways.segmentation) degrade_segmentation(shape, segmentation);
  const double size = shape.diagonal();
  const Point factor(scale.between(least_scale, most_scale), scale.between(least_scale, most_scale),
                     scale.between(least_scale, most_scale));
  const Eigen::Isometry3d turn = rotation_about(Point::Zero(), Point::UnitY(), rotation.between(-pi, pi));
  for (Part& part : shape.parts) {
    Mesh& mesh = part.solid.mesh;
    if (ways.openings && openings.between(0, 1) < open_chance) open_surface(mesh, openings);
    if (ways.gaps) shrink(mesh, gaps.between(0, widest_gap) * size);
    if (ways.noise) add_noise(mesh, noise);
    for (Point& p : mesh.points) {
      if (ways.scale) p = factor.cwiseProduct(p);
      if (ways.rotation) p = turn * p;
      p = snapped(p);
    }
    part.solid.mid.clear();
  }
  return shape;
}

} // namespace CGAL::Shape_correspondence::generator
