// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"

#include "generator/textures.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>

#include <catch2/catch.hpp>

// Formats for which the package has no models: assimp writes them here, if it was built with its exporters.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace gen = CGAL::Shape_correspondence::generator;

TEST_CASE("Models in formats that assimp writes have their parts, materials and textures")
{
  const Temporary_folder folder;
  folder.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl picture\nmap_Kd p.png\n");
  folder.write("p.png", gen::test_picture());
  const std::string two_boxes = "mtllib m.mtl\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                "o seat\nusemtl red\nv 0 1 0\nv 4 1 0\nv 4 1 4\nv 2 3 2\nf 1/1 2/2 3/3\nf 1/1 2/2 "
                                "4/3\nf 2/1 3/2 4/3\nf 3/1 1/2 4/3\n"
                                "o leg\nusemtl picture\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 1 1 1\nf 5/1 6/2 7/3\nf 5/1 6/2 "
                                "8/3\nf 6/1 7/2 8/3\nf 7/1 5/2 8/3\n";
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(folder.write("m.obj", two_boxes), aiProcess_Triangulate);
  REQUIRE(scene);
  for (const auto& [format, file] :
       {std::pair("3ds", "m.3ds"), std::pair("fbxa", "m.fbx"), std::pair("collada", "m.dae"),
        std::pair("gltf2", "m.gltf"), std::pair("glb2", "m.glb")}) {
    CAPTURE(format);
    Assimp::Exporter exporter;
    if (exporter.Export(scene, format, folder.path(file)) != aiReturn_SUCCESS) {
      WARN("assimp does not write " << format);
      continue;
    }
    Shape_appearance looks;
    const Segmented_shape shape = IO::read_shape_and_appearance(folder.path(file), looks);
    REQUIRE(shape.parts().size() == 2);
    CHECK(looks.warnings.empty());
    for (std::size_t part = 0; part < 2; ++part) {
      const Part_mesh& mesh = shape.parts()[part].mesh;
      CHECK(mesh.triangles.cols() == 4);
      REQUIRE_FALSE(looks.parts[part].materials.empty());
      const Surface_material& material = looks.materials.at(std::size_t(looks.parts[part].materials[0]));
      const bool is_seat = mesh.points.row(1).maxCoeff() > 2; // by its height: some formats truncate names
      if (is_seat) CHECK(material.colour.head<3>().isApprox(Eigen::Vector3d(1, 0, 0), 1e-3));
      CHECK((material.texture >= 0) == !is_seat);
      if (!is_seat) CHECK(looks.textures.at(std::size_t(material.texture)).bytes == gen::test_picture());
    }
  }
}

TEST_CASE("The upright axis of an FBX file is the one that it says")
{
  const Temporary_folder folder;
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(folder.write("m.obj", obj_table()), aiProcess_Triangulate);
  REQUIRE(scene);
  Assimp::Exporter exporter;
  if (exporter.Export(scene, "fbxa", folder.path("m.fbx")) != aiReturn_SUCCESS) {
    WARN("assimp does not write FBX");
    return;
  }
  const std::string text = text_of(folder.path("m.fbx"));
  const auto up_of = [&](int axis, int sign) {
    std::string changed = text;
    const auto set = [&](const std::string& name, int value) {
      const std::string key = "P: \"" + name + "\", \"int\", \"Integer\", \"\", ";
      const std::size_t at = changed.find(key) + key.size();
      changed.replace(at, changed.find('\n', at) - at, std::to_string(value));
    };
    set("UpAxis", axis);
    set("UpAxisSign", sign);
    return IO::read_segmented_shape(folder.write("changed.fbx", changed)).up();
  };
  CHECK(up_of(1, 1) == Point::UnitY());
  CHECK(up_of(2, 1) == Point::UnitZ());
  CHECK(up_of(2, -1) == -Point::UnitZ());
  CHECK(up_of(0, 1) == Point::UnitX());
}
