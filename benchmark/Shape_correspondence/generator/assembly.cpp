// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "assembly.h"

#include "surface_distance.h"

#include <algorithm>
#include <stdexcept>

namespace CGAL::Shape_correspondence::generator {

void Assembly::add(const std::string& part, const Label& label, const Solid& solid)
{
  const Solid& placed = place(part, label, solid);
  groups.push_back({{part}, Symmetry::self, is_mirror_symmetric(placed.mesh)});
}

void Assembly::add_pair(const Names& left_right, const Label& left, const Label& right, const Solid& solid)
{
  const Solid placed = place(left_right.at(0), left, solid);
  place(left_right.at(1), right, mirrored(placed));
  groups.push_back({left_right, Symmetry::reflection, false, Point::Zero(), Point::UnitX()});
}

void Assembly::add_pair(const Names& left_right, const Label& label, const Solid& solid)
{
  if (label.fine.empty()) return add_pair(left_right, label, label, solid);
  add_pair(left_right, {label.coarse, label.fine + "_left"}, {label.coarse, label.fine + "_right"}, solid);
}

void Assembly::add_front_and_back(const Names& front_back, const Label& front, const Label& back, const Solid& solid)
{
  const Solid placed = place(front_back.at(0), front, solid);
  place(front_back.at(1), back, mirrored(placed, 2));
  groups.push_back({front_back, Symmetry::reflection, false, Point::Zero(), Point::UnitZ()});
}

void Assembly::add_four(const Names& names, const Label& front, const Label& back, const Solid& solid)
{
  const Names fronts(names.begin(), names.begin() + 2), backs(names.begin() + 2, names.end());
  add_pair(fronts, front, solid);
  add_pair(backs, back, mirrored(snapped(solid), 2));
  groups.resize(groups.size() - 2);
  groups.push_back({names, Symmetry::reflection, false, Point::Zero(), Point::UnitX()});
}

void Assembly::add_labelled_ring(const Names& names, const std::vector<Label>& labels, const Solid& solid,
                                 const Point& point, const Point& axis)
{
  for (std::size_t i = 0; i < names.size(); ++i)
    place(names[i], labels.at(i), transformed(solid, rotation_about(point, axis, 2 * pi * i / names.size())));
  groups.push_back({names, Symmetry::rotation, false, point, axis.normalized()});
}

void Assembly::add_ring(const Names& names, const Label& label, const Solid& solid, const Point& point,
                        const Point& axis)
{
  add_labelled_ring(names, std::vector<Label>(names.size(), label), solid, point, axis);
}

void Assembly::add_row(const Names& names, const Label& label, const Solid& solid, const Point& step)
{
  const Point vector = snapped(step);
  const Solid first = snapped(solid);
  for (std::size_t i = 0; i < names.size(); ++i)
    place(names[i], label, translated(first, double(i) * vector));
  groups.push_back({names, Symmetry::translation, false, Point::Zero(), vector});
}

void Assembly::state_row(const Names& names, const Point& step)
{
  const auto is_one_of_them = [&](const Part_group& group) {
    return group.parts.size() == 1 && std::find(names.begin(), names.end(), group.parts[0]) != names.end();
  };
  groups.erase(std::remove_if(groups.begin(), groups.end(), is_one_of_them), groups.end());
  groups.push_back({names, Symmetry::translation, false, Point::Zero(), step, true});
}

void Assembly::touch(const std::string& part, const Names& others)
{
  for (const std::string& other : others) {
    const int a = index(part), b = index(other);
    contacts.push_back({std::min(a, b), std::max(a, b)});
  }
}

void Assembly::touch_in_turn(const Names& ones, const Names& others)
{
  for (std::size_t i = 0; i < ones.size(); ++i)
    touch(ones[i], {others.at(i)});
}

double Assembly::diagonal() const
{
  Box box;
  for (const Part& part : parts)
    box.extend(box_of(part.solid.mesh.points));
  return box.diagonal().norm();
}

std::vector<Assembly::Near_parts> Assembly::near_parts(double fraction) const
{
  std::vector<Near_parts> result;
  const double limit = fraction * diagonal();
  for (int a = 0; a < int(parts.size()); ++a)
    for (int b = a + 1; b < int(parts.size()); ++b) {
      const double distance = surface_distance(parts[a].solid.mesh, parts[b].solid.mesh, limit);
      if (distance < limit) result.push_back({{a, b}, distance / diagonal()});
    }
  return result;
}

int Assembly::index(const std::string& part) const
{
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].name == part) return int(i);
  throw std::logic_error(name + ": no part " + part);
}

const Solid& Assembly::place(const std::string& part, const Label& label, const Solid& solid)
{
  for (const Part& other : parts)
    if (other.name == part) throw std::logic_error(name + ": part " + part + " twice");
  parts.push_back({part, label, snapped(solid)});
  return parts.back().solid;
}

bool Assembly::is_mirror_symmetric(const Mesh& mesh)
{
  constexpr double tolerance = 1e-4;
  for (const Point& p : mesh.points) {
    const Point image(-p.x(), p.y(), p.z());
    auto meets = [&](const Point& q) { return (q - image).norm() < tolerance; };
    if (std::none_of(mesh.points.begin(), mesh.points.end(), meets)) return false;
  }
  return true;
}

Names numbered(const std::string& stem, int n)
{
  Names names;
  for (int i = 1; i <= n; ++i)
    names.push_back(stem + std::to_string(i));
  return names;
}

} // namespace CGAL::Shape_correspondence::generator
