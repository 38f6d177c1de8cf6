// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Full disks, modified files, killed or stopped processes, conflicting outputs.

#include "hand_made_graphs.h"
#include "io/system/atomic_file.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>

#include <array>
#include <csignal>
#include <map>
#include <sys/stat.h>
#include <unistd.h>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

/// The only file of a folder, besides folders.
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

std::string graph_text(const Structural_graph& graph, const std::string& name)
{
  Structural_graph named = graph;
  structure(named).name = name;
  std::ostringstream text;
  IO::write_structural_graph_json(text, named);
  return text.str();
}

std::size_t files_of(const std::string& folder)
{
  std::size_t n = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder))
    ++n;
  return n;
}

/// Runs `work` in a process that kills itself in the middle of it.
template <typename Work>
void die_in(const Work& work)
{
  const pid_t child = fork();
  if (child == 0) {
    work([] { raise(SIGKILL); });
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
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
  // A disk that is full after some kilobytes
  const std::string command = "trap '' XFSZ; ulimit -f 8; " + quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " graph " + model +
                              " --cache " + quoted(folder.path("cache")) + " >" + quoted(folder.path("out")) + " 2>" +
                              quoted(folder.path("error"));
  const int status = std::system(command.c_str());
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  CHECK(text_of(folder.path("out")) == expected);
  CHECK_THAT(text_of(folder.path("error")), Contains("note: ") && Contains("not kept"));
  CHECK(files_of(folder.path("cache")) == 0);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // they reserve terabytes
TEST_CASE("A file that memory does not suffice for is named")
{
  const Temporary_folder folder;
  std::string text = "{\"format\": [\"a\"";
  for (int i = 0; i < 4000000; ++i)
    text += ",\"a\"";
  const std::string file = folder.write("a.json", text + "]}");
  const std::string command = "ulimit -v 250000; " + quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " graph --threads 1 " +
                              quoted(file) + " 2>" + quoted(folder.path("error"));
  const int status = std::system(command.c_str());
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 1));
  CHECK_THAT(text_of(folder.path("error")), Contains(file) && Contains("memory"));
}
#endif

TEST_CASE("With closed standard streams nothing is printed into the files that are opened")
{
  const Temporary_folder folder;
  const std::string graph = folder.write("g.json", graph_text(hand_made::chair(), "a")), output = folder.path("o.json");
  const std::string command =
      quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " graph " + quoted(graph) + " --json " + quoted(output);
  for (const std::string closed : {">&-", "2>&-", "<&-", "<&- >&- 2>&-"}) {
    INFO(closed);
    const int status = std::system((command + " >/dev/null 2>&1 " + closed).c_str());
    CHECK(WEXITSTATUS(status) == (closed.find(">&-") != std::string::npos && closed[0] != '2' ? 1 : 0));
    CHECK(text_of(output) == text_of(graph));
  }
}

TEST_CASE("Standard output that is full is an error of every command")
{
  const Temporary_folder folder;
  const std::string graph = quoted(folder.write("g.json", graph_text(hand_made::chair(), "a")));
  for (const std::string& arguments :
       {std::string("--version"), std::string("--help"), std::string("help match"), "graph " + graph,
        "graph " + graph + " --json -", "match " + graph + " " + graph}) {
    INFO(arguments);
    const std::string command = quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " " + arguments + " >/dev/full 2>/dev/null";
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 1);
  }
}

TEST_CASE("Files that may not grow any more are an error that names the output, and leave nothing behind")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table())), error = folder.path("error");
  const std::string limited = "ulimit -f 2; " + quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " ";
  fs::create_directories(folder.path("out"));
  const auto status_of = [&](const std::string& arguments) {
    const int status = std::system((limited + arguments + " >/dev/null 2>" + quoted(error)).c_str());
    REQUIRE(WIFEXITED(status));
    return WEXITSTATUS(status);
  };
  const std::string output = folder.path("out/o");
  CHECK(status_of("graph " + model + " --glb " + quoted(output + ".glb")) == 1);
  CHECK_THAT(text_of(error), Contains(output + ".glb: it cannot be written (File too large)"));
  CHECK(status_of("blend " + model + " " + model + " --frames 2 --format obj -o " + quoted(output)) == 1);
  CHECK_THAT(text_of(error), Contains(output + "/frame") && Contains("File too large") && !Contains(".tmp-"));
  CHECK(files_of(folder.path("out")) == 0);
}

