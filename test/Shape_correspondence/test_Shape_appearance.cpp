// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"

#include "generator/textures.h"
#include "texture/image_file.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <sys/stat.h>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace gen = CGAL::Shape_correspondence::generator;

namespace {

struct Model
{
  Segmented_shape shape;
  Shape_appearance looks;
};

Model read(const std::string& path)
{
  Model model;
  model.shape = IO::read_shape_and_appearance(path, model.looks);
  return model;
}

// Two tetrahedra; 'a' has a concave quadrilateral face, which is triangulated
const char* const two_parts = "mtllib some.mtl\n"
                              "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nv 1 1 2\n"
                              "vt 0 0\nvt 1 0\nvt 1 1\nvt .75 .25\nvt .25 .25\n"
                              "o a\nusemtl red\nf 1/1 2/2 3/3 4/4\nf 1/1 2/2 5/5\nf 2/2 3/3 5/5\n"
                              "o b\nusemtl picture\nf 3/3 4/4 5/5\nf 4 1 5\nf 1/9 1/1 5/5\nf 3/-5 1/x 5/5\n";

double largest_difference(const std::vector<Eigen::Vector2f>& a, const std::vector<Eigen::Vector2f>& b)
{
  REQUIRE(a.size() == b.size());
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    result = std::max(result, double((a[i] - b[i]).norm()));
  return result;
}

} // namespace

TEST_CASE("Materials and texture coordinates of OBJ belong to the triangles that are left")
{
  const Temporary_folder folder;
  folder.write("some.mtl",
               "newmtl red\nKd 1 0 0\nd .5\nnewmtl picture\nKd .1 .1 .1\nmap_Kd -clamp on -s 1 1 1 a picture.png\n");
  folder.write("a picture.png", gen::test_picture());
  const Model model = read(folder.write("model.obj", two_parts));
  CHECK(model.looks.warnings.empty());
  REQUIRE(model.looks.materials.size() == 2);
  CHECK(model.looks.materials[0].colour.isApprox(Eigen::Vector4d(1, 0, 0, .5)));
  CHECK(model.looks.materials[1].colour == Eigen::Vector4d::Ones());
  REQUIRE(model.looks.textures.size() == 1);
  CHECK(model.looks.textures[0].bytes == gen::test_picture());
  CHECK(model.looks.textures[0].wrap_u == Texture_wrap::CLAMP);
  REQUIRE(model.looks.parts.size() == 2);
  for (std::size_t part = 0; part < 2; ++part) {
    const Part_mesh& mesh = model.shape.parts()[part].mesh;
    const Part_appearance& looks = model.looks.parts[part];
    CHECK(looks.materials == std::vector<int>(std::size_t(mesh.triangles.cols()), int(part)));
    REQUIRE(looks.coordinates.size() == 3 * std::size_t(mesh.triangles.cols()));
  }
  // In 'a', texture coordinates are a quarter of x and y for any triangulation
  const Part_mesh& a = model.shape.parts()[0].mesh;
  CHECK(a.triangles.cols() == 4);
  for (Eigen::Index i = 0; i < a.triangles.size(); ++i) {
    const Point p = a.points.col(a.triangles.data()[i]);
    CHECK((model.looks.parts[0].coordinates[std::size_t(i)] - Eigen::Vector2f(float(p.x() / 4), float(1 - p.y() / 4)))
              .norm() < 1e-6);
  }
  // In 'b', one triangle has no texture coordinates, one has two equal corners, one has invalid numbers
  CHECK(model.shape.parts()[1].mesh.triangles.cols() == 3);
}

TEST_CASE("The geometry is the same whether the appearance is read or not")
{
  const Temporary_folder folder;
  const std::string path = folder.write("model.obj", two_parts);
  const Segmented_shape plain = IO::read_segmented_shape(path);
  const Model model = read(path);
  REQUIRE(model.looks.warnings.size() == 1); // the material library is missing
  CHECK(model.looks.warnings[0].find("some.mtl") != std::string::npos);
  CHECK(model.looks.empty());
  for (std::size_t part = 0; part < 2; ++part) {
    CHECK(plain.parts()[part].mesh.points == model.shape.parts()[part].mesh.points);
    CHECK(plain.parts()[part].mesh.triangles == model.shape.parts()[part].mesh.triangles);
  }
}

TEST_CASE("Damaged material libraries and textures are left out with warnings")
{
  const Temporary_folder folder;
  folder.write("some.mtl",
               "Kd 1 1 1\nnewmtl red\nKd red 1\nTr 1e999\nKd nan 7 -1\nnewmtl picture\nmap_Kd\nmap_Kd none.png\n");
  folder.write("none.png", "no image");
  const Model model = read(folder.write("model.obj", two_parts));
  REQUIRE(model.looks.warnings.size() == 2);
  CHECK(model.looks.warnings[0].find("some.mtl") != std::string::npos);
  CHECK(model.looks.warnings[1].find("none.png") != std::string::npos);
  for (const Surface_material& material : model.looks.materials) {
    CHECK(material.texture == -1);
    CHECK(material.colour.minCoeff() >= 0);
    CHECK(material.colour.maxCoeff() <= 1);
  }
}

