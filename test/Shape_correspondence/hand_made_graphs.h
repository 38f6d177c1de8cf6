// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Handwritten structural graphs: no mesh, no detection, all numbers known.
#ifndef SHAPE_CORRESPONDENCE_TEST_HAND_MADE_GRAPHS_H
#define SHAPE_CORRESPONDENCE_TEST_HAND_MADE_GRAPHS_H

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

namespace hand_made {

using namespace CGAL::Shape_correspondence;

inline Points points(std::initializer_list<Point> list)
{
  Points result(3, Eigen::Index(list.size()));
  Eigen::Index i = 0;
  for (const Point& p : list)
    result.col(i++) = p;
  return result;
}

inline Part_abstraction curve(const std::string& name, const Point& from, const Point& to)
{
  Part_abstraction part;
  part.name = name;
  part.geometry = Curve{points({from, to}), false};
  return part;
}

// The closed curve through the ends of two crossing segments, centre ± u and centre ± v.
inline Part_abstraction ring(const std::string& name, const Point& centre, const Point& u, const Point& v)
{
  Part_abstraction part;
  part.name = name;
  part.geometry = Curve{points({centre + u, centre + v, centre - u, centre - v}), true};
  return part;
}

// The rectangle from `corner` along two edge vectors.
inline Part_abstraction sheet(const std::string& name, const Point& corner, const Point& u, const Point& v)
{
  Part_abstraction part;
  part.name = name;
  part.geometry = Sheet{points({corner, corner + v, corner + u, corner + u + v}), 2, 2};
  return part;
}

inline Contact contact(const Shape_structure& shape, std::size_t a, std::size_t b, const Point& where)
{
  return {{a, b}, {nearest_parameter(shape.parts[a], where), nearest_parameter(shape.parts[b], where)}, {}};
}

inline Part_group group(std::vector<std::size_t> parts, Symmetry_type type = Symmetry_type::SELF,
                        const Point& direction = Point::Zero(), double solidity = 1)
{
  Part_group result;
  result.parts = std::move(parts);
  result.symmetry.type = type;
  result.symmetry.direction = type == Symmetry_type::SELF ? Point::UnitX() : direction;
  result.volume = solidity;
  result.hull_volume = 1;
  return result;
}

// A graph of points with given contacts, by default each a group of its own. All samples of a part are at one place, so
// that energies can be computed by hand. A contact whose rod turns by an angle t has the distortion E_d = 1 - cos t (1
// beyond a right angle) and, if the rod grows, the connectedness energy E_c = 1. If its parts come to be in one place,
// E_d = 1 and E_c = 0.
// \param places positions of the parts, ascending in y, then x, then z, so that labels are the indices of target groups
inline Structural_graph point_graph(const std::vector<Point>& places,
                                    const std::vector<std::array<std::size_t, 2>>& contacts,
                                    std::vector<Part_group> groups = {})
{
  Shape_structure shape;
  const bool has_groups = !groups.empty();
  for (std::size_t i = 0; i < places.size(); ++i) {
    shape.parts.push_back(curve("point " + std::to_string(i), places[i], places[i]));
    if (!has_groups) groups.push_back(group({i}));
  }
  for (const auto& pair : contacts)
    shape.contacts.push_back(contact(shape, pair[0], pair[1], places[pair[0]]));
  return make_structural_graph(std::move(shape), std::move(groups));
}

// Seat, back, two front legs and two hind legs, each two a mirror pair: height 1, y up, front z, symmetric about x = 0.
// Parts: 0 seat, 1 back, 2 and 3 front legs, 4 and 5 hind legs; of each pair, the left leg (x > 0) first.
inline Structural_graph chair(bool symmetry = true)
{
  Shape_structure shape;
  shape.name = "chair";
  shape.frame.mirror_x = true;
  shape.parts = {sheet("seat", {-.25, .5, -.25}, {.5, 0, 0}, {0, 0, .5}),
                 sheet("back", {-.25, .5, -.25}, {.5, 0, 0}, {0, .5, 0}),
                 curve("leg front left", {.25, 0, .25}, {.25, .5, .25}),
                 curve("leg front right", {-.25, 0, .25}, {-.25, .5, .25}),
                 curve("leg hind left", {.25, 0, -.25}, {.25, .5, -.25}),
                 curve("leg hind right", {-.25, 0, -.25}, {-.25, .5, -.25})};
  shape.contacts = {contact(shape, 0, 1, {0, .5, -.25}), contact(shape, 0, 2, {.25, .5, .25}),
                    contact(shape, 0, 3, {-.25, .5, .25}), contact(shape, 0, 4, {.25, .5, -.25}),
                    contact(shape, 0, 5, {-.25, .5, -.25})};
  const auto pair = Symmetry_type::REFLECTION;
  std::vector<Part_group> groups;
  if (symmetry)
    groups = {group({0}), group({1}), group({2, 3}, pair, Point::UnitX(), .1), group({4, 5}, pair, Point::UnitX(), .1)};
  else
    for (std::size_t i = 0; i < 6; ++i)
      groups.push_back(group({i}));
  return make_structural_graph(std::move(shape), std::move(groups));
}

// The chair with a back of three slats (parts 1, 2, 3, a row along x) and legs 4 to 7.
inline Structural_graph slatted_chair()
{
  Shape_structure shape;
  shape.name = "slatted chair";
  shape.frame.mirror_x = true;
  shape.parts = {sheet("seat", {-.25, .5, -.25}, {.5, 0, 0}, {0, 0, .5}),
                 curve("slat 1", {-.2, .5, -.25}, {-.2, 1, -.25}),
                 curve("slat 2", {0, .5, -.25}, {0, 1, -.25}),
                 curve("slat 3", {.2, .5, -.25}, {.2, 1, -.25}),
                 curve("leg front left", {.25, 0, .25}, {.25, .5, .25}),
                 curve("leg front right", {-.25, 0, .25}, {-.25, .5, .25}),
                 curve("leg hind left", {.25, 0, -.25}, {.25, .5, -.25}),
                 curve("leg hind right", {-.25, 0, -.25}, {-.25, .5, -.25})};
  shape.contacts = {contact(shape, 0, 1, {-.2, .5, -.25}), contact(shape, 0, 2, {0, .5, -.25}),
                    contact(shape, 0, 3, {.2, .5, -.25}),  contact(shape, 0, 4, {.25, .5, .25}),
                    contact(shape, 0, 5, {-.25, .5, .25}), contact(shape, 0, 6, {.25, .5, -.25}),
                    contact(shape, 0, 7, {-.25, .5, -.25})};
  const auto pair = Symmetry_type::REFLECTION;
  return make_structural_graph(std::move(shape),
                               {group({0}), group({1, 2, 3}, Symmetry_type::TRANSLATION, {.2, 0, 0}, .4),
                                group({4, 5}, pair, Point::UnitX(), .1), group({6, 7}, pair, Point::UnitX(), .1)});
}

// A square top (part 0) on four legs (1 to 4) at its corners, of height 1. \param grouped whether legs are a group
inline Structural_graph table(bool grouped = true)
{
  Shape_structure shape;
  shape.name = "table";
  shape.frame.mirror_x = shape.frame.mirror_z = true;
  shape.parts = {sheet("top", {-.5, 1, -.5}, {1, 0, 0}, {0, 0, 1})};
  for (double z : {-.5, .5})
    for (double x : {-.5, .5}) {
      shape.parts.push_back(curve("leg " + std::to_string(shape.parts.size()), {x, 0, z}, {x, 1, z}));
      shape.contacts.push_back(contact(shape, 0, shape.parts.size() - 1, {x, 1, z}));
    }
  std::vector<Part_group> groups = {group({0})};
  if (grouped)
    groups.push_back(group({1, 2, 3, 4}, Symmetry_type::REFLECTION, Point::UnitX(), .1));
  else
    for (std::size_t leg = 1; leg <= 4; ++leg)
      groups.push_back(group({leg}));
  return make_structural_graph(std::move(shape), std::move(groups));
}

// The table's top on one thick column in the middle, whose surface is known.
inline Structural_graph pedestal_table()
{
  Shape_structure shape;
  shape.name = "pedestal table";
  shape.frame.mirror_x = shape.frame.mirror_z = true;
  shape.parts = {sheet("top", {-.5, 1, -.5}, {1, 0, 0}, {0, 0, 1}), curve("column", {0, 0, 0}, {0, 1, 0})};
  shape.parts[1].surface = points(
      {{-.3, 0, -.3}, {.3, 0, -.3}, {-.3, 0, .3}, {.3, 0, .3}, {-.3, 1, -.3}, {.3, 1, -.3}, {-.3, 1, .3}, {.3, 1, .3}});
  shape.contacts = {contact(shape, 0, 1, {0, 1, 0})};
  return make_structural_graph(std::move(shape), {group({0}), group({1})});
}

// The graph rotated about the up axis, scaled and translated.
inline Structural_graph moved(const Structural_graph& graph, double angle, double scale, const Point& shift)
{
  Structural_graph result = graph;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix();
  Shape_structure& shape = structure(result);
  for (Part_abstraction& part : shape.parts) {
    part.surface = ((scale * turn * part.surface).colwise() + shift).eval();
    std::visit([&](auto& geometry) { geometry.points = ((scale * turn * geometry.points).colwise() + shift).eval(); },
               part.geometry);
  }
  shape.frame.axes = turn * shape.frame.axes;
  shape.frame.origin = scale * turn * shape.frame.origin + shift;
  shape.frame.height *= scale;
  for (std::size_t v = 0; v < num_vertices(result); ++v) {
    Symmetry& symmetry = result[v].symmetry;
    symmetry.point = scale * turn * symmetry.point + shift;
    symmetry.direction = turn * symmetry.direction;
    if (symmetry.type == Symmetry_type::TRANSLATION) symmetry.direction *= scale;
  }
  return result;
}

} // namespace hand_made

#endif // SHAPE_CORRESPONDENCE_TEST_HAND_MADE_GRAPHS_H
