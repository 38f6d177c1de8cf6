// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/version.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <set>

// The program from outside: exit status, messages, and what it leaves behind.

using namespace CGAL::Shape_correspondence;
using namespace model_files;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

std::string graph_file(const Temporary_folder& folder, const std::string& name, const Structural_graph& graph)
{
  std::ostringstream text;
  IO::write_structural_graph_json(text, graph);
  return folder.write(name, text.str());
}

/// An input that must be refused: status 1, one message on standard error that names the file, nothing left behind.
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

TEST_CASE("Help at both levels and the version")
{
  const Run help = run("--help");
  CHECK(help.status == 0);
  CHECK_THAT(help.out, Contains("graph") && Contains("match") && Contains("Example"));
  for (const char* command : {"graph", "match", "evaluate"}) {
    const Run of_command = run(std::string(command) + " --help");
    CHECK(of_command.status == 0);
    CHECK_THAT(of_command.out, Contains("Usage") && Contains("Example") && Contains("--json") && Contains("--threads"));
  }
  CHECK_THAT(run("match --help").out, Contains("the paper's K") && Contains("=20"));
  CHECK(run("--version").out == "shape_correspondence " CGAL_SHAPE_CORRESPONDENCE_VERSION "\n");
  CHECK(std::string(CGAL_SHAPE_CORRESPONDENCE_VERSION) == SHAPE_CORRESPONDENCE_PROJECT_VERSION);
}

TEST_CASE("Bad usage ends with status 2 and a pointer to the help")
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
                                          "match " + a + " " + a + " --direction backward",
                                          "match " + a + " " + a + " --search luck",
                                          "match " + a + " " + a + " --search parts --solutions 2",
                                          "match " + a + " " + a + " --paper --search exact",
                                          "match " + a + " " + a + " --solutions 0",
                                          "match " + a + " " + a + " --min-confidence 2",
                                          "match " + a + " " + a + " --allow-unmatched -1",
                                          "match " + a + " " + a + " --without everything",
                                          "match " + a + " " + a + " --norm other",
                                          "match " + a + " " + a + " --weights 1",
                                          "match " + a + " " + a + " --weights 1,x",
                                          "match " + a + " " + a + " --weights -1,1",
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
                                          "match " + a + " " + a + " --search beam --search-time-limit 2",
                                          "match " + a + " " + a + " --direction forward",
                                          "match " + a + " " + a + " --max-parts-of source",
                                          "match " + a + " " + a + " --roles none --category chair",
                                          "match " + a + " " + a + " --front auto --alignments 2",
                                          "match " + a + " " + a + " --edge-length .05",
                                          "match " + a + " " + a + " -q -v",
                                          "collection " + a + " " + a + " -k 3",
                                          "parts " + a + " --kind curve",
                                          "roles predict " + a + " --trees 3",
                                          "label " + a + " --trees 3",
                                          "help match graph",
                                          "help --man match",
                                          "help paint",
                                          "completion fish",
                                          "demo a b",
                                          "graph " + a + " --json"}) {
    INFO(arguments);
    const Run result = run(arguments);
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK_THAT(result.error, Contains("--help"));
  }
}

TEST_CASE("Numbers beyond all sense and empty words are refused, and the message says why")
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
           {"match " + two + "--search exact --weights 1e308,1", "1e50"},
           {"match " + two + "--json ''", "--json is empty"},
           {"match " + a + " ''", "input is empty"},
           {"match " + two + "--pin chair=x", "; `shape_correspondence graph` lists"},
           {"collection " + two + "--neighbours -1", "not be negative"},
           {"evaluate " + a + " --ground-truth " + a + " --resamples 2000000000", "at most 1000000"},
           {"evaluate " + a + " --ground-truth " + a + " --worst -1", "not be negative"}}) {
    INFO(arguments);
    const Run result = run(arguments);
    CHECK(result.status == 2);
    CHECK_THAT(result.error, Contains(reason));
  }
}

