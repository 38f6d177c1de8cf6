// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Chairs and shelves of boxes, with the roles of their parts.
#ifndef SHAPE_CORRESPONDENCE_TEST_LABELLED_FURNITURE_H
#define SHAPE_CORRESPONDENCE_TEST_LABELLED_FURNITURE_H

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/train_role_model.h>

#include <deque>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace labelled_furniture {

using namespace CGAL::Shape_correspondence;
using hand_made::curve;

// Points on a box's surface, at the same relative positions for every box.
inline Points box_surface(const Point& low, const Point& high)
{
  Points result(3, 32);
  for (int i = 0; i < 32; ++i) {
    const Point t(((i * 7) % 8) / 7., ((i * 5) % 11) / 10., ((i * 3) % 5) / 4.);
    result.col(i) = low + (high - low).cwiseProduct(t);
  }
  result.col(0) = low;
  result.col(1) = high;
  return result;
}

inline Part_abstraction box(const std::string& name, const Point& low, const Point& high)
{
  const Point middle = (low + high) / 2;
  Part_abstraction part = curve(name, {middle.x(), low.y(), middle.z()}, {middle.x(), high.y(), middle.z()});
  part.surface = box_surface(low, high);
  const Point s = high - low;
  part.area = 2 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
  return part;
}

struct Furniture
{
  Structural_graph graph;
  std::string category;
  std::vector<Part_label> labels;
};

inline std::vector<std::string> roles(const std::vector<Part_label>& labels)
{
  std::vector<std::string> result;
  for (const Part_label& label : labels)
    result.push_back(label.coarse);
  return result;
}

inline Furniture furniture(const std::string& category, std::vector<Part_abstraction> parts,
                           std::vector<Part_label> labels)
{
  Shape_structure shape;
  shape.name = category;
  shape.parts = std::move(parts);
  std::vector<Part_group> groups;
  for (std::size_t part = 0; part < shape.parts.size(); ++part)
    groups.push_back({{part}, {}, 0, 0});
  return {make_structural_graph(std::move(shape), std::move(groups)), category, std::move(labels)};
}

// A chair of width 2 with given thickness of the legs and height of the seat.
inline Furniture chair(double thickness, double seat)
{
  std::vector<Part_abstraction> parts;
  for (const double x : {-1., 1. - thickness})
    for (const double z : {-1., 1. - thickness})
      parts.push_back(box("leg" + std::to_string(parts.size()), {x, 0, z}, {x + thickness, seat, z + thickness}));
  parts.push_back(box("seat", {-1, seat, -1}, {1, seat + 0.2, 1}));
  parts.push_back(box("back", {-1, seat + 0.2, -1}, {1, seat + 2, -0.8}));
  return furniture("chair", std::move(parts),
                   {{"leg", "leg_back_right"},
                    {"leg", "leg_front_right"},
                    {"leg", "leg_back_left"},
                    {"leg", "leg_front_left"},
                    {"seat", ""},
                    {"back", ""}});
}

inline Furniture shelf(double thickness, int boards)
{
  std::vector<Part_abstraction> parts{box("left", {1 - thickness, 0, -0.5}, {1, 4, 0.5}),
                                      box("right", {-1, 0, -0.5}, {-1 + thickness, 4, 0.5})};
  std::vector<Part_label> labels{{"side", "side_left"}, {"side", "side_right"}};
  for (int i = 0; i < boards; ++i) {
    const double y = (4 - thickness) * (i + 0.5) / boards;
    parts.push_back(box("board" + std::to_string(i), {-1 + thickness, y, -0.5}, {1 - thickness, y + thickness, 0.5}));
    labels.push_back({"board", ""});
  }
  return furniture("shelf", std::move(parts), std::move(labels));
}

inline const std::deque<Furniture>& examples()
{
  static const std::deque<Furniture> result = [] {
    std::deque<Furniture> shapes;
    for (double x : {0.1, 0.15, 0.2, 0.25, 0.3}) {
      shapes.push_back(chair(x, 1.5 + 2 * x));
      shapes.push_back(shelf(x / 2, 2 + int(10 * x)));
    }
    return shapes;
  }();
  return result;
}

inline std::vector<Labelled_graph> labelled(const std::deque<Furniture>& shapes)
{
  std::vector<Labelled_graph> result;
  for (const Furniture& shape : shapes)
    result.push_back({&shape.graph, shape.category, shape.labels, 1});
  return result;
}

inline std::string bytes(const Role_model& model)
{
  std::ostringstream out;
  model.write(out);
  return out.str();
}

inline std::vector<std::string> likeliest(const Part_roles& roles)
{
  std::vector<std::string> result;
  for (Eigen::Index part = 0; part < roles.probabilities.rows(); ++part) {
    Eigen::Index role = 0;
    roles.probabilities.row(part).maxCoeff(&role);
    result.push_back(roles.roles[std::size_t(role)]);
  }
  return result;
}

} // namespace labelled_furniture

#endif // SHAPE_CORRESPONDENCE_TEST_LABELLED_FURNITURE_H
