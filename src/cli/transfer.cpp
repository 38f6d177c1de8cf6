// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/jobs.h"
#include "cli/run.h"
#include "io/system/colours.h"
#include "io/system/input_file.h"
#include "io/write/Json.h"
#include "matching/unlikely_pairs.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

namespace CGAL::Shape_correspondence::cli {
namespace {

const char* const transfer_help =
    R"(Usage: shape_correspondence transfer SOURCE TARGET -o FILE.glb|FILE.obj|FILE.ply [options]

Transfers the colours and textures of the source to the target and writes the target with them. It follows the
correspondence of the parts and a map between their surfaces. With --labels, it transfers labels of parts instead.

All colours are baked, pixel by pixel, into one texture of the target. The texture coordinates are those of the target;
if triangles overlap in them, new ones are laid out.

A target part takes the colours of its counterpart. Of several counterparts, it takes the largest; of several about as
large, the highest. The table lists this one first. A target part without counterpart takes the colours of the largest
part that it touches and that has the same material in the target. If the target has no materials, it takes those of the
largest part that it touches. Otherwise it keeps its own colours, or is grey if it has none. With labels, a part with
several counterparts is divided among them, and a part without counterpart gets none.

SOURCE and TARGET are models, as for `match`. Colours and textures are read from OBJ with its MTL files, glTF/GLB, COLLADA, PLY, OFF,
FBX, 3DS and AC3D; textures must be PNG or JPEG.

FILE.glb contains the texture. FILE.obj comes with FILE.mtl and FILE.png. FILE.ply has colours at the vertices of divided
triangles, and the part and label of each face.

Examples: shape_correspondence transfer painted_chair.glb chair.obj -o painted.glb
          shape_correspondence transfer data/chair_slatted chair.obj --labels data/chair_slatted/labels.json -o l.ply

)";

/// Label indices of the source's parts, and the names of the labels.
struct Source_labels
{
  std::vector<int> of_part;
  std::vector<std::string> names;

  void add(const std::string& name)
  {
    const auto found = std::find(names.begin(), names.end(), name);
    of_part.push_back(int(found - names.begin()));
    if (found == names.end()) names.push_back(name);
  }
};

Source_labels source_labels(const Segmented_shape& source, const std::string& from)
{
  Source_labels result;
  if (from == "parts") {
    for (const Shape_part& part : source.parts())
      result.add(part.name);
    return result;
  }
  const std::vector<IO::Labelled_shape> labelled = IO::read_part_labels(from);
  if (labelled.size() != 1)
    throw Invalid_input(from + ": it has the labels of " + std::to_string(labelled.size()) +
                        " shapes; give those of the source");
  for (const Shape_part& part : source.parts()) {
    const std::size_t index = labelled[0].index(part.name);
    if (index == labelled[0].parts.size())
      throw Invalid_input(from + ": it has no label of the source's part '" + part.name + "'; add one");
    result.add(labelled[0].labels[index].coarse);
  }
  return result;
}

const char* origin_name(Appearance_origin origin)
{
  static constexpr const char* names[] = {"source", "neighbour", "target", "neutral"};
  return names[int(origin)];
}

/// The label of most triangles of a part; -1: none.
int main_label(const Transferred_part& part)
{
  std::map<int, std::size_t> count;
  for (int label : part.labels)
    ++count[label];
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == count.end() ? -1 : most->first;
}

std::vector<std::string> names_of(const std::vector<std::size_t>& parts, const Loaded_shape& shape)
{
  return mapped(parts, [&](std::size_t part) { return structure(shape.graph).parts[part].name; });
}

/// Writes a table of what every target part received.
void write_transfer_table(std::ostream& out, const Loaded_shape& source, const Loaded_shape& target,
                          const Transferred_looks& transferred)
{
  const bool has_labels = !transferred.labels.empty();
  std::vector<std::vector<std::string>> rows{{"target part", has_labels ? "label" : "appearance of", "source parts"}};
  for (std::size_t i = 0; i < transferred.result.parts.size(); ++i) {
    const Transferred_part& part = transferred.result.parts[i];
    const int label = main_label(part);
    const std::string first = has_labels ? (label < 0 ? "-" : transferred.labels[std::size_t(label)])
                              : part.origin == Appearance_origin::SOURCE ? "the source"
                              : part.origin == Appearance_origin::NEIGHBOUR
                                  ? structure(target.graph).parts[part.neighbour].name
                              : part.origin == Appearance_origin::TARGET ? "its own"
                                                                         : "none: grey";
    rows.push_back({structure(target.graph).parts[i].name, first,
                    part.sources.empty() ? "-" : listed(names_of(part.sources, source))});
  }
  write_table(out, rows);
  const std::vector<Appearance_origin> origins = mapped(transferred.result.parts, &Transferred_part::origin);
  const auto count = [&](Appearance_origin origin) { return std::count(origins.begin(), origins.end(), origin); };
  const auto neutral = count(Appearance_origin::NEUTRAL), own = count(Appearance_origin::TARGET),
             taken = count(Appearance_origin::NEIGHBOUR);
  out << "\ntexture coordinates: "
      << (transferred.result.has_given_coordinates ? "those of the target" : "laid out anew") << '\n';
  if (own + neutral + taken > 0)
    out << "parts that nothing was transferred to: " << own + neutral + taken << " ("
        << (has_labels ? "" : std::to_string(taken) + " look like a part that they touch, ") << own
        << " keep their own appearance, " << neutral << " are grey)\n";
}

class Transfer_command : public Pair_command
{
public:
  Transfer_command() : Pair_command(transfer_help)
  {
    constexpr double least_size = 16, largest_size = 8192;
    Option_table::Group add = table.group("Output");
    add("output,o", "FILE", &request_.output, "the target with what was transferred: .glb, .obj or .ply");
    add("size", "N", &request_.options.size, "width and height of the texture in pixels")
        .between(least_size, largest_size);
    add("labels", "LABELS", &request_.labels,
        "transfer labels of the source's parts: 'parts' (their names) or a file labels.json")
        .input();
    add("new-coordinates", &request_.options.new_coordinates,
        "lay out new texture coordinates even if those of the target can be used");
    add_result_option(add);
    add("json", "FILE", &common.json, "write what was transferred to every target part as JSON; - is standard output");
    add_shared_options();
  }

private:
  void check() override
  {
    Pair_command::check();
    if (request_.output.empty()) throw Usage_error("-o is missing: FILE.glb, FILE.obj or FILE.ply");
    const std::string extension = IO::lower_extension(request_.output);
    if (extension != ".glb" && extension != ".obj" && extension != ".ply")
      throw Usage_error("-o must name a file that ends in .glb, .obj or .ply");
  }

