// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "texture/textures.h"
#include "base/for_each_index.h"
#include "io/system/colours.h"
#include "shape/triangle_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The pixel, within the image, that a texture repeats at a pixel outside of it.
int wrapped(int pixel, int size, Texture_wrap wrap)
{
  const int period = wrap == Texture_wrap::MIRROR ? 2 * size : size;
  if (wrap == Texture_wrap::CLAMP) return std::clamp(pixel, 0, size - 1);
  const int inside = (pixel % period + period) % period;
  return inside < size ? inside : 2 * size - 1 - inside;
}

} // namespace

Appearance_sampler::Appearance_sampler(const Shape_appearance& appearance, const Eigen::Vector3d& neutral)
    : appearance_(appearance), neutral_(neutral)
{
  for (std::size_t byte = 0; byte < linear_.size(); ++byte)
    linear_[byte] = linear_of_srgb(double(byte) / 255);
}

bool Appearance_sampler::is_known(std::size_t part) const
{
  if (part >= appearance_.parts.size()) return false;
  const Part_appearance& looks = appearance_.parts[part];
  return !looks.colours.empty() ||
         std::any_of(looks.materials.begin(), looks.materials.end(), [](int material) { return material >= 0; });
}

Eigen::Vector3d Appearance_sampler::texture_at(const Texture& texture, const Eigen::Vector2d& at) const
{
  const Image& image = texture.image;
  const Eigen::Vector2d pixel(at.x() * image.width - 0.5, at.y() * image.height - 0.5);
  const int x = int(std::floor(pixel.x())), y = int(std::floor(pixel.y()));
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int dy : {0, 1})
    for (int dx : {0, 1}) {
      const double weight = (dx ? pixel.x() - x : 1 - (pixel.x() - x)) * (dy ? pixel.y() - y : 1 - (pixel.y() - y));
      const auto column = std::size_t(wrapped(x + dx, image.width, texture.wrap_u));
      const auto row = std::size_t(wrapped(y + dy, image.height, texture.wrap_v));
      const std::uint8_t* const bytes = image.pixels.data() + 4 * (row * std::size_t(image.width) + column);
      result += weight * Eigen::Vector3d(linear_[bytes[0]], linear_[bytes[1]], linear_[bytes[2]]);
    }
  return result;
}

Eigen::Vector3d Appearance_sampler::operator()(std::size_t part, std::size_t triangle,
                                               const Eigen::Vector3d& weights) const
{
  if (!is_known(part)) return neutral_;
  const Part_appearance& looks = appearance_.parts[part];
  Eigen::Vector3d result = looks.colours.empty() ? neutral_ : Eigen::Vector3d(Eigen::Vector3d::Ones());
  const int number = looks.materials.empty() ? -1 : looks.materials[triangle];
  if (number >= 0) {
    const Surface_material& material = appearance_.materials[std::size_t(number)];
    result = material.colour.head<3>();
    if (material.texture >= 0 && !looks.coordinates.empty()) {
      const Texture& texture = appearance_.textures[std::size_t(material.texture)];
      if (!texture.image.empty())
        result = result.cwiseProduct(texture_at(texture, value_at<double>(looks.coordinates, triangle, weights)));
    }
  }
  return looks.colours.empty() ? result : result.cwiseProduct(value_at<double>(looks.colours, triangle, weights));
}

namespace {

// Largest share of pixels covered twice, as along edges of triangles, with which a given layout is used
constexpr double most_overlap = 0.01;
// Largest share of the surface's area without area in the image, with which a given layout is used
constexpr double most_collapsed = 0.01;
// Least cosine of a face's angle to its chart; its texture is stretched by up to 1 / cosine
constexpr double steepest = 0.4;
constexpr double off_border = 1e-6; // barycentric margin: a pixel whose centre is on an edge belongs to no triangle

/// Adjacent triangles of a part in a plane; their bounding box begins at (0, 0), in the units of the shape.
struct Chart
{
  std::size_t part;
  std::vector<int> triangles;
  Eigen::Vector2d extent;
};

class Chart_maker
{
public:
  /// \param flat receives the triangles' corners within their charts
  Chart_maker(std::size_t part, const Part_mesh& mesh, const Eigen::Matrix3d& frame, std::vector<Flat_triangle>& flat)
      : part_(part),
        triangles_(mesh.triangles),
        points_(frame.transpose() * mesh.points),
        neighbours_(neighbours_of(mesh)),
        flat_(flat)
  {}

