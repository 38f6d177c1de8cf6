// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/bake.h"
#include "base/clamped.h"
#include "base/for_each_index.h"
#include "base/srgb.h"

#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The triangle that a pixel shows; -1: none.
struct Shown_triangle
{
  int part = -1, triangle = -1;
};

std::vector<Shown_triangle> shown_triangles(const Texture_layout& layout, int size)
{
  std::vector<Shown_triangle> result(std::size_t(size) * std::size_t(size));
  const auto show = [&](int x, int y, std::size_t part, std::size_t triangle) {
    Shown_triangle& shown = result[std::size_t(y) * std::size_t(size) + std::size_t(x)];
    if (shown.part < 0) shown = {int(part), int(triangle)};
  };
  for (std::size_t part = 0; part < layout.size(); ++part)
    for (std::size_t t = 0; t < layout[part].size(); ++t)
      for_each_pixel(layout[part][t], size, [&](int x, int y) { show(x, y, part, t); });
  // Triangles that are thinner than a pixel
  for (std::size_t part = 0; part < layout.size(); ++part)
    for (std::size_t t = 0; t < layout[part].size(); ++t) {
      const Flat_triangle& flat = layout[part][t];
      const Eigen::Vector2d middle = (flat[0] + flat[1] + flat[2]) / 3;
      show(clamped_cell(middle.x(), size - 1), clamped_cell(middle.y(), size - 1), part, t);
    }
  return result;
}

/// Barycentric coordinates of the point of a triangle near a point of the picture.
Eigen::Vector3d inside_coordinates(const Flat_triangle& flat, const Eigen::Vector2d& p)
{
  const Eigen::Vector3d weights = barycentric_coordinates(flat, p);
  if (!weights.allFinite()) return Eigen::Vector3d::Constant(1. / 3);
  const Eigen::Vector3d inside = weights.cwiseMax(0);
  return inside / inside.sum();
}

/// Lets colours go on into pixels that have none, one pixel far.
void grow(std::vector<Eigen::Vector3f>& colours, std::vector<bool>& known, int size)
{
  const std::vector<Eigen::Vector3f> before = colours;
  const std::vector<bool> was_known = known;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const std::size_t pixel = std::size_t(y) * std::size_t(size) + std::size_t(x);
      if (was_known[pixel]) continue;
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      int count = 0;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size - 1); ++i) {
          const std::size_t other = std::size_t(j) * std::size_t(size) + std::size_t(i);
          if (!was_known[other]) continue;
          sum += before[other];
          ++count;
        }
      if (count == 0) continue;
      colours[pixel] = sum / float(count);
      known[pixel] = true;
    }
}

} // namespace

Image bake(const Texture_layout& layout, int size, int margin, int samples, const Eigen::Vector3d& background,
           const Colour_of_point& colour)
{
  const std::vector<Shown_triangle> shown = shown_triangles(layout, size);
  std::vector<Eigen::Vector3f> colours(shown.size(), background.cast<float>());
  for_each_index<CGAL::Parallel_if_available_tag>(std::size_t(size), [&](std::size_t y) {
    for (std::size_t x = 0; x < std::size_t(size); ++x) {
      const Shown_triangle& at = shown[y * std::size_t(size) + x];
      if (at.part < 0) continue;
      const auto part = std::size_t(at.part), triangle = std::size_t(at.triangle);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const Eigen::Vector2d p(double(x) + (i + 0.5) / samples, double(y) + (j + 0.5) / samples);
          sum += colour(part, triangle, inside_coordinates(layout[part][triangle], p));
        }
      colours[y * std::size_t(size) + x] = (sum / (samples * samples)).cast<float>();
    }
  });
  std::vector<bool> known(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    known[i] = shown[i].part >= 0;
  for (int i = 0; i < margin; ++i)
    grow(colours, known, size);
  Image image{size, size, {}};
  image.pixels.reserve(4 * colours.size());
  for (const Eigen::Vector3f& linear : colours) {
    for (float channel : linear)
      image.pixels.push_back(std::uint8_t(std::lround(255 * srgb_of_linear(double(channel)))));
    image.pixels.push_back(255);
  }
  return image;
}

} // namespace CGAL::Shape_correspondence::internal