TEST_CASE("A word that is spelt nearly right is suggested")
{
  CHECK_THAT(run("macth a b").error, Contains("did you mean 'match'? Try"));
  CHECK_THAT(run("help grph").error, Contains("did you mean 'graph'?"));
  CHECK_THAT(run("match a b --min-confidnce 1").error, Contains("did you mean '--min-confidence'?"));
  CHECK_THAT(run("match a b --jsn x").error, Contains("did you mean '--json'?"));
  CHECK_THAT(run("paint a b").error, Contains("no command 'paint'") && !Contains("did you mean"));
  CHECK_THAT(run("match a b --frobnicate").error, Contains("--frobnicate") && !Contains("did you mean"));
}

TEST_CASE("help, the manual page and the completions tell of every command and option")
{
  CHECK(run("help").out == run("--help").out);
  const std::string page = run("help --man").out, bash = run("completion bash").out, zsh = run("completion zsh").out;
  CHECK_THAT(page, Contains(".TH SHAPE_CORRESPONDENCE 1"));
  for (const std::string command :
       {"parts", "graph", "match", "blend", "collection", "evaluate", "roles", "demo", "completion", "help"}) {
    INFO(command);
    const std::string help = run(command + " --help").out;
    CHECK(run("help " + command).out == help);
    CHECK_THAT(help, Contains("Usage: shape_correspondence " + command));
    CHECK_THAT(run("help").out, Contains("\n  " + command + " "));
    CHECK_THAT(page, Contains("shape_correspondence " + command));
    CHECK_THAT(bash, Contains("      " + command + ") words="));
    CHECK_THAT(zsh, Contains("    '" + command + ":"));
  }
  CHECK_THAT(page, Contains("\\-\\-min\\-confidence"));
  CHECK_THAT(zsh, Contains("'--min-confidence["));
  for (const std::string line : {"\n.", "\n'"}) // at the start of a line they are requests of troff
    for (std::size_t at = page.find(line); at != std::string::npos; at = page.find(line, at + 1)) {
      const std::string request = page.substr(at + 1, 4);
      CHECK((request == ".TH " || request == ".SH " || request == ".nf\n" || request == ".fi\n"));
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
  CHECK(completions("shape_correspondence help eva", 2) == "evaluate\n");
  CHECK(completions("shape_correspondence match no_such_file", 2) == "\n"); // left to the completion of files
  const std::string zsh = folder.write("zsh_completion", run("completion zsh").out);
  if (std::system("command -v zsh > /dev/null") == 0)
    CHECK(std::system(("zsh -n " + quoted(zsh)).c_str()) == 0);
  else
    WARN("zsh is not installed: its completion was not parsed");
}

TEST_CASE("The demo matches its chairs without an error and blends them")
{
  const Temporary_folder folder;
  const std::string demo = folder.path("demo"), data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Run shown = run("demo " + quoted(demo));
  INFO(shown.error);
  REQUIRE(shown.status == 0);
  CHECK_THAT(shown.out, Contains("$ shape_correspondence match") && Contains("$ shape_correspondence blend"));
  CHECK(text_of(demo + "/match.html").find("<!DOCTYPE html>") == 0);
  CHECK(text_of(demo + "/blend.glb").substr(0, 4) == "glTF");
  const Run scores = run("evaluate " + quoted(demo + "/match.json") + " --ground-truth " + quoted(data) + " --json -");
  REQUIRE(scores.status == 0);
  CHECK(json::parse(scores.out)["mean"]["f1"]["mean"] == 1);
  CHECK(run("demo " + quoted(demo)).status == 1); // it is there already
}

TEST_CASE("The table of match: sets of parts, their operation and confidence, one distance in all commands")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR, cache = " --cache " + quoted(folder.path("cache"));
  const std::string pair = quoted(data + "/chair_four_legged") + " " + quoted(data + "/chair_swivel") + cache;
  const Run table = run("match " + pair + " -v");
  INFO(table.out);
  REQUIRE(table.status == 0);
  CHECK_THAT(table.out, Contains("confidence") && Contains("merge 4:1") && Contains("duplicate 4:6") &&
                            Contains(" % ") && Contains("role in a chair"));
  CHECK_THAT(table.out, Contains("group in the source") && Contains("connectedness"));
  CHECK_THAT(table.error, Contains(" s, at most ") && Contains(" MB"));
  CHECK_THAT(run("match " + pair).out, !Contains("group in the source"));

  const std::string csv = folder.path("distances.csv");
  REQUIRE(run("collection " + pair + " -q --csv " + quoted(csv)).status == 0);
  std::istringstream rows(text_of(csv));
  std::string row;
  std::getline(rows, row);
  std::getline(rows, row); // of chair_four_legged
  std::ostringstream distance;
  distance.precision(4);
  distance << std::stod(row.substr(row.rfind(',') + 1));
  CHECK_THAT(table.out, Contains("distance: " + distance.str() + " "));
  CHECK_THAT(run("match " + pair + " --search beam").out, !Contains("confidence"));
}

