// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/version.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <fstream>

// The program, run from a shell: exit status, messages, and remaining files.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// Checks that an input is refused: status 1, one message on standard error that names the file, no remaining files.
/// \return the message
std::string refused(const Temporary_folder& folder, const std::string& input)
{
  const std::size_t files = folder.number_of_files();
  const std::string good = graph_file(folder, "good.json", hand_made::chair());
  const std::string outputs = " --json " + quoted(folder.path("r.json")) + " --glb " + quoted(folder.path("r.glb"));
  std::string message;
  for (const std::string& command : {"graph " + quoted(input), "match " + quoted(good) + " " + quoted(input),
                                     "match " + quoted(input) + " " + quoted(good)}) {
    const Run result = run(command + outputs);
    INFO(command + "\n" + result.error);
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK_THAT(result.error, Contains(input));
    CHECK(folder.number_of_files() == files + 1);
    message = result.error;
  }
  fs::remove(good);
  return message;
}

} // namespace

TEST_CASE("The program prints its help, that of each command, and its version")
{
  const Run help = run("--help");
  CHECK(help.status == 0);
  CHECK_THAT(help.out, Contains("graph") && Contains("match") && Contains("Example"));
  for (const char* command : {"graph", "match", "evaluate"}) {
    const Run of_command = run(std::string(command) + " --help");
    CHECK(of_command.status == 0);
    CHECK_THAT(of_command.out,
               Contains("Usage") && Contains("Example") && Contains("--json") && Contains("--help-all"));
    CHECK_THAT(run(std::string(command) + " --help-all").out, Contains("--json") && Contains("--threads"));
  }
  CHECK_THAT(run("match --help-all").out, Contains("the paper's K") && Contains("=20"));
  CHECK(run("--version").out == "shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION "\n");
  CHECK(std::string(CGAL_SHAPE_CORRESPONDENCE_VERSION) == SHAPE_CORRESPONDENCE_PROJECT_VERSION);
}

TEST_CASE("The short help has the usual options only, and no help has lines of more than 80 characters")
{
  const std::string usual = run("match --help").out, all = run("help match").out;
  const auto options = [](const std::string& help) {
    std::istringstream in(help);
    int number = 0;
    for (std::string line; std::getline(in, line);)
      number += line.rfind("  -", 0) == 0 && line.rfind("  - ", 0) != 0;
    return number;
  };
  CHECK(options(usual) <= 16);
  CHECK(options(all) > 50);
  CHECK_THAT(usual, Contains("--help-all lists " + std::to_string(options(all) - options(usual)) + " more options"));
  for (const char* command : {"parts", "graph", "match", "blend", "transfer", "collection", "evaluate", "roles",
                              "label", "demo", "completion", "help"}) {
    std::istringstream lines(run(std::string("help ") + command).out);
    for (std::string line; std::getline(lines, line);) {
      INFO(line);
      CHECK(std::count_if(line.begin(), line.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; }) <= 80);
    }
  }
}

TEST_CASE("-o writes what the ending of its file says, and no other file")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  const auto out = [&](const char* name) { return " -o " + quoted(folder.path(name)); };
  CHECK(run("match " + a + " " + a + out("m.html") + out("m.json") + out("m.glb")).status == 0);
  CHECK(text_of(folder.path("m.html")).find("<!DOCTYPE html>") == 0);
  CHECK(json::parse(text_of(folder.path("m.json")))["format"] == "shape_correspondence/match");
  CHECK(text_of(folder.path("m.glb")).substr(0, 4) == "glTF");
  for (const std::string& arguments : {"graph " + a + out("x.obj"), "match " + a + " " + a + out("x.obj"),
                                       "match " + a + " " + a + out("x.html") + out("y.html")}) {
    INFO(arguments);
    const Run refused = run(arguments);
    CHECK(refused.status == 2);
    CHECK_THAT(refused.error, Contains("--output"));
    CHECK(!fs::exists(folder.path("x.obj")));
  }
}

TEST_CASE("A folder of shapes is known by parts and collection, which leave out what is no shape")
{
  const Temporary_folder folder;
  const auto in_set = [&](const char* name) { return folder.path(std::string("set/") + name); };
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  fs::create_directories(in_set("notes"));
  for (const char* name : {"chair_four_legged", "chair_swivel"})
    fs::copy_file(data + "/raw/" + name + ".obj", in_set((name + std::string(".obj")).c_str()));
  fs::copy_file(data + "/README.md", in_set("README.md"));
  const std::string set = quoted(folder.path("set"));
  const Run parts = run("parts " + set);
  CHECK(parts.status == 0);
  CHECK_THAT(parts.out, Contains("chair_four_legged.obj: ") && Contains("chair_swivel.obj: "));
  CHECK_THAT(run("parts " + quoted(data + "/stool")).out, Contains("stool: ")); // a folder of parts
  const Run collection = run("collection " + set + " --abstraction boxes --json -");
  CHECK(collection.status == 0);
  CHECK_THAT(collection.error, Contains("left out, since they are no shapes: README.md, notes"));
  CHECK(json::parse(collection.out)["shapes"].size() == 2);
}