  void make(std::vector<Chart>& charts)
  {
    assign_directions();
    for (std::size_t t = 0; t < neighbours_.size(); ++t)
      flat_.push_back(projected(t));
    std::vector<bool> done(neighbours_.size(), false);
    for (std::size_t t = 0; t < done.size(); ++t)
      while (!done[t])
        charts.push_back(chart_from(int(t), done));
  }

private:
  /// The cosine of the angle between a triangle's normal and one of six directions.
  double cosine(std::size_t t, int direction) const
  {
    const Point normal = contacts::area_vector(triangle_of(points_, triangles_, Eigen::Index(t)));
    const double length = normal.norm();
    const Point unit = length > 0 ? Point(normal / length) : Point(0, 0, 1);
    return (direction % 2 ? -1. : 1.) * unit[direction / 2];
  }

  /// Assigns to each triangle one of six directions: that nearest to its normal, or that of most of its neighbours.
  void assign_directions()
  {
    constexpr double alike = 1e-6; // tolerance for equal cosines
    for (std::size_t t = 0; t < neighbours_.size(); ++t) {
      int best = 0;
      for (int d = 1; d < 6; ++d)
        if (cosine(t, d) > cosine(t, best) + alike) best = d;
      directions_.push_back(best);
    }
    smooth(neighbours_, directions_, [&](std::size_t t, int direction) { return cosine(t, direction) > steepest; });
  }

  Flat_triangle projected(std::size_t t) const
  {
    const int axis = directions_[t] / 2;
    const bool is_mirrored = directions_[t] % 2 == 1; // so that left and right are those seen from outside
    Flat_triangle result;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point p = points_.col(triangles_(Eigen::Index(k), Eigen::Index(t)));
      // Rows of the image run downwards
      const double right = axis == 0 ? -p.z() : p.x(), down = axis == 1 ? p.z() : -p.y();
      result[k] = {is_mirrored ? -right : right, down};
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
    Chart chart{part_, without_overlap(found), {}};
    for (int t : chart.triangles)
      done[std::size_t(t)] = true;
    lay_down(chart);
    return chart;
  }

  Eigen::AlignedBox2d bounds(const std::vector<int>& triangles) const
  {
    Eigen::AlignedBox2d result;
    for (int t : triangles)
      for (const Eigen::Vector2d& corner : flat_[std::size_t(t)])
        result.extend(corner);
    return result;
  }

  /// The triangles that do not overlap earlier ones in a coarse image. The first one is always included.
  std::vector<int> without_overlap(const std::vector<int>& triangles) const
  {
    constexpr int size = 256;
    constexpr std::size_t few = 2; // number of pixels that adjacent triangles may share, on their edges
    const Eigen::AlignedBox2d box = bounds(triangles);
    const double extent = box.sizes().maxCoeff();
    if (!(extent > 0) || triangles.size() == 1) return triangles;
    std::vector<int> result;
    std::vector<bool> taken(std::size_t(size) * size, false);
    for (int t : triangles) {
      Flat_triangle scaled = flat_[std::size_t(t)];
      for (Eigen::Vector2d& corner : scaled)
        corner = (corner - box.min()) * (size - 1) / extent;
      std::size_t pixels = 0, overlapping = 0;
      const auto count = [&](std::size_t pixel) {
        ++pixels;
        overlapping += taken[pixel];
      };
      for_each_pixel(scaled, size, count, off_border);
      if (overlapping > few && 10 * overlapping > pixels) continue;
      for_each_pixel(
          scaled, size, [&](std::size_t pixel) { taken[pixel] = true; }, off_border);
      result.push_back(t);
    }
    return result;
  }

