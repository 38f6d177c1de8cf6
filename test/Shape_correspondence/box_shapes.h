// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shapes made of boxes, whose groups and contacts are known by construction, and motions of them.
#ifndef SHAPE_CORRESPONDENCE_TEST_BOX_SHAPES_H
#define SHAPE_CORRESPONDENCE_TEST_BOX_SHAPES_H

#include <CGAL/Shape_correspondence/abstract_part.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace box_shapes {

using namespace CGAL::Shape_correspondence;

/// A box with n × n squares on each side, rotated by `yaw` about the up axis through the origin.
inline Part_mesh box(const Point& centre, const Point& size, double yaw = 0, int n = 2)
{
  std::vector<Point> points;
  std::vector<Eigen::Vector3i> triangles;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    Point w = Point::Zero(), u = Point::Zero(), v = Point::Zero();
    w[axis] = sign, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = sign;
    const int first = static_cast<int>(points.size());
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        points.push_back((w + (2.0 * i / n - 1) * u + (2.0 * j / n - 1) * v).cwiseProduct(size) / 2 + centre);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int p = first + i * (n + 1) + j, q = p + n + 1;
        triangles.emplace_back(p, q, q + 1);
        triangles.emplace_back(p, q + 1, p + 1);
      }
  }
  Part_mesh mesh;
  mesh.points.resize(3, points.size());
  mesh.triangles.resize(3, triangles.size());
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(yaw, Point::UnitY()).toRotationMatrix();
  for (std::size_t i = 0; i < points.size(); ++i)
    mesh.points.col(i) = turn * points[i];
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.col(i) = triangles[i];
  return mesh;
}

/// A table: a plate on four legs.
inline Segmented_shape table()
{
  Segmented_shape shape("table");
  shape.add_part("plate", box({0, 0.975, 0}, {1.6, 0.05, 0.9}));
  const double x = 0.7, z = 0.35;
  int i = 0;
  for (const Point& p : {Point(x, 0.475, z), Point(-x, 0.475, z), Point(x, 0.475, -z), Point(-x, 0.475, -z)})
    shape.add_part("leg_" + std::to_string(++i), box(p, {0.08, 0.95, 0.08}));
  return shape;
}

/// A box with a knob, since a shape has at least two parts.
inline Segmented_shape knobbed_box(const Point& size)
{
  Segmented_shape shape;
  shape.add_part("box", box({0, size.y() / 2, 0}, size));
  shape.add_part("knob", box({0, size.y() + 0.02, 0}, {0.04, 0.04, 0.04}));
  return shape;
}

/// A plate with a knob, and three laths in its place, side by side along x with gaps between them.
inline Segmented_shape knobbed_plate() { return knobbed_box({1.2, 0.1, 0.6}); }
inline Segmented_shape three_laths()
{
  Segmented_shape shape("laths");
  for (int i = 0; i < 3; ++i)
    shape.add_part("lath_" + std::to_string(i), box({-0.4 + 0.4 * i, 0.05, 0}, {0.3, 0.1, 0.6}));
  return shape;
}

/// A chair: long back legs, short front legs, a seat, stretchers at both sides and a row of five slats between rails.
inline Segmented_shape chair()
{
  Segmented_shape shape("chair");
  shape.add_part("seat", box({0, 0.45, 0}, {0.5, 0.04, 0.46}));
  for (const double x : {0.22, -0.22}) {
    const std::string side = x > 0 ? "_l" : "_r";
    shape.add_part("front_leg" + side, box({x, 0.215, 0.2}, {0.04, 0.43, 0.04}));
    shape.add_part("back_leg" + side, box({x, 0.5, -0.25}, {0.04, 1.0, 0.04}));
    shape.add_part("stretcher" + side, box({x, 0.15, -0.025}, {0.02, 0.03, 0.41}));
  }
  shape.add_part("rail", box({0, 0.96, -0.25}, {0.4, 0.06, 0.03}));
  for (int i = 0; i < 5; ++i)
    shape.add_part("slat_" + std::to_string(i), box({-0.14 + 0.07 * i, 0.7, -0.25}, {0.03, 0.46, 0.01}));
  return shape;
}

