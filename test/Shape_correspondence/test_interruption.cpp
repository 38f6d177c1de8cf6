// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What an interrupted program leaves behind, and pipes or devices in place of outputs, caches and stores.

#include "hand_made_graphs.h"
#include "model_files.h"
#include "program.h"

#include <catch2/catch.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

const std::string program = quoted(SHAPE_CORRESPONDENCE_PROGRAM);

int shell(const std::string& lines)
{
  const int status = std::system(("(" + lines + ") >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string file_in(const std::string& folder, const std::string& extension)
{
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) return entry.path().string();
  return "";
}

void replace_by_pipe(const std::string& file)
{
  REQUIRE(fs::remove(file));
  REQUIRE(mkfifo(file.c_str(), 0600) == 0);
}

struct Blend_files
{
  Temporary_folder folder;
  std::string inputs, output = folder.path("frames"), json = folder.path("blend.json");

  Blend_files()
  {
    const std::string table = folder.write("table.obj", obj_table());
    inputs = "blend " + quoted(table) + " " + quoted(table) + " --abstraction boxes --quiet -o " + quoted(output);
  }
};

} // namespace

TEST_CASE("The signals that end the program leave no temporary file")
{
  for (const char* signal : {"TERM", "HUP", "INT"}) {
    INFO(signal);
    const Blend_files blend;
    // A shell makes its background processes ignore INT
    const int status = shell("env --default-signal=INT " + program + " " + blend.inputs +
                             " --frames 10000 & while ! ls " + quoted(blend.output) +
                             ".tmp-*/*000* && kill -0 $!; do sleep 0.02; done; kill -" + signal + " $!; wait $!");
    CHECK(status == 128 + (signal == std::string("TERM") ? 15 : signal == std::string("HUP") ? 1 : 2));
    CHECK(blend.folder.number_of_files() == 1);
    CHECK(std::distance(fs::directory_iterator(blend.folder.path("")), {}) == 1);
  }
}

TEST_CASE("Signals that are ignored stay ignored")
{
  const Blend_files blend;
  CHECK(shell("trap '' HUP; " + program + " " + blend.inputs + " --frames 100 & sleep 0.2; kill -HUP $!; wait $!") ==
        0);
  CHECK(fs::exists(blend.output + "/frame_099.obj"));
}

TEST_CASE("The frames of a blend and its JSON are there together or not at all")
{
  const Blend_files blend;
  const Run failed = run(blend.inputs + " --frames 3 --json /dev/full");
  CHECK(failed.status == 1);
  CHECK_THAT(failed.error, Contains("/dev/full"));
  CHECK(!fs::exists(blend.output));
  CHECK(blend.folder.number_of_files() == 1);
  CHECK(run(blend.inputs + " --frames 3 --json " + quoted(blend.json)).status == 0);
  CHECK(blend.folder.number_of_files() == 5);
}

TEST_CASE("If a second output fails, the message says which one is whole")
{
  const Blend_files blend;
  const std::string glb = blend.folder.path("blend.glb");
  const std::string table = blend.folder.path("table.obj");
  const Run failed = run("blend " + quoted(table) + " " + quoted(table) + " --abstraction boxes -o " + quoted(glb) +
                         " --frames 3 --json /dev/full");
  CHECK(failed.status == 1);
  CHECK_THAT(failed.error, Contains("/dev/full") && Contains("is whole: " + glb));
  const std::string json = blend.folder.path("graph.json");
  const Run graph = run("graph " + quoted(table) + " --abstraction boxes --json " + quoted(json) + " --glb /dev/full");
  CHECK(graph.status == 1);
  CHECK_THAT(graph.error, Contains("is whole: " + json));
  CHECK(fs::exists(json));
}

TEST_CASE("A pipe in place of an entry of a cache or a store is not waited for; the entry is made anew")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", obj_table()), cache = folder.path("cache");
  const std::string graph = "graph " + quoted(table) + " --abstraction boxes --cache " + quoted(cache);
  REQUIRE(run(graph).status == 0);
  const std::string entry = file_in(cache, ".graph");
  replace_by_pipe(entry);
  CHECK(shell("timeout 60 " + program + " " + graph) == 0);
  CHECK(fs::is_regular_file(entry));

  const std::string store = folder.path("store"), collection = "collection " + quoted(table) + " " + quoted(table) +
                                                               " --abstraction boxes --store " + quoted(store);
  REQUIRE(run(collection).status == 0);
  std::vector<std::string> entries;
  for (const auto& file : fs::recursive_directory_iterator(store))
    if (file.is_regular_file()) entries.push_back(file.path().string());
  REQUIRE(entries.size() >= 2);
  for (const std::string& file : entries)
    replace_by_pipe(file);
  CHECK(shell("timeout 60 " + program + " " + collection) <= 1);
}

TEST_CASE("A folder that cannot be read is named")
{
  const Temporary_folder folder;
  folder.write("models/a.obj", obj_table());
  const std::string closed = fs::path(folder.write("models/closed/b.obj", obj_table())).parent_path().string();
  fs::permissions(folder.path(""), fs::perms(0755));
  fs::permissions(closed, fs::perms::none);
  const std::string user = getuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  if (shell(user + program + " --version") == 0) {
    const std::string errors = folder.path("errors");
    CHECK(std::system(
              (user + program + " parts --all " + quoted(folder.path("models")) + " >/dev/null 2>" + quoted(errors))
                  .c_str()) != 0);
    CHECK_THAT(text_of(errors), Contains(closed + ": it cannot be used") && Contains("; check the path"));
  }
  fs::permissions(closed, fs::perms::owner_all);
}
