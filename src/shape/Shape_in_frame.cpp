// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Shape_in_frame.h"
#include "base/directions.h"
#include "shape/canonical_surface.h"
#include "shape/oriented_box.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int frame_samples = 4096;        ///< samples of a whole shape, to find its frame
constexpr int rough_samples = 1024;        ///< samples of a whole shape, to find axes that settle ties
constexpr int least_frame_samples = 4;     ///< least number of samples of each part
constexpr double rounding_of_axes = 1e-12; ///< norm of a difference of axes that is rounding noise

/// The triangles of a part, their area, and the position of their centre along a direction.
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

/// Points spread over surfaces by area, the same to the bit whatever the order of the surfaces.
Points sample_surfaces(const std::vector<const Part_mesh*>& surfaces, const Point& origin, const Point& direction,
                       int samples)
{
  std::vector<Part_triangles> parts;
  for (const Part_mesh* surface : surfaces)
    parts.emplace_back(*surface, origin, direction);
  std::sort(parts.begin(), parts.end());
  double total = 0;
  for (const Part_triangles& part : parts)
    total += part.area;
  std::vector<Point> points;
  for (const Part_triangles& part : parts) {
    const int share = static_cast<int>(std::lround(samples * part.area / total));
    const auto added = contacts::sample_triangles(part.triangles, std::max(least_frame_samples, share)).points;
    points.insert(points.end(), added.begin(), added.end());
  }
  Points result(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(i) = points[i];
  return result;
}

/// The coordinate axes after the rotation of least angle that maps y to the up direction.
Eigen::Matrix3d upright_axes(const Point& up) { return least_rotation(Point::UnitY(), up).toRotationMatrix(); }

/// The samples of a shape, and its vertices.
struct Sampled_shape
{
  Sampled_shape(const std::vector<const Part_mesh*>& surfaces, const Eigen::Matrix3d& axes, int count)
  {
    std::vector<const Points*> points;
    for (const Part_mesh* surface : surfaces)
      points.push_back(&surface->points);
    vertices = joined(points);
    samples = sample_surfaces(surfaces, vertices.rowwise().minCoeff(), axes * generic_direction(), count);
  }

  Shape_frame frame(const Point& up) const { return frame_of_samples(samples, vertices, up); }

  Points vertices, samples;
};

std::vector<const Part_mesh*> surfaces_of(const Segmented_shape& shape)
{
  std::vector<const Part_mesh*> result;
  for (const Shape_part& part : shape.parts())
    result.push_back(&part.mesh);
  return result;
}

} // namespace

Shape_in_frame::Shape_in_frame(const Segmented_shape& given)
{
  const Eigen::Matrix3d axes = upright_axes(given.up());
  const std::vector<Canonical_surface> surfaces = canonical_surfaces(given, axes);
  shape = canonical_shape(given, surfaces, axes);
  // Made canonical once more with the axes found, so that a rotated shape gets the same triangles and samples
  const Eigen::Matrix3d found = Sampled_shape(surfaces_of(shape), axes, rough_samples).frame(shape.up()).axes;
  if ((found - axes).norm() > rounding_of_axes) shape = canonical_shape(given, surfaces, found);
  frame = Sampled_shape(surfaces_of(shape), found, frame_samples).frame(shape.up());
}

std::array<Shape_frame, 3> frames_by_axis(const Segmented_shape& given)
{
  const Segmented_shape shape = canonical_shape(given, canonical_surfaces(given));
  const Sampled_shape sampled(surfaces_of(shape), Eigen::Matrix3d::Identity(), frame_samples);
  return {sampled.frame(Point::UnitX()), sampled.frame(Point::UnitY()), sampled.frame(Point::UnitZ())};
}

Shape_frame rough_frame(const std::vector<const Part_mesh*>& surfaces, const Point& up)
{
  return Sampled_shape(surfaces, upright_axes(up), rough_samples).frame(up);
}

} // namespace CGAL::Shape_correspondence::internal
