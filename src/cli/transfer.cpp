// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/choose_parts.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_shape.h"
#include "cli/match_options.h"
#include "cli/outputs.h"
#include "cli/run_report.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "cli/transfer_looks.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"
#include "matching/unlikely_pairs.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence transfer SOURCE TARGET -o FILE.glb|FILE.obj|FILE.ply [options]

Carries the colours and textures of the source over to the target, along the correspondence of their parts and the map
between their surfaces, and writes the target with them. With --labels, labels of parts are carried over instead.

Everything is baked, pixel by pixel, into one texture of the target. It has the texture coordinates of the target if no
triangles overlap in them; otherwise new ones are laid out. Where a part corresponds to several, their looks blend into
each other without a seam. Target parts without counterpart keep their own looks, or are grey; the table lists them.

SOURCE and TARGET are models, as for `match`. Looks are read from OBJ with its MTL files, glTF/GLB, COLLADA, PLY, OFF,
FBX, 3DS and AC3D; textures must be PNG or JPEG.

FILE.glb has the texture in it; beside FILE.obj, FILE.mtl and FILE.png are written; FILE.ply has colours at the vertices
of divided triangles, and the part and label of each face.

Examples: shape_correspondence transfer painted_chair.glb chair.obj -o painted.glb
          shape_correspondence transfer data/chair_slatted chair.obj --labels data/chair_slatted/labels.json -o l.ply

)";

po::options_description output_options(Transfer_request& request, std::string& match, Common_options& common)
{
  po::options_description result = option_group("Output");
  auto add = result.add_options();
  add("output,o", po::value(&request.output)->value_name("FILE"),
      "the target with what was transferred: .glb, .obj or .ply");
  add("size", number(request.options.size)->value_name("N"), "width and height of the texture in pixels");
  add("labels", po::value(&request.labels)->value_name("LABELS"),
      "transfer labels of the source's parts: 'parts' (their names) or a file labels.json");
  add("new-coordinates", po::bool_switch(&request.options.new_coordinates),
      "lay out new texture coordinates even if those of the target can be used");
  add("match", po::value(&match)->value_name("R.json"),
      "read the correspondence from a result that `match --json` wrote for these shapes");
  add("json", po::value(&common.json)->value_name("FILE"),
      "write what was transferred to every target part as JSON; - is standard output");
  return result;
}

struct Variables
{
  Common_options common;
  Match_options match;
  Transfer_request request;
  std::string result; ///< of `match`, or empty
};

po::options_description all_options(Variables& v)
{
  po::options_description result;
  result.add(output_options(v.request, v.result, v.common))
      .add(match_options(v.match))
      .add(pair_options(v.common))
      .add(model_options(v.common))
      .add(common_options(v.common));
  return result;
}

/// \throw Usage_error
void check(const Transfer_request& request)
{
  if (request.output.empty()) throw Usage_error("-o is missing: FILE.glb, FILE.obj or FILE.ply");
  const std::string extension = IO::lower_extension(request.output);
  if (extension != ".glb" && extension != ".obj" && extension != ".ply")
    throw Usage_error("-o must name a file that ends in .glb, .obj or .ply");
  if (request.options.size < 16 || request.options.size > 8192) throw Usage_error("--size must be between 16 and 8192");
}

/// The files that are written.
std::vector<std::string> output_files(const Transfer_request& request)
{
  std::vector<std::string> result{request.output};
  if (IO::lower_extension(request.output) == ".obj")
    for (const char* beside : {".mtl", ".png"})
      result.push_back(std::filesystem::path(request.output).replace_extension(beside).string());
  return result;
}

} // namespace

Command_help help_of_transfer()
{
  static Variables unused;
  return {help_text, all_options(unused)};
}

void run_transfer(const std::vector<std::string>& arguments)
{
  Variables variables;
  Common_options& common = variables.common;
  Transfer_request& request = variables.request;
  const Arguments parsed = parse(arguments, all_options(variables), 2, 2);
  if (parsed.help) return write_help(std::cout, command_of("transfer"));
  const Run_report report(common);
  refuse_abstraction_of_graphs(parsed);
  Search_options search = search_options(variables.match, parsed.values);
  if (!variables.result.empty()) refuse_search_options(parsed.values);
  check(common);
  check(request);
  const std::vector<std::string>& paths = parsed.inputs;
  std::vector<std::string> outputs = output_files(request);
  outputs.push_back(common.json);
  check_outputs(outputs, {paths[0], paths[1], variables.result, request.labels});
  const Thread_limit limit(common.threads);
  common.roles = search.roles;
  std::vector<std::string> warnings;
  std::vector<Loaded_shape> shapes = load_pair(paths, common, warnings);
  Loaded_shape &source = shapes[0], &target = shapes[1];
  choose_parts(variables.match, {source.graph, paths[0]}, {target.graph, paths[1]}, search);
  Correspondence correspondence = variables.result.empty()
                                      ? find_correspondence(source.graph, target.graph, search)
                                      : IO::correspondence_of(IO::read_correspondence_json(variables.result),
                                                              source.graph, target.graph, variables.result);
  internal::remove_unlikely_pairs(correspondence, search.min_confidence);
  Transferred_looks transferred = transfer_looks(paths[0], source, paths[1], target, correspondence, request);
  for (const std::vector<std::string>& more : {warnings_of(paths, shapes), correspondence.warnings})
    warnings.insert(warnings.end(), more.begin(), more.end());
  transferred.warnings.insert(transferred.warnings.begin(), warnings.begin(), warnings.end());
  write_output(common.json, [&](std::ostream& out) {
    write_transfer_json(out, paths[0], source, paths[1], target, request, transferred);
  });
  if (!common.prints_table()) return;
  write_transfer_table(std::cout, source, target, transferred);
  write_notes(std::cout, transferred.warnings, common.verbose);
}

} // namespace CGAL::Shape_correspondence::cli
