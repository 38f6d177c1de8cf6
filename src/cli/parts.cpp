// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/read_model.h"
#include "cli/run_report.h"
#include "cli/text_table.h"
#include "io/read/model_parts.h"
#include "io/system/quoting.h"
#include "viewer/parts_sheet.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence parts MODEL... [options]
       shape_correspondence parts FOLDER --all [options]

Lists the objects of model files with their loose pieces, and which part each piece becomes, and why. No part is
abstracted, so this is fast. With --html, it also writes a page with a picture of every model, one colour for each part.

MODEL is a model file or a folder of part meshes, as in `graph`. With --all, the models are all model files in FOLDER
and its subfolders.

If the parts are not the wanted ones: --parts file, components or segments makes others, in every command. For full
control, `graph MODEL --parts-json FILE` writes which piece is in which part; edit the file and read it with
--parts-from.

Examples: shape_correspondence parts chair.obj
          shape_correspondence parts furniture --all --html furniture.html --quiet

)";

po::options_description parts_options(Common_options& common)
{
  po::options_description result = option_group("Options of parts");
  auto add = result.add_options();
  add("html", po::value(&common.html)->value_name("FILE"), "write a page with a picture of every model");
  add("parts-from", po::value(&common.parts_from)->value_name("FILE"),
      "read the parts from a list of pieces and their parts, as `graph --parts-json` writes it");
  add("all", po::bool_switch(), "the input is a folder of model files, not of part meshes");
  return result;
}

std::vector<std::string> models_in(const std::string& folder)
{
  if (!fs::is_directory(folder)) throw Invalid_input(folder + ": it is not a folder");
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && IO::is_model_file(entry.path().string())) result.push_back(entry.path().string());
  std::sort(result.begin(), result.end());
  if (result.empty()) throw Invalid_input(folder + ": there is no model file in it");
  return result;
}

std::size_t count_open(const Part_split& split, std::size_t object)
{
  return std::size_t(std::count_if(split.pieces.begin(), split.pieces.end(),
                                   [&](const Model_piece& piece) { return piece.object == object && !piece.closed; }));
}

double size_of_object(const Read_model& model, std::size_t object)
{
  double result = 0;
  for (const Model_piece& piece : model.split.pieces)
    if (piece.object == object) result = std::max(result, piece.size);
  return result;
}

/// How many parts of how many objects, and which way is up.
std::string summary(const Read_model& model)
{
  std::string result =
      std::to_string(model.objects.parts().size()) + " objects, " + std::to_string(model.split.pieces.size()) +
      (model.split.by_segments ? " segments, " : " pieces, ") + std::to_string(model.split.shape.parts().size()) +
      " parts; " + axis_name(model.objects.up()) + " up";
  if (model.up_confidence < 1)
    result += " (confidence " + std::to_string(std::lround(100 * model.up_confidence)) + " %)";
  return result;
}

void print_model(const std::string& path, const Read_model& model)
{
  std::cout << IO::quote_terminal(path) << ": " << summary(model) << "\n\n";
  std::vector<std::vector<std::string>> objects{{"object", "triangles", "open pieces", "largest piece", "result"}};
  for (std::size_t i = 0; i < model.objects.parts().size(); ++i) {
    const Shape_part& object = model.objects.parts()[i];
    objects.push_back({object.name, std::to_string(object.mesh.triangles.cols()),
                       std::to_string(count_open(model.split, i)), short_number(size_of_object(model, i)),
                       model.split.decisions[i]});
  }
  write_table(std::cout, std::move(objects));
  std::vector<std::vector<std::string>> pieces{{"part", "piece", "size", "surface", "reason"}};
  for (std::size_t part = 0; part < model.split.shape.parts().size(); ++part)
    for (const Model_piece& piece : model.split.pieces)
      if (piece.part == part)
        pieces.push_back({model.split.shape.parts()[part].name, piece.name, short_number(piece.size),
                          piece.closed ? "closed" : "open", piece.reason});
  std::cout << '\n';
  write_table(std::cout, std::move(pieces));
  std::cout << "\nSizes are fractions of the size of the model.\n";
  for (const std::string& warning : model.warnings)
    std::cout << "warning: " << IO::quote_terminal(warning) << '\n';
  std::cout << '\n';
}

po::options_description all_options(Common_options& common)
{
  po::options_description result;
  result.add(parts_options(common)).add(reading_options(common)).add(common_options(common));
  return result;
}

} // namespace

Command_help help_of_parts()
{
  static Common_options unused;
  return {help_text, all_options(unused)};
}

void run_parts(const std::vector<std::string>& arguments)
{
  Common_options common;
  const Arguments parsed = parse(arguments, all_options(common), 1, any_number);
  if (parsed.help) return write_help(std::cout, command_of("parts"));
  const Run_report report(common);
  check(common);
  common.roles = IO::shipped_role_model();
  check_outputs({common.html}, parsed.inputs);
  const bool all = parsed.values["all"].as<bool>();
  if (all && parsed.inputs.size() != 1) throw Usage_error("--all takes one folder");
  const std::vector<std::string> paths = all ? models_in(parsed.inputs[0]) : parsed.inputs;
  IO::Parts_sheet sheet(paths.size());
  std::string complaints;
  for (const std::string& path : paths) {
    try {
      const Read_model model = read_model(path, common);
      if (common.prints_table()) print_model(path, model);
      if (!common.html.empty()) sheet.add(fs::path(path).stem().string(), model.objects, model.split, summary(model));
    } catch (const Invalid_input& error) {
      complaints += (complaints.empty() ? "" : "\n") + std::string(error.what());
      sheet.add(fs::path(path).stem().string(), error.what());
    }
  }
  write_output(common.html, [&](std::ostream& out) { sheet.write(out); });
  if (!complaints.empty()) throw Invalid_input(complaints);
}

} // namespace CGAL::Shape_correspondence::cli
