// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// `match` through the program on models of data/: complete results, the file format, invariance, reproducibility.
#include "model_files.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const fs::path data = SHAPE_CORRESPONDENCE_DATA_DIR;

// A folder for each process, since several may run at once
fs::path scratch()
{
  static const model_files::Temporary_folder folder;
  return folder.path("");
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

json match(const fs::path& source, const fs::path& target, const std::string& options = "")
{
  const fs::path out = scratch() / "result.json";
  fs::remove(out);
  const std::string command = quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " match " + quoted(source) + " " + quoted(target) +
                              " --quiet --json " + quoted(out) + " " + options;
  REQUIRE(std::system(command.c_str()) == 0);
  return json::parse(std::ifstream(out));
}

using Names = std::set<std::pair<std::string, std::string>>;

Names pairs_of(const json& result)
{
  Names pairs;
  for (const json& pair : result["pairs"])
    pairs.emplace(pair[0], pair[1]);
  return pairs;
}

// Copies a model with its vertices moved and its parts renamed.
fs::path changed_copy(const std::string& model, const std::string& name,
                      const std::function<void(double&, double&, double&)>& move,
                      const std::function<std::string(const std::string&)>& rename)
{
  const fs::path folder = scratch() / name / "parts";
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(data / model / "parts")) {
    std::ifstream in(entry.path());
    std::ofstream out(folder / (rename(entry.path().stem().string()) + ".obj"));
    out.precision(17);
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("v ", 0) == 0) {
        std::istringstream numbers(line.substr(2));
        double x, y, z;
        numbers >> x >> y >> z;
        move(x, y, z);
        out << "v " << x << ' ' << y << ' ' << z << '\n';
      } else
        out << line << '\n';
    }
  }
  return folder;
}

std::string same(const std::string& name) { return name; }
void stay(double&, double&, double&) {}

void turn_by_30_degrees(double& x, double&, double& z)
{
  const double a = std::acos(-1.0) / 6, turned = std::cos(a) * x + std::sin(a) * z;
  z = -std::sin(a) * x + std::cos(a) * z;
  x = turned;
}

} // namespace

TEST_CASE("Matches of models of one category are complete, in the format, and account for every part")
{
  const std::vector<std::pair<std::string, std::string>> models = {{"chair_four_legged", "chair_swivel"},
                                                                   {"table_trestle", "table_pedestal"},
                                                                   {"bicycle", "tricycle"},
                                                                   {"airplane_propeller", "airplane_twin_engine"}};
  for (const auto& pair : models)
    for (const std::string method : {"parts", "beam"}) {
      INFO(pair.first << " and " << pair.second << ' ' << method);
      const json result = match(data / pair.first, data / pair.second,
                                "--search " + method + " --cache " + quoted(scratch() / "cache"));
      CHECK(result["search"]["method"] == method);
      CHECK(result["format"] == "shape_correspondence/match");
      CHECK(result["version"] == 1);
      CHECK(result["complete"] == true);
      CHECK(result["source"] == (data / pair.first).string());
      CHECK(result["energy"].get<double>() ==
            Approx(result["terms"]["distortion"].get<double>() + 0.6 * result["terms"]["connectedness"].get<double>() +
                   0.4 * result["terms"]["split"].get<double>()));
      for (const char* phase : {"read", "abstraction", "structure", "search"})
        CHECK(result["seconds"][phase] >= 0);
      CHECK(result["search"]["lower_bound"].get<double>() <= result["energy"].get<double>());

      for (int side : {0, 1}) {
        std::set<std::string> parts, seen;
        const fs::path model = data / (side == 0 ? pair.first : pair.second) / "parts";
        for (const auto& entry : fs::directory_iterator(model))
          parts.insert(entry.path().stem().string());
        for (const auto& names : pairs_of(result))
          seen.insert(side == 0 ? names.first : names.second);
        for (const json& name : result[side == 0 ? "unmatched_source" : "unmatched_target"])
          CHECK(seen.insert(name).second);
        CHECK(seen == parts);
      }
      // In the paper's method, all parts of the deformed shape are matched
      if (method == "parts") continue;
      const char* deformed = result["direction"] == "source_to_target" ? "unmatched_source" : "unmatched_target";
      CHECK(result[deformed].empty());
    }
}

