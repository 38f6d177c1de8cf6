// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/shape_picture.h"
#include "viewer/html_text.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double margin = 0.04;               // of the picture on every side
constexpr double least_light = 0.35;          // of a face that turns away from the light
const Point view_direction(0.45, 0.35, 0.82); // towards the eye; x to the side, y up, z to the front

/// To coordinates of the picture: x to the right, y up, z towards the eye.
Eigen::Matrix3d to_view(const Point& up)
{
  const Point front = up.z() > 0.5 ? Point(-Point::UnitY()) : Point::UnitZ();
  Eigen::Matrix3d upright; // rows: side, up, front
  upright << up.cross(front).transpose(), up.transpose(), front.transpose();
  const Point eye = view_direction.normalized(), right = Point::UnitY().cross(eye).normalized();
  Eigen::Matrix3d view;
  view << right.transpose(), eye.cross(right).transpose(), eye.transpose();
  return view * upright;
}

/// A picture with a depth for every pixel.
class Canvas
{
public:
  explicit Canvas(int width)
      : width_(width),
        depths_(std::size_t(width * width), -std::numeric_limits<double>::infinity()),
        pixels_(3 * depths_.size(), 255)
  {}

  /// Corners in pixels, z towards the eye.
  void draw(const Point& a, const Point& b, const Point& c, const Colour& colour)
  {
    const double area = (b - a).head<2>().x() * (c - a).y() - (b - a).y() * (c - a).x();
    if (area == 0) return;
    const auto first = [&](int k) { return std::max(0, int(std::floor(std::min({a[k], b[k], c[k]})))); };
    const auto last = [&](int k) { return std::min(width_ - 1, int(std::ceil(std::max({a[k], b[k], c[k]})))); };
    const std::array<double, 3> screen = screen_colour(colour);
    for (int y = first(1); y <= last(1); ++y)
      for (int x = first(0); x <= last(0); ++x) {
        const double u = ((x - a.x()) * (c - a).y() - (y - a.y()) * (c - a).x()) / area;
        const double v = ((b - a).x() * (y - a.y()) - (b - a).y() * (x - a.x())) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const auto pixel = std::size_t(y * width_ + x);
        const double depth = a.z() + u * (b - a).z() + v * (c - a).z();
        if (depth <= depths_[pixel]) continue;
        depths_[pixel] = depth;
        for (std::size_t k = 0; k < 3; ++k)
          pixels_[3 * pixel + 2 - k] = std::uint8_t(255 * screen[k] + 0.5);
      }
  }

  /// As a BMP file: a header, and rows from below, blue, green, red, filled to whole words.
  std::string bitmap() const
  {
    constexpr std::uint32_t header = 54;
    const auto row = std::uint32_t(3 * width_ + 3) / 4 * 4, size = row * std::uint32_t(width_);
    std::string result = "BM";
    const auto add = [&](std::uint32_t value, int bytes) {
      for (int i = 0; i < bytes; ++i)
        result += char(value >> 8 * i & 0xff);
    };
    const auto width = std::uint32_t(width_);
    add(header + size, 4), add(0, 4), add(header, 4);
    add(40, 4), add(width, 4), add(width, 4), add(1, 2), add(24, 2), add(0, 4), add(size, 4), add(0, 4), add(0, 4);
    add(0, 4), add(0, 4);
    for (int y = 0; y < width_; ++y) {
      result.append(reinterpret_cast<const char*>(pixels_.data()) + std::size_t(3 * width_ * y),
                    std::size_t(3 * width_));
      result.append(row - std::size_t(3 * width_), '\0');
    }
    return result;
  }

private:
  int width_;
  std::vector<double> depths_;
  std::vector<std::uint8_t> pixels_;
};

} // namespace

std::string shape_picture(const Segmented_shape& shape, const std::vector<Colour>& colours, int width)
{
  const Eigen::Matrix3d turn = to_view(shape.up());
  std::vector<Points> points;
  Eigen::AlignedBox3d box;
  for (const Shape_part& part : shape.parts()) {
    points.push_back(turn * part.mesh.points);
    for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t)
      for (int k = 0; k < 3; ++k)
        box.extend(Point(points.back().col(part.mesh.triangles(k, t))));
  }
  const double extent = std::max({box.sizes().x(), box.sizes().y(), std::numeric_limits<double>::min()});
  const double scale = (1 - 2 * margin) * (width - 1) / extent;
  Canvas canvas(width);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Points placed =
        (scale * (points[i].colwise() - box.center())).colwise() + Point(0.5, 0.5, 0) * double(width - 1);
    const Eigen::Matrix3Xi& triangles = shape.parts()[i].mesh.triangles;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      const Point a = placed.col(triangles(0, t)), b = placed.col(triangles(1, t)), c = placed.col(triangles(2, t));
      const double light = std::abs((b - a).cross(c - a).normalized().dot(Point(0.3, 0.5, 0.8).normalized()));
      canvas.draw(a, b, c, (least_light + (1 - least_light) * light) * colours[i]);
    }
  }
  return canvas.bitmap();
}

} // namespace CGAL::Shape_correspondence::IO
