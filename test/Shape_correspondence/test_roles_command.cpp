// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The commands roles and label, and roles in other commands, run as programs.
#include "labelled_furniture.h"
#include "model_files.h"
#include "program.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

using namespace CGAL::Shape_correspondence;
using namespace labelled_furniture;
using namespace model_files;
using Catch::Matchers::Contains;

TEST_CASE("The command label predicts roles")
{
  const Temporary_folder folder;
  const std::string shape = std::string(SHAPE_CORRESPONDENCE_DATA_DIR) + "/chair_four_legged/parts";
  const std::string file = folder.path("labels.json");
  const Run labelled = run("label " + shape + " --output " + file);
  REQUIRE(labelled.status == 0);
  CHECK_THAT(labelled.out, Contains("seat"));
  const auto labels = nlohmann::json::parse(text_of(file));
  CHECK(labels["category"] == "chair");
  CHECK(labels["parts"].size() == 12);
  CHECK(labels == nlohmann::json::parse(run("label " + shape + " -o - ").out));
  const auto as_table = nlohmann::json::parse(run("label " + shape + " -o - --category table").out);
  CHECK(as_table["category"] == "table");
  CHECK_THAT(run("label " + shape + " --category boat").error, Contains("does not have the category"));
  CHECK(run("label " + shape + " " + shape).status == 2);
  CHECK(run("label " + shape + " --output " + shape).status == 2);
}

TEST_CASE("roles train writes the same model with any number of threads, and a manifest of its shapes")
{
  const Temporary_folder folder;
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR, quick = " --abstraction boxes --trees 5 --quiet ";
  const std::string train = "roles train " + data + quick + "--output " + folder.path("a.roles");
  const Run trained = run(train + " --threads 1 --manifest - --date 2026-01-31");
  REQUIRE(trained.status == 0);
  const auto manifest = nlohmann::json::parse(trained.out);
  CHECK(manifest["date"] == "2026-01-31");
  CHECK(manifest["shapes"].size() == 14);
  CHECK(manifest["categories"].size() == 6);
  CHECK(manifest["shapes"][0]["license"] == "GPL-3.0-or-later");
  const std::string bytes = text_of(folder.path("a.roles"));
  REQUIRE(run(train + " --threads 2").status == 0);
  CHECK(text_of(folder.path("a.roles")) == bytes);
  CHECK(run("label " + data + "/stool/parts --abstraction boxes --quiet --roles " + folder.path("a.roles")).status ==
        0);
  CHECK_THAT(run("roles train " + data).error, Contains("--output"));
  CHECK_THAT(run("roles predict " + data + " --output x.roles").error, Contains("`label` predicts roles"));
  CHECK(run("roles --help").out.find("roles train FOLDER") != std::string::npos);
}

TEST_CASE("Shapes without labels are left out of training with a warning, and none is not enough")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Temporary_folder folder;
  namespace fs = std::filesystem;
  for (const std::string name : {"chair_four_legged", "stool"})
    for (const std::string category : {"a/", "b/"}) {
      fs::create_directories(folder.path("set/" + category));
      fs::copy(data + "/" + name, folder.path("set/" + category + name), fs::copy_options::recursive);
    }
  const std::string train =
      "roles train " + folder.path("set") + " --abstraction boxes --trees 5 --output " + folder.path("a.roles");
  CHECK(run(train).error.find("labels.json") == std::string::npos);
  fs::remove(folder.path("set/b/stool/labels.json"));
  const Run one = run(train);
  CHECK(one.status == 0);
  CHECK_THAT(one.error, Contains("1 shape has no labels.json") && Contains("set/b/stool"));
  fs::remove(folder.path("set/a/stool/labels.json"));
  const Run two = run(train);
  CHECK(two.status == 0);
  CHECK_THAT(two.error, Contains("2 shapes have no labels.json") && Contains("set/a/stool"));
  CHECK(run(train + " --quiet").error.empty());
  for (const std::string category : {"a", "b"})
    fs::remove(folder.path("set/" + category + "/chair_four_legged/labels.json"));
  fs::remove(folder.path("a.roles"));
  const Run none = run(train + " --quiet");
  CHECK(none.status == 1);
  CHECK_THAT(none.error, Contains("there is no labels.json") && Contains(folder.path("set")));
  CHECK(!fs::exists(folder.path("a.roles")));
}

