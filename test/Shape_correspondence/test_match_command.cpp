// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/matrix_files.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

TEST_CASE("match prints sets of parts with their operation and confidence, and the distance that collection computes")
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

TEST_CASE("graph and match write web pages")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  CHECK(run("graph " + a + " --quiet --html " + quoted(folder.path("g.html"))).status == 0);
  CHECK(run("match " + a + " " + a + " --quiet --html " + quoted(folder.path("m.html"))).status == 0);
  CHECK(text_of(folder.path("g.html")).find("<!DOCTYPE html>") == 0);
  CHECK(text_of(folder.path("m.html")).find("<!DOCTYPE html>") == 0);
}

TEST_CASE("match compares features of faces in files, and says what is wrong with them")
{
  const Temporary_folder folder;
  const std::string model =
      folder.write("two.obj", obj_box("o left", 0, 0, 0, 0, 1, 1, 1) + obj_box("o right", 1, 1.5, 0, 0, 1, 1, 1));
  // Of the twelve faces, the first `n` have one feature, the others another one
  const auto features = [&](const std::string& name, Eigen::Index rows, Eigen::Index n, Eigen::Index of_first) {
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(rows, 2);
    values.col(of_first).head(n).setOnes();
    values.col(1 - of_first).tail(rows - n).setOnes();
    std::ostringstream text;
    IO::write_npy(text, values);
    return " --target-features " + quoted(folder.write(name, text.str()));
  };
  const std::string pair = "match " + quoted(model) + " " + quoted(model) + " --json - --up y --roles none",
                    alike = features("alike.npy", 12, 6, 0), swapped = features("swapped.npy", 12, 6, 1),
                    of_source = " --source-features " + quoted(folder.path("alike.npy"));
  const json straight = json::parse(R"([["left","left"],["right","right"]])"),
             crossed = json::parse(R"([["left","right"],["right","left"]])");
  const auto result = [&](const std::string& options) { return json::parse(run(pair + options).out); };
  CHECK(result("")["pairs"] == straight);
  CHECK(result("").count("features") == 0);
  CHECK(result(of_source + alike)["pairs"] == straight);
  const json found = result(of_source + swapped + " --feature-weight 10");
  CHECK(found["pairs"] == crossed);
  CHECK(found["features"] == json{{"dimension", 2}, {"weight", 10}, {"calibrated", false}});
  CHECK_THAT(found["warnings"].dump(), Contains("Features of 2 dimensions"));
  CHECK(result(of_source + swapped + " --feature-weight 0")["pairs"] == straight);

  const auto refused = [&](const std::string& options, int status, const std::string& fault) {
    INFO(options);
    const Run faulty = run(pair + options);
    CHECK(faulty.status == status);
    CHECK(faulty.out.empty());
    CHECK_THAT(faulty.error, Contains(fault) && Contains("; "));
  };
  refused(of_source + " --target-features " + quoted(folder.path("none.npy")), 1, "none.npy");
  refused(of_source + " --target-features " + quoted(model), 1, "not an array of NumPy");
  refused(of_source + features("short.npy", 11, 6, 0), 1, "11 rows of features, but it has 12 faces and 16 vertices");
  refused(alike, 2, "--source-features");
  refused(of_source + alike + " --search exact", 2, "--source-features");
}