TEST_CASE("A glTF whose buffer is not there: the message names it")
{
  const Temporary_folder folder;
  const std::string old = R"({"asset": {"version": "1.0"}, "scene": "s", "scenes": {"s": {"nodes": ["n"]}},
    "nodes": {"n": {"meshes": ["m"]}}, "meshes": {"m": {"primitives": [{"attributes": {"POSITION": "a"}, "mode": 4}]}},
    "accessors": {"a": {"bufferView": "v", "byteOffset": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
    "bufferViews": {"v": {"buffer": "b", "byteLength": 36, "byteOffset": 0, "target": 34962}},
    "buffers": {"b": {"byteLength": 36, "type": "arraybuffer", "uri": "missing.bin"}}})";
  const Run result = run("graph " + quoted(folder.write("old.gltf", old)));
  CHECK(result.status == 1);
  CHECK_THAT(result.error, Contains("missing.bin', which it names, is not there"));
}

TEST_CASE("Wrong usage ends with status 2 and a reference to the help")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  for (const std::string& arguments :
       std::initializer_list<std::string>{std::string(),
                                          std::string("paint"),
                                          std::string("--nonsense"),
                                          std::string("match"),
                                          "match " + a,
                                          "match " + a + " " + a + " " + a,
                                          "graph " + a + " " + a,
                                          "match " + a + " " + a + " --nonsense",
                                          "match " + a + " " + a + " --beam 3",
                                          "match " + a + " " + a + " --kind round",
                                          "graph " + a + " --part-kind leg",
                                          "graph " + a + " --part-kind leg=round",
                                          "graph " + a + " --abstraction magic",
                                          "graph " + a + " --edge-length 0",
                                          "graph " + a + " --triangles 3",
                                          "graph " + a + " --time-limit -1",
                                          "graph " + a + " --curve-points 1",
                                          "graph " + a + " --html - --json -",
                                          "graph " + a + " --graphml - --dot -",
                                          "match " + a + " " + a + " --solutions 0",
                                          "match " + a + " " + a + " --beam-width 0",
                                          "match " + a + " " + a + " --beam-width many",
                                          "match " + a + " " + a + " --expansions -1",
                                          "match " + a + " " + a + " --search luck",
                                          "match " + a + " " + a + " --search parts --solutions 2",
                                          "match " + a + " " + a + " --paper --search exact",
                                          "match " + a + " " + a + " --solutions 0",
                                          "match " + a + " " + a + " --min-confidence 2",
                                          "match " + a + " " + a + " --allow-unmatched -1",
                                          "match " + a + " " + a + " --alignments 0",
                                          "match " + a + " " + a + " --front left",
                                          "match " + a + " " + a + " --max-parts 0",
                                          "match " + a + " " + a + " --threads 0",
                                          "match " + a + " " + a + " --json - --glb -",
                                          "graph " + a + " --up up",
                                          "graph " + a + " --symmetries spiral",
                                          "graph " + a + " --symmetry-tolerance 2",
                                          "graph " + a + " --contact-tolerance -1",
                                          "graph " + a + " --progress sometimes",
                                          "match " + a + " " + a + " --paper --min-confidence .5",
                                          "match " + a + " " + a + " --search exact --roles none",
                                          "match " + a + " " + a + " --search exact --beam-width 5",
                                          "match " + a + " " + a + " --roles none --category chair",
                                          "match " + a + " " + a + " --front auto --alignments 2",
                                          "match " + a + " " + a + " --front likely --search exact",
                                          "match " + a + " " + a + " --front likely --roles none",
                                          "match " + a + " " + a + " --edge-length .05",
                                          "match " + a + " " + a + " -q -v",
                                          "collection " + a + " " + a + " -k 3",
                                          "parts " + a + " --kind curve",
                                          "roles predict " + a,
                                          "label " + a + " --trees 3",
                                          "help match graph",
                                          "help paint",
                                          "completion csh",
                                          "demo a b",
                                          "graph " + a + " --json"}) {
    INFO(arguments);
    const Run result = run(arguments);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.error, Contains("--help"));
  }
}

