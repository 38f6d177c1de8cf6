// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/IO/parts_json.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <map>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr const char* parts_format = "shape_correspondence/parts";
constexpr int parts_version = 1;

} // namespace

void write_parts_json(std::ostream& out, const Part_split& split)
{
  Json pieces = Json::array();
  for (const Model_piece& piece : split.pieces)
    pieces.push_back(
        {{"piece", piece.name}, {"part", piece.part == no_part ? "" : split.shape.parts()[piece.part].name}});
  Json({{"format", parts_format},
        {"version", parts_version},
        {"name", split.shape.name()},
        {"segments", split.by_segments},
        {"patches", Json(split.patched_objects)},
        {"materials", split.by_materials},
        {"pieces", std::move(pieces)}})
      .write(out);
}

Part_split split_parts_by_json(const Segmented_shape& objects, const std::string& path,
                               const std::vector<std::vector<int>>& materials)
{
  const Json_field document = read_json_file(path);
  if (!document.has("format", parts_format))
    throw Invalid_input(path + ": it is not a list of pieces and their parts; make one by `write_parts_json()`");
  if (document["version"].integer() != parts_version) document["version"].fail("is of another version");
  std::map<std::string, std::string> part_of_piece;
  for (const Json_field& entry : document["pieces"].elements())
    if (!part_of_piece.emplace(entry["piece"].text(), entry["part"].text()).second)
      entry["piece"].fail("names a piece that is listed before");
  const bool by_segments = document["segments"].boolean();
  std::vector<std::string> patched_objects;
  if (document.has("patches"))
    for (const Json_field& object : document["patches"].elements())
      patched_objects.push_back(object.text());
  const bool by_materials = document.has("materials") && document["materials"].boolean();
  try {
    return split_parts(objects, part_of_piece, by_segments, {},
                       by_materials ? materials : std::vector<std::vector<int>>(), patched_objects);
  } catch (const Invalid_input& error) {
    throw Invalid_input(path + ": " + error.what() + "; write the list anew with `write_parts_json()`");
  }
}

} // namespace CGAL::Shape_correspondence::IO
