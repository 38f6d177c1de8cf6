// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts and upright axes of raw models in the program: --parts, lists of pieces, the command parts.
#include "model_files.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

TEST_CASE("Parts are made of a model that has none, and marked as automatic")
{
  const Temporary_folder folder;
  const std::string two = obj_box("o all", 0, 0, 0, 0, 1, 1, 1) + "v 0 3 0\nv 1 3 0\nv 0 4 0\nv 0 3 1\n" +
                          "f 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n" + "v 5 0 0\nv 6 0 0\nv 7 0 0\nf 13 14 15\n";
  const std::string model = quoted(folder.write("two.obj", two));
  CHECK(run("graph " + model + " --parts file").status == 1);
  const Run done = run("graph " + model + " --segment --abstraction boxes --json -");
  INFO(done.error);
  REQUIRE(done.status == 0);
  const json graph = json::parse(done.out);
  CHECK(graph["segmentation"] == "automatic");
  CHECK(graph["parts"].size() >= 2);
  for (const char* words : {" --segment --parts file", " --parts file --segment"}) // --segment wins over --parts
    CHECK(run("graph " + model + words + " --abstraction boxes --json -").out == done.out);
  CHECK_THAT(graph["warnings"][0].get<std::string>(), Contains("automatic segmentation"));
  CHECK_THAT(graph["warnings"].dump(), Contains("they have no area: 1."));
  const std::string table = quoted(folder.write("table.obj", obj_table()));
  CHECK(run("match " + table + " " + model + " --parts segments --abstraction boxes").status == 0);
  const Run whole = run("graph " + quoted(folder.write("cube.obj", obj_box("o cube", 0, 0, 0, 0, 1, 1, 1))));
  CHECK(whole.status == 1);
  CHECK_THAT(whole.error, Contains("one piece"));
}

namespace {

/// A table whose legs are one object.
std::string obj_table_of_materials()
{
  const std::string table = obj_table();
  std::string result;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("o leg_", 0) != 0 || line == "o leg_1") result += (line == "o leg_1" ? "o wood" : line) + '\n';
  return result;
}

std::string with_z_up(const std::string& obj)
{
  std::string result;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    double x = 0, y = 0, z = 0;
    if (line.rfind("v ", 0) == 0 && words >> word >> x >> y >> z)
      result += "v " + std::to_string(x) + ' ' + std::to_string(-z) + ' ' + std::to_string(y) + '\n';
    else
      result += line + '\n';
  }
  return result;
}

/// A shape of data/, whose parts are separate files, as one OBJ text.
std::string obj_of_shape(const std::string& name)
{
  std::string result;
  int before = 0;
  const fs::path folder = fs::path(SHAPE_CORRESPONDENCE_DATA_DIR) / name / "parts";
  std::vector<fs::path> files{fs::directory_iterator(folder), fs::directory_iterator()};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream in(file);
    int vertices = 0;
    for (std::string line; std::getline(in, line);) {
      if (line[0] == 'v' || line[0] == 'o') result += line + '\n';
      if (line.rfind("v ", 0) == 0) ++vertices;
      std::istringstream corners(line.substr(1));
      if (line.rfind("f ", 0) != 0) continue;
      result += 'f';
      for (int corner = 0; corners >> corner;)
        result += ' ' + std::to_string(before + corner);
      result += '\n';
    }
    before += vertices;
  }
  return result;
}

std::vector<std::string> part_names(const json& graph)
{
  std::vector<std::string> result;
  for (const json& part : graph["parts"])
    result.push_back(part["name"]);
  return result;
}

} // namespace

