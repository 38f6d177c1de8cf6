// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "boxed_graphs.h"

#include "generator/models.h"
#include "generator/textures.h"
#include "texture/textures.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/transfer_appearance.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

using namespace box_shapes;
using namespace boxed_graphs;
using namespace CGAL::Shape_correspondence::internal;

namespace gen = CGAL::Shape_correspondence::generator;

namespace {

// Colours of corners that vary smoothly and are all different.
Shape_appearance rainbow(const Segmented_shape& shape)
{
  Shape_appearance looks;
  Point low = Point::Constant(1e300), high = -low;
  for (const Shape_part& part : shape.parts()) {
    low = low.cwiseMin(part.mesh.points.rowwise().minCoeff());
    high = high.cwiseMax(part.mesh.points.rowwise().maxCoeff());
  }
  for (const Shape_part& part : shape.parts()) {
    looks.parts.emplace_back();
    for (Eigen::Index i = 0; i < part.mesh.triangles.size(); ++i) {
      const Point p = part.mesh.points.col(part.mesh.triangles.data()[i]);
      looks.parts.back().colours.push_back(((p - low).array() / (high - low).array()).matrix().cast<float>());
    }
  }
  return looks;
}

// An appearance with one material for each part.
Shape_appearance painted(const Segmented_shape& shape, const std::vector<Eigen::Vector3d>& colours)
{
  Shape_appearance looks;
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    Eigen::Vector4d colour(0, 0, 0, 1);
    colour.head<3>() = colours[i];
    looks.materials.push_back({"m" + std::to_string(i), colour, -1});
    looks.parts.emplace_back();
    looks.parts.back().materials.assign(std::size_t(shape.parts()[i].mesh.triangles.cols()), int(i));
  }
  return looks;
}

Segmented_shape laths(int n = 3)
{
  Segmented_shape shape("laths");
  for (int i = 0; i < n; ++i)
    shape.add_part("lath_" + std::to_string(i), box({1.2 / n * (i + 0.5) - 0.6, 0.05, 0}, {0.9 / n, 0.1, 0.6}));
  return shape;
}

Segmented_shape plate()
{
  Segmented_shape shape("plate");
  shape.add_part("box", box({0, 0.05, 0}, {1.2, 0.1, 0.6}, 0, 8));
  shape.add_part("knob", box({0, 0.12, 0}, {0.04, 0.04, 0.04}));
  return shape;
}

// The largest difference between two appearances of a shape, in the colours at the centroids of its triangles.
double greatest_difference(const Shape_appearance& a, const Shape_appearance& b, const Segmented_shape& shape)
{
  const Appearance_sampler from(a, Eigen::Vector3d::Zero()), to(b, Eigen::Vector3d::Zero());
  double result = 0;
  for (std::size_t part = 0; part < shape.parts().size(); ++part)
    for (Eigen::Index t = 0; t < shape.parts()[part].mesh.triangles.cols(); ++t) {
      const Eigen::Vector3d middle = Eigen::Vector3d::Constant(1. / 3);
      result = std::max(result, (from(part, std::size_t(t), middle) - to(part, std::size_t(t), middle)).norm());
    }
  return result;
}

} // namespace

TEST_CASE("A shape that is mapped to itself keeps its appearance, in new texture coordinates")
{
  const Segmented_shape shape = chair();
  const Structural_graph graph = graph_of(shape);
  const Shape_appearance looks = rainbow(shape);
  Transfer_options options;
  options.size = 512;
  const Transferred_appearance result =
      transfer_appearance(graph, shape, looks, graph, shape, {}, identity(shape), options);
  CHECK_FALSE(result.has_given_coordinates);
  for (const Transferred_part& part : result.parts)
    CHECK(part.origin == Appearance_origin::SOURCE);
  // Tolerance for the resolution and depth of the texture
  CHECK(greatest_difference(looks, result.appearance, shape) < 0.03);
}

TEST_CASE("The appearance does not depend on the position and size of the target")
{
  const Segmented_shape shape = chair();
  const Shape_appearance looks = rainbow(shape);
  Segmented_shape moved("moved");
  for (const Shape_part& part : shape.parts())
    moved.add_part(part.name, {Points((7 * part.mesh.points).colwise() + Point(20, -3, 5)), part.mesh.triangles});
  Transfer_options options;
  options.size = 512;
  const Transferred_appearance result =
      transfer_appearance(graph_of(shape), shape, looks, graph_of(moved), moved, {}, identity(shape), options);
  CHECK(greatest_difference(looks, result.appearance, shape) < 0.03);
}