TEST_CASE("A model matches itself at no cost, part by part")
{
  for (const char* model : {"chair_slatted", "bicycle", "table_pedestal"}) {
    INFO(model);
    const json result = match(data / model, data / model);
    CHECK(result["energy"] == 0);
    for (const auto& pair : pairs_of(result))
      CHECK(pair.first == pair.second);
    CHECK(result["unmatched_source"].empty());
  }
}

TEST_CASE("Copies in one place, also of less detail, match themselves at no cost, part by part")
{
  const model_files::Temporary_folder folder;
  using model_files::obj_box;
  std::string text;
  int parts = 0;
  const auto add = [&](const std::string& name, double x, double y, double z, double dx, double dy, double dz) {
    text += obj_box("o " + name, parts++, x, y, z, dx, dy, dz);
  };
  for (const char* copy : {"", "_collision", "_lod"}) {
    const double inset = copy == std::string("_lod") ? 0.002 : 0;
    add(std::string("left") + copy, inset, inset, 0, 0.05, 0.5, 0.6);
    add(std::string("right") + copy, 0.95 - inset, inset, 0, 0.05, 0.5, 0.6);
    add(std::string("rear") + copy, 0, inset, inset, 1, 0.5, 0.05);
  }
  add("floor", 0, 0, 0, 1, 0.05, 0.6);
  add("lid", 0, 0.5, 0, 1, 0.05, 0.6);
  const fs::path file = folder.write("box.obj", text);
  for (const char* roles : {"--up y", "--up y --roles none"}) {
    INFO(roles);
    const json result = match(file, file, roles);
    CHECK(result["energy"] == 0);
    CHECK(result["pairs"].size() == 11);
    for (const auto& pair : pairs_of(result))
      CHECK(pair.first == pair.second);
  }
}

TEST_CASE("Moving, scaling, turning by 30 degrees and shuffling parts changes no pair")
{
  const std::string source = "chair_slatted", target = "chair_swivel";
  const Names expected = pairs_of(match(data / source, data / target));

  const auto move = [](double& x, double& y, double& z) { x += 3.3, y -= 17.1, z += 0.7; };
  const auto scale = [](double& x, double& y, double& z) { x *= 39.37, y *= 39.37, z *= 39.37; };
  CHECK(pairs_of(match(data / source, changed_copy(target, "moved", move, same))) == expected);
  CHECK(pairs_of(match(data / source, changed_copy(target, "scaled", scale, same))) == expected);
  CHECK(pairs_of(match(data / source, changed_copy(target, "turned", turn_by_30_degrees, same))) == expected);
  CHECK(pairs_of(match(changed_copy(source, "turned_source", turn_by_30_degrees, same), data / target)) == expected);

  // Reversed names have another alphabetical order
  const auto reversed = [](const std::string& name) { return std::string(name.rbegin(), name.rend()); };
  Names restored;
  for (const auto& pair : pairs_of(match(data / source, changed_copy(target, "shuffled", stay, reversed))))
    restored.emplace(pair.first, reversed(pair.second));
  CHECK(restored == expected);
}

TEST_CASE("Two runs, and runs with one and two threads, give the same file but for the seconds")
{
  const auto without_seconds = [](json result) {
    result.erase("seconds");
    return result.dump();
  };
  const auto run = [&](const std::string& threads) {
    return without_seconds(match(data / "chair_swivel", data / "chair_spindle", "--threads " + threads));
  };
  const std::string first = run("1");
  CHECK(run("1") == first);
  CHECK(run("2") == first);
}

TEST_CASE("A saved graph matches as its model does")
{
  const fs::path graph = scratch() / "graph.json";
  const std::string command = quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " graph " + quoted(data / "chair_four_legged") +
                              " -o " + quoted(graph) + " --quiet";
  REQUIRE(std::system(command.c_str()) == 0);
  const json from_model = match(data / "chair_four_legged", data / "stool"), from_graph = match(graph, data / "stool");
  CHECK(from_graph["pairs"] == from_model["pairs"]);
  CHECK(from_graph["energy"] == from_model["energy"]);
}

