// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/colours.h"
#include "io/write/part_labels.h"
#include "io/write/pictures.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/parts_json.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Limit for the triangles of all models, which share it equally, and the least share of a model
constexpr std::size_t sheet_triangles = 200000, fewest_of_model = 500;
constexpr std::size_t most_drawn_pieces = 500; // limit for pieces of a model that are drawn each as a mesh

/// The rotation of the upright axis to y, and of a horizontal direction, the front, to z.
Eigen::Matrix3d upright(const Point& up)
{
  const Point front = std::abs(up.z()) > 0.5 ? Point(-up.z() * Point::UnitY()) : Point::UnitZ();
  Eigen::Matrix3d result; // rows: side, up, front
  result << up.cross(front).transpose(), up.transpose(), front.transpose();
  return result;
}

/// Whether the page draws each piece as a mesh of its own, so that its user can divide parts.
bool draws_pieces(const Part_split& split)
{
  return !split.unions.empty() && !split.by_materials && split.pieces.size() <= most_drawn_pieces;
}

Segmented_shape pieces_of(const Segmented_shape& objects, const Part_split& split)
{
  std::map<std::string, std::string> part_of_piece;
  for (const Model_piece& piece : split.pieces)
    part_of_piece[piece.name] = piece.name;
  return split_parts(objects, part_of_piece, false, {}, {}, split.patched_objects).shape;
}

} // namespace

Parts_sheet::Parts_sheet(std::size_t models)
    : triangles_of_model_(std::max(fewest_of_model, sheet_triangles / std::max<std::size_t>(1, models)))
{}

void Parts_sheet::add(const std::string& title, const Segmented_shape& objects, const Part_split& split,
                      const std::vector<std::string>& roles, const std::string& summary)
{
  const bool are_pieces = draws_pieces(split);
  const Segmented_shape shape =
      simplified_shape(are_pieces ? pieces_of(objects, split) : split.shape, triangles_of_model_);
  std::vector<std::string> known = roles, names;
  known.resize(split.shape.parts().size());
  const std::vector<Colour> colours = colours_of_roles(known);
  const Eigen::Matrix3d turn = upright(split.shape.up());
  Json decisions = Json::array();
  std::vector<int> nodes, materials;
  for (std::size_t i = 0; i < known.size(); ++i) {
    names.push_back(split.shape.parts()[i].name);
    materials.push_back(glb_.add_material(names[i], colours[i]));
  }
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    const Shape_part& drawn = shape.parts()[i];
    Drawn_mesh mesh{turn * drawn.mesh.points, {}, drawn.mesh.triangles};
    mesh.material = materials[are_pieces ? split.pieces[i].part : i];
    nodes.push_back(glb_.add_node(drawn.name, {std::move(mesh)}));
  }
  for (std::size_t i = 0; i < split.decisions.size(); ++i)
    decisions.push_back(Json::array({objects.parts()[i].name, split.decisions[i]}));
  roots_.push_back(glb_.add_node(title, nodes, Point::Zero()));
  std::ostringstream list;
  write_parts_json(list, split);
  Json pieces = Json::array(); // by piece: the part, the size, and why it is in the part
  for (const Model_piece& piece : split.pieces)
    pieces.push_back(Json::array(
        {piece.part == no_part ? -1 : int(piece.part), std::round(1000 * piece.size) / 1000, piece.reason}));
  Json unions = Json::array();
  if (are_pieces)
    for (const std::array<std::size_t, 2>& pair : split.unions)
      unions.push_back(Json::array({int(pair[0]), int(pair[1])}));
  models_.push_back({{"name", title},
                     {"summary", summary},
                     {"unions", unions},
                     {"parts", names},
                     {"labels", part_labels(names, roles)},
                     {"roles", known},
                     {"objects", decisions},
                     {"pieces", pieces},
                     {"list", Json::of_text(list.str())}});
}

void Parts_sheet::add(const std::string& title, const std::string& complaint)
{
  roots_.push_back(glb_.add_node(title, std::vector<int>(), Point::Zero()));
  models_.push_back({{"name", title},
                     {"summary", complaint},
                     {"unusable", true},
                     {"parts", Json::array()},
                     {"objects", Json::array()}});
}

void Parts_sheet::write(std::ostream& out) const
{
  std::ostringstream json, glb;
  Json({{"models", models_}}).write(json);
  glb_.write(glb, {{"parts", roots_}});
  write_page(out, {"Parts", {{"parts", json.str()}}, {{"parts.glb", glb.str()}}});
}

} // namespace CGAL::Shape_correspondence::IO
