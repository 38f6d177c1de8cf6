// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <map>
#include <signal.h>

// The command `collection`, run as a program.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

struct Run
{
  int status;
  std::string out;
  std::string error;
};

std::string quoted(const std::string& word) { return "'" + word + "'"; }

/// Runs the command. \param arguments in the syntax of the shell
Run run(const std::string& arguments)
{
  const Temporary_folder folder;
  const int status = std::system((quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " collection " + arguments + " >" +
                                  quoted(folder.path("out")) + " 2>" + quoted(folder.path("error")))
                                     .c_str());
  REQUIRE(WIFEXITED(status));
  return {WEXITSTATUS(status), text_of(folder.path("out")), text_of(folder.path("error"))};
}

Structural_graph named(Structural_graph graph, const std::string& name)
{
  structure(graph).name = name;
  return graph;
}

std::vector<Structural_graph> shapes()
{
  std::vector<Structural_graph> result{hand_made::chair(),      hand_made::slatted_chair(),
                                       hand_made::table(),      hand_made::pedestal_table(),
                                       hand_made::chair(false), hand_made::table(false)};
  for (std::size_t i = 0; i < result.size(); ++i)
    structure(result[i]).name = "shape " + std::to_string(i);
  return result;
}

std::string shape_folder(const Temporary_folder& folder)
{
  std::size_t i = 0;
  for (const Structural_graph& graph : shapes()) {
    std::ostringstream text;
    IO::write_structural_graph_json(text, graph);
    folder.write("shapes/" + std::to_string(i++) + ".json", text.str());
  }
  folder.write("shapes/notes.txt", "no shape");
  return folder.path("shapes");
}

std::size_t number_of_rows(const Temporary_folder& folder)
{
  std::size_t n = 0;
  for (const auto& entry : fs::directory_iterator(folder.path("store/pairs")))
    n += entry.path().extension() == ".row";
  return n;
}

} // namespace

TEST_CASE("A folder of shapes: energies, medoid, tree, clusters, files")
{
  const Temporary_folder folder;
  const std::string in = shape_folder(folder);
  const Run done = run(quoted(in) + " --roles none --json " + quoted(folder.path("c.json")) + " --npy " +
                       quoted(folder.path("c.npy")) + " --csv " + quoted(folder.path("c.csv")) + " --html " +
                       quoted(folder.path("c.html")));
  INFO(done.error);
  REQUIRE(done.status == 0);
  CHECK_THAT(done.out, Contains("medoid") && Contains("shape 3"));
  const json result = json::parse(text_of(folder.path("c.json")));
  const Energy_matrix expected = energy_matrix(shapes());
  REQUIRE(result["energies"].size() == 6);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      CHECK(result["energies"][std::size_t(i)][std::size_t(j)] == expected.energies(i, j));
  CHECK(result["spanning_tree"].size() == 5);
  CHECK(result["shapes"][0]["file"] == in + "/0.json");
  CHECK(text_of(folder.path("c.npy")).size() == 128 + 36 * 8);
  CHECK_THAT(text_of(folder.path("c.csv")), Contains("shape 0,shape 1"));
  CHECK(text_of(folder.path("c.html")).find("<!DOCTYPE html>") == 0);
  std::map<std::string, std::size_t> seats; // the seats of all chairs are in one cluster
  for (const json& cluster : result["clusters"])
    for (const json& part : cluster["parts"])
      if (part[1] == "seat") seats[part[0]] = cluster["label"];
  CHECK(seats.size() == 3);
  CHECK(seats["shape 0"] == seats["shape 1"]);
  CHECK(seats["shape 0"] == seats["shape 4"]);
}

TEST_CASE("Matches of all pairs of shapes, and of them those that the clusters confirm")
{
  const Temporary_folder folder;
  const std::string in = quoted(shape_folder(folder)) + " --roles none --json - ";
  const json plain = json::parse(run(in).out), all = json::parse(run(in + "--matches").out),
             agreeing = json::parse(run(in + "--matches --agreeing").out);
  CHECK(plain.count("matches") == 0);
  REQUIRE(all["matches"].size() == 30);
  const Energy_matrix expected = energy_matrix(shapes());
  CHECK(all["matches"][0]["source"] == "shape 0");
  CHECK(all["matches"][0]["target"] == "shape 1");
  CHECK(all["matches"][0]["pairs"].size() == expected.map(0, 1).pairs.size());
  std::map<json, json> cluster; // cluster of (shape, part)
  for (const json& c : all["clusters"])
    for (const json& part : c["parts"])
      cluster[part] = c["label"];
  for (std::size_t k = 0; k < 30; ++k) {
    const json &match = all["matches"][k], &kept = agreeing["matches"][k];
    json confirmed = json::array();
    for (const json& pair : match["pairs"]) {
      const auto source = cluster.find({match["source"], pair[0]}), target = cluster.find({match["target"], pair[1]});
      if (source != cluster.end() && target != cluster.end() && source->second == target->second)
        confirmed.push_back(pair);
    }
    CHECK(kept["pairs"] == confirmed);
    CHECK(kept["confidences"].size() == confirmed.size());
  }
}

