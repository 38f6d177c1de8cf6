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
  void add(const std::string& part, const Label& label, const Solid& solid);

  /// A part on the left and its mirror image on the right.
  void add_pair(const Names& left_right, const Label& left, const Label& right, const Solid& solid);

  /// The same, "_left" and "_right" appended to the fine label.
  void add_pair(const Names& left_right, const Label& label, const Solid& solid);

  /// A part in front and its mirror image in the plane z = 0 behind.
  void add_front_and_back(const Names& front_back, const Label& front, const Label& back, const Solid& solid);

  /// A part on the left in front and its mirror images in the planes x = 0 and z = 0: front left, front right, back
  /// left, back right; the first two have one label, "_left" and "_right" appended to fine labels.
  void add_four(const Names& names, const Label& front, const Label& back, const Solid& solid);

  /// As many copies about an axis as there are names, a label each.
  void add_labelled_ring(const Names& names, const std::vector<Label>& labels, const Solid& solid, const Point& point,
                         const Point& axis);

  /// The same, one label for all.
  void add_ring(const Names& names, const Label& label, const Solid& solid, const Point& point, const Point& axis);

  /// Copies one after the other, `step` apart.
  void add_row(const Names& names, const Label& label, const Solid& solid, const Point& step);

  /// States that parts that were made one by one are as good as copies, `step` apart.
  void state_row(const Names& names, const Point& step);

  /// States that a part touches others.
  void touch(const std::string& part, const Names& others);

  /// States that the i-th part of one list touches the i-th of the other.
  void touch_in_turn(const Names& ones, const Names& others);

  double diagonal() const;

  /// Two parts, the smaller index first, and how far apart they are, over the diagonal.
  struct Near_parts
  {
    std::array<int, 2> parts;
    double gap;
  };

  /// All pairs of parts that are within a fraction of the diagonal of each other, by brute force.
  std::vector<Near_parts> near_parts(double fraction) const;

  int index(const std::string& part) const;

private:
  const Solid& place(const std::string& part, const Label& label, const Solid& solid);

  static bool is_mirror_symmetric(const Mesh& mesh);
};

/// `stem` followed by 1, 2, …, n.
Names numbered(const std::string& stem, int n);

} // namespace CGAL::Shape_correspondence::generator
