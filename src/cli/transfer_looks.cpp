// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/transfer_looks.h"
#include "cli/text.h"
#include "io/system/colours.h"
#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/IO/appearance_files.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <map>
#include <ostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Labels of the source's parts by number, and the names of the numbers.
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
      throw Invalid_input(from + ": it has no label of the source's part '" + part.name + "'");
    result.add(labelled[0].labels[index].coarse);
  }
  return result;
}

const char* origin_name(Looks_origin origin)
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
  std::vector<std::string> result;
  for (std::size_t part : parts)
    result.push_back(structure(shape.graph).parts[part].name);
  return result;
}

} // namespace

Transferred_looks transfer_looks(const std::string& source_file, Loaded_shape& source, const std::string& target_file,
                                 Loaded_shape& target, const Correspondence& correspondence,
                                 const Transfer_request& request)
{
  complete_surfaces(source_file, source);
  complete_surfaces(target_file, target);
  Transferred_looks result;
  for (const auto& [file, shape] : {std::pair(&source_file, &source), std::pair(&target_file, &target)}) {
    read_appearance(*file, *shape);
    IO::decode_textures(shape->appearance, shape->appearance.warnings);
    for (const std::string& warning : shape->appearance.warnings)
      result.warnings.push_back(*file + ": " + warning);
  }
  if (request.labels.empty()) {
    if (source.appearance.empty())
      throw Invalid_input(source_file + ": it has no materials, textures or colours to transfer" +
                          (source.appearance.warnings.empty() ? "" : " (" + source.appearance.warnings[0] + ')') +
                          "; --labels parts transfers which part is which");
    result.result = transfer_appearance(source.graph, *source.model, source.appearance, target.graph, *target.model,
                                        target.appearance, correspondence, request.options);
  } else {
    const Source_labels labels = source_labels(*source.model, request.labels);
    result.labels = labels.names;
    result.result =
        transfer_labels(source.graph, *source.model, labels.of_part, IO::distinct_colours(labels.names.size()),
                        target.graph, *target.model, target.appearance, correspondence, request.options);
  }
  if (!request.output.empty()) IO::write_transferred_shape(request.output, *target.model, result.result, result.labels);
  return result;
}

void write_transfer_json(std::ostream& out, const std::string& source_file, const Loaded_shape& source,
                         const std::string& target_file, const Loaded_shape& target, const Transfer_request& request,
                         const Transferred_looks& transferred)
{
  IO::Json json;
  json["format"] = "shape_correspondence/transfer";
  json["version"] = 1;
  json["source"] = source_file;
  json["target"] = target_file;
  json["output"] = request.output;
  json["texture_size"] = request.options.size;
  json["texture_coordinates"] = transferred.result.has_given_coordinates ? "given" : "new";
  if (!transferred.labels.empty()) json["labels"] = transferred.labels;
  json["parts"] = IO::Json::array();
  for (std::size_t i = 0; i < transferred.result.parts.size(); ++i) {
    const Transferred_part& part = transferred.result.parts[i];
    IO::Json line = {{"name", structure(target.graph).parts[i].name}, {"looks", origin_name(part.origin)}};
    line["sources"] = names_of(part.sources, source);
    if (part.origin == Looks_origin::NEIGHBOUR) line["neighbour"] = structure(target.graph).parts[part.neighbour].name;
    if (const int label = main_label(part); label >= 0) line["label"] = transferred.labels[std::size_t(label)];
    json["parts"].push_back(line);
  }
  json["warnings"] = transferred.warnings;
  json.write(out);
}

void write_transfer_table(std::ostream& out, const Loaded_shape& source, const Loaded_shape& target,
                          const Transferred_looks& transferred)
{
  const bool has_labels = !transferred.labels.empty();
  std::vector<std::vector<std::string>> rows{{"target part", has_labels ? "label" : "looks of", "source parts"}};
  std::size_t neutral = 0, own = 0, taken = 0;
  for (std::size_t i = 0; i < transferred.result.parts.size(); ++i) {
    const Transferred_part& part = transferred.result.parts[i];
    const int label = main_label(part);
    const std::string first = has_labels ? (label < 0 ? "-" : transferred.labels[std::size_t(label)])
                              : part.origin == Looks_origin::SOURCE ? "the source"
                              : part.origin == Looks_origin::NEIGHBOUR
                                  ? structure(target.graph).parts[part.neighbour].name
                              : part.origin == Looks_origin::TARGET ? "its own"
                                                                    : "none: grey";
    rows.push_back({structure(target.graph).parts[i].name, first,
                    part.sources.empty() ? "-" : listed(names_of(part.sources, source))});
    neutral += part.origin == Looks_origin::NEUTRAL;
    own += part.origin == Looks_origin::TARGET;
    taken += part.origin == Looks_origin::NEIGHBOUR;
  }
  write_table(out, rows);
  out << "\ntexture coordinates: "
      << (transferred.result.has_given_coordinates ? "those of the target" : "laid out anew") << '\n';
  if (own + neutral + taken > 0)
    out << "parts that nothing was transferred to: " << own + neutral + taken << " ("
        << (has_labels ? "" : std::to_string(taken) + " look like a part that they touch, ") << own
        << " keep their own looks, " << neutral << " are grey)\n";
}

} // namespace CGAL::Shape_correspondence::cli
