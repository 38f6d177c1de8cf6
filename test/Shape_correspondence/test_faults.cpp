// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Full disks, failing system calls, killed or stopped processes, conflicting outputs.

#include "hand_made_graphs.h"
#include "io/system/atomic_file.h"
#include "program.h"

#include <csignal>
#include <map>
#include <sys/stat.h>
#include <unistd.h>

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;

namespace {

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

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // sanitizers reserve terabytes
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
  CHECK(fs::is_empty(folder.path("out")));
}

#if defined(SHAPE_CORRESPONDENCE_FAILING_CALLS) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
namespace {

/// Runs the program so that its `call`-th system call on a written file fails. \return the exit status
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
  constexpr int calls = 40; // more calls on files than the program makes
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

TEST_CASE("An output is written to the disk before it replaces the previous file, and its folder after that")
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
  constexpr int calls = 40; // more calls on files than the program makes
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
  CHECK(fs::is_empty(folder.path("new")));
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
