// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writer.h"

#include <algorithm>
#include <cstdio>

namespace CGAL::Shape_correspondence::generator {

namespace {

std::string quoted(const std::string& text) { return '"' + text + '"'; }

// A JSON array of `items`.
std::string json_array(const std::vector<std::string>& items, const std::string& separator = ", ")
{
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i > 0 ? separator : "") + items[i];
  return text + "]";
}

std::string json_lines(const std::vector<std::string>& items)
{
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i)
    text += std::string(i > 0 ? "," : "") + "\n    " + items[i];
  return text + "\n  ]";
}

std::string json_point(const Point& p) { return json_array({number(p.x()), number(p.y()), number(p.z())}); }

std::string json_points(const Path& points)
{
  std::vector<std::string> items;
  for (const Point& p : points)
    items.push_back(json_point(p));
  return json_array(items);
}

std::string json_names(const Names& names)
{
  std::vector<std::string> items;
  for (const std::string& name : names)
    items.push_back(quoted(name));
  return json_array(items);
}

// The parts in one OBJ file, each with a line `o`.
std::string single_obj_text(const Assembly& shape)
{
  std::string text;
  int shift = 0;
  for (const Part& part : shape.parts) {
    text += obj_text(part, shift);
    shift += int(part.solid.mesh.points.size());
  }
  return text;
}

std::string part_structure_text(const Part& part)
{
  const Solid& solid = part.solid;
  const std::string head = "{\"name\": " + quoted(part.name) + ", \"type\": ";
  if (solid.kind != Kind::sheet)
    return head + "\"curve\", \"closed\": " + (solid.kind == Kind::closed_curve ? "true" : "false") +
           ", \"points\": " + json_points(solid.mid) + "}";
  std::vector<std::string> rows;
  for (int i = 0; i < sheet_grid_size; ++i) {
    const auto row = solid.mid.begin() + i * sheet_grid_size;
    rows.push_back(json_points(Path(row, row + sheet_grid_size)));
  }
  return head + "\"sheet\", \"grid\": " + json_array(rows) + "}";
}

std::string plane_text(const Point& normal)
{
  return ", \"plane\": {\"point\": " + json_point(Point::Zero()) + ", \"normal\": " + json_point(normal) + "}";
}

std::string group_text(const Part_group& group)
{
  const std::string head = "{\"parts\": " + json_names(group.parts) + ", \"symmetry\": ";
  switch (group.symmetry) {
  case Symmetry::reflection:
    return head + "\"reflection\"" + plane_text(group.direction) + "}";
  case Symmetry::rotation:
    return head + "\"rotation\", \"axis\": " + json_point(group.direction) + ", \"point\": " + json_point(group.point) +
           ", \"order\": " + std::to_string(group.parts.size()) + "}";
  case Symmetry::translation:
    return head + "\"translation\", \"vector\": " + json_point(group.direction) + "}";
  default:
    return head + "\"self\"" + (group.mirror_symmetric ? plane_text(Point::UnitX()) : "") + "}";
  }
}

// The curves, sheets, groups and contacts of the shape as it was constructed, with the keys of a structural graph.
std::string structure_text(const Assembly& shape)
{
  std::vector<std::string> parts, groups, contacts;
  for (const Part& part : shape.parts)
    parts.push_back(part_structure_text(part));
  for (const Part_group& group : shape.groups)
    groups.push_back(group_text(group));
  for (const auto& [pair, gap] : shape.near_parts(contact_tolerance))
    contacts.push_back("{\"parts\": " + json_names({shape.parts[pair[0]].name, shape.parts[pair[1]].name}) +
                       ", \"gap\": " + number(gap) + "}");
  return "{\n  \"format\": \"shape_correspondence/made\",\n  \"version\": 1,\n  \"name\": " + quoted(shape.name) +
         ",\n  \"up\": [0, 1, 0],\n  \"parts\": " + json_lines(parts) + ",\n  \"groups\": " + json_lines(groups) +
         ",\n  \"contacts\": " + json_lines(contacts) + "\n}\n";
}

} // namespace

std::string number(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.5f", x == 0 ? 0. : x);
  return text;
}

std::string obj_text(const Part& part, int shift)
{
  std::string text = "o " + part.name + "\n";
  for (const Point& p : part.solid.mesh.points)
    text += "v " + number(p.x()) + " " + number(p.y()) + " " + number(p.z()) + "\n";
  for (const auto& f : part.solid.mesh.faces) {
    text += "f";
    for (int i : f)
      text += " " + std::to_string(i + 1 + shift);
    text += "\n";
  }
  return text;
}

std::string part_file(const Part& part) { return "parts/" + part.name + ".obj"; }

std::string labels_text(const Assembly& shape)
{
  std::vector<std::string> items;
  for (const Part& part : shape.parts)
    items.push_back("{\"name\": " + quoted(part.name) + ", \"file\": " + quoted(part_file(part)) +
                    ", \"coarse\": " + quoted(part.label.coarse) +
                    ", \"fine\": " + (part.label.fine.empty() ? "null" : quoted(part.label.fine)) + "}");
  return "{\n  \"id\": " + quoted(shape.name) + ",\n  \"category\": " + quoted(shape.category) +
         ",\n  \"license\": " + quoted(model_license) +
         ",\n  \"up\": \"y\",\n  \"front\": \"+z\",\n  \"left\": \"+x\",\n  \"parts\": " + json_lines(items) + "\n}\n";
}

Files folder_files(const Assembly& shape)
{
  Files files;
  for (const Part& part : shape.parts)
    files[shape.name + "/" + part_file(part)] = obj_text(part);
  files[shape.name + "/labels.json"] = labels_text(shape);
  if (!shape.groups.empty()) files[shape.name + "/structure.json"] = structure_text(shape);
  return files;
}

Files single_file(const Assembly& shape) { return {{shape.name + ".obj", single_obj_text(shape)}}; }

Files raw_file(const Assembly& shape)
{
  std::vector<Part> parts = shape.parts;
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Part& a, const Part& b) { return a.label.coarse < b.label.coarse; });
  std::string text;
  int shift = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts[i];
    part.name = part.label.coarse;
    for (Point& p : part.solid.mesh.points)
      p = Point(p.x(), -p.z(), p.y());
    std::string object = obj_text(part, shift);
    if (i > 0 && parts[i - 1].name == part.name) object.erase(0, object.find('\n') + 1); // part of the same object
    text += object;
    shift += int(part.solid.mesh.points.size());
  }
  return {{shape.name + ".obj", text}};
}

} // namespace CGAL::Shape_correspondence::generator
