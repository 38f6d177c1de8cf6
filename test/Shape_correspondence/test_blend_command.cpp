// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <array>

// The command blend, run as a program.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// A chair of six boxes as OBJ. \param far z of one corner of the seat, as text
std::string obj_chair(double width, double leg, double back, const std::string& far)
{
  const double far_leg = width - 0.1, seat = leg + 0.08;
  const std::vector<std::pair<std::string, std::array<double, 6>>> boxes{
      {"leg_0", {0, 0, 0, 0.1, leg, 0.1}},       {"leg_1", {far_leg, 0, 0, 0.1, leg, 0.1}},
      {"leg_2", {0, 0, far_leg, 0.1, leg, 0.1}}, {"leg_3", {far_leg, 0, far_leg, 0.1, leg, 0.1}},
      {"seat", {0, leg, 0, width, 0.08, width}}, {"back", {0, seat, 0, width, back, 0.08}}};
  const int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const int faces[6][4] = {{1, 4, 3, 2}, {5, 6, 7, 8}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}};
  std::ostringstream out;
  int first = 0;
  for (const auto& [name, box] : boxes) {
    out << "o " << name << '\n';
    for (int i = 0; i < 8; ++i) {
      out << "v " << box[0] + box[3] * around[i % 4][0] << ' ' << box[1] + box[4] * around[i % 4][1] << ' ';
      if (name == "seat" && i == 5)
        out << far << '\n';
      else
        out << box[2] + box[5] * (i / 4) << '\n';
    }
    for (const auto& face : faces) {
      out << 'f';
      for (int corner : face)
        out << ' ' << first + corner;
      out << '\n';
    }
    first += 8;
  }
  return out.str();
}

} // namespace

TEST_CASE("With a vertex so far away that rounding shrinks parts to points, blends have finite coordinates")
{
  const Temporary_folder folder;
  const std::string chair = folder.write("chair.obj", obj_chair(1.2, 0.45, 0.91, "1.2"));
  for (const std::string far : {"1e14", "1e12", "1e15"}) {
    INFO(far);
    const std::string damaged = folder.write("far.obj", obj_chair(1, 0.5, 0.7, far)), frames = folder.path(far);
    const Run blend = run("blend " + quoted(damaged) + " " + quoted(chair) + " -o " + quoted(frames) + " --frames 3");
    REQUIRE(blend.status == 0);
    for (const char* frame : {"frame_000.obj", "frame_001.obj", "frame_002.obj"})
      CHECK(text_of(frames + "/" + frame).find("nan") == std::string::npos);
  }
}

TEST_CASE("blend writes frames or an animation, and refuses what it cannot use")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const std::string models =
      "blend " + quoted(data + "/stool") + " " + quoted(data + "/stool") + " --abstraction boxes";
  CHECK(run(models).status == 2); // no output is given
  CHECK(run(models + " -o " + quoted(folder.path("f")) + " --frames 1").status == 2);
  CHECK(run(models + " -o " + quoted(folder.path("f")) + " --format stl").status == 2);
  const std::string graph = graph_file(folder, "graph.json", hand_made::chair());
  const Run refusal = run("blend " + quoted(graph) + " " + quoted(graph) + " -o " + quoted(folder.path("f")));
  CHECK(refusal.status == 1);
  CHECK_THAT(refusal.error, Contains("graph.json") && Contains("without surfaces"));
  CHECK(folder.number_of_files() == 1);

  const Run frames = run(models + " -o " + quoted(folder.path("f")) + " --frames 3 --json -");
  CHECK(frames.status == 0);
  CHECK(std::filesystem::exists(folder.path("f/frame_002.obj")));
  const json report = json::parse(frames.out);
  CHECK(report["format"] == "shape_correspondence/blend");
  CHECK(report["frames"].size() == 3);
  CHECK(report["schedules"].size() == 2);
  CHECK(run(models + " -o " + quoted(folder.path("f")) + " --frames 3").status == 1); // the output exists
  const Run animation = run(models + " -o " + quoted(folder.path("a.glb")) + " --frames 3 --verbose");
  CHECK(animation.status == 0);
  CHECK_THAT(animation.out, Contains("The first schedule is used"));
  CHECK(text_of(folder.path("a.glb")).substr(0, 4) == "glTF");
  CHECK(run("blend " + quoted(graph) + " " + quoted(graph) + " -o " + quoted(folder.path("frames.obj"))).status == 2);
  CHECK(run(models + " --quiet --frames 2 -o " + quoted(folder.path("b.html"))).status == 0);
  const std::string page = text_of(folder.path("b.html"));
  for (const char* id : {"match", "match.glb", "blend", "blend.glb"})
    CHECK(page.find(std::string("id=\"") + id + "\">") != std::string::npos);
  CHECK(run(models + " --quiet --frames 2 --html " + quoted(folder.path("c.html"))).status == 0);
  std::string page_by_option = text_of(folder.path("c.html"));
  REQUIRE(page_by_option.find("c.html") != std::string::npos); // the page contains its own name
  page_by_option.replace(page_by_option.find("c.html"), 1, "b");
  CHECK((page_by_option == page)); // in parentheses, so that a failure does not print both pages
  CHECK(run(models + " --html " + quoted(folder.path("d.html")) + " -o " + quoted(folder.path("d.glb"))).status == 2);
  const Run no_page = run(models + " --html " + quoted(folder.path("d.glb")));
  CHECK(no_page.status == 2);
  CHECK_THAT(no_page.error, Contains("d.glb") && Contains("must end in .html"));
}

