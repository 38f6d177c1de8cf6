// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// Structure preservation (paper, section 5): how far the parts of unmatched groups move. A part follows the points
/// where it touches others, breadth-first from the matched ones; the members of a group follow their representative,
/// the one that touches most, by the group's generator. Then every unmatched group is placed anew by all that it
/// touches, until no part moves by more than `tolerance`.
class Structure_preservation
{
public:
  static constexpr double tolerance = 1e-3; ///< of the shape's height
  static constexpr int maximum_sweeps = 20;

  explicit Structure_preservation(const Aligned_shape& shape);

  /// Moves the parts of unmatched groups; makes no allocation.
  /// \param matched by group
  /// \param contact_displacement by contact, the movement of the contact point on the first and on the second part
  /// where that part is matched
  /// \param displacement a column a part; those of matched parts are left alone
  void operator()(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement,
                  Points& displacement);

private:
  struct Touch
  {
    std::size_t contact, part, other;
    int other_side;
  };

  double place(std::size_t group, const std::vector<char>& matched,
               const std::vector<std::array<Point, 2>>& contact_displacement, Points& displacement);

  const Aligned_shape& shape_;
  std::vector<std::vector<Touch>> touches_; // by group, to parts of other groups, those of a part together
  std::vector<char> placed_;
  std::vector<std::size_t> order_; // unmatched groups that something matched reaches, breadth-first
};

} // namespace CGAL::Shape_correspondence
