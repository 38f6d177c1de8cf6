// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "mesh.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::generator {

using Names = std::vector<std::string>;

/// Coarse and fine label of a part, which say its role. An empty fine label is written as null.
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

/// Copies of one part under a reflection in the plane through the origin with normal `direction`, a rotation about the
/// axis through `point`, or a translation by `direction`; or a single part (`self`), which is `mirror_symmetric` if the
/// plane x = 0 maps it to itself.
struct Part_group
{
  Names parts;
  Symmetry symmetry;
  bool mirror_symmetric = false;
  Point point = Point::Zero(), direction = Point::Zero();
  bool near_copies = false; ///< whether the parts were made one by one and are nearly congruent
};

/// A labelled shape: y is up, its front faces +z, its own left is +x; units are metres.
class Assembly
{
public:
  std::string name, category;
  std::vector<Part> parts;
  std::vector<Part_group> groups;
  /// Pairs of indices of parts that touch, the smaller index first.
  std::vector<std::array<int, 2>> contacts;

  Assembly(std::string name, std::string category) : name(std::move(name)), category(std::move(category)) {}

  /// Adds a part without copies.
  void add(const std::string& part, const Label& label, const Solid& solid);

  /// Adds a part on the left and its mirror image on the right.
  void add_pair(const Names& left_right, const Label& left, const Label& right, const Solid& solid);

  /// Adds a part on the left and its mirror image on the right. Both have the label, but "_left" or "_right" is
  /// appended to its fine label if that is not empty.
  void add_pair(const Names& left_right, const Label& label, const Solid& solid);

  /// Adds a part in front and its mirror image in the plane z = 0 behind.
  void add_front_and_back(const Names& front_back, const Label& front, const Label& back, const Solid& solid);

  /// Adds a part at the front left and its mirror images in the planes x = 0 and z = 0. `names`: front left, front
  /// right, back left, back right. Labels are those of the two pairs, see `add_pair()`.
  void add_four(const Names& names, const Label& front, const Label& back, const Solid& solid);

  /// Adds copies of a part, evenly spaced about an axis, one for each name and label.
  void add_labelled_ring(const Names& names, const std::vector<Label>& labels, const Solid& solid, const Point& point,
                         const Point& axis);

  /// Adds copies of a part, evenly spaced about an axis, with one label.
  void add_ring(const Names& names, const Label& label, const Solid& solid, const Point& point, const Point& axis);

  /// Adds a row of copies of a part, each shifted by `step` from the one before.
  void add_row(const Names& names, const Label& label, const Solid& solid, const Point& step);

  /// States that parts added one by one are a row of nearly congruent parts, `step` apart.
  void state_row(const Names& names, const Point& step);

  /// States that a part touches others.
  void touch(const std::string& part, const Names& others);

  /// States that the i-th part of one list touches the i-th of the other.
  void touch_in_turn(const Names& ones, const Names& others);

  double diagonal() const;

  /// Indices of two parts, the smaller first, and their distance over the shape's diagonal.
  struct Near_parts
  {
    std::array<int, 2> parts;
    double gap;
  };

  /// All pairs of parts whose distance is less than `fraction` of the shape's diagonal, by brute force.
  std::vector<Near_parts> near_parts(double fraction) const;

  int index(const std::string& part) const;

private:
  const Solid& place(const std::string& part, const Label& label, const Solid& solid);

  static bool is_mirror_symmetric(const Mesh& mesh);
};

/// `stem` followed by 1, 2, …, n.
Names numbered(const std::string& stem, int n);

} // namespace CGAL::Shape_correspondence::generator
