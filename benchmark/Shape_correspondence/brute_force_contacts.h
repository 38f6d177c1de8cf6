// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of parts by many points on either surface and CGAL's AABB tree of the other: slow, and independent of how
// contacts are detected.
#ifndef CGAL_SHAPE_CORRESPONDENCE_BENCHMARK_BRUTE_FORCE_CONTACTS_H
#define CGAL_SHAPE_CORRESPONDENCE_BENCHMARK_BRUTE_FORCE_CONTACTS_H

#include "shape/surface_tree.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace benchmark {

class Brute_force_contacts
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = internal::Surface_tree<Kernel, Primitive>;

  struct Surface
  {
    Triangles triangles;
    Tree tree;
    Points samples;
    double spacing; // of the samples, about
  };

  static constexpr std::size_t sample_count = 3000;
  std::vector<std::unique_ptr<Surface>> surfaces_;

  static Kernel::Point_3 cgal_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

  double one_sided(std::size_t from, std::size_t to) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < surfaces_[from]->samples.cols(); ++i)
      least = std::min(least, surfaces_[to]->tree.squared_distance(cgal_point(surfaces_[from]->samples.col(i))));
    return std::sqrt(least);
  }

public:
  explicit Brute_force_contacts(const Segmented_shape& shape)
  {
    for (const Shape_part& part : shape.parts()) {
      auto surface = std::make_unique<Surface>();
      double area = 0;
      for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t) {
        const auto corner = [&](int k) { return cgal_point(part.mesh.points.col(part.mesh.triangles(k, t))); };
        const Kernel::Triangle_3 triangle(corner(0), corner(1), corner(2));
        if (triangle.is_degenerate()) continue;
        surface->triangles.push_back(triangle);
        area += std::sqrt(triangle.squared_area());
      }
      surface->tree.insert(surface->triangles.begin(), surface->triangles.end());
      surface->tree.accelerate_distance_queries();
      const Points inner = sample_surface(part.mesh, sample_count);
      surface->samples.resize(3, inner.cols() + part.mesh.points.cols());
      surface->samples << inner, part.mesh.points;
      surface->spacing = std::sqrt(area / double(sample_count));
      surfaces_.push_back(std::move(surface));
    }
  }

  /// The least distance of a sample of either part from the other: at least the distance of the surfaces.
  double distance(std::size_t a, std::size_t b) const { return std::min(one_sided(a, b), one_sided(b, a)); }

  /// By how much `distance()` may be above the distance of the surfaces.
  double uncertainty(std::size_t a, std::size_t b) const
  {
    return std::max(surfaces_[a]->spacing, surfaces_[b]->spacing);
  }

  /// Whether a part is inside another: a ray from it leaves the other's surface.
  bool is_inside(std::size_t inner, std::size_t outer) const
  {
    const Kernel::Ray_3 ray(cgal_point(surfaces_[inner]->samples.col(0)), Kernel::Vector_3(0.577, 0.612, 0.541));
    return surfaces_[outer]->tree.number_of_intersected_primitives(ray) % 2 == 1;
  }
};

} // namespace benchmark
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BENCHMARK_BRUTE_FORCE_CONTACTS_H
