// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "generator/benchmark/boat_designs.h"
#include "generator/benchmark/cart_designs.h"
#include "generator/benchmark/degrade.h"
#include "generator/grammar/kinds.h"
#include "generator/models.h"
#include "generator/surface_distance.h"
#include "generator/writer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace gen = CGAL::Shape_correspondence::generator;
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

bool is_closed(const Mesh& mesh)
{
  std::map<std::pair<int, int>, int> uses;
  for (const auto& f : mesh.faces)
    for (int i = 0; i < 3; ++i)
      ++uses[{f[i], f[(i + 1) % 3]}];
  for (const auto& [edge, n] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    if (n != 1 || opposite == uses.end() || opposite->second != 1) return false;
  }
  return true;
}

std::vector<double> component_volumes(const Mesh& mesh)
{
  CGAL::Shape_correspondence::internal::Disjoint_sets sets(mesh.points.size());
  for (const auto& f : mesh.faces) {
    sets.unite(f[0], f[1]);
    sets.unite(f[0], f[2]);
  }
  std::map<std::size_t, Mesh> components;
  for (const auto& f : mesh.faces) {
    Mesh& component = components[sets[f[0]]];
    component.points = mesh.points;
    component.faces.push_back(f);
  }
  std::vector<double> volumes;
  for (const auto& component : components)
    volumes.push_back(gen::volume(component.second));
  return volumes;
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

/// Mirrored copies are exact; others differ by the rounding of both copies.
constexpr double copy_tolerance = 1.25 * gen::grid_step;

constexpr double near_copy_tolerance = 0.01;

/// Distance below which parts are in contact, over the shape's diagonal.
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
    return k < 2 ? in_x : Point(in_x.x(), in_x.y(), -in_x.z()); // the back pair of four
  }
  case gen::Symmetry::rotation:
    return gen::rotation_about(group.point, group.direction, 2 * gen::pi * k / group.parts.size()) * p;
  default:
    return p + double(k) * group.direction;
  }
}

/// The largest difference of the bounding boxes, over the diagonal.
double box_difference(const Mesh& mesh, const Mesh& other, const Point& shift)
{
  const Box a = box_of(mesh.points), b = box_of(other.points);
  const double low = (a.min() + shift - b.min()).cwiseAbs().maxCoeff();
  const double high = (a.max() + shift - b.max()).cwiseAbs().maxCoeff();
  return std::max(low, high) / a.diagonal().norm();
}

} // namespace

TEST_CASE("groups are what they say", "[generate_models]")
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

namespace {

/// FNV-1a hash of the names and contents of files.
std::uint64_t hash_of(const std::vector<gen::Assembly>& shapes)
{
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const gen::Assembly& shape : shapes)
    for (const auto& [path, content] : gen::folder_files(shape))
      for (unsigned char c : path + content)
        hash = (hash ^ c) * 0x100000001b3;
  return hash;
}

/// The number of connected components of parts in contact.
std::size_t number_of_pieces(const gen::Assembly& shape)
{
  CGAL::Shape_correspondence::internal::Disjoint_sets pieces(shape.parts.size());
  for (const auto& near : shape.near_parts(.005))
    pieces.unite(near.parts[0], near.parts[1]);
  return pieces.number_of_sets();
}

std::vector<gen::Assembly> gallery_shapes()
{
  std::vector<gen::Assembly> shapes = gen::boats();
  for (const gen::Assembly& cart : gen::carts())
    shapes.push_back(cart);
  return shapes;
}

// Every part has a role and a closed outward mesh, and is of the size of the shape; \return the roles by category.
std::map<std::string, std::set<std::string>> checked_roles(const std::vector<gen::Assembly>& shapes)
{
  std::map<std::string, std::set<std::string>> roles;
  for (const gen::Assembly& shape : shapes) {
    std::set<std::string> parts;
    INFO(shape.name);
    CHECK(shape.parts.size() >= 2);
    for (const gen::Part& part : shape.parts) {
      INFO(part.name);
      roles[shape.category].insert(part.label.coarse);
      CHECK(parts.insert(part.name).second);
      CHECK(is_closed(part.solid.mesh));
      CHECK(gen::volume(part.solid.mesh) > 0);
    }
  }
  return roles;
}

} // namespace

