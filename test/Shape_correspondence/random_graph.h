// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_RANDOM_GRAPH_H
#define SHAPE_CORRESPONDENCE_TEST_RANDOM_GRAPH_H

#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace random_graph {

using namespace CGAL::Shape_correspondence;

/// A random coordinate, occasionally degenerate: zero, tiny, huge, or a grid point that recurs.
inline double coordinate(std::mt19937& random)
{
  switch (random() % 16) {
  case 0:
    return 0;
  case 1:
    return 1e-12;
  case 2:
    return random() % 64 == 0 ? 1e12 : 1;
  case 3:
    return -1;
  default:
    return double(random() % 9) / 4 + (random() % 2 == 0 ? 0 : double(random() % 1000) / 1e3);
  }
}

inline Point point(std::mt19937& random)
{
  const double x = coordinate(random), y = coordinate(random);
  return {x, y, coordinate(random)};
}

inline Part_abstraction part(std::mt19937& random, const std::string& name)
{
  Part_abstraction result;
  result.name = name;
  const int rows = 2 + int(random() % 4), cols = 2 + int(random() % 3);
  const bool is_sheet = random() % 3 == 0;
  Points points(3, is_sheet ? rows * cols : rows);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = random() % 8 == 0 && i > 0 ? Point(points.col(i - 1)) : point(random);
  if (is_sheet)
    result.geometry = Sheet{points, rows, cols};
  else
    result.geometry = Curve{points, random() % 4 == 0};
  result.volume = random() % 4 == 0 ? 0 : std::abs(coordinate(random));
  result.hull_volume = random() % 4 == 0 ? 0 : result.volume * 2;
  result.area = random() % 4 == 0 ? 0 : std::abs(coordinate(random));
  if (random() % 2 == 0) {
    result.surface.resize(3, 1 + Eigen::Index(random() % 20));
    for (Eigen::Index i = 0; i < result.surface.cols(); ++i)
      result.surface.col(i) = point(random);
  }
  return result;
}

/// A random shape of at most `most_parts` parts; groups and contacts are random, or detected by the library.
inline Structural_graph graph(std::mt19937& random, std::size_t most_parts)
{
  Shape_structure shape;
  shape.name = "random";
  const std::size_t n = 2 + random() % (most_parts - 1);
  for (std::size_t i = 0; i < n; ++i)
    shape.parts.push_back(i > 0 && random() % 6 == 0 ? shape.parts[random() % i] : part(random, ""));
  for (std::size_t i = 0; i < n; ++i)
    shape.parts[i].name = "part " + std::to_string(i);
  Points all(3, 0);
  for (const Part_abstraction& p : shape.parts) {
    all.conservativeResize(3, all.cols() + p.control_points().cols());
    all.rightCols(p.control_points().cols()) = p.control_points();
  }
  shape.frame = compute_shape_frame(all, Point::UnitY());
  if (!(shape.frame.height > 0)) shape.frame.height = 1;
  if (random() % 2 == 0)
    for (std::size_t k = random() % (2 * n); k > 0; --k) {
      Contact contact;
      contact.parts = {random() % n, random() % n};
      for (Eigen::Vector2d& parameter : contact.parameters)
        parameter = {double(random() % 5) / 4, double(random() % 5) / 4};
      if (contact.parts[0] != contact.parts[1]) shape.contacts.push_back(contact);
    }
  std::vector<Part_group> groups;
  if (random() % 2 == 0) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t begin = 0; begin < n;) {
      const std::size_t end = std::min(n, begin + 1 + random() % 4);
      Part_group group;
      group.parts.assign(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(end));
      if (end - begin > 1) {
        group.symmetry.type = random() % 2 == 0 ? Symmetry_type::REFLECTION : Symmetry_type::TRANSLATION;
        group.symmetry.direction = Point::Unit(Eigen::Index(random() % 3));
      }
      group.volume = std::abs(coordinate(random));
      groups.push_back(std::move(group));
      begin = end;
    }
  }
  return complete_structural_graph(std::move(shape), std::move(groups));
}

} // namespace random_graph

#endif // SHAPE_CORRESPONDENCE_TEST_RANDOM_GRAPH_H
