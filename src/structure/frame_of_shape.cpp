// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "structure/frame_of_shape.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int frame_samples = 4096;    ///< of a whole shape, to find its frame
constexpr int least_frame_samples = 4; ///< of every part, however small

/// The triangles of a part and their area.
struct Part_triangles
{
  explicit Part_triangles(const Part_mesh& mesh)
      : triangles(contacts::sampled_triangles_of(mesh)), area(contacts::total_area(triangles))
  {}

  /// An order that does not depend on the file: by area, then by the first corner.
  bool operator<(const Part_triangles& other) const
  {
    const auto key = [](const Part_triangles& part) {
      const Point& p = part.triangles.front().corner;
      return std::make_tuple(part.area, p.x(), p.y(), p.z());
    };
    return key(*this) < key(other);
  }

  std::vector<contacts::Sampled_triangle> triangles;
  double area;
};

/// Points spread over the shape by area, the same to the bit whatever the order of the parts.
Points sample_shape(const Segmented_shape& shape)
{
  std::vector<Part_triangles> parts;
  for (const Shape_part& part : shape.parts())
    parts.emplace_back(part.mesh);
  std::sort(parts.begin(), parts.end());
  double total = 0;
  for (const Part_triangles& part : parts)
    total += part.area;
  std::vector<Point> points;
  for (const Part_triangles& part : parts) {
    const int share = static_cast<int>(std::lround(frame_samples * part.area / total));
    const auto samples = contacts::sample_triangles(part.triangles, std::max(least_frame_samples, share)).points;
    points.insert(points.end(), samples.begin(), samples.end());
  }
  Points result(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(i) = points[i];
  return result;
}

} // namespace

Shape_frame frame_of(const Segmented_shape& shape) { return compute_shape_frame(sample_shape(shape), shape.up()); }

std::array<Shape_frame, 3> frames_by_axis(const Segmented_shape& shape)
{
  const Points samples = sample_shape(shape);
  return {compute_shape_frame(samples, Point::UnitX()), compute_shape_frame(samples, Point::UnitY()),
          compute_shape_frame(samples, Point::UnitZ())};
}

} // namespace CGAL::Shape_correspondence::internal
