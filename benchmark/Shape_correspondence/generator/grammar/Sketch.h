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

/// The place of a part that is appended to the stem of its fine label.
enum class Place {
  none,
  side,  ///< left or right
  corner ///< front, mid or back, and left, center or right
};

/// A shape that a grammar generates: its random numbers and its parts. Shapes are symmetric in the plane x = 0 unless
/// their grammar says otherwise.
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
  /// Adds a part and its mirror image in the plane x = 0.
  void add_pair(const std::string& role, const Solid& solid, const std::string& fine = "", Place place = Place::side);
  /// Adds a part and its mirror images in the planes x = 0 and z = 0.
  void add_four(const std::string& role, const Solid& solid, const std::string& fine = "");
  /// Adds one part for each solid or, with probability `chance_of_one`, one part of all solids.
  void add_several(const std::string& role, const Solids& solids, const std::string& fine = "",
                   Place place = Place::none, double chance_of_one = 0.25);

  /// A straight bar, round or square like all bars of the shape; `from_width` and `to_width` are diameters.
  Solid stick(const Point& from, const Point& to, double from_width, double to_width);
  Solid stick(const Point& from, const Point& to, double width) { return stick(from, to, width, width); }
  /// A bar along a smooth curve through the knots.
  Solid rod(const Path& knots, double width);
  /// A block whose edges are as round as those of all blocks of the shape.
  Solid block(const Point& middle, const Point& size) { return block(middle, size, roundness_); }
  /// A block. \param roundness from 0 (a box) to 1 (an ellipsoid)
  static Solid block(const Point& middle, const Point& size, double roundness);
  /// A block of random roundness, for soft parts.
  Solid cushion(const Point& middle, const Point& size) { return block(middle, size, in(.2, .7)); }
  /// A solid of revolution about the segment between two points, with random radii between the two given ones.
  Solid turned(const Point& from, const Point& to, double least_radius, double most_radius);

  bool is_square() const { return is_square_; }

  /// Turns all parts by 90° about the y axis, which takes +z to +x.
  void turn_quarter();

  /// The shape; fine labels are kept only if they distinguish parts of one role.
  Assembly finished(const std::string& name) const;

private:
  struct Word
  {
    std::string fine;
    Place place;
  };

  Random random_;
  Assembly shape_;
  std::vector<Word> words_; // stem and place of the fine label, by part
  bool is_square_;
  double roundness_;
};

Solid joined(const Solids& solids);

/// Copies of a solid, shifted by vectors that are evenly spaced between `from` and `to`.
Solids row(const Solid& first, const Point& from, const Point& to, int count);

/// Copies of a solid, evenly spaced about the vertical line through `centre`.
Solids ring(const Solid& first, int count, const Point& centre = Point::Zero());

} // namespace CGAL::Shape_correspondence::generator