/// A stool: a seat on a post on a star of five feet.
inline Segmented_shape star_stool()
{
  Segmented_shape shape("star_stool");
  shape.add_part("seat", box({0, 0.63, 0}, {0.42, 0.06, 0.36}));
  shape.add_part("post", box({0, 0.325, 0}, {0.06, 0.55, 0.05}));
  for (int i = 0; i < 5; ++i)
    shape.add_part("foot_" + std::to_string(i),
                   box({0.17, 0.03, 0}, {0.29, 0.04, 0.03}, 0.3 + i * 2 * 3.14159265358979 / 5));
  return shape;
}

struct Motion
{
  double scale = 1, yaw = 0;
  Point shift = Point::Zero();

  Points operator()(const Points& points) const
  {
    return (scale * (Eigen::AngleAxisd(yaw, Point::UnitY()).toRotationMatrix() * points)).colwise() + shift;
  }
};

inline Segmented_shape moved(const Segmented_shape& shape, const Motion& motion, const std::vector<std::size_t>& order)
{
  Segmented_shape result(shape.name());
  for (std::size_t i : order) {
    const Shape_part& part = shape.parts()[i];
    result.add_part(part.name, {motion(part.mesh.points), part.mesh.triangles});
  }
  return result;
}

inline std::vector<std::size_t> random_order(std::size_t n, std::mt19937& random)
{
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i)
    order[i] = i;
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[random() % i]);
  return order;
}

inline Motion random_motion(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  return {std::exp(3 * unit(random)), 3.14159 * unit(random), 10 * Point(unit(random), unit(random), unit(random))};
}

/// The shape with vertices displaced at random by up to a fraction of the shape's diagonal.
inline Segmented_shape noisy(const Segmented_shape& shape, double fraction, std::mt19937& random)
{
  Eigen::AlignedBox3d bounds;
  for (const Shape_part& part : shape.parts())
    for (Eigen::Index i = 0; i < part.mesh.points.cols(); ++i)
      bounds.extend(Point(part.mesh.points.col(i)));
  std::uniform_real_distribution<double> unit(-1, 1);
  Segmented_shape result(shape.name());
  for (const Shape_part& part : shape.parts()) {
    Part_mesh mesh = part.mesh;
    for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
      mesh.points.col(i) +=
          fraction * bounds.diagonal().norm() * Point(unit(random), unit(random), unit(random)) / std::sqrt(3.0);
    result.add_part(part.name, mesh);
  }
  return result;
}

/// Abstracts a part without skeletonization: the curve along its bounding box's longest axis, and surface points.
inline Part_abstraction quick_part(const Shape_part& input)
{
  Part_abstraction part;
  part.name = input.name;
  part.surface = sample_surface(input.mesh, 256);
  part.hull = input.mesh.points;
  const Point low = part.hull.rowwise().minCoeff(), high = part.hull.rowwise().maxCoeff();
  Eigen::Index longest;
  const Point extent = high - low;
  extent.maxCoeff(&longest);
  Curve curve;
  curve.points.resize(3, 2);
  curve.points << (low + high) / 2, (low + high) / 2;
  curve.points(longest, 0) = low[longest];
  curve.points(longest, 1) = high[longest];
  part.geometry = curve;
  return part;
}

inline std::vector<Part_abstraction> quick_parts(const Segmented_shape& shape)
{
  std::vector<Part_abstraction> parts;
  for (const Shape_part& part : shape.parts())
    parts.push_back(quick_part(part));
  return parts;
}

inline Shape_frame frame_of(const std::vector<Part_abstraction>& parts, const Point& up = Point::UnitY())
{
  Points all(3, 0);
  for (const Part_abstraction& part : parts) {
    all.conservativeResize(3, all.cols() + part.surface.cols());
    all.rightCols(part.surface.cols()) = part.surface;
  }
  return compute_shape_frame(all, up);
}

using Names = std::set<std::string>;

} // namespace box_shapes

#endif // SHAPE_CORRESPONDENCE_TEST_BOX_SHAPES_H
