// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Graphs and pairs in a cache or in the store of a collection, which are damaged or cannot be written.

#include "hand_made_graphs.h"
#include "io/system/atomic_file.h"
#include "program.h"

#include <array>
#include <map>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

/// The only regular file in a folder; sub-folders do not count.
std::string file_in(const std::string& folder)
{
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  REQUIRE(files.size() == 1);
  return files[0];
}

/// Modifies a digit in the second half of a file.
void damage(const std::string& file)
{
  std::string text = text_of(file);
  const std::size_t at = text.find_first_of("12345678", text.size() / 2);
  REQUIRE(at != std::string::npos);
  ++text[at];
  std::ofstream(file, std::ios::binary) << text;
}

std::string write_tables(const Temporary_folder& folder)
{
  for (int i = 0; i < 6; ++i) {
    const std::string name = "shapes/" + std::to_string(i) + ".obj";
    folder.write(name, obj_table() + obj_box("o extra", 5, -0.5, 0.1 + 0.1 * i, -0.5, 1, 0.02, 0.1));
  }
  return folder.path("shapes");
}

/// The graphs in a store: file names, which identify contents, and contents.
std::map<std::string, std::string> graphs_of(const std::string& store)
{
  std::map<std::string, std::string> result;
  for (const std::string sub : {"graphs", "cache"}) {
    if (!fs::exists(store + "/" + sub)) continue;
    for (const auto& entry : fs::directory_iterator(store + "/" + sub))
      if (entry.is_regular_file()) result[entry.path().filename().string()] = text_of(entry.path().string());
  }
  return result;
}

/// Puts damaged graphs with valid digests in place of a cache entry, and checks that the graph is rebuilt.
void check_damaged_entry(const std::string& entry, const std::string& command)
{
  const std::string expected = run(command).out, kept = text_of(entry), content = fs::path(entry).stem().string();
  REQUIRE(!expected.empty());
  for (const auto& [key, from, to] : std::vector<std::array<std::string, 3>>{
           {"\"contacts\"", "\"leg_1\"", "\"top\""},                     // contact of a part with itself
           {"\"contacts\"", "\"leg_1\"", "\"none\""},                    // contact of a missing part
           {"\"contacts\"", "\"parameters\":[[0", "\"parameters\":[[7"}, // a parameter outside of the part
           {"\"groups\"", "\"leg_1\"", "\"leg_2\""},                     // a part in two groups
           {"\"content\"", content, "0"}}) {
    INFO(key << ": " << to);
    std::string text = kept.substr(kept.find('\n') + 1);
    const std::size_t at = text.find(from, text.find(key));
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
    IO::write_checked_file(entry, "shape_correspondence cache entry " + content, text);
    const Run again = run(command);
    CHECK(again.out == expected);
    CHECK_THAT(again.error, Contains("note: ") && Contains("damaged"));
    CHECK(text_of(entry) == kept);
  }
}

} // namespace

TEST_CASE("A damaged graph of the cache is made again, with a warning")
{
  const Temporary_folder folder;
  const std::string command =
      "graph " + quoted(folder.write("table.obj", obj_table())) + " --json - --cache " + quoted(folder.path("cache"));
  const std::string expected = run(command).out;
  const std::string entry = file_in(folder.path("cache")), kept = text_of(entry);
  damage(entry);
  const Run again = run(command);
  CHECK(again.status == 0);
  CHECK(again.out == expected);
  CHECK_THAT(again.error, Contains("note: ") && Contains("damaged"));
  CHECK(text_of(entry) == kept);
  CHECK(run(command).error.empty());
}

TEST_CASE("A cache that cannot be written is a warning")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table()));
  const std::string expected = run("graph " + model).out;
  fs::create_directories(folder.path("cache"));
  // A limit on the size of files acts like a disk that is full after some kilobytes
  const std::string command = "trap '' XFSZ; ulimit -f 8; " + quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " graph " + model +
                              " --cache " + quoted(folder.path("cache")) + " >" + quoted(folder.path("out")) + " 2>" +
                              quoted(folder.path("error"));
  const int status = std::system(command.c_str());
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  CHECK(text_of(folder.path("out")) == expected);
  CHECK_THAT(text_of(folder.path("error")), Contains("note: ") && Contains("not kept"));
  for (const auto& entry : fs::recursive_directory_iterator(folder.path("cache"))) {
    CHECK(entry.path().extension() != ".graph");
    CHECK(entry.path().filename().string().find(".tmp") == std::string::npos);
  }
}