TEST_CASE("Shapes of which one is more than twice as high as the other get the same height, unless --size is given")
{
  const Temporary_folder folder;
  const std::string small = quoted(folder.write("small.obj", obj_chair(0.5, 0.5, 0.5, "0"))),
                    large = quoted(folder.write("large.obj", obj_chair(9, 9, 9, "0")));
  const auto warnings = [&](const std::string& target, const std::string& arguments) {
    const Run result = run("blend " + small + " " + target + " --up y --abstraction boxes --at 1 --json - -o " +
                           quoted(folder.path("at_1.obj")) + arguments);
    INFO(result.error);
    REQUIRE(result.status == 0);
    return json::parse(result.out)["warnings"].dump();
  };
  CHECK_THAT(warnings(large, ""), Contains("times as high as the other; both get height 1"));
  double highest = 0;
  std::istringstream lines(text_of(folder.path("at_1.obj")));
  for (std::string word; lines >> word;) {
    double x, y;
    if (word == "v" && lines >> x >> y) highest = std::max(highest, y);
  }
  CHECK(highest == Approx(1).margin(0.01));
  CHECK_THAT(warnings(large, " --size blend"), !Contains("times as high"));
  CHECK_THAT(warnings(small, ""), !Contains("times as high"));
}

TEST_CASE("blend makes one in-between shape of a given size, by one schedule or by each of those that differ")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const std::string models = "blend " + quoted(data + "/chair_slatted") + " " + quoted(data + "/stool") +
                             " --abstraction boxes --quiet --cache " + quoted(folder.path("cache")) + " -o ";
  const auto out = [&](const std::string& name) { return models + quoted(folder.path(name)); };
  CHECK(run(out("a.obj") + " --at 0.5 --size same").status == 0);
  const std::string shape = text_of(folder.path("a.obj"));
  CHECK(shape.find('~') != std::string::npos);
  CHECK(run(out("a.ply") + " --at 0.5 --schedule in-two-steps").status == 0);
  CHECK(text_of(folder.path("a.ply")).substr(0, 3) == "ply");
  CHECK(run(out("all") + " --at 0.5 --schedule all").status == 0);
  int shapes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path("all")))
    shapes += file.path().extension() == ".obj";
  CHECK(shapes > 1);
  CHECK(run(out("solid.obj") + " --at 0.5 --solid").status == 0);
  const std::string solid = text_of(folder.path("solid.obj"));
  CHECK(solid.find("o solid") != std::string::npos);
  CHECK(solid.find('~') == std::string::npos);
  CHECK(run(out("solid.glb") + " --at 0.5 --solid").status == 2);
  CHECK(run(out("solid") + " --solid").status == 2);
  CHECK(run(out("b.obj") + " --at 1.5").status == 2);
  CHECK(run(out("b") + " --at 0.5").status == 2); // a single shape needs a file, not a folder
  CHECK(run(out("b.glb") + " --schedule all").status == 2);
  CHECK(run(out("b.glb") + " --schedule never").status == 2);
  CHECK(run(out("b.glb") + " --size huge").status == 2);
  // No pair has the confidence that is asked for, 1, so nothing morphs, which is reported
  const Run unsure = run(out("c.obj") + " --at 0.5 --min-confidence 1 --json -");
  CHECK(unsure.status == 0);
  const json report = json::parse(unsure.out);
  for (const json& task : report["tasks"])
    CHECK((task["task"] == "shrink" || task["task"] == "grow" || task["task"] == "exchange"));
  CHECK_THAT(report["warnings"].dump(), Contains("--min-confidence"));
  CHECK(report["frames"][0]["quality"]["apart"] == 0);
}

