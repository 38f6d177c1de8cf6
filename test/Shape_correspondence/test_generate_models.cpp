// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed_meshes.h"
#include "generator/models.h"
#include "generator/surface_distance.h"
#include "generator/writer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

using namespace closed_meshes;
namespace fs = std::filesystem;

namespace {

using gen::Box;
using gen::box_of;
using gen::Mesh;
using gen::Point;

const fs::path data_folder = SHAPE_CORRESPONDENCE_DATA_DIR;

std::string content_of(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool self_intersects(const Mesh& mesh)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> surface;
  using Vertex = CGAL::SM_Vertex_index;
  for (const Point& p : mesh.points)
    surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& f : mesh.faces)
    surface.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
  return CGAL::Polygon_mesh_processing::does_self_intersect(surface);
}

/// Limit for the difference of copies that are not mirror images, which comes from rounding both copies to the grid.
constexpr double copy_tolerance = 1.25 * gen::grid_step;

/// Limit for the difference of the bounding boxes of near copies, divided by the diagonal.
constexpr double near_copy_tolerance = 0.01;

/// Distance below which parts are in contact, divided by the shape's diagonal.
constexpr double touch_tolerance = 5e-4;

const gen::Part& part_of(const gen::Assembly& shape, const std::string& name) { return shape.parts[shape.index(name)]; }

} // namespace

TEST_CASE("the models in data/ are what the generator makes", "[generate_models]")
{
  std::set<fs::path> expected;
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    CHECK(shape.name == model.name);
    for (const auto& [path, content] : gen::folder_files(shape)) {
      INFO(path);
      CHECK(content_of(data_folder / path) == content);
      expected.insert(data_folder / path);
    }
    for (const auto& entry : fs::recursive_directory_iterator(data_folder / model.name)) {
      INFO(entry.path());
      CHECK((entry.is_directory() || expected.count(entry.path()) == 1));
    }
  }
}

TEST_CASE("the models in data/raw are what the generator makes", "[generate_models]")
{
  int found = 0;
  for (const gen::Model& model : gen::models())
    for (const auto& [path, content] : gen::raw_file(model.make())) {
      if (!fs::exists(data_folder / "raw" / path)) continue;
      INFO(path);
      CHECK(content_of(data_folder / "raw" / path) == content);
      ++found;
    }
  CHECK(found == 2);
}

TEST_CASE("every part is a closed outward mesh without self-intersections", "[generate_models]")
{
  std::vector<gen::Assembly> shapes;
  for (const gen::Model& model : gen::models())
    shapes.push_back(model.make());
  for (const gen::Assembly& shape : shapes)
    for (const gen::Part& part : shape.parts) {
      const Mesh& mesh = part.solid.mesh;
      INFO(shape.name << ": " << part.name);
      CHECK(is_closed(mesh));
      CHECK(mesh.faces.size() >= 50);
      CHECK(mesh.faces.size() <= 1500);
      for (double volume : component_volumes(mesh))
        CHECK(volume > 0);
      CHECK_FALSE(self_intersects(mesh));
    }
}

TEST_CASE("labels are complete and parts have names of their own", "[generate_models]")
{
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    INFO(model.name);
    CHECK(shape.parts.size() >= 6);
    CHECK(shape.parts.size() <= 30);
    CHECK_FALSE(shape.category.empty());
    std::set<std::string> names;
    for (const gen::Part& part : shape.parts) {
      CHECK_FALSE(part.label.coarse.empty());
      CHECK(names.insert(part.name).second);
    }
  }
}

TEST_CASE("every part is in one group", "[generate_models]")
{
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    std::multiset<std::string> grouped;
    for (const gen::Part_group& group : shape.groups)
      grouped.insert(group.parts.begin(), group.parts.end());
    INFO(model.name);
    CHECK(grouped.size() == shape.parts.size());
    for (const gen::Part& part : shape.parts)
      CHECK(grouped.count(part.name) == 1);
  }
}

