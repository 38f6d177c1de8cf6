// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <set>

// The command graph, run as a program.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

TEST_CASE("graph reads what it writes, over an older output")
{
  const Temporary_folder folder;
  const std::string a = graph_file(folder, "a.json", hand_made::chair()), b = folder.write("b.json", "old");
  CHECK(run("graph " + quoted(a) + " -o " + quoted(b)).status == 0);
  CHECK(text_of(a) == text_of(b));
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("A cache folder saves the abstraction, and is used only for the same model and options")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", obj_table());
  const std::string command =
      "match " + quoted(table) + " " + quoted(table) + " --json - --cache " + quoted(folder.path("cache"));
  const auto result_of = [](const std::string& arguments) {
    const Run done = run(arguments);
    INFO(done.error);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
  };
  json first = result_of(command), second = result_of(command);
  CHECK(first["seconds"]["abstraction"] > 0);
  CHECK(second["seconds"]["abstraction"] == 0);
  const std::size_t answers = 4; // number of files that keep which parts and upright axes were found
  CHECK(folder.number_of_files() == 2 + answers);
  first.erase("seconds");
  second.erase("seconds");
  CHECK(first == second);
  CHECK(result_of(command + " --kind curve")["seconds"]["abstraction"] > 0);
  CHECK(folder.number_of_files() == 3 + answers);
  const Run without = run("graph " + quoted(table) + " --cache " + quoted(table));
  CHECK(without.status == 0);
  CHECK_THAT(without.error, Contains("note: ") && Contains("cache"));
}

TEST_CASE("What a cache keeps of reading models changes no result, also if it is damaged")
{
  const Temporary_folder folder;
  const std::string shelf = obj_box("o shelf", 5, -0.5, 0.2, -0.5, 1, 0.02, 1), kept = folder.path("cache/models"),
                    pair = quoted(folder.write("a.obj", obj_table())) + " " +
                           quoted(folder.write("b.obj", obj_table() + shelf)),
                    cache = " --cache " + quoted(folder.path("cache"));
  const auto found = [&](const std::string& options) {
    json result = json::parse(run("match " + pair + " --quiet --json -" + options).out);
    result.erase("seconds");
    return result;
  };
  const auto number_kept = [&] { return std::distance(fs::directory_iterator(kept), fs::directory_iterator()); };
  const json expected = found(""), without_roles = found(" --roles none");
  CHECK(found(cache) == expected);
  CHECK(number_kept() >= 5); // for each of two models: parts, axis by roles; for the pair: both axes
  const auto before = number_kept();
  CHECK(found(cache) == expected);
  CHECK(number_kept() == before);
  CHECK(found(" --roles none" + cache) == without_roles);
  for (const fs::directory_entry& entry : fs::directory_iterator(kept))
    fs::resize_file(entry.path(), entry.file_size() - 1);
  const Run damaged = run("match " + pair + " --json -" + cache);
  CHECK_THAT(damaged.error, Contains(kept) && Contains("it is damaged; it is made again"));
  json result = json::parse(damaged.out);
  result.erase("seconds");
  CHECK(result == expected);
  CHECK(run("match " + pair + " --json -" + cache).error.find("damaged") == std::string::npos);
}

TEST_CASE("Options set the kinds of symmetry, the contact tolerance and the upright axis")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table()));
  const auto graph_of = [&](const std::string& options) {
    const Run done = run("graph " + model + " --json - --abstraction boxes" + options);
    INFO(done.error);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
  };
  const auto sizes_of_groups = [](const json& graph) {
    std::multiset<std::size_t> result;
    for (const json& group : graph["groups"])
      result.insert(group["parts"].size());
    return result;
  };
  CHECK(sizes_of_groups(graph_of("")) == std::multiset<std::size_t>{1, 4});
  CHECK(sizes_of_groups(graph_of(" --symmetries reflection")) == std::multiset<std::size_t>{1, 4});
  CHECK(sizes_of_groups(graph_of(" --symmetries translation")) == std::multiset<std::size_t>{1, 2, 2});
  CHECK(sizes_of_groups(graph_of(" --no-symmetry")) == std::multiset<std::size_t>{1, 1, 1, 1, 1});
  CHECK(graph_of("")["contacts"].size() == 4);
  CHECK(graph_of(" --contact-tolerance 0.5")["contacts"].size() == 8);

  const json up = graph_of(" --up auto");
  CHECK(up["up"] == graph_of("")["up"]);
  CHECK_THAT(up["warnings"][0].get<std::string>(), Contains("upright axis was taken to be y"));
  CHECK(graph_of(" --up -y")["up"][1].get<double>() == Approx(-1));
  CHECK(graph_of(" --up=-z")["up"][2].get<double>() == Approx(-1));
  CHECK(graph_of(" --up +x")["up"][0].get<double>() == Approx(1));
  CHECK_THAT(run("parts " + model + " --up -x").out, Contains("5 parts; -x up"));
}