TEST_CASE("Texture coordinates without bounds become 0")
{
  const Temporary_folder folder;
  const Model model = read(
      folder.write("m.obj", "usemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1e30 0\nvt nan nan\nvt .5 1\nf 1/1 2/2 3/3\n"));
  REQUIRE(model.looks.parts[0].coordinates.size() == 3);
  CHECK(model.looks.parts[0].coordinates[0].isZero());
  CHECK(model.looks.parts[0].coordinates[1].isZero());
  CHECK(model.looks.parts[0].coordinates[2].isApprox(Eigen::Vector2f(.5f, 0)));
}

TEST_CASE("Every truncation of an image is an error or an image, and none ends the program")
{
  const std::string png = gen::test_picture();
  IO::Image_budget budget;
  const Image image = IO::decoded_image(png, budget);
  CHECK(image.width == 128);
  CHECK(image.pixels[4 * (128 * 20 + 40)] == 60 + 25 * 2); // red channel of the third column
  CHECK(IO::decoded_image(IO::png_of(image), budget).pixels == image.pixels);
  for (std::size_t size = 0; size < png.size(); size += 97)
    CHECK_THROWS_AS(IO::decoded_image(png.substr(0, size), budget), Invalid_input);
  CHECK_THROWS_AS(IO::decoded_image("\xff\xd8\xff\xe0 no jpeg", budget), Invalid_input);
}

TEST_CASE("Images beyond the limits on a model's pixels and scans are left out with warnings")
{
  IO::Image_budget budget;
  budget.take(8192, 4096, 1);
  CHECK_THROWS_WITH(IO::Image_budget().take(8193, 1, 1), Contains("8193 x 1 pixels"));
  CHECK_THROWS_WITH(budget.take(8192, 8192, 1), Contains("more than are left"));
  CHECK_THROWS_WITH(IO::Image_budget().take(4096, 4096, 2000), Contains("2000 scans"));
  budget.take(8192, 4096, 1);
  CHECK_THROWS_AS(budget.take(1, 1, 1), Invalid_input);
  Shape_appearance looks;
  const std::string large = IO::png_of({4096, 4096, std::vector<std::uint8_t>(std::size_t(4) << 24)});
  for (int i = 0; i < 5; ++i) {
    looks.textures.push_back({"t" + std::to_string(i), large, {}});
    looks.materials.push_back({"m", Eigen::Vector4d::Ones(), i});
  }
  IO::decode_textures(looks, looks.warnings);
  REQUIRE(looks.warnings.size() == 1);
  CHECK_THAT(looks.warnings[0], Contains("'t4' was left out") && Contains("67108864"));
  CHECK(looks.materials[3].texture == 3);
  CHECK(looks.materials[4].texture == -1);
}

TEST_CASE("A model names files of its folder only, unless others are allowed")
{
  const Temporary_folder folder;
  folder.write("other/p.png", gen::test_picture());
  folder.write("other/some.mtl", "newmtl picture\nmap_Kd ../other/p.png\n");
  fs::create_directories(folder.path("model"));
  std::string text = two_parts;
  text.replace(text.find("some.mtl"), 8, "../other/some.mtl");
  const std::string file = folder.write("model/model.obj", text);
  const Model model = read(file);
  REQUIRE(model.looks.warnings.size() == 1);
  CHECK_THAT(model.looks.warnings[0], Contains("outside the model's folder") && Contains("allow_outside_files"));
  CHECK(model.looks.textures.empty());
  IO::Reading_options options;
  options.allow_outside_files = true;
  Shape_appearance looks;
  IO::read_shape_and_appearance(file, looks, Point::UnitY(), nullptr, options);
  CHECK(looks.warnings.empty());
  REQUIRE(looks.textures.size() == 1);
  CHECK(looks.textures[0].bytes == gen::test_picture());
  // A pipe is never read, wherever it is
  REQUIRE(mkfifo(folder.path("model/some.mtl").c_str(), 0600) == 0);
  text.replace(text.find("../other/"), 9, "");
  IO::read_shape_and_appearance(folder.write("model/model.obj", text), looks, Point::UnitY(), nullptr, options);
  REQUIRE(looks.warnings.size() == 1);
  CHECK_THAT(looks.warnings[0], Contains("is not there"));
}