TEST_CASE("The output has the same bytes with any number of threads, with a new store, and from that store")
{
  const Temporary_folder folder;
  const std::string in = quoted(shape_folder(folder)), store = " --store " + quoted(folder.path("store"));
  const std::string expected = run(in + " --json -").out;
  CHECK(!expected.empty());
  CHECK(run(in + " --threads 1 --json -").out == expected);
  CHECK(run(in + store + " --json -").out == expected);
  CHECK(number_of_rows(folder) == 5); // one row for each shape except the last
  CHECK(run(in + store + " --json -").out == expected);

  SECTION("A damaged or missing row is done again")
  {
    const std::string row = fs::directory_iterator(folder.path("store/pairs"))->path().string();
    const std::string whole = text_of(row);
    folder.write("store/pairs/" + fs::path(row).filename().string(), whole.substr(0, whole.size() - 3));
    CHECK(run(in + store + " --json -").out == expected);
    CHECK(text_of(row) == whole);
    fs::remove(row);
    CHECK(run(in + store + " --json -").out == expected);
    CHECK(text_of(row) == whole);
  }
  SECTION("A changed shape has a row of its own, and the others get its pairs")
  {
    std::ostringstream text;
    IO::write_structural_graph_json(text, named(hand_made::moved(hand_made::table(), 0, 3, {1, 0, 0}), "shape 2"));
    folder.write("shapes/2.json", text.str());
    CHECK(run(in + store + " --json -").out == run(in + " --json -").out);
    CHECK(number_of_rows(folder) == 5 + 1);
  }
  SECTION("Changed options need other rows")
  {
    const std::string changed = " --min-confidence 0.5";
    CHECK(run(in + store + changed + " --json -").out == run(in + changed + " --json -").out);
    CHECK(number_of_rows(folder) == 10);
  }
}

#ifdef SHAPE_CORRESPONDENCE_MPIRUN
namespace {

/// Runs the program with several processes by `mpirun`. \param wrapper command that starts the program; may be empty
int run_in_team(const std::string& processes, const std::string& arguments, const std::string& wrapper = "")
{
  // mpirun itself may hang after a process was killed at its start
  const std::string seconds = wrapper.empty() ? "120" : "20";
  return std::system(("timeout -s KILL " + seconds +
                      " " SHAPE_CORRESPONDENCE_MPIRUN " --allow-run-as-root --oversubscribe -n " + processes + " " +
                      wrapper + quoted(SHAPE_CORRESPONDENCE_MPI_PROGRAM) + " collection " + arguments + " 2>/dev/null")
                         .c_str());
}

} // namespace

TEST_CASE("The output has the same bytes with any number of processes")
{
  const Temporary_folder folder;
  const std::string in = quoted(shape_folder(folder));
  const std::string expected = run(in + " --json -").out;
  for (const std::string processes : {"1", "2", "4"}) {
    const std::string output = folder.path("c" + processes + ".json");
    CHECK(run_in_team(processes, in + " --quiet --threads 1 --store " + quoted(folder.path("store" + processes)) +
                                     " --json " + quoted(output)) == 0);
    CHECK(text_of(output) == expected);
  }
  CHECK(run_in_team("2", in + " --quiet") != 0); // several processes need a store
  CHECK(std::system((SHAPE_CORRESPONDENCE_MPIRUN " --allow-run-as-root --oversubscribe -n 2 " +
                     quoted(SHAPE_CORRESPONDENCE_PROGRAM) + " collection " + in + " --quiet 2>/dev/null")
                        .c_str()) != 0); // refused, since each process would do all the work
}

TEST_CASE("If one of several processes is killed, its work is kept, and completed by the next run")
{
  const Temporary_folder folder;
  const std::string output = folder.path("c.json"), in = quoted(shape_folder(folder)) + " --search exact --threads 1";
  const std::string expected = run(in + " --json -").out;
  const std::string arguments = in + " --quiet --store " + quoted(folder.path("store")) + " --json " + quoted(output);
  std::size_t last = 0;
  for (const std::string seconds : {"0", "0.05", "0.1"}) {
    const std::string killed =
        "sh -c 'if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then (sleep " + seconds + "; kill -9 $$) & fi; exec \"$@\"' sh ";
    const bool is_done = run_in_team("2", arguments, killed) == 0;
    const std::size_t rows = fs::is_directory(folder.path("store/pairs")) ? number_of_rows(folder) : 0;
    CHECK(rows >= last); // finished rows are kept
    last = rows;
    CHECK(fs::exists(output) >= is_done);
    CHECK((!fs::exists(output) || text_of(output) == expected));
  }
  CHECK(run_in_team("2", arguments) == 0);
  CHECK(text_of(output) == expected);
}
#endif