TEST_CASE("blend takes graphs whose parts name their meshes")
{
  const Temporary_folder folder;
  const std::string model = std::string(SHAPE_CORRESPONDENCE_DATA_DIR) + "/stool", graph = folder.path("stool.json");
  REQUIRE(run("graph " + quoted(model) + " -o " + quoted(graph) + " --abstraction boxes").status == 0);
  json document = json::parse(text_of(graph));
  std::filesystem::copy(model + "/parts", folder.path("meshes"));
  for (json& part : document["parts"])
    part["mesh"] = "meshes/" + part["name"].get<std::string>() + ".obj";
  folder.write("stool.json", document.dump());
  const auto blended = [&](const std::string& source, const std::string& out) {
    return run("blend " + quoted(source) + " " + quoted(model) + " --abstraction boxes --frames 2 -o " +
               quoted(folder.path(out)));
  };
  REQUIRE(blended(graph, "of_graph").status == 0);
  REQUIRE(blended(model, "of_model").status == 0);
  CHECK(text_of(folder.path("of_graph/frame_000.obj")) == text_of(folder.path("of_model/frame_000.obj")));

  document["parts"][0].erase("mesh");
  folder.write("stool.json", document.dump());
  const Run some = blended(graph, "of_some");
  CHECK(some.status == 1);
  CHECK_THAT(some.error, Contains("stool.json") && Contains("\"mesh\""));
  document["parts"][0]["mesh"] = "meshes/none.obj";
  folder.write("stool.json", document.dump());
  const Run missing = blended(graph, "of_none");
  CHECK(missing.status == 1);
  CHECK_THAT(missing.error, Contains("none.obj"));
}

TEST_CASE("blend takes a correspondence that was found before")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const std::string models =
      quoted(data + "/chair_spindle") + " " + quoted(data + "/chair_four_legged") + " --abstraction boxes";
  const std::string result = folder.path("match.json"), other = folder.path("other.json");
  REQUIRE(run("match " + models + " --json " + quoted(result)).status == 0);
  const auto tasks = [&](const std::string& out, const std::string& options) {
    const Run done = run("blend " + models + " -o " + quoted(folder.path(out)) + " --frames 2 --json - " + options);
    REQUIRE(done.status == 0);
    return json::parse(done.out)["tasks"];
  };
  CHECK(tasks("a", "--match " + quoted(result)) == tasks("b", ""));

  json seats = json::parse(text_of(result));
  seats["pairs"] = json::array({json::array({"saddle_seat", "seat"})});
  seats.erase("confidences");
  folder.write("other.json", seats.dump());
  const json of_seats = tasks("c", "--match " + quoted(other));
  CHECK(std::count_if(of_seats.begin(), of_seats.end(), [](const json& task) { return task["task"] == "morph"; }) == 1);

  // A pair that is more probably wrong than right is below the default of --min-confidence, 0.5
  seats["confidences"] = {.49};
  folder.write("other.json", seats.dump());
  const auto morphs = [&](const std::string& out, const std::string& least) {
    const json all = tasks(out, "--match " + quoted(other) + least);
    return std::count_if(all.begin(), all.end(), [](const json& task) { return task["task"] == "morph"; });
  };
  CHECK(morphs("e", "") == 0);
  CHECK(morphs("f", " --min-confidence .5") == 0);
  CHECK(morphs("g", " --min-confidence .4") == 1);
  seats["confidences"] = {.51};
  folder.write("other.json", seats.dump());
  CHECK(morphs("h", "") == 1);
  seats.erase("confidences");

  const std::string blend = "blend " + models + " -o " + quoted(folder.path("d"));
  CHECK(run(blend + " --match " + quoted(result) + " --search beam").status == 2);
  CHECK(run(blend + " --match " + quoted(folder.path("none.json"))).status == 1);
  seats["pairs"][0][1] = "no_such_part";
  folder.write("other.json", seats.dump());
  const Run refusal = run(blend + " --match " + quoted(other));
  CHECK(refusal.status == 1);
  CHECK_THAT(refusal.error, Contains("other.json") && Contains("no_such_part") && Contains("chair_four_legged"));
}