TEST_CASE("Inputs that cannot be used end with status 1, a message and nothing left behind")
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

TEST_CASE("match writes a table, a JSON and a picture")
{
  const Temporary_folder folder;
  const std::string a = graph_file(folder, "a.json", hand_made::chair());
  const std::string b = graph_file(folder, "b.json", hand_made::slatted_chair());
  const std::string inputs = "match " + quoted(a) + " " + quoted(b);
  const Run table = run(inputs);
  CHECK(table.status == 0);
  CHECK(table.error.empty());
  CHECK_THAT(table.out, Contains("slat 1") && Contains("unmatched") && Contains("energy"));

  const Run quiet =
      run(inputs + " --quiet --json " + quoted(folder.path("r.json")) + " --glb " + quoted(folder.path("r.glb")));
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.error.empty());
  CHECK(folder.number_of_files() == 4);
  const json result = json::parse(text_of(folder.path("r.json")));
  CHECK(result["source"] == a);
  CHECK(result["target"] == b);
  CHECK(result["complete"] == true);
  CHECK(text_of(folder.path("r.glb")).substr(0, 4) == "glTF");

  const Run piped = run(inputs + " --json -");
  CHECK(piped.status == 0);
  CHECK(json::parse(piped.out)["pairs"] == result["pairs"]);
}

TEST_CASE("graph reads what it writes, over an older output")
{
  const Temporary_folder folder;
  const std::string a = graph_file(folder, "a.json", hand_made::chair()), b = folder.write("b.json", "old");
  CHECK(run("graph " + quoted(a) + " -o " + quoted(b)).status == 0);
  CHECK(text_of(a) == text_of(b));
  CHECK(folder.number_of_files() == 2);
}

TEST_CASE("Both commands write pages")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  CHECK(run("graph " + a + " --quiet --html " + quoted(folder.path("g.html"))).status == 0);
  CHECK(run("match " + a + " " + a + " --quiet --html " + quoted(folder.path("m.html"))).status == 0);
  CHECK(text_of(folder.path("g.html")).find("<!DOCTYPE html>") == 0);
  CHECK(text_of(folder.path("m.html")).find("<!DOCTYPE html>") == 0);
}

TEST_CASE("A cache folder saves the abstraction, and is used only for the same model and options")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", obj_table());
  const std::string command =
      "match " + quoted(table) + " " + quoted(table) + " --json - --cache " + quoted(folder.path("cache"));
  const auto result_of = [](const std::string& arguments) {
    const Run done = run(arguments);
    INFO(done.error);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
  };
  json first = result_of(command), second = result_of(command);
  CHECK(first["seconds"]["abstraction"] > 0);
  CHECK(second["seconds"]["abstraction"] == 0);
  CHECK(folder.number_of_files() == 2);
  first.erase("seconds");
  second.erase("seconds");
  CHECK(first == second);
  CHECK(result_of(command + " --kind curve")["seconds"]["abstraction"] > 0);
  CHECK(folder.number_of_files() == 3);
  const Run without = run("graph " + quoted(table) + " --cache " + quoted(table));
  CHECK(without.status == 0);
  CHECK_THAT(without.error, Contains("warning") && Contains("cache"));
}

