// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../assembly.h"
#include "../benchmark/random.h"
#include "../primitives.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::generator {

using Solids = std::vector<Solid>;

/// What a fine label says of the place of a part, after its stem.
enum class Place {
  none,
  side,  ///< left or right
  corner ///< front, mid or back, and left, center or right
};

/// A shape in the making: what is drawn for it, and its parts. All are symmetric in the plane x = 0 unless the grammar
/// says otherwise.
class Sketch
{
public:
  Sketch(const std::string& category, std::uint64_t seed);

  double in(double low, double high) { return random_.between(low, high); }
  int count(int least, int most) { return least + int(random_.below(std::size_t(most - least + 1))); }
  bool chance(double p) { return in(0, 1) < p; }
  template <typename T>
  T any(std::initializer_list<T> values)
  {
    return values.begin()[random_.below(values.size())];
  }

  void add(const std::string& role, const Solid& solid, const std::string& fine = "", Place place = Place::none);
  /// And its mirror image in the plane x = 0.
  void add_pair(const std::string& role, const Solid& solid, const std::string& fine = "", Place place = Place::side);
  /// And its mirror images in the planes x = 0 and z = 0.
  void add_four(const std::string& role, const Solid& solid, const std::string& fine = "");
  /// One part each, or at times one for all.
  void add_several(const std::string& role, const Solids& solids, const std::string& fine = "",
                   Place place = Place::none, double chance_of_one = 0.25);

  /// A straight piece, round or square as all of the shape; `from_width` and `to_width` are diameters.
  Solid stick(const Point& from, const Point& to, double from_width, double to_width);
  Solid stick(const Point& from, const Point& to, double width) { return stick(from, to, width, width); }
  /// A curved piece through the knots.
  Solid rod(const Path& knots, double width);
  /// Something with edges as round as all of the shape's.
  Solid block(const Point& middle, const Point& size) { return block(middle, size, roundness_); }
  /// Between a box (0) and an ellipsoid (1).
  static Solid block(const Point& middle, const Point& size, double roundness);
  /// A thing that is soft: a block of its own roundness.
  Solid cushion(const Point& middle, const Point& size) { return block(middle, size, in(.2, .7)); }
  /// A solid of revolution from one point to the other, of radii that are drawn between two.
  Solid turned(const Point& from, const Point& to, double least_radius, double most_radius);

  bool is_square() const { return is_square_; }

  /// All that was drawn, turned so that +z comes to +x.
  void turn_quarter();

  /// The shape, with fine labels where they tell parts of a role apart.
  Assembly finished(const std::string& name) const;

private:
  struct Word
  {
    std::string fine;
    Place place;
  };

  Random random_;
  Assembly shape_;
  std::vector<Word> words_; // by part
  bool is_square_;
  double roundness_;
};

Solid joined(const Solids& solids);

/// Copies, evenly spaced between two shifts of the first.
Solids row(const Solid& first, const Point& from, const Point& to, int count);

/// Copies about a line along y.
Solids ring(const Solid& first, int count, const Point& centre = Point::Zero());

} // namespace CGAL::Shape_correspondence::generator