TEST_CASE("Colours of vertices and faces are read from PLY and OFF")
{
  const Temporary_folder folder;
  const Model ply = read(folder.write(
      "m.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n"));
  REQUIRE(ply.looks.parts[0].colours.size() == 3);
  for (int k = 0; k < 3; ++k)
    CHECK(ply.looks.parts[0].colours[std::size_t(k)] == Eigen::Vector3f::Unit(k));
  const Model off =
      read(folder.write("m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2 255 0 0\n3 0 1 3 0.0 1.0 0.0\n"));
  REQUIRE(off.looks.parts[0].colours.size() == 6);
  CHECK(off.looks.parts[0].colours[2] == Eigen::Vector3f(1, 0, 0));
  CHECK(off.looks.parts[0].colours[3] == Eigen::Vector3f(0, 1, 0));
  const Model vertices =
      read(folder.write("c.off", "COFF\n3 1 0\n0 0 0 0 0 255 255\n1 0 0 0 0 255 255\n0 1 0 255 0 0 255\n3 0 1 2\n"));
  REQUIRE(vertices.looks.parts[0].colours.size() == 3);
  CHECK(vertices.looks.parts[0].colours[2] == Eigen::Vector3f(1, 0, 0));
}

TEST_CASE("A shape reads back from GLB with its materials, texture and coordinates")
{
  const Temporary_folder folder;
  folder.write("some.mtl", "newmtl red\nKd 1 0 0\nnewmtl picture\nmap_Kd p.png\n");
  folder.write("p.png", gen::test_picture());
  const Model model = read(folder.write("model.obj", two_parts));
  std::ostringstream glb;
  IO::write_segmented_shape_glb(glb, model.shape, model.looks);
  const Model again = read(folder.write("again.glb", glb.str()));
  REQUIRE(again.shape.parts().size() == 2);
  REQUIRE(again.looks.textures.size() == 1);
  CHECK(again.looks.textures[0].bytes == gen::test_picture());
  const auto material = [&](std::size_t part) {
    return again.looks.materials[std::size_t(again.looks.parts[part].materials[0])];
  };
  CHECK(material(0).colour.isApprox(Eigen::Vector4d(1, 0, 0, 1)));
  CHECK(material(0).texture == -1);
  CHECK(material(1).texture == 0);
  CHECK(largest_difference(again.looks.parts[1].coordinates, model.looks.parts[1].coordinates) < 1e-6);
}

TEST_CASE("Parts that are split off have the materials of their triangles, and what lies on a surface its coordinates")
{
  const Temporary_folder folder;
  std::string text = "mtllib m.mtl\nvt 0 0\nvt 1 0\nvt 0 1\n";
  for (int i = 0; i < 4; ++i) { // four distant tetrahedra in one object
    const std::string x = std::to_string(10 * i), x1 = std::to_string(10 * i + 1);
    text += "usemtl m" + std::to_string(i) + "\nv " + x + " 0 0\nv " + x1 + " 0 0\nv " + x + " 1 0\nv " + x + " 0 1\n" +
            "f -4/1 -2/2 -3/3\nf -4/1 -3/2 -1/3\nf -4/1 -1/2 -2/3\nf -3/1 -2/2 -1/3\n";
  }
  std::string library;
  for (int i = 0; i < 4; ++i)
    library += "newmtl m" + std::to_string(i) + "\nKd " + std::to_string(i / 4.) + " 0 0\n";
  folder.write("m.mtl", library);
  const Model model = read(folder.write("m.obj", text));
  REQUIRE(model.shape.parts().size() == 1);
  Part_splitting_options options;
  options.mode = Part_splitting::COMPONENTS;
  const Part_split split = split_parts(model.shape, options);
  REQUIRE(split.shape.parts().size() == 4);
  const Shape_appearance looks = appearance_of_parts(model.shape, model.looks, split);
  for (std::size_t part = 0; part < 4; ++part) {
    const int number = int(split.shape.parts()[part].mesh.points.row(0).minCoeff() / 10);
    CHECK(looks.parts[part].materials == std::vector<int>(4, number));
  }
  // The midpoint of an edge has the mean of the coordinates of its ends
  const Part_mesh& mesh = model.shape.parts()[0].mesh;
  const Eigen::Vector3i t = mesh.triangles.col(0);
  Part_mesh half{Points(3, 3), Eigen::Matrix3Xi(3, 1)};
  half.triangles.col(0) << 0, 1, 2;
  half.points << mesh.points.col(t[0]), (mesh.points.col(t[0]) + mesh.points.col(t[1])) / 2, mesh.points.col(t[2]);
  const Part_appearance on_it = appearance_on(mesh, model.looks.parts[0], half);
  const std::vector<Eigen::Vector2f>& given = model.looks.parts[0].coordinates;
  CHECK(largest_difference(on_it.coordinates, {given[0], (given[0] + given[1]) / 2, given[2]}) < 1e-6);
}
