// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

TEST_CASE("The table of match: sets of parts, their operation and confidence, one distance in all commands")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR, cache = " --cache " + quoted(folder.path("cache"));
  const std::string pair = quoted(data + "/chair_four_legged") + " " + quoted(data + "/chair_swivel") + cache;
  const Run table = run("match " + pair + " -v");
  INFO(table.out);
  REQUIRE(table.status == 0);
  CHECK_THAT(table.out, Contains("conf.") && Contains("merge 4:1") && Contains("duplicate 4:") && Contains(" %") &&
                            Contains("role ") && Contains("category: chair"));
  std::istringstream lines(run("match " + pair).out);
  for (std::string line; std::getline(lines, line);)
    CHECK(line.size() <= 80);
  CHECK_THAT(table.out, Contains("group in the source") && Contains("connectedness"));
  CHECK_THAT(table.error, Contains(" s, at most ") && Contains(" MB"));
  CHECK_THAT(run("match " + pair).out, !Contains("group in the source"));
  const std::string airplanes = quoted(data + "/airplane_twin_engine") + " " + quoted(data + "/airplane_propeller");
  CHECK_THAT(run("match " + airplanes + cache).out, Contains("category: airplane"));

  const std::string csv = folder.path("distances.csv");
  REQUIRE(run("collection " + pair + " -q --csv " + quoted(csv)).status == 0);
  std::istringstream rows(text_of(csv));
  std::string row;
  std::getline(rows, row);
  std::getline(rows, row); // the row of chair_four_legged
  std::ostringstream distance;
  distance.precision(4);
  distance << std::stod(row.substr(row.rfind(',') + 1));
  CHECK_THAT(table.out, Contains("distance: " + distance.str() + " "));
  CHECK_THAT(run("match " + pair + " --search beam").out, !Contains("conf.") && !Contains("proven"));
  CHECK_THAT(run("match " + airplanes + cache + " --search exact").out, Contains("proven minimal for this direction"));
}

TEST_CASE("match writes a table, a JSON and a picture")
{
  const Temporary_folder folder;
  const std::string a = graph_file(folder, "a.json", hand_made::chair());
  const std::string b = graph_file(folder, "b.json", hand_made::slatted_chair());
  const std::string inputs = "match " + quoted(a) + " " + quoted(b);
  const Run table = run(inputs);
  CHECK(table.status == 0);
  CHECK(table.error.empty());
  CHECK_THAT(table.out, Contains("slat 1") && Contains("unmatched") && Contains("energy"));

  const Run quiet =
      run(inputs + " --quiet --json " + quoted(folder.path("r.json")) + " --glb " + quoted(folder.path("r.glb")));
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.error.empty());
  CHECK(folder.number_of_files() == 4);
  const json result = json::parse(text_of(folder.path("r.json")));
  CHECK(result["source"] == a);
  CHECK(result["target"] == b);
  CHECK(result["complete"] == true);
  CHECK(text_of(folder.path("r.glb")).substr(0, 4) == "glTF");

  const Run piped = run(inputs + " --json -");
  CHECK(piped.status == 0);
  CHECK(json::parse(piped.out)["pairs"] == result["pairs"]);
}

TEST_CASE("Both commands write pages")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  CHECK(run("graph " + a + " --quiet --html " + quoted(folder.path("g.html"))).status == 0);
  CHECK(run("match " + a + " " + a + " --quiet --html " + quoted(folder.path("m.html"))).status == 0);
  CHECK(text_of(folder.path("g.html")).find("<!DOCTYPE html>") == 0);
  CHECK(text_of(folder.path("m.html")).find("<!DOCTYPE html>") == 0);
}
