// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

// The command `evaluate`, and its input files.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

using Names = std::vector<std::pair<std::string, std::string>>;

std::string labels(const std::vector<std::array<std::string, 3>>& parts)
{
  json list = json::array();
  for (const auto& [name, coarse, fine] : parts)
    list.push_back({{"name", name}, {"coarse", coarse}, {"fine", fine.empty() ? json() : json(fine)}});
  return json{{"category", "chair"}, {"parts", list}}.dump();
}

std::string result(const std::string& source, const std::string& target, const Names& pairs, bool complete = true)
{
  json list = json::array();
  for (const auto& [s, t] : pairs)
    list.push_back({s, t});
  return json{{"format", "shape_correspondence/match"},
              {"version", 1},
              {"source", source},
              {"target", target},
              {"complete", complete},
              {"pairs", list}}
      .dump();
}

/// Two chairs with labels, and a result for them.
struct Labelled_chairs
{
  Temporary_folder folder;
  std::string results;

  Labelled_chairs()
  {
    folder.write("truth/chair/a/labels.json", labels({{"p", "leg", "front"}, {"q", "leg", "back"}, {"r", "seat", ""}}));
    folder.write("truth/chair/b/labels.json", labels({{"1", "leg", "front"}, {"2", "leg", "back"}, {"3", "seat", ""}}));
    results = folder.write("results/a--b.json",
                           result("shapes/chair/a/parts", "b.obj", {{"p", "1"}, {"q", "1"}, {"p", "3"}, {"r", "3"}}));
  }

  Run evaluate(const std::string& inputs, const std::string& options = "") const
  {
    return run("evaluate " + inputs + " --ground-truth " + quoted(folder.path("truth")) + " " + options);
  }

  std::string refused_result(const std::string& text) const
  {
    const std::string file = folder.write("bad.json", text);
    const Run bad = evaluate(quoted(file), "--json " + quoted(folder.path("out.json")));
    CHECK(bad.status == 1);
    CHECK(bad.out.empty());
    CHECK_FALSE(fs::exists(folder.path("out.json")));
    CHECK_THAT(bad.error, Contains(file));
    return bad.error;
  }
};

std::string refused_labels(const std::string& text)
{
  const Temporary_folder folder;
  const std::string file = folder.write("a/labels.json", text);
  const std::string message = complaint([&] { IO::read_part_labels(folder.path("a")); });
  CHECK_THAT(message, Contains(file));
  return message;
}

} // namespace

TEST_CASE("evaluate scores a result, and a folder of them, in a table and as JSON")
{
  const Labelled_chairs chairs;
  // Right: p-1, r-3; right coarse label: q-1; missed: q-2
  const Run table = chairs.evaluate(quoted(chairs.results));
  CHECK(table.status == 0);
  CHECK_THAT(table.out, Contains("chair") && Contains("0.500") && Contains("0.667") && Contains("0.571"));
  const Run as_json = chairs.evaluate(quoted(chairs.folder.path("results")), "--json -");
  REQUIRE(as_json.status == 0);
  const json document = json::parse(as_json.out);
  CHECK(document["format"] == "shape_correspondence/evaluation");
  CHECK(document["mean"]["f1"] == Approx(4. / 7));
  CHECK(document["categories"][0]["category"] == "chair");
  const json& only = document["results"][0];
  CHECK(only["source"] == "a");
  CHECK(only["target"] == "b");
  CHECK(only["right"] == json::parse(R"([["p", "1"], ["r", "3"]])"));
  CHECK(only["wrong"] == json::parse(R"([["q", "1"], ["p", "3"]])"));
  CHECK(only["missed"] == json::parse(R"([["q", "2"]])"));
}

TEST_CASE("An incomplete result counts as one without pairs")
{
  const Labelled_chairs chairs;
  const std::string file = chairs.folder.write("i.json", result("a", "b", {{"p", "1"}}, false));
  const Run run = chairs.evaluate(quoted(file), "--json -");
  CHECK(json::parse(run.out)["mean"]["f1"] == 0);
}

TEST_CASE("Errors about results say what is wrong with them")
{
  const Labelled_chairs chairs;
  CHECK_THAT(chairs.refused_result("{"), Contains("not a JSON document"));
  CHECK_THAT(chairs.refused_result("[]"), Contains("not an object"));
  CHECK_THAT(chairs.refused_result("{\"format\": \"other\"}"), Contains("format"));
  CHECK_THAT(chairs.refused_result(result("a", "zebra", {})), Contains("'zebra' has no labels"));
  CHECK_THAT(chairs.refused_result(result("a", "b", {{"p", "9"}})), Contains("part '9' is not in"));
  CHECK_THAT(chairs.refused_result("{\"format\": \"shape_correspondence/match\", \"version\": 1, \"source\": \"a\", "
                                   "\"target\": \"b\", \"complete\": true, \"pairs\": [[\"p\"]]}"),
             Contains("pairs[0]"));
  CHECK(chairs.evaluate(quoted(chairs.folder.path("nothing.json"))).status == 1);
  CHECK_THAT(chairs.evaluate(quoted(chairs.folder.path("truth"))).error, Contains("no result"));
}

TEST_CASE("Shapes of one name are told apart by their category, or not compared")
{
  const Labelled_chairs chairs;
  chairs.folder.write("truth/table/a/labels.json", "{\"parts\": [{\"name\": \"t\", \"coarse\": \"top\"}]}");
  CHECK(chairs.evaluate(quoted(chairs.results)).status == 0); // the result names shapes/chair/a
  CHECK_THAT(chairs.refused_result(result("a", "b", {})), Contains("several labelled shapes"));
  CHECK_THAT(chairs.refused_result(result("table/a", "chair/b", {})),
             Contains("category 'table'") && Contains("'chair'"));
}

TEST_CASE("Errors about labels say what is wrong with them")
{
  CHECK_THAT(refused_labels("nonsense"), Contains("not a JSON document"));
  CHECK_THAT(refused_labels("{}"), Contains("parts"));
  CHECK_THAT(refused_labels("{\"parts\": []}"), Contains("empty"));
  CHECK_THAT(refused_labels(labels({{"p", "leg", ""}, {"p", "leg", ""}})), Contains("parts[1].name"));
  CHECK_THAT(refused_labels(labels({{"p", "", ""}})), Contains("coarse"));
  CHECK_THAT(refused_labels("{\"parts\": [{\"name\": \"p\"}]}"), Contains("coarse"));
  const Temporary_folder empty;
  CHECK_THAT(complaint([&] { IO::read_part_labels(empty.path("")); }), Contains("labels.json"));
  CHECK_THAT(complaint([&] { IO::read_part_labels(empty.path("none")); }), Contains("none"));
}

TEST_CASE("The labels of the models that come with the package can be read")
{
  const std::vector<IO::Labelled_shape> shapes = IO::read_part_labels(SHAPE_CORRESPONDENCE_DATA_DIR);
  CHECK(shapes.size() == 14);
  CHECK(shapes[0].name == "airplane_propeller");
  CHECK(shapes[0].category == "airplane");
  CHECK(shapes[0].index("cowling") < shapes[0].parts.size());
  CHECK(shapes[0].index("none") == shapes[0].parts.size());
}

TEST_CASE("Wrong usage of evaluate ends with status 2")
{
  const Labelled_chairs chairs;
  CHECK(run("evaluate " + quoted(chairs.results)).status == 2);
  CHECK(run("evaluate --ground-truth " + quoted(chairs.folder.path("truth"))).status == 2);
  CHECK(chairs.evaluate(quoted(chairs.results), "--nonsense").status == 2);
}