TEST_CASE("graph writes files for graph tools")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  const std::string graphml = folder.path("g.graphml"), dot = folder.path("g.dot");
  CHECK(run("graph " + a + " --quiet --graphml " + quoted(graphml) + " --dot " + quoted(dot)).status == 0);
  CHECK_THAT(text_of(graphml), Contains("<graphml"));
  CHECK_THAT(text_of(dot), Contains("graph"));
  CHECK(run("graph " + a + " --graphml " + quoted(folder.path("no/folder.graphml"))).status == 1);
}

TEST_CASE("Options make all parts or single parts curves or sheets")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table()));
  const std::string graph = "graph " + model + " --json - --abstraction boxes";
  const auto types = [&](const std::string& options) {
    std::map<std::string, std::string> result;
    const json document = json::parse(run(graph + options).out);
    for (const json& part : document["parts"])
      result[part["name"]] = part["type"];
    return result;
  };
  CHECK(types("")["leg_1"] == "curve");
  CHECK(types(" --kind sheet")["leg_1"] == "sheet");
  CHECK(types(" --kind sheet --part-kind leg_1=curve")["leg_1"] == "curve");
  CHECK(types(" --part-kind leg_1=sheet")["leg_2"] == "curve");
  for (const std::string& command : {"graph " + model, "label " + model, "match " + model + " " + model}) {
    const Run unknown = run(command + " --abstraction boxes --part-kind leg_9=curve");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.error, Contains("no part 'leg_9'; did you mean 'leg_"));
  }
}

TEST_CASE("--abstraction selects a way of abstraction by its name")
{
  const Temporary_folder folder;
  const std::string graph = "graph " + quoted(folder.write("table.obj", obj_table())) + " --json - --abstraction ";
  const auto method_of_top = [&](const std::string& abstraction) -> std::string {
    const json document = json::parse(run(graph + abstraction).out);
    for (const json& part : document["parts"])
      if (part["name"] == "top") return part["abstraction"]["method"];
    return "";
  };
  CHECK(method_of_top("flow") == "meso_skeleton");
  CHECK(method_of_top("fitted") == "prism");
  CHECK(method_of_top("boxes") == "bounding_box");
}

TEST_CASE("--paper builds graphs by the flow by default, and warns about graphs built otherwise")
{
  const Temporary_folder folder;
  const std::string table = quoted(folder.write("table.obj", obj_table())), flow = quoted(folder.path("flow.json")),
                    fitted = quoted(folder.path("fitted.json")), cache = " --cache " + quoted(folder.path("cache"));
  REQUIRE(run("graph " + table + cache + " --abstraction flow -o " + flow).status == 0);
  REQUIRE(run("graph " + table + cache + " -o " + fitted).status == 0);
  const auto seconds = [&](const std::string& options) {
    const json result = json::parse(run("match " + table + " " + table + cache + options + " --json -").out);
    return double(result["seconds"]["abstraction"]);
  };
  CHECK(seconds("") == 0);
  CHECK(seconds(" --paper") > 0); // the paper's contacts differ, so that the cached graph is not used
  CHECK(seconds(" --paper") == 0);
  const auto warnings = [&](const std::string& graph, const std::string& options) {
    return json::parse(run("match " + graph + " " + graph + options + " --json -").out)["warnings"].size();
  };
  CHECK(warnings(flow, " --paper") == 0);
  CHECK(warnings(fitted, "") == 0);
  CHECK(warnings(fitted, " --paper") == 2);
  CHECK(warnings(flow, "") == 2);
}

TEST_CASE("A model in one file has the same graph with any number of threads, and matches its graph")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", obj_table());
  const std::string graph = folder.path("table.json");
  const Run written = run("graph " + quoted(table) + " -o " + quoted(graph) + " --progress always --threads 2");
  INFO(written.error);
  REQUIRE(written.status == 0);
  CHECK_THAT(written.error, Contains("part 5 of 5"));
  CHECK_THAT(written.out, Contains("leg_1"));
  const Run single = run("graph " + quoted(table) + " --json - --threads 1");
  CHECK(single.out == text_of(graph));
  const Run self = run("match " + quoted(table) + " " + quoted(graph) + " --json -");
  REQUIRE(self.status == 0);
  CHECK(json::parse(self.out)["energy"].get<double>() == Approx(0).margin(1e-9));
  CHECK(json::parse(self.out)["pairs"].size() == 5);
}

TEST_CASE("A part that is open above and below has a graph whatever its thickness")
{
  const Temporary_folder folder;
  for (double thickness = 0.04; thickness < 0.1; thickness += 0.0025) {
    INFO(thickness);
    std::string top = obj_box("o top", 0, -0.5, 0, -0.5, 1, thickness, 1);
    for (const std::string face : {"f 1 2 6 5 \n", "f 3 7 8 4 \n"}) { // lower and upper face
      REQUIRE(top.find(face) != std::string::npos);
      top.erase(top.find(face), face.size());
    }
    const std::string table = top + obj_box("o leg", 1, -0.05, -0.5, -0.05, 0.1, 0.5, 0.1);
    const Run open = run("graph " + quoted(folder.write("open.obj", table)) + " --json -");
    CHECK(open.status == 0);
    CHECK(json::parse(open.out)["parts"].size() == 2);
  }
}
