// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Shape_in_frame.h"
#include "base/directions.h"
#include "base/generic_direction.h"
#include "shape/all_vertices.h"
#include "shape/canonical_surface.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int frame_samples = 4096;    ///< of a whole shape, to find its frame
constexpr int least_frame_samples = 4; ///< of every part, however small

/// The triangles of a part, their area, and the place of its centre along a direction.
struct Part_triangles
{
  Part_triangles(const Part_mesh& mesh, const Point& origin, const Point& direction)
      : triangles(contacts::sampled_triangles_of(mesh)), area(contacts::total_area(triangles))
  {
    for (const contacts::Sampled_triangle& t : triangles)
      place += t.area / area * direction.dot(t.corner - origin + (t.side_1 + t.side_2) / 3);
  }

  /// An order that does not depend on the file.
  bool operator<(const Part_triangles& other) const
  {
    return std::tie(place, area) < std::tie(other.place, other.area);
  }

  std::vector<contacts::Sampled_triangle> triangles;
  double area;
  double place = 0;
};

/// Points spread over the shape by area, the same to the bit whatever the order of the parts.
Points sample_shape(const Segmented_shape& shape, const Eigen::Matrix3d& axes)
{
  const Points vertices = all_vertices(shape);
  const Point origin = vertices.rowwise().minCoeff();
  std::vector<Part_triangles> parts;
  for (const Shape_part& part : shape.parts())
    parts.emplace_back(part.mesh, origin, axes * generic_direction());
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

/// Axes of which the second is the upright direction, by the least rotation.
Eigen::Matrix3d upright_axes(const Point& up) { return least_rotation(Point::UnitY(), up).toRotationMatrix(); }

} // namespace

Shape_in_frame::Shape_in_frame(const Segmented_shape& given)
{
  const Eigen::Matrix3d axes = upright_axes(given.up());
  shape = canonical_shape(given, axes);
  const Shape_frame first = frame_of_samples(sample_shape(shape, axes), all_vertices(shape), shape.up());
  // Again with the axes found, so that the same triangles and samples are taken of a shape that was turned
  shape = canonical_shape(given, first.axes);
  frame = frame_of_samples(sample_shape(shape, first.axes), all_vertices(shape), shape.up());
}

std::array<Shape_frame, 3> frames_by_axis(const Segmented_shape& given)
{
  const Segmented_shape shape = canonical_shape(given);
  const Points samples = sample_shape(shape, Eigen::Matrix3d::Identity()), vertices = all_vertices(shape);
  return {frame_of_samples(samples, vertices, Point::UnitX()), frame_of_samples(samples, vertices, Point::UnitY()),
          frame_of_samples(samples, vertices, Point::UnitZ())};
}

} // namespace CGAL::Shape_correspondence::internal
