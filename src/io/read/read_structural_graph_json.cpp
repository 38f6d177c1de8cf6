// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "io/read/document.h"
#include "io/read/report_text.h"
#include "io/system/input_file.h"
#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <istream>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::IO {
namespace {

/// The frame of a shape for which only the abstractions are known.
Shape_frame frame_of_abstractions(const std::vector<Part_abstraction>& parts, const Point& up)
{
  constexpr int samples_along = 6; // samples of a curve, or along each side of a sheet
  Points all(3, 0);
  for (const Part_abstraction& part : parts) {
    const Points samples = sample(part, samples_along);
    all.conservativeResize(Eigen::NoChange, all.cols() + samples.cols());
    all.rightCols(samples.cols()) = samples;
  }
  return compute_shape_frame(all, up);
}

/// Merges contacts of the same two parts into one contact with the locations of all.
std::vector<Contact> merged_contacts(std::vector<Contact> contacts)
{
  std::vector<Contact> result;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> earlier;
  for (Contact& contact : contacts) {
    const auto [place, is_new] = earlier.emplace(std::minmax(contact.parts[0], contact.parts[1]), result.size());
    if (is_new) {
      result.push_back(std::move(contact));
      continue;
    }
    Contact& known = result[place->second];
    contact.further.insert(contact.further.begin(), contact.parameters);
    for (auto& parameters : contact.further) {
      if (known.parts != contact.parts) std::swap(parameters[0], parameters[1]);
      known.further.push_back(parameters);
    }
  }
  return result;
}

using Part_indices = std::map<std::string, std::size_t>;

constexpr double same_direction = 1e-6; // tolerance for unit vectors, which a person may have typed

void check_extent(const Json_field& field, const Points& points)
{
  if ((points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm() == 0)
    field.fail("has all its points at the same place");
}

Curve read_curve(const Json_field& part)
{
  Curve curve;
  const Json_field list = part["points"];
  curve.closed = part.has("closed") && part["closed"].boolean();
  if (list.size() < 2) list.fail("has fewer than 2 points");
  curve.points = list.points();
  check_extent(list, curve.points);
  return curve;
}

Sheet read_sheet(const Json_field& part)
{
  const Json_field grid = part["grid"];
  const std::vector<Json_field> rows = grid.elements();
  if (rows.size() < 2) grid.fail("has fewer than 2 rows");
  const std::size_t cols = rows[0].size();
  if (cols < 2) rows[0].fail("has fewer than 2 points");
  std::vector<Points> points; // collects rows first, since a damaged file may promise more points than it has
  points.reserve(rows.size());
  for (const Json_field& row : rows)
    points.push_back(row.points(cols, "as long as the first row"));
  Sheet sheet;
  sheet.rows = static_cast<int>(rows.size());
  sheet.cols = static_cast<int>(cols);
  sheet.points.resize(3, Eigen::Index(rows.size() * cols));
  for (std::size_t i = 0; i < rows.size(); ++i)
    sheet.points.middleCols(Eigen::Index(i * cols), sheet.cols) = points[i];
  check_extent(grid, sheet.points);
  return sheet;
}

template <typename Value>
Value read_word(const Json_field& field, Words<Value> words)
{
  const std::string text = field.text();
  std::string known;
  for (const auto& [word, value] : words) {
    if (text == word) return value;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  field.fail("is \"" + text + "\", which is none of " + known);
}

void read_flags(const Json_field& field, Abstraction_report& report)
{
  for (const std::string& text : field.texts())
    for (const auto& [word, flag] : flag_words)
      if (text == word) report.*flag = true;
}

Abstraction_report::Method read_method(const Json_field& abstraction)
{
  using Method = Abstraction_report::Method;
  // Older files give the method of a fitted curve or sheet under another key
  if (abstraction.has("fitted_to"))
    return read_word<Method>(abstraction["fitted_to"],
                             {{"medial_axis", Method::MEDIAL_AXIS}, {"revolution_axis", Method::AXIS}});
  return read_word(abstraction["method"], method_words);
}

Abstraction_report read_report(const Json_field& field)
{
  Abstraction_report report;
  if (field.has("method") || field.has("fitted_to")) report.method = read_method(field);
  if (field.has("repair")) report.repair = read_word(field["repair"], repair_words);
  if (field.has("residual")) report.residual = field["residual"].number_at_least_0();
  if (field.has("coverage")) report.coverage = field["coverage"].number_at_least_0();
  if (field.has("iterations")) report.iterations = field["iterations"].integer();
  if (field.has("flags")) read_flags(field["flags"], report);
  if (field.has("fallback")) report.fallback = field["fallback"].text();
  if (field.has("copy_of")) report.copy_of = field["copy_of"].text();
  return report;
}

Part_abstraction read_part(const Json_field& field)
{
  Part_abstraction part;
  part.name = field["name"].text();
  if (part.name.empty()) field["name"].fail("is empty; give every part a name");
  if (read_word<bool>(field["type"], {{"curve", false}, {"sheet", true}}))
    part.geometry = read_sheet(field);
  else
    part.geometry = read_curve(field);
  if (field.has("volume")) part.volume = field["volume"].number_at_least_0();
  if (field.has("hull_volume")) part.hull_volume = field["hull_volume"].number_at_least_0();
  if (field.has("area")) part.area = field["area"].number_at_least_0();
  if (field.has("surface")) part.surface = field["surface"].points();
  if (field.has("abstraction")) part.report = read_report(field["abstraction"]);
  return part;
}

std::vector<Part_abstraction> read_parts(const Json_field& list, Part_indices& indices)
{
  if (list.size() > internal::most_parts) list.fail("has " + internal::too_many_parts(list.size()));
  std::vector<Part_abstraction> parts;
  for (const Json_field& element : list.elements()) {
    Part_abstraction part = read_part(element);
    if (!indices.emplace(part.name, parts.size()).second)
      element["name"].fail("is \"" + part.name + "\", the name of an earlier part; give every part a name of its own");
    parts.push_back(std::move(part));
  }
  return parts;
}

std::size_t part_index(const Json_field& name, const Part_indices& indices)
{
  const auto found = indices.find(name.text());
  if (found == indices.end()) name.fail("is \"" + name.text() + "\", but no part has that name");
  return found->second;
}

Symmetry read_symmetry(const Json_field& group)
{
  Symmetry symmetry;
  if (group.has("symmetry")) symmetry.type = read_word(group["symmetry"], symmetry_words);
  if (symmetry.type == Symmetry_type::SELF && !group.has("plane")) symmetry.type = Symmetry_type::NONE;
  if (symmetry.type == Symmetry_type::REFLECTION || symmetry.type == Symmetry_type::SELF) {
    symmetry.point = group["plane"]["point"].point();
    symmetry.direction = group["plane"]["normal"].unit_vector();
  } else if (symmetry.type == Symmetry_type::ROTATION) {
    symmetry.point = group["point"].point();
    symmetry.direction = group["axis"].unit_vector();
    symmetry.order = group["order"].integer();
    if (symmetry.order < 2) group["order"].fail("is less than 2");
  } else if (symmetry.type == Symmetry_type::TRANSLATION) {
    symmetry.direction = group["vector"].point();
    if (group.has("point")) symmetry.point = group["point"].point();
  }
  if (group.has("residual")) symmetry.residual = group["residual"].number_at_least_0();
  return symmetry;
}

Part_group read_group(const Json_field& field, const std::vector<Part_abstraction>& parts, const Part_indices& indices,
                      std::set<std::size_t>& grouped)
{
  Part_group group;
  for (const Json_field& name : field["parts"].elements()) {
    group.parts.push_back(part_index(name, indices));
    if (!grouped.insert(group.parts.back()).second)
      name.fail("is \"" + name.text() + "\", which is in a group already");
  }
  if (group.parts.empty()) field["parts"].fail("is empty");
  group.symmetry = read_symmetry(field);
  const bool is_of_one = group.symmetry.type == Symmetry_type::NONE || group.symmetry.type == Symmetry_type::SELF;
  if (is_of_one && group.parts.size() > 1) field.fail("has several parts, whose symmetry cannot be \"self\"");
  if (field.has("volume"))
    group.volume = field["volume"].number_at_least_0();
  else
    for (std::size_t part : group.parts)
      group.volume += parts[part].volume;
  if (field.has("hull_volume"))
    group.hull_volume = field["hull_volume"].number_at_least_0();
  else if (group.parts.size() == 1)
    group.hull_volume = parts[group.parts[0]].hull_volume;
  return group;
}

/// The groups in the file, and a single group for every part that the file leaves out.
std::vector<Part_group> read_groups(const Json_field& list, const std::vector<Part_abstraction>& parts,
                                    const Part_indices& indices)
{
  std::vector<Part_group> groups;
  std::set<std::size_t> grouped;
  for (const Json_field& element : list.elements())
    groups.push_back(read_group(element, parts, indices, grouped));
  for (std::size_t part = 0; !groups.empty() && part < parts.size(); ++part) {
    if (grouped.count(part) == 0) groups.push_back({{part}, Symmetry(), parts[part].volume, parts[part].hull_volume});
  }
  return groups;
}

Eigen::Vector2d read_parameter(const Json_field& field, const Part_abstraction& part)
{
  const std::vector<Json_field> numbers = part.is_sheet() ? field.elements(2, "a parameter [u, v] of a sheet")
                                                          : field.elements(1, "a parameter [t] of a curve");
  Eigen::Vector2d parameter = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    parameter[i] = numbers[i].number();
    if (parameter[i] < 0 || parameter[i] > 1) numbers[i].fail("is not between 0 and 1");
  }
  return parameter;
}

Contact read_contact(const Json_field& field, const std::vector<Part_abstraction>& parts, const Part_indices& indices)
{
  Contact contact;
  const std::vector<Json_field> names = field["parts"].elements(2, "a pair of part names");
  const std::vector<Json_field> parameters = field["parameters"].elements(2, "a pair of parameters");
  for (int side = 0; side < 2; ++side) {
    contact.parts[side] = part_index(names[side], indices);
    contact.parameters[side] = read_parameter(parameters[side], parts[contact.parts[side]]);
  }
  if (contact.parts[0] == contact.parts[1]) field["parts"].fail("names the same part twice");
  return contact;
}

/// Reads the contacts; those of the same two parts are regions of one contact, and are merged.
std::vector<Contact> read_contacts(const Json_field& list, const std::vector<Part_abstraction>& parts,
                                   const Part_indices& indices)
{
  std::vector<Contact> contacts;
  for (const Json_field& element : list.elements())
    contacts.push_back(read_contact(element, parts, indices));
  return merged_contacts(std::move(contacts));
}

Shape_frame read_frame(const Json_field& field, const Point& up)
{
  Shape_frame frame;
  frame.origin = field["origin"].point();
  frame.axes << field["side"].unit_vector(), field["up"].unit_vector(), field["front"].unit_vector();
  frame.height = field["height"].number();
  if (!(frame.height > 0)) field["height"].fail("is not above 0");
  if ((frame.axes.transpose() * frame.axes - Eigen::Matrix3d::Identity()).norm() > same_direction ||
      frame.axes.determinant() < 0)
    field.fail("has axes (side, up, front) that are not orthogonal or not right-handed");
  if ((frame.axes.col(1) - up).norm() > same_direction)
    field["up"].fail("is not the \"up\" of the document; correct it or remove \"frame\"");
  frame.mirror_x = field.has("mirror_side") && field["mirror_side"].boolean();
  frame.mirror_z = field.has("mirror_front") && field["mirror_front"].boolean();
  return frame;
}

void check_format(const Json_field& document)
{
  if (document["format"].text() != "shape_correspondence/graph")
    document["format"].fail("is \"" + document["format"].text() + "\" instead of \"shape_correspondence/graph\"");
  if (document["version"].integer() != 1)
    document["version"].fail("is " + std::to_string(document["version"].integer()) +
                             ", and this program reads version 1 only");
}

Structural_graph read_graph(const Json_field& document, const Structure_options& options)
{
  check_format(document);
  Shape_structure shape;
  Part_indices indices;
  shape.name = document.has("name") ? document["name"].text() : "shape";
  shape.parts = read_parts(document["parts"], indices);
  if (shape.parts.size() < 2) document["parts"].fail("has fewer than two parts; describe a shape of two or more");
  const Point up = document.has("up") ? document["up"].unit_vector() : Point::UnitY();
  shape.frame = document.has("frame") ? read_frame(document["frame"], up) : frame_of_abstractions(shape.parts, up);
  std::vector<Part_group> groups;
  if (document.has("groups") && options.symmetry.enabled)
    groups = read_groups(document["groups"], shape.parts, indices);
  if (document.has("contacts")) shape.contacts = read_contacts(document["contacts"], shape.parts, indices);
  if (document.has("content")) shape.content = document["content"].text();
  if (document.has("segmentation"))
    shape.automatic_parts = read_word<bool>(document["segmentation"], {{"given", false}, {"automatic", true}});
  if (document.has("warnings")) {
    shape.warnings = document["warnings"].texts();
  }
  return complete_structural_graph(std::move(shape), std::move(groups), options);
}

} // namespace

Structural_graph read_structural_graph_json(std::istream& in, const std::string& file_name,
                                            const Structure_options& options)
{
  return read_graph(read_json(in, file_name), options);
}

std::optional<Segmented_shape> read_part_meshes(const std::string& graph_file, const Structural_graph& graph,
                                                const Reading_options& options)
{
  const std::vector<Json_field> parts = read_json_file(graph_file)["parts"].elements();
  const auto names_mesh = [](const Json_field& part) { return part.has("mesh"); };
  if (std::none_of(parts.begin(), parts.end(), names_mesh)) return std::nullopt;
  const Shape_structure& shape = structure(graph);
  Segmented_shape result(shape.name, shape.frame.axes.col(1));
  for (const Json_field& part : parts) {
    const std::filesystem::path folder = std::filesystem::path(graph_file).parent_path();
    const std::string file = (folder / part["mesh"].text()).string();
    if (!options.allow_outside_files && std::filesystem::exists(file) && !is_in_folder_of(graph_file, file))
      part["mesh"].fail("names a file outside the folder of the graph; set `Reading_options::allow_outside_files`");
    const Segmented_shape of_file = read_segmented_shape(file, Point::UnitY(), nullptr, options);
    std::vector<const Part_mesh*> meshes;
    for (const Shape_part& of_mesh : of_file.parts())
      meshes.push_back(&of_mesh.mesh);
    result.add_part(part["name"].text(), internal::joined(meshes));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
