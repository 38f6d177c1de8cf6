// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/srgb.h"
#include "texture/Texture_layout.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The linear colours of an image's pixels; none: unknown.
using Colours = std::vector<std::optional<Eigen::Vector3f>>;

/// The triangle shown by a pixel; -1: none.
struct Shown_triangle
{
  int part = -1, triangle = -1;
};

std::vector<Shown_triangle> shown_triangles(const Texture_layout& layout, int size)
{
  std::vector<Shown_triangle> result(std::size_t(size) * std::size_t(size));
  const auto show = [&](std::size_t pixel, std::size_t part, std::size_t triangle) {
    if (result[pixel].part < 0) result[pixel] = {int(part), int(triangle)};
  };
  for (std::size_t part = 0; part < layout.size(); ++part)
    for (std::size_t t = 0; t < layout[part].size(); ++t)
      for_each_pixel(layout[part][t], size, [&](std::size_t pixel) { show(pixel, part, t); });
  // Triangles that contain no centre of a pixel are shown by the pixel at their centroid
  for (std::size_t part = 0; part < layout.size(); ++part)
    for (std::size_t t = 0; t < layout[part].size(); ++t) {
      const Flat_triangle& flat = layout[part][t];
      const Eigen::Vector2d middle = (flat[0] + flat[1] + flat[2]) / 3;
      show(pixel_at(clamped_cell(middle.x(), size - 1), clamped_cell(middle.y(), size - 1), size), part, t);
    }
  return result;
}

/// Barycentric coordinates of a point of a triangle near a point of the image.
Eigen::Vector3d inside_coordinates(const Flat_triangle& flat, const Eigen::Vector2d& p)
{
  const Eigen::Vector3d weights = barycentric_coordinates(flat, p);
  if (!weights.allFinite()) return Eigen::Vector3d::Constant(1. / 3);
  const Eigen::Vector3d inside = weights.cwiseMax(0);
  return inside / inside.sum();
}

/// Extends colours by one pixel into pixels without a colour.
void grow(Colours& colours, int size)
{
  const Colours before = colours;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      std::optional<Eigen::Vector3f>& colour = colours[pixel_at(x, y, size)];
      if (colour) continue;
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      int count = 0;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size - 1); ++i)
          if (const std::optional<Eigen::Vector3f>& other = before[pixel_at(i, j, size)]) {
            sum += *other;
            ++count;
          }
      if (count > 0) colour = sum / float(count);
    }
}

} // namespace

Image bake(const Texture_layout& layout, int size, int margin, int samples, const Eigen::Vector3d& background,
           const Colour_of_point& colour)
{
  const std::vector<Shown_triangle> shown = shown_triangles(layout, size);
  Colours colours(shown.size());
  for_each_index<CGAL::Parallel_if_available_tag>(std::size_t(size), [&](std::size_t y) {
    for (std::size_t x = 0; x < std::size_t(size); ++x) {
      const std::size_t pixel = y * std::size_t(size) + x;
      if (shown[pixel].part < 0) continue;
      const auto part = std::size_t(shown[pixel].part), triangle = std::size_t(shown[pixel].triangle);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const Eigen::Vector2d p(double(x) + (i + 0.5) / samples, double(y) + (j + 0.5) / samples);
          sum += colour(part, triangle, inside_coordinates(layout[part][triangle], p));
        }
      colours[pixel] = (sum / (samples * samples)).cast<float>();
    }
  });
  for (int i = 0; i < margin; ++i)
    grow(colours, size);
  Image image{size, size, {}};
  image.pixels.reserve(4 * colours.size());
  for (const std::optional<Eigen::Vector3f>& linear : colours) {
    for (float channel : linear.value_or(background.cast<float>()))
      image.pixels.push_back(std::uint8_t(std::lround(255 * srgb_of_linear(double(channel)))));
    image.pixels.push_back(255);
  }
  return image;
}

} // namespace CGAL::Shape_correspondence::internal