TEST_CASE("New texture coordinates are inside the image, do not overlap, and have one scale")
{
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly assembly = model.make();
    Segmented_shape shape(assembly.name);
    for (const gen::Part& part : assembly.parts) {
      Part_mesh mesh{Points(3, part.solid.mesh.points.size()), Eigen::Matrix3Xi(3, part.solid.mesh.faces.size())};
      for (std::size_t i = 0; i < part.solid.mesh.points.size(); ++i)
        mesh.points.col(Eigen::Index(i)) = part.solid.mesh.points[i];
      for (std::size_t i = 0; i < part.solid.mesh.faces.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          mesh.triangles(Eigen::Index(k), Eigen::Index(i)) = part.solid.mesh.faces[i][k];
      shape.add_part(part.name, mesh);
    }
    constexpr int size = 1024;
    const Texture_layout layout = new_layout(shape, Eigen::Matrix3d::Identity(), size, 2);
    CAPTURE(shape.name());
    std::vector<int> owner(std::size_t(size) * size, -1);
    std::size_t covered = 0, twice = 0;
    double least = 1e300, greatest = 0;
    for (std::size_t part = 0; part < layout.size(); ++part)
      for (std::size_t t = 0; t < layout[part].size(); ++t) {
        const Flat_triangle& flat = layout[part][t];
        for (const Eigen::Vector2d& corner : flat) {
          REQUIRE(corner.minCoeff() >= 0);
          REQUIRE(corner.maxCoeff() <= size);
        }
        for_each_pixel(flat, size, [&](std::size_t at) {
          int& pixel = owner[at];
          ++covered;
          twice += pixel >= 0;
          pixel = int(t);
        });
        const Part_mesh& mesh = shape.parts()[part].mesh;
        const auto corner = [&](int k) -> Point { return mesh.points.col(mesh.triangles(k, Eigen::Index(t))); };
        const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
        const double flat_area = std::abs(cross(flat[1] - flat[0], flat[2] - flat[0]));
        if (area < 1e-5) continue;
        least = std::min(least, flat_area / area);
        greatest = std::max(greatest, flat_area / area);
      }
    CHECK(double(twice) < 0.01 * double(covered));
    CHECK(greatest < 3 * least); // triangles oblique to the projection are smaller
  }
}