TEST_CASE("Objects of loose pieces are split, and the output says how to prevent that")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table_of_materials()));
  const std::string graph = "graph " + model + " --abstraction boxes --json - --cache " + quoted(folder.path("cache"));
  const json split = json::parse(run(graph).out);
  CHECK(part_names(split) == std::vector<std::string>{"top", "wood", "wood#2", "wood#3", "wood#4"});
  CHECK_THAT(split["warnings"][0].get<std::string>(), Contains("wood") && Contains("--parts file"));
  CHECK(part_names(json::parse(run(graph + " --parts file").out)) == std::vector<std::string>{"top", "wood"});
  CHECK(part_names(json::parse(run(graph + " --parts components").out)).size() == 5);
  CHECK(run(graph + " --parts all").status == 2);
  CHECK(json::parse(run(graph).out)["warnings"] == split["warnings"]); // kept in the cache

  const Run shown = run("parts " + model + " --html " + quoted(folder.path("parts.html")));
  CHECK(shown.status == 0);
  CHECK_THAT(shown.out, Contains("4 pieces, split into 4 parts") && Contains("wood#4"));
  CHECK_THAT(text_of(folder.path("parts.html")), Contains("id=\"parts.glb\">Z2xURgIAAA") && Contains("5 parts"));
  folder.write("models/a/table.obj", obj_table());
  folder.write("models/b/bad.obj", "v 0 0\n");
  const Run all = run("parts " + quoted(folder.path("models")) + " --all");
  CHECK(all.status == 1);
  CHECK_THAT(all.out, Contains("table.obj"));
  CHECK_THAT(all.error, Contains("bad.obj"));
  const std::string page = folder.path("bad.html"), bad = quoted(folder.path("models/b/bad.obj"));
  CHECK(run("parts " + bad + " --html " + quoted(page)).status == 1);
  CHECK_FALSE(fs::exists(page)); // there is nothing to show
  CHECK(run("parts " + model + " " + bad + " --html " + quoted(page)).status == 1);
  CHECK_THAT(text_of(page), Contains("bad.obj"));
  std::string dust;
  for (int i = 0; i <= 10000; ++i)
    dust += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + " .5 0\nv " + std::to_string(i) +
            " 0 .5\nf -1 -2 -3\n";
  const std::string pieces = folder.write("dust.obj", dust);
  CHECK_THAT(run("parts " + quoted(pieces)).error, Contains(pieces + ": it has 10001 loose pieces"));
}

TEST_CASE("A list of pieces and their parts, written, edited and read")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table_of_materials()));
  const std::string list = folder.path("parts.json"), graph = "graph " + model + " --abstraction boxes --json - ";
  const Run written = run(graph + "--parts-json " + quoted(list));
  REQUIRE(written.status == 0);
  const std::string of_parts = folder.path("of_parts.json");
  CHECK(run("parts " + model + " --quiet --parts-json " + quoted(of_parts)).status == 0);
  CHECK(text_of(of_parts) == text_of(list));
  CHECK(run("parts " + model + " " + model + " --quiet --parts-json " + quoted(of_parts)).status == 2);
  const Run again = run(graph + "--parts-from " + quoted(list));
  REQUIRE(again.status == 0);
  CHECK(part_names(json::parse(again.out)) == part_names(json::parse(written.out)));

  json document = json::parse(text_of(list));
  CHECK(document["pieces"][1] == json({{"piece", "wood#1"}, {"part", "wood"}}));
  document["pieces"][1]["part"] = document["pieces"][2]["part"] = "left";
  document["pieces"][3]["part"] = document["pieces"][4]["part"] = "right";
  folder.write("parts.json", document.dump());
  const std::string from = " --abstraction boxes --json - --source-parts-from " + quoted(list);
  const Run matched = run("match " + model + " " + model + from + " --target-parts-from " + quoted(list));
  REQUIRE(matched.status == 0);
  CHECK_THAT(matched.out, Contains("left") && !Contains("wood"));
  CHECK_THAT(run("match " + model + " " + model + from).out, Contains("left") && Contains("wood"));

  const auto refused = [&](const json& changed) {
    folder.write("parts.json", changed.dump());
    const Run run_of_it = run(graph + "--parts-from " + quoted(list));
    CHECK(run_of_it.status == 1);
    CHECK_THAT(run_of_it.error, Contains("parts.json"));
  };
  json twice = document, missing = document, unknown = document, other = document;
  twice["pieces"].push_back(document["pieces"][0]);
  missing["pieces"].erase(0);
  unknown["pieces"][0]["piece"] = "lid";
  other["format"] = "shape_correspondence/match";
  for (const json& changed : {twice, missing, unknown, other, json::array()})
    refused(changed);
}