TEST_CASE("A run that was killed at any moment continues where it stopped")
{
  const Temporary_folder folder;
  const std::string in = shape_folder(folder), store = folder.path("store");
  const std::string options = quoted(in) + " --search exact --threads 1 --quiet --json ";
  const std::string expected = run(options + "-").out;
  const std::string output = folder.path("c.json");
  std::size_t last = 0;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const pid_t child = fork();
    if (child == 0) {
      execl(SHAPE_CORRESPONDENCE_PROGRAM, "shape_correspondence", "collection", in.c_str(), "--search", "exact",
            "--threads", "1", "--quiet", "--json", output.c_str(), "--store", store.c_str(),
            static_cast<char*>(nullptr));
      _exit(127);
    }
    usleep(useconds_t(8000 + 7000 * attempt));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    const std::size_t rows = fs::is_directory(folder.path("store/pairs")) ? number_of_rows(folder) : 0;
    CHECK(rows >= last); // finished rows are kept
    last = rows;
    CHECK((!fs::exists(output) || text_of(output) == expected));
  }
  CHECK(run(options + "- --store " + quoted(store)).out == expected);
}

TEST_CASE("Shapes that cannot be used: all are named, the work is kept, --skip-bad leaves them out")
{
  const Temporary_folder folder;
  const std::string in = shape_folder(folder), store = " --store " + quoted(folder.path("store"));
  const std::string expected = run(quoted(in) + store + " --json -").out;
  folder.write("shapes/bad.json", "{\"format\": 1}");
  folder.write("shapes/empty.obj", "");
  const Run refused = run(quoted(in) + store + " --json -");
  CHECK(refused.status == 1);
  CHECK(refused.out.empty());
  CHECK_THAT(refused.error, Contains("bad.json") && Contains("empty.obj") && Contains("--skip-bad"));
  const Run skipped = run(quoted(in) + store + " --skip-bad --json -");
  REQUIRE(skipped.status == 0);
  json result = json::parse(skipped.out);
  CHECK(result["warnings"].size() == 2);
  CHECK_THAT(result["warnings"][0].get<std::string>(), Contains("bad.json"));
  result["warnings"] = json::array();
  CHECK(result == json::parse(expected));
  folder.write("graphs", "a file");
  const Run no_folder = run(quoted(in) + " --store " + quoted(folder.path("graphs")));
  CHECK(no_folder.status == 1);
  CHECK_THAT(no_folder.error, Contains("graphs/graphs: it cannot be used as a store"));
}

TEST_CASE("--nearest lists the shapes nearest to a query")
{
  const Temporary_folder folder;
  const std::string in = shape_folder(folder), query = in + "/2.json";
  const Run done = run(quoted(in) + " --nearest " + quoted(query) + " -k 2 --json -");
  INFO(done.error);
  REQUIRE(done.status == 0);
  const json result = json::parse(done.out);
  REQUIRE(result["nearest"].size() == 2);
  CHECK(result["nearest"][0]["name"] == "shape 2");
  CHECK(result["nearest"][0]["distance"].get<double>() == Approx(0).margin(1e-9));
  CHECK(result["nearest"][1]["name"] == "shape 5"); // the same table, whose legs are no group
  CHECK_THAT(run(quoted(in) + " --nearest " + quoted(query)).out, Contains("of 6 shapes"));
}

TEST_CASE("The nearest shapes are of the query's category where roles know it")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR, chair = quoted(data + "/chair_four_legged");
  const std::string shapes = quoted(data + "/table_four_legged") + " " + quoted(data + "/chair_slatted");
  const auto nearest = [&](const std::string& options) {
    const Run done = run(shapes + " --abstraction boxes --nearest " + chair + " -k 1 --json - " + options);
    INFO(done.error);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
  };
  CHECK(nearest("--roles none")["nearest"][0]["name"] == "table_four_legged"); // a table with similar legs and aprons
  CHECK(nearest("--roles none")["category"] == "");
  const json by_category = nearest("");
  CHECK(by_category["category"] == "chair");
  CHECK(by_category["nearest"][0]["name"] == "chair_slatted");
  CHECK(by_category["nearest"][0]["category"] == "chair");
}

TEST_CASE("Wrong usage and invalid inputs are refused")
{
  const Temporary_folder folder;
  const std::string in = quoted(shape_folder(folder)), store = " --store " + quoted(folder.path("store"));
  for (const std::string& arguments :
       {std::string(), in + " --inflation 1", in + " --cycle-support 2", in + " --unmatched-energy -1",
        in + " --neighbours 0", in + " --search exact --solutions 2", in + " --npy x --csv x", in + " --nearest x -k 0",
        in + " --nearest x --npy y", in + " --matches", in + " --json - --agreeing",
        in + " --nearest x --json - --matches"}) {
    INFO(arguments);
    const Run result = run(arguments);
    CHECK(result.status == 2);
    CHECK_THAT(result.error, Contains("--help"));
  }
  fs::create_directories(folder.path("none"));
  for (const std::string& arguments :
       {quoted(folder.path("missing")), quoted(folder.path("none")), quoted(folder.path("shapes/0.json")),
        in + " --npy /nowhere/x", in + " --nearest " + quoted(folder.path("missing")),
        in + " --store " + quoted(folder.path("shapes/0.json"))}) {
    INFO(arguments);
    CHECK(run(arguments).status == 1);
  }
}