TEST_CASE(
    "A panel that three laths merge into has the appearance of the largest, not bands, and so do parts that touch it")
{
  Segmented_shape source("laths");
  const double widths[] = {0.3, 0.5, 0.2};
  double x = -0.6;
  for (double width : widths) {
    source.add_part("lath" + std::to_string(source.parts().size()), box({x + width / 2, 0.05, 0}, {width, 0.1, 0.6}));
    x += 1.1 * width;
  }
  const Segmented_shape target = plate();
  const Transferred_appearance result =
      transfer_appearance(graph_of(source), source, painted(source, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
                          graph_of(target), target, {}, pairing({{0, 0}, {1, 0}, {2, 0}}));
  CHECK(result.parts[0].sources == std::vector<std::size_t>{1, 0, 2});
  CHECK(result.parts[0].origin == Appearance_origin::SOURCE);
  CHECK(result.parts[1].origin == Appearance_origin::NEIGHBOUR); // the knob has no appearance of its own
  CHECK(result.parts[1].neighbour == 0);
  CHECK(greatest_difference(painted(target, {{0, 1, 0}, {0, 1, 0}}), result.appearance, target) < 0.02);
}

TEST_CASE("Of merged parts of about equal size the highest one gives the appearance, if it has any")
{
  Segmented_shape source("seat");
  source.add_part("board", box({0, 0.05, 0}, {1.25, 0.1, 0.6}));
  source.add_part("pad", box({0, 0.15, 0}, {1.2, 0.1, 0.6}));
  source.add_part("label", box({0, 0.21, 0}, {0.1, 0.02, 0.1}));
  const Segmented_shape target = plate();
  Shape_appearance looks = painted(source, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const auto first_source = [&] {
    return transfer_appearance(graph_of(source), source, looks, graph_of(target), target, {},
                               pairing({{0, 0}, {1, 0}, {2, 0}}))
        .parts[0]
        .sources[0];
  };
  CHECK(first_source() == 1);
  looks.parts[1] = {};
  CHECK(first_source() == 0);
}

TEST_CASE("A part without counterpart looks like the part of its material that it touches, also through other parts")
{
  Segmented_shape target("tower"); // a plate, a block on it, a knob on that, and a handle of another material
  target.add_part("plate", box({0, 0.05, 0}, {1.2, 0.1, 0.6}));
  target.add_part("block", box({0, 0.2, 0}, {0.3, 0.2, 0.3}));
  target.add_part("knob", box({0, 0.35, 0}, {0.1, 0.1, 0.1}));
  target.add_part("handle", box({0.65, 0.05, 0}, {0.1, 0.05, 0.2}));
  Shape_appearance own = painted(target, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 1, 0}});
  for (std::size_t part : {1, 2})
    std::fill(own.parts[part].materials.begin(), own.parts[part].materials.end(), 0);
  const Segmented_shape source = plate();
  const Shape_appearance looks = painted(source, {{1, 0, 0}, {0, 1, 0}});
  const auto transferred = [&](const Shape_appearance& of_target) {
    return transfer_appearance(graph_of(source), source, looks, graph_of(target), target, of_target, pairing({{0, 0}}));
  };
  const Transferred_appearance result = transferred(own);
  CHECK(result.parts[1].neighbour == 0);
  CHECK(result.parts[2].neighbour == 1);
  CHECK(result.parts[2].origin == Appearance_origin::NEIGHBOUR);
  CHECK(result.parts[3].origin == Appearance_origin::TARGET);
  const Shape_appearance expected = painted(target, {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  CHECK(greatest_difference(expected, result.appearance, target) < 0.02);
  own.parts[3] = {};
  CHECK(transferred(own).parts[3].neighbour == 0);
  CHECK(transferred(own).parts[3].origin == Appearance_origin::NEIGHBOUR);
}

TEST_CASE("Transferred labels of faces have straight borders, and parts without counterpart have no labels")
{
  const Segmented_shape source = laths(), target = plate();
  const std::vector<Eigen::Vector3d> colours = {{1, 0, 0}, {0, 0, 1}};
  Transfer_options options;
  options.size = 128;
  const Transferred_appearance result = transfer_labels(graph_of(source), source, {0, 0, 1}, colours, graph_of(target),
                                                        target, {}, pairing({{0, 0}, {1, 0}, {2, 0}}), options);
  const Part_mesh& mesh = target.parts()[0].mesh;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const double x = (mesh.points(0, mesh.triangles(0, t)) + mesh.points(0, mesh.triangles(1, t)) +
                      mesh.points(0, mesh.triangles(2, t))) /
                     3;
    if (std::abs(x - 0.2) > 0.1) CHECK(result.parts[0].labels[std::size_t(t)] == (x < 0.2 ? 0 : 1));
  }
  CHECK(std::set<int>(result.parts[1].labels.begin(), result.parts[1].labels.end()) == std::set<int>{-1});
  CHECK_THROWS_AS(transfer_labels(graph_of(source), source, {0, 0, 2}, colours, graph_of(target), target, {}, {}),
                  Invalid_input);
}

TEST_CASE(
    "A part without counterpart keeps its own appearance; all counterparts of a part get the appearance of that part")
{
  const Segmented_shape source = plate(), target = laths(4);
  const Transferred_appearance result = transfer_appearance(
      graph_of(source), source, painted(source, {{1, 0, 0}, {0, 1, 0}}), graph_of(target), target,
      painted(target, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}), pairing({{0, 0}, {0, 1}, {0, 2}}));
  const Appearance_sampler sampler(result.appearance, Eigen::Vector3d::Zero());
  for (std::size_t part = 0; part < 4; ++part) {
    CHECK(result.parts[part].origin == (part < 3 ? Appearance_origin::SOURCE : Appearance_origin::TARGET));
    CHECK(sampler(part, 0, Eigen::Vector3d::Constant(1. / 3)).isApprox(Eigen::Vector3d::Unit(part < 3 ? 0 : 2), 0.02));
  }
}