TEST_CASE("Symmetries, contacts and the upright axis on demand")
{
  const Temporary_folder folder;
  const std::string model = quoted(folder.write("table.obj", obj_table()));
  const auto graph_of = [&](const std::string& options) {
    const Run done = run("graph " + model + " --json - --abstraction boxes" + options);
    INFO(done.error);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
  };
  const auto sizes_of_groups = [](const json& graph) {
    std::multiset<std::size_t> result;
    for (const json& group : graph["groups"])
      result.insert(group["parts"].size());
    return result;
  };
  CHECK(sizes_of_groups(graph_of("")) == std::multiset<std::size_t>{1, 4});
  CHECK(sizes_of_groups(graph_of(" --symmetries reflection")) == std::multiset<std::size_t>{1, 4});
  CHECK(sizes_of_groups(graph_of(" --symmetries translation")) == std::multiset<std::size_t>{1, 2, 2});
  CHECK(sizes_of_groups(graph_of(" --no-symmetry")) == std::multiset<std::size_t>{1, 1, 1, 1, 1});
  CHECK(graph_of("")["contacts"].size() == 4);
  CHECK(graph_of(" --contact-tolerance 0.5")["contacts"].size() == 8);

  const json up = graph_of(" --up auto");
  CHECK(up["up"] == graph_of("")["up"]);
  CHECK_THAT(up["warnings"][0].get<std::string>(), Contains("upright axis was taken to be y"));
}

TEST_CASE("Files for graph tools")
{
  const Temporary_folder folder;
  const std::string a = quoted(graph_file(folder, "a.json", hand_made::chair()));
  const std::string graphml = folder.path("g.graphml"), dot = folder.path("g.dot");
  CHECK(run("graph " + a + " --quiet --graphml " + quoted(graphml) + " --dot " + quoted(dot)).status == 0);
  CHECK_THAT(text_of(graphml), Contains("<graphml"));
  CHECK_THAT(text_of(dot), Contains("graph"));
  CHECK(run("graph " + a + " --graphml " + quoted(folder.path("no/folder.graphml"))).status == 1);
  const Run xml = run("graph " + quoted(folder.write("g.xml", "<document/>")) + " --up auto");
  CHECK(xml.status == 1);
  CHECK_THAT(xml.error, Contains("--up x, y or z"));
}

TEST_CASE("Kinds and bounding boxes on demand")
{
  const Temporary_folder folder;
  const std::string graph = "graph " + quoted(folder.write("table.obj", obj_table())) + " --json - --abstraction boxes";
  const auto types = [&](const std::string& options) {
    std::map<std::string, std::string> result;
    const json document = json::parse(run(graph + options).out);
    for (const json& part : document["parts"])
      result[part["name"]] = part["type"];
    return result;
  };
  CHECK(types("")["leg_1"] == "curve");
  CHECK(types(" --kind sheet")["leg_1"] == "sheet");
  CHECK(types(" --kind sheet --part-kind leg_1=curve")["leg_1"] == "curve");
  CHECK(types(" --part-kind leg_1=sheet")["leg_2"] == "curve");
}

TEST_CASE("Ways of abstraction by their names")
{
  const Temporary_folder folder;
  const std::string graph = "graph " + quoted(folder.write("table.obj", obj_table())) + " --json - --abstraction ";
  const auto method_of_top = [&](const std::string& abstraction) -> std::string {
    const json document = json::parse(run(graph + abstraction).out);
    for (const json& part : document["parts"])
      if (part["name"] == "top") return part["abstraction"]["method"];
    return "";
  };
  CHECK(method_of_top("flow") == "meso_skeleton");
  CHECK(method_of_top("fitted") == "prism");
  CHECK(method_of_top("boxes") == "bounding_box");
}

TEST_CASE("A model of one file through the program")
{
  const Temporary_folder folder;
  const std::string table = folder.write("table.obj", obj_table());
  const std::string graph = folder.path("table.json");
  const Run written = run("graph " + quoted(table) + " -o " + quoted(graph) + " --progress always --threads 2");
  INFO(written.error);
  REQUIRE(written.status == 0);
  CHECK_THAT(written.error, Contains("part 5 of 5"));
  CHECK_THAT(written.out, Contains("leg_1"));
  const Run single = run("graph " + quoted(table) + " --json - --threads 1");
  CHECK(single.out == text_of(graph));
  const Run self = run("match " + quoted(table) + " " + quoted(graph) + " --json -");
  REQUIRE(self.status == 0);
  CHECK(json::parse(self.out)["energy"].get<double>() == Approx(0).margin(1e-9));
  CHECK(json::parse(self.out)["pairs"].size() == 5);
}

