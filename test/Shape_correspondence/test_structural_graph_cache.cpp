// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"
#include "part_meshes.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_cache.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <sstream>
#include <thread>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using part_meshes::box;

namespace {

Segmented_shape post_and_top(double height)
{
  Segmented_shape shape("table");
  shape.add_part("post", box({-0.1, 0, -0.1}, {0.1, height, 0.1}));
  shape.add_part("top", box({-0.5, height, -0.4}, {0.5, height + 0.1, 0.4}));
  return shape;
}

Structure_options quick()
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  return options;
}

Structural_graph graph_of(const Segmented_shape& shape, const Structure_options& options)
{
  Structural_graph graph = build_structural_graph(shape, options);
  structure(graph).content = IO::content_hash(shape, options);
  return graph;
}

std::string json_of(const Structural_graph& graph)
{
  std::ostringstream out;
  IO::write_structural_graph_json(out, graph);
  return out.str();
}

} // namespace

TEST_CASE("The content hash tells shapes and options apart")
{
  const Segmented_shape shape = post_and_top(1);
  const Structure_options options = quick();
  const std::string hash = IO::content_hash(shape, options);
  CHECK(IO::content_hash(post_and_top(1), quick()) == hash);
  std::set<std::string> others{hash};
  const auto is_new = [&](const std::string& other) { return others.insert(other).second; };
  CHECK(is_new(IO::content_hash(post_and_top(std::nextafter(1., 2.)), options)));
  Segmented_shape renamed("table");
  renamed.add_part("pillar", shape.parts()[0].mesh);
  renamed.add_part("top", shape.parts()[1].mesh);
  CHECK(is_new(IO::content_hash(renamed, options)));
  CHECK(is_new(IO::content_hash(shape, {})));
  Structure_options by_flow;
  by_flow.abstraction.abstractor = Mean_curvature_abstraction();
  CHECK(is_new(IO::content_hash(shape, by_flow)));
  Structure_options own;
  own.abstraction.abstractor = [](const Shape_part&, const Abstraction_options&) { return Part_abstraction(); };
  CHECK(is_new(IO::content_hash(shape, own)));
  const auto changed = [&](auto change) {
    Structure_options other = options;
    change(other);
    return IO::content_hash(shape, other);
  };
  CHECK(is_new(changed([](auto& o) { o.abstraction.edge_length = 0.03; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.triangles = 700; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.stop_volume = 0.03; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.maximum_iterations = 30; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.curve_points = 30; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.sheet_points = 30; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.kind = Abstraction_kind::CURVE; })));
  CHECK(is_new(changed([](auto& o) { o.abstraction.part_kinds["top"] = Abstraction_kind::CURVE; })));
  CHECK(is_new(changed([](auto& o) { o.symmetry.enabled = false; })));
  CHECK(is_new(changed([](auto& o) { o.contacts.tolerance = 0.03; })));
  CHECK(is_new(changed([](auto& o) { o.contacts.closest_points = true; })));
  // A time limit does not matter, since results that depend on it are not stored
  CHECK_FALSE(is_new(changed([](auto& o) { o.abstraction.time_limit = 30; })));
  CHECK_FALSE(is_new(changed([](auto& o) { o.abstraction.progress = [](std::size_t, std::size_t) {}; })));
}

TEST_CASE("A cache returns what was saved, and nothing else")
{
  const Temporary_folder folder;
  const IO::Structural_graph_cache cache(folder.path("deep/cache"));
  const Segmented_shape shape = post_and_top(1);
  const Structural_graph graph = graph_of(shape, quick());
  const std::string content = structure(graph).content;
  CHECK_FALSE(cache.find(content));
  cache.insert(graph);
  REQUIRE(cache.find(content));
  CHECK(json_of(*cache.find(content)) == json_of(graph));
  CHECK_FALSE(cache.find(IO::content_hash(post_and_top(2), quick())));

  const std::string file = "deep/cache/" + content + ".graph";
  const std::string entry = text_of(folder.path(file));
  SECTION("a damaged entry counts as missing, and is written again")
  {
    std::string damaged = entry;
    SECTION("one digit") { damaged[damaged.find("0.5")] = '1'; }
    SECTION("cut off") { damaged.resize(damaged.size() / 2); }
    SECTION("empty") { damaged.clear(); }
    SECTION("something else") { damaged = "{}"; }
    folder.write(file, damaged);
    CHECK_FALSE(cache.find(content));
    cache.insert(graph);
    CHECK(cache.find(content));
  }
  SECTION("the entry of another content counts as missing")
  {
    const std::string other = IO::content_hash(post_and_top(2), quick());
    folder.write("deep/cache/" + other + ".graph", entry);
    CHECK_FALSE(cache.find(other));
  }
}

TEST_CASE("Results that depend on the machine's speed are not saved")
{
  const Temporary_folder folder;
  const IO::Structural_graph_cache cache(folder.path("cache"));
  Structural_graph graph = graph_of(post_and_top(1), quick());
  structure(graph).parts[0].report.time_limit = true;
  cache.insert(graph);
  CHECK_FALSE(cache.find(structure(graph).content));
}

TEST_CASE("Many may write the same entry at once")
{
  const Temporary_folder folder;
  const IO::Structural_graph_cache cache(folder.path("cache"));
  const Structural_graph graph = graph_of(post_and_top(1), quick());
  std::vector<std::thread> writers;
  for (int i = 0; i < 4; ++i)
    writers.emplace_back([&] {
      for (int k = 0; k < 20; ++k)
        cache.insert(graph);
    });
  for (std::thread& writer : writers)
    writer.join();
  CHECK(cache.find(structure(graph).content));
  CHECK(folder.number_of_files() == 1);
}

TEST_CASE("A cache folder that cannot be one is refused")
{
  const Temporary_folder folder;
  const std::string file = folder.write("file", "text");
  CHECK_THROWS_WITH(IO::Structural_graph_cache(file), Catch::Matchers::Contains("cannot be used as a cache folder"));
}