  std::vector<std::string> output_files() const override
  {
    std::vector<std::string> result{request_.output, common.json};
    if (IO::lower_extension(request_.output) == ".obj")
      for (const char* beside : {".mtl", ".png"})
        result.push_back(std::filesystem::path(request_.output).replace_extension(beside).string());
    return result;
  }

  void work() override
  {
    load();
    Correspondence pairs = correspondence();
    internal::remove_unlikely_pairs(pairs, search.min_confidence);
    Transferred_looks transferred = transfer_looks(shapes[0], shapes[1], pairs, request_);
    append(warnings, pairs.warnings);
    transferred.warnings.insert(transferred.warnings.begin(), warnings.begin(), warnings.end());
    write_output(common.json,
                 [&](std::ostream& out) { write_transfer_json(out, source(), target(), request_, transferred); });
    if (!common.prints_table()) return;
    write_transfer_table(std::cout, source(), target(), transferred);
    write_notes(std::cout, transferred.warnings, common.verbose);
  }

  Transfer_request request_;
};

} // namespace

Transferred_looks transfer_looks(Loaded_shape& source, Loaded_shape& target, const Correspondence& correspondence,
                                 const Transfer_request& request)
{
  Transferred_looks result;
  for (Loaded_shape* shape : {&source, &target}) {
    complete_surfaces(*shape);
    read_appearance(*shape);
    IO::decode_textures(shape->appearance, shape->appearance.warnings);
    append(result.warnings, warnings_of_appearance(*shape));
  }
  if (request.labels.empty()) {
    if (source.appearance.empty())
      throw Invalid_input(source.path + ": it has no materials, textures or colours to transfer" +
                          (source.appearance.warnings.empty() ? "" : " (" + source.appearance.warnings[0] + ')') +
                          "; use --labels parts to transfer which part is which");
    result.result = transfer_appearance(source.graph, *source.model, source.appearance, target.graph, *target.model,
                                        target.appearance, correspondence, request.options);
  } else {
    const Source_labels labels = source_labels(*source.model, request.labels);
    result.labels = labels.names;
    result.result =
        transfer_labels(source.graph, *source.model, labels.of_part, IO::distinct_colours(labels.names.size()),
                        target.graph, *target.model, target.appearance, correspondence, request.options);
  }
  if (!request.output.empty()) {
    IO::write_transferred_shape(request.output, *target.model, result.result, result.labels);
    output_is_whole(request.output);
  }
  return result;
}

void write_transfer_json(std::ostream& out, const Loaded_shape& source, const Loaded_shape& target,
                         const Transfer_request& request, const Transferred_looks& transferred)
{
  IO::Json json;
  json["format"] = "shape_correspondence/transfer";
  json["version"] = 1;
  json["source"] = source.path;
  json["target"] = target.path;
  json["output"] = request.output;
  json["texture_size"] = request.options.size;
  json["texture_coordinates"] = transferred.result.has_given_coordinates ? "given" : "new";
  if (!transferred.labels.empty()) json["labels"] = transferred.labels;
  json["parts"] = IO::Json::array();
  for (std::size_t i = 0; i < transferred.result.parts.size(); ++i) {
    const Transferred_part& part = transferred.result.parts[i];
    IO::Json line = {{"name", structure(target.graph).parts[i].name}, {"looks", origin_name(part.origin)}};
    line["sources"] = names_of(part.sources, source);
    if (part.origin == Appearance_origin::NEIGHBOUR)
      line["neighbour"] = structure(target.graph).parts[part.neighbour].name;
    if (const int label = main_label(part); label >= 0) line["label"] = transferred.labels[std::size_t(label)];
    json["parts"].push_back(line);
  }
  json["warnings"] = transferred.warnings;
  json.write(out);
}

std::unique_ptr<Command> transfer_command() { return std::make_unique<Transfer_command>(); }

} // namespace CGAL::Shape_correspondence::cli