#if defined(SHAPE_CORRESPONDENCE_FAILING_CALLS) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {

/// Runs the program while one of its calls on written files fails.
int run_failing(int call, const std::string& arguments, const std::string& error)
{
  const int status = std::system(("LD_PRELOAD=" + quoted(SHAPE_CORRESPONDENCE_FAILING_CALLS) +
                                  " FAILING_CALL=" + std::to_string(call) + " " + quoted(SHAPE_CORRESPONDENCE_PROGRAM) +
                                  " " + arguments + " >/dev/null 2>" + quoted(error))
                                     .c_str());
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

std::map<std::string, std::string> contents(const std::string& folder)
{
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) result[fs::relative(entry.path(), folder).string()] = text_of(entry.path().string());
  return result;
}

} // namespace

TEST_CASE("Whichever call on a file fails, an output is whole or as it was before, and the failure is told")
{
  constexpr int calls = 40; // more than there are
  const char* const formats[] = {"json", "csv", "npy", "html"};
  const Temporary_folder folder;
  folder.write("shapes/a.json", graph_text(hand_made::chair(), "a"));
  folder.write("shapes/b.json", graph_text(hand_made::slatted_chair(), "b"));
  const std::string error = folder.path("error"), outputs = folder.path("outputs");
  std::string arguments = "collection " + quoted(folder.path("shapes")) + " -q";
  for (const char* format : formats)
    arguments += " --" + std::string(format) + " " + quoted(outputs + "/o." + format);
  const auto begin_anew = [&] {
    fs::remove_all(outputs);
    for (const char* format : formats)
      folder.write(std::string("outputs/o.") + format, "old");
  };
  begin_anew();
  REQUIRE(run_failing(0, arguments, error) == 0);
  const std::map<std::string, std::string> whole = contents(outputs);
  int failures = 0, status = 0;
  for (int call = 1; call <= calls; ++call) {
    INFO("call " << call);
    begin_anew();
    status = run_failing(call, arguments, error);
    const std::map<std::string, std::string> found = contents(outputs);
    CHECK(found.size() == whole.size());
    for (const auto& [name, text] : found) {
      INFO(name);
      CHECK((text == "old" || text == whole.at(name)));
    }
    if (status == 0) {
      CHECK(found == whole);
      continue;
    }
    ++failures;
    CHECK(status == 1);
    CHECK_THAT(text_of(error), Contains(outputs) && Contains("cannot be written"));
  }
  CHECK(failures > 10);
  CHECK(status == 0);
}

TEST_CASE("An output is on the disk before it takes the place of what was there, and its folder after that")
{
  const Temporary_folder folder;
  const std::string graph = quoted(folder.write("g.json", graph_text(hand_made::chair(), "a"))),
                    error = folder.path("error");
  const std::string arguments = "graph " + graph + " -q --json " + quoted(folder.path("o.json"));
  setenv("FAILING_NAME", "fsync", 1);
  folder.write("o.json", "old");
  CHECK(run_failing(1, arguments, error) == 1);
  CHECK(text_of(folder.path("o.json")) == "old");
  CHECK(run_failing(2, arguments, error) == 1);
  CHECK(text_of(folder.path("o.json")) == text_of(folder.path("g.json")));
  CHECK(run_failing(3, arguments, error) == 0);
  unsetenv("FAILING_NAME");
}

TEST_CASE("Whichever call on a file of a cache or store fails, the result is the same")
{
  constexpr int calls = 40; // more than there are
  const Temporary_folder folder;
  folder.write("shapes/a.json", graph_text(hand_made::chair(), "a"));
  folder.write("shapes/b.json", graph_text(hand_made::slatted_chair(), "b"));
  const std::string shapes = quoted(folder.path("shapes")), store = folder.path("store"), error = folder.path("error");
  const std::string expected = run("collection " + shapes + " --json -").out;
  int failures = 0, status = 0;
  for (int call = 1; call <= calls; ++call) {
    INFO("call " << call);
    fs::remove_all(store);
    status = run_failing(call, "collection " + shapes + " --store " + quoted(store), error);
    failures += !text_of(error).empty();
    if (status != 0) CHECK_THAT(text_of(error), Contains(store));
    const Run again = run("collection " + shapes + " --json - --store " + quoted(store));
    CHECK(again.status == 0);
    CHECK(again.out == expected);
  }
  CHECK(failures > 5);
  CHECK(status == 0);
}
#endif