TEST_CASE("blend writes frames or an animation, and refuses what it cannot use")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const std::string models =
      "blend " + quoted(data + "/stool") + " " + quoted(data + "/stool") + " --abstraction boxes";
  CHECK(run(models).status == 2); // no output
  CHECK(run(models + " -o " + quoted(folder.path("f")) + " --frames 1").status == 2);
  CHECK(run(models + " -o " + quoted(folder.path("f")) + " --format stl").status == 2);
  const std::string graph = graph_file(folder, "graph.json", hand_made::chair());
  const Run refusal = run("blend " + quoted(graph) + " " + quoted(graph) + " -o " + quoted(folder.path("f")));
  CHECK(refusal.status == 1);
  CHECK_THAT(refusal.error, Contains("graph.json") && Contains("without surfaces"));
  CHECK(folder.number_of_files() == 1);

  const Run frames = run(models + " -o " + quoted(folder.path("f")) + " --frames 3 --json -");
  CHECK(frames.status == 0);
  CHECK(std::filesystem::exists(folder.path("f/frame_002.obj")));
  const json report = json::parse(frames.out);
  CHECK(report["format"] == "shape_correspondence/blend");
  CHECK(report["frames"].size() == 3);
  CHECK(report["schedules"].size() == 5);
  CHECK(run(models + " -o " + quoted(folder.path("f")) + " --frames 3").status == 1); // it is there already
  CHECK(run(models + " -o " + quoted(folder.path("a.glb")) + " --frames 3 --quiet").status == 0);
  CHECK(text_of(folder.path("a.glb")).substr(0, 4) == "glTF");
  CHECK(run("blend " + quoted(graph) + " " + quoted(graph) + " -o " + quoted(folder.path("frames.obj"))).status == 2);
  CHECK(run(models + " --quiet --frames 2 -o " + quoted(folder.path("b.html"))).status == 0);
  const std::string page = text_of(folder.path("b.html"));
  for (const char* id : {"match", "match.glb", "blend", "blend.glb"})
    CHECK(page.find(std::string("id=\"") + id + "\">") != std::string::npos);
}

TEST_CASE("blend makes one shape, by one schedule or by all that differ, of a size that is asked for")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const std::string models = "blend " + quoted(data + "/table_four_legged") + " " + quoted(data + "/table_trestle") +
                             " --abstraction boxes --quiet --cache " + quoted(folder.path("cache")) + " -o ";
  const auto out = [&](const std::string& name) { return models + quoted(folder.path(name)); };
  CHECK(run(out("a.obj") + " --at 0.5 --size same").status == 0);
  const std::string shape = text_of(folder.path("a.obj"));
  CHECK(shape.find('~') != std::string::npos);
  CHECK(run(out("a.ply") + " --at 0.5 --schedule all-at-once").status == 0);
  CHECK(text_of(folder.path("a.ply")).substr(0, 3) == "ply");
  CHECK(run(out("all") + " --at 0.5 --schedule all").status == 0);
  int shapes = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path("all")))
    shapes += file.path().extension() == ".obj";
  CHECK(shapes > 1);
  CHECK(run(out("b.obj") + " --at 1.5").status == 2);
  CHECK(run(out("b") + " --at 0.5").status == 2); // one shape, no file
  CHECK(run(out("b.glb") + " --schedule all").status == 2);
  CHECK(run(out("b.glb") + " --schedule never").status == 2);
  CHECK(run(out("b.glb") + " --size huge").status == 2);
  // Nothing is believed: all shrinks and grows, and is told
  const Run unsure = run(out("c.obj") + " --at 0.5 --min-confidence 1 --json -");
  CHECK(unsure.status == 0);
  const json report = json::parse(unsure.out);
  for (const json& task : report["tasks"])
    CHECK((task["task"] == "shrink" || task["task"] == "grow"));
  CHECK_THAT(report["warnings"].dump(), Contains("--min-confidence"));
  for (const auto& [measure, tolerance] : report["tolerances"].items())
    CHECK(report["frames"][0]["quality"][measure] <= tolerance);
}