  /// Moves a chart to (0, 0), with its longer side along x.
  void lay_down(Chart& chart)
  {
    if (const Eigen::Vector2d sizes = bounds(chart.triangles).sizes(); sizes.y() > sizes.x())
      for (int t : chart.triangles)
        for (Eigen::Vector2d& corner : flat_[std::size_t(t)])
          corner = quarter_turn(corner);
    const Eigen::AlignedBox2d box = bounds(chart.triangles);
    for (int t : chart.triangles)
      for (Eigen::Vector2d& corner : flat_[std::size_t(t)])
        corner -= box.min();
    chart.extent = box.sizes();
  }

  std::size_t part_;
  const Eigen::Matrix3Xi& triangles_;
  Points points_; ///< vertices in the frame
  std::vector<std::vector<int>> neighbours_;
  std::vector<int> directions_;
  std::vector<Flat_triangle>& flat_;
};

/// Packs charts into rows. \return their positions; none if they do not fit
std::optional<std::vector<Eigen::Vector2d>> packed(const std::vector<Chart>& charts, double scale, int size, int margin)
{
  std::vector<Eigen::Vector2d> places;
  double x = 0, y = 0, height = 0;
  for (const Chart& chart : charts) {
    const Eigen::Vector2d extent = (scale * chart.extent).array().ceil() + 2 * margin + 1;
    if (extent.x() > size) return std::nullopt;
    if (x + extent.x() > size) {
      x = 0;
      y += height;
      height = 0;
    }
    if (y + extent.y() > size) return std::nullopt;
    places.emplace_back(x + margin + 0.5, y + margin + 0.5);
    x += extent.x();
    height = std::max(height, extent.y());
  }
  return places;
}

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

std::optional<Texture_layout> given_layout(const Segmented_shape& shape, const Shape_appearance& appearance, int size)
{
  constexpr float outside = 1e-3f; // tolerance for texture coordinates in [0, 1]
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
      const auto cover = [&](std::size_t pixel) {
        ++covered;
        twice += taken[pixel];
        taken[pixel] = true;
      };
      for_each_pixel(flat, size, cover, off_border);
      result[part].push_back(flat);
    }
  }
  if (double(twice) > most_overlap * double(covered) || collapsed > most_collapsed * area) return std::nullopt;
  return result;
}

Texture_layout new_layout(const Segmented_shape& shape, const Eigen::Matrix3d& frame, int size, int margin)
{
  std::vector<Chart> charts;
  Texture_layout result(shape.parts().size());
  for (std::size_t part = 0; part < result.size(); ++part)
    Chart_maker(part, shape.parts()[part].mesh, frame, result[part]).make(charts);
  double longest = 0;
  for (const Chart& chart : charts)
    longest = std::max(longest, chart.extent.x());
  std::stable_sort(charts.begin(), charts.end(),
                   [](const Chart& a, const Chart& b) { return a.extent.y() > b.extent.y(); });
  double low = 0, high = size / longest;
  constexpr int rounds = 30;
  for (int round = 0; round < rounds; ++round) {
    const double middle = (low + high) / 2;
    (packed(charts, middle, size, margin) ? low : high) = middle;
  }
  std::optional<std::vector<Eigen::Vector2d>> places = packed(charts, low, size, margin);
  for (; !places && margin > 0; --margin) // reduces margins that leave too little room
    places = packed(charts, low, size, margin - 1);
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (int t : charts[i].triangles)
      for (Eigen::Vector2d& corner : result[charts[i].part][std::size_t(t)])
        corner = (places ? (*places)[i] : Eigen::Vector2d(0.5, 0.5)) + low * corner;
  return result;
}

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