TEST_CASE("A disk of a few kilobytes gets whole files or none")
{
  const Temporary_folder folder;
  const std::string graph = quoted(folder.write("g.json", graph_text(hand_made::slatted_chair(), "a"))),
                    disk = quoted(folder.path("disk")), program = quoted(SHAPE_CORRESPONDENCE_PROGRAM);
  fs::create_directories(folder.path("disk"));
  // Mounts a small disk in a separate namespace, and lists its content at the end
  const std::string in_own_space = "unshare -rm sh -c ";
  if (std::system((in_own_space + "'mount -t tmpfs -o size=16k none '" + disk + " 2>/dev/null").c_str()) != 0) {
    WARN("no disk can be mounted here");
    return;
  }
  const std::string script =
      folder.write("try", "mount -t tmpfs -o size=16k none " + disk + " || exit 9\n" + program + " match " + graph +
                              " " + graph + " -q --html " + disk + "/o.html\necho $?\nls " + disk + "\n" + program +
                              " graph " + graph + " -q --json " + disk + "/o.json\necho $?\nls " + disk + "\n");
  REQUIRE(std::system(("unshare -rm sh " + quoted(script) + " >" + quoted(folder.path("out")) + " 2>" +
                       quoted(folder.path("error")))
                          .c_str()) == 0);
  CHECK(text_of(folder.path("out")) == "1\n0\no.json\n");
  CHECK_THAT(text_of(folder.path("error")), Contains("o.html") && Contains("No space left"));
}