TEST_CASE("blend takes graphs whose parts name their meshes")
{
  const Temporary_folder folder;
  const std::string model = std::string(SHAPE_CORRESPONDENCE_DATA_DIR) + "/stool", graph = folder.path("stool.json");
  REQUIRE(run("graph " + quoted(model) + " -o " + quoted(graph) + " --abstraction boxes").status == 0);
  json document = json::parse(text_of(graph));
  std::filesystem::copy(model + "/parts", folder.path("meshes"));
  for (json& part : document["parts"])
    part["mesh"] = "meshes/" + part["name"].get<std::string>() + ".obj";
  folder.write("stool.json", document.dump());
  const auto blended = [&](const std::string& source, const std::string& out) {
    return run("blend " + quoted(source) + " " + quoted(model) + " --abstraction boxes --frames 2 -o " +
               quoted(folder.path(out)));
  };
  REQUIRE(blended(graph, "of_graph").status == 0);
  REQUIRE(blended(model, "of_model").status == 0);
  CHECK(text_of(folder.path("of_graph/frame_000.obj")) == text_of(folder.path("of_model/frame_000.obj")));

  document["parts"][0].erase("mesh");
  folder.write("stool.json", document.dump());
  const Run some = blended(graph, "of_some");
  CHECK(some.status == 1);
  CHECK_THAT(some.error, Contains("stool.json") && Contains("\"mesh\""));
  document["parts"][0]["mesh"] = "meshes/none.obj";
  folder.write("stool.json", document.dump());
  const Run missing = blended(graph, "of_none");
  CHECK(missing.status == 1);
  CHECK_THAT(missing.error, Contains("none.obj"));
}

TEST_CASE("blend takes a correspondence that was found before")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const std::string models = quoted(data + "/chair_spindle") + " " + quoted(data + "/stool") + " --abstraction boxes";
  const std::string result = folder.path("match.json"), other = folder.path("other.json");
  REQUIRE(run("match " + models + " --json " + quoted(result)).status == 0);
  const auto tasks = [&](const std::string& out, const std::string& options) {
    const Run done = run("blend " + models + " -o " + quoted(folder.path(out)) + " --frames 2 --json - " + options);
    REQUIRE(done.status == 0);
    return json::parse(done.out)["tasks"];
  };
  CHECK(tasks("a", "--match " + quoted(result)) == tasks("b", ""));

  json seats = json::parse(text_of(result));
  seats["pairs"] = json::array({json::array({"saddle_seat", "round_board"})});
  seats.erase("confidences");
  folder.write("other.json", seats.dump());
  const json of_seats = tasks("c", "--match " + quoted(other));
  CHECK(std::count_if(of_seats.begin(), of_seats.end(), [](const json& task) { return task["task"] == "morph"; }) == 1);

  // Below the default of --min-confidence, too
  seats["confidences"] = {.2};
  folder.write("other.json", seats.dump());
  const auto morphs = [&](const std::string& out, const std::string& least) {
    const json all = tasks(out, "--match " + quoted(other) + least);
    return std::count_if(all.begin(), all.end(), [](const json& task) { return task["task"] == "morph"; });
  };
  CHECK(morphs("e", "") == 0);
  CHECK(morphs("f", " --min-confidence .25") == 0);
  CHECK(morphs("g", " --min-confidence .1") == 1);
  seats.erase("confidences");

  const std::string blend = "blend " + models + " -o " + quoted(folder.path("d"));
  CHECK(run(blend + " --match " + quoted(result) + " --search beam").status == 2);
  CHECK(run(blend + " --match " + quoted(folder.path("none.json"))).status == 1);
  seats["pairs"][0][1] = "no_such_part";
  folder.write("other.json", seats.dump());
  const Run refusal = run(blend + " --match " + quoted(other));
  CHECK(refusal.status == 1);
  CHECK_THAT(refusal.error, Contains("other.json") && Contains("no_such_part") && Contains("stool"));
}