TEST_CASE("the grammar draws shapes of ten categories with roles that follow from it", "[grammar]")
{
  const auto roles = checked_roles(gen::drawn_shapes(600, 1));
  CHECK(roles.size() == 10);
  const auto has = [&](const char* category, std::set<std::string> wanted) {
    INFO(category);
    CHECK(std::includes(roles.at(category).begin(), roles.at(category).end(), wanted.begin(), wanted.end()));
  };
  has("airplane", {"engine", "fuselage", "gear", "h_stab", "propeller", "v_stab", "wing"});
  has("bed", {"bedding", "footboard", "headboard", "leg", "mattress", "pillow", "side_rail"});
  has("car", {"body", "bumper", "light", "mirror", "wheel", "window"});
  has("chair", {"armrest", "back", "leg", "seat", "seat_frame", "stretcher"});
  has("lamp", {"arm", "base", "body", "bulb", "chain", "shade"});
  has("plant", {"leaf", "pot", "soil", "stem"});
  has("shelf", {"back", "body", "bottom", "divider", "door", "drawer", "handle", "leg", "shelf", "side", "top"});
  has("sofa", {"armrest", "back", "base", "cushion", "leg", "seat"});
  has("table", {"apron", "cabinet", "drawer", "leg", "panel", "shelf", "stretcher", "tabletop"});
  has("velocipede", {"drivetrain", "fork", "frame", "handlebar", "pedal", "saddle", "wheel"});
}

TEST_CASE("the grammar gives the same bits for a seed and others for another one", "[grammar]")
{
  const std::uint64_t hash = hash_of(gen::drawn_shapes(30, 1));
  CHECK(hash == hash_of(gen::drawn_shapes(30, 1)));
  CHECK(hash != hash_of(gen::drawn_shapes(30, 2)));
  CHECK(hash == 0xae56c0d51601a1b5);
}

TEST_CASE("a star base comes in one part and in several", "[grammar]")
{
  std::set<bool> found; // whether all legs are one part
  for (const gen::Assembly& shape : gen::drawn_shapes(1500, 3)) {
    std::vector<gen::Mesh> legs;
    for (const gen::Part& part : shape.parts)
      if (part.label.coarse == "leg" && part.label.fine != "pedestal_post") legs.push_back(part.solid.mesh);
    const bool has_post = std::any_of(shape.parts.begin(), shape.parts.end(),
                                      [](const gen::Part& part) { return part.label.fine == "pedestal_post"; });
    if (shape.category != "chair" || !has_post) continue;
    if (legs.size() == 1 && component_volumes(legs[0]).size() >= 3) found.insert(true);
    if (legs.size() >= 3) found.insert(false);
  }
  CHECK(found.size() == 2);
}

TEST_CASE("methods are compared on fifteen shapes of each category", "[grammar]")
{
  std::map<std::string, int> counts;
  std::set<std::string> names;
  for (const gen::Assembly& shape : gen::compared_shapes()) {
    ++counts[shape.category];
    CHECK(names.insert(shape.name).second);
  }
  CHECK(counts == std::map<std::string, int>{
                      {"airplane", 15}, {"bed", 15}, {"chair", 15}, {"lamp", 15}, {"table", 15}, {"velocipede", 15}});
}