TEST_CASE("The shipped model knows the models of the package, and the program matches with it")
{
  const auto model = IO::shipped_role_model();
  CHECK(model->categories() == std::vector<std::string>{"airplane", "bed", "car", "chair", "lamp", "plant", "shelf",
                                                        "sofa", "table", "velocipede"});
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Run predicted = run("label " + data + "/chair_four_legged/parts -o -");
  REQUIRE(predicted.status == 0);
  const auto labels = nlohmann::json::parse(predicted.out);
  CHECK(labels["category"] == "chair");
  const std::string shapes = data + "/chair_four_legged/parts " + data + "/stool/parts --quiet --json - ";
  CHECK(nlohmann::json::parse(run("match " + shapes).out)["category"] == "chair");
  CHECK(!nlohmann::json::parse(run("match " + shapes + "--roles none").out).contains("category"));
  CHECK(!nlohmann::json::parse(run("match " + shapes + "--search exact").out).contains("category"));
  const Run paper = run("match " + shapes + "--paper --category chair");
  CHECK(paper.status == 2);
  CHECK_THAT(paper.error, Contains("--category has no effect on --search beam"));
  const Run missing = run("match " + shapes + "--roles /nowhere.roles");
  CHECK(missing.status == 1);
  CHECK_THAT(missing.error, Contains("/nowhere.roles"));
}

namespace {

// Writes a shelf of `shelf()` to a folder, with labels of lower and upper boards. \return the folder of its parts
std::string write_shelf(const Temporary_folder& folder, const std::string& name, double thickness, int boards)
{
  const Furniture shape = shelf(thickness, boards);
  const std::vector<Part_abstraction>& parts = structure(shape.graph).parts;
  auto document = nlohmann::json{{"id", name}, {"category", "shelf"}, {"parts", nlohmann::json::array()}};
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const Point low = parts[part].surface.col(0), size = parts[part].surface.col(1) - low;
    const std::string file = "parts/" + parts[part].name + ".obj", role = part < 2      ? "side"
                                                                          : low.y() < 2 ? "lower"
                                                                                        : "upper";
    folder.write(name + "/" + file, obj_box("o part", 0, low.x(), low.y(), low.z(), size.x(), size.y(), size.z()));
    document["parts"].push_back({{"name", parts[part].name}, {"file", file}, {"coarse", role}});
  }
  folder.write(name + "/labels.json", document.dump());
  return folder.path(name) + "/parts";
}

} // namespace

TEST_CASE("The program uses the user's own examples of a category that it does not know where there are three or more")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Temporary_folder folder;
  const auto match = [](const std::string& words) {
    return nlohmann::json::parse(run("match --quiet --json - --roles none " + words).out);
  };
  const auto examples = [&](const std::string& names, const std::vector<std::string>& chairs) {
    for (const std::string& chair : chairs)
      std::filesystem::copy(data + "/" + chair, folder.path(names + "/" + chair),
                            std::filesystem::copy_options::recursive);
    return " --examples " + folder.path(names);
  };
  std::filesystem::create_directory(folder.path("two"));
  const std::string two = examples("two", {"chair_slatted", "chair_spindle"});
  const std::string chairs = data + "/chair_four_legged/parts " + data + "/stool/parts";
  const auto without = match(chairs);
  for (const std::string category : {"", " --category chair"}) {
    const auto matched = match(chairs + two + category);
    CHECK(!matched.contains("category"));
    CHECK(matched["pairs"] == without["pairs"]);
    CHECK(matched["confidences"] == without["confidences"]);
    CHECK_THAT(matched["warnings"].dump(),
               Contains("examples of the category chair were not used") && Contains("until there are 3"));
  }
  CHECK_THAT(run("collection " + folder.path("two") + " --json - --roles none" + two).error, Contains("not used"));
  // `label` uses any number of examples, since nothing else can label shapes of a user's own category
  const std::string stool = "label " + data + "/stool/parts -o - ";
  CHECK(run(stool + two).error.find("not used") == std::string::npos); // chairs are a known category

  const std::string a = write_shelf(folder, "a", 0.06, 4), b = write_shelf(folder, "b", 0.1, 6);
  for (int i = 1; i < 6; ++i)
    write_shelf(folder, "shelves/" + std::to_string(i), 0.03 + 0.01 * i, 2 * i);
  const auto shelves = match(a + " " + b + " --examples " + folder.path("shelves"));
  CHECK(shelves["category"] == "shelf");
  CHECK(shelves["pairs"].size() == 2 + 2 * 3 + 2 * 3); // the sides, all pairs of lower boards, all pairs of upper ones
  CHECK(shelves["warnings"].dump().find("not used") == std::string::npos);
}

