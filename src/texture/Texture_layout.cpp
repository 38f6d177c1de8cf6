// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/Texture_layout.h"
#include "shape/triangle_distance.h"
#include "texture/neighbours.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

// Share of the covered pixels that may be covered twice: along the edges of triangles
constexpr double most_overlap = 0.01;
// Share of the surface that may have no area in the picture
constexpr double most_collapsed = 0.01;
// Cosine of the steepest face that joins a chart of its neighbours; its texture is stretched by 1 / cosine
constexpr double steepest = 0.4;
constexpr int smoothing_rounds = 3;
constexpr double off_border = 1e-6; // barycentric: pixels whose middles are on an edge are of no triangle

/// A chart: triangles of a part, and where their corners lie, from (0, 0) on, in the units of the shape.
struct Chart
{
  std::size_t part = 0;
  std::vector<int> triangles;
  std::vector<Flat_triangle> flat;
  Eigen::Vector2d extent = Eigen::Vector2d::Zero();
};

Eigen::AlignedBox2d bounds(const std::vector<Flat_triangle>& triangles)
{
  Eigen::AlignedBox2d result;
  for (const Flat_triangle& triangle : triangles)
    for (const Eigen::Vector2d& corner : triangle)
      result.extend(corner);
  return result;
}

/// Cuts a part into charts.
class Chart_maker
{
public:
  Chart_maker(std::size_t part, const Part_mesh& mesh, const Eigen::Matrix3d& frame)
      : part_(part), mesh_(mesh), points_(frame.transpose() * mesh.points), neighbours_(neighbours_of(mesh))
  {}

  void make(std::vector<Chart>& charts)
  {
    assign_directions();
    std::vector<bool> done(neighbours_.size(), false);
    for (std::size_t t = 0; t < done.size(); ++t)
      while (!done[t])
        charts.push_back(chart_from(int(t), done));
  }

private:
  Point normal(int t) const
  {
    const auto corner = [&](int k) -> Point { return points_.col(mesh_.triangles(k, t)); };
    const Point result = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double length = result.norm();
    return length > 0 ? Point(result / length) : Point(0, 0, 1);
  }

  static Point direction(int d) { return (d % 2 ? -1. : 1.) * Point::Unit(d / 2); }

  /// Each triangle faces one of six directions, that which its normal is nearest to or that of most of its neighbours.
  void assign_directions()
  {
    constexpr double alike = 1e-6; // equal cosines, but for rounding
    for (std::size_t t = 0; t < neighbours_.size(); ++t) {
      int best = 0;
      for (int d = 1; d < 6; ++d)
        if (normal(int(t)).dot(direction(d)) > normal(int(t)).dot(direction(best)) + alike) best = d;
      directions_.push_back(best);
    }
    for (int round = 0; round < smoothing_rounds; ++round) {
      std::vector<int> smoothed = directions_;
      for (std::size_t t = 0; t < neighbours_.size(); ++t)
        for (int neighbour : neighbours_[t]) {
          const int d = directions_[std::size_t(neighbour)];
          const auto of_it = [&](int other) { return directions_[std::size_t(other)] == d; };
          const auto votes = std::count_if(neighbours_[t].begin(), neighbours_[t].end(), of_it);
          if (votes >= 2 && normal(int(t)).dot(direction(d)) > steepest) smoothed[t] = d;
        }
      directions_.swap(smoothed);
    }
  }

  Flat_triangle projected(int t) const
  {
    const int axis = directions_[std::size_t(t)] / 2;
    const bool is_mirrored = directions_[std::size_t(t)] % 2 == 1; // seen from outside, right is right
    Flat_triangle result;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point p = points_.col(mesh_.triangles(Eigen::Index(k), t));
      // Up is up in the picture, whose rows go down
      const Eigen::Vector2d at = axis == 0   ? Eigen::Vector2d(-p.z(), -p.y())
                                 : axis == 1 ? Eigen::Vector2d(p.x(), p.z())
                                             : Eigen::Vector2d(p.x(), -p.y());
      result[k] = is_mirrored ? Eigen::Vector2d(-at.x(), at.y()) : at;
    }
    return result;
  }

  /// The connected triangles of one direction, as far as they do not overlap.
  Chart chart_from(int first, std::vector<bool>& done)
  {
    std::vector<int> found{first};
    std::vector<bool> seen(done);
    seen[std::size_t(first)] = true;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (int next : neighbours_[std::size_t(found[i])]) {
        const auto n = std::size_t(next);
        if (seen[n] || directions_[n] != directions_[std::size_t(first)]) continue;
        seen[n] = true;
        found.push_back(next);
      }
    Chart chart;
    chart.part = part_;
    std::vector<Flat_triangle> flat;
    for (int t : found)
      flat.push_back(projected(t));
    const std::vector<bool> fits = without_overlap(flat);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!fits[i]) continue;
      done[std::size_t(found[i])] = true;
      chart.triangles.push_back(found[i]);
      chart.flat.push_back(flat[i]);
    }
    lay_down(chart);
    return chart;
  }

  /// Which triangles do not overlap earlier ones in a coarse picture. The first one never does.
  static std::vector<bool> without_overlap(const std::vector<Flat_triangle>& flat)
  {
    constexpr int size = 256;
    constexpr int few = 2; // pixels on edges
    const Eigen::AlignedBox2d box = bounds(flat);
    const double extent = box.sizes().maxCoeff();
    std::vector<bool> result(flat.size(), true);
    if (!(extent > 0) || flat.size() == 1) return result;
    std::vector<bool> taken(std::size_t(size) * size, false);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      Flat_triangle scaled = flat[i];
      for (Eigen::Vector2d& corner : scaled)
        corner = (corner - box.min()) * (size - 1) / extent;
      std::vector<std::size_t> pixels;
      int overlapping = 0;
      for_each_pixel(
          scaled, size,
          [&](int x, int y) {
            const std::size_t pixel = std::size_t(y) * size + std::size_t(x);
            overlapping += taken[pixel];
            pixels.push_back(pixel);
          },
          off_border);
      result[i] = i == 0 || overlapping <= few || 10 * std::size_t(overlapping) <= pixels.size();
      if (!result[i]) continue;
      for (std::size_t pixel : pixels)
        taken[pixel] = true;
    }
    return result;
  }

  /// Moves a chart to (0, 0), its longer side along x.
  static void lay_down(Chart& chart)
  {
    if (const Eigen::Vector2d sizes = bounds(chart.flat).sizes(); sizes.y() > sizes.x())
      for (Flat_triangle& triangle : chart.flat)
        for (Eigen::Vector2d& corner : triangle)
          corner = Eigen::Vector2d(-corner.y(), corner.x());
    const Eigen::AlignedBox2d box = bounds(chart.flat);
    for (Flat_triangle& triangle : chart.flat)
      for (Eigen::Vector2d& corner : triangle)
        corner -= box.min();
    chart.extent = box.sizes();
  }

  std::size_t part_;
  const Part_mesh& mesh_;
  Points points_; ///< in the frame
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> directions_;
};