namespace {

/// The image of a point of a group's first member in the k-th member.
Point image(const gen::Part_group& group, std::size_t k, const Point& p)
{
  switch (group.symmetry) {
  case gen::Symmetry::reflection: {
    const Point once = p - 2 * group.direction.dot(p) * group.direction;
    const Point in_x = k % 2 == 1 ? once : p;
    return k < 2 ? in_x : Point(in_x.x(), in_x.y(), -in_x.z()); // of four members, the last two are at the back
  }
  case gen::Symmetry::rotation:
    return gen::rotation_about(group.point, group.direction, 2 * gen::pi * k / group.parts.size()) * p;
  default:
    return p + double(k) * group.direction;
  }
}

/// The largest difference of the bounding boxes of the shifted mesh and the other one, divided by the diagonal.
double box_difference(const Mesh& mesh, const Mesh& other, const Point& shift)
{
  const Box a = box_of(mesh.points), b = box_of(other.points);
  const double low = (a.min() + shift - b.min()).cwiseAbs().maxCoeff();
  const double high = (a.max() + shift - b.max()).cwiseAbs().maxCoeff();
  return std::max(low, high) / a.diagonal().norm();
}

} // namespace

TEST_CASE("members of groups are the images of the first member under the symmetry of the group", "[generate_models]")
{
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    for (const gen::Part_group& group : shape.groups) {
      const Mesh& first = part_of(shape, group.parts[0]).solid.mesh;
      for (std::size_t k = 1; k < group.parts.size(); ++k) {
        INFO(model.name << ": " << group.parts[k]);
        const Mesh& copy = part_of(shape, group.parts[k]).solid.mesh;
        if (group.near_copies) {
          CHECK(box_difference(first, copy, double(k) * group.direction) <= near_copy_tolerance);
          continue;
        }
        REQUIRE(copy.points.size() == first.points.size());
        double error = 0;
        for (std::size_t i = 0; i < first.points.size(); ++i)
          error = std::max(error, (copy.points[i] - image(group, k, first.points[i])).cwiseAbs().maxCoeff());
        CHECK(error <= (group.symmetry == gen::Symmetry::reflection ? 0. : copy_tolerance));
      }
    }
  }
}

TEST_CASE("the stated contacts are the parts that touch", "[generate_models]")
{
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    std::set<std::array<int, 2>> touching;
    for (const auto& near : shape.near_parts(touch_tolerance))
      touching.insert(near.parts);
    const std::set<std::array<int, 2>> stated(shape.contacts.begin(), shape.contacts.end());
    INFO(model.name);
    CHECK(stated.size() == shape.contacts.size());
    CHECK(touching == stated);
  }
}

TEST_CASE("distances of surfaces, worked out by hand", "[generate_models]")
{
  const auto triangle = [](const Point& a, const Point& b, const Point& c) { return Mesh{{a, b, c}, {{0, 1, 2}}}; };
  const Mesh flat = triangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  const auto distance = [&](const Mesh& other) { return gen::surface_distance(flat, other, 10); };
  CHECK(distance(triangle({.5, .5, 1}, {.5, .5, 3}, {.6, .6, 3})) == Approx(1));            // corner and face
  CHECK(distance(triangle({.5, .5, -1}, {.5, .5, 3}, {.6, .6, 3})) == 0);                   // edge through face
  CHECK(distance(triangle({1, -1, -1}, {1, -1, 1}, {1, -3, 0})) == Approx(1));              // two edges
  CHECK(distance(triangle({-1, -1, 0}, {-2, -1, 0}, {-1, -2, 0})) == Approx(std::sqrt(2))); // two corners
  CHECK(gen::surface_distance(flat, triangle({0, 0, 5}, {1, 0, 5}, {0, 1, 5}), 2) == 2);    // beyond the limit
}

TEST_CASE("raw models have one object for each coarse label, z up, and all faces")
{
  const auto lines_of = [](const gen::Files& files, const std::string& keyword) {
    std::vector<std::string> lines;
    std::istringstream in(files.begin()->second);
    for (std::string line; std::getline(in, line);)
      if (line.rfind(keyword, 0) == 0) lines.push_back(line);
    return lines;
  };
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    INFO(shape.name);
    const gen::Files raw = gen::raw_file(shape), single = gen::single_file(shape);
    std::set<std::string> objects;
    double lowest = 1;
    for (const gen::Part& part : shape.parts) {
      objects.insert("o " + part.label.coarse);
      for (const auto& p : part.solid.mesh.points)
        lowest = std::min(lowest, p.y());
    }
    CHECK(lines_of(raw, "o ") == std::vector<std::string>(objects.begin(), objects.end()));
    CHECK(lines_of(raw, "f ").size() == lines_of(single, "f ").size());
    double lowest_z = 1;
    for (const std::string& line : lines_of(raw, "v "))
      lowest_z = std::min(lowest_z, std::stod(line.substr(line.rfind(' '))));
    CHECK(lowest_z == Approx(lowest).margin(1e-5));
  }
}
