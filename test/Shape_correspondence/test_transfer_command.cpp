// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program.h"

#include "generator/models.h"
#include "generator/textures.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace CGAL::Shape_correspondence;

namespace gen = CGAL::Shape_correspondence::generator;

TEST_CASE("The program transfers a texture; what it writes reads back")
{
  const model_files::Temporary_folder folder;
  for (const gen::Model& model : gen::models()) {
    const gen::Assembly shape = model.make();
    if (shape.name != "stool" && shape.name != "table_four_legged") continue;
    for (const auto& [path, content] : gen::textured_file(shape))
      folder.write(path, content);
  }
  const std::string source = quoted(folder.path("table_four_legged.obj")), target = quoted(folder.path("stool.obj"));
  const std::string common = source + " " + target + " --abstraction boxes --size 128 ";
  for (const std::string name : {"out.glb", "out.obj"}) {
    CAPTURE(name);
    const Run glb =
        run("transfer " + common + "-o " + quoted(folder.path(name)) + " --json " + quoted(folder.path("t.json")));
    CHECK(glb.error.empty());
    REQUIRE(glb.status == 0);
    Shape_appearance looks;
    const Segmented_shape shape = IO::read_shape_and_appearance(folder.path(name), looks);
    const auto json = nlohmann::json::parse(model_files::text_of(folder.path("t.json")));
    CHECK(json["format"] == "shape_correspondence/transfer");
    CHECK(json["parts"].size() == shape.parts().size());
    CHECK(json["texture_coordinates"] == "new"); // those of the model overlap
    REQUIRE(looks.textures.size() == 1);
    IO::decode_textures(looks, looks.warnings);
    CHECK(looks.warnings.empty());
    CHECK(looks.textures[0].image.width == 128);
  }
  CHECK(std::filesystem::exists(folder.path("out.mtl")));
  CHECK(run("match " + source + " " + target + " --abstraction boxes -o " + quoted(folder.path("m.glb"))).status == 0);
  const std::string match = model_files::text_of(folder.path("m.glb"));
  CHECK(match.find(R"("name":"materials")") != std::string::npos);
  CHECK(match.find(R"("mimeType":"image/png")") != std::string::npos);
  const Run labels = run("transfer " + common + "--labels parts -o " + quoted(folder.path("out.ply")));
  CHECK(labels.status == 0);
  const std::string ply = model_files::text_of(folder.path("out.ply"));
  CHECK(ply.find("property int label") != std::string::npos);
  Shape_appearance looks;
  IO::read_shape_and_appearance(folder.path("out.ply"), looks);
  CHECK_FALSE(looks.parts[0].colours.empty());
}

TEST_CASE("The program reads materials outside the model's folder only with --allow-outside-files")
{
  const model_files::Temporary_folder folder;
  for (const gen::Model& model : gen::models())
    if (model.make().name == "stool")
      for (const auto& [path, content] : gen::textured_file(model.make()))
        folder.write(path, content);
  std::string text = model_files::text_of(folder.path("stool.obj"));
  text.insert(text.find("mtllib ") + 7, "../");
  const std::string model = quoted(folder.write("inside/stool.obj", text));
  const std::string transfer =
      "transfer " + model + " " + model + " --abstraction boxes --size 128 -v -o " + quoted(folder.path("out.glb"));
  const Run inside = run(transfer), outside = run(transfer + " --allow-outside-files");
  CHECK(inside.status == 1);
  CHECK(inside.error.find("--allow-outside-files") != std::string::npos);
  CHECK(outside.status == 0);
}

TEST_CASE("The program says what is missing for a transfer")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const model_files::Temporary_folder folder;
  const std::string pair = quoted(data + "/stool") + " " + quoted(data + "/table_pedestal") + " --abstraction boxes ";
  const Run plain = run("transfer " + pair + "-o " + quoted(folder.path("a.glb")));
  CHECK(plain.status == 1);
  CHECK(plain.error.find("--labels parts") != std::string::npos);
  CHECK(run("transfer " + pair).status == 2);
  CHECK(run("transfer " + pair + "-o a.stl").status == 2);
  CHECK(run("transfer " + pair + "-o a.glb --size 5").status == 2);
  CHECK(run("transfer " + pair + "-o a.glb --match m.json --paper").status == 2);
  CHECK(folder.number_of_files() == 0);
}