TEST_CASE("boats and carts of the gallery are whole, and the same bits every time", "[benchmark_shapes]")
{
  const std::vector<gen::Assembly> shapes = gallery_shapes();
  std::map<std::string, int> counts;
  for (const gen::Assembly& shape : shapes) {
    INFO(shape.name);
    ++counts[shape.category];
    CHECK(number_of_pieces(shape) == 1);
    for (const gen::Part& part : shape.parts) {
      INFO(part.name);
      CHECK(is_closed(part.solid.mesh));
      CHECK_FALSE(part.label.coarse.empty());
    }
  }
  CHECK(counts == std::map<std::string, int>{{"boat", 3}, {"cart", 3}});
  CHECK(hash_of(shapes) == hash_of(gallery_shapes()));
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

TEST_CASE("shapes are degraded as requested, and in no other way", "[benchmark_shapes]")
{
  const gen::Assembly model = gen::models().front().make();
  const auto made_worse = [&](bool gen::Degradation::*way, std::uint64_t seed = 7) {
    gen::Degradation ways;
    ways.*way = true;
    return gen::degraded(model, ways, seed);
  };
  const auto total = [](const gen::Assembly& shape, const auto& measure) {
    double sum = 0;
    for (const gen::Part& part : shape.parts)
      sum += measure(part.solid.mesh);
    return sum;
  };
  const auto faces = [](const Mesh& mesh) { return double(mesh.faces.size()); };

  SECTION("in no way")
  {
    const gen::Assembly same = gen::degraded(model, {}, 7);
    for (std::size_t i = 0; i < model.parts.size(); ++i)
      CHECK(same.parts[i].solid.mesh.points == model.parts[i].solid.mesh.points);
  }
  SECTION("segmentation: other parts, the same surface")
  {
    const gen::Assembly other = made_worse(&gen::Degradation::segmentation);
    CHECK(other.parts.size() != model.parts.size());
    CHECK(total(other, faces) == total(model, faces));
    std::set<std::string> names;
    for (const gen::Part& part : other.parts) {
      CHECK(names.insert(part.name).second);
      CHECK_FALSE(part.label.coarse.empty());
    }
  }
  SECTION("openings: some surfaces are open, none is lost")
  {
    const gen::Assembly other = made_worse(&gen::Degradation::openings);
    int open = 0;
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      const Mesh& mesh = other.parts[i].solid.mesh;
      open += !is_closed(mesh);
      CHECK(2 * mesh.faces.size() > model.parts[i].solid.mesh.faces.size());
    }
    CHECK(open > 3);
    CHECK(open < int(model.parts.size()));
  }
  SECTION("gaps: parts are smaller and fewer touch")
  {
    const gen::Assembly other = made_worse(&gen::Degradation::gaps);
    CHECK(total(other, gen::volume) < total(model, gen::volume));
    CHECK(other.near_parts(1e-4).size() < model.near_parts(1e-4).size());
  }
  SECTION("noise: vertices move a little")
  {
    const gen::Assembly other = made_worse(&gen::Degradation::noise);
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      const Mesh &mesh = other.parts[i].solid.mesh, &before = model.parts[i].solid.mesh;
      CHECK(mesh.points != before.points);
      for (std::size_t k = 0; k < mesh.points.size(); ++k)
        CHECK((mesh.points[k] - before.points[k]).norm() < .01 * gen::diagonal(before) + gen::grid_step);
    }
  }
  SECTION("scale and rotation: shapes stay upright")
  {
    const auto extent = [](const gen::Assembly& shape) {
      Box box;
      for (const gen::Part& part : shape.parts)
        box.extend(box_of(part.solid.mesh.points));
      return Point(box.diagonal());
    };
    const Point before = extent(model), scaled = extent(made_worse(&gen::Degradation::scale)),
                turned = extent(made_worse(&gen::Degradation::rotation));
    for (int k = 0; k < 3; ++k) {
      CHECK(scaled[k] / before[k] > .74);
      CHECK(scaled[k] / before[k] < 1.31);
    }
    CHECK(scaled[0] / before[0] != Approx(scaled[1] / before[1]));
    CHECK(turned.y() == Approx(before.y()));
    CHECK(turned.x() != Approx(before.x()));
  }
  SECTION("one way changes nothing about the other, and seeds matter")
  {
    gen::Degradation both;
    both.openings = both.rotation = true;
    const gen::Assembly one = made_worse(&gen::Degradation::openings), two = gen::degraded(model, both, 7);
    for (std::size_t i = 0; i < model.parts.size(); ++i)
      CHECK(one.parts[i].solid.mesh.faces == two.parts[i].solid.mesh.faces);
    CHECK(hash_of({made_worse(&gen::Degradation::noise, 8)}) != hash_of({made_worse(&gen::Degradation::noise)}));
  }
  SECTION("the same bits every time")
  {
    gen::Degradation all;
    all.segmentation = all.openings = all.gaps = all.noise = all.scale = all.rotation = true;
    CHECK(hash_of({gen::degraded(model, all, 1)}) == 0x29ae6b44ff212f88);
  }
}