TEST_CASE("Numbers out of range and empty words are refused, and the message says why")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair())), two = a + " " + a + " ",
                    blend = "blend " + two + "-o " + quoted(folder.path("b.obj")) + " ",
                    table = quoted(folder.write("table.obj", obj_table()));
  for (const auto& [arguments, reason] : std::initializer_list<std::pair<std::string, std::string>>{
           {blend + "--at -1", "between 0 and 1"},
           {blend + "--at nan", "between 0 and 1"},
           {blend + "--at .5 --frames 2000000000", "at most 10000"},
           {"graph " + table + " --curve-points 2000000000", "at most 1000"},
           {"graph " + table + " --sheet-points 100000", "at most 200"},
           {"match " + two + "--threads 1000000000", "at most 4096"},
           {"match " + two + "--json ''", "--json is empty"},
           {"match " + a + " ''", "input is empty"},
           {"match " + two + "--pin chair=x", "; `shape_correspondence graph` lists"},
           {"collection " + two + "--neighbours -1", "not be negative"}}) {
    INFO(arguments);
    const Run result = run(arguments);
    CHECK(result.status == 2);
    CHECK_THAT(result.error, Contains(reason));
  }
}

TEST_CASE("Options take values in all notations of command lines")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  const std::string graph = run("graph " + a + " --json -").out;
  REQUIRE(!graph.empty());
  for (const char* words : {"--json=-", "-o -", "-o-", "-qo-", "-q -o -", "--json - --", "--threads=1 --json -"}) {
    INFO(words);
    CHECK(run("graph " + std::string(words) + " " + a).out == graph);
  }
  const std::string pair = "match " + a + " " + a + " --allow-unmatched";
  CHECK(run(pair).out == run(pair + "=.5").out);
  CHECK(run(pair + " .7").out == run(pair + "=.7").out);
  CHECK(run(pair + " --threads 1").out == run(pair).out);
  for (const auto& [words, message] : std::initializer_list<std::pair<const char*, const char*>>{
           {"--quiet=3", "option '--quiet' does not take any arguments"},
           {"--json x --json y", "option '--json' cannot be specified more than once"},
           {"--json", "the required argument for option '--json' is missing"},
           {"--threads 99999999999", "the argument ('99999999999') for option '--threads' is invalid"},
           {"--threads 1x", "the argument ('1x') for option '--threads' is invalid"},
           {"--threads=", "the argument for option '--threads' should follow immediately after the equal sign"},
           {"--thr 1", "there is no option '--thr'; did you mean '--threads'?"},
           {"-y", "there is no option '-y'"},
           {"-- -q", "it takes 1 input, not 2"}}) {
    INFO(words);
    const Run result = run("graph " + a + " " + words);
    CHECK(result.status == 2);
    CHECK_THAT(result.error, Contains(message));
  }
}

TEST_CASE("A word that is spelt nearly right is suggested")
{
  CHECK_THAT(run("macth a b").error, Contains("did you mean 'match'? Try"));
  CHECK_THAT(run("help grph").error, Contains("did you mean 'graph'?"));
  CHECK_THAT(run("match a b --min-confidnce 1").error, Contains("did you mean '--min-confidence'?"));
  CHECK_THAT(run("match a b --jsn x").error, Contains("did you mean '--json'?"));
  CHECK_THAT(run("match a b --out x.html").error, Contains("did you mean '--output'?"));
  CHECK_THAT(run("paint a b").error, Contains("no command 'paint'") && !Contains("did you mean"));
  CHECK_THAT(run("match a b --frobnicate").error, Contains("--frobnicate") && !Contains("did you mean"));
}

TEST_CASE("help and the completion tell of every command and option")
{
  CHECK(run("help").out == run("--help").out);
  const std::string bash = run("completion bash").out;
  for (const std::string command :
       {"parts", "graph", "match", "blend", "collection", "evaluate", "roles", "demo", "completion", "help"}) {
    INFO(command);
    const std::string help =
        run(command + (command == "help" || command == "completion" ? " --help" : " --help-all")).out;
    CHECK(run("help " + command).out == help);
    CHECK_THAT(help, Contains("Usage: shape_correspondence " + command));
    CHECK_THAT(run("help").out, Contains("\n  " + command + " "));
    CHECK_THAT(bash, Contains("      " + command + ") words="));
  }
}

