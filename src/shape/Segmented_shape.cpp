// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "shape/check_mesh.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/part_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

namespace {

template <typename Matrix, typename Column>
Matrix as_matrix(const std::vector<Column>& columns)
{
  Matrix result(3, Eigen::Index(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    result.col(Eigen::Index(i)) = columns[i];
  return result;
}

std::string part_message(const std::string& name, const std::string& what) { return "part '" + name + "': " + what; }

void check_coordinates(const std::string& name, const Points& points)
{
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    if (!points.col(v).allFinite()) {
      throw Invalid_input(part_message(name, "vertex " + std::to_string(v) +
                                                 " has a coordinate that is not a finite number; "
                                                 "repair or remove it"));
    }
    if (points.col(v).cwiseAbs().maxCoeff() > largest_coordinate) {
      throw Invalid_input(
          part_message(name, "vertex " + std::to_string(v) + " has a coordinate beyond 1e15; scale the model down"));
    }
  }
}

void check_indices(const std::string& name, const Part_mesh& mesh)
{
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.triangles(k, t);
      if (v < 0 || v >= mesh.points.cols()) {
        throw Invalid_input(part_message(name, "triangle " + std::to_string(t) + " refers to vertex " +
                                                   std::to_string(v) + " of " + std::to_string(mesh.points.cols()) +
                                                   "; correct the index or remove the triangle"));
      }
    }
  }
}

void check_triangles_of_vertices(const std::string& name, const Part_mesh& mesh)
{
  std::vector<std::size_t> count(std::size_t(mesh.points.cols()), 0);
  for (const int v : mesh.triangles.reshaped())
    ++count[std::size_t(v)];
  const auto most = std::max_element(count.begin(), count.end());
  if (*most > most_triangles_of_vertex)
    throw Invalid_input(part_message(name, "vertex " + std::to_string(most - count.begin()) + " has " +
                                               std::to_string(*most) + " triangles, of at most " +
                                               std::to_string(most_triangles_of_vertex) +
                                               "; divide its faces in another way, or simplify the part"));
}

} // namespace

int Part_mesh_data::add_point(double x, double y, double z)
{
  points_.emplace_back(x, y, z);
  return int(points_.size()) - 1;
}

void Part_mesh_data::add_polygon(const std::vector<int>& corners)
{
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles_.emplace_back(corners[0], corners[k - 1], corners[k]);
}

Points Part_mesh_data::points() const { return as_matrix<Points>(points_); }

Eigen::Matrix3Xi Part_mesh_data::triangles() const { return as_matrix<Eigen::Matrix3Xi>(triangles_); }

} // namespace CGAL::Shape_correspondence::internal

namespace CGAL::Shape_correspondence {
using namespace internal;

void internal::check_triangles(const std::string& part, const Part_mesh& mesh)
{
  check_coordinates(part, mesh.points);
  check_indices(part, mesh);
  if (mesh.points.cols() > 0) check_triangles_of_vertices(part, mesh);
}

void internal::check_mesh(const std::string& part, const Part_mesh& mesh)
{
  if (mesh.triangles.cols() == 0)
    throw Invalid_input(part_message(part, "no triangles; remove the part or give it a surface"));
  check_triangles(part, mesh);
  if (!has_area(mesh))
    throw Invalid_input(part_message(part, "all triangles have zero area; remove the part or give it a surface"));
}

Segmented_shape::Segmented_shape(std::string name, const Point& up) : name_(std::move(name)) { set_up(up); }

void Segmented_shape::set_up(const Point& up)
{
  up_ = up.normalized();
  if (!(up_.norm() > 0.5))
    throw Invalid_input("shape '" + name_ + "': the up direction is zero or not finite; give a unit vector");
}

void Segmented_shape::add_part(std::string name, Part_mesh mesh)
{
  if (name.empty()) {
    throw Invalid_input("part number " + std::to_string(parts_.size()) + " of shape '" + name_ +
                        "': the name is empty; give every part a name");
  }
  if (names_.count(name) > 0)
    throw Invalid_input(part_message(name, "shape '" + name_ + "' has another part of that name; rename one of them"));
  check_mesh(name, mesh);
  names_.insert(name);
  parts_.push_back({std::move(name), std::move(mesh)});
}

} // namespace CGAL::Shape_correspondence
