// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_models.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <map>
#include <sstream>

// Shapes of blends in files: animations, frames, solids.

using namespace blend_models;

TEST_CASE("A shape in between is one closed surface for printing, of its size and place")
{
  const Shape_blend blend = blend_of("stool", "chair_four_legged");
  const Segmented_shape half = blend(0.5);
  const Part_mesh solid = blend.solid(0.5, 0.03);
  CHECK(is_closed(solid));
  Segmented_shape wrapped("solid");
  wrapped.add_part("solid", solid);
  CHECK(distance(wrapped, half) < 0.03);
  CHECK(distance(half, wrapped, [&](const Shape_part&, const Point& p) { return is_inside(p, solid); }) < 0.03);
  double volume = 0;
  for (Eigen::Index t = 0; t < solid.triangles.cols(); ++t) {
    const auto corner = [&](int i) -> Point { return solid.points.col(solid.triangles(i, t)); };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  CHECK(volume > 0); // oriented outwards
  CHECK_THROWS_AS(blend.solid(0.5, 0), Invalid_input);
  CHECK_THROWS_AS(blend.solid(0.5, 2), Invalid_input);
}

TEST_CASE("In glTF files y is up, whatever is up in the shapes")
{
  const auto lying = [](const std::string& name) {
    Model result{Segmented_shape(name, Point::UnitZ()), {}};
    for (const Shape_part& part : model(name).shape.parts()) {
      Part_mesh mesh = part.mesh;
      mesh.points.row(1) = -part.mesh.points.row(2);
      mesh.points.row(2) = part.mesh.points.row(1);
      result.shape.add_part(part.name, mesh);
    }
    Structure_options options;
    options.abstraction.abstractor = Bounding_box_abstraction();
    result.graph = build_structural_graph(result.shape, options);
    return result;
  };
  const Model stool = lying("stool"), chair = lying("chair_spindle");
  const Correspondence correspondence = find_correspondence(stool.graph, chair.graph);
  const Shape_blend blend = blend_of(stool, chair, correspondence);
  std::ostringstream glb;
  IO::write_blend_glb(glb, blend, correspondence, 4);
  const std::string bytes = glb.str();
  const auto length = static_cast<unsigned char>(bytes[12]) | static_cast<unsigned char>(bytes[13]) << 8 |
                      static_cast<unsigned char>(bytes[14]) << 16;
  const auto document = nlohmann::json::parse(bytes.substr(20, std::size_t(length)));
  Eigen::AlignedBox3d of_ends, drawn;
  for (const Segmented_shape& end : {blend(0), blend(1)})
    for (const Shape_part& part : end.parts())
      for (const auto& p : part.mesh.points.colwise())
        of_ends.extend(Point(p.x(), p.z(), -p.y()));
  for (const auto& mesh : document["meshes"]) {
    const auto& accessor = document["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    for (const char* corner : {"min", "max"})
      drawn.extend(Point(accessor[corner][0], accessor[corner][1], accessor[corner][2]));
  }
  const double tolerance = 0.05 * of_ends.diagonal().norm(); // parts in between may extend slightly beyond the ends
  CHECK((drawn.min() - of_ends.min()).norm() < tolerance);
  CHECK((drawn.max() - of_ends.max()).norm() < tolerance);
}

TEST_CASE("Frames as OBJ and PLY read back; the animation plays all surfaces one after the other")
{
  const Model &stool = model("stool"), &chair = model("chair_spindle");
  const Correspondence correspondence = find_correspondence(chair.graph, stool.graph);
  const Shape_blend blend = blend_of(chair, stool, correspondence);
  const model_files::Temporary_folder folder;
  std::ostringstream obj, ply, glb;
  const Segmented_shape half = blend(0.5);
  IO::write_segmented_shape_obj(obj, half);
  const Segmented_shape read = IO::read_segmented_shape(folder.write("half.obj", obj.str()));
  CHECK(read.parts().size() == half.parts().size());
  IO::write_segmented_shape_ply(ply, half);
  const Segmented_shape labelled = IO::read_segmented_shape(folder.write("half.ply", ply.str()));
  const auto triangles = [](const Segmented_shape& shape) {
    Eigen::Index result = 0;
    for (const Shape_part& part : shape.parts())
      result += part.mesh.triangles.cols();
    return result;
  };
  CHECK(labelled.parts().size() == half.parts().size()); // the faces name their parts
  CHECK(triangles(labelled) == triangles(half));

  IO::write_blend_glb(glb, blend, correspondence, 4);
  const std::string bytes = glb.str();
  const auto length = static_cast<unsigned char>(bytes[12]) | static_cast<unsigned char>(bytes[13]) << 8 |
                      static_cast<unsigned char>(bytes[14]) << 16;
  const auto document = nlohmann::json::parse(bytes.substr(20, std::size_t(length)));
  REQUIRE(document["animations"].size() == 1);
  std::map<std::string, int> channels;
  for (const auto& channel : document["animations"][0]["channels"])
    ++channels[channel["target"]["path"]];
  CHECK(channels["weights"] > 0);
  CHECK(channels["scale"] >= channels["weights"] + 2); // scales also show and hide the shapes of both ends

  // Rest points plus weighted morph targets equal the points of the blend in every frame
  const auto numbers = [&, binary = bytes.substr(28 + std::size_t(length))](std::size_t accessor) {
    const auto& [count, type] = std::pair(document["accessors"][accessor]["count"].get<std::size_t>(),
                                          document["accessors"][accessor]["type"].get<std::string>());
    std::vector<float> result(count * (type == "VEC3" ? 3 : 1));
    const auto& place = document["accessors"][accessor];
    const auto& view = document["bufferViews"][place["bufferView"].get<std::size_t>()];
    const std::size_t offset = view["byteOffset"].get<std::size_t>() + place.value("byteOffset", std::size_t(0));
    std::memcpy(result.data(), binary.data() + offset, result.size() * sizeof(float));
    return result;
  };
  const std::vector<Blend_surface> surfaces = blend.surfaces();
  std::size_t compared = 0;
  for (const auto& channel : document["animations"][0]["channels"]) {
    if (channel["target"]["path"] != "weights") continue;
    const auto& node = document["nodes"][channel["target"]["node"].get<std::size_t>()];
    const auto& mesh = document["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    const auto& sampler = document["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
    const std::vector<float> times = numbers(sampler["input"]), weights = numbers(sampler["output"]);
    const std::size_t targets = mesh["targets"].size();
    REQUIRE(weights.size() == times.size() * targets);
    for (std::size_t key = 0; key < times.size(); ++key) {
      std::vector<float> points = numbers(mesh["attributes"]["POSITION"]);
      for (std::size_t target = 0; target < targets; ++target) {
        const std::vector<float> difference = numbers(mesh["targets"][target]["POSITION"]);
        for (std::size_t i = 0; i < points.size(); ++i)
          points[i] += weights[key * targets + target] * difference[i];
      }
      const std::vector<Points> wanted = blend.points((double(times[key]) - 0.5) / 2); // still for .5 s, moving for 2 s
      double least = 1e9; // minimum over the surfaces of this name, one for each piece of a part
      for (std::size_t s = 0; s < surfaces.size(); ++s)
        if (surfaces[s].name == node["name"] && std::size_t(wanted[s].size()) == points.size())
          least = std::min(least,
                           (wanted[s] - Eigen::Map<Eigen::Matrix3Xf>(points.data(), 3, wanted[s].cols()).cast<double>())
                               .colwise()
                               .norm()
                               .maxCoeff());
      CHECK(least < 0.002 * 1.6); // 0.002 of the larger shape's diagonal, which is below 1.6
      ++compared;
    }
  }
  CHECK(compared > 0);
}