TEST_CASE("A model with y up and one with z up are matched by one plain command")
{
  const Temporary_folder folder;
  const std::string y = quoted(folder.write("y.obj", obj_table()));
  const std::string z = quoted(folder.write("z.obj", with_z_up(obj_table())));
  const std::string match = "match " + y + ' ' + z + " --abstraction boxes --json - ";
  const auto pairs = [&](const std::string& options) { return json::parse(run(match + options).out)["pairs"]; };
  const json plain = json::parse(run(match).out);
  CHECK(plain["pairs"] == pairs("--source-up y --target-up z"));
  CHECK(plain["pairs"].size() == 5);
  CHECK(plain["energy"].get<double>() == Approx(0).margin(1e-9));
  CHECK_THAT(plain["warnings"][0].get<std::string>(),
             Contains("z.obj") && Contains("like labelled ones") && Contains("--target-up"));
  const json without_roles = json::parse(run(match + "--roles none").out);
  CHECK(without_roles["pairs"] == plain["pairs"]);
  CHECK_THAT(without_roles["warnings"][0].get<std::string>(),
             Contains("z.obj") && Contains("confidence") && Contains("--target-up"));
  CHECK(run(match + "--target-up up").status == 2);
  CHECK(pairs("--up y") != plain["pairs"]); // with y up, one of the two lies on its side
}

TEST_CASE("Where a model stands on several sides, the roles of its parts tell its upright axis")
{
  const Temporary_folder folder;
  const std::string chair = obj_of_shape("chair_four_legged");
  const std::string y = quoted(folder.write("y.obj", chair)), z = quoted(folder.write("z.obj", with_z_up(chair)));
  CHECK_THAT(run("parts " + z).out, Contains("z up")); // the axis that all commands use
  CHECK_THAT(run("parts " + z + " --up y").out, Contains("y up"));
  const std::string boxes = " --abstraction boxes --json - ";
  const auto warnings = [&](const std::string& command) { return json::parse(run(command).out)["warnings"].dump(); };
  CHECK_THAT(warnings("graph " + z + boxes), Contains("taken to be z") && Contains("--up"));
  CHECK_THAT(warnings("graph " + y + boxes), !Contains("taken to be"));
  CHECK_THAT(warnings("graph " + z + " --up y" + boxes), !Contains("taken to be"));

  const auto match = [&](const std::string& a, const std::string& b, const std::string& options) {
    return json::parse(run("match " + a + ' ' + b + boxes + options).out);
  };
  const json right = match(y, z, "--source-up y --target-up z"), found = match(y, z, ""), swapped = match(z, y, "");
  CHECK(found["pairs"] == right["pairs"]);
  CHECK(found["energy"].get<double>() == Approx(right["energy"].get<double>()));
  CHECK_THAT(found["warnings"].dump(), Contains("z.obj: The upright axis was taken to be z") &&
                                           Contains("--target-up") && !Contains("--source-up"));
  CHECK(swapped["pairs"].size() == found["pairs"].size());
  CHECK_THAT(swapped["warnings"].dump(), Contains("--source-up") && !Contains("--target-up"));
}

TEST_CASE("Pieces end where the material changes if the parts are then more like labelled ones")
{
  const Temporary_folder folder;
  // A table whose top and legs share vertices, one object of two materials; and a shelf
  const std::string table = obj_box("o table\nusemtl glass", 0, 0, 7, 0, 10, 1, 10) +
                            obj_box("usemtl wood", 1, 0, 0, 0, 1, 7, 1) + obj_box("usemtl wood", 2, 9, 0, 0, 1, 7, 1) +
                            obj_box("usemtl wood", 3, 0, 0, 9, 1, 7, 1) + obj_box("usemtl wood", 4, 9, 0, 9, 1, 7, 1) +
                            obj_box("o shelf\nusemtl wood", 5, 1, 2, 1, 8, 0.5, 8);
  const std::string model = quoted(folder.write("table.obj", table));
  const std::string list = quoted(folder.write("list.json", ""));
  const std::string graph = "graph " + model + " --abstraction boxes --json - ";
  const json found = json::parse(run(graph + "--parts-json " + list).out);
  CHECK(found["parts"].size() == 6);
  CHECK_THAT(found["warnings"].dump(), Contains("material changes") && Contains("--parts components or file"));
  CHECK(part_names(json::parse(run(graph + "--parts-from " + list).out)) == part_names(found));
  CHECK(json::parse(run(graph + "--parts file").out)["parts"].size() == 2);
  const std::string match = "match " + model + ' ' + model + " --abstraction boxes --json - ";
  CHECK(json::parse(run(match).out)["pairs"].size() == 6);
  CHECK(json::parse(run(match + "--roles none").out)["pairs"].size() == 2);
}