/// Puts charts into rows, the highest first. \return their places, or none if they do not fit
std::optional<std::vector<Eigen::Vector2d>>
packed(const std::vector<Chart>& charts, const std::vector<std::size_t>& by_height, double scale, int size, int margin)
{
  std::vector<Eigen::Vector2d> places(charts.size());
  double x = 0, y = 0, height = 0;
  for (std::size_t i : by_height) {
    const Eigen::Vector2d extent = (scale * charts[i].extent).array().ceil() + 2 * margin + 1;
    if (extent.x() > size) return std::nullopt;
    if (x + extent.x() > size) {
      x = 0;
      y += height;
      height = 0;
    }
    if (y + extent.y() > size) return std::nullopt;
    places[i] = Eigen::Vector2d(x + margin + 0.5, y + margin + 0.5);
    x += extent.x();
    height = std::max(height, extent.y());
  }
  return places;
}

} // namespace

std::optional<Texture_layout> given_layout(const Segmented_shape& shape, const Shape_appearance& appearance, int size)
{
  constexpr float outside = 1e-3f;
  if (appearance.parts.size() != shape.parts().size()) return std::nullopt;
  Texture_layout result(shape.parts().size());
  std::vector<bool> taken(std::size_t(size) * std::size_t(size), false);
  std::size_t covered = 0, twice = 0;
  double area = 0, collapsed = 0;
  for (std::size_t part = 0; part < result.size(); ++part) {
    const Part_mesh& mesh = shape.parts()[part].mesh;
    const std::vector<Eigen::Vector2f>& given = appearance.parts[part].coordinates;
    if (given.empty()) return std::nullopt;
    for (std::size_t t = 0; t < given.size() / 3; ++t) {
      Flat_triangle flat;
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector2f& at = given[3 * t + k];
        if (at.minCoeff() < -outside || at.maxCoeff() > 1 + outside) return std::nullopt;
        flat[k] = at.cast<double>() * size;
      }
      const double of_triangle = contacts::area_vector(triangle_of(mesh, Eigen::Index(t))).norm() / 2;
      area += of_triangle;
      if (!(std::abs(cross(flat[1] - flat[0], flat[2] - flat[0])) > 0)) collapsed += of_triangle;
      for_each_pixel(
          flat, size,
          [&](int x, int y) {
            const std::size_t pixel = std::size_t(y) * std::size_t(size) + std::size_t(x);
            ++covered;
            twice += taken[pixel];
            taken[pixel] = true;
          },
          off_border);
      result[part].push_back(flat);
    }
  }
  if (double(twice) > most_overlap * double(covered) || collapsed > most_collapsed * area) return std::nullopt;
  return result;
}

Texture_layout new_layout(const Segmented_shape& shape, const Eigen::Matrix3d& frame, int size, int margin)
{
  std::vector<Chart> charts;
  Texture_layout result;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const Part_mesh& mesh = shape.parts()[part].mesh;
    result.emplace_back(std::size_t(mesh.triangles.cols()));
    Chart_maker(part, mesh, frame).make(charts);
  }
  std::vector<std::size_t> by_height(charts.size());
  std::iota(by_height.begin(), by_height.end(), std::size_t(0));
  std::stable_sort(by_height.begin(), by_height.end(),
                   [&](std::size_t a, std::size_t b) { return charts[a].extent.y() > charts[b].extent.y(); });
  double longest = 0;
  for (const Chart& chart : charts)
    longest = std::max(longest, chart.extent.x());
  double low = 0, high = size / longest;
  constexpr int rounds = 30;
  for (int round = 0; round < rounds; ++round) {
    const double middle = (low + high) / 2;
    (packed(charts, by_height, middle, size, margin) ? low : high) = middle;
  }
  std::optional<std::vector<Eigen::Vector2d>> places = packed(charts, by_height, low, size, margin);
  for (; !places && margin > 0; --margin) // more charts than there is room for their margins
    places = packed(charts, by_height, low, size, margin - 1);
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t t = 0; t < charts[i].triangles.size(); ++t) {
      Flat_triangle& flat = result[charts[i].part][std::size_t(charts[i].triangles[t])];
      for (std::size_t k = 0; k < 3; ++k)
        flat[k] = (places ? (*places)[i] : Eigen::Vector2d(0.5, 0.5)) + low * charts[i].flat[t][k];
    }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