TEST_CASE("Texture coordinates of the target are used only if no triangles overlap in them")
{
  const Segmented_shape shape = laths();
  const Structural_graph graph = graph_of(shape);
  const Shape_appearance looks = painted(shape, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Texture_layout apart = new_layout(shape, Eigen::Matrix3d::Identity(), 256, 4);
  Shape_appearance good, overlapping, outside;
  for (std::size_t part = 0; part < 3; ++part) {
    good.parts.emplace_back();
    for (const Flat_triangle& flat : apart[part])
      for (const Eigen::Vector2d& corner : flat)
        good.parts.back().coordinates.push_back((corner / 256).cast<float>());
  }
  overlapping = outside = good;
  overlapping.parts[1] = overlapping.parts[0];
  outside.parts[2].coordinates[5].x() = 1.5f;
  Transfer_options options;
  options.size = 256;
  const auto transferred = [&](const Shape_appearance& of_target) {
    return transfer_appearance(graph, shape, looks, graph, shape, of_target, identity(shape), options);
  };
  const Transferred_appearance given = transferred(good);
  CHECK(given.has_given_coordinates);
  for (std::size_t i = 0; i < good.parts[0].coordinates.size(); ++i)
    CHECK((given.appearance.parts[0].coordinates[i] - good.parts[0].coordinates[i]).norm() < 1e-6);
  CHECK(greatest_difference(looks, given.appearance, shape) < 0.02);
  CHECK_FALSE(transferred(overlapping).has_given_coordinates);
  CHECK_FALSE(transferred(outside).has_given_coordinates);
  options.new_coordinates = true;
  CHECK_FALSE(transferred(good).has_given_coordinates);
}

TEST_CASE("A source without appearance, and options out of their ranges, are refused")
{
  const Segmented_shape shape = laths();
  const Structural_graph graph = graph_of(shape);
  CHECK_THROWS_AS(transfer_appearance(graph, shape, {}, graph, shape, {}, identity(shape)), Invalid_input);
  Transfer_options options;
  options.size = 1 << 20;
  CHECK_THROWS_AS(transfer_appearance(graph, shape, rainbow(shape), graph, shape, {}, identity(shape), options),
                  Invalid_input);
}

namespace {

nlohmann::json document_of(const std::string& glb)
{
  std::size_t size = 0;
  for (int i = 3; i >= 0; --i)
    size = size << 8 | static_cast<unsigned char>(glb.at(12 + std::size_t(i)));
  return nlohmann::json::parse(glb.substr(20, size));
}

// The red channels of the materials of in-between surfaces, by name of the node.
std::map<std::string, std::set<double>> reds_in_between(const nlohmann::json& document)
{
  std::map<std::string, std::set<double>> result;
  for (const auto& node : document["nodes"]) {
    if (!node.contains("mesh") || node["name"].get<std::string>().find('~') == std::string::npos) continue;
    for (const auto& primitive : document["meshes"][node["mesh"].get<std::size_t>()]["primitives"])
      result[node["name"]].insert(
          document["materials"][primitive["material"].get<std::size_t>()]["pbrMetallicRoughness"]["baseColorFactor"][0]
              .get<double>());
  }
  return result;
}

} // namespace

TEST_CASE("In a blend colours are interpolated, and a texture stays on its surface")
{
  const Segmented_shape shape = table();
  const Structural_graph graph = graph_of(shape);
  const Correspondence correspondence = identity(shape);
  std::vector<Eigen::Vector3d> before(shape.parts().size(), {0.2, 0.4, 0.6}), after = before;
  before[0] = {1, 0, 0};
  after[0] = {0, 0, 1};
  IO::Blend_appearance looks{painted(shape, before), painted(shape, after)};
  // In the source, the second part has a texture
  looks.source.textures.push_back({"picture", gen::test_picture(), {}});
  looks.source.materials[1].texture = 0;
  looks.source.parts[1].coordinates.assign(3 * looks.source.parts[1].materials.size(), Eigen::Vector2f(0.5f, 0.5f));
  const Shape_blend blend(graph, shape, graph, shape, correspondence);
  std::ostringstream animation, frame;
  IO::write_blend_glb(animation, blend, looks, 6);
  const nlohmann::json document = document_of(animation.str());
  auto reds = reds_in_between(document);
  const std::string name = shape.parts()[0].name, other = shape.parts()[2].name;
  CHECK(reds[name + "~" + name].size() == 6); // one for each of five intervals, and one more where the surface changes
  CHECK(reds[other + "~" + other] == std::set<double>{0.2});
  REQUIRE(document["images"].size() == 1);
  bool is_textured_between = false;
  for (const auto& node : document["nodes"])
    if (node.contains("mesh") && node["name"].get<std::string>().find('~') != std::string::npos)
      for (const auto& primitive : document["meshes"][node["mesh"].get<std::size_t>()]["primitives"])
        is_textured_between = is_textured_between || primitive["attributes"].contains("TEXCOORD_0");
  CHECK(is_textured_between);

  IO::write_blend_frame_glb(frame, blend, looks, 0.5);
  reds = reds_in_between(document_of(frame.str()));
  REQUIRE(reds[name + "~" + name].size() == 1);
  CHECK(*reds[name + "~" + name].begin() == Approx(0.5).margin(0.3)); // the task of the part is half done

  // A part has one surface at any time, also when the target's replaces the source's
  Segmented_shape blunt("blunt");
  for (Shape_part part : shape.parts()) {
    part.mesh.points.row(2).array() += (part.mesh.points.row(0).array() > 0.75).cast<double>() * 0.1;
    blunt.add_part(part.name, part.mesh);
  }
  const Structural_graph blunt_graph = graph_of(blunt);
  const Shape_blend other_blend(graph, shape, blunt_graph, blunt, correspondence);
  const std::vector<Blend_surface> surfaces = other_blend.surfaces();
  const auto second = std::find_if(surfaces.begin(), surfaces.end(), [](const Blend_surface& surface) {
    return surface.side == 1 && surface.begin > 0 && surface.begin < 1;
  });
  REQUIRE(second != surfaces.end());
  std::ostringstream at_change;
  IO::write_blend_frame_glb(at_change, other_blend, {painted(shape, before), painted(blunt, after)}, second->begin);
  CHECK(document_of(at_change.str())["meshes"].size() == shape.parts().size());
}