TEST_CASE("The completion of bash completes commands, options and files")
{
  const Temporary_folder folder;
  const std::string script = folder.write("completion", run("completion bash").out);
  const auto completions = [&](const std::string& words, int position) {
    const std::string out = folder.path("out");
    const std::string commands = "source " + script + "; COMP_WORDS=(" + words +
                                 "); COMP_CWORD=" + std::to_string(position) +
                                 "; _shape_correspondence; echo ${COMPREPLY[*]}";
    REQUIRE(std::system(("bash -c '" + commands + "' > " + quoted(out)).c_str()) == 0);
    return text_of(out);
  };
  CHECK(completions("shape_correspondence mat", 1) == "match\n");
  CHECK(completions("shape_correspondence match a --min-", 3) == "--min-confidence --min-marginals\n");
  CHECK(completions("shape_correspondence match --search be", 3) == "beam\n");
  CHECK(completions("shape_correspondence match --search = be", 4) == "beam\n");
  CHECK(completions("shape_correspondence help eva", 2) == "evaluate\n");
  CHECK(completions("shape_correspondence match no_such_file", 2) == "\n"); // the shell then completes names of files
}

TEST_CASE("The demo matches its chairs without an error and blends them")
{
  const Temporary_folder folder;
  const std::string demo = folder.path("demo"), data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Run shown = run("demo " + quoted(demo));
  INFO(shown.error);
  REQUIRE(shown.status == 0);
  CHECK_THAT(shown.out, Contains("$ shape_correspondence match") && Contains("$ shape_correspondence blend"));
  CHECK_THAT(shown.out + shown.error, !Contains("note"));
  CHECK(text_of(demo + "/match.html").find("<!DOCTYPE html>") == 0);
  CHECK(text_of(demo + "/blend.html").find("<!DOCTYPE html>") == 0);
  CHECK(text_of(demo + "/blend.glb").substr(0, 4) == "glTF");
  const Run scores = run("evaluate " + quoted(demo + "/match.json") + " --ground-truth " + quoted(data) + " --json -");
  REQUIRE(scores.status == 0);
  CHECK(json::parse(scores.out)["mean"]["f1"] > 0.75); // casters are legs for the role model, not for the labels
  fs::remove(demo + "/blend.html");
  CHECK(run("demo " + quoted(demo)).status == 0); // overwrites the files of an earlier demo
  CHECK(fs::exists(demo + "/blend.html"));
  std::ofstream(demo + "/own.txt") << "x";
  CHECK(run("demo " + quoted(demo)).status == 1);
}

TEST_CASE("Inputs that cannot be used end with status 1, a message and no files")
{
  const Temporary_folder folder;
  const std::string box = obj_box("o leg", 0, 0, 0, 0, 1, 1, 1);
  CHECK_THAT(refused(folder, folder.path("missing.obj")), Contains("no such file"));
  CHECK_THAT(refused(folder, folder.path("missing.json")), Contains("no such file"));
  CHECK_THAT(refused(folder, folder.write("empty.obj", "")), Contains("empty"));
  CHECK_THAT(refused(folder, folder.write("text.obj", "Dear reader,\nno model.\n")), Contains("no face"));
  CHECK_THAT(refused(folder, folder.write("one.obj", box)), Contains("two"));
  CHECK_THAT(refused(folder, folder.write("nan.obj", box + "o seat\nv nan 0 0\nv 1 0 0\nv 0 1 0\nf 9 10 11\n")),
             Contains("'seat'"));
  CHECK_THAT(refused(folder, folder.write("flat.obj", box + "o seat\nv 0 0 0\nv 1 0 0\nv 2 0 0\nf 9 10 11\n")),
             Contains("only one part"));
  CHECK_THAT(refused(folder, folder.write("a.txt", box)), Contains(".txt"));
  CHECK_THAT(refused(folder, folder.write("b.json", "{\"format\": 1}")), Contains("format"));
  fs::create_directories(folder.path("none"));
  CHECK_THAT(refused(folder, folder.path("none")), Contains("no part"));
  REQUIRE(mkfifo(folder.path("pipe.json").c_str(), 0600) == 0);
  CHECK_THAT(refused(folder, folder.path("pipe.json")), Contains("pipe.json: it is a pipe"));
  fs::create_symlink("loop", folder.path("loop"));
  const Run endless = run("collection " + quoted(folder.path("loop")));
  CHECK(endless.status == 1);
  CHECK_THAT(endless.error, Contains(folder.path("loop") + ": it cannot be used"));
}

TEST_CASE("Outputs that cannot be written end with status 1 before any work")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  fs::create_directories(folder.path("folder"));
  for (const std::string& output : {folder.path("none/r.json"), folder.path("folder"), folder.path("a.json/r.json")}) {
    for (const char* option : {" --json ", " --glb "}) {
      INFO(output);
      const Run result = run("match " + a + " " + a + option + quoted(output));
      CHECK(result.status == 1);
      CHECK_THAT(result.error, Contains(output) && Contains("cannot be written"));
      CHECK(folder.number_of_files() == 1);
    }
  }
  const Run full = run("graph " + a + " --json /dev/full");
  CHECK(full.status == 1);
  CHECK_THAT(full.error, Contains("/dev/full"));
}