TEST_CASE("A damaged graph or row of a store is made again, with a warning")
{
  const Temporary_folder folder;
  folder.write("shapes/a.json", graph_text(hand_made::chair(), "a"));
  folder.write("shapes/b.json", graph_text(hand_made::slatted_chair(), "b"));
  const std::string command =
      "collection " + quoted(folder.path("shapes")) + " --json - --store " + quoted(folder.path("store"));
  const std::string expected = run(command).out;
  REQUIRE(!expected.empty());
  damage((fs::directory_iterator(folder.path("store/graphs"))->path()).string());
  const Run with_graph = run(command);
  CHECK(with_graph.out == expected);
  CHECK_THAT(with_graph.error, Contains("note: ") && Contains("damaged"));
  const std::string row = file_in(folder.path("store/pairs"));
  std::string bytes = text_of(row);
  bytes.back() ^= 1;
  std::ofstream(row, std::ios::binary) << bytes;
  const Run with_row = run(command);
  CHECK(with_row.out == expected);
  CHECK_THAT(with_row.error, Contains("note: ") && Contains("damaged"));
  CHECK(run(command).error.empty());
}

TEST_CASE("A shape of a collection that fails does not harm the graphs of others, on however many threads")
{
  constexpr int runs = 8; // number of runs for each failure and number of threads
  const Temporary_folder folder;
  const std::string shapes = write_tables(folder), store = folder.path("store"), whole = folder.path("whole"),
                    error = folder.path("error"), program = quoted(SHAPE_CORRESPONDENCE_PROGRAM);
  const std::string expected = run("collection " + shapes + " --json - --threads 1 --store " + quoted(whole)).out;
  const std::map<std::string, std::string> right = graphs_of(whole);
  const fs::path blocked = fs::directory_iterator(whole + "/graphs")->path().filename();
  std::uintmax_t longest = 0;
  for (const auto& [name, text] : right)
    longest = std::max<std::uintmax_t>(longest, text.size());
  REQUIRE(right.size() == 12);
  const auto try_often = [&](const std::string& before, const std::string& message, const auto& prepare) {
    for (const std::string threads : {"1", "2", "8"}) {
      for (int i = 0; i < runs; ++i) {
        INFO(message << ", " << threads << " threads");
        fs::remove_all(store);
        prepare();
        const std::string command = before + program + " collection " + quoted(shapes) + " -q --json - --store " +
                                    quoted(store) + " --threads " + threads;
        const int status = std::system((command + " >/dev/null 2>" + quoted(error)).c_str());
        REQUIRE(WIFEXITED(status));
        REQUIRE(WEXITSTATUS(status) == 1);
        REQUIRE_THAT(text_of(error), Contains(message));
        for (const auto& [name, text] : graphs_of(store)) {
          INFO(name);
          REQUIRE(right.count(name) == 1);
          REQUIRE(right.at(name) == text);
        }
      }
    }
  };
  const auto check_the_rest = [&] {
    fs::remove_all(store + "/graphs");
    CHECK(run("collection " + shapes + " --json - --store " + quoted(store)).out == expected);
  };
  SECTION("one graph cannot be written")
  {
    try_often("", blocked.string(), [&] { fs::create_directories(fs::path(store) / "graphs" / blocked); });
    check_the_rest();
  }
  SECTION("the disk is full")
  {
    const std::string limit = "trap '' XFSZ; ulimit -f " + std::to_string(longest / 1024) + "; ";
    try_often(limit, "cannot be written", [] {});
    check_the_rest();
  }
  SECTION("one input is bad")
  {
    const std::string good = text_of(shapes + "/3.obj");
    folder.write("shapes/3.obj", good + "f 1 2 900\n");
    try_often("", "3.obj", [] {});
    folder.write("shapes/3.obj", good);
    check_the_rest();
  }
}

TEST_CASE("Damaged graphs of a cache whose digests are valid are made again, with a warning")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table())), cache = quoted(folder.path("cache"));
  const std::string command = "graph " + model + " --json - --cache " + cache;
  REQUIRE(run(command).status == 0);
  check_damaged_entry(file_in(folder.path("cache")), command);
}

TEST_CASE("Damaged graphs of a collection's store, and those with a wrong digest, are made again")
{
  const Temporary_folder folder;
  folder.write("shapes/a.obj", obj_table());
  folder.write("shapes/b.obj", obj_table() + obj_box("o extra", 5, -0.5, 0.1, -0.5, 1, 0.02, 0.1));
  const std::string store = folder.path("store");
  const std::string command = "collection " + quoted(folder.path("shapes")) + " --json - --store " + quoted(store);
  const std::string expected = run(command).out;
  const std::map<std::string, std::string> right = graphs_of(store);
  REQUIRE(right.size() == 4);
  check_damaged_entry(fs::directory_iterator(store + "/cache")->path().string(), command);
  for (const std::string sub : {"/graphs", "/cache"}) {
    INFO(sub);
    damage(fs::directory_iterator(store + sub)->path().string());
    const Run again = run(command);
    CHECK(again.out == expected);
    CHECK_THAT(again.error, Contains("note: ") && Contains("damaged"));
    CHECK(graphs_of(store) == right);
  }
}
