// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts and upright axes of raw models through the program: --parts, lists of pieces, the command parts.
#include "model_files.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

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

/// The same with z up, as programs turn it.
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

std::vector<std::string> part_names(const json& graph)
{
  std::vector<std::string> result;
  for (const json& part : graph["parts"])
    result.push_back(part["name"]);
  return result;
}

} // namespace

TEST_CASE("Objects of loose pieces are split, and what to type if they are not to be is said")
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
  CHECK(json::parse(run(graph).out)["warnings"] == split["warnings"]); // from the cache

  const Run shown = run("parts " + model + " --html " + quoted(folder.path("parts.html")));
  CHECK(shown.status == 0);
  CHECK_THAT(shown.out, Contains("4 pieces, split into 4 parts") && Contains("wood#4"));
  CHECK_THAT(text_of(folder.path("parts.html")), Contains("id=\"parts.glb\">Z2xURgIAAAA") && Contains("5 parts"));
  folder.write("models/a/table.obj", obj_table());
  folder.write("models/b/bad.obj", "v 0 0\n");
  const Run all = run("parts " + quoted(folder.path("models")) + " --all");
  CHECK(all.status == 1);
  CHECK_THAT(all.out, Contains("table.obj"));
  CHECK_THAT(all.error, Contains("bad.obj"));
}

TEST_CASE("A list of pieces and their parts, written, edited and read")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table_of_materials()));
  const std::string list = folder.path("parts.json"), graph = "graph " + model + " --abstraction boxes --json - ";
  const Run written = run(graph + "--parts-json " + quoted(list));
  REQUIRE(written.status == 0);
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
             Contains("z.obj") && Contains("confidence") && Contains("--target-up"));
  CHECK(run(match + "--target-up up").status == 2);
  CHECK(json::parse(run(match + "--up y").out)["energy"].get<double>() > 0.01);
}
