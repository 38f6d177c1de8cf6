// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a cache knows of folders of part meshes before they are parsed.
#include "io/system/checked_file.h"
#include "model_files.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

/// Two folders of part meshes and a cache for them.
struct Pair_of_folders
{
  Pair_of_folders()
  {
    add_table("a", 1);
    add_table("b", 1.2);
  }

  void add_table(const std::string& name, double width) const
  {
    folder.write(name + "/parts/top.obj", obj_box("o top", 0, -width, 0.7, -0.5, 2 * width, 0.05, 1));
    folder.write(name + "/parts/leg_1.obj", obj_box("o leg", 0, -width, 0, -0.1, 0.1, 0.7, 0.2));
    folder.write(name + "/parts/leg_2.obj", obj_box("o leg", 0, width - 0.1, 0, -0.1, 0.1, 0.7, 0.2));
  }

  std::string command(const std::string& options = "") const
  {
    return "match " + quoted(folder.path("a")) + " " + quoted(folder.path("b")) + " --abstraction boxes --json - " +
           options;
  }

  std::string cache() const { return " --cache " + quoted(folder.path("cache")); }

  /// What a match prints but for its times, and whether it had to build a graph.
  static std::pair<std::string, bool> result(const std::string& arguments)
  {
    const Run done = run(arguments);
    INFO(done.error);
    REQUIRE(done.status == 0);
    nlohmann::json document = nlohmann::json::parse(done.out);
    const bool is_built = document["seconds"]["abstraction"] > 0;
    document.erase("seconds");
    return {document.dump() + done.error, is_built};
  }

  /// That a match with the cache is the same as without. \return whether it had to build a graph
  bool is_same_as_without_cache(const std::string& options = "") const
  {
    const auto [found, is_built] = result(command(options + cache()));
    CHECK(found == result(command(options)).first);
    return is_built;
  }

  std::vector<std::string> entries(const std::string& extension) const
  {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder.path("cache")))
      if (entry.path().extension() == extension) files.push_back(entry.path().string());
    return files;
  }

  Temporary_folder folder;
};

} // namespace

TEST_CASE("A cache knows folders of part meshes, and only those of the same names and bytes")
{
  const Pair_of_folders pair;
  CHECK(pair.is_same_as_without_cache());
  CHECK(pair.entries(".folder").size() == 2);
  CHECK_FALSE(pair.is_same_as_without_cache());
  const auto changes = [&](const std::string& what) {
    INFO(what);
    const bool is_built = pair.is_same_as_without_cache();
    CHECK_FALSE(pair.is_same_as_without_cache());
    return is_built;
  };
  const std::string leg = pair.folder.path("a/parts/leg_1.obj"), text = text_of(leg);
  std::string other = text;
  REQUIRE(other.find("v -1 0") != std::string::npos);
  other[other.find("v -1 0") + 3] = '2';
  pair.folder.write("a/parts/leg_1.obj", other);
  CHECK(changes("a byte of a part"));
  pair.folder.write("a/parts/leg_1.obj", text);
  CHECK_FALSE(changes("the part as it was"));
  fs::rename(leg, pair.folder.path("a/parts/leg_0.obj")); // the order of the files is the same
  CHECK(changes("the name of a part"));
  pair.folder.write("a/parts/post_2.obj", obj_box("o post", 0, 0, 0, -0.1, 0.1, 0.7, 0.2));
  CHECK(changes("one part more"));
  fs::remove(pair.folder.path("a/parts/top.obj"));
  CHECK(changes("one part less"));
  fs::rename(pair.folder.path("a"), pair.folder.path("c"));
  fs::rename(pair.folder.path("b"), pair.folder.path("a"));
  fs::rename(pair.folder.path("c"), pair.folder.path("b"));
  CHECK(changes("the names of the shapes"));
}

TEST_CASE("What a cache knows of folders depends on the options")
{
  const Pair_of_folders pair;
  pair.is_same_as_without_cache();
  for (const std::string options :
       {"--up z", "--source-up x", "--kind curve", "--no-symmetry", "--contact-tolerance 0.1", "--parts components"}) {
    INFO(options);
    CHECK(pair.is_same_as_without_cache(options) == (options != "--parts components"));
    CHECK_FALSE(pair.is_same_as_without_cache(options));
  }
  CHECK_FALSE(pair.is_same_as_without_cache("--parts file"));
  CHECK_FALSE(pair.is_same_as_without_cache("--target-up auto"));
}

TEST_CASE("A folder that is known is not parsed, unless its meshes are needed")
{
  const Pair_of_folders pair;
  pair.is_same_as_without_cache();
  // An entry that says that a is what b is: what it says is taken
  std::map<std::string, std::string> contents;
  for (const std::string& file : pair.entries(".folder")) {
    const std::string text = text_of(file);
    contents[file] = text.substr(text.find('\n') + 1);
  }
  REQUIRE(contents.size() == 2);
  const auto& [file, content] = *contents.begin();
  const std::string title = text_of(file).substr(0, std::string("shape_correspondence known folder ").size() + 36);
  REQUIRE(content != contents.rbegin()->second);
  IO::write_checked_file(file, title, contents.rbegin()->second + "A sentence of the reader.\n");
  const auto [changed, is_built] = Pair_of_folders::result(pair.command(pair.cache()));
  CHECK_FALSE(is_built);
  CHECK_THAT(changed, Contains("A sentence of the reader."));
  CHECK(changed != Pair_of_folders::result(pair.command()).first);
  const std::string picture = pair.folder.path("m.glb"), expected = pair.folder.path("expected.glb");
  CHECK_FALSE(pair.is_same_as_without_cache("--glb " + quoted(picture)));
  Pair_of_folders::result(pair.command("--glb " + quoted(expected)));
  CHECK(text_of(picture) == text_of(expected));
  for (const std::string& damaged : {std::string(), text_of(file).substr(0, 80), std::string("{}")}) {
    pair.folder.write(fs::relative(file, pair.folder.path("")).string(), damaged);
    CHECK_FALSE(pair.is_same_as_without_cache());
    CHECK(text_of(file).size() > 80); // it is made again
  }
  const std::string graph = pair.entries(".graph").front();
  std::string damaged = text_of(graph);
  damaged[damaged.size() / 2] ^= 1;
  pair.folder.write(fs::relative(graph, pair.folder.path("")).string(), damaged);
  CHECK_THAT(run(pair.command(pair.cache())).error, Contains("damaged"));
  CHECK_FALSE(pair.is_same_as_without_cache());
}

TEST_CASE("What was said of a folder when it was read is said again, and files that name others are read each time")
{
  const Pair_of_folders pair;
  pair.folder.write("a/parts/leg_1.obj", text_of(pair.folder.path("a/parts/leg_1.obj")) + "f 1 2\n");
  CHECK_THAT(Pair_of_folders::result(pair.command(pair.cache())).first, Contains("Faces of fewer than three corners"));
  CHECK_FALSE(pair.is_same_as_without_cache());
  CHECK(pair.entries(".folder").size() == 2);
  CHECK(run("match " + quoted(pair.folder.path("a")) + " " + quoted(pair.folder.path("b")) +
            " --abstraction boxes --glb " + quoted(pair.folder.path("scene.glb")))
            .status == 0);
  fs::rename(pair.folder.path("scene.glb"), pair.folder.path("b/parts/scene.glb"));
  CHECK(pair.is_same_as_without_cache());
  CHECK(pair.entries(".folder").size() == 2);
  CHECK_FALSE(pair.is_same_as_without_cache());
}