TEST_CASE("A collection that is killed again and again, and run once more, gives the same result")
{
  const Temporary_folder folder;
  for (int i = 0; i < 6; ++i)
    folder.write("shapes/" + std::to_string(i) + ".json",
                 graph_text(i % 2 == 0 ? hand_made::chair() : hand_made::slatted_chair(), std::to_string(i)));
  const std::string shapes = folder.path("shapes"), store = folder.path("store"), json = folder.path("c.json");
  const std::string command = "collection " + quoted(shapes) + " -q --json " + quoted(json);
  REQUIRE(run(command).status == 0);
  const std::string expected = text_of(json);
  for (useconds_t lifetime = 2000; lifetime < 100000; lifetime += 4000) {
    const pid_t child = fork();
    if (child == 0) {
      execl(SHAPE_CORRESPONDENCE_PROGRAM, "shape_correspondence", "collection", shapes.c_str(), "-q", "--json",
            json.c_str(), "--store", store.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    usleep(lifetime);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    CHECK(text_of(json) == expected);
  }
  const Run last = run(command + " --store " + quoted(store));
  CHECK(last.status == 0);
  CHECK(last.error.empty());
  CHECK(text_of(json) == expected);
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

namespace {

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

} // namespace

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

namespace {

/// Damages a cache entry with graphs whose digests are valid, and checks that they are rebuilt.
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

TEST_CASE("Graphs of a cache that are damaged, but not in their digests, are made again, with a warning")
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

TEST_CASE("A writer that is killed leaves the previous file, and does not hinder the next writer")
{
  const Temporary_folder folder;
  const std::string file = folder.write("r.json", "old"), frames = folder.path("fr");
  die_in([&](const auto& die) {
    IO::write_atomically(file, [&](std::ostream& out) {
      out << "half" << std::flush;
      die();
    });
  });
  die_in([&](const auto& die) { IO::write_folder_atomically(frames, [&](const std::string&) { die(); }); });
  CHECK(text_of(file) == "old");
  CHECK(!fs::exists(frames));
  IO::check_writable(file);
  IO::write_atomically(file, [](std::ostream& out) { out << "new"; });
  IO::check_new_folder(frames);
  IO::write_folder_atomically(frames, [](const std::string& made) { std::ofstream(made + "/a") << "a"; });
  CHECK(text_of(file) == "new");
  CHECK(text_of(frames + "/a") == "a");
}

TEST_CASE("Files that are overwritten keep their mode and the links to them")
{
  const Temporary_folder folder;
  const std::string file = folder.write("r.json", "old"), link = folder.path("link");
  chmod(file.c_str(), 0640);
  fs::create_symlink("r.json", link);
  IO::write_atomically(link, [](std::ostream& out) { out << "new"; });
  CHECK(text_of(file) == "new");
  CHECK(fs::is_symlink(link));
  struct stat status = {};
  REQUIRE(stat(file.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("A link to a file that is not there yet leads to the new file, links in a circle are refused")
{
  const Temporary_folder folder;
  fs::create_directory(folder.path("new"));
  fs::create_symlink("new/r.json", folder.path("first"));
  fs::create_symlink(folder.path("first"), folder.path("second"));
  IO::check_writable(folder.path("second"));
  CHECK(files_of(folder.path("new")) == 0);
  IO::write_atomically(folder.path("second"), [](std::ostream& out) { out << "text"; });
  CHECK(text_of(folder.path("new/r.json")) == "text");
  CHECK(fs::is_symlink(folder.path("first")));
  CHECK(fs::is_symlink(folder.path("second")));
  fs::create_symlink("loop", folder.path("loop"));
  const auto write = [&] { IO::write_atomically(folder.path("loop"), [](std::ostream& out) { out << "text"; }); };
  CHECK_THAT(complaint(write), Contains("loop") && Contains("symbolic links"));
  CHECK_THAT(complaint([&] { IO::check_writable(folder.path("loop")); }), Contains("symbolic links"));
  CHECK(fs::is_symlink(folder.path("loop")));
}

TEST_CASE("Two outputs of one file, and an output that is an input, are refused however they are spelt")
{
  const Temporary_folder folder;
  const std::string a = folder.write("a.json", graph_text(hand_made::chair(), "a")), before = text_of(a);
  fs::create_symlink("a.json", folder.path("link.json"));
  fs::create_symlink(".", folder.path("here"));
  fs::create_symlink("r.json", folder.path("r_link.json"));
  fs::create_symlink("o1", folder.path("o1_link"));
  folder.write("r.json", "");
  const std::string match = "match " + quoted(a) + " " + quoted(a), o1 = folder.path("o1");
  for (const std::string& outputs :
       {" --json " + quoted(o1) + " --glb " + quoted(folder.path("./o1")),
        " --json " + quoted(o1) + " --glb " + quoted(folder.path("here/o1")),
        " --json " + quoted(folder.path("r.json")) + " --html " + quoted(folder.path("r_link.json")),
        " --json " + quoted(o1) + " --glb " + quoted(folder.path("o1_link")), " --json " + quoted(a),
        " --glb " + quoted(folder.path("./a.json")), " --html " + quoted(folder.path("link.json"))}) {
    INFO(outputs);
    const Run result = run(match + outputs);
    CHECK(result.status == 2);
    CHECK_THAT(result.error, Contains("same file") || Contains("is an input"));
    CHECK(text_of(a) == before);
  }
  CHECK(run(match + " --json " + quoted(o1) + " --glb " + quoted(folder.path("o2"))).status == 0);
}

TEST_CASE("A process that is stopped for a while writes the same bytes")
{
  const Temporary_folder folder;
  const std::string model = folder.write("table.obj", obj_table()), output = folder.path("g.json");
  const std::string expected = run("graph " + quoted(model) + " --json -").out;
  for (useconds_t before : {5000u, 30000u, 100000u}) {
    const pid_t child = fork();
    if (child == 0) {
      execl(SHAPE_CORRESPONDENCE_PROGRAM, "shape_correspondence", "graph", model.c_str(), "--quiet", "--json",
            output.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    usleep(before);
    kill(child, SIGSTOP);
    usleep(500000);
    kill(child, SIGCONT);
    int status = 0;
    waitpid(child, &status, 0);
    REQUIRE((WIFEXITED(status) && WEXITSTATUS(status) == 0));
    CHECK(text_of(output) == expected);
  }
  // By default, there is no time limit
  CHECK(Abstraction_options().time_limit == std::numeric_limits<double>::infinity());
}
