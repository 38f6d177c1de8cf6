// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

using namespace CGAL::Shape_correspondence;
using nlohmann::json;

namespace {

Correspondence back_splits()
{
  Correspondence c;
  c.pairs = {{0, 0}, {1, 1}, {1, 2}};
  c.groups = {{{0}, {0}, Operation::MATCH, 0.1}, {{1}, {1, 2}, Operation::SPLIT, 1.0 / 3}};
  c.contacts = {{{0, 1}, 0.25, 0.5}};
  c.unmatched_source = {2, 3, 4, 5};
  c.unmatched_target = {3};
  c.energy = 0.1 + 0.2; // differs from 0.3 in the last bit, which must be kept
  c.terms = {0.1, 0.2, 0.7};
  c.complete = true;
  c.search = {"beam", 7, 11, 0.05};
  c.warnings = {"A \"quoted\" warning."};
  return c;
}

json written(const Correspondence& c)
{
  std::ostringstream out;
  IO::write_correspondence_json(out, c, hand_made::chair(), hand_made::slatted_chair(), "a.obj", "b.obj",
                                {0.5, 1.5, 2.5, 3.5});
  return json::parse(out.str());
}

} // namespace

TEST_CASE("A number that is not finite is an error, and never written")
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::function<void(Correspondence&, double)> places[] = {
      [](Correspondence& c, double number) { c.energy = number; },
      [](Correspondence& c, double number) { c.terms.distortion = number; },
      [](Correspondence& c, double number) { c.groups[1].energy = number; },
      [](Correspondence& c, double number) { c.contacts[0].distortion = number; }};
  for (const auto& put : places)
    for (double number : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
      Correspondence c = back_splits();
      put(c, number);
      CHECK_THROWS_AS(written(c), Invalid_input);
    }
}

TEST_CASE("A correspondence is written as the format says")
{
  const json result = written(back_splits());
  CHECK(result["format"] == "shape_correspondence/match");
  CHECK(result["version"] == 1);
  CHECK(result["source"] == "a.obj");
  CHECK(result["target"] == "b.obj");
  CHECK(result["energy"].get<double>() == 0.1 + 0.2);
  CHECK(result["terms"] == json({{"distortion", 0.1}, {"connectedness", 0.2}, {"split", 0.7}}));
  CHECK(result["direction"] == "source_to_target");
  CHECK(result["complete"] == true);
  CHECK(result["optimal"] == false);
  CHECK(result["pairs"] == json::parse(R"([["seat", "seat"], ["back", "slat 1"], ["back", "slat 2"]])"));
  REQUIRE(result["groups"].size() == 2);
  CHECK(result["groups"][1]["source"] == json::array({"back"}));
  CHECK(result["groups"][1]["target"] == json::parse(R"(["slat 1", "slat 2"])"));
  CHECK(result["groups"][1]["operation"] == "split");
  CHECK(result["groups"][1]["energy"].get<double>() == 1.0 / 3);
  CHECK(result["contacts"][0]["parts"] == json::parse(R"(["seat", "back"])"));
  CHECK(result["unmatched_source"].size() == 4);
  CHECK(result["unmatched_target"] == json::array({"slat 3"}));
  CHECK(result["seconds"] == json({{"read", 0.5}, {"abstraction", 1.5}, {"structure", 2.5}, {"search", 3.5}}));
  CHECK(result["search"] == json({{"method", "beam"}, {"states", 7}, {"evaluations", 11}, {"lower_bound", 0.05}}));
  CHECK(result["warnings"] == json::array({"A \"quoted\" warning."}));
}

TEST_CASE("If the target is deformed, contacts are those of the target, and pairs still name the source first")
{
  Correspondence c = back_splits();
  c.direction = Direction::TARGET_TO_SOURCE;
  const json result = written(c);
  CHECK(result["direction"] == "target_to_source");
  CHECK(result["contacts"][0]["parts"] == json::parse(R"(["seat", "slat 1"])"));
  CHECK(result["pairs"][1] == json::parse(R"(["back", "slat 1"])"));
}

TEST_CASE("An empty correspondence has empty lists")
{
  const json result = written(Correspondence());
  for (const char* key : {"pairs", "groups", "unmatched_source", "unmatched_target", "warnings"}) {
    INFO(key);
    CHECK(result[key] == json::array());
  }
}

TEST_CASE("A correspondence that was written is read: its pairs by name, with confidences, and whether it is complete")
{
  const std::string file = "test_correspondence_json.json";
  const Structural_graph source = hand_made::chair(), target = hand_made::slatted_chair();
  for (const double confidence : {std::numeric_limits<double>::quiet_NaN(), 0.25}) {
    Correspondence c = back_splits();
    c.target_quarter_turns = 2;
    c.category = "chair";
    c.source_roles.assign(structure(source).parts.size(), "leg");
    c.target_roles.assign(structure(target).parts.size(), "rung");
    c.source_roles[0] = "seat";
    for (Part_correspondence& pair : c.pairs)
      pair.confidence = confidence;
    std::ofstream(file) << written(c);
    CHECK(written(c).contains("confidences") == c.pairs[0].has_confidence());
    const IO::Named_correspondence named = IO::read_correspondence_json(file);
    CHECK(named.source == "a.obj");
    CHECK(named.target == "b.obj");
    CHECK(named.complete);
    CHECK(named.target_quarter_turns == 2);
    REQUIRE(named.pairs.size() == 3);
    CHECK(named.pairs[2].source == "back");
    CHECK(named.pairs[2].target == "slat 2");
    const Correspondence read = IO::correspondence_of(named, source, target, file);
    CHECK(read.pairs == c.pairs);
    CHECK(read.unmatched_source == c.unmatched_source);
    CHECK(read.unmatched_target == std::vector<std::size_t>{3, 4, 5, 6, 7}); // all parts in no pair
    CHECK(read.complete);
    CHECK(read.target_quarter_turns == 2);
    CHECK(read.category == "chair");
    CHECK(read.source_roles == c.source_roles);
    CHECK(read.target_roles == c.target_roles);
    CHECK_THROWS_WITH(IO::correspondence_of(named, target, source, file), Catch::Contains("does not have"));
  }
  std::remove(file.c_str());
}

TEST_CASE("Correspondences with turns, confidences or pairs that make no sense are refused")
{
  const std::string file = "test_correspondence_json_refused.json";
  Correspondence c = back_splits();
  for (Part_correspondence& pair : c.pairs)
    pair.confidence = 0.5;
  const json good = written(c);
  const auto complaint = [&](const char* key, const json& value) {
    json changed = good;
    changed[key] = value;
    std::ofstream(file) << changed;
    try {
      IO::read_correspondence_json(file);
    } catch (const Invalid_input& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint("target_quarter_turns", 3).empty());
  for (int turns : {-1, 4, 99})
    CHECK_THAT(complaint("target_quarter_turns", turns),
               Catch::Matchers::StartsWith(file + ": target_quarter_turns is not 0, 1, 2 or 3"));
  CHECK(complaint("confidences", {0, 1, 0.5}).empty());
  CHECK_THAT(complaint("confidences", {0.5, 0.5, 1.1}),
             Catch::Matchers::StartsWith(file + ": confidences[2] is greater than 1"));
  CHECK_THAT(complaint("confidences", {0.5, -0.5, 0}),
             Catch::Matchers::StartsWith(file + ": confidences[1] is negative"));
  CHECK(!complaint("confidences", {0.5}).empty());
  CHECK(!complaint("pairs", {{"seat"}}).empty());
  std::remove(file.c_str());
}