TEST_CASE("The program takes examples with other options, and transfers labels")
{
  const std::string data = SHAPE_CORRESPONDENCE_DATA_DIR;
  const Temporary_folder folder;
  std::filesystem::create_directory(folder.path("examples"));
  for (const std::string name : {"chair_four_legged", "stool"})
    std::filesystem::copy(data + "/" + name, folder.path("examples/" + name), std::filesystem::copy_options::recursive);
  const std::string shapes = data + "/chair_four_legged/parts " + data + "/stool/parts --quiet --json - ";
  const Run predicted = run("label " + data + "/stool/parts -o - --quiet --examples " + folder.path("examples"));
  CHECK(nlohmann::json::parse(predicted.out)["category"] == "chair");
  CHECK_THAT(run("match " + shapes + "--examples " + folder.path("none")).error, Contains("no such file"));
  CHECK_THAT(run("match " + shapes + "--paper --examples " + folder.path("examples")).error,
             Contains("--examples has no effect on --search beam"));
  CHECK_THAT(run("match " + shapes + "--role-weight 1 --roles none").error, Contains("--role-weight has no effect"));
  const auto exact = nlohmann::json::parse(run("match " + shapes + "--role-weight 0.5").out);
  CHECK(exact["search"]["method"] == "exact");
  CHECK(exact["category"] == "chair");

  const std::string set =
      "collection " + folder.path("examples") + " --quiet --labels-from " + data + "/chair_four_legged ";
  const Run transferred = run(set + "--labels-to " + folder.path("labels") + " --json -");
  REQUIRE(transferred.status == 0);
  const auto result = nlohmann::json::parse(transferred.out);
  CHECK(result["category"] == "chair");
  CHECK(result["shapes"].size() == 2);
  const auto own = nlohmann::json::parse(text_of(folder.path("labels/chair_four_legged/labels.json")));
  const auto truth = nlohmann::json::parse(text_of(data + "/chair_four_legged/labels.json"));
  REQUIRE(own["parts"].size() == truth["parts"].size());
  for (const auto& part : own["parts"])
    for (const auto& known : truth["parts"])
      if (part["name"] == known["name"]) CHECK(part["coarse"] == known["coarse"]);
  CHECK(nlohmann::json::parse(text_of(folder.path("labels/stool/labels.json")))["parts"].size() > 3);

  CHECK_THAT(run("collection " + folder.path("examples") + " --labels-from " + data + "/chair_four_legged").out,
             Contains("mean confidence") && Contains("4 leg"));
  CHECK_THAT(run("collection " + data + " --labels-to x").error, Contains("without --labels-from"));
  CHECK_THAT(run(set + "--csv x.csv").error, Contains("--labels-from goes with"));
  CHECK_THAT(run("collection " + folder.path("examples") + " --labels-from " + folder.path("examples")).error,
             Contains("2 labelled shapes"));
}