TEST_CASE("The exact search costs no more than the beam, and proves it")
{
  const json beam = match(data / "bicycle", data / "tricycle", "--search beam");
  const json exact = match(data / "bicycle", data / "tricycle", "--search exact");
  CHECK(exact["energy"].get<double>() <= beam["energy"].get<double>() + 1e-9);
  CHECK(exact["optimal"] == true);
  CHECK(exact["search"]["lower_bound"] == exact["energy"]);
}

TEST_CASE("Every model of data/ corresponds to itself, part by part, at no cost, by every method")
{
  for (const auto& entry : fs::directory_iterator(data)) {
    if (!fs::exists(entry.path() / "labels.json")) continue; // not a model
    const fs::path graph = scratch() / (entry.path().filename().string() + ".json");
    REQUIRE(std::system((quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " graph " + quoted(entry.path()) + " --quiet -o " +
                         quoted(graph))
                            .c_str()) == 0);
    for (const char* method : {"parts", "beam", "exact"}) {
      INFO(entry.path() << ' ' << method);
      const json result = match(graph, graph, std::string("--search ") + method);
      CHECK(result["energy"] == 0);
      CHECK(result["unmatched_source"].empty());
      for (const json& pair : result["pairs"])
        CHECK(pair[0] == pair[1]);
    }
  }
}

TEST_CASE("The method follows from the options, where it is not named")
{
  const auto method = [](const std::string& options) {
    return match(data / "stool", data / "stool", options)["search"]["method"].get<std::string>();
  };
  CHECK(method("") == "parts");
  CHECK(method("--paper") == "beam");
  CHECK(method("--beam-width 5") == "beam");
  CHECK(method("--solutions 2") == "exact");
  CHECK(method("--allow-unmatched") == "exact");
  CHECK(method("--search-time-limit 10") == "exact");
  CHECK(method("--time-limit 10") == "parts");
}

TEST_CASE("Pinned pairs are in the result and forbidden ones are not, with and without roles")
{
  const auto partners = [](const json& result, const std::string& part) {
    std::set<std::string> names;
    for (const json& pair : result["pairs"])
      if (pair[0] == part) names.insert(pair[1]);
    return names;
  };
  for (const std::string roles : {"--roles auto", "--roles none", "--search exact"}) {
    const json result =
        match(data / "chair_four_legged", data / "chair_slatted",
              roles + " --pin back_panel=slat_1 --pin back_panel=slat_4 --forbid front_left_leg=leg_fl");
    CHECK(partners(result, "back_panel") == std::set<std::string>{"slat_1", "slat_4"});
    CHECK(partners(result, "front_left_leg").count("leg_fl") == 0);
    if (result.contains("confidences"))
      for (std::size_t i = 0; i < result["pairs"].size(); ++i)
        if (result["pairs"][i][0] == "back_panel") CHECK(result["confidences"][i] == 1);
  }
  const auto fails = [](const std::string& options) {
    const std::string command = quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " match " + quoted(data / "stool") + " " +
                                quoted(data / "stool") + " --quiet " + options + " 2> /dev/null";
    return std::system(command.c_str()) != 0;
  };
  CHECK(fails("--pin nobody=nobody"));
  CHECK(fails("--pin nobody"));
  CHECK(fails("--forbid nobody=nobody"));
}

TEST_CASE("Ranked solutions, min-marginals and chosen parts are in the result file")
{
  const json ranked = match(data / "chair_four_legged", data / "chair_slatted", "--solutions 3 --min-marginals");
  REQUIRE(ranked["solutions"].size() == 3);
  CHECK(ranked["solutions"][0]["pairs"] == ranked["pairs"]);
  CHECK(ranked["solutions"][0]["energy"].get<double>() <= ranked["solutions"][1]["energy"].get<double>());
  for (const json& group : ranked["groups"])
    CHECK(group.contains("min_marginal"));

  const json parts = match(data / "stool", data / "stool");
  CHECK(parts["confidences"].size() == parts["pairs"].size());
  const std::string name = parts["pairs"][0][0];
  const json chosen = match(data / "stool", data / "stool", "--source-parts " + name + " --target-parts " + name);
  CHECK(chosen["pairs"] == json::array({{name, name}}));
  const std::string none = quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " match " + quoted(data / "stool") + " " +
                           quoted(data / "stool") + " --quiet --source-parts nobody 2> /dev/null";
  CHECK(std::system(none.c_str()) != 0);
}
