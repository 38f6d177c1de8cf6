// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_ASSEMBLY_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_ASSEMBLY_H

#include "primitives.h"
#include "surface_distance.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

using Names = std::vector<std::string>;

/// What a part is for. An empty fine label is written as null.
struct Label
{
  std::string coarse, fine;
};

struct Part
{
  std::string name;
  Label label;
  Solid solid;
};

enum class Symmetry { self, reflection, rotation, translation };

/// Copies of one part. The symmetry is in a plane through the origin, about an axis, or along a vector; a single part
/// is `self`, `mirror_symmetric` when the plane x = 0 takes it to itself.
struct Part_group
{
  Names parts;
  Symmetry symmetry;
  bool mirror_symmetric = false;
  Point point = Point::Zero(), direction = Point::Zero();
  bool near_copies = false; ///< made one by one and much alike
};

/// A labelled shape: y is up, its front looks to +z, its own left is +x; units are metres.
class Assembly
{
public:
  std::string name, category;
  std::vector<Part> parts;
  std::vector<Part_group> groups;
  /// Pairs of indices of parts that touch, the smaller index first.
  std::vector<std::array<int, 2>> contacts;

  Assembly(std::string name, std::string category) : name(std::move(name)), category(std::move(category)) {}

  /// A part of its own.
  void add(const std::string& part, const Label& label, const Solid& solid)
  {
    const Solid& placed = place(part, label, solid);
    groups.push_back({{part}, Symmetry::self, is_mirror_symmetric(placed.mesh)});
  }

  /// A part on the left and its mirror image on the right.
  void add_pair(const Names& left_right, const Label& left, const Label& right, const Solid& solid)
  {
    const Solid placed = place(left_right.at(0), left, solid);
    place(left_right.at(1), right, mirrored(placed));
    groups.push_back({left_right, Symmetry::reflection, false, Point::Zero(), Point::UnitX()});
  }

  /// The same, "_left" and "_right" appended to the fine label.
  void add_pair(const Names& left_right, const Label& label, const Solid& solid)
  {
    if (label.fine.empty()) return add_pair(left_right, label, label, solid);
    add_pair(left_right, {label.coarse, label.fine + "_left"}, {label.coarse, label.fine + "_right"}, solid);
  }

  /// A part in front and its mirror image in the plane z = 0 behind.
  void add_front_and_back(const Names& front_back, const Label& front, const Label& back, const Solid& solid)
  {
    const Solid placed = place(front_back.at(0), front, solid);
    place(front_back.at(1), back, mirrored(placed, 2));
    groups.push_back({front_back, Symmetry::reflection, false, Point::Zero(), Point::UnitZ()});
  }

  /// A part on the left in front and its mirror images in the planes x = 0 and z = 0: front left, front right, back
  /// left, back right; the first two have one label, "_left" and "_right" appended to fine labels.
  void add_four(const Names& names, const Label& front, const Label& back, const Solid& solid)
  {
    const Names fronts(names.begin(), names.begin() + 2), backs(names.begin() + 2, names.end());
    add_pair(fronts, front, solid);
    add_pair(backs, back, mirrored(snapped(solid), 2));
    groups.resize(groups.size() - 2);
    groups.push_back({names, Symmetry::reflection, false, Point::Zero(), Point::UnitX()});
  }

  /// As many copies about an axis as there are names, a label each.
  void add_labelled_ring(const Names& names, const std::vector<Label>& labels, const Solid& solid, const Point& point,
                         const Point& axis)
  {
    for (std::size_t i = 0; i < names.size(); ++i)
      place(names[i], labels.at(i), transformed(solid, rotation_about(point, axis, 2 * pi * i / names.size())));
    groups.push_back({names, Symmetry::rotation, false, point, axis.normalized()});
  }

  /// The same, one label for all.
  void add_ring(const Names& names, const Label& label, const Solid& solid, const Point& point, const Point& axis)
  {
    add_labelled_ring(names, std::vector<Label>(names.size(), label), solid, point, axis);
  }

  /// Copies one after the other, `step` apart.
  void add_row(const Names& names, const Label& label, const Solid& solid, const Point& step)
  {
    const Point vector = snapped(step);
    const Solid first = snapped(solid);
    for (std::size_t i = 0; i < names.size(); ++i)
      place(names[i], label, translated(first, double(i) * vector));
    groups.push_back({names, Symmetry::translation, false, Point::Zero(), vector});
  }

  /// States that parts that were made one by one are as good as copies, `step` apart.
  void state_row(const Names& names, const Point& step)
  {
    const auto is_one_of_them = [&](const Part_group& group) {
      return group.parts.size() == 1 && std::find(names.begin(), names.end(), group.parts[0]) != names.end();
    };
    groups.erase(std::remove_if(groups.begin(), groups.end(), is_one_of_them), groups.end());
    groups.push_back({names, Symmetry::translation, false, Point::Zero(), step, true});
  }

  /// States that a part touches others.
  void touch(const std::string& part, const Names& others)
  {
    for (const std::string& other : others) {
      const int a = index(part), b = index(other);
      contacts.push_back({std::min(a, b), std::max(a, b)});
    }
  }

  /// States that the i-th part of one list touches the i-th of the other.
  void touch_in_turn(const Names& ones, const Names& others)
  {
    for (std::size_t i = 0; i < ones.size(); ++i)
      touch(ones[i], {others.at(i)});
  }

  double diagonal() const
  {
    Box box;
    for (const Part& part : parts)
      box.extend(box_of(part.solid.mesh.points));
    return box.diagonal().norm();
  }

  /// Two parts, the smaller index first, and how far apart they are, over the diagonal.
  struct Near_parts
  {
    std::array<int, 2> parts;
    double gap;
  };

  /// All pairs of parts that are within a fraction of the diagonal of each other, by brute force.
  std::vector<Near_parts> near_parts(double fraction) const
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

  int index(const std::string& part) const
  {
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].name == part) return int(i);
    throw std::logic_error(name + ": no part " + part);
  }

private:
  const Solid& place(const std::string& part, const Label& label, const Solid& solid)
  {
    for (const Part& other : parts)
      if (other.name == part) throw std::logic_error(name + ": part " + part + " twice");
    parts.push_back({part, label, snapped(solid)});
    return parts.back().solid;
  }

  static bool is_mirror_symmetric(const Mesh& mesh)
  {
    constexpr double tolerance = 1e-4;
    for (const Point& p : mesh.points) {
      const Point image(-p.x(), p.y(), p.z());
      auto meets = [&](const Point& q) { return (q - image).norm() < tolerance; };
      if (std::none_of(mesh.points.begin(), mesh.points.end(), meets)) return false;
    }
    return true;
  }
};

/// `stem` followed by 1, 2, …, n.
inline Names numbered(const std::string& stem, int n)
{
  Names names;
  for (int i = 1; i <= n; ++i)
    names.push_back(stem + std::to_string(i));
  return names;
}

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_ASSEMBLY_H
