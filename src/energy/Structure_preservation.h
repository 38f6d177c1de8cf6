// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <Eigen/Core>

#include <boost/graph/properties.hpp>
#include <boost/pending/queue.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// How an unmatched part is displaced and deformed: an affine map.
struct Part_motion
{
  Point shift = Point::Zero();                       ///< of the part's centroid
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero(); ///< what is added to a vector from there

  friend bool operator==(const Part_motion& a, const Part_motion& b)
  {
    return a.shift == b.shift && a.stretch == b.stretch;
  }
};

/// Structure preservation (paper, sections 4.2 and 5): how the parts of unmatched groups are displaced and deformed.
///
/// A part follows the points where it touches others, breadth-first from the matched ones; the members of a group
/// follow their representative, the one that touches most, by the group's generator. Then every unmatched group is
/// placed anew by all that it touches, until no part moves by more than `tolerance`. In the end the representatives are
/// stretched, so that what spans several parts goes on touching them: by the affine map nearest to a translation that
/// moves the points where it touches as they should.
class Structure_preservation
{
public:
  static constexpr double tolerance = 1e-3; ///< of the shape's height
  static constexpr int maximum_sweeps = 20;
  /// How much a part resists being stretched: the weight of its samples' scatter, where that of the points that it
  /// touches at has weight 1. With two points at its ends, a bar follows them to within 2 % of what they move apart.
  static constexpr double stiffness = 0.1;

  explicit Structure_preservation(const Aligned_shape& shape);

  /// Moves the parts of unmatched groups.
  /// \param matched by group
  /// \param contact_displacement by contact, the movement of the contact point on the first and on the second part
  /// where that part is matched
  /// \param motions by part; those of matched parts are left alone
  void operator()(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement,
                  std::vector<Part_motion>& motions);

private:
  struct Touch
  {
    std::size_t contact, part, other, other_group;
    int other_side;
  };

  // The parts of a group that touch others are stretched by the points where its representative does.
  struct Handles
  {
    std::size_t representative = 0, begin = 0, end = 0; // and its touches
    Point middle = Point::Zero();                       // mean of the points, from the part's centroid
    std::vector<Point> slopes;                          // by touch: the stretch is the sum of displacements times these
    std::vector<Eigen::Matrix3d> directions; // by member, what the generator makes of those of the representative
  };

  Handles handles(std::size_t group) const;
  void visit(const std::vector<char>& matched);
  void place(std::size_t group, const std::vector<char>& matched,
             const std::vector<std::array<Point, 2>>& contact_displacement);
  void gather(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement);
  double sweep();
  void displace(std::size_t group, const Point& moved);
  void stretch(std::size_t group, const std::vector<char>& matched,
               const std::vector<std::array<Point, 2>>& contact_displacement, std::vector<Part_motion>& motions) const;

  const Aligned_shape& shape_;
  std::vector<std::vector<Touch>> touches_; // by group, to parts of other groups, those of a part together
  std::vector<Handles> handles_;            // by group
  Points displacement_;                     // by part
  std::vector<char> placed_;
  std::vector<const double*> followed_; // by group in `order_` and touch of its representative, x of a displacement

  // Of the visit, by group
  boost::queue<std::size_t> queue_;
  std::vector<boost::default_color_type> colours_;
  std::vector<int> layer_;
  std::vector<std::size_t> sources_;
  std::vector<std::size_t> order_; // unmatched groups that something matched reaches, breadth-first
};

} // namespace CGAL::Shape_correspondence
