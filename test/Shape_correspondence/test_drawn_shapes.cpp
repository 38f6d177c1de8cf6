// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shapes that the grammar draws, those of the gallery, and degraded ones.

#include "closed_meshes.h"
#include "generator/benchmark/degrade.h"
#include "generator/benchmark/vehicles.h"
#include "generator/grammar/kinds.h"
#include "generator/models.h"
#include "generator/surface_distance.h"
#include "generator/writer.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

using namespace closed_meshes;

namespace {

using gen::Box;
using gen::box_of;
using gen::Mesh;
using gen::Point;

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

// Checks that parts have different names and closed meshes oriented outwards. \return the roles by category
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
  CHECK(hash == 0xcc0a0dec6cc14bec);
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

TEST_CASE("no two handles of furniture are in one place", "[grammar]")
{
  constexpr double apart = .01; // least distance of handles, in metres
  for (const gen::Assembly& shape : gen::drawn_shapes(300, 1)) {
    INFO(shape.name);
    std::vector<Point> handles;
    for (const gen::Part& part : shape.parts)
      if (part.label.coarse == "handle") handles.push_back(box_of(part.solid.mesh.points).center());
    for (std::size_t b = 0; b < handles.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        CHECK((handles[a] - handles[b]).norm() > apart);
  }
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
